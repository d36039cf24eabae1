"""Clients of a live class without a browser: instructor, followers and their streams, byte by byte."""

from __future__ import annotations

import asyncio
import json
import time
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from http.client import HTTPConnection
from typing import Any, NamedTuple
from urllib.parse import urlsplit

PATIENCE = 60.0
TRACES = ("Traceback", 'File "', "site-packages", "Error:")


class Answered(NamedTuple):
    status: int
    text: str
    headers: dict[str, str]

    @property
    def json(self) -> Any:
        return json.loads(self.text)

    @property
    def refused(self) -> bool:
        """True for a client error (4xx) whose text shows nothing of the program."""
        return 400 <= self.status < 500 and self.quiet

    @property
    def quiet(self) -> bool:
        return not any(sign in self.text for sign in TRACES)


def call(
    url: str, path: str = "/", method: str = "GET", body: object = None, word: str = "", **headers: str
) -> Answered:
    """Send one request with a key or token. Underscores in header names become hyphens."""
    connection = HTTPConnection(urlsplit(url).netloc, timeout=PATIENCE)
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    if word:
        named["Authorization"] = f"Bearer {word}"
    try:
        sent = body if body is None or isinstance(body, bytes) else json.dumps(body)
        connection.request(method, path, sent, named)
        answer = connection.getresponse()
        return Answered(answer.status, answer.read().decode("utf-8", "replace"), dict(answer.headers))
    finally:
        connection.close()


async def called(*given: Any, **more: Any) -> Answered:
    return await asyncio.to_thread(call, *given, **more)


class Stream:
    """The events of a class. `heard` has those read so far, each with the time of its arrival."""

    begun: set[Stream] = set()
    """Streams that are still open."""

    def __init__(self, url: str, code: str, word: str) -> None:
        self.url, self.code, self.word = url, code, word
        self.heard: list[tuple[float, dict[str, Any]]] = []
        self.bytes = 0
        self.headers = ""
        self.ended = False
        self._task: asyncio.Task[None] | None = None
        self._writer: asyncio.StreamWriter | None = None

    async def open(self, keep: Callable[[bytes], Any] = json.loads) -> Stream:
        host = urlsplit(self.url)
        self.begun.add(self)
        self._reader, self._writer = await asyncio.open_connection(host.hostname, host.port, limit=2**20)
        lines = [
            f"GET /class/{self.code}/events HTTP/1.1", f"Host: {host.netloc}", f"Authorization: Bearer {self.word}"
        ]  # fmt: skip
        self._writer.write("\r\n".join([*lines, "", ""]).encode())
        self.headers = (await asyncio.wait_for(self._reader.readuntil(b"\r\n\r\n"), PATIENCE)).decode()
        self._task = asyncio.create_task(self._read(keep))
        return self

    async def _read(self, keep: Callable[[bytes], Any]) -> None:
        try:
            while size := int(await self._reader.readline() or b"0", 16):
                chunk = await self._reader.readexactly(size + 2)
                self.bytes += len(chunk)
                for event in chunk.strip().split(b"\n\n"):
                    self.heard.append((time.time(), keep(event.removeprefix(b"data: "))))
        except (ConnectionError, asyncio.IncompleteReadError, ValueError):
            pass
        self.ended = True

    async def until(self, holds: Callable[[dict[str, Any]], Any], seconds: float = PATIENCE) -> dict[str, Any]:
        """Wait for an event that fulfils a condition, and return the last such event."""
        async with asyncio.timeout(seconds):
            while True:
                for _, event in reversed(self.heard):
                    if holds(event):
                        return event
                await asyncio.sleep(0.005)

    async def close(self) -> None:
        self.begun.discard(self)
        if self._writer:
            self._writer.close()
        if self._task:
            await self._task


@asynccontextmanager
async def streams_closed() -> AsyncIterator[None]:
    """Close all streams at the end, so that a failed test does not affect later ones."""
    try:
        yield
    finally:
        await asyncio.gather(*(stream.close() for stream in list(Stream.begun)))


class Class:
    """A class, and its instructor, whose requests a proxy may have sent for an address."""

    def __init__(self, url: str, opened: dict[str, Any], address: str = "") -> None:
        self.url, self.opened, self.headers = url, opened, {"X_Forwarded_For": address}
        self.code, self.key = opened["code"], opened["key"]

    @classmethod
    async def open(cls, url: str) -> Class:
        answer = await called(url, "/class", "POST")
        assert answer.status == 200, answer.text
        return cls(url, answer.json)

    async def ask(
        self, path: str, method: str = "GET", body: object = None, word: str | None = None, url: str = ""
    ) -> Answered:
        """Send a request to an address of the class: with its key, or with another word or none."""
        word = self.key if word is None else word
        return await called(url or self.url, f"/class/{self.code}/{path}", method, body, word, **self.headers)

    async def order(self, type: str, **order: Any) -> Answered:
        return await self.ask("lead", "POST", {"type": type, **order})

    async def tally(self) -> Any:
        return (await self.ask("tally")).json

    async def token(self, url: str = "") -> str:
        """Send the request of a follower who asks for news; the server counts everyone who asks."""
        token: str = (await self.ask("token", "POST", word="", url=url)).json["token"]
        assert (await self.ask("now", word=token, url=url)).status == 200
        return token

    async def follow(self, url: str = "", keep: Callable[[bytes], Any] = json.loads) -> Stream:
        return await Stream(url or self.url, self.code, await self.token(url)).open(keep)

    async def lead(self) -> Stream:
        """Open the instructor's stream."""
        return await Stream(self.url, self.code, self.key).open()

    async def vote(self, token: str, url: str = "", **vote: Any) -> Answered:
        return await self.ask("answer", "PUT", vote, token, url)

    async def voted(self, token: str, **vote: Any) -> None:
        """Send an answer, which is accepted."""
        assert (await self.vote(token, **vote)).status == 204


class Remote:
    """A phone as a remote control."""

    def __init__(self, lesson: Class, digits: str, key: str) -> None:
        self.lesson, self.digits, self.key = lesson, digits, key

    @staticmethod
    async def secret(lesson: Class) -> str:
        """Return the secret of a new ticket."""
        ticket = (await lesson.ask("tickets", "POST")).json["address"]
        return str(ticket.partition("remote=")[2])

    @classmethod
    async def wait(cls, lesson: Class) -> Remote | None:
        """Return a phone that has scanned a ticket and waits to be admitted; None if too many wait."""
        paired = await lesson.ask("remote", "PUT", {"address": await cls.secret(lesson)}, word="")
        return cls(lesson, **paired.json) if paired.status == 200 else None

    @classmethod
    async def pair(cls, lesson: Class) -> Remote:
        remote = await cls.wait(lesson)
        assert remote and (await remote.decide()).status == 200
        return remote

    async def decide(self, method: str = "PUT", digits: str = "") -> Answered:
        """The instructor's page admits or refuses it."""
        return await self.lesson.ask("tickets", method, {"digits": digits or self.digits})

    async def look(self, after: str = "") -> Answered:
        return await self.lesson.ask(f"remote?after={after}", word=self.key)

    async def press(self, **done: str) -> Answered:
        return await self.lesson.ask("remote", "POST", done, self.key)
