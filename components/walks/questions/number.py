"""A number to type, right within a tolerance; wrong ones that are often given have their own sentences."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Annotated, Any

from msgspec import Meta, field

from components.language.messages import Given
from components.language.room import Counted
from components.language.walk import Lesson, StepCard
from components.quantities.numbers import shortest, three
from components.quantities.typed import typed_number
from components.walks.questions.question import Judged, Judgement, Question
from components.walks.subject import Subject
from components.walks.types import Above0, Entry, Sentence


class AnswerEntry(Entry, frozen=True, kw_only=True):
    """A number, or several of which each is right, and how far off still counts."""

    value: Annotated[tuple[float, ...], Meta(min_length=1)] = field(name="is")
    tol: Above0
    unit: str = ""

    def near(self, number: float) -> bool:
        return any(abs(number - one) <= self.tol for one in self.value)

    @property
    def truth(self) -> str:
        gap = " " if self.unit and self.unit != "°" else ""
        return " or ".join(f"{three(one)}{gap}{self.unit}" for one in self.value)


class Miss(Entry, frozen=True, kw_only=True):
    """A wrong number that is often given, with the sentence that is its own."""

    value: float = field(name="is")
    idea: Sentence
    reply: Sentence


class NumericStep(Question, frozen=True, kw_only=True):
    """A number: typed, or a place on an axis."""

    answer: AnswerEntry
    misses: tuple[Miss, ...] = ()

    def number(self, given: Given, subject: Subject) -> float:
        """The number that an answer is; ValueError, in words, for what is none."""
        raise NotImplementedError

    def sentences(self) -> Iterator[tuple[str, str]]:
        yield from super().sentences()
        for i, miss in enumerate(self.misses):
            yield f"misses[{i}].reply", miss.reply

    def problems(self, subject: Subject) -> Iterator[str]:
        for i, miss in enumerate(self.misses):
            if self.answer.near(miss.value):
                yield f"misses[{i}].is: {miss.value:g} is within the tolerance of the right answer."

    def judge(self, given: Given, subject: Subject) -> Judgement:
        number = self.number(given, subject)
        if self.answer.near(number):
            return Judgement(True, number)
        hit = (miss.reply for miss in self.misses if abs(number - miss.value) <= self.answer.tol)
        return Judgement(False, number, reply=next(hit, ""))


class NumberStep(NumericStep, frozen=True, kw_only=True, tag="number"):
    """A number to type."""

    takes = "text"
    usual = 3.0

    def number(self, given: Given, subject: Subject) -> float:
        return typed_number(given.text, self.answer.unit)

    def card(self, subject: Subject, **step: Any) -> StepCard:
        return StepCard(unit=self.answer.unit, **step)

    def teaches(self, given: Given, subject: Subject, **step: Any) -> Lesson:
        return Lesson(truth=self.answer.truth, places=self.answer.value, **step)

    def count(self, given: Sequence[Judged]) -> Counted:
        return Counted(answered=len(given), numbers=tuple(one.number for one in given))

    def written(self, given: Judged) -> str:
        return shortest(given.number)
