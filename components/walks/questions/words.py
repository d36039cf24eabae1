"""The question for a few words. No answer is right or wrong, and the instructor chooses which ones the hall sees."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator, Sequence
from typing import Any

from components.language.class_messages import Counted, WordGroup
from components.language.messages import Given
from components.language.walk import Lesson, StepCard
from components.walks.questions.question import Judged, Judgement, Question, Written
from components.walks.subject import Subject

MOST_GROUPS = 200
"""Maximum number of groups of equal answers that are sent; they are the newest."""
JOINER = "\u200d"
"""The character that joins the parts of one emoji."""


class WordsStep(Question, frozen=True, kw_only=True, tag="words"):
    """The question for a few words to type, at most 80 characters."""

    takes = "text"
    usual_minutes = 3.0

    @property
    def judges(self) -> bool:
        return False

    def problems(self, subject: Subject) -> Iterator[str]:
        return iter(())

    def card(self, subject: Subject, **step: Any) -> StepCard:
        return StepCard(**step)

    def judge(self, given: Given, subject: Subject) -> Judgement:
        if not tidied(given.text):
            raise ValueError("Type an answer in words: it has no letter or sign that can be seen.")
        return Judgement(None)

    def teaches(self, given: Given, subject: Subject, **step: Any) -> Lesson:
        return Lesson(**step)

    def count(self, given: Sequence[Judged]) -> Counted:
        groups = dict[str, list[Judged]]()
        for one in given:
            groups.setdefault(normalized(one.text), []).append(one)
        newest = sorted(groups.values(), key=lambda group: max(one.at for one in group), reverse=True)
        words = (
            WordGroup(text=tidied(max(group, key=lambda one: one.at).text), count=len(group))
            for group in newest[:MOST_GROUPS]
        )
        return Counted(answered=len(given), words=tuple(words))

    def written(self, given: Judged, subject: Subject) -> Written:
        return Written(tidied(given.text))


def tidied(text: str) -> str:
    """Return a text in one line, without invisible characters and marks that change the direction of text."""
    seen = (sign if sign == JOINER or unicodedata.category(sign)[0] != "C" else " " for sign in text)
    return " ".join("".join(seen).split()).strip(JOINER)


def normalized(text: str) -> str:
    """Return the common form of equal answers: without case, accents of form, and marks at the end of a sentence."""
    return unicodedata.normalize("NFKC", tidied(text)).casefold().strip(" .,;:!?\"'“”‘’")
