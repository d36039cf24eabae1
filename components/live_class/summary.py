"""The summary of a class: each question that it answered, and how many were right."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence

from components.language.room import StepSummary, VoteSummary
from components.layout.text import rich
from components.live_class.question_bank import QuestionBank
from components.live_class.registry import Registry
from components.live_class.room import ClassRoom
from components.walks.questions.question import Judged

LONGEST = 200
"""Characters of an answer that can be said: a choice or a number, no sketch."""


async def summary(registry: Registry, room: ClassRoom) -> list[StepSummary]:
    """The questions that have a right answer, in the order of their first answers, each with all its votes."""
    bank = registry.bank_of(room)
    asked: dict[tuple[str, str], dict[int, list[Judged]]] = defaultdict(dict)
    for question in await registry.store.questions(room.code):
        walk, step, vote = question.split("/")
        if answers := await registry.given(room, question):
            asked[walk, step][int(vote)] = answers
    return [_summary(bank, walk, step, votes) for (walk, step), votes in asked.items() if bank.judges(walk, step)]


def _summary(bank: QuestionBank, walk: str, step: str, votes: dict[int, list[Judged]]) -> StepSummary:
    numbers = sorted(votes)
    told = (VoteSummary(vote=n, answered=len(votes[n]), right=sum(one.right for one in votes[n])) for n in numbers)
    mistake, mistaken = _mistake(bank, votes[numbers[-1]])
    return StepSummary(
        walk=walk,
        step=step,
        place=bank.place(walk, step),
        question=rich(bank.asked(walk, step)),
        votes=tuple(told),
        mistake=mistake,
        mistaken=mistaken,
    )


def _mistake(bank: QuestionBank, answers: Sequence[Judged]) -> tuple[str, int]:
    """The wrong answer that was given most often, and by how many."""
    wrong = Counter(" ".join(bank.written(one)).strip() for one in answers if not one.right)
    for text, count in wrong.most_common(1):
        if len(text) <= LONGEST:
            return text, count
    return "", 0
