"""The answers of a lecture as a table, without a word of who gave them."""

from __future__ import annotations

import csv
import io
import re

from components.live_class.pauses import by_and_by
from components.live_class.question_bank import Judged
from components.live_class.registry import Registry
from components.live_class.room import ClassRoom
from components.numbers import shortest

FORMULAS = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")
"""Beginnings of a cell that a spreadsheet works out, or does in some language or when the file is saved again."""
NUMBER = re.compile(r"-?\d+(\.\d+)?(e[+-]?\d+)?")
HEAD = ("walk", "step", "vote", "answer", "right")


async def votes_csv(registry: Registry, room: ClassRoom) -> str:
    """A line for each answer, in no order that tells one follower from another."""
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(HEAD)
    for question in await registry.store.questions(room.code):
        judged = await registry.given(room, question)
        rows = [(said(one), "yes" if one.right else "no") async for one in by_and_by(judged)]
        walk, step, vote = question.split("/")
        async for row in by_and_by(sorted(rows)):
            writer.writerow(map(cell, (walk, step, vote, *row)))
    return text.getvalue()


def said(one: Judged) -> str:
    """An answer in one cell: options count from 1, a sketch has its heights in thousandths of the frame."""
    if one.option is not None:
        return str(one.option + 1)
    if one.curves:
        return "; ".join(f"{name}: {' '.join(map(_height, curve))}" for name, curve in one.curves.items())
    return shortest(one.number) if one.text else f"{one.value:.6g}"


def cell(text: str) -> str:
    """A text that no spreadsheet takes for a formula; a negative number is a number."""
    return f"'{text}" if text.startswith(FORMULAS) and not NUMBER.fullmatch(text) else text


def _height(height: int | None) -> str:
    return "-" if height is None else str(height)
