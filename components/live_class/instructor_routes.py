"""The live class over HTTP for its instructor's page: opens a room, leads it, counts answers, ends it."""

from __future__ import annotations

from urllib.parse import unquote

from components.language.class_messages import Order, Reopen, RestoreAnswers, ShowAnswer, Tally
from components.live_class.codes import as_code, digest, is_key
from components.live_class.handler import ClassHandler
from components.live_class.store import ALONE
from components.live_class.summary import stored, summary
from components.live_class.votes_csv import votes_csv
from components.serving.handlers import RefusedError
from components.serving.visitors import network_of

LONGEST_ORDER = 64_000
"""Bytes of a message from the instructor's page, which may contain a walk's file."""
MOST_OPENED = 100
"""Rooms that one network may open in the time after which an unused room ends."""
ROWS = 100
"""Rows of a table that are sent together."""

ASKED = "Opening a class here needs the instructors' passphrase."
WRONG = "This is not the instructors' passphrase. Ask the operator of this server for it."


class Opener(ClassHandler):
    """Base handler of handlers that open rooms; limits their number for each network."""

    async def admit(self) -> str:
        """Count a room for the visitor's network. Return the network, which owns the room."""
        network = str(network_of(self.visitor))
        if seconds := self.classes.openings.admit(self.visitor):
            raise RefusedError(
                429, "Many classes were opened from this network just now. Try again in a moment.", seconds
            )
        if await self.outcome(self.classes.registry.store.count(f"opened {network}", ALONE)) > MOST_OPENED:
            raise RefusedError(
                429,
                f"{MOST_OPENED} classes were opened from this network. Try again in {ALONE / 60:.0f} minutes.",
                ALONE,
            )
        return network


class OpenClass(Opener):
    """The handler that opens a room."""

    async def post(self) -> None:
        phrase, owner = self.context.settings.class_passphrase, ""
        # The limit on wrong passphrases does not delay a visitor with the right one.
        if not phrase or not is_key(unquote(self.word), digest(phrase)):
            owner = await self.admit()
            if phrase:
                raise RefusedError(401, WRONG if self.word else ASKED)
        self.reply(self.opened(*await self.outcome(self.classes.registry.open(owner))))


class LeadClass(Opener):
    """The handler of an instructor's page. It executes orders, and gives a returning page its room, which it opens
    again if the server has lost it.
    """

    async def get(self, code: str) -> None:
        room = await self.led(code)
        self.reply(self.opened(room.code, self.word))

    async def put(self, code: str) -> None:
        registry, asked, owner = self.classes.registry, self.body(Reopen), ""
        if not self.context.settings.class_passphrase or not registry.is_own(self.word):
            owner = await self.admit()
        room = await self.outcome(registry.reopen(as_code(code), self.word, asked.control, owner))
        self.reply(self.opened(room.code, self.word))

    async def post(self, code: str) -> None:
        room = await self.led(code)
        order: Order = self.body(Order, LONGEST_ORDER)  # type: ignore[arg-type]  # a union of types
        obey = self.in_turn if isinstance(order, RestoreAnswers | ShowAnswer) else self.outcome
        await obey(self.classes.registry.obey(room, order, str(network_of(self.visitor))))
        self.set_status(204)


class CountAnswers(ClassHandler):
    """The handler of the count of the answers so far."""

    async def get(self, code: str) -> None:
        room = await self.led(code)
        tally: Tally | None = await self.in_turn(self.classes.registry.tally(room))
        self.reply(tally)


class CopyAnswers(ClassHandler):
    """The handler of the answers to one vote, for the copies that the instructor's page keeps in case a server loses
    them.
    """

    async def get(self, code: str) -> None:
        room = await self.led(code)
        self.reply(await self.in_turn(self.classes.registry.copied(room, self.get_query_argument("question", ""))))


class SumUp(ClassHandler):
    """The handler of the summary of a class: each question with the number of answers and of right answers."""

    async def get(self, code: str) -> None:
        room = await self.led(code)
        self.reply(await self.in_turn(summary(self.classes.registry, room)))


class CountStored(ClassHandler):
    """The handler of the number of answers that the end of the class deletes."""

    async def get(self, code: str) -> None:
        room = await self.led(code)
        self.reply(await self.in_turn(stored(self.classes.registry, room)))


class TakeAnswers(ClassHandler):
    """The handler of all answers of the lecture, as CSV."""

    async def get(self, code: str) -> None:
        room = await self.led(code)
        pieces = await self.in_turn(votes_csv(self.classes.registry, room))
        self.set_header("Content-Type", "text/csv; charset=utf-8")
        for i in range(0, len(pieces), ROWS):
            self.write("".join(pieces[i : i + ROWS]))
            await self.flush()
