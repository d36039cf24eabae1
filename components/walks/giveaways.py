"""Numbers that give the answer of a question away.

A live number in a formula, a heading, a table or a label gives an answer away if it is the answer, or if the answer
follows from it in one step, as a period follows from an angular frequency.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator
from typing import NamedTuple

from components.quantities.formatting import parse_number
from components.quantities.typed import unit_size
from components.walks.cards import asked
from components.walks.leaks import chain_of, texts_in_sight
from components.walks.links import Scenes, page_state_at
from components.walks.subject import Subject
from components.walks.walk import Step, Walk

SAME = 0.006
"""The relative difference below which two numbers with three digits count as equal."""
OVER = frozenset({"s", "ms", "min", "h", "rad/s", "Hz", "1/s"})
"""Units of answers that may be the reciprocal of a number, or 2π divided by it."""
_NUMBER = re.compile(r"[-−+]?\d+(?:\.\d+)?(?:·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?")


class Relation(NamedTuple):
    """A step from a number to an answer: its name, and the units of answers for which it makes sense (none: all)."""

    name: str
    follow: Callable[[float], float]
    units: frozenset[str] = frozenset()


RELATIONS = (
    Relation("it is the answer", lambda value: value),
    Relation("2π over it is the answer", lambda value: 2 * math.pi / value, OVER),
    Relation("1 over it is the answer", lambda value: 1 / value, OVER),
)


def giveaways(walk: Walk, scenes: Scenes) -> Iterator[str]:
    """Return a sentence for each live number that gives an answer away, in its own question or in an earlier step of
    the same scene and system. Numbers that the question states, and parameters of the scene, do not count.
    """
    for i, step in enumerate(walk.steps, 1):
        subject = Subject(walk.name, step, scenes)
        for where, texts in _in_sight(walk, i, subject, scenes) if step.right(subject) else ():
            yield from (
                f"{walk.name}, step {i} ({step.id}), cover: “{name}” is visible{where}, {text}: {how}."
                for name, text, how in _telling(step, texts, subject)
            )


def _in_sight(walk: Walk, number: int, subject: Subject, scenes: Scenes) -> Iterator[tuple[str, dict[str, str]]]:
    """Return the live numbers of a step's question, and of earlier pictures of the same system, each with its place."""
    *before, step = walk.steps[:number]
    yield "", texts_in_sight(subject.page_state, step.cover, step.show)
    chain = chain_of(subject.answered.scene)
    for early in before:
        for when, link, covers in (("before", early.state, early.cover), ("after", early.shown, early.still)):
            page = page_state_at(link, scenes)
            if chain_of(page.scene) == chain:
                yield f" {when} the answer of {early.id}", texts_in_sight(page, covers, early.show)


def _telling(step: Step, texts: dict[str, str], subject: Subject) -> Iterator[tuple[str, str, str]]:
    """Return the live numbers that reveal the answer of a step, with their texts and the relation."""
    right, unit = step.right(subject), step.unit
    given = [*_numbers(asked(step, subject)), *_set_to(subject, unit)]
    for name, text in texts.items():
        for value in _numbers(text):
            if not value or _is_one_of(value, given):
                continue
            for relation in RELATIONS:
                if (not relation.units or unit in relation.units) and _is_one_of(relation.follow(value), right):
                    yield name, text, relation.name


def _numbers(text: str) -> list[float]:
    return [parse_number(found) for found in _NUMBER.findall(text)]


def _set_to(subject: Subject, unit: str) -> Iterator[float]:
    """Return the quantities that the scene is set to, in SI and in the unit of the answer."""
    for value in subject.page_state.scene.values.values():
        if isinstance(value, float):
            yield from (value, value / unit_size(unit))


def _is_one_of(value: float, others: Iterable[float]) -> bool:
    return any(abs(value - one) <= SAME * abs(one) for one in others if one)
