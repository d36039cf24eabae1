"""The number of bytes that one anonymous visitor can make a class store."""

from __future__ import annotations

import asyncio
import gc
import sys
from collections import Counter
from itertools import pairwise
from types import CoroutineType, FrameType, FunctionType, ModuleType
from typing import get_args

import pytest
import redis

from components.language.class_messages import Order
from components.live_class import follower_routes, instructor_routes, registry, remotes, room
from tests.live_class.caller import Class
from tests.live_class.messages import MESSAGES, Client
from tests.live_class.served import CHOICE, served
from tests.live_class.stores import KINDS, Valkey, made, set_limits

NO_DATA = (type, ModuleType, FunctionType, FrameType, CoroutineType, asyncio.Task, asyncio.AbstractEventLoop)
REFUSED = {
    "POST /class/CODE/answer",
    "PUT /class/CODE/word", "PUT /class/CODE/word of none", "PUT /class/CODE/tickets", "DELETE /class/CODE/tickets",
    "POST /class/CODE/token of none", "GET /class/CODE/now of none",
}  # fmt: skip
"""Guesses and messages of strangers."""
ROUND = 18
"""Messages of a kind that are sent before the bytes are first counted, and between two counts."""
STEADY = 2000
"""Bytes that a round may add although nothing is stored per message: filling caches and growing lists."""


def test_the_orders_are_all_that_a_class_takes() -> None:
    orders = {order.__struct_config__.tag for order in get_args(Order)}
    assert orders == {name.split(" ")[2] for name in MESSAGES if name.startswith("POST /class/CODE/lead")}


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """A server with small limits."""
    set_limits(monkeypatch, 300_000, 50_000)
    monkeypatch.setattr(follower_routes, "MOST_FOLLOWERS", 4)
    monkeypatch.setattr(registry, "SPARE", 2)
    monkeypatch.setattr(instructor_routes, "MOST_OPENED", 4)
    monkeypatch.setattr(room, "KEPT", 4)
    monkeypatch.setattr(remotes, "DIGITS", range(10, 14))


def bytes_of(root: object) -> int:
    """Return the bytes of all objects reachable from one."""
    seen, todo, total = set[int](), [root], 0
    while todo:
        one = todo.pop()
        if id(one) not in seen and not isinstance(one, NO_DATA):
            seen.add(id(one))
            total += sys.getsizeof(one)
            todo += gc.get_referents(one)
    return total


def bytes_in(url: str) -> int:
    """Return the bytes of everything that a Valkey stores."""
    with redis.Redis.from_url(url) as client:
        return sum(int(client.memory_usage(key) or 0) for key in client.scan_iter())  # type: ignore[arg-type]


@pytest.mark.parametrize("kind", [KINDS[0], pytest.param("valkey", marks=[*KINDS[1].marks, pytest.mark.slow])])
async def test_many_messages_of_a_kind_leave_no_more_than_some(
    kind: str, valkey: Valkey, small: None, subtests: pytest.Subtests
) -> None:
    """After some messages a limit is reached: twice or three times as many add nothing."""
    async with made(kind, valkey.url) as kept, served(kept, trusted_proxies=("127.0.0.1",)) as (server, url):
        rooms = server.classes.registry
        for i, name in enumerate(MESSAGES):
            code, key = await rooms.open()
            sender = Client(url, Class(url, {"code": code, "key": key}), f"198.51.{i}.1")
            await sender.lesson.order("put", **CHOICE)
            sizes, statuses = list[int](), Counter[int]()
            for turn in range(3):
                for number in range(turn * ROUND, (turn + 1) * ROUND):
                    answer = await sender.send(name, number)
                    statuses[answer.status if answer else 0] += 1
                sizes.append(bytes_of(rooms) + (bytes_in(valkey.url) if kind == "valkey" else 0))
            with subtests.test(name):
                assert min(statuses) < 400 or name in REFUSED
                assert min(more - some for some, more in pairwise(sizes)) < STEADY
            await sender.lesson.order("end")
