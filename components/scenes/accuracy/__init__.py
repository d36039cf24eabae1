"""Accuracy: how far methods in steps drift, and what each digit costs, measured on the server."""

from __future__ import annotations

from functools import cache

import param

from components import chain
from components.language.blocks import Block
from components.language.state import Frame
from components.layout.controls import Group
from components.layout.views import View
from components.quantities.parameters import WordList, angular_frequency, count, force, one_of, positive
from components.quantities.readouts import SceneNumber
from components.scene import Picture, Scene
from components.scene.frames import FITTED, framed
from components.scenes.accuracy.axes import axes_of
from components.scenes.accuracy.case import AccuracyCase
from components.scenes.accuracy.data import MORE, Kept, work
from components.scenes.accuracy.drift import drift_columns
from components.scenes.accuracy.measurement import Measurement, known
from components.scenes.accuracy.plots import Places
from components.scenes.accuracy.sheet import paper
from components.scenes.accuracy.studies import Digits, studies
from components.scenes.accuracy.watch import WATCH
from components.scenes.accuracy.words import Facts, cell_texts
from components.scenes.accuracy.words import Forms as F
from components.scenes.accuracy.words import Numbers as N
from physics.integrators.accuracy import SYSTEMS, System

OWN = "own"


class Accuracy(Scene):
    slug = "accuracy"
    title = "Accuracy"
    lecture = "Numerics"
    points = "beyond the slides"
    headline = "A solver in steps gets slower with every digit; a formula does not"
    equations = chain.DRIVEN
    work = Measurement
    shares = chain.SHARES
    sharing = {"system": OWN}
    start = "System"
    watch = WATCH
    presets = {
        **{system.name: {"system": slug} for slug, system in SYSTEMS.items()},
        "From a link": {"system": OWN},
    }

    system = one_of("benign", [*SYSTEMS, OWN], "System")
    physical = (system,)
    steps = count(
        30.0, symbol="n", label="number of steps a period", softbounds=(8.0, 300.0), bounds=(4.0, 500.0),
        allowed="the number of steps a period is a whole number from 4 to 500",
        says="is the number of steps in one slow period. More of them are shorter.",
    )  # fmt: skip
    wanted = positive(
        1e-6, symbol="error", unit="", label="error", softbounds=(1e-15, 1.0), scale="log",
        says="is the accepted error. The list says what it costs.",
    )  # fmt: skip
    limit = positive(
        1.0, symbol="limit", unit="s", label="time limit of a run",
        softbounds=(0.2, 5.0), bounds=(0.01, 60.0), inclusive_bounds=(True, True),
        allowed="the time limit of a run is 0.01 to 60 s",
        says="is the time limit per run. Slower methods are listed with the reason why they stopped.",
    )  # fmt: skip
    cost = positive(
        0.1, symbol="cost", unit="s", label="run time", softbounds=(1e-3, 1.0), scale="log",
        says="is the run time that every method may spend where they are compared at equal cost.",
    )  # fmt: skip
    equal = one_of("error", {"error": "Equal error", "cost": "Equal cost"}, "Compared at")
    clock = one_of("python", {"python": "In Python", "compiled": "Compiled"}, "Time of the steps")
    unit = one_of("app", {"app": "As the app runs it", "doubles": "In doubles"}, "Closed form compared with")
    picked = WordList(default=["rec_verlet", "5"], doc="The run picked: source and place among its points.")
    hidden = WordList(default=[MORE], doc="The curves switched off, by group.")
    m1, m2, k1, k2 = chain.masses_and_springs(1.0, 1.0, 1.0, 1.0)
    x1_0, x2_0 = chain.start_positions(1.0)
    v1_0, v2_0 = chain.start_velocities()
    F_0 = force(0.0)
    omega = angular_frequency(1.0)
    measured = param.Parameter(default=None, doc="The measurement that the page has asked for, as far as it has come.")
    views = (
        View(
            "Drift", "Take fewer steps a period: which method leaves the exact motion first, and how?",
            keys=(steps,), names=("plot:drift", "keys"),
        ),
        View(
            "Run time", "Drag the line of the error down: which methods pay for more digits, and which do not?",
            keys=(wanted,), names=("plot:work",), word="time",
        ),
        View(
            "Growth", "Compare the methods at equal error, then at equal cost: whose error grows fastest?",
            keys=(equal, cost), names=("plot:error_growth", "keys"),
        ),
        View(
            "Length", "Follow each line to the right: what does a longer motion cost, in time and in error?",
            names=("plot:span_time",),
        ),
        View(
            "Digits", "Drag the accepted error down: how far do the 16 digits of a double reach?",
            keys=(wanted,), names=("plot:digits_ratio",),
        ),
        View(
            "Stability", "Follow a line until it leaves 1: how long may a step of that method be?",
            names=("plot:stability",),
        ),
    )  # fmt: skip
    old_view = "time"
    groups = (
        Group("Steps", (steps,), form=F.view["drift"]),
        Group("Run", (wanted, limit), form=F.races),
        Group("Time of the steps", (clock,), form=F.view["time"]),
        Group("× closed form", (unit,), form=F.in_units),
        Group("Compared at", (equal,), form=F.view["growth"]),
        Group("", (cost,), form=F.cost),
    )

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return paper()

    def shown_system(self) -> System:
        if self.system != OWN:
            return SYSTEMS[self.system]
        x_0, v_0 = chain.start_of(self)
        own = {"chain": chain.of_scene(self), "x_0": x_0, "v_0": v_0, "F_0": self.F_0, "omega": self.omega}
        return System(slug=OWN, name="Own", **own)

    def picture(self, frame: Frame = FITTED) -> Picture:
        case = self._case()
        axes = framed(frame, axes_of(case.longest, case.run, case.system.unit, case.size))
        kept = Kept.columns(case.run) if case.run and case.run.error_growth else {}
        return Picture(
            columns={**work(case.drawn), **kept, **drift_columns(case), **studies(case)},
            axes=axes,
            scalars=Places.scalars(case, axes),
            values={**N.texts(case, axes), **cell_texts(case), **Digits.texts(case, axes)},
            forms=F.forms(case),
        )

    @property
    def numbers(self) -> dict[str, SceneNumber]:
        return Facts.numbers(self._case())

    def _case(self) -> AccuracyCase:
        names = ("steps", "wanted", "limit", "cost", "equal", "clock", "unit", "view", "picked", "hidden")
        chosen = {name: getattr(self, name) for name in names}
        return AccuracyCase(system=self.shown_system(), known=known(self), **chosen)
