"""The base handler of the live class: permissions, limits, and refusals in a sentence."""

from __future__ import annotations

import io
from collections.abc import Awaitable
from typing import Any, TypeVar

import msgspec
import segno

from components.language.class_messages import Opened
from components.live_class.codes import as_code, join_key
from components.live_class.context import ClassContext
from components.live_class.question_bank import BusyError
from components.live_class.registry import ClosedError, EndedError
from components.live_class.room import ClassRoom
from components.live_class.store import UnreachableError
from components.serving.handlers import SENTENCES, RefusedError, VisitorHandler
from components.serving.settings import own_address
from components.serving.shell import version
from components.serving.visitors import network_of

LONGEST = 8000
"""Bytes of a message to a room; two sketches take a quarter of it."""
UNREACHABLE = "The server cannot reach the data of the class now. Try again in a moment."

Body = TypeVar("Body")
Answered = TypeVar("Answered")


class ClassHandler(VisitorHandler):
    """Base handler of messages to a room; refusals are sentences, as JSON."""

    def initialize(self, classes: ClassContext) -> None:
        self.classes = classes

    async def prepare(self) -> None:
        await super().prepare()
        self.set_header("Cache-Control", "no-store")
        self.set_header("Lecture-Version", version())  # a page of another version reloads
        origin = self.request.headers.get("Origin", "")
        own = f"{self.request.protocol}://{self.request.host}"
        if origin and origin != own and not self.context.goes_by(origin):
            raise RefusedError(403, "You can lead or follow a class only from the page of the lecture.")

    @property
    def word(self) -> str:
        """The key or token in the request."""
        return self.request.headers.get("Authorization", "").removeprefix("Bearer ")

    def body(self, kind: type[Body], longest: int = LONGEST) -> Body:
        if len(self.request.body) > longest:
            raise RefusedError(413, "This message is too long.")
        try:
            return msgspec.json.decode(self.request.body, type=kind)
        except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
            raise RefusedError(400, "This is not what the lecture's page sends.") from error

    def reply(self, value: object) -> None:
        self.set_header("Content-Type", "application/json")
        self.write(msgspec.json.encode(value))

    async def outcome(self, asked: Awaitable[Answered]) -> Answered:
        """Return the result of the registry, or refuse with its sentence."""
        try:
            return await asked
        except EndedError as reason:
            raise RefusedError(410, str(reason)) from reason
        except ClosedError as reason:
            raise RefusedError(404, str(reason)) from reason
        except UnreachableError as reason:
            raise RefusedError(503, UNREACHABLE, after=1) from reason
        except BusyError as reason:
            raise RefusedError(429, str(reason), after=1) from reason
        except ValueError as reason:
            raise RefusedError(409, str(reason)) from reason

    async def in_turn(self, asked: Awaitable[Answered]) -> Answered:
        """Wait until no other expensive work runs for this network, then return the result of this one."""
        async with self.classes.turns.of(str(network_of(self.visitor))):
            return await self.outcome(asked)

    def limit(self, name: str) -> None:
        """Count a message of a sender, and refuse it if there were too many."""
        if seconds := self.classes.rate.admit(name):
            raise RefusedError(429, "Too many messages at once. Try again in a moment.", seconds)

    async def led(self, code: str) -> ClassRoom:
        """Return the room if the request has the instructor's key. Requests of others do not count towards the limit,
        because they could use it up.
        """
        room = await self.outcome(self.classes.registry.led(as_code(code), self.word))
        self.limit(f"lead {room.code}")
        return room

    def address(self, path: str) -> str:
        """Return the address of the class or of a remote control, from its path below the lecture's own."""
        settings = self.context.settings
        host = self.request.host
        if settings.everywhere and self.request.host_name in ("localhost", "127.0.0.1") and (own := own_address()):
            host = host.replace(self.request.host_name, own)
        base = settings.public_url or f"{self._scheme()}://{host}{self._folder()}"
        return f"{base.rstrip('/')}/{path}"

    def _scheme(self) -> str:
        """Return the scheme that the visitor's browser uses, as a trusted proxy reports it."""
        scheme = self.request.headers.get("X-Forwarded-Proto", "")
        return scheme if self.context.trusted and scheme in ("http", "https") else self.request.protocol

    def _folder(self) -> str:
        """Return the path under which a proxy serves the lecture, as the page itself reports it."""
        path = self.request.headers.get("X-Page-Path", "/")
        return path.rstrip("/") if path.startswith("/") and path.isascii() and len(path) < 200 else ""

    def opened(self, code: str, key: str) -> Opened:
        address = self.address(f"{code}?join={join_key(key)}")
        return Opened(code=code, key=key, address=address, square=square(address))

    def write_error(self, status_code: int, **more: Any) -> None:
        error = more.get("exc_info", (None, None, None))[1]
        sentence = error.sentence if isinstance(error, RefusedError) else SENTENCES.get(status_code, SENTENCES[400])
        if isinstance(error, RefusedError) and error.after:
            self.set_header("Retry-After", str(max(1, round(error.after))))
        self.context.metrics.refused.labels(f"class {status_code}").inc()
        self.reply({"sentence": sentence})
        self.finish()


def square(text: str) -> str:
    """A QR code as SVG, in the colour of the text around it."""
    drawing = io.BytesIO()
    segno.make(text, error="m", micro=False).save(
        drawing, kind="svg", xmldecl=False, svgns=True, border=2, omitsize=True, svgclass="qr", lineclass=None
    )
    return drawing.getvalue().decode()
