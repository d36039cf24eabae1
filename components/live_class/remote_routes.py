"""The live class over HTTP for a phone as the instructor's remote control, and for the screen that accepts it."""

from __future__ import annotations

import msgspec

from components.language.class_messages import Confirmed, Done, Moderate, Paired, Reopen, Ticket
from components.live_class.codes import as_code, digest, new_key
from components.live_class.handler import ClassHandler, square
from components.live_class.remote_view import remote_view
from components.live_class.remotes import CONTROL, begun, is_in, new_digits, waits
from components.live_class.room import ClassRoom
from components.serving.handlers import RefusedError

TICKET = 60.0
"""Seconds for which a code accepts a phone."""
NOT_IN = "The lecturer's screen has not confirmed this phone. Press Remote control there for a new code."


class LetIn(ClassHandler):
    """The handler of a ticket, valid once, for a minute. The instructor accepts or rejects the phone, by two digits."""

    async def post(self, code: str) -> None:
        room, ticket = await self.led(code), new_key()
        lent = self.classes.registry.store.lend(_name(room.code), digest(ticket), b"in", TICKET)
        await self.outcome(lent)
        address = self.address(f"?class={room.code}&remote={ticket}")
        self.reply(Ticket(address=address, square=square(address)))

    async def put(self, code: str) -> None:
        room = await self._decided(code, is_in=True)
        self.reply(Reopen(control=room.parts[CONTROL].decode()))

    async def delete(self, code: str) -> None:
        await self._decided(code, is_in=False)
        self.set_status(204)

    async def _decided(self, code: str, is_in: bool) -> ClassRoom:
        room, confirmed = await self.led(code), self.body(Confirmed)
        await self.outcome(self.classes.registry.decide(room, confirmed.digits, is_in))
        return room


class RemoteHandler(ClassHandler):
    """Base handler for the instructor's remote control."""

    async def _there(self, code: str) -> ClassRoom:
        """Return the room of a ticket. The refusal for a wrong ticket does not reveal if the room exists."""
        room = await self.outcome(self.classes.registry.followed(as_code(code), self.word))
        if room is None:
            raise RefusedError(403, NOT_IN)
        self.limit(f"remote {self.word}")
        return room

    async def _let_in(self, code: str) -> ClassRoom:
        room = await self._there(code)
        if not is_in(room.parts, self.word):
            raise RefusedError(403, NOT_IN)
        return room


class RemoteControl(RemoteHandler):
    """The handler of the remote control itself: it shows its ticket, waits to be accepted, then sends orders."""

    async def put(self, code: str) -> None:
        registry, ticket = self.classes.registry, self.body(Ticket)
        if not await self.outcome(registry.store.take(_name(as_code(code)), digest(ticket.address))):
            raise RefusedError(
                403,
                "This code has been used, is older than a minute, or was replaced by a newer one. "
                "The lecturer's screen shows a new one.",
            )
        room = await self.outcome(registry.room(as_code(code)))
        try:
            digits = new_digits(taken=room.waiting)
        except ValueError as reason:
            raise RefusedError(429, str(reason), TICKET) from reason
        paired = Paired(digits=digits, key=registry.token(room))
        await self.outcome(registry.publish(room, begun(digits, paired.key)))
        self.reply(paired)

    async def get(self, code: str) -> None:
        """Reply with the contents if they differ from the shown state, or with null until the phone is accepted."""
        room = await self._there(code)
        if is_in(room.parts, self.word):
            if self.get_query_argument("after", "") == room.number:
                self.set_status(204)
            else:
                self.reply(await self.in_turn(remote_view(self.classes.registry, room)))
        elif waits(room.parts, self.word):
            self.reply(None)
        else:
            raise RefusedError(403, NOT_IN)

    async def post(self, code: str) -> None:
        room, done = await self._let_in(code), self.body(Done)
        if done.deed in ("allow", "remove"):
            order = Moderate(text=done.text, shows=done.deed == "allow")
            await self.outcome(self.classes.registry.obey(room, order))
            self.set_status(204)
            return
        words = {"deed": done.deed} | ({"step": done.step} if done.deed == "go" else {})
        parts = {name: msgspec.json.encode(word) for name, word in words.items()}
        await self.outcome(self.classes.registry.store.publish(room.code, parts))
        self.set_status(204)


class Listing(RemoteHandler):
    """The handler of the contents on a remote control: the steps of the walk with the current question."""

    async def get(self, code: str) -> None:
        room = await self._let_in(code)
        self.reply(self.classes.registry.bank_of(room).listed(room.question.walk))


def _name(code: str) -> str:
    """Return the name under which a room's ticket is stored. A new one replaces the last one."""
    return f"ticket {code}"
