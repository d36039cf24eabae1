"""A walk, and the kinds of question that its steps may ask."""

from __future__ import annotations

from typing import TypeAlias

from msgspec import Struct

from components.language.walk import WalkTrial
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.number import NumberStep
from components.walks.questions.point import PointStep
from components.walks.questions.sketch import SketchStep
from components.walks.questions.words import WordsStep
from components.walks.types import Sentence

Step: TypeAlias = ChoiceStep | NumberStep | PointStep | SketchStep | WordsStep


class Walk(Struct, frozen=True, kw_only=True):
    """A walk: its steps in order, its name in links, the sentences of its summary, and scenes to try afterwards."""

    name: str
    title: str
    steps: tuple[Step, ...]
    end: tuple[Sentence, ...] = ()
    trials: tuple[WalkTrial, ...] = ()

    def place(self, asked: str) -> int | None:
        """Return the index of a step, given by its id or by its number from 1 on."""
        ids = [step.id for step in self.steps]
        if asked in ids:
            return ids.index(asked)
        return int(asked) - 1 if asked.isdecimal() and 1 <= int(asked[:6]) <= len(ids) else None
