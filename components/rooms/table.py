"""The answers of a lecture as a table, without a word of who gave them."""

from __future__ import annotations

import csv
import io

from components.page.room import Vote
from components.rooms.hall import Hall
from components.rooms.room import ClassRoom

HEAD = ("walk", "step", "vote", "answer", "right")


async def answers_csv(hall: Hall, room: ClassRoom) -> str:
    """A line for each answer, in no order that tells one follower from another."""
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(HEAD)
    for question in await hall.store.questions(room.code):
        judged = await hall.given(room, question)
        rows = [(said(one.vote), "yes" if one.right else "no") for one in judged]
        walk, step, vote = question.split("/")
        writer.writerows((walk, step, vote, *row) for row in sorted(rows))
    return text.getvalue()


def said(vote: Vote) -> str:
    """An answer in one cell: options count from 1, a sketch has its heights in thousandths of the frame."""
    if vote.option is not None:
        return str(vote.option + 1)
    if vote.curves:
        return "; ".join(f"{name}: {' '.join(map(_height, curve))}" for name, curve in vote.curves.items())
    return vote.text or f"{vote.value:.6g}"


def _height(height: int | None) -> str:
    return "-" if height is None else str(height)
