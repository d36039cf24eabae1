"""One equation in nine systems, and the pendulum at any amplitude (D31, point 7)."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import Any

import numpy as np
import param
from numpy.typing import NDArray

from components.analogue_controls import LARGEST, SHORT, SWINGING, groups, quantities
from components.analogue_pictures import tiles
from components.analogue_sheet import LIMITS, analogue_sheet
from components.controls import Group
from components.motion import cosine_of, derived, pace, sine_of, sines, table
from components.numbers import signed, three
from components.plots import Axis, nice_axis, time_axis
from components.scene import Columns, Picture, Scene
from components.sheet import Block
from components.stage import var
from components.traces import samples, trace
from physics.analogue import Analogue
from physics.analogues import ANALOGUES
from physics.oscillator import Oscillator
from physics.pendulum import Pendulum, PendulumMotion, amplitude_at_excess, excess
from physics.sampling import Sinusoid, periods

ONE = Axis(-1.0, 1.0)
DEGREE = math.pi / 180
SWINGS = 3.5
TINY = 1e-9
"""rad; smaller swings have this one's shape to the last digit."""
UNHURRIED = (1.0, 10.0)
"""s; periods that are easy to watch as they are."""
MOST_HALF_WAVES = 12
"""More would not be seen in a picture."""


@dataclass(frozen=True)
class Case:
    """The chosen system with its parameters, released at rest from q_0 (SI, rad), and the spring of equal numbers."""

    system: Analogue
    p: dict[str, float]
    q_0: float
    window: float | None

    @cached_property
    def spring(self) -> Oscillator:
        return Oscillator(m=self.system.inertia(self.p), k=self.system.stiffness(self.p))

    @cached_property
    def omega(self) -> float:
        return self.system.omega_n(self.p)

    @cached_property
    def pendulum(self) -> Pendulum | None:
        return self.system.pendulum(self.p)

    @cached_property
    def excess(self) -> float:
        """T/T_0 - 1; 0 for what is linear."""
        return excess(self.q_0) if self.pendulum else 0.0

    @cached_property
    def period(self) -> float:
        return self.pendulum.period(self.q_0) if self.pendulum else self.spring.period

    @cached_property
    def end(self) -> float:
        return self.window or periods(2 * math.pi / self.period, SWINGS)

    def swing(self, t: NDArray[np.float64]) -> tuple[PendulumMotion, float]:
        """The exact motion, and its size: that of q_0, or a small one of the same shape."""
        size = math.copysign(max(abs(self.q_0), TINY), self.q_0)
        return self.pendulum.motion(size, t), size

    def axis(self) -> Axis:
        """The axis of the coordinate, with ticks at the amplitude; angles of pendulums in degrees."""
        unit, factor = ("°", DEGREE) if self.pendulum else (self.system.unit, 1.0)
        size = abs(self.q_0)
        axis = nice_axis(-size, size, unit, factor=factor)
        top = axis.place(size) or 1.0
        return replace(axis, start=1.3 * -size or axis.start, end=1.3 * size or axis.end, ticks=(-top, 0.0, top))

    def table_axis(self) -> Axis:
        """The unit in which the table counts x and q."""
        return nice_axis(-abs(self.q_0), abs(self.q_0), self.system.unit)

    def energy_axis(self) -> Axis:
        return nice_axis(0.0, self.system.energy(self.p, self.q_0), "J")


class Analogues(Scene):
    slug = "analogues"
    title = "Analogues"
    lecture = "D31"
    headline = "Nine systems, one equation: only the names change"
    groups = (Group("System", ("system",), "all nine in step", pictures=tiles()), *groups())
    presets = {
        "60°": {},
        "Clock": {"pendulum_l": 0.994, "theta_0": 3.0},
        "Nearly over": {"theta_0": 179.0},
        "Guitar": {"system": "string", "string_T": 73.45},
        "Radio": {"system": "circuit", "circuit_L": 1e-4, "circuit_C": 2.53e-10},
        "Swell": {"system": "wave", "wave_wavelength": 200.0},
        "Cavendish": {"system": "shaft", "shaft_J": 12.5, "shaft_k_t": 7e-4},
    }

    system = param.Selector(
        default="pendulum", objects={SHORT[slug]: slug for slug in ANALOGUES}, label="System", doc="The system shown."
    )

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return analogue_sheet()

    def picture(self) -> Picture:
        case = self._case()
        time, size, energy = time_axis(case.end), case.axis(), case.energy_axis()
        curves, bands, t = _motion_columns(case)
        axes = {"t": time, "q": size, **_late_axes(case)}
        return Picture(
            columns={"time": {"t": t, **curves}, "band": bands and {"t": t, **bands}, **_late_columns(case)},
            axes=axes,
            signals=_signals(case, time, size, energy),
            scalars=_scalars(case, axes),
            values=_values(case, size, energy),
            live={
                "level": size.digits(signed=True),
                **{name: case.table_axis().digits(signed=True) for name in ("x", "q")},
                **{name: energy.digits() for name in ("T_x", "V_x", "T_q", "V_q")},
            },
            forms=_forms(case),
            notes=_notes(case),
        )

    def _case(self) -> Case:
        system = ANALOGUES[self.system]
        p = {parameter.name: getattr(self, f"{self.system}_{parameter.name}") for parameter in system.parameters}
        start = math.radians(self.theta_0) if self.system in SWINGING else getattr(self, f"{self.system}_start")
        return Case(system, p, start, self.window)


