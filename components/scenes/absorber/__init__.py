"""Absorber: the scene in which a tuned second mass keeps a machine still, at the cost of two resonances (D34, "simple
vibration damping").
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, Self

from components import chain
from components.language.state import Frame
from components.layout.controls import Group
from components.layout.views import View
from components.quantities.axes import nice_axis
from components.quantities.declared import Declared, Form, by_name
from components.quantities.motion import pace
from components.quantities.parameters import (
    Switch,
    Values,
    angular_frequency,
    mass,
    not_negative,
    one_of,
    positive,
    stiffness,
)
from components.quantities.readouts import Readout, SceneNumber
from components.quantities.units import Unit
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scene.scene import VIEW
from components.scenes.absorber.about import absorber_about
from components.scenes.absorber.case import AbsorberCase
from components.scenes.absorber.curves import (
    Axes,
    FromStart,
    Signals,
    axes_of,
    columns_of,
    moved,
    rest_of,
    signals_of,
    times,
)
from components.scenes.absorber.numbers import Numbers as N
from components.scenes.absorber.numbers import goal_texts
from components.scenes.absorber.places import Places, drawn
from components.scenes.absorber.sheet import absorber_sheet
from components.scenes.absorber.stage import SWING
from components.scenes.absorber.words import WATCH, Forms
from physics.absorber import den_hartog, tuned_stiffness
from physics.forced import antiresonance
from physics.sampling import periods

MACHINE = ("m1", "k1", "F_0", "omega")
TURNS = 8
"""Length of the time window in periods of the drive."""
RECORD: dict[str, Any] = {"allow_None": True, "says": "is of the lightest absorber that has met all goals."}
MOST_START = 20.0
"""The ends of the sliders for initial displacements, in static deflections F_0/k1."""


@lru_cache(maxsize=1)
def _asked_again(case: AbsorberCase) -> AbsorberCase:
    """Return the case with these values. It is cached, because one change needs it several times."""
    return case


BELOW = {"m1": 100.0, "k1": 250e3, "F_0": 500.0, "omega": 48.0, "own": False, "tuning": "tuned"}


class Panels(Declared[Any]):
    """The visible groups of controls."""

    own = Form[Any](lambda scene: scene.own)
    fixed = Form[Any](lambda scene: not scene.own)
    damped = Form[Any](lambda scene: scene.damping == "added")


class Absorber(Scene):
    slug = "absorber"
    title = "Absorber"
    lecture = "D34"
    points = "beyond the slides"
    headline = "A tuned mass can hold the machine still; the price is two resonances"
    spoken = {"machine": N.swing, "resonances": f"{{{N.slow.name}}} and {N.fast.aloud}"}
    equations = (
        "m1 x1'' = -k1 x1 - k2 (x1 - x2) - c (x1' - x2') + F_0 sin(omega t)",
        "m2 x2'' = k2 (x1 - x2) + c (x1' - x2'); c = 0 with damping = none",
    )
    start = "Machine"
    watch = WATCH
    presets = {
        "Below": BELOW,
        "Resonant": {**BELOW, "omega": 50.0},
        "Above": {**BELOW, "omega": 60.0},
        "Own": {**BELOW, "own": True},
    }

    m1 = mass(100.0, symbol="m_1", tint="m1", softbounds=(10, 1000), says="is the machine. Type any value above 0.")
    k1 = positive(
        250e3, label="mounting", symbol="k_1", unit="N/m", tint="k", softbounds=(1e4, 1e7), scale="log",
        says="is the spring under the machine. Type any value above 0.",
    )  # fmt: skip
    F_0 = positive(
        500.0, label="shaking force", symbol="F_0", unit="N", tint="F", softbounds=(10, 1e4), scale="log",
        says="shakes the machine. Type any value above 0.",
    )  # fmt: skip
    omega = angular_frequency(
        48.0, symbol="ω", softbounds=(10.0, 100.0), bounds=(0.0, None), inclusive_bounds=(False, True),
        says="is the machine's running speed. Type any value above 0.",
        allowed="a running speed is a finite number above 0",
    )  # fmt: skip
    own = Switch(default=False, label="Own machine")
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
    tuning = one_of("tuned", {"tuned": "Keep tuned", "free": "Free", "detached": "Detach"}, "Absorber spring")
    damping = one_of("none", {"none": "No damping", "added": "Add damping"}, "Damping")
    c = not_negative(
        100.0, label="damping", symbol="c", unit="N s/m", tint="ink", softbounds=(0, 2000), scale="near0",
        says="damps the motion of the masses against each other. Type any value from 0 up.",
    )  # fmt: skip
    x1_0, x2_0 = chain.start_positions()
    v1_0, v2_0 = chain.start_velocities()
    _valley = angular_frequency(48.0, symbol="ω₂", label="tuned frequency")
    lightest = positive(None, label="mass", symbol="m_2", unit="kg", softbounds=(1.0, 100.0), **RECORD)
    lightest_k2 = not_negative(None, label="stiffness", symbol="k_2", unit="N/m", softbounds=(0, 200e3), **RECORD)
    physical, reached = (tuning, damping), (lightest, lightest_k2)
    groups = (
        Group(
            "The machine",
            (),
            form=Panels.fixed,
            facts=(
                (f"[m1|$m_1 = {N.m1}$ kg] on [k|$k_1 = {N.k1}$ kN/m],",),
                (rf"shaken by [F|$F_0 = {N.F_0}$ N] at [F|$\omega = {N.omega}$ rad/s]",),
            ),
        ),
        Group("Your own machine", (m1, k1, F_0, omega), form=Panels.own, dense=True),
        Group(
            "Your absorber",
            (m2, k2, tuning),
            facts=((rf"Mass ratio $\mu = m_2/m_1 = {N.mu}$",), (f"Your lightest solution: {N.lightest}",)),
        ),
        Group("", (damping,), "Beyond the lecture: damping", folded=True),
        Group("", (c,), actions=(("optimum", "Den Hartog's optimum"),), form=Panels.damped),
        Group("", (x1_0, x2_0, v1_0, v2_0), "Start", folded=True, form=Forms.rest),
    )

    views = (
        View(
            "Goals",
            "Meet the goals for the displacements *x*_1, *x*_2 at the drive *ω*; then meet them with less mass *m*_2.",
            keys=(m2, k2), names=("stage", "stage:goals", "plot:swing"),
        ),
        View(
            "Stroke", "Make *m*_2 lighter: what does its stroke do, and where do the resonances go?",
            keys=(m2, k2), names=("stage", "plot:swing", "plot:stroke"),
        ),
        View(
            "From rest", "Start from rest: what stays that the particular solution does not show?",
            keys=(m2, k2), names=("stage", "plot:rest"), word="rest",
        ),
        View(
            "Formulas", "Change *m*_2, and watch the numbers in each formula.",
            keys=(m2, k2), names=("stage", "words:formulas"),
        ),
    )  # fmt: skip
    old_views = {"played": {"particular": "goals", "rest": "rest"}}

    sheet = staticmethod(absorber_sheet)

    def units(self) -> dict[str, Unit]:
        kilo, milli = Unit("kN/m", 1e3), Unit("mm", 1e-3)
        return {"k1": kilo, "k2": kilo, "x1_0": milli, "x2_0": milli}

    def action(self, name: str) -> Values:
        best = den_hartog(self.m1, self.k1, self.m2)
        k2, c = (float(f"{value:.4g}") for value in (best.k2, best.c))
        return {"k2": k2, "c": c, "tuning": "free"}

    def following(self, changed: frozenset[str], before: Self | None, *, in_hand: bool) -> Values:
        """Compute the values that depend on others: the spring of a tuned absorber, the spring that the knob sets, and
        the best result, which is dropped for another machine.
        """
        k2, tuning = self.k2, self.tuning
        if "_valley" in changed:
            k2, tuning = tuned_stiffness(self.m2, self._valley), "free"
        elif "k2" in changed and "tuning" not in changed and k2 != tuned_stiffness(self.m2, self.omega):
            tuning = "free"
        if tuning == "tuned":
            k2 = tuned_stiffness(self.m2, self.omega)
        case = self._case(k2, self._damping)
        best, spring = self._record(is_told=before is None, is_other=bool(changed & set(MACHINE)))
        if tuning != "detached" and not case.c and self.m2 < (best or math.inf) and all(case.met):
            best, spring = self.m2, k2
        return {
            "k2": k2,
            "tuning": tuning,
            "_valley": antiresonance(case.chain),
            "lightest": best,
            "lightest_k2": spring,
            **self._started(changed),
        }

    def derived(self) -> frozenset[str]:
        return frozenset({"k2"} if self.tuning == "tuned" else ())

    def _record(self, *, is_told: bool, is_other: bool) -> tuple[float | None, float | None]:
        """Return the lightest absorber so far that met all goals, and its spring. It must be for this machine; one from
        a link is checked."""
        best, spring = self.lightest, self.lightest_k2
        if is_told and best and spring is not None:
            machine = {name: getattr(self, name) for name in MACHINE}
            return (best, spring) if all(AbsorberCase(**machine, m2=best, k2=spring, c=0.0).met) else (None, None)
        return (None, None) if is_told or is_other else (best, spring)

    def _started(self, changed: frozenset[str]) -> Values:
        """Setting initial conditions opens the view that uses them. The particular solution has none."""
        if self.view == "rest" or not changed & {VIEW, *chain.START}:
            return {}
        return dict.fromkeys(chain.START, 0.0) if VIEW in changed else {VIEW: "rest"}

    @property
    def _damping(self) -> float:
        return self.c if self.damping == "added" else 0.0

    def _spans(self, case: AbsorberCase) -> dict[str, tuple[float, float]]:
        """Return the ends of sliders: the useful range for a machine of this size."""
        own, reach = case.own, min(case.deflections(MOST_START), 1e308)
        speed = min(own * reach, 1e308)
        return {
            "m2": (max(0.01 * self.m1, 5e-324), self.m1),
            "k2": (0.0, 0.8 * self.k1),
            "c": (0.0, 0.4 * math.sqrt(self.k1) * math.sqrt(self.m1)),
            "omega": (0.2 * own, min(2.0 * own, 1e308)),
            **dict.fromkeys(("x1_0", "x2_0"), (-reach, reach)),
            **dict.fromkeys(("v1_0", "v2_0"), (-speed, speed)),
        }

    def _case(self, k2: float, c: float) -> AbsorberCase:
        values = {"m1": self.m1, "k1": self.k1, "F_0": self.F_0, "omega": self.omega, "m2": self.m2}
        x_0, v_0 = chain.start_of(self)
        return _asked_again(AbsorberCase(**values, k2=k2, c=c, from_rest=self.view == "rest", x_0=x_0, v_0=v_0))

    @property
    def _shown_case(self) -> AbsorberCase:
        return self._case(0.0, 0.0) if self.tuning == "detached" else self._case(self.k2, self._damping)

    def picture(self, frame: Frame = FITTED) -> Picture:
        case, window = self._shown_case, self.window or periods(self.omega, TURNS)
        try:
            return self._drawn(case, frame, window, moved(case, times(case, frame.window or window)))
        except (ValueError, ArithmeticError):
            if not case.plays:
                raise
            return self._drawn(case, frame, window, None)  # the other views can be drawn

    def _drawn(self, case: AbsorberCase, frame: Frame, window: float, motion: FromStart | None) -> Picture:
        end = frame.window or window
        axes = framed(frame, axes_of(case, window))
        swing = Axes.X1(axes)
        own, rest, traces = rest_of(case, motion, end, swing)
        axes |= framed(frame, by_name({Axes.rest: own}))
        counted = axes | by_name({Axes.F: nice_axis(0.0, self.F_0, "N")})
        stage = drawn(case, None if case.plays else motion, end, swing, frame.scale)
        return Picture(
            columns=columns_of(case, axes) | rest,
            axes=axes,
            signals=signals_of(case, motion, end, counted),
            traces=traces,
            scalars=Places.scalars(case, axes) | stage.scalars,
            pace=pace(self.omega, self.omega if case.plays else case.fastest),
            scale=stage.scale,
            fits=stage.fits,
            values=N.texts(case, counted) | goal_texts(case, counted, self.lightest) | by_name({N.tick: stage.tick}),
            live=Signals.live(counted),
            forms=Forms.forms(case) | Panels.forms(self),
            spans=self._spans(case),
        )

    @property
    def numbers(self) -> dict[str, SceneNumber]:
        return N.numbers(self._shown_case)

    def readouts(self) -> tuple[Readout, ...]:
        return N.readouts(self._shown_case)

    def about(self, shown: Picture) -> About:
        return absorber_about(shown, self._shown_case)
