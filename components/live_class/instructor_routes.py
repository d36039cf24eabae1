"""The live class over HTTP, as its instructor's page uses it: a room is opened, led, counted, and ended."""

from __future__ import annotations

from urllib.parse import unquote

from components.language.room import Order, Reopen, Tally
from components.live_class.codes import as_code, digest, is_key
from components.live_class.handler import ClassHandler
from components.live_class.store import ALONE
from components.live_class.summary import summary
from components.live_class.votes_csv import votes_csv
from components.serving.handlers import RefusedError
from components.serving.visitors import network_of

LONGEST_ORDER = 64_000
"""Bytes of a message from the instructor's page, which may hand over a walk's file."""
MOST_OPENED = 100
"""Rooms that one network may open in the time for which one lives alone."""

ASKED = "Opening a class here needs the instructors' passphrase."
WRONG = "This is not the instructors' passphrase. Whoever runs this server has set it."


class Opener(ClassHandler):
    """A handler that opens rooms, so many for one network."""

    async def admit(self) -> None:
        name = f"opened {network_of(self.visitor)}"
        if seconds := self.classes.openings.admit(self.visitor):
            raise RefusedError(
                429, "Many classes were opened from this network just now. Try again in a moment.", seconds
            )
        if await self.outcome(self.classes.registry.store.count(name, ALONE)) > MOST_OPENED:
            raise RefusedError(
                429,
                f"{MOST_OPENED} classes were opened from this network. Try again in {ALONE / 60:.0f} minutes.",
                ALONE,
            )


class OpenClass(Opener):
    """The handler that opens a room."""

    async def post(self) -> None:
        phrase = self.context.settings.class_passphrase
        if not phrase or not is_key(unquote(self.word), digest(phrase)):  # who knows it waits for nobody who does not
            await self.admit()
            if phrase:
                raise RefusedError(401, WRONG if self.word else ASKED)
        self.reply(self.opened(*await self.outcome(self.classes.registry.open())))


class LeadClass(Opener):
    """The handler of an instructor's page: it gives one that comes back its room, which it opens anew where the server
    has lost it, and obeys its orders."""

    async def get(self, code: str) -> None:
        room = await self.led(code)
        self.reply(self.opened(room.code, self.word))

    async def put(self, code: str) -> None:
        registry, asked = self.classes.registry, self.body(Reopen)
        if not self.context.settings.class_passphrase or not registry.is_own(self.word):
            await self.admit()
        room = await self.outcome(registry.reopen(as_code(code), self.word, asked.control))
        self.reply(self.opened(room.code, self.word))

    async def post(self, code: str) -> None:
        room = await self.led(code)
        order: Order = self.body(Order, LONGEST_ORDER)  # type: ignore[arg-type]  # a union of types
        await self.outcome(self.classes.registry.obey(room, order, str(network_of(self.visitor))))
        self.set_status(204)


class CountAnswers(ClassHandler):
    """The handler of the count of the answers so far."""

    async def get(self, code: str) -> None:
        room = await self.led(code)
        tally: Tally | None = await self.outcome(self.classes.registry.tally(room))
        self.reply(tally)


class CopyAnswers(ClassHandler):
    """The handler of the answers to one vote as an instructor's page keeps them, for a server that loses them."""

    async def get(self, code: str) -> None:
        room = await self.led(code)
        self.reply(await self.outcome(self.classes.registry.copied(room, self.get_query_argument("question", ""))))


class SumUp(ClassHandler):
    """The handler of the summary of a class: each question that was answered, and how many were right."""

    async def get(self, code: str) -> None:
        room = await self.led(code)
        self.reply(await self.outcome(summary(self.classes.registry, room)))


class TakeAnswers(ClassHandler):
    """The handler of all answers of the lecture, as CSV."""

    async def get(self, code: str) -> None:
        room = await self.led(code)
        text = await self.outcome(votes_csv(self.classes.registry, room))
        self.set_header("Content-Type", "text/csv; charset=utf-8")
        self.write(text)
