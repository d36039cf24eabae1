"""Modes: the scene of the two frequencies at which both masses agree on a shape (D34, points 3 and 4)."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from components import chain
from components.chain.signals import Axes
from components.language.blocks import Block
from components.language.state import Frame
from components.layout.controls import Group
from components.layout.sheet import column, when
from components.layout.views import View, in_views
from components.quantities.axes import ONE
from components.quantities.declared import Declared, Family, Form
from components.quantities.parameters import Values, angular_frequency, finite, one_of
from components.quantities.readouts import Readout, SceneNumber
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED
from components.scenes.modes import guess, hunt, roots, solve, sweep
from components.scenes.modes.about import braked_about, guess_about, hunt_about, solve_about, sweep_about
from components.scenes.modes.determinant import Determinant
from components.scenes.modes.determinant import Numbers as DeterminantNumbers
from components.scenes.modes.guess_case import Guess, said
from components.scenes.modes.numbers import BrakedChain, BrakedNumbers, ComparedNumbers, RootReadouts, SolvedNumbers
from components.scenes.modes.watch import WATCH
from physics.coupled import TwoMassChain

VIEWS = ("hunt", "guess", "solve", "roots", "sweep")
USUAL = {"m1": 2.0, "m2": 1.0, "k1": 4.0, "k2": 2.0, "c1": 0.0, "c2": 0.0}


class Seen(Declared[str]):
    """The view of the scene. A picture has only the parts of the visible view."""

    view = Family(VIEWS, lambda one: Form[str](lambda view: view == one), "seen_{}")


LEFT_OUT = "Shown without the dashpots: they are in the view Roots."
ROW_OF = {"row1": 1, "row2": 2}
"""The equation, of mass 1 or of mass 2, from which the button computes the shape."""


class ModesScene(Scene):
    slug = "modes"
    title = "Modes"
    lecture = "D34"
    points = "points 3, 4"
    headline = "Undamped masses agree on a shape at two frequencies"
    spoken = {"slow mode": ComparedNumbers.omega_slow, "fast mode": ComparedNumbers.omega_fast}
    equations = (
        *chain.FREE,
        "row 1: X2/X1 = (k1 + k2 - m1 w^2)/k2; row 2: X2/X1 = k2/(k2 - m2 w^2)",
        "D = (k1 + k2 - m1 w^2) (k2 - m2 w^2) - k2^2",
    )
    shares = chain.BRAKED
    watch = WATCH
    presets = {
        "Unequal masses": USUAL,
        "All equal": {**USUAL, "m1": 1.0, "m2": 1.0, "k1": 1.0, "k2": 1.0},
        "Beats": {**USUAL, "m1": 1.0, "k1": 0.96, "m2": 0.04, "k2": 0.04},
        "No wall": {**USUAL, "k1": 0.0},
        "Loose": {**USUAL, "k2": 0.1},
    }
    steady = (Axes.x.name,)

    m1, m2, k1, k2 = chain.masses_and_springs(2.0, 1.0, 4.0, 2.0)
    c1, c2 = chain.dashpots()
    omega = angular_frequency(
        1.7,
        softbounds=(0.0, 2.4),
        says="moves the point sideways, X₂/X₁ up and down. Find the points where no extra force is needed.",
    )
    ratio = finite(
        -0.8,
        symbol="X₂/X₁",
        label="trial shape",
        unit="",
        softbounds=(-4.0, 4.0),
        tint="F",
        says="is the shape that you try: how far mass 2 swings for 1 of mass 1. Type any value.",
    )
    swept = sweep.SWEPT
    grows = roots.GROWS
    x1_0, x2_0 = chain.start_positions(1.0, 0.5, how=", from rest")
    answer = hunt.ANSWER
    groups = (
        Group(
            "Guess",
            (omega, ratio),
            form=Seen.view["guess"],
            actions=tuple((action, f"Use equation {row}") for action, row in ROW_OF.items()),
        ),
        Group("Start, from rest", (x1_0, x2_0), "or drag the ring", form=Seen.view["hunt"]),
        chain.chain_group(m1, m2, k1, k2),
        chain.dashpots_group(c1, c2, Seen.view["roots"]),
    )
    views = (
        View(
            "Hunt",
            "Drag the ring, where mass 1 and 2 start: when is the path straight? With both springs there are two.",
            keys=(x1_0, x2_0), names=("stage", "plot:plane"),
        ),
        View(
            "Guess", "Drag the point: where is no extra force of your hand needed?",
            keys=(omega, ratio), names=("stage:guess", "plot:shape"),
        ),
        View(
            "Solve", "Change the chain: can the two frequencies ever meet?",
            keys=(m2, k2), names=("stage:solve", "plot:det"),
        ),
        View(
            "Roots", "Drag a cross: where does the motion decay sooner, and when does it stop swinging?",
            keys=(c1,), names=("choice:grows", "plot:roots"),
        ),
        View(
            "Sweep", "Choose what to sweep: which frequency follows it, and where do the two come near?",
            keys=(k2,), names=("choice:swept", "plot:frequencies"),
        ),
    )  # fmt: skip
    old_view, old_views = "guess", {"task": {view: view for view in ("hunt", "guess", "solve", "sweep")}}

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return column(
            in_views(when(Seen.view["hunt"], hunt.sheet()), "hunt"),
            in_views(when(Seen.view["guess"], guess.sheet()), "guess"),
            in_views(solve.sheet(), "solve"),  # a step of a walk can show D under the plot of Guess
            in_views(when(Seen.view["roots"], roots.sheet()), "roots"),
            in_views(when(Seen.view["sweep"], sweep.sheet()), "sweep"),
        )

    def picture(self, frame: Frame = FITTED) -> Picture:
        system = chain.of_scene(self)
        picture = self._view(system, frame)
        return replace(
            picture,
            scalars={**chain.sizes(system, 0.88), **picture.scalars},
            forms=Seen.forms(self.view) | picture.forms,
            notes=(*picture.notes, *((LEFT_OUT,) if self._brakes and self.view != "roots" else ())),
        )

    @property
    def _brakes(self) -> bool:
        return any(chain.damping_of(self))

    def _view(self, system: TwoMassChain, frame: Frame) -> Picture:
        if self.view == "solve":
            return solve.picture(system, self.omega, self.window, frame)
        if self.view == "roots":
            return roots.picture(system, chain.damping_of(self), self.grows, self.window, frame)
        if self.view == "sweep":
            return sweep.picture(system, self.swept, frame)
        if self.view == "hunt":
            return hunt.picture(system, (self.x1_0, self.x2_0), self.answer == "shown", self.window, frame)
        return guess.picture(system, self.omega, self.ratio, self.window, frame)

    def action(self, name: str) -> Values:
        """The shape that one of the two equations fixes at the trial frequency."""
        row = ROW_OF[name]
        wanted = said(chain.of_scene(self), self.omega).rows[row - 1]
        if wanted is None:
            raise ValueError(f"equation {row} is 0 = 0 here: any shape satisfies it")
        if not wanted.is_finite():
            raise ValueError(f"equation {row} requires X₁ = 0 here: no ratio X₂/X₁ expresses that")
        return {"ratio": float(wanted)}

    @property
    def numbers(self) -> dict[str, SceneNumber]:
        system = chain.of_scene(self)
        return {
            **ComparedNumbers.numbers(system.modes()),
            **SolvedNumbers.numbers(system),
            **guess.Numbers.numbers(Guess(system, self.omega, ONE, self.ratio, ONE)),
            **DeterminantNumbers.numbers(Determinant(system, self.omega, ONE, ONE, 0)),
            **BrakedNumbers.numbers(BrakedChain(system, chain.damping_of(self))),
        }

    def readouts(self) -> tuple[Readout, ...]:
        if self._brakes and self.view == "roots":
            return RootReadouts.readouts(BrakedChain(chain.of_scene(self), chain.damping_of(self)))
        return ComparedNumbers.readouts(chain.of_scene(self).modes())

    def about(self, shown: Picture) -> About:
        system = chain.of_scene(self)
        if self.view == "hunt":
            return hunt_about(shown, system, (self.x1_0, self.x2_0))
        if self.view == "sweep":
            return sweep_about(shown, system, self.swept)
        if self._brakes and self.view == "roots":
            return braked_about(system, chain.damping_of(self))
        return solve_about(system) if self.view in ("solve", "roots") else guess_about(shown, system)