for _name, _quantity in quantities().items():
    Analogues.param.add_parameter(_name, _quantity)


def _motion_columns(case: Case) -> tuple[Columns, Columns, NDArray[np.float64]]:
    """The coordinate q and that of the spring, x: curves, or bands where too fast."""
    t = np.linspace(0.0, case.end, samples(case.end, case.omega))
    rule = [Sinusoid(case.q_0, case.omega, math.pi / 2)]
    x = case.spring.motion(case.q_0, 0.0, t).x
    q = x
    if case.pendulum:
        motion, size = case.swing(t)
        q = motion.theta * (case.q_0 / size)
    curve_x, band_x = trace("x", rule, t, curve=x)
    curve_q, band_q = trace("q", rule, t, curve=q)
    return curve_x | curve_q, band_x | band_q, t


def _late_axes(case: Case) -> dict[str, Axis]:
    """Angle and lateness; they reach to 90 degrees and 19 %, or as far as the start is beyond."""
    wide = case.pendulum is not None and abs(case.q_0) > 88 * DEGREE
    end, step = (180, 30) if wide else (90, 15)
    angle = Axis(0.0, end, "°", ticks=tuple(float(tick) for tick in range(0, end + 1, step)))
    return {"angle": angle, "late": nice_axis(0.0, max(1.25 * case.excess, 0.19), "%", 4, exact=True, factor=0.01)}


