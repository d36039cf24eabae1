"""Analogues: the scene of one equation in nine systems, and of the pendulum at any amplitude (D31, point 7)."""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from components.language.blocks import Block
from components.language.numbers import var
from components.language.picture import Pace
from components.language.signals import AnySignal
from components.language.state import Frame
from components.layout.controls import Group
from components.quantities.axes import ONE, Axis, time_axis
from components.quantities.motion import cosine_of, derived, pace, sampled, sine_of, sines
from components.quantities.parameters import one_of
from components.quantities.readouts import Readout
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scene.traces import Traces, bands_over_time, samples
from components.scenes.analogues.about import analogue_about
from components.scenes.analogues.case import CURVES, DEGREE, LIMITS, AnalogueCase, late_axes, late_columns, motion_bands
from components.scenes.analogues.controls import LARGEST, SHORT, SWINGING, groups, quantities, start_angle
from components.scenes.analogues.numbers import Numbers as N
from components.scenes.analogues.pictures import tiles
from components.scenes.analogues.reach import REMARKS
from components.scenes.analogues.sheet import analogue_sheet
from components.scenes.analogues.watch import WATCH
from physics.analogues import ANALOGUES
from physics.pendulum import amplitude_at_excess

UNHURRIED = (0.5, 10.0)
"""s; periods that are easy to watch as they are."""
MOST_HALF_WAVES = 12
"""More would not be seen in a picture."""
COSINE, SHARE = var("cosine"), var("share")
COSINE_SQUARED, SINE_SQUARED, ROOT_SQUARED = (var(name) * var(name) for name in ("cosine", "sine", "root"))


class Analogues(Scene):
    slug = "analogues"
    title = "Analogues"
    lecture = "D31"
    points = "point 7"
    headline = "Nine systems, one equation: only the names change"
    spoken = {"period": N.period, "frequency": N.frequency}
    equations = (
        "inertia q'' + stiffness q = 0; of a pendulum and a rocking body: theta'' + omega_n^2 sin(theta) = 0",
        "omega_n = sqrt(stiffness/inertia); x is the spring and mass of equal numbers",
    )
    groups = (Group("System", ("system",), pictures=tiles()), *groups())
    shares = {"mass": "spring_m", "stiffness": "spring_k"}
    sharing = {"system": "spring"}
    start = "Examples"
    start_folded = True
    watch = WATCH
    presets = {
        "10°": {"theta_0": 10.0},
        "60°": {},
        "Clock": {"pendulum_l": 0.994, "theta_0": 3.0},
        "Nearly over": {"theta_0": 179.0},
        "Guitar": {"system": "string", "string_T": 73.45},
        "Radio": {"system": "circuit", "circuit_L": 1e-4, "circuit_C": 2.53e-10},
        "Swell": {"system": "wave", "wave_wavelength": 200.0},
        "Cavendish": {"system": "shaft", "shaft_J": 1.25, "shaft_k_t": 7e-5},
    }
    opens = presets["10°"]

    system = one_of(
        default="pendulum",
        objects={SHORT[slug]: slug for slug in ANALOGUES},
        label="System",
        doc="The system shown.",
    )

    theta_0 = start_angle()

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return analogue_sheet()

    def picture(self, frame: Frame = FITTED) -> Picture:
        case = self._case(frame.window)
        axes = framed(frame, {"t": time_axis(case.own_end), "q": case.axis(), **late_axes(case)})
        time, size, energy = axes["t"], axes["q"], case.energy_axis()
        bands = motion_bands(case)
        drawn = Traces(case.end, case.t.size, () if bands else CURVES, case.exact, {"x": "rule", "q": "level"})
        return Picture(
            columns={**bands_over_time(case.t, bands), **late_columns(case, axes["angle"].end)},
            axes=axes,
            signals=_signals(case, time, size, energy),
            traces={"time": drawn},
            scalars=_scalars(case, axes),
            pace=_pace(case),
            values=N.texts(case, axes),
            live={
                "level": size.digits(signed=True),
                **dict.fromkeys(("x", "q"), case.table_axis.digits(signed=True)),
                **dict.fromkeys(("T_x", "V_x", "T_q", "V_q"), energy.digits()),
            },
            forms=_forms(case),
            notes=_notes(case),
        )

    def _case(self, standing: float | None = None) -> AnalogueCase:
        system = ANALOGUES[self.system]
        p = {parameter.name: getattr(self, f"{self.system}_{parameter.name}") for parameter in system.parameters}
        start = math.radians(self.theta_0) if self.system in SWINGING else getattr(self, f"{self.system}_start")
        return AnalogueCase(system=system, p=p, q_0=start, window=self.window, standing=standing)

    def readouts(self) -> tuple[Readout, ...]:
        return N.readouts(self._case())

    def about(self, shown: Picture) -> About:
        return analogue_about(shown, self._case())


# The other parameters are those of the nine systems, as the table of physics.analogues has them.
for _name, _quantity in quantities().items():
    Analogues.param.add_parameter(_name, _quantity)


