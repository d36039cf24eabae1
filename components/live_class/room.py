"""A room as one replica knows it, and who of those here hears of it."""

from __future__ import annotations

import asyncio
from collections import deque
from secrets import token_hex
from time import monotonic
from typing import Any, Protocol, TypeVar

import msgspec

from components.language.room import News, PutTo, RunClock, SentPicture
from components.live_class.codes import voter_of
from components.live_class.question_bank import QuestionBank, ReadWalks
from components.live_class.remotes import WAITS, waiting
from components.live_class.store import Parts
from components.walks.walk import Walk

SILENCE = 15.0
"""Seconds after which those who follow hear something, whatever happens."""
ASKED = 5.0
"""Seconds for which somebody who asks, once a second without a stream, is counted."""
NOTHING_PUT = PutTo()
KINDS: dict[str, type] = {"picture": SentPicture, "clock": RunClock, "question": PutTo}
"""The parts that followers hear of."""
LEADERS = ("deed", "step", "answers")
"""The parts that the instructor's page alone hears of, as they come; the store keeps nothing of them."""
KEPT = 16
"""Of which so many are told once more to a page that has missed them."""
OBEYED = 10.0
"""Seconds for which a deed is worth doing: to a page that was away longer it would come out of nowhere."""

Kind = TypeVar("Kind")


class RoomListener(Protocol):
    """A listener: somebody who hears what is told of a room."""

    @property
    def leads(self) -> bool: ...

    @property
    def name(self) -> str:
        """The name of a follower, of whom two tabs are one."""

    def hear(self, event: bytes) -> bool:
        """Take an event; False where earlier ones are still on their way, so that this one is left out."""

    def end(self) -> None: ...


