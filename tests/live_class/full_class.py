"""A class with as many answers as a server stores, and the requests that read them."""

from __future__ import annotations

from typing import Any

import msgspec

from components.language.messages import Given
from components.live_class.store import MemoryStore
from tests.live_class.caller import Class
from tests.live_class.served import LECTURE

ANSWERS = 5000
VOTES = 3
READ = ("summary", "answers.csv", "answers?question={walk}/{step}/1", "tally", "stored")
"""Addresses below that of a class, for its instructor."""


async def fill(lesson: Class, kept: MemoryStore, asked: dict[str, Any]) -> None:
    """Fill some votes with the largest number of answers, all of them wrong."""
    judged = LECTURE.bank.judge(Given(**asked))
    assert not judged.right
    for vote in range(1, VOTES + 1):
        await lesson.order("put", walk=asked["walk"], step=asked["step"], vote=vote)
        answer = msgspec.json.encode(msgspec.structs.replace(judged, vote=vote))
        for voter in range(ANSWERS):
            assert await kept.vote(lesson.code, f"{asked['walk']}/{asked['step']}/{vote}", f"{voter:019}", answer)
