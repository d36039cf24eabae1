"""Energy: the scene of a hanging mass, whose energy goes to and fro; gravity sets where it hangs (D31, points 4 to
6)."""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from components.language.blocks import Block
from components.language.numbers import var
from components.language.signals import AnySignal
from components.language.state import Frame
from components.layout.controls import Group
from components.layout.stage import wire
from components.quantities.axes import ONE, Axis
from components.quantities.motion import QUARTER, derived, pace, sines
from components.quantities.parameters import Values, displacement, mass, not_negative, one_of, positive, velocity
from components.quantities.readouts import Readout
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scene.traces import Columns, Floats, band_columns, bands_over_time, over_time, samples, trace
from components.scenes.energy.about import energy_about
from components.scenes.energy.case import HangingCase, case_axes, claim
from components.scenes.energy.hanging import PLANETS
from components.scenes.energy.numbers import Numbers as N
from components.scenes.energy.sheet import hanging_sheet
from components.scenes.energy.watch import WATCH
from physics.hanging import Datum, HangingMass
from physics.sampling import Sinusoid, drawable


class Energy(Scene):
    slug = "energy"
    title = "Energy"
    lecture = "D31"
    points = "points 4 to 6"
    headline = "Energy swings between motion and position; the sum stays constant"
    pictured = ("energy", {"window": 1.5})
    spoken = {"natural frequency": N.omega, "period": N.tau, "energy": N.E_total, "static deflection": N.delta_st}
    equations = (
        "m x'' + k x = 0; x downwards from equilibrium",
        "T = m v^2/2; delta_st = m g/k",
        "V = k x^2/2; with datum = separate larger by m g delta_st/2",
    )
    groups = (
        Group("Mass and spring", ("m", "k")),
        Group("Start", ("x_0",)),
        Group("", ("v_0",), "Start velocity", folded=True),
        Group("", ("g",), "Gravity", actions=tuple((slug, name) for slug, (name, _) in PLANETS.items()), folded=True),
        Group("V is counted from", ("datum",)),
    )
    places = tuple(PLANETS)
    shares = {"mass": "m", "stiffness": "k"}
    watch = WATCH
    presets = {
        "Pulled down": {},
        "Pushed up": {"x_0": -0.2},
        "Kicked at equilibrium": {"x_0": 0.0, "v_0": 1.2},
        "Heavy": {"m": 2.0},
        "Soft": {"k": 20.0},
        "Hanging still": {"x_0": 0.0},
    }

    m = mass(
        1.0,
        symbol="m",
        tint="m1",
        says="is the mass. It sets where it hangs and how fast it swings. Any value above 0.",
    )
    k = positive(
        39.4, symbol="k", unit="N/m", label="stiffness", tint="k", scale="log", softbounds=(1.0, 200.0),
        says="is the stiffness of the spring. Any value above 0: a weight cannot hang on nothing.",
    )  # fmt: skip
    g = not_negative(
        9.81, symbol="g", unit="m/s²", label="gravity", softbounds=(0.0, 30.0),
        allowed="gravity is a finite number, 0 or more",
        says="is the gravity. It moves the equilibrium, and not the swing. Any value from 0 up.",
    )  # fmt: skip
    x_0 = displacement(
        0.2, symbol="x_0", tint="m1", softbounds=(-0.3, 0.3),
        says="is how far down it is pulled at the start. Any number.",
    )  # fmt: skip
    v_0 = velocity(
        0.0, symbol="v_0", tint="m1", softbounds=(-2.0, 2.0),
        says="is the velocity at the start, positive downwards. Any number.",
    )  # fmt: skip
    datum = one_of(
        default="equilibrium",
        objects={"Equilibrium": "equilibrium", "Spring + gravity": "separate", "Three terms": "slide"},
        label="Datum of V",
    )

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return hanging_sheet()

    def action(self, name: str) -> Values:
        return {"g": PLANETS[name][1]}

    def picture(self, frame: Frame = FITTED) -> Picture:
        case = self._case(self.datum, frame)
        t = np.linspace(0.0, case.end, samples(case.end, 2 * case.omega))
        names, bands = _drawn(case, t)
        axes = framed(frame, case_axes(case))
        return Picture(
            columns={**bands_over_time(t, bands), "well": _well_columns(case, axes["x_well"])},
            axes=axes,
            signals=_signals(case, axes),
            traces=over_time(case.end, 2 * case.omega, names, lambda t: _exact(case, t)),
            scalars=_scalars(case, axes, t),
            pace=pace(case.omega, case.omega),
            values=N.texts(case, axes),
            live={
                "x": axes["x"].digits(signed=True),
                **{name: axes["E"].digits() for name in ("T", "V", "spring")},
                **{name: axes["E"].digits(signed=True) for name in ("gravity", "constant")},
            },
            forms={"datum": case.datum, "claim": claim(case), "place": "said"},
        )

    def readouts(self) -> tuple[Readout, ...]:
        return N.readouts(self._case("equilibrium"))

    def _case(self, datum: str, frame: Frame = FITTED) -> HangingCase:
        system, window = HangingMass(m=self.m, k=self.k, g=self.g), self.window
        return HangingCase(system=system, x_0=self.x_0, v_0=self.v_0, datum=datum, window=window, standing=frame.window)

    def about(self, shown: Picture) -> About:
        system = HangingMass(m=self.m, k=self.k, g=self.g)
        datum: Datum = "separate" if self.datum == "separate" else "equilibrium"
        return energy_about(shown, system, self.x_0, self.v_0, datum)