class ClassRoom:
    """A room as this replica knows it."""

    def __init__(self, code: str, parts: Parts) -> None:
        self.code = code
        self.parts: dict[str, bytes] = dict(parts)
        self.listeners: set[RoomListener] = set()
        self.streams: dict[str, list[RoomListener]] = {}
        """The listeners that have a name, by that name."""
        self.polls: dict[str, float] = {}
        """When each of those who have no stream has asked last, by name."""
        self.seen: dict[str, float] = {}
        """When each stream has begun or ended, by the name of who had it."""
        self.asked = monotonic()
        """When somebody has asked for it last."""
        self.here = 0
        self.peak = 0
        """The most that have been here at once."""
        self.answered = 0
        """The number of answers to the question that is put, as those who are here were told it."""
        self.recount = False
        """Whether answers have come since they were counted."""
        self.lost = False
        self.missed = 0
        """The times in a row that it was not found in the store."""
        self.unsaved: dict[str, bytes] = {}
        """Parts that the store has not taken as yet: newer than what it has."""
        self.votes: dict[str, Parts] = {}
        self._decoded: dict[str, tuple[bytes, Any]] = {}
        self.bank: tuple[bytes, QuestionBank] | None = None
        """The questions of walks from files, beside the part that they were read from."""
        self.walks: ReadWalks = {}
        """Walks from files, as they were read."""
        self.reading: tuple[tuple[str, str], asyncio.Future[Walk]] | None = None
        """The walk from a file that is being read for it: its name and text, and what it will be."""
        self._replica = token_hex(3)
        self._count = 0
        self._own: deque[tuple[float, News]] = deque(maxlen=KEPT)
        self._waiting: tuple[str, ...] = ()
        self._led = 0.0
        """When a page of the instructor's that has no stream has asked last."""

    @property
    def number(self) -> str:
        return f"{self._replica}.{self._count}"

    @property
    def used(self) -> bool:
        """Whether anybody is in it, or on the way: one who asks now and then, or whose stream has not begun; or
        something that is not saved."""
        return bool(self.listeners or self.unsaved) or monotonic() - self.asked < 2 * SILENCE

    @property
    def following(self) -> set[str]:
        """The names of those who follow, by a stream or by asking."""
        late = monotonic() - ASKED
        asking = (one for one, seen in self.polls.items() if seen > late)
        return {*(listener.name for listener in self.listeners if not listener.leads), *asking}

    @property
    def followers(self) -> int:
        return len(self.following)

    @property
    def names(self) -> set[str]:
        """The names of those who follow here, or have until a moment ago: a phone between two streams is not gone."""
        now = monotonic()
        self.polls = {one: seen for one, seen in self.polls.items() if now - seen < 2 * SILENCE}
        self.seen = {one: seen for one, seen in self.seen.items() if now - seen < 2 * SILENCE}
        return {*self.streams, *self.polls, *self.seen}

    @property
    def places(self) -> int:
        """The number of places that are taken here: those of phones that were here a moment ago count."""
        return len(self.polls) + max(len(self.streams), len(self.seen))

    def follows(self, name: str) -> bool:
        late = monotonic() - 2 * SILENCE
        return name in self.streams or max(self.polls.get(name, 0.0), self.seen.get(name, 0.0)) > late

    def voter(self, token: str) -> str:
        """The name of a follower by a token of this room; "" for what is none."""
        return voter_of(token, self.parts.get("key", b""))

    @property
    def is_led(self) -> bool:
        """Whether a page of the instructor's is here: it keeps the room alive, and a store that forgot it hears it
        anew."""
        return monotonic() - self._led < 2 * SILENCE or any(listener.leads for listener in self.listeners)

    @property
    def waiting(self) -> tuple[str, ...]:
        """The digits of remote controls that wait to be let in."""
        return tuple(waiting(self.parts))

    def part(self, name: str, kind: type[Kind]) -> Kind | None:
        """A part as it is now; decoded once, however many ask."""
        part = self.parts.get(name)
        if part is None:
            return None
        known = self._decoded.get(name)
        if known is None or known[0] is not part:
            known = self._decoded[name] = part, msgspec.json.decode(part, type=kind)
        return known[1]

    @property
    def question(self) -> PutTo:
        return self.part("question", PutTo) or NOTHING_PUT

    @property
    def own(self) -> dict[str, str]:
        """Walks from the instructor's files: their texts by name."""
        return self.part("walks", dict[str, str]) or {}

    def whole(self, leads: bool = False) -> News:
        known: dict[str, Any] = {name: self.part(name, kind) for name, kind in KINDS.items()}
        remotes = self.waiting if leads else None
        known |= {"here": self.here, "answered": self.answered}
        return News(number=self.number, lost=self.lost, remotes=remotes, **known)

    def polled(self, word: str, leads: bool) -> None:
        """Somebody asks who has no stream."""
        if leads:
            self._led = monotonic()
        else:
            self.polls[name_of(word)] = monotonic()

    def untold(self, number: str) -> list[News]:
        """The news for the instructor's page alone since a state that it knows."""
        replica, _, count = number.partition(".")
        if replica != self._replica or not count.isdecimal():
            return []
        late = monotonic() - OBEYED
        missed = [own for at, own in self._own if at > late or not own.deed]
        return [own for own in missed if int(own.number.partition(".")[2]) > int(count)]

    def tell(self, parts: Parts) -> None:
        """Take new parts in, and tell all who are here: one encoded event, the same for all."""
        self._count += 1
        self.recount = self.recount or bool({"answers", "question"} & parts.keys())
        if "question" in parts:
            self.answered = 0  # until they are counted
        self.parts |= {name: part for name, part in parts.items() if name not in (*LEADERS, "by")}
        known: dict[str, Any] = {name: self.part(name, kind) for name, kind in KINDS.items() if name in parts}
        if known:
            self.say(News(number=self.number, **known))
        if own := {name: parts[name] for name in LEADERS if name in parts}:
            told = {name: msgspec.json.decode(part) for name, part in own.items()}
            if "answers" in own:  # they are counted anew: of many, the last says as much, and no deed makes way
                self._own = deque((one for one in self._own if not one[1].answers), KEPT)
            news = msgspec.convert({"number": self.number, **told}, News)
            self._own.append((monotonic(), news))
            self.say(news, leaders=True)
        if any(name.startswith(WAITS) for name in parts):
            self._say_waiting()

    def look(self) -> None:
        """Say what changes by itself: a phone waits no longer."""
        if self.waiting != self._waiting:
            self._count += 1
            self._say_waiting()

    def change(self, **facts: Any) -> None:
        """Tell all who are here, those without a stream too, how it stands with the room itself: `here`,
        `answered`, `lost`."""
        self._count += 1
        for name, fact in facts.items():
            setattr(self, name, fact)
        self.peak = max(self.peak, self.here)
        self.say(News(number=self.number, **facts))

    def _say_waiting(self) -> None:
        self._waiting = self.waiting
        self.say(News(number=self.number, remotes=self._waiting), leaders=True)

    def say(self, news: News, leaders: bool = False) -> None:
        event = as_event(news)
        for listener in list(self.listeners):
            if listener.leads or not leaders:
                listener.hear(event)

    def end(self) -> None:
        """The class is over."""
        self.say(News(number=self.number, ended=True))
        for listener in list(self.listeners):
            listener.end()


def name_of(word: str) -> str:
    """The name of a follower in a token; a key is its own."""
    return word.partition(".")[0]


def as_event(news: News) -> bytes:
    return b"data: " + msgspec.json.encode(news) + b"\n\n"
