"""The summary of a class: each question that it answered, and how many were right."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence

from components.language.room import StepSummary, VoteSummary
from components.layout.text import rich
from components.live_class.registry import Registry
from components.live_class.room import ClassRoom
from components.walks.questions.question import Judged

LONGEST = 200
"""Characters of an answer that can be said."""


async def summary(registry: Registry, room: ClassRoom) -> list[StepSummary]:
    """The questions that have a right answer, in the order of their first answers, each with all its votes."""
    bank = registry.bank_of(room)
    asked: dict[tuple[str, str], list[int]] = defaultdict(list)
    for question in await registry.store.questions(room.code):
        walk, step, vote = question.split("/")
        asked[walk, step].append(int(vote))
    told = [await _summary(registry, room, *one, sorted(votes)) for one, votes in asked.items() if bank.judges(*one)]
    return [one for one in told if one]


async def _summary(
    registry: Registry, room: ClassRoom, walk: str, step: str, numbers: Sequence[int]
) -> StepSummary | None:
    """The summary of a question; None where no answer to it is left."""
    bank, votes, last = registry.bank_of(room), list[VoteSummary](), list[Judged]()
    for number in numbers:
        if answers := await registry.given(room, f"{walk}/{step}/{number}"):
            votes.append(VoteSummary(vote=number, answered=len(answers), right=sum(one.right for one in answers)))
            last = answers
    if not votes:
        return None
    mistake, mistaken = await _mistake(registry, room, last)
    return StepSummary(
        walk=walk,
        step=step,
        place=bank.place(walk, step),
        question=rich(bank.asked(walk, step)),
        votes=tuple(votes),
        mistake=mistake,
        mistaken=mistaken,
    )


async def _mistake(registry: Registry, room: ClassRoom, answers: Sequence[Judged]) -> tuple[str, int]:
    """The wrong answer that was given most often, and by how many; no sketch is written, which takes long."""
    bank = registry.bank_of(room)
    wrong = [one for one in answers if not one.right and not one.curves]
    texts = await registry.slices.map(lambda one: " ".join(bank.written(one)).strip(), wrong)
    for text, count in Counter(texts).most_common(1):
        if len(text) <= LONGEST:
            return text, count
    return "", 0
