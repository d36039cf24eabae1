"""The base of all kinds of question, and the form in which a class stores an answer."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any, ClassVar, NamedTuple

from msgspec.structs import replace

from components.language.class_messages import Counted, Voted
from components.language.messages import Given
from components.language.walk import Lesson, StepCard
from components.layout.text import rich
from components.walks.links import page_state_at
from components.walks.subject import Subject
from components.walks.texts import line
from components.walks.types import BaseStep, Reply

UNFIT = "This answer does not fit the question."


class Judgement(NamedTuple):
    """The judgement of an answer: whether it is right (None if no answer can be), its number, its features, its reply,
    and the link to a case that the reply mentions."""

    right: bool | None
    number: float = 0.0
    has: tuple[bool, ...] = ()
    reply: str = ""
    where: str = ""


class Written(NamedTuple):
    """An answer in a table, and its unit."""

    answer: str
    unit: str = ""


class Judged(Voted, frozen=True, kw_only=True):
    """An answer as a class stores it, with its judgement, and a hash of the step by which it was judged."""

    number: float = 0.0
    right: bool = False
    has: tuple[bool, ...] = ()
    form: str = ""


class Question(BaseStep, frozen=True, kw_only=True):
    """A step with one kind of question: its fields in a walk's file, and its behaviour.

    `takes` is the field of an answer that it uses, `usual_minutes` the default number of minutes.
    """

    takes: ClassVar[str]
    usual_minutes: ClassVar[float]

    @property
    def kind(self) -> str:
        return str(self.__struct_config__.tag)

    @property
    def judges(self) -> bool:
        """True if answers can be right or wrong."""
        return True

    @property
    def planned(self) -> float:
        """Minutes that the step takes."""
        return self.minutes or self.usual_minutes

    @property
    def unit(self) -> str:
        """The unit of the requested number."""
        return ""

    def right(self, subject: Subject) -> tuple[float, ...]:
        """Return the right numbers in that unit; empty if the question has no number."""
        return ()

    def problems(self, subject: Subject) -> Iterator[str]:
        """Return sentences that say what is wrong with the question in its scene, the field first."""
        raise NotImplementedError

    def doubts(self, subject: Subject) -> Iterator[str]:
        """Return sentences on likely mistakes, with which the step still works. `make walk` prints them."""
        return iter(())

    def card(self, subject: Subject, **step: Any) -> StepCard:
        """Return the card of the question, without any sign of the right answer."""
        raise NotImplementedError

    def judged(self, given: Given, subject: Subject) -> Judgement | None:
        """Return the judgement of an answer, None if nothing was answered. Raises ValueError, with a reason, for an
        answer
        of another kind.
        """
        bare = Given(walk=given.walk, step=given.step, seed=given.seed, vote=given.vote, sure=given.sure)
        if replace(bare, **{self.takes: getattr(given, self.takes)}) != given:
            raise ValueError(UNFIT)
        return None if given == bare else self.judge(given, subject)

    def judge(self, given: Given, subject: Subject) -> Judgement:
        """Return the judgement of an answer that has only the field of this kind."""
        raise NotImplementedError

    def lesson(self, given: Given, subject: Subject) -> Lesson:
        """Return the lesson for an answer, or for none. Raises ValueError, with a reason, for an answer of another
        kind."""
        judged = self.judged(given, subject)
        return self.teaches(
            given,
            subject,
            title=rich(self.title),
            explain=rich(self.explain),
            follows=tuple(map(line, self.equations)),
            next=rich(self.next),
            right=judged and judged.right,
            reply=rich(judged.reply) if judged else "",
            where=subject.elsewhere(judged.where) if judged and judged.where else None,
        )

    def teaches(self, given: Given, subject: Subject, **step: Any) -> Lesson:
        """Return the lesson with the additions of this kind."""
        raise NotImplementedError

    def count(self, given: Sequence[Judged]) -> Counted:
        """Return the answers of a class together."""
        raise NotImplementedError

    def written(self, given: Judged, subject: Subject) -> Written:
        """Return an answer in the table of a class."""
        raise NotImplementedError


def astray(field: str, replies: Sequence[Reply], subject: Subject) -> Iterator[str]:
    """Return a sentence for each reply in a field of a walk's file whose link opens nothing."""
    for i, one in enumerate(replies):
        if one.where:
            yield from refused(f"{field}[{i}].where", partial(page_state_at, one.where, subject.scenes))


def refused(field: str, act: Callable[[], object]) -> Iterator[str]:
    """Call `act`; yield the message of a ValueError, after the name of the field in the walk's file."""
    try:
        act()
    except ValueError as reason:
        yield f"{field}: {reason}."
