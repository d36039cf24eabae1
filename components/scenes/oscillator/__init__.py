"""Oscillator: the scene of spring and mass, with x, v and a as one turning arrow (D31, points 1 to 3)."""

from __future__ import annotations

from components.language.state import Frame
from components.layout.controls import Group
from components.quantities.declared import by_name
from components.quantities.motion import pace
from components.quantities.parameters import displacement, mass, one_of, stiffness, velocity
from components.quantities.readouts import Readout
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scene.traces import BAND, Traces, over_time
from components.scenes.oscillator.about import oscillator_about
from components.scenes.oscillator.case import Oscillation
from components.scenes.oscillator.curves import (
    ROWS,
    Pulled,
    Signals,
    axes_of,
    bands_of,
    exact,
    force_axis,
    scalars_of,
)
from components.scenes.oscillator.numbers import Forms, parts_of
from components.scenes.oscillator.numbers import Numbers as N
from components.scenes.oscillator.sheet import WATCH, oscillator_sheet
from physics.oscillator import Oscillator

PULLED = {"m": 1.0, "k": 39.4, "x_0": 0.15, "v_0": 0.0}


class OscillatorScene(Scene):
    slug = "oscillator"
    title = "Oscillator"
    lecture = "D31"
    points = "points 1 to 3"
    headline = "A swing is a turning arrow, seen from the side"
    spoken = {"natural frequency": N.omega, "period": N.tau}
    equations = (
        "m x'' + k x = 0",
        "omega_n = sqrt(k/m); v = x'; a = x''; x = x_0 and v = v_0 at t = 0",
    )
    shares = {"mass": "m", "stiffness": "k"}
    watch = WATCH
    presets = {
        "Pulled": PULLED,
        "Kicked": {**PULLED, "x_0": 0.0, "v_0": 0.8},
        "Pushed back": {**PULLED, "x_0": 0.1, "v_0": -0.8},
        "Heavy": {**PULLED, "m": 4.0},
        "Stiff": {**PULLED, "k": 158.0},
        "Rest": {**PULLED, "x_0": 0.0},
        "No spring": {**PULLED, "k": 0.0, "x_0": 0.1, "v_0": 0.02},
    }
    opens = {"x_0": PULLED["x_0"], "v_0": PULLED["v_0"], "view": "swing"}

    m = mass(
        1.0, symbol="m", tint="m1", says="is the mass. Four times the mass swings half as fast. Any value above 0."
    )
    k = stiffness(39.4, symbol="k", says="is the stiffness of the spring. At 0 the mass is free. Any value from 0 up.")
    x_0 = displacement(
        0.1, symbol="x_0", tint="m1", softbounds=(-0.3, 0.3),
        says="is where the mass starts, away from the wall. Any number.",
    )  # fmt: skip
    v_0 = velocity(
        -0.8, symbol="v_0", tint="T", softbounds=(-2.0, 2.0),
        says="is the velocity at the start, positive away from the wall. Any number.",
    )  # fmt: skip
    view = one_of(
        "motion", {"swing": "Motion", "motion": "Formulas", "force": "Force"}, "What is shown beside the motion"
    )
    groups = (Group("Mass and spring", (m, k)), Group("Start", (x_0, v_0)), Group("Shown", (view,)))

    sheet = staticmethod(oscillator_sheet)

    def picture(self, frame: Frame = FITTED) -> Picture:
        swing = self._swing(frame)
        axes = framed(frame, axes_of(swing))
        moving, counted = (Pulled, axes | force_axis(swing)) if self.view == "force" else (Signals, axes)
        values, drawn = N.texts(swing, counted), ROWS if swing.drawable else ()
        return Picture(
            columns={BAND: {}} if swing.drawable else bands_of(swing),
            axes=axes,
            signals=moving.signals(swing, counted),
            traces={
                **over_time(swing.end, swing.omega, drawn, lambda t: exact(swing, t), moving=ROWS),
                "loop": Traces(*swing.loop, tuple(row.name for row in ROWS), lambda t: by_name(exact(swing, t))),
            },
            scalars=scalars_of(swing, axes),
            pace=pace(swing.omega, swing.omega),
            values=values,
            live=moving.live(counted),
            forms=Forms.forms(swing) | by_name({Forms.parts: parts_of(swing, values)}),
        )

    def _swing(self, frame: Frame = FITTED) -> Oscillation:
        return Oscillation(
            oscillator=Oscillator(m=self.m, k=self.k), x_0=self.x_0, v_0=self.v_0, view=self.view,
            window=self.window, standing=frame.window,
        )  # fmt: skip

    def readouts(self) -> tuple[Readout, ...]:
        return N.readouts(self._swing())

    def about(self, shown: Picture) -> About:
        return oscillator_about(shown, Oscillator(m=self.m, k=self.k), self.x_0, self.v_0)
