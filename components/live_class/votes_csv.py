"""The answers of a lecture as a table that does not identify anybody."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Mapping
from datetime import UTC, datetime
from hashlib import sha256

from components.live_class.question_bank import SURE, QuestionBank
from components.live_class.registry import Registry
from components.live_class.room import ClassRoom

FORMULAS = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")
"""First characters of a cell that a spreadsheet may evaluate, in any language, now or after the file is saved again."""
NUMBER = re.compile(r"-?\d+(\.\d+)?(e[+-]?\d+)?")
HEAD = ("phone", "time", "here", "walk", "step", "vote", "question", "answer", "unit", "right", "sure")


async def votes_csv(registry: Registry, room: ClassRoom) -> list[str]:
    """Return the table in pieces, with a line for each answer: an anonymous number for the phone; the time in UTC; the
    number of followers; sketches as points in SI."""
    questions = await registry.store.questions(room.code)
    votes = {question: await registry.votes(room, question) for question in questions}
    phones = await numbered(registry, {name for answers in votes.values() for name in answers}, room.code)
    pieces = [line(HEAD)]
    for question, answers in votes.items():
        rows = VoteRows(registry.bank_of(room), question, phones)
        pieces += await registry.slices.map(rows.row, sorted(answers.items(), key=lambda answer: phones[answer[0]]))
    return pieces


class VoteRows:
    """Return the rows of the answers to one vote."""

    def __init__(self, bank: QuestionBank, question: str, phones: Mapping[str, int]) -> None:
        self._bank, self._phones = bank, phones
        self._question = question.split("/")
        self._asked: tuple[str, tuple[str, str]] | None = None

    def row(self, answer: tuple[str, bytes]) -> str:
        """Return the row of an answer and its name, or "" if its question has changed since."""
        name, kept = answer
        one = self._bank.read(kept)
        if one is None:
            return ""
        walk, step, vote = self._question
        asked, words = self._asked = self._asked or self._of(walk, step)
        given = time_of(one.at), str(one.here or "")
        cells = (*given, walk, step, vote, asked, *self._bank.written(one), words[one.right], SURE.get(one.sure, ""))
        return line((self._phones[name], *map(cell, cells)))

    def _of(self, walk: str, step: str) -> tuple[str, tuple[str, str]]:
        """Return the question as text, and the words for wrong and right."""
        return self._bank.asked(walk, step), ("no", "yes") if self._bank.judges(walk, step) else ("", "")


async def numbered(registry: Registry, names: Iterable[str], code: str) -> dict[str, int]:
    """Return a number for each name, in an order that does not reveal the times in the tokens."""
    hashed = await registry.slices.map(lambda name: (sha256(f"{code} {name}".encode()).digest(), name), names)
    return {name: number for number, (_, name) in enumerate(sorted(hashed), start=1)}


def line(cells: Iterable[object]) -> str:
    text = io.StringIO(newline="")
    csv.writer(text).writerow(cells)
    return text.getvalue()


def time_of(at: float) -> str:
    return datetime.fromtimestamp(at, UTC).strftime("%Y-%m-%dT%H:%M:%SZ") if at else ""


def cell(text: str) -> str:
    """Return a text that no spreadsheet interprets as a formula. Negative numbers are unchanged."""
    return f"'{text}" if text.startswith(FORMULAS) and not NUMBER.fullmatch(text) else text
