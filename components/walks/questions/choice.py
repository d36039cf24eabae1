"""The question with answers to choose from. One is right, each of the others has its own reply."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Annotated, Any

from msgspec import Meta

from components.language.class_messages import Counted
from components.language.messages import Given
from components.language.walk import Lesson, StepCard, Verdict
from components.layout.text import plain, rich
from components.walks.questions.question import Judged, Judgement, Question, Written, astray
from components.walks.subject import Subject
from components.walks.types import Reply, Sentence


class OptionEntry(Reply, frozen=True, kw_only=True):
    """An answer to choose: the right one, or one with its own reply."""

    text: Sentence
    right: bool = False


class ChoiceStep(Question, frozen=True, kw_only=True, tag="choice"):
    """A question with a few options, in an order that differs between classes and visitors unless it is `fixed`. In a
    `poll`, a
    question asked aloud, no answer is right.
    """

    takes = "option"
    usual_minutes = 2.0
    options: Annotated[tuple[OptionEntry, ...], Meta(min_length=2, max_length=5)]
    fixed: bool = False
    poll: bool = False

    @property
    def judges(self) -> bool:
        return not self.poll

    def links(self) -> Iterator[str]:
        yield from super().links()
        yield from (option.where for option in self.options if option.where)

    def sentences(self) -> Iterator[tuple[str, str]]:
        yield from super().sentences()
        for i, option in enumerate(self.options):
            yield f"options[{i}].text", option.text
            yield f"options[{i}].reply", option.reply

    def problems(self, subject: Subject) -> Iterator[str]:
        right = sum(option.right for option in self.options)
        if self.poll and right:
            yield "options: none is right in a poll."
        if not self.poll and right != 1:
            yield "options: exactly one must be right."
        for i, option in enumerate(self.options):
            if self.judges and not option.right and not option.reply:
                yield f"options[{i}].reply: a wrong answer needs a reply."
        yield from astray("options", self.options, subject)

    def card(self, subject: Subject, **step: Any) -> StepCard:
        options = tuple(rich(option.text) for option in self.options)
        return StepCard(options=options, fixed=self.fixed, poll=self.poll, **step)

    def judge(self, given: Given, subject: Subject) -> Judgement:
        option = given.option or 0
        if option >= len(self.options):
            raise ValueError(f"This question has {len(self.options)} answers.")
        return Judgement(self.options[option].right if self.judges else None)

    def teaches(self, given: Given, subject: Subject, **step: Any) -> Lesson:
        verdicts = (
            Verdict(right=one.right, reply=rich(one.reply), where=subject.elsewhere(one.where) if one.where else None)
            for one in self.options
        )
        return Lesson(verdicts=tuple(verdicts), **step)

    def count(self, given: Sequence[Judged]) -> Counted:
        counts = Counter(one.option for one in given)
        return Counted(answered=len(given), options=tuple(counts[i] for i in range(len(self.options))))

    def written(self, given: Judged, subject: Subject) -> Written:
        return Written(plain(self.options[given.option or 0].text))
