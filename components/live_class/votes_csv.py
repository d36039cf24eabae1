"""The answers of a lecture as a table, without a word of who gave them."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable
from datetime import UTC, datetime
from hashlib import sha256

from components.live_class.pauses import by_and_by
from components.live_class.registry import Registry
from components.live_class.room import ClassRoom

FORMULAS = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")
"""Beginnings of a cell that a spreadsheet works out, or does in some language or when the file is saved again."""
NUMBER = re.compile(r"-?\d+(\.\d+)?(e[+-]?\d+)?")
HEAD = ("phone", "time", "here", "walk", "step", "vote", "question", "answer", "unit", "right")


async def votes_csv(registry: Registry, room: ClassRoom) -> str:
    """A line for each answer: by which phone of the class, under a number that says nothing of whose it is; when, in
    UTC; how many were here; sketches as points in SI."""
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(HEAD)
    bank = registry.bank_of(room)
    questions = await registry.store.questions(room.code)
    given = {question: await registry.given_by(room, question) for question in questions}
    phones = numbered((name for answers in given.values() for name, _ in answers), room.code)
    for question, answers in given.items():
        walk, step, vote = question.split("/")
        if not answers:
            continue
        asked, words = bank.asked(walk, step), ("no", "yes") if bank.judges(walk, step) else ("", "")
        async for name, one in by_and_by(sorted(answers, key=lambda answer: phones[answer[0]])):
            row = (time_of(one.at), str(one.here or ""), walk, step, vote, asked, *bank.written(one), words[one.right])
            writer.writerow((phones[name], *map(cell, row)))
    return text.getvalue()


def numbered(names: Iterable[str], code: str) -> dict[str, int]:
    """A number for each name, in an order that tells nothing of when somebody came: their tokens begin with that."""
    known = sorted(set(names), key=lambda name: sha256(f"{code} {name}".encode()).digest())
    return {name: number for number, name in enumerate(known, start=1)}


def time_of(at: float) -> str:
    return datetime.fromtimestamp(at, UTC).strftime("%Y-%m-%dT%H:%M:%SZ") if at else ""


def cell(text: str) -> str:
    """A text that no spreadsheet takes for a formula; a negative number is a number."""
    return f"'{text}" if text.startswith(FORMULAS) and not NUMBER.fullmatch(text) else text
