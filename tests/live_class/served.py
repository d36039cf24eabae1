"""A server with a live class, listeners of a class without one, and a class with as many answers as a server stores."""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from functools import partial
from typing import Any

import msgspec

from app import SHEETS, walked
from components.language.class_messages import News
from components.language.messages import Given
from components.live_class.routes import LiveClass
from components.live_class.store import MemoryStore, Store
from components.serving.server import Server
from components.serving.settings import Settings
from tests.live_class.caller import Class, streams_closed

LECTURE = walked([])
BANK = LECTURE.bank
CHOICE = {"walk": "d31", "step": "d31-03"}
ANSWERS = 5000
READ = ("summary", "answers.csv", "answers?question={walk}/{step}/1", "tally", "stored")
"""Addresses below that of a class, for its instructor."""


@asynccontextmanager
async def served(store: Store | None = None, **settings: Any) -> AsyncIterator[tuple[Server, str]]:
    """Yield such a server. At the end, close all streams that the test has opened."""
    made = Settings(**{"address": "127.0.0.1", "port": 0, **settings})
    live_class = LiveClass(store or MemoryStore(), BANK, made.class_passphrase, made.bokeh_secret_key)
    page = partial(LECTURE.open_page, lead=live_class.lead)
    server = Server(page, made, sheets={**SHEETS, **LECTURE.files}, extensions=[live_class], start=LECTURE.start)
    server.classes = live_class.context
    try:
        async with streams_closed():
            yield server, f"http://127.0.0.1:{server.port}/"
    finally:
        await server.end()


@asynccontextmanager
async def taught(store: Store | None = None, **settings: Any) -> AsyncIterator[tuple[Server, str, Class]]:
    """Yield such a server with an open class."""
    async with served(store, **settings) as (server, url):
        yield server, url, await Class.open(url)


class Listener:
    """A listener of a class."""

    def __init__(self, leads: bool = False) -> None:
        self.leads = leads
        self.name = str(id(self))
        self.news: list[News] = []
        self.ended = False

    def receive(self, event: bytes) -> None:
        self.news.append(msgspec.json.decode(event.removeprefix(b"data: "), type=News))

    def end(self) -> None:
        self.ended = True


async def fill(opened: Class, kept: MemoryStore, asked: dict[str, Any], votes: int = 3) -> None:
    """Fill some votes with the largest number of answers, all of them wrong."""
    judged = BANK.judge(Given(**asked))
    assert not judged.right
    for vote in range(1, votes + 1):
        await opened.order("put", walk=asked["walk"], step=asked["step"], vote=vote)
        answer = msgspec.json.encode(msgspec.structs.replace(judged, vote=vote))
        for voter in range(ANSWERS):
            assert await kept.vote(opened.code, f"{asked['walk']}/{asked['step']}/{vote}", f"{voter:019}", answer)
