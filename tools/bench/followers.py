"""Many followers of a live class without a browser, each a connection that only listens: when each event came, and how
many bytes it was."""

from __future__ import annotations

import asyncio
import base64
import json
import math
import time
import zlib
from collections.abc import Sequence
from typing import Any
from urllib.parse import urlsplit

from tests.live_class.caller import Class
from tests.serving.visitor import USUAL, Visitor

END = b"\n\n\r\n"
"""An event that is a separate chunk; a proxy may join two."""
RATE = 20.0
"""Changes a second of the instructor's hand."""


class Hearing(asyncio.Protocol):
    """One follower. `heard` has the instant and the event's key in `EVENTS`, which all of a process share."""

    EVENTS: dict[int, bytes] = {}

    def __init__(self, head: bytes) -> None:
        self._head = head
        self._buffer = b""
        self.heard: list[tuple[float, int]] = []
        self.bytes = 0
        self.lost = False

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self.transport = transport
        transport.write(self._head)

    def data_received(self, data: bytes) -> None:
        self.bytes += len(data)
        self._buffer += data
        while (end := self._buffer.find(END)) >= 0:
            chunk, self._buffer = self._buffer[:end], self._buffer[end + len(END) :]
            for event in chunk.split(b"\n\n"):
                key = hash(event)
                self.EVENTS.setdefault(key, event)
                self.heard.append((time.time(), key))

    def connection_lost(self, reason: Exception | None) -> None:
        self.lost = True


async def followed(room: Class, urls: Sequence[str], count: int) -> list[Hearing]:
    """So many followers, spread over addresses."""
    gate = asyncio.Semaphore(50)

    async def one(number: int) -> Hearing:
        host = urlsplit(urls[number % len(urls)])
        lines = [f"GET /class/{room.code}/events HTTP/1.1", f"Host: {host.netloc}"]
        async with gate:
            head = "\r\n".join([*lines, f"Authorization: Bearer {await room.token()}", "", ""]).encode()
            _, hearing = await asyncio.get_running_loop().create_connection(
                lambda: Hearing(head), host.hostname, host.port
            )
            async with asyncio.timeout(30):
                while not hearing.heard:
                    await asyncio.sleep(0.01)
        return hearing

    return list(await asyncio.gather(*(one(number) for number in range(count))))


async def drag(visitor: Visitor, seconds: float) -> dict[float, float]:
    """When each value was set."""
    sent: dict[float, float] = {}
    begun = time.monotonic()
    while (now := time.monotonic() - begun) < seconds:
        value = round(2 + math.sin(3 * now) + 1e-6 * len(sent), 9)
        sent[value] = time.time()
        await visitor.send({"type": "set", "values": {"k2": value}})
        await asyncio.sleep(max(0.0, now + 1 / RATE - (time.monotonic() - begun)))
    return sent


def values(name: str) -> dict[int, float]:
    """The value of a parameter in each picture that was heard, by the key of its event."""
    found = {}
    for key, event in Hearing.EVENTS.items():
        told: dict[str, Any] = json.loads(event[event.index(b"{") :])
        if picture := told.get("picture"):
            preset_dictionary = USUAL[picture["sheet"]]
            text = (
                zlib.decompressobj(-15, preset_dictionary)
                .decompress(base64.b64decode(picture["data"]))
                .partition(b"\n")[0]
            )
            found[key] = json.loads(text)["settings"][name]["value"]
    return found


def sizes() -> list[int]:
    """Bytes on the wire of each picture that was heard."""
    return [len(event) + len(END) for event in Hearing.EVENTS.values() if b'"picture"' in event]
