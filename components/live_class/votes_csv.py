"""The answers of a lecture as a table, without a word of who gave them."""

from __future__ import annotations

import csv
import io
import re

from components.live_class.pauses import by_and_by
from components.live_class.registry import Registry
from components.live_class.room import ClassRoom

FORMULAS = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")
"""Beginnings of a cell that a spreadsheet works out, or does in some language or when the file is saved again."""
NUMBER = re.compile(r"-?\d+(\.\d+)?(e[+-]?\d+)?")
HEAD = ("walk", "step", "vote", "answer", "right")


async def votes_csv(registry: Registry, room: ClassRoom) -> str:
    """A line for each answer, in no order that tells one follower from another."""
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(HEAD)
    bank = registry.bank_of(room)
    for question in await registry.store.questions(room.code):
        judged = await registry.given(room, question)
        rows = [(bank.written(one, room.code), "yes" if one.right else "no") async for one in by_and_by(judged)]
        walk, step, vote = question.split("/")
        async for row in by_and_by(sorted(rows)):
            writer.writerow(map(cell, (walk, step, vote, *row)))
    return text.getvalue()


def cell(text: str) -> str:
    """A text that no spreadsheet takes for a formula; a negative number is a number."""
    return f"'{text}" if text.startswith(FORMULAS) and not NUMBER.fullmatch(text) else text
