"""A second mass tuned to the drive holds a machine still, at the price of two resonances (D34, point 9)."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import param

from components.about import About
from components.about_chain import absorber_about
from components.axes import nice_axis, time_axis
from components.controls import Group
from components.duty import Duty
from components.motion import pace
from components.parameters import angular_frequency, mass, not_negative, positive, stiffness
from components.scene import Picture, Scene
from components.scenes.absorber import data, drawing
from components.scenes.absorber.goals import goals
from components.scenes.absorber.words import sentences
from components.sheet import Block, column, row, words
from components.units import Unit
from physics.absorber import den_hartog, tuned_stiffness
from physics.coupled import TwoMassChain
from physics.forced import antiresonance
from physics.sampling import periods

MACHINE = ("m1", "k1", "F_0", "omega")
TOP = (15.0, 20.0)
"""How far the axes of swing and stroke reach, over the static deflection."""
TURNS = 8
"""Periods of the drive that the clock plays."""


class Absorber(Scene):
    slug = "absorber"
    title = "Absorber"
    lecture = "D34"
    headline = "A tuned mass holds the machine still; the price is two resonances"
    start = "Machine"
    presets = {
        "Below": {},
        "Resonant": {"omega": 50.0},
        "Above": {"omega": 60.0},
        "Own": {"own": True},
    }
    groups = (
        Group(
            "The machine",
            (),
            "fixed",
            show="fixed",
            facts=(
                ("[m1|$m_1$]", "mass", "{m1}", "kg"),
                ("[k|$k_1$]", "mounting", "{k1}", "kN/m"),
                ("[F|$F_0$]", "shaking force", "{F_0}", "N"),
                (r"[F|$\omega$]", "running speed", "{omega}", "rad/s"),
            ),
        ),
        Group("Your own machine", MACHINE, show="own", dense=True),
        Group(
            "Your absorber",
            ("m2", "k2", "tuning"),
            "or drag the valley",
            facts=((r"Mass ratio $\mu = m_2/m_1$", "{mu}"), ("Lightest that met every goal", "{lightest}")),
        ),
        Group("Beyond the lecture", ("damping",)),
        Group("", ("c",), actions=(("optimum", "Den Hartog's optimum"),), show="damped"),
    )

    m1 = mass(100.0, symbol="m_1", tint="m1", softbounds=(10, 1000), says="is the machine. Type any value above 0.")
    k1 = positive(
        250e3,
        label="mounting",
        symbol="k_1",
        unit="N/m",
        tint="k",
        softbounds=(1e4, 1e7),
        scale="log",
        says="is the spring under the machine. Type any value above 0.",
    )
    F_0 = positive(
        500.0,
        label="shaking force",
        symbol="F_0",
        unit="N",
        tint="F",
        softbounds=(10, 1e4),
        scale="log",
        says="shakes the machine. Type any value above 0.",
    )
    omega = angular_frequency(
        48.0,
        symbol="ω",
        softbounds=(10.0, 100.0),
        bounds=(0.0, None),
        inclusive_bounds=(False, True),
        says="is the machine's running speed. Type any value above 0.",
        allowed="a running speed is a finite number above 0",
    )
    own = param.Boolean(default=False, label="Own machine")
    m2 = mass(
        16.0,
        symbol="m_2",
        tint="m2",
        softbounds=(1.0, 100.0),
        says="moves the two resonances apart. Meet all three goals, then do it with less mass.",
    )
    k2 = stiffness(
        36864.0,
        symbol="k_2",
        softbounds=(0, 200e3),
        says="moves the valley. The machine stands still where √(k₂/m₂) is its speed.",
    )
    tuning = param.Selector(
        default="tuned",
        objects={"Keep tuned": "tuned", "Free": "free", "Detach": "detached"},
        label="Absorber spring",
    )
    damping = param.Selector(default="none", objects={"No damping": "none", "Add damping": "added"}, label="Damping")
    c = not_negative(
        100.0,
        label="damping",
        symbol="c",
        unit="N s/m",
        tint="ink",
        softbounds=(0, 2000),
        scale="near0",
        says="damps the motion of the masses against each other. Type any value from 0 up.",
    )
    _valley = angular_frequency(48.0, symbol="ω₂", label="tuned frequency")
    _lightest = mass(None, symbol="m_2", allow_None=True)  # type: ignore[arg-type]

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return column(
            row(drawing.picture(), words(*sentences(), style="facts", basis=286, phone=5), grow=228, gap=26),
            row(column(drawing.swing_plot(), drawing.stroke_plot()), goals(), grow=346, gap=26),
        )

    def units(self) -> dict[str, Unit]:
        kilo = Unit("kN/m", 1e3)
        return {"k1": kilo, "k2": kilo}

    def action(self, name: str) -> dict[str, Any]:
        best = den_hartog(self.m1, self.k1, self.m2)
        k2, c = (float(f"{value:.4g}") for value in (best.k2, best.c))
        return {"k2": k2, "c": c, "tuning": "free"}

    def following(self, changed: frozenset[str]) -> dict[str, Any]:
        """A tuned spring follows mass and speed, the knob sets the spring, the score is of this machine."""
        k2, tuning = self.k2, self.tuning
        if "_valley" in changed:
            k2, tuning = tuned_stiffness(self.m2, self._valley), "free"
        elif "k2" in changed and "tuning" not in changed and k2 != tuned_stiffness(self.m2, self.omega):
            tuning = "free"
        if tuning == "tuned":
            k2 = tuned_stiffness(self.m2, self.omega)
        valley = antiresonance(TwoMassChain(m1=self.m1, m2=self.m2, k1=self.k1, k2=k2))
        best = None if changed & set(MACHINE) else self._lightest
        if tuning != "detached" and not self._damping and all(self._duty(k2).met) and self.m2 < (best or math.inf):
            best = self.m2
        return {"k2": k2, "tuning": tuning, "_valley": valley, "_lightest": best}

    @property
    def _damping(self) -> float:
        return self.c if self.damping == "added" else 0.0

    def _range_sliders(self, own: float) -> None:
        """Sliders span what is of interest on a machine of this size."""
        spans = {
            "m2": (max(0.01 * self.m1, 5e-324), self.m1),
            "k2": (0.0, 0.8 * self.k1),
            "c": (0.0, 0.4 * math.sqrt(self.k1) * math.sqrt(self.m1)),
            "omega": (0.2 * own, min(2.0 * own, 1e308)),
        }
        for name, span in spans.items():
            self.param[name].softbounds = span

    def _duty(self, k2: float, c: float = 0.0) -> Duty:
        return Duty(m1=self.m1, k1=self.k1, F_0=self.F_0, omega=self.omega, m2=self.m2, k2=k2, c=c)

    @property
    def _shown_duty(self) -> Duty:
        return self._duty(0.0, 0.0) if self.tuning == "detached" else self._duty(self.k2, self._damping)

    def picture(self) -> Picture:
        duty = self._shown_duty
        end = self.window or periods(self.omega, TURNS)
        low, high = min(0.4 * duty.own, 0.7 * self.omega), max(1.6 * duty.own, 1.3 * self.omega)
        swing, stroke = (drawing.size_axis(duty.deflections(top)) for top in TOP)
        axes = {
            "t": time_axis(end),
            "w": nice_axis(low, high, "rad/s", 6, exact=True),
            "X1": swing,
            "X2": stroke,
        }
        push = nice_axis(0.0, self.F_0, "N")
        self._range_sliders(duty.own)
        columns, seen = data.columns(duty, axes)
        drawn, tick = data.drawn(duty, end, swing)
        fastest = max(self.omega, float(duty.driven.free.omega[1])) if not duty.steady else self.omega
        return Picture(
            columns=columns,
            axes=axes,
            signals=data.signals(duty, swing, axes["t"], push),
            scalars={**drawn, **data.marks(duty, axes), **seen, **pace(self.omega, fastest)},
            values={**data.values(duty, axes, push, self.m2, self._lightest), "tick": tick},
            live={
                **{name: swing.digits(signed=True) for name in ("x_alone", "x1", "x2")},
                **{name: push.digits(signed=True) for name in ("drive_now", "pull_now")},
            },
            forms=data.forms(duty, own=self.own, damped=self.damping == "added"),
        )

    def about(self) -> About:
        return absorber_about(self.shown, self._shown_duty)