@cache
def _lateness(end: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Angles in degrees and T/T_0 - 1 there."""
    angles = np.linspace(0.0, min(end, 179.9), 121)
    return angles, np.array([excess(math.radians(angle)) for angle in angles])


def _late_columns(case: Case) -> dict[str, Columns]:
    if not case.pendulum:
        return {"late": {}, "limits": {}, "here": {}}
    angles, late = _lateness(_late_axes(case)["angle"].end)
    limits = np.array(list(LIMITS.values()))
    return {
        "late": {"angle": angles, "excess": late},
        "limits": {"angle": np.degrees([amplitude_at_excess(value) for value in limits]), "excess": limits},
        "here": {"angle": np.array([math.degrees(abs(case.q_0))]), "excess": np.array([case.excess])},
    }


def _signals(case: Case, time: Axis, size: Axis, energy: Axis) -> dict[str, Any]:
    """cos and sin of omega t; the share of the amplitude at which q stands; numbers and angles from these."""
    own, E = case.table_axis(), energy.place(case.system.energy(case.p, case.q_0))
    exact_E = energy.place(case.system.exact_energy(case.p, case.q_0))
    cosine, sine, share, root = (var(name) for name in ("cosine", "sine", "share", "root"))
    signals = {
        "cosine": sines(ONE, time, (1.0, case.omega, math.pi / 2)),
        "sine": sines(ONE, time, (1.0, case.omega, 0.0)),
        "phase": sines(ONE, time, line=(0.0, case.omega)),
        **_shares(case, time),
        "level": derived(size.place(case.q_0) * share),
        "rule": derived(size.place(case.q_0) * cosine),
        "x": derived(own.place(case.q_0) * cosine),
        "q": derived(own.place(case.q_0) * share),
        "T_x": derived(E * sine * sine),
        "V_x": derived(E * cosine * cosine),
        "T_q": derived(exact_E - exact_E * root * root),
        "V_q": derived(exact_E * root * root),
    }
    if case.pendulum:
        signals |= {"angle": derived(case.q_0 * share), "rule_angle": derived(case.q_0 * cosine)}
        signals |= {"angle_sine": sine_of("angle"), "angle_cosine": cosine_of("angle")}
        signals |= {"rule_sine": sine_of("rule_angle"), "rule_cosine": cosine_of("rule_angle")}
    return signals


def _shares(case: Case, time: Axis) -> dict[str, Any]:
    """q over q_0, and the square root of V over its largest: both the cosine where the system is linear."""
    if not case.pendulum:
        return {name: derived(var("cosine")) for name in ("share", "root")}
    count = min(96 * math.ceil(1 + case.excess), 512)
    motion, size = case.swing(np.linspace(0.0, case.period, count + 1))
    half = math.sin(size / 2)
    return {
        "share": table(time, case.period, motion.theta / size, motion.theta_dot / size),
        "root": table(
            time, case.period, np.sin(motion.theta / 2) / half, np.cos(motion.theta / 2) * motion.theta_dot / (2 * half)
        ),
    }


def _scalars(case: Case, axes: dict[str, Axis]) -> dict[str, float]:
    """Sizes on the stage, what is shown of it, places of brackets and flags, and the clock's speed."""
    time, T_0, T = axes["t"], case.spring.period, case.period
    scalars = {case.system.slug: 1.0, "amplitude": axes["q"].place(abs(case.q_0)), "drawn_sign": math.copysign(1.0, case.q_0)}
    scalars |= pace(2 * math.pi / T, case.omega) | ({"pace": 1.0} if UNHURRIED[0] <= T <= UNHURRIED[1] else {})
    scalars["size"] = math.copysign(min(abs(case.q_0) / (LARGEST * case.system.swing), 1.0), case.q_0)
    scalars |= {"half_waves": min(case.p.get("n", 1.0), MOST_HALF_WAVES)}
    scalars |= {"along": 10 / scalars["half_waves"], "belly": 0.5 / scalars["half_waves"]}
    drawn = samples(case.end, case.omega) > 12 * case.end / T_0
    if case.pendulum:
        scalars |= _pendulum_scalars(case, axes)
        if drawn and 3.1 * T <= case.end:
            scalars |= {"late_seen": 1.0, "third_rule": time.place(3 * T_0), "third_swing": time.place(3 * T)}
    elif drawn and 2 * T <= case.end:
        scalars |= {"period_seen": 1.0, "first_peak": time.place(T), "second_peak": time.place(2 * T)}
    return scalars


def _pendulum_scalars(case: Case, axes: dict[str, Axis]) -> dict[str, float]:
    """Where the pendulum hangs: lower and shorter where it swings over its pivot."""
    theta = abs(case.q_0)
    pivot, rod = (0.14, 0.5) if theta < 61 * DEGREE else (0.14, 0.43) if theta <= 91 * DEGREE else (0.46, 0.3)
    flags = {name: math.degrees(amplitude_at_excess(value)) for name, value in LIMITS.items()}
    return {
        "pivot": pivot,
        "rod": rod,
        "theta_0": theta,
        "ends_seen": float(theta < 150 * DEGREE),
        "end_sine": math.sin(theta),
        "end_cosine": math.cos(theta),
        "size_angle": math.degrees(theta),
        "late_now": axes["late"].place(case.excess),
        "rule_seen": 1.0,
        **flags,
    }


def _values(case: Case, size: Axis, energy: Axis) -> dict[str, str]:
    system, own = case.system, case.table_axis()
    degrees = three(math.degrees(abs(case.q_0)))
    return {
        "omega": three(case.omega),
        "frequency": three(1 / case.period),
        "period": three(case.period),
        "small_period": three(case.spring.period),
        "late": three(3 * (case.spring.period * case.excess)),
        "late_percent": three(100 * case.excess),
        "end_right": f"{degrees}°",
        "end_left": f"−{degrees}°",
        "level_unit": _unit(size, "") if case.pendulum else _unit(size),
        "system_name": system.name,
        "m": three(case.spring.m),
        "m_unit": f"\N{NO-BREAK SPACE}{system.inertia_unit}",
        "k": three(case.spring.k),
        "k_unit": f"\N{NO-BREAK SPACE}{system.stiffness_unit}",
        "x_unit": _unit(replace(own, unit="m")),
        "q_unit": _unit(own),
        "J_unit": _unit(energy),
        "E_unit": _unit(energy) + ("/m²" if system.slug == "wave" else ""),
    }


def _unit(axis: Axis, gap: str = "\N{NO-BREAK SPACE}") -> str:
    """The unit as it follows a number: ·10⁻⁶ m, or a space and m."""
    return axis.suffix.replace(" ", "\N{NO-BREAK SPACE}") + axis.unit if axis.suffix else gap + axis.unit


def _forms(case: Case) -> dict[str, str]:
    slug = case.system.slug
    kind = "swinging" if case.pendulum else "linear"
    forms = {"system": slug, slug: "shown", kind: "shown", "q": slug, "x": slug if case.pendulum else "linear"}
    return forms | ({"note": slug} if case.system.note else {})


def _notes(case: Case) -> tuple[str, ...]:
    if case.p.get("n", 1.0) > MOST_HALF_WAVES:
        return (f"The picture shows {MOST_HALF_WAVES} half waves; the numbers are those of n.",)
    return ()
