"""A visitor without a browser: opens a session, over HTTP and a raw WebSocket, and moves sliders.

It speaks the protocol of Bokeh 3: a message is a JSON header, metadata and content, then two frames a buffer.
"""

from __future__ import annotations

import asyncio
import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any
from urllib.request import urlopen

from tornado.websocket import WebSocketClientConnection, websocket_connect

PATIENCE = 30.0  # seconds until a missing answer is an error

# What a browser tells of itself as soon as the page is there.
ABOUT = {
    "dark_mode": False,
    "device_pixel_ratio": 1,
    "language": "en-US",
    "webdriver": False,
    "timezone": "UTC",
    "timezone_offset": 0,
    "webgl": True,
}


@dataclass
class Traffic:
    """What the server has sent: bytes of all frames, and patches without acknowledgements."""

    bytes: int = 0
    patches: int = 0


class Visitor:
    """One open session. `traffic` counts from its opening; only bytes that carry content are counted."""

    def __init__(self, socket: WebSocketClientConnection) -> None:
        self.traffic = Traffic()
        self._socket = socket
        self._number = 0
        self._arrived: dict[str, asyncio.Future[Any]] = {}
        self._view = ""
        self._reader: asyncio.Task[None] | None = None

    @classmethod
    async def arrive(cls, url: str, query: str = "") -> Visitor:
        page = await asyncio.to_thread(_get, f"{url}?{query}")
        token = re.search(r'"token":"([^"]+)"', page)
        if token is None:
            raise RuntimeError(f"{url} is not a page of Bokeh's")
        address = f"{url.replace('http', 'ws', 1)}ws?{query}"
        socket = await websocket_connect(address, subprotocols=["bokeh", token[1]])
        if socket.protocol:
            socket.protocol.set_nodelay(True)  # as browsers do
        visitor = cls(socket)
        welcome = visitor._expect("ACK")
        visitor._reader = asyncio.create_task(visitor._read())
        await asyncio.wait_for(welcome, PATIENCE)
        await visitor._start()
        return visitor

    async def move(self, parameter: str, value: float) -> None:
        """Move one slider, and wait for the page's new picture."""
        await self.say({"type": "set", "values": {parameter: value}})

    async def say(self, message: dict[str, Any]) -> None:
        """Send one of the page's messages, and wait for its answer."""
        self._number += 1
        answered = self._expect(f"answer {self._number}")
        data = _encoded({**message, "number": self._number})
        await self._patch(_event("data_event", model={"id": self._view}, data=data))
        await asyncio.wait_for(answered, PATIENCE)

    def leave(self) -> None:
        if self._reader:
            self._reader.cancel()
        self._socket.close()

    async def _start(self) -> None:
        document = (await self._send("PULL-DOC-REQ"))["doc"]
        models = {model["name"]: model["id"] for model in _models(document["roots"])}
        self._view = models.get("panel.models.esm.ReactiveESM", "")
        if info := models.get("panel.models.browser.BrowserInfo"):
            for name, value in ABOUT.items():
                await self._patch({"kind": "ModelChanged", "model": {"id": info}, "attr": name, "new": value})
        await self._patch(_event("document_ready"))

    async def _patch(self, event: dict[str, Any]) -> None:
        await self._send("PATCH-DOC", {"events": [event]})

    async def _send(self, kind: str, content: dict[str, Any] | None = None) -> Any:
        """Send a message and wait for the reply to it."""
        self._number += 1
        name = f"visitor-{self._number}"
        replied = self._expect(name)
        for part in ({"msgid": name, "msgtype": kind}, {}, content or {}):
            await self._socket.write_message(json.dumps(part))
        return await asyncio.wait_for(replied, PATIENCE)

    def _expect(self, name: str) -> asyncio.Future[Any]:
        self._arrived[name] = asyncio.get_running_loop().create_future()
        return self._arrived[name]

    async def _read(self) -> None:
        while True:
            header, _, content = [json.loads(await self._frame()) for _ in range(3)]
            for _ in range(2 * header.get("num_buffers", 0)):
                await self._frame()
            self.traffic.patches += header["msgtype"] == "PATCH-DOC"
            for name in (header.get("reqid", header["msgtype"]), *_answers(content)):
                if waiting := self._arrived.pop(name, None):
                    waiting.set_result(content)

    async def _frame(self) -> str | bytes:
        frame = await self._socket.read_message()
        if frame is None:
            closed = ConnectionError("the server closed the session")
            for waiting in self._arrived.values():
                waiting.set_exception(closed)
            raise closed
        self.traffic.bytes += len(frame)
        return frame


def _get(address: str) -> str:
    with urlopen(address, timeout=PATIENCE) as reply:
        text: str = reply.read().decode()
        return text


def _event(name: str, **values: Any) -> dict[str, Any]:
    wired = {"type": "map", "entries": list(values.items())}
    return {
        "kind": "MessageSent",
        "msg_type": "bokeh_event",
        "msg_data": {"type": "event", "name": name, "values": wired},
    }


def _encoded(value: Any) -> Any:
    if isinstance(value, dict):
        return {"type": "map", "entries": [[name, _encoded(item)] for name, item in value.items()]}
    return value


def _models(tree: Any) -> Iterator[dict[str, Any]]:
    """Every model defined in a serialised document."""
    if isinstance(tree, dict):
        if tree.get("type") == "object" and "id" in tree:
            yield tree
        tree = list(tree.values())
    if isinstance(tree, list):
        for item in tree:
            yield from _models(item)


def _answers(content: dict[str, Any]) -> Iterator[str]:
    """The names of the slider moves that a patch answers."""
    for event in content.get("events", []):
        values = dict(event.get("msg_data", {}).get("values", {}).get("entries", []))
        data = values.get("data")
        if isinstance(data, dict) and "facts" in (parts := dict(data.get("entries", []))):
            yield f"answer {json.loads(parts['facts']).get('answer')}"
