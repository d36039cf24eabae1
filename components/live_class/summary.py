"""The summary of a class: each question with the number of right answers."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from functools import partial
from typing import TypeAlias

from components.language.class_messages import StepSummary, Stored, VoteSummary
from components.layout.text import rich
from components.live_class.question_bank import QuestionBank
from components.live_class.registry import Registry
from components.live_class.room import ClassRoom

LONGEST = 200
"""Maximum length of an answer in the summary."""
JudgedAnswer: TypeAlias = tuple[bool, str]


async def summary(registry: Registry, room: ClassRoom) -> list[StepSummary]:
    """The questions that have a right answer, in the order of their first answers, each with all its votes."""
    bank = registry.bank_of(room)
    asked: dict[tuple[str, str], list[int]] = defaultdict(list)
    for question in await registry.store.questions(room.code):
        walk, step, vote = question.split("/")
        asked[walk, step].append(int(vote))
    judged = [await _summary(registry, room, *one, sorted(votes)) for one, votes in asked.items() if bank.judges(*one)]
    return [one for one in judged if one]


async def stored(registry: Registry, room: ClassRoom) -> Stored:
    """Count the data that will be deleted when the class ends, including votes on questions asked aloud."""
    names = await registry.store.questions(room.code)
    counts = {name: len(await registry.store.votes(room.code, name)) for name in names}
    questions = {name.rpartition("/")[0] for name, count in counts.items() if count}
    return Stored(answers=sum(counts.values()), questions=len(questions))


async def _summary(
    registry: Registry, room: ClassRoom, walk: str, step: str, numbers: Sequence[int]
) -> StepSummary | None:
    """Return the summary of a question, or None if it has no answers left."""
    bank, votes, last = registry.bank_of(room), list[VoteSummary](), list[JudgedAnswer]()
    for number in numbers:
        kept = await registry.votes(room, f"{walk}/{step}/{number}")
        if judged := [one for one in await registry.slices.map(partial(_judged, bank), kept.values()) if one]:
            votes.append(VoteSummary(vote=number, answered=len(judged), right=sum(is_right for is_right, _ in judged)))
            last = judged
    if not votes:
        return None
    mistake, mistaken = _mistake(last)
    return StepSummary(
        walk=walk,
        step=step,
        place=bank.place(walk, step),
        question=rich(bank.asked(walk, step)),
        votes=tuple(votes),
        mistake=mistake,
        mistaken=mistaken,
    )


def _judged(bank: QuestionBank, kept: bytes) -> JudgedAnswer | None:
    """Return whether an answer is right, and the text of a wrong one. Sketches have no text, because it takes long to
    compute.
    """
    one = bank.read(kept)
    if one is None:
        return None
    return one.right, "" if one.right or one.curves else " ".join(bank.written(one)).strip()


def _mistake(judged: Sequence[JudgedAnswer]) -> tuple[str, int]:
    """Return the most frequent wrong answer, and its count."""
    for text, count in Counter(text for _, text in judged if text).most_common(1):
        if len(text) <= LONGEST:
            return text, count
    return "", 0
