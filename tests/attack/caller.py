"""Clients that send requests and WebSocket frames byte by byte, including ones that no page sends."""

from __future__ import annotations

import asyncio
import base64
import json
import re
import zlib
from typing import Any

from tornado.httpclient import HTTPClientError, HTTPRequest
from tornado.websocket import WebSocketClientConnection, websocket_connect

from tests.live_class.caller import call

PATIENCE = 60.0
"""Seconds to wait for an answer of the server."""


ask = call


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


async def connect(url: str, token: str, headers: dict[str, str] | None = None) -> WebSocketClientConnection:
    request = HTTPRequest(f"{url.replace('http', 'ws', 1)}ws", headers=headers)
    return await asyncio.wait_for(websocket_connect(request, subprotocols=["bokeh", token]), PATIENCE)


async def refused(url: str, token: str) -> int:
    """Return the status of a refused handshake, or 101 if it was accepted."""
    try:
        await Caller(await connect(url, token)).depart()
    except HTTPClientError as error:
        return error.code
    return 101


class Caller:
    """A raw WebSocket on its own session."""

    def __init__(self, socket: WebSocketClientConnection) -> None:
        self.socket = socket

    @classmethod
    async def arrive(cls, url: str) -> Caller:
        page = await asyncio.to_thread(ask, url, "/?scene=coupled")
        caller = cls(await connect(url, token_of(page.text)))
        for _ in range(3):  # the three frames of the greeting
            await caller.receive()
        return caller

    async def receive(self) -> str | bytes | None:
        """Return the next frame, or None if the server has closed."""
        return await asyncio.wait_for(self.socket.read_message(), PATIENCE)

    async def send(self, *frames: str | bytes) -> None:
        for frame in frames:
            await self.socket.write_message(frame, binary=isinstance(frame, bytes))

    async def depart(self) -> None:
        """Close the socket and wait until the server has closed it too."""
        self.socket.close()
        while await self.receive() is not None:
            pass

    async def closed(self) -> tuple[int | None, str]:
        """Return the code and reason with which the server closes. Frames that come before are ignored."""
        while await self.receive() is not None:
            pass
        self.socket.close()
        return self.socket.close_code, self.socket.close_reason or ""


def header(kind: str = "PATCH-DOC", **more: Any) -> str:
    return json.dumps({"msgid": "attack", "msgtype": kind, **more})


def patch(*events: Any) -> tuple[str, str, str]:
    return header(), "{}", json.dumps({"events": list(events)})


def event(name: str, **values: Any) -> dict[str, Any]:
    wired = {"type": "map", "entries": [list(entry) for entry in values.items()]}
    return {
        "kind": "MessageSent",
        "msg_type": "bokeh_event",
        "msg_data": {"type": "event", "name": name, "values": wired},
    }


def said(data: Any, model: str = "p1") -> tuple[str, str, str]:
    """Return the frames of a message of the page's component."""
    return patch(event("from_browser", model={"id": model}, data=data))
