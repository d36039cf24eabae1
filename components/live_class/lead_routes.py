"""The live class over HTTP: moves the lead from one computer to another, by a word that is read from the first."""

from __future__ import annotations

import msgspec

from components.language.class_messages import HandOver, TakenOver, TakeOver, Ticket
from components.live_class.codes import as_code, digest, new_word
from components.live_class.follower_routes import MINUTE, MISSES, TOO_MANY
from components.live_class.handler import ClassHandler
from components.live_class.instructor_routes import LONGEST_ORDER
from components.live_class.remotes import CONTROL
from components.serving.handlers import LectureHandler, RefusedError
from components.serving.visitors import network_of

MOMENT = 120.0
"""Seconds for which a word is valid."""
NO_WORD = (
    "This key has been used, is older than two minutes, or was replaced by a newer one. "
    "The computer that leads the class shows a new one."
)


class Lent(msgspec.Struct, frozen=True):
    """The stored lead of a class, until another computer takes it with the word."""

    key: str
    query: str
    shown: dict[str, int]


class PassLead(ClassHandler):
    """The handler of the word with which another computer takes the lead. It is given to the leading page and can be
    used once.
    """

    async def post(self, code: str) -> None:
        room, asked = await self.led(code), self.body(HandOver, LONGEST_ORDER)
        word, lent = new_word(), msgspec.json.encode(Lent(self.word, asked.query, asked.shown))
        await self.outcome(self.classes.registry.store.lend(_name(room.code), digest(word), lent, MOMENT))
        self.reply(Ticket(address=self.address(f"{room.code}-{word}")))

    async def put(self, code: str) -> None:
        store, miss = self.classes.registry.store, f"miss {network_of(self.visitor)}"
        if await self.outcome(store.count(miss, MINUTE, 0)) >= MISSES:
            raise RefusedError(429, TOO_MANY, MINUTE)
        kept = await self.outcome(store.take(_name(as_code(code)), digest(self.body(TakeOver).word.upper())))
        if not kept:
            await self.outcome(store.count(miss, MINUTE))
            raise RefusedError(403, NO_WORD)
        lent = msgspec.json.decode(kept, type=Lent)
        room = await self.outcome(self.classes.registry.led(as_code(code), lent.key))
        await self.outcome(store.publish(room.code, {"deed": b'"taken"'}))
        opened = msgspec.structs.asdict(self.opened(room.code, lent.key))
        control = room.parts.get(CONTROL, b"").decode()
        self.reply(TakenOver(query=lent.query, shown=lent.shown, walks=room.own, control=control, **opened))


class MovedByWord(LectureHandler):
    """The handler of an address with code and word, such as lecture.example/EUW5-7K2M9XQP."""

    def get(self, code: str, word: str) -> None:
        self.redirect(
            f"./?class={code.upper()}&lead={word.upper()}"
        )  # relative, because a proxy may serve the lecture under a path

    head = get


def _name(code: str) -> str:
    """Return the name under which a room's lead is stored. A new word replaces the last one."""
    return f"lead {code}"
