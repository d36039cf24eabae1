"""The live class over HTTP, as its instructor's page uses it: a room is opened, led, counted, and ended."""

from __future__ import annotations

import io
from collections.abc import Awaitable
from typing import TYPE_CHECKING, Any, TypeVar
from urllib.parse import unquote

import msgspec
import segno
from tornado.web import RequestHandler

from components.live_class.codes import as_code, digest, is_key, join_key
from components.live_class.registry import ClosedError
from components.live_class.room import ClassRoom
from components.live_class.store import ALONE, AwayError
from components.live_class.votes_csv import votes_csv
from components.page.room import Opened, Order, Tally
from components.serving.answers import SENTENCES, RefusedError, Visited
from components.serving.settings import own_address
from components.serving.shell import version
from components.serving.visitors import network_of

if TYPE_CHECKING:
    from components.serving.server import Lecture

LONGEST = 8000
"""Bytes of a message to a room: two sketches are a quarter of it."""
LONGEST_ORDER = 64_000
"""The same from the instructor's page, which may hand over a walk's file."""
AWAY = "The server cannot reach its record of the class now. What you see stays; try again in a moment."
MOST_OPENED = 100
"""Rooms that one network may open in the time for which one lives alone."""

ASKED = "Opening a class here needs the instructors' passphrase."
WRONG = "This is not the instructors' passphrase. Whoever runs this server has set it."

Body = TypeVar("Body")
Answered = TypeVar("Answered")


class Waited(RequestHandler):
    """What comes after the checks of a name."""

    async def prepare(self) -> None:
        """Nothing."""


class ClassAnswer(Visited, Waited):
    """Whatever is said to a room; refusals are sentences, as JSON."""

    application: Lecture

    async def prepare(self) -> None:
        await super().prepare()
        self.set_header("Cache-Control", "no-store")
        self.set_header("Lecture-Version", version())  # a page of another one loads anew
        origin = self.request.headers.get("Origin", "")
        if (
            origin
            and origin != f"{self.request.protocol}://{self.request.host}"
            and not self.application.goes_by(origin)
        ):
            raise RefusedError(403, "A class is led and followed from the lecture's own page.")

    @property
    def word(self) -> str:
        """The key or token that is shown."""
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

    async def asked(self, question: Awaitable[Answered]) -> Answered:
        """What the registry says, or why it does not, in a sentence."""
        try:
            return await question
        except ClosedError as reason:
            raise RefusedError(404, str(reason)) from reason
        except AwayError as reason:
            raise RefusedError(503, AWAY, after=1) from reason
        except ValueError as reason:
            raise RefusedError(409, str(reason)) from reason

    def often(self, name: str) -> None:
        if seconds := self.application.class_rate.admit(name):
            raise RefusedError(429, "Too many messages at once. Try again in a moment.", seconds)

    async def led(self, code: str) -> ClassRoom:
        """The room, for its instructor alone; what others ask does not count, or they could silence an instructor."""
        room = await self.asked(self.application.registry.led(as_code(code), self.word))
        self.often(f"lead {room.code}")
        return room

    def address(self, query: str) -> str:
        """Where the class, or a remote control, comes in."""
        settings = self.application.asked
        host = self.request.host
        if settings.everywhere and self.request.host_name in ("localhost", "127.0.0.1") and (own := own_address()):
            host = host.replace(self.request.host_name, own)
        base = settings.public_url or f"{self._scheme()}://{host}{self._folder()}"
        return f"{base.rstrip('/')}/?{query}"

    def _scheme(self) -> str:
        """As the visitor's browser has it, by the word of a proxy that is trusted."""
        told = self.request.headers.get("X-Forwarded-Proto", "")
        return told if self.settings["trusted_proxies"] and told in ("http", "https") else self.request.protocol

    def _folder(self) -> str:
        """The path that a proxy serves the lecture under, by the word of the page itself."""
        path = self.request.headers.get("X-Page-Path", "/")
        return path.rstrip("/") if path.startswith("/") and path.isascii() and len(path) < 200 else ""

    def opened(self, code: str, key: str) -> Opened:
        address = self.address(f"class={code}&join={join_key(key)}")
        return Opened(code=code, key=key, address=address, square=square(address))

    def write_error(self, status_code: int, **more: Any) -> None:
        error = more.get("exc_info", (None, None, None))[1]
        sentence = error.sentence if isinstance(error, RefusedError) else SENTENCES.get(status_code, SENTENCES[400])
        if isinstance(error, RefusedError) and error.after:
            self.set_header("Retry-After", str(max(1, round(error.after))))
        self.application.metrics.refused.labels(f"class {status_code}").inc()
        self.reply({"sentence": sentence})
        self.finish()


def square(text: str) -> str:
    """A QR code as SVG, in the colour of the text around it."""
    drawing = io.BytesIO()
    segno.make(text, error="m", micro=False).save(
        drawing, kind="svg", xmldecl=False, svgns=True, border=2, omitsize=True, svgclass="qr", lineclass=None
    )
    return drawing.getvalue().decode()


class OpenClass(ClassAnswer):
    """A new room."""

    async def post(self) -> None:
        phrase = self.application.asked.class_passphrase
        if not phrase or not is_key(unquote(self.word), digest(phrase)):  # who knows it waits for nobody who does not
            await self._admit()
            if phrase:
                raise RefusedError(401, WRONG if self.word else ASKED)
        self.reply(self.opened(*await self.asked(self.application.registry.open())))

    async def _admit(self) -> None:
        name = f"opened {network_of(self.visitor)}"
        if seconds := self.application.openings.admit(self.visitor):
            raise RefusedError(
                429, "Many classes were opened from this network just now. Try again in a moment.", seconds
            )
        if await self.asked(self.application.registry.store.count(name, ALONE)) > MOST_OPENED:
            raise RefusedError(
                429,
                f"{MOST_OPENED} classes were opened from this network. Try again in {ALONE / 60:.0f} minutes.",
                ALONE,
            )


class LeadClass(ClassAnswer):
    """To an instructor's page that comes back: its room; from it, what is to be done."""

    async def get(self, code: str) -> None:
        room = await self.led(code)
        self.reply(self.opened(room.code, self.word))

    async def post(self, code: str) -> None:
        room = await self.led(code)
        order: Order = self.body(Order, LONGEST_ORDER)  # type: ignore[arg-type]  # a union of types
        await self.asked(self.application.registry.obey(room, order, str(network_of(self.visitor))))
        self.set_status(204)


class CountAnswers(ClassAnswer):
    """What has been answered so far."""

    async def get(self, code: str) -> None:
        room = await self.led(code)
        tally: Tally | None = await self.asked(self.application.registry.tally(room))
        self.reply(tally)


class TakeAnswers(ClassAnswer):
    """All answers of the lecture, as CSV."""

    async def get(self, code: str) -> None:
        room = await self.led(code)
        text = await self.asked(votes_csv(self.application.registry, room))
        self.set_header("Content-Type", "text/csv; charset=utf-8")
        self.write(text)
