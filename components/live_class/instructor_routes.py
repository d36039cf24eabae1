"""The live class over HTTP, as its instructor's page uses it: a room is opened, led, counted, and ended."""

from __future__ import annotations

from urllib.parse import unquote

from components.language.room import Order, Tally
from components.live_class.codes import digest, is_key
from components.live_class.handler import ClassHandler
from components.live_class.store import ALONE
from components.live_class.votes_csv import votes_csv
from components.serving.handlers import RefusedError
from components.serving.visitors import network_of

LONGEST_ORDER = 64_000
"""Bytes of a message from the instructor's page, which may hand over a walk's file."""
MOST_OPENED = 100
"""Rooms that one network may open in the time for which one lives alone."""

ASKED = "Opening a class here needs the instructors' passphrase."
WRONG = "This is not the instructors' passphrase. Whoever runs this server has set it."


class OpenClass(ClassHandler):
    """The handler that opens a room."""

    async def post(self) -> None:
        phrase = self.context.settings.class_passphrase
        if not phrase or not is_key(unquote(self.word), digest(phrase)):  # who knows it waits for nobody who does not
            await self._admit()
            if phrase:
                raise RefusedError(401, WRONG if self.word else ASKED)
        self.reply(self.opened(*await self.outcome(self.classes.registry.open())))

    async def _admit(self) -> None:
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


class LeadClass(ClassHandler):
    """The handler of an instructor's page: it gives one that comes back its room, and obeys its orders."""

    async def get(self, code: str) -> None:
        room = await self.led(code)
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


class TakeAnswers(ClassHandler):
    """The handler of all answers of the lecture, as CSV."""

    async def get(self, code: str) -> None:
        room = await self.led(code)
        text = await self.outcome(votes_csv(self.classes.registry, room))
        self.set_header("Content-Type", "text/csv; charset=utf-8")
        self.write(text)
