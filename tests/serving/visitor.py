"""Visitors without a browser, over HTTP and a raw WebSocket: one moves sliders, another sends what no page sends.

They use the protocol of Bokeh 3: a message is a JSON header, metadata and content, then two frames per buffer.
"""

from __future__ import annotations

import asyncio
import base64
import json
import re
import zlib
from typing import Any, Self

from tornado.httpclient import HTTPClientError, HTTPError, HTTPRequest
from tornado.websocket import WebSocketClientConnection, WebSocketClosedError, websocket_connect

from components.session.panel_bridge import FROM_SERVER
from tests.live_class.caller import PATIENCE
from tests.live_class.caller import call as ask
from tests.page.scripts import text_of

LEFT = "the server closed the session"
USUAL: dict[str, bytes] = {}
"""The preset dictionary of each sheet, which the visitors of a process fetch once."""


def token_of(page: str) -> str:
    """Return the token that opens the page's session."""
    found = re.search(r'"token":"([^"]+)"', page)
    if found is None:
        raise ConnectionError("this is not a page with a session")
    return found[1]


def contents(token: str) -> dict[str, Any]:
    """Return the contents of a token, which are readable without a key."""
    said: dict[str, Any] = json.loads(_decoded(token.partition(".")[0]))
    packed = said.pop("__bk__zlib_", None)
    return said | (json.loads(zlib.decompress(_decoded(packed))) if packed else {})


def _decoded(text: str) -> bytes:
    return base64.urlsafe_b64decode(text + "=" * (-len(text) % 4))


async def refused(url: str, token: str, headers: dict[str, str] | None = None) -> int:
    """Return the status of a refused handshake, or 101 if it was accepted."""
    try:
        await (await Caller.connect(url, token, headers)).depart()
    except HTTPClientError as error:
        return error.code
    return 101


class Caller:
    """A raw WebSocket on its own session."""

    def __init__(self, socket: WebSocketClientConnection, url: str) -> None:
        self.socket, self.url = socket, url

    @classmethod
    async def connect(cls, url: str, token: str, headers: dict[str, str] | None = None) -> Self:
        """Connect a page that has its token."""
        request = HTTPRequest(f"{url.replace('http', 'ws', 1)}ws", headers=headers)
        return cls(await asyncio.wait_for(websocket_connect(request, subprotocols=["bokeh", token]), PATIENCE), url)

    @classmethod
    async def arrive(cls, url: str, query: str = "scene=oscillator") -> Self:
        page = await asyncio.to_thread(ask, url, f"/?{query}")
        caller = await cls.connect(url, token_of(page.text))
        await caller.greeted()
        return caller

    async def greeted(self) -> None:
        """Read the three frames of the greeting."""
        for _ in range(3):
            await self.receive()

    async def receive(self) -> str | bytes | None:
        """Return the next frame, or None if the server has closed."""
        return await asyncio.wait_for(self.socket.read_message(), PATIENCE)

    async def write(self, *frames: str | bytes) -> None:
        for frame in frames:
            await self.socket.write_message(frame, binary=isinstance(frame, bytes))

    async def depart(self) -> None:
        """Close the socket and wait until the server has closed it too."""
        self.socket.close()
        await self.closed()

    async def closed(self) -> tuple[int | None, str]:
        """Return the code and reason with which the server closes. Frames that come before are ignored."""
        while await self.receive() is not None:
            pass
        self.socket.close()
        return self.socket.close_code, self.socket.close_reason or ""