def _signals(case: AnalogueCase, time: Axis, size: Axis, energy: Axis) -> dict[str, AnySignal]:
    """cos and sin of omega t; the share of the amplitude at which q stands; numbers and angles from these."""
    E, exact_E = energy.place(case.energy), energy.place(case.exact_energy)
    place, place_in_table = size.place(case.q_0), case.table_axis.place(case.q_0)
    signals = {
        "cosine": sines(ONE, time, (1.0, case.omega, math.pi / 2)),
        "sine": sines(ONE, time, (1.0, case.omega, 0.0)),
        **_shares(case, time),
        "level": derived(place * SHARE),
        "pose": derived(var("size") * SHARE),
        "rule": derived(place * COSINE),
        "x": derived(place_in_table * COSINE),
        "q": derived(place_in_table * SHARE),
        "T_x": derived(E * SINE_SQUARED),
        "V_x": derived(E * COSINE_SQUARED),
        "T_q": derived(exact_E - exact_E * ROOT_SQUARED),
        "V_q": derived(exact_E * ROOT_SQUARED),
    }
    if case.pendulum:
        signals |= {"angle": derived(case.q_0 * SHARE), "rule_angle": derived(case.q_0 * COSINE)}
        signals |= {"angle_sine": sine_of("angle"), "angle_cosine": cosine_of("angle")}
        signals |= {"rule_sine": sine_of("rule_angle"), "rule_cosine": cosine_of("rule_angle")}
    return signals


def _shares(case: AnalogueCase, time: Axis) -> dict[str, AnySignal]:
    """q over q_0, and the square root of V over its largest: both the cosine where the system is linear."""
    if not case.pendulum:
        return dict.fromkeys(("share", "root"), derived(COSINE))
    theta, theta_dot, size = case.swings
    half = math.sin(size / 2)
    return {
        "share": sampled(time, case.period, theta / size, theta_dot / size),
        "root": sampled(time, case.period, np.sin(theta / 2) / half, np.cos(theta / 2) * theta_dot / (2 * half)),
    }


def _pace(case: AnalogueCase) -> Pace:
    """A swing of a few seconds is played in real time, also where the small one would not be."""
    own = pace(2 * math.pi / case.period, case.omega)
    return Pace(1.0, own.limit) if UNHURRIED[0] <= case.period <= UNHURRIED[1] else own


def _scalars(case: AnalogueCase, axes: dict[str, Axis]) -> dict[str, float]:
    """Sizes on the stage, what is shown of it, places of brackets and flags, and the clock's speed."""
    time, T_0, T = axes["t"], case.spring.period, case.period
    scalars = {
        case.system.slug: 1.0,
        "amplitude": axes["q"].place(abs(case.q_0)),
        "per_q": 1.3 / axes["q"].place(axes["q"].end),
    }
    scalars["size"] = math.copysign(min(abs(case.q_0) / (LARGEST * case.system.swing), 1.0), case.q_0)
    scalars |= {"half_waves": min(case.p.get("n", 1.0), MOST_HALF_WAVES)}
    scalars |= {"along": 10 / scalars["half_waves"], "belly": 0.5 / scalars["half_waves"]}
    drawn = samples(case.end, case.omega) > 12 * case.end / T_0 and abs(case.q_0) <= axes["q"].end
    if case.pendulum:
        scalars |= _pendulum_scalars(case, axes)
        if drawn and case.end >= 3.1 * T:
            scalars |= {"late_seen": 1.0, "third_rule": time.place(3 * T_0), "third_swing": time.place(3 * T)}
    elif drawn and case.end >= 2 * T:
        scalars |= {"period_seen": 1.0, "first_peak": time.place(T), "second_peak": time.place(2 * T)}
    return scalars


def _pendulum_scalars(case: AnalogueCase, axes: dict[str, Axis]) -> dict[str, float]:
    """Where the pendulum hangs: lower and shorter where it swings over its pivot."""
    theta = abs(case.q_0)
    pivot, rod = (0.14, 0.5) if theta < 61 * DEGREE else (0.14, 0.43) if theta <= 91 * DEGREE else (0.46, 0.3)
    flags = {name: round(math.degrees(amplitude_at_excess(value)), 4) for name, value in LIMITS.items()}
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
        "late_before": float(theta > 25 * DEGREE),
        "late_after": float(theta <= 25 * DEGREE),
        **flags,
    }


def _forms(case: AnalogueCase) -> dict[str, str]:
    slug = case.system.slug
    kind = "swinging" if case.pendulum else "linear"
    forms = {
        "system": slug,
        "reach": slug if case.q_0 else "rest",
        slug: "shown",
        kind: "shown",
        "q": slug,
        "x": slug if case.pendulum else "linear",
    }
    return forms | ({"note": slug} if slug in REMARKS else {})


def _notes(case: AnalogueCase) -> tuple[str, ...]:
    if case.p.get("n", 1.0) > MOST_HALF_WAVES:
        return (f"The picture shows {MOST_HALF_WAVES} half waves; the numbers are those of n.",)
    return ()
