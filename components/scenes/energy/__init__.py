"""Energy: the scene of a hanging mass, whose energy goes to and fro; gravity sets where it hangs (D31, points 4 to
6)."""

from __future__ import annotations

from components.language.state import Frame
from components.layout.controls import Group
from components.quantities.motion import pace
from components.quantities.parameters import Values, displacement, mass, not_negative, one_of, positive, velocity
from components.quantities.readouts import Readout
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scene.traces import over_time
from components.scenes.energy.about import energy_about
from components.scenes.energy.case import HangingCase, axes_of
from components.scenes.energy.curves import (
    ENERGY,
    PLANETS,
    Places,
    Signals,
    drawn,
    exact,
    moving,
    planets_of,
    well_columns,
)
from components.scenes.energy.numbers import Forms
from components.scenes.energy.numbers import Numbers as N
from components.scenes.energy.sheet import hanging_sheet
from components.scenes.energy.watch import WATCH
from physics.hanging import Datum, HangingMass

PULLED = {"m": 1.0, "k": 39.4, "x_0": 0.2, "v_0": 0.0}


class Energy(Scene):
    slug = "energy"
    title = "Energy"
    lecture = "D31"
    points = "points 4 to 6"
    headline = "Energy swings between motion and position; the sum stays constant"
    pictured = (ENERGY, {"window": 1.5})
    spoken = {"natural frequency": N.omega, "period": N.tau, "energy": N.E_total, "static deflection": N.delta_st}
    equations = (
        "m x'' + k x = 0; x downwards from equilibrium",
        "T = m v^2/2; delta_st = m g/k",
        "V = k x^2/2; with datum = separate larger by m g delta_st/2",
    )
    places = tuple(PLANETS)
    shares = {"mass": "m", "stiffness": "k"}
    watch = WATCH
    presets = {
        "Pulled down": PULLED,
        "Pushed up": {**PULLED, "x_0": -0.2},
        "Kicked at equilibrium": {**PULLED, "x_0": 0.0, "v_0": 1.2},
        "Heavy": {**PULLED, "m": 2.0},
        "Soft": {**PULLED, "k": 20.0},
        "Hanging still": {**PULLED, "x_0": 0.0},
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
        "equilibrium",
        {"equilibrium": "Equilibrium", "separate": "Spring + gravity", "slide": "Three terms"},
        "Datum of V",
    )
    groups = (
        Group("Mass and spring", (m, k)),
        Group("Start", (x_0,)),
        Group("", (v_0,), "Start velocity", folded=True),
        Group("", (g,), "Gravity", actions=tuple((slug, name) for slug, (name, _) in PLANETS.items()), folded=True),
        Group("V is counted from", (datum,)),
    )

    sheet = staticmethod(hanging_sheet)

    def action(self, name: str) -> Values:
        return {"g": PLANETS[name][1]}

    def picture(self, frame: Frame = FITTED) -> Picture:
        case = self._case(self.datum, frame)
        signals, bands = drawn(case)
        axes = framed(frame, axes_of(case))
        return Picture(
            columns={**bands, "well": well_columns(case, axes)},
            axes=axes,
            signals=Signals.signals(case, axes),
            traces=over_time(
                case.end, 2 * case.omega, signals, lambda t: exact(case, t), moving=moving(case), moves=case.omega
            ),
            scalars=Places.scalars(case, axes) | planets_of(case, axes),
            pace=pace(case.omega, case.omega),
            values=N.texts(case, axes),
            live=Signals.live(axes),
            forms=Forms.forms(case),
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