def _exact(case: HangingCase, t: Floats) -> Columns:
    """x, T and V, the energies of spring and gravity counted apart, and what stands still."""
    motion = case.system.motion(case.x_0, case.v_0, t)
    energies = case.system.energies(motion.x, motion.v, "separate" if case.separate else "equilibrium")
    levels = {"total": case.total, "constant": -case.constant}
    return {
        "x": motion.x,
        **{name: getattr(energies, name) for name in ("T", "V", "spring", "gravity")},
        **{name: np.full_like(t, level) for name, level in levels.items()},
    }


def _drawn(case: HangingCase, t: Floats) -> tuple[tuple[str, ...], Columns]:
    """The names of the curves over time, and the bands of those that are too fast."""
    omega, phi, half = case.omega, case.constants.phi, case.E / 2
    potential = Sinusoid(half, 2 * omega, 2 * phi - QUARTER)
    swings: dict[str, tuple[list[Sinusoid], float]] = {
        "x": ([Sinusoid(case.constants.C, omega, phi)], 0.0),
        "T": ([Sinusoid(half, 2 * omega, 2 * phi + QUARTER)], half),
        "V": ([potential], half + case.shift),
    }
    if case.apart:
        stretch = Sinusoid(case.weight, omega, phi)
        swings["spring"] = [potential, stretch], half + case.constant
        swings["gravity"] = [stretch._replace(phase=phi + math.pi)], 0.0
    bands: Columns = {}
    for name, (parts, base) in swings.items():
        if not drawable(max(part.omega for part in parts), t):
            bands |= trace(name, parts, t, np.full_like(t, base))[1]
    levels = ("total", "constant") if case.datum == "slide" else ("total",)
    return (*(name for name in swings if band_columns(name)[0] not in bands), *levels), bands


def _well_columns(case: HangingCase, axis: Axis) -> Columns:
    """V over x; term by term, also its terms, and where the slide's constant is not among them, the slide's V."""
    x = np.linspace(axis.start, axis.end, 121)
    slide = case.system.well(x)
    if not case.apart:
        return {"x": x, "V": slide}
    parts = case.system.energies(x, np.zeros_like(x))
    columns = {"x": x, "spring": parts.spring, "gravity": parts.gravity}
    if case.separate:
        return columns | {"V": case.system.well(x, "separate"), "other": slide}
    return columns | {"V": slide, "constant": np.full_like(x, -case.constant)}


def _signals(case: HangingCase, axes: dict[str, Axis]) -> dict[str, AnySignal]:
    """x, and the energies from the sine and cosine of the phase."""
    time, energy, phi = axes["t"], axes["E"], case.constants.phi
    sine, cosine = var("sine"), var("cosine")
    sine_squared = sine * sine
    E, shift, weight, constant = (energy.place(v) for v in (case.E, case.shift, case.weight, case.constant))
    return {
        "x": sines(axes["x"], time, (case.constants.C, case.omega, phi)),
        "sine": sines(ONE, time, (1.0, case.omega, phi)),
        "cosine": sines(ONE, time, (1.0, case.omega, phi + QUARTER)),
        "T": derived(E * cosine * cosine),
        "V": derived(E * sine_squared + shift),
        "spring": derived(E * sine_squared + weight * sine + constant),
        "gravity": derived(-weight * sine),
        "constant": derived(-constant),
        "total": derived(E + shift),
        "V_share": derived(_share(case.E, case.total) * sine_squared + _share(case.shift, case.total)),
    }


def _share(part: float, whole: float) -> float:
    return part / whole if whole else 0.0


def _scalars(case: HangingCase, axes: dict[str, Axis], t: Floats) -> dict[str, float]:
    """Places on the stage, sizes, and the clock's speed."""
    x, delta, C = axes["x"], case.system.delta_st, case.constants.C
    span = x.start - x.end
    far = -delta < x.end
    scalars = {
        "x_top": x.place(x.end),
        "x_bottom": x.place(x.start),
        "per_span": 1 / (x.place(x.start) - x.place(x.end)),
        "per_window": 1 / axes["t"].place(case.end),
        "natural": x.place(max(-delta, x.end)),
        "natural_seen": float(not far),
        "natural_far": float(far),
        "apart": float(delta > 0.1 * span),
        "close": float(0 < delta <= 0.1 * span),
        "together": float(not delta),
        "has_energy": float(case.total > 0),
        "swinging": float(C > 0),
        "shift": axes["E"].place(case.shift),
        "shifted": float(case.shift > 0.1 * (axes["E"].end - axes["E"].start)),
        "C": x.place(C),
        "phi": case.constants.phi,
        "side": min(max(math.sqrt(case.system.m), 0.5), 1.3),
        "wire": wire(case.system.k),
        **_planets(case, x),
    }
    if drawable(case.omega, t):
        scalars["swings"] = case.end / case.system.oscillator.period
    return scalars


def _planets(case: HangingCase, x: Axis) -> dict[str, float]:
    """Where the mass would hang elsewhere, as far as that is in the picture and apart from what else is."""
    scalars: dict[str, float] = {}
    taken = [0.0, -case.system.delta_st]
    for slug, (_, g) in PLANETS.items():
        scalars[f"{slug}_here"] = float(g == case.system.g)
        place = case.system.delta_st * (g / case.system.g - 1) if case.system.g else g * case.system.m / case.system.k
        apart = min(abs(place - other) for other in taken) > 0.065 * (x.start - x.end)
        if apart and x.end <= place <= x.start:
            taken.append(place)
            scalars |= {slug: x.place(place), f"{slug}_seen": 1.0}
        elif scalars[f"{slug}_here"]:
            scalars[slug] = 0.0
    return scalars
