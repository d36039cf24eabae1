"""A visitor without a browser: opens a session, over HTTP and a raw WebSocket, and moves sliders.

It uses the protocol of Bokeh 3: a message is a JSON header, metadata and content, then two frames per buffer.
"""

from __future__ import annotations

import asyncio
import json
import zlib
from collections import defaultdict
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from tornado.httpclient import HTTPError
from tornado.websocket import WebSocketClientConnection, WebSocketClosedError

from components.session.panel_bridge import FROM_SERVER
from tests.attack.caller import ask, connect, event, token_of

PATIENCE = 30.0  # seconds until a missing answer is an error
LEFT = "the server closed the session"
USUAL: dict[str, bytes] = {}
"""The preset dictionary of each sheet, which the visitors of a process fetch once."""


@dataclass
class Traffic:
    """The traffic from the server: bytes of all frames, and patches without acknowledgements."""

    bytes: int = 0
    patches: int = 0


class Visitor:
    """One open session. `traffic` counts from its opening; only bytes that carry content are counted."""

    def __init__(self, socket: WebSocketClientConnection, url: str) -> None:
        self.traffic = Traffic()
        self._url, self._socket, self._number, self._view = url, socket, 0, ""
        self._arrived = defaultdict[str, asyncio.Future[Any]](asyncio.get_running_loop().create_future)
        self._reader = asyncio.create_task(self._read())

    @classmethod
    async def arrive(cls, url: str, query: str = "scene=oscillator") -> Visitor:
        page = await asyncio.to_thread(ask, url, f"/?{query}")
        return await cls.connect(url, token_of(page.text))

    @classmethod
    async def connect(cls, url: str, token: str, headers: dict[str, str] | None = None) -> Visitor:
        """Connect a page that has its token. Raises ConnectionError if no server accepts it."""
        try:
            socket = await connect(url, token, headers)
        except (HTTPError, OSError) as error:
            raise ConnectionError(str(error)) from error
        if socket.protocol:
            socket.protocol.set_nodelay(True)  # as browsers do
        visitor = cls(socket, url)
        try:
            await visitor._start()
        except (ConnectionError, TimeoutError):
            await visitor.depart()
            raise
        return visitor

    async def move(self, parameter: str, value: float) -> None:
        """Move one slider and wait for the new picture."""
        await self.send({"type": "set", "values": {parameter: value}})

    async def send(self, message: dict[str, Any]) -> dict[str, Any]:
        """Send a message of the page, and return its answer without the columns."""
        data = _encoded({**message, "number": self._number})
        answer = f"answer {self._number}"
        await self._patch(event("from_browser", model={"id": self._view}, data=data))
        told: dict[str, Any] = await self._answer(answer)
        return told

    async def depart(self) -> None:
        """Leave and wait until the connection has ended, because an open socket can outlive the event loop."""
        self._socket.close()
        await asyncio.wait_for(self._reader, PATIENCE)

    async def _start(self) -> None:
        await self._answer("ACK")
        pulled = await self._answer(await self._send("PULL-DOC-REQ"))
        self._view = next((model["id"] for model in pulled["doc"]["roots"]), "")
        await self._patch(event("document_ready"))

    async def _patch(self, event: dict[str, Any]) -> None:
        await self._send("PATCH-DOC", {"events": [event]})

    async def _send(self, kind: str, content: dict[str, Any] | None = None) -> str:
        """Send a message, and return the name of its answer."""
        self._number += 1
        name = f"visitor-{self._number}"
        for part in ({"msgid": name, "msgtype": kind}, {}, content or {}):
            try:
                await self._socket.write_message(json.dumps(part))
            except WebSocketClosedError as error:
                raise ConnectionError(LEFT) from error
        return name

    async def _answer(self, name: str) -> Any:
        """Wait until an answer arrives or the server closes."""
        arrived = self._arrived[name]
        await asyncio.wait((arrived, self._reader), timeout=PATIENCE, return_when=asyncio.FIRST_COMPLETED)
        if not self._arrived.pop(name).done():
            raise ConnectionError(LEFT) if self._reader.done() else TimeoutError(name)
        return arrived.result()

    async def _read(self) -> None:
        with suppress(ConnectionError):
            while True:
                header, _, content = [json.loads(await self._frame()) for _ in range(3)]
                buffers = [await self._frame() for _ in range(2 * header.get("num_buffers", 0))]
                self.traffic.patches += header["msgtype"] == "PATCH-DOC"
                self._take(header.get("reqid", header["msgtype"]), content)
                for told in await self._told(content, buffers[1::2]):
                    self._take(f"answer {told['answer']}", told)
        self._socket.close()

    def _take(self, name: str, content: Any) -> None:
        if not self._arrived[name].done():
            self._arrived[name].set_result(content)

    async def _told(self, content: dict[str, Any], buffers: list[Any]) -> list[dict[str, Any]]:
        """Return the messages in a patch, without their columns."""
        told = []
        for one in content.get("events", []):
            if one.get("msg_type") == FROM_SERVER:
                sheet, _, data = buffers.pop(0).partition(b"\n")
                preset_dictionary = await self.dictionary(sheet.decode())
                text = zlib.decompressobj(-15, *([preset_dictionary] if preset_dictionary else [])).decompress(data)
                told.append(json.loads(text.partition(b"\n")[0]))
        return told

    async def dictionary(self, sheet: str) -> bytes:
        """Return the preset dictionary of a scene."""
        if sheet and sheet not in USUAL:
            found = await asyncio.to_thread(ask, self._url, f"/assets/{sheet}")
            USUAL[sheet] = found.json["preset_dictionary"].encode()
        return USUAL.get(sheet, b"")

    async def _frame(self) -> str | bytes:
        frame = await self._socket.read_message()
        if frame is None:
            raise ConnectionError(LEFT)
        self.traffic.bytes += len(frame)
        return frame


def _encoded(value: Any) -> Any:
    if isinstance(value, dict):
        return {"type": "map", "entries": [[name, _encoded(item)] for name, item in value.items()]}
    return value
