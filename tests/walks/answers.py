"""Answers of a class to any question, some right, some wrong."""

from typing import Any

from components.language.messages import Sketched
from components.scenes import SCENES
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.number import NumberStep
from components.walks.questions.point import PointStep
from components.walks.questions.sketch import SketchStep
from components.walks.questions.words import WordsStep
from components.walks.subject import Subject, place_of
from components.walks.walk import Step
from tests.walks.test_walking import heights


def answers(step: Step, count: int) -> list[dict[str, Any]]:
    """Return so many answers as they are sent, without walk and step; every second one is right."""
    kinds = _kinds(step)
    return [kinds[0] if i % 2 else kinds[i // 2 % len(kinds)] for i in range(count)]


def _kinds(step: Step) -> list[dict[str, Any]]:
    """The right answer, then wrong ones."""
    subject = Subject("", step, SCENES)
    if isinstance(step, ChoiceStep):
        options = sorted(range(len(step.options)), key=lambda i: not step.options[i].right)
        return [{"option": i} for i in options]
    if isinstance(step, SketchStep):
        true = heights(step)
        return [{"curves": {name: _lowered(curve, by) for name, curve in true.items()}} for by in (0, 120, 300)]
    if isinstance(step, WordsStep):
        return [{"text": text} for text in ("It swings", "it swings.", "No idea")]
    numbers = (*step.right(subject), *step.wrong(subject))
    if isinstance(step, PointStep):
        axis = step.on(subject)
        return [{"value": place_of(axis, number)} for number in numbers]
    assert isinstance(step, NumberStep)
    return [{"text": f"{number:.4g}"} for number in numbers]


def _lowered(curve: Sketched, by: int) -> Sketched:
    return [None if height is None else max(height - by, -100) for height in curve]