class Visitor(Caller):
    """A page's session. It counts the bytes of all frames from the server, and its patches."""

    bytes = patches = number = 0
    view = ""

    @classmethod
    async def connect(cls, url: str, token: str, headers: dict[str, str] | None = None) -> Self:
        """Connect and load the page. Raises ConnectionError if no server accepts the token."""
        try:
            visitor = await super().connect(url, token, headers)
        except (HTTPError, OSError) as error:
            raise ConnectionError(str(error)) from error
        if visitor.socket.protocol:
            visitor.socket.protocol.set_nodelay(True)  # as browsers do
        try:
            await visitor._reply("ACK")
            pulled = await visitor._request("PULL-DOC-REQ", {}, "1")
            visitor.view = next((model["id"] for model in pulled["doc"]["roots"]), "")
            await visitor._request("PATCH-DOC", {"events": [event("document_ready")]})
        except (ConnectionError, TimeoutError):
            await visitor.depart()
            raise
        return visitor

    async def greeted(self) -> None:
        """Do nothing: the greeting is read."""

    async def move(self, parameter: str, value: float) -> None:
        """Move one slider and wait for the new picture."""
        await self.send({"type": "set", "values": {parameter: value}})

    async def send(self, message: dict[str, Any]) -> dict[str, Any]:
        """Send a message of the page, and return its answer without the columns."""
        data = _encoded({**message, "number": self.number})
        sent = event("from_browser", model={"id": self.view}, data=data)
        told: dict[str, Any] = await self._request("PATCH-DOC", {"events": [sent]}, f"answer {self.number}")
        return told

    async def _request(self, kind: str, content: dict[str, Any], answer: str = "") -> Any:
        """Send a message, and wait for its answer if it has one."""
        self.number += 1
        try:
            await self.write(json.dumps({"msgid": f"{self.number}", "msgtype": kind}), "{}", json.dumps(content))
        except WebSocketClosedError as error:
            raise ConnectionError(LEFT) from error
        return await self._reply(answer) if answer else None

    async def _reply(self, name: str) -> Any:
        """Read messages until the one with this name comes, and return its content."""
        async with asyncio.timeout(PATIENCE):
            while name not in (found := await self._message()):
                pass
        return found[name]

    async def _message(self) -> dict[str, Any]:
        """Return the content of the next message, and the session's answers in it without their columns, by name."""
        header, _, content = [json.loads(await self._frame()) for _ in range(3)]
        buffers = [await self._frame() for _ in range(2 * header.get("num_buffers", 0))][1::2]
        self.patches += header["msgtype"] == "PATCH-DOC"
        found = {header.get("reqid", header["msgtype"]): content}
        for one in content.get("events", []):
            if one.get("msg_type") == FROM_SERVER:
                sheet, _, data = buffers.pop(0).partition(b"\n")
                told = json.loads(text_of({"sheet": "", "data": data}, await self.dictionary(sheet.decode())))
                found[f"answer {told['answer']}"] = told
        return found

    async def dictionary(self, sheet: str) -> bytes:
        """Return the preset dictionary of a scene."""
        if sheet and sheet not in USUAL:
            found = await asyncio.to_thread(ask, self.url, f"/assets/{sheet}")
            USUAL[sheet] = found.json["preset_dictionary"].encode()
        return USUAL.get(sheet, b"")

    async def _frame(self) -> Any:
        frame = await self.receive()
        if frame is None:
            raise ConnectionError(LEFT)
        self.bytes += len(frame)
        return frame


def _encoded(value: Any) -> Any:
    if isinstance(value, dict):
        return {"type": "map", "entries": [[name, _encoded(item)] for name, item in value.items()]}
    return value


def header(kind: str = "PATCH-DOC", **more: Any) -> str:
    return json.dumps({"msgid": "attack", "msgtype": kind, **more})


def patch(*events: Any) -> tuple[str, str, str]:
    return header(), "{}", json.dumps({"events": list(events)})


def event(name: str, **values: Any) -> dict[str, Any]:
    wired = {"type": "map", "entries": [list(entry) for entry in values.items()]}
    data = {"type": "event", "name": name, "values": wired}
    return {"kind": "MessageSent", "msg_type": "bokeh_event", "msg_data": data}


def said(data: Any, model: str = "p1") -> tuple[str, str, str]:
    """Return the frames of a message of the page's component."""
    return patch(event("from_browser", model={"id": model}, data=data))
