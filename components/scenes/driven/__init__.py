"""Driven: the scene of one damped mass under a force, a shaken base or an unbalance, through its resonance (D33)."""

from __future__ import annotations

import math

from components.dashpot import DashpotScene, keeping, parts
from components.language.state import Frame
from components.layout.controls import Group
from components.quantities.motion import pace
from components.quantities.parameters import Values, angular_frequency, displacement, force, not_negative, velocity
from components.quantities.readouts import Readout
from components.scene import Picture
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scene.traces import over_time
from components.scenes.driven.about import driven_about
from components.scenes.driven.case import KINDS, DrivenCase
from components.scenes.driven.curves import (
    END,
    RESPONSE,
    Places,
    Resonance,
    Signals,
    axes_of,
    columns_of,
    drawn,
    exact,
    fast_in,
    moving,
    ringing,
)
from components.scenes.driven.numbers import Numbers as N
from components.scenes.driven.polygon import corners_of
from components.scenes.driven.sheet import KIND, driven_sheet
from components.scenes.driven.watch import WATCH
from components.scenes.driven.words import Forms, notes
from physics.driven import DrivenOscillator

NATURAL = math.sqrt(39.48)
"""The natural frequency of the presets, in rad/s: a period of one second."""

BELOW = {
    "kind": "force",
    "F_0": 2.0,
    "Y": 0.05,
    "moment": 0.05,
    "omega": 4.398,
    "m": 1.0,
    "k": 39.48,
    "c": 2.513,
    "keep": "c",
    "x_0": 0.0,
    "v_0": 0.0,
}


class DrivenScene(DashpotScene):
    slug = "driven"
    title = "Driven"
    lecture = "D32, D33"
    points = "forced vibration with a dashpot"
    headline = "At resonance spring and inertia cancel; only the dashpot holds the push"
    pictured = (RESPONSE, {})
    spoken = {"size of the swing": N.X, "r": N.r, "lag": N.phi}
    equations = (
        "kind = force: m x'' + c x' + k x = F_0 sin(omega t)",
        "kind = base: m x'' + c (x' - y') + k (x - y) = 0; y = Y sin(omega t)",
        "kind = unbalance: m x'' + c x' + k x = moment omega^2 sin(omega t); moment = m_0 e",
        "r = omega/omega_n; M = |X| over F_0/k or over Y or over moment/m; lag = -arg X",
        "power = 2 zeta (r M)^2: the power lost over its largest; times Q = 1/(2 zeta)",
        "P_in and P_lost are means over the last 2 pi/omega; 0 before t = 0",
    )
    watch = WATCH
    presets = {
        "Below": BELOW,
        "Resonance": {**BELOW, "omega": 6.2833},
        "Above": {**BELOW, "omega": 12.566},
        "Strong dashpot": {**BELOW, "omega": 6.2833, "c": 10.05},
        "No dashpot": {**BELOW, "omega": NATURAL, "c": 0.0},
        "Beats": {**BELOW, "omega": 5.655, "c": 0.0},
        "Washboard": {**BELOW, "kind": "base", "omega": 10.053},
        "Spin-dry": {**BELOW, "kind": "unbalance", "omega": 9.425},
    }

    kind = KIND
    physical = (kind,)
    F_0 = force(2.0, says="is the amplitude of the force. Type any value from 0 up.")
    Y = not_negative(
        0.05, symbol="Y", unit="m", label="amplitude of the base", tint="F", softbounds=(0.0, 0.2),
        says="is how far the base is shaken to each side. Any value from 0 up.",
    )  # fmt: skip
    moment = not_negative(
        0.05, symbol="m₀e", unit="kg m", label="unbalance", tint="F", softbounds=(0.0, 0.2),
        says="is the mass that turns times its distance from the axle. Any value from 0 up.",
    )  # fmt: skip
    omega = angular_frequency(
        4.398, softbounds=(0.0, 2.5 * NATURAL), says="is the frequency of the drive. Any value from 0 up."
    )
    m, k, c, zeta = parts(1.0, 39.48, 2.513, hangs=False)
    keep = keeping()
    x_0 = displacement(symbol="x_0", tint="m1", softbounds=(-0.3, 0.3), says="is where the mass starts. Any number.")
    v_0 = velocity(symbol="v_0", tint="m1", softbounds=(-3.0, 3.0), says="is the velocity at the start. Any number.")
    groups = (
        Group("Drive", (omega,)),
        *(Group("", (one,), form=Forms.driven[kind]) for kind, one in zip(KINDS, (F_0, Y, moment), strict=True)),
        Group("Mass, spring, dashpot", (m, k, c, zeta)),
        Group("", (x_0, v_0), "Start", folded=True),
        Group("When m or k changes", (keep,)),
    )

    sheet = staticmethod(driven_sheet)

    def picture(self, frame: Frame = FITTED) -> Picture:
        case = self._case(frame)
        axes, fast = framed(frame, axes_of(case)), fast_in(case)
        return Picture(
            columns=columns_of(case, axes),
            axes=axes,
            signals=Signals.signals(case, axes),
            traces=over_time(case.end, case.fastest, drawn(case), lambda t: exact(case, t), moving=moving(case)),
            scalars=Places.scalars(case, axes) | Resonance.scalars(case, axes) | corners_of(case, axes),
            pace=pace(min(case.omega_n, case.omega or case.omega_n), max(case.omega_n, case.omega)),
            values=N.texts(case, axes),
            live=Signals.live(axes),
            forms=Forms.forms(case),
            notes=notes(case, Signals.x in fast, ringing(case), Signals.y in fast),
            spans={"omega": (0.0, END * case.omega_n)},
        )

    def readouts(self) -> tuple[Readout, ...]:
        return N.readouts(self._case())

    def about(self, shown: Picture) -> About:
        return driven_about(shown, self._case())

    def _case(self, frame: Frame = FITTED) -> DrivenCase:
        return DrivenCase(
            oscillator=DrivenOscillator(m=self.m, c=self.c, k=self.k),
            kind=self.kind,
            size={"force": self.F_0, "base": self.Y, "unbalance": self.moment}[self.kind],
            omega=self.omega,
            x_0=self.x_0,
            v_0=self.v_0,
            window=self.window,
            standing=frame.window,
        )
