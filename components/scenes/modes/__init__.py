"""Both masses agree on a shape at just two frequencies: the natural frequencies and modes (D34, points 2 to 4)."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import param

from components import chain
from components.about import About
from components.about_chain import guess_about, hunt_about, solve_about, sweep_about
from components.controls import Group
from components.parameters import angular_frequency, displacement, finite, mass, stiffness
from components.scene import Picture, Scene
from components.scenes.modes import guess, guess_picture, hunt, solve, sweep
from components.sheet import Block, choice, column, when
from physics.coupled import TwoMassChain
from physics.modes import trial
from physics.sweeps import PARAMETERS

VIEWS = {"guess": "Guess", "solve": "Solve", "sweep": "Sweep", "hunt": "Hunt"}
SOURCES = (
    "row1",
    "row2_below",
    "row2_above",
    "det",
    *(f"{kind}_{part}" for kind in ("omega", "ratio") for part in ("sweep", "low", "high", "now")),
    "path",
    "answer",
)


class Modes(Scene):
    slug = "modes"
    title = "Modes"
    lecture = "D34"
    headline = "Both masses agree on a shape at just two frequencies"
    groups = (
        Group(
            "Guess",
            ("omega", "ratio", "instant"),
            "or drag the point",
            show="guess",
            actions=(("row1", "As mass 1 wants"), ("row2", "As mass 2 wants")),
        ),
        Group("Start, from rest", ("x1_0", "x2_0"), "or drag the ring", show="hunt"),
        chain.CHAIN,
    )
    presets = {
        "Default": {},
        "Equal (slide 8)": {"m1": 1.0, "m2": 1.0, "k1": 1.0, "k2": 1.0},
        "Beats": {"m1": 1.0, "k1": 0.96, "m2": 0.04, "k2": 0.04},
        "No wall": {"k1": 0.0},
        "Loose": {"k2": 0.1},
    }

    task = param.Selector(default="guess", objects=list(VIEWS), label="View")
    m1 = mass(2.0, symbol="m_1", tint="m1", says="is the mass next to the wall. Type any value above 0.")
    m2 = mass(1.0, symbol="m_2", tint="m2", says="is the mass at the end. Type any value above 0.")
    k1 = stiffness(
        4.0, symbol="k_1", says="ties mass 1 to the wall. 0 lets the pair go free; type any value from 0 up."
    )
    k2 = stiffness(2.0, symbol="k_2", says="couples the masses. 0 lets mass 2 go free; type any value from 0 up.")
    omega = angular_frequency(
        1.7,
        softbounds=(0.0, 2.4),
        says="moves the point sideways, X₂/X₁ up and down. Find the points that leave your hand nothing to add.",
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
    instant = param.Selector(
        default="full", objects={"At full swing": "full", "Moving": "moving"}, label="The guess is drawn"
    )
    swept = param.Selector(default="k2", objects=list(PARAMETERS), label="Swept parameter")
    x1_0 = displacement(1.0, symbol="x_1", tint="m1", says="is where mass 1 starts, from rest. Type any value.")
    x2_0 = displacement(0.5, symbol="x_2", tint="m2", says="is where mass 2 starts, from rest. Type any value.")
    answer = param.Selector(default="hidden", objects=["hidden", "shown"], label="The answer of the hunt")

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return column(
            choice("task", VIEWS, "View", style="views", phone=-1),
            when("guess", guess.sheet()),
            when("solve", solve.sheet()),
            when("sweep", sweep.sheet()),
            when("hunt", hunt.sheet()),
        )

    def picture(self) -> Picture:
        system = TwoMassChain(m1=self.m1, m2=self.m2, k1=self.k1, k2=self.k2)
        picture = self._view(system)
        sizes = chain.sizes(self.m1, self.m2, 0.88)
        sizes |= {"wire1": chain.wire(self.k1), "wire2": chain.wire(self.k2)}
        return replace(
            picture,
            columns={name: {} for name in SOURCES} | picture.columns,
            scalars={**sizes, **picture.scalars},
            forms={self.task: "shown", **picture.forms},
        )

    def _view(self, system: TwoMassChain) -> Picture:
        if self.task == "solve":
            return solve.picture(system, self.window)
        if self.task == "sweep":
            return sweep.picture(system, self.swept)
        if self.task == "hunt":
            return hunt.picture(system, (self.x1_0, self.x2_0), self.answer == "shown", self.window)
        return guess_picture.picture(system, self.omega, self.ratio, self.instant == "moving", self.window)

    def action(self, name: str) -> dict[str, Any]:
        """The shape that one of the two equations fixes at the trial frequency."""
        system = TwoMassChain(m1=self.m1, m2=self.m2, k1=self.k1, k2=self.k2)
        wanted = trial(system, self.omega).rows[int(name[-1]) - 1]
        if wanted is None:
            raise ValueError(f"row {name[-1]} is 0 = 0 here: any shape will do")
        if not wanted.is_finite():
            raise ValueError(f"row {name[-1]} asks for X₁ = 0 here: no ratio X₂/X₁ says that")
        return {"ratio": float(wanted)}

    def about(self) -> About:
        system = TwoMassChain(m1=self.m1, m2=self.m2, k1=self.k1, k2=self.k2)
        if self.task == "hunt":
            return hunt_about(self.shown, system, (self.x1_0, self.x2_0))
        if self.task == "sweep":
            return sweep_about(self.shown, system, self.swept)
        return solve_about(system) if self.task == "solve" else guess_about(self.shown, system)
