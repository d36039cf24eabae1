"""Damped: the scene of a mass on a spring and a dashpot, which takes the same share of every swing (D32)."""

from __future__ import annotations

from components.dashpot import DashpotScene, keeping, parts
from components.language.state import Frame
from components.layout.controls import Group
from components.quantities.motion import pace
from components.quantities.parameters import Values, displacement, one_of, velocity
from components.quantities.readouts import Readout
from components.scene import Picture
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scene.traces import over_time
from components.scenes.damped.about import damped_about
from components.scenes.damped.case import DampedCase
from components.scenes.damped.curves import LAYERS, STACK, Signals, axes_of, columns_of, drawn, exact, instants, moving
from components.scenes.damped.numbers import Numbers as N
from components.scenes.damped.places import Arrows, Places, stairs_of
from components.scenes.damped.sheet import damped_sheet
from components.scenes.damped.watch import WATCH
from components.scenes.damped.words import Forms, notes
from physics.damped import DampedOscillator

LIGHT = {"m": 1.0, "c": 1.257, "k": 39.48, "x_0": 0.1, "v_0": 0.0, "keep": "c"}
CAR = {**LIGHT, "m": 300.0, "c": 1500.0, "k": 2e4, "x_0": 0.05}


class Damped(DashpotScene):
    slug = "damped"
    title = "Damped"
    lecture = "D32, D33"
    points = "free vibration with a dashpot"
    headline = "A dashpot takes the same share of every swing, or lets none begin"
    spoken = {"damping ratio": N.zeta, "natural frequency": N.omega, "each swing keeps": N.keep}
    equations = (
        "m x'' + c x' + k x = 0",
        "omega_n = sqrt(k/m); zeta = c/(2 m omega_n); omega_d = omega_n sqrt(1 - zeta^2); delta = 2 pi zeta "
        "omega_n/omega_d",
        "T = m v^2/2; V = k x^2/2; P = c v^2; E = T + V; E_0 - E is heat",
    )
    watch = WATCH
    presets = {
        "Light": LIGHT,
        "Car": CAR,
        "Worn": {**CAR, "c": 300.0},
        "Door closer": {**LIGHT, "m": 20.0, "c": 90.0, "k": 45.0, "x_0": 0.8},
        "Critical": {**LIGHT, "c": 12.566622},
        "Thrown": {**LIGHT, "c": 18.85, "v_0": -3.0},
        "No dashpot": {**LIGHT, "c": 0.0},
    }

    m, k, c, zeta = parts(1.0, 39.48, 1.257)
    keep = keeping()
    x_0 = displacement(
        0.1, symbol="x_0", tint="m1", softbounds=(-0.3, 0.3),
        says="is where the mass starts, away from the wall. Any number.",
    )  # fmt: skip
    v_0 = velocity(
        0.0, symbol="v_0", tint="m1", softbounds=(-3.0, 3.0),
        says="is the velocity at the start, positive away from the wall. Any number.",
    )  # fmt: skip
    view = one_of("motion", {"motion": "Motion", "forces": "Forces"}, "What is shown beside the mass")
    groups = (
        Group("Mass, spring, dashpot", (m, k, c, zeta)),
        Group("When m or k changes", (keep,)),
        Group("Start", (x_0, v_0)),
        Group("Shown", (view,)),
    )

    sheet = staticmethod(damped_sheet)

    def picture(self, frame: Frame = FITTED) -> Picture:
        case = self._case(frame)
        axes = framed(frame, axes_of(case))
        t = instants(case)
        shown = drawn(case, t)
        forces = Arrows.scalars(case, axes) if self.view == "forces" else {}
        return Picture(
            columns=columns_of(case, t),
            axes=axes,
            signals=Signals.signals(case, axes),
            traces=over_time(
                case.end,
                case.fastest,
                shown,
                lambda t: exact(case, t),
                moves=case.oscillator.omega_d,
                moving=moving(case),
                layers=LAYERS,
                averaged={*STACK, Signals.P} - {*shown},
            ),
            scalars=Places.scalars(case, axes) | stairs_of(case, axes) | forces,
            pace=pace(case.omega, case.omega),
            values=N.texts(case, axes),
            live=Signals.live(axes),
            forms=Forms.forms(case),
            notes=notes(case, t),
        )

    def readouts(self) -> tuple[Readout, ...]:
        return N.readouts(self._case())

    def about(self, shown: Picture) -> About:
        return damped_about(shown, self._case())

    def _case(self, frame: Frame = FITTED) -> DampedCase:
        oscillator = DampedOscillator(m=self.m, c=self.c, k=self.k)
        return DampedCase(oscillator=oscillator, x_0=self.x_0, v_0=self.v_0, window=self.window, standing=frame.window)
