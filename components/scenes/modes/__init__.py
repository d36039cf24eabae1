"""Modes: the scene of the two frequencies at which both masses agree on a shape (D34, points 3 and 4)."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from components import chain
from components.chain.signals import Axes
from components.language.blocks import Block
from components.language.state import Frame
from components.layout.controls import Group
from components.layout.sheet import Paragraph, choice, column, desk, when, words
from components.quantities.declared import Declared, Family, Form
from components.quantities.parameters import Values, angular_frequency, finite, one_of
from components.quantities.readouts import Readout
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED
from components.scenes.modes import guess, hunt, solve, sweep
from components.scenes.modes.about import braked_about, guess_about, hunt_about, solve_about, sweep_about
from components.scenes.modes.guess_case import said
from components.scenes.modes.numbers import BrakedChain, ComparedNumbers, RootReadouts
from components.scenes.modes.watch import WATCH
from physics.coupled import TwoMassChain

TASKS: dict[str, Paragraph] = {
    "guess": "Drag the point: where is no extra force needed?",
    "solve": solve.TASK,
    "sweep": "Sweep one value: which frequency follows it, and where do the two come near?",
    "hunt": "Drag the start: from where is the path a straight line?",
}
VIEWS = {"hunt": "Hunt", "guess": "Guess", "solve": "Solve", "sweep": "Sweep"}
TASK = one_of("guess", VIEWS, "View")

USUAL = {"m1": 2.0, "m2": 1.0, "k1": 4.0, "k2": 2.0, "c1": 0.0, "c2": 0.0}


class Tasks(Declared[str]):
    """The view that stands."""

    view = Family(VIEWS, lambda one: Form[str](lambda task: task == one), "{}")


LEFT_OUT = "Shown without the dashpots: they are part of Solve."
ROW_OF = {"row1": 1, "row2": 2}
"""The equation, that of mass 1 or of mass 2, which an action takes the shape from."""


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
        "Default": USUAL,
        "All equal": {**USUAL, "m1": 1.0, "m2": 1.0, "k1": 1.0, "k2": 1.0},
        "Beats": {**USUAL, "m1": 1.0, "k1": 0.96, "m2": 0.04, "k2": 0.04},
        "No wall": {**USUAL, "k1": 0.0},
        "Loose": {**USUAL, "k2": 0.1},
    }
    opens = {"task": "hunt"}
    steady = (Axes.x.name,)

    task = TASK
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
    x1_0, x2_0 = chain.start_positions(1.0, 0.5, how=", from rest")
    answer = hunt.ANSWER
    groups = (
        Group(
            "Guess",
            (omega, ratio),
            form=Tasks.view["guess"],
            actions=tuple((action, f"Use equation {row}") for action, row in ROW_OF.items()),
        ),
        Group("Start, from rest", (x1_0, x2_0), "or drag the ring", form=Tasks.view["hunt"]),
        chain.chain_group(m1, m2, k1, k2),
        chain.dashpots_group(c1, c2, Tasks.view["solve"]),
    )

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return column(
            choice(TASK, style="views", phone=-1),
            *(desk(when(Tasks.view[view], words(task, style="task", phone=0))) for view, task in TASKS.items()),
            when(Tasks.view["guess"], guess.sheet()),
            when(Tasks.view["solve"], solve.sheet()),
            when(Tasks.view["sweep"], sweep.sheet()),
            when(Tasks.view["hunt"], hunt.sheet()),
        )

    def picture(self, frame: Frame = FITTED) -> Picture:
        system = chain.of_scene(self)
        picture = self._view(system, frame)
        return replace(
            picture,
            scalars={**chain.sizes(system, 0.88), **picture.scalars},
            forms=Tasks.forms(self.task) | picture.forms,
            notes=(*picture.notes, *((LEFT_OUT,) if self._brakes and self.task != "solve" else ())),
        )

    @property
    def _brakes(self) -> bool:
        return any(chain.damping_of(self))

    def _view(self, system: TwoMassChain, frame: Frame) -> Picture:
        if self.task == "solve":
            return solve.picture(system, chain.damping_of(self), self.window, frame)
        if self.task == "sweep":
            return sweep.picture(system, self.swept, frame)
        if self.task == "hunt":
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

    def readouts(self) -> tuple[Readout, ...]:
        if self._brakes and self.task == "solve":
            return RootReadouts.readouts(BrakedChain(chain.of_scene(self), chain.damping_of(self)))
        return ComparedNumbers.readouts(chain.of_scene(self).modes())

    def about(self, shown: Picture) -> About:
        system = chain.of_scene(self)
        if self.task == "hunt":
            return hunt_about(shown, system, (self.x1_0, self.x2_0))
        if self.task == "sweep":
            return sweep_about(shown, system, self.swept)
        if self._brakes and self.task == "solve":
            return braked_about(system, chain.damping_of(self))
        return solve_about(system) if self.task == "solve" else guess_about(shown, system)
