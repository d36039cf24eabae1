"""The question for a typed number, which is right within a tolerance. Frequent wrong numbers have their own replies."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from typing import Any, TypeAlias

from msgspec import field

from components.language.class_messages import Counted
from components.language.messages import Given
from components.language.walk import Lesson, StepCard
from components.quantities.formatting import shortest, three
from components.quantities.typed import typed_number, unit_size
from components.walks.expressions import worked_out
from components.walks.questions.question import Judged, Judgement, Question, Written, astray, refused
from components.walks.subject import Subject
from components.walks.types import Entry, Reply, Sentence

Numeral: TypeAlias = float | str
"""A number in a walk's file; a text is parsed like a typed one."""


class AnswerEntry(Entry, frozen=True, kw_only=True):
    """The right number, or several, with their tolerance. `of` names a quantity of the scene, or is an expression of
    such quantities; `is` is a number that no quantity gives.
    """

    of: str | tuple[str, ...] = ()
    given: Numeral | tuple[Numeral, ...] = field(name="is", default=())
    tol: Numeral
    unit: str = ""

    def __post_init__(self) -> None:
        if not (self.quantities or self.numbers):
            raise ValueError("it has neither of nor is")
        if not self.tolerance > 0:
            raise ValueError("tol is a number above 0")

    @property
    def quantities(self) -> tuple[str, ...]:
        return (self.of,) if isinstance(self.of, str) else self.of

    @property
    def numbers(self) -> tuple[float, ...]:
        given = self.given if isinstance(self.given, tuple) else (self.given,)
        return tuple(map(self._read, given))

    @property
    def tolerance(self) -> float:
        return self._read(self.tol)

    def _read(self, given: Numeral) -> float:
        return typed_number(given, self.unit) if isinstance(given, str) else given


class Miss(Reply, frozen=True, kw_only=True):
    """A frequent wrong number, or an expression of the scene's numbers, with its own reply."""

    given: Numeral = field(name="is")
    idea: Sentence
    reply: Sentence


class NumericStep(Question, frozen=True, kw_only=True):
    """A number: typed, or a position on an axis."""

    answer: AnswerEntry
    misses: tuple[Miss, ...] = ()

    def links(self) -> Iterator[str]:
        yield from super().links()
        yield from (miss.where for miss in self.misses if miss.where)

    def number(self, given: Given, subject: Subject) -> float:
        """Return the number of an answer. Raises ValueError, with a reason, if it has none."""
        raise NotImplementedError

    @property
    def unit(self) -> str:
        return self.answer.unit

    def right(self, subject: Subject) -> tuple[float, ...]:
        told = tuple(self._of_scene(one, subject) for one in self.answer.quantities)
        return told or self.answer.numbers

    def wrong(self, subject: Subject) -> tuple[float, ...]:
        """Return the frequent wrong numbers."""
        given = (miss.given for miss in self.misses)
        return tuple(self._of_scene(one, subject) if isinstance(one, str) else one for one in given)

    def _of_scene(self, expression: str, subject: Subject) -> float:
        """Return the value of an expression, from the scene's numbers with the answer, in the unit of the answer."""
        return worked_out(expression, subject.numbers) / unit_size(self.answer.unit)

    def truth(self, subject: Subject) -> str:
        unit = self.answer.unit
        gap = " " if unit and unit != "°" else ""
        return " or ".join(f"{three(one)}{gap}{unit}" for one in self.right(subject))

    def is_near(self, number: float, others: Iterable[float]) -> bool:
        return any(abs(number - one) <= self.answer.tolerance for one in others)

    def sentences(self) -> Iterator[tuple[str, str]]:
        yield from super().sentences()
        for i, miss in enumerate(self.misses):
            yield f"misses[{i}].reply", miss.reply

    def problems(self, subject: Subject) -> Iterator[str]:
        yield from astray("misses", self.misses, subject)
        found = [*refused("answer.of", partial(self.right, subject)), *refused("misses", partial(self.wrong, subject))]
        yield from found
        if found:
            return
        right = self.right(subject)
        for number in self.answer.numbers:
            if not self.is_near(number, right):
                yield f"answer.is: {number:g} is not what the scene has, {self.truth(subject)}."
        for i, number in enumerate(self.wrong(subject)):
            if self.is_near(number, right):
                yield f"misses[{i}].is: {number:g} is within the tolerance of the right answer."

    def doubts(self, subject: Subject) -> Iterator[str]:
        """Warn of a number that no quantity gives, and of two wrong numbers that are equal, of which only the first is
        used."""
        size = unit_size(self.answer.unit)
        known = [number / size for number in subject.numbers.values()]
        for number in () if self.answer.quantities else self.answer.numbers:
            if not self.is_near(number, known):
                yield f"answer: {number:g} is no number of this scene: name the quantity that it is, of = ..."
        wrong = self.wrong(subject)
        for i, number in enumerate(wrong):
            if self.is_near(number, wrong[:i]):
                yield f"misses[{i}].is: {number:g} is within the tolerance of a miss before it."

    def judge(self, given: Given, subject: Subject) -> Judgement:
        number = self.number(given, subject)
        if self.is_near(number, self.right(subject)):
            return Judgement(True, number)
        wrong = zip(self.misses, self.wrong(subject), strict=True)
        hit = (miss for miss, one in wrong if self.is_near(number, (one,)))
        miss = next(hit, Reply())
        return Judgement(False, number, reply=miss.reply, where=miss.where)


class NumberStep(NumericStep, frozen=True, kw_only=True, tag="number"):
    """A question whose answer is a number that the student types."""

    takes = "text"
    usual_minutes = 3.0

    def number(self, given: Given, subject: Subject) -> float:
        return typed_number(given.text, self.answer.unit)

    def card(self, subject: Subject, **step: Any) -> StepCard:
        return StepCard(unit=self.answer.unit, **step)

    def teaches(self, given: Given, subject: Subject, **step: Any) -> Lesson:
        return Lesson(truth=self.truth(subject), places=self.right(subject), **step)

    def count(self, given: Sequence[Judged]) -> Counted:
        return Counted(answered=len(given), numbers=tuple(one.number for one in given))

    def written(self, given: Judged, subject: Subject) -> Written:
        return Written(shortest(given.number), self.answer.unit)
