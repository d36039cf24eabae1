"""A room at one replica, and its listeners there."""

from __future__ import annotations

import asyncio
from collections import deque
from secrets import token_hex
from time import monotonic
from typing import Any, Protocol, TypeVar

import msgspec

from components.language.class_messages import News, PutTo, RunClock, SentPicture
from components.live_class.codes import voter_of
from components.live_class.question_bank import QuestionBank, ReadWalks
from components.live_class.remotes import WAITS, waiting
from components.live_class.store import Parts
from components.walks.walk import Walk

SILENCE = 15.0
"""Longest time in seconds without sending anything to a follower."""
ASKED = 5.0
"""Seconds for which a follower without a stream counts as present after a request. Such followers send one each
second."""
NOTHING_PUT = PutTo()
KINDS: dict[str, type] = {"picture": SentPicture, "clock": RunClock, "question": PutTo}
"""The parts of a room that followers get."""
LEADERS = ("deed", "step", "answers")
"""The parts that only the instructor's page gets. The store does not keep them."""
KEPT = 16
"""Number of changes that a page can receive later if it has missed them."""
OBEYED = 10.0
"""Seconds for which an order of a remote control is valid, because a late one would surprise the instructor."""

Kind = TypeVar("Kind")


class RoomListener(Protocol):
    """A listener, which gets the events of a room."""

    @property
    def leads(self) -> bool: ...

    @property
    def name(self) -> str:
        """The name of a follower; two tabs of one browser share it."""

    def receive(self, event: bytes) -> None:
        """Take an event, or leave it out because earlier ones are still being sent."""

    def end(self) -> None: ...


class ClassRoom:
    """A room in this replica."""

    def __init__(self, code: str, parts: Parts) -> None:
        self.code = code
        self.parts: dict[str, bytes] = dict(parts)
        self.listeners: set[RoomListener] = set()
        self.streams: dict[str, list[RoomListener]] = {}
        """The named listeners, by name."""
        self.polls: dict[str, float] = {}
        """Time of the last request of each follower without a stream, by name."""
        self.seen: dict[str, float] = {}
        """Time at which the last stream of each follower began or ended, by name."""
        self.asked = monotonic()
        """Time of the last request for this room."""
        self.here = 0
        self.peak = 0
        """Largest number of followers at one time."""
        self.answered = 0
        """Number of answers to the current question that was last sent to the room."""
        self.recount = False
        """True if answers have arrived since the last count."""
        self.lost = False
        self.missed = 0
        """Number of consecutive times that the store did not have the room."""
        self.unsaved: dict[str, bytes] = {}
        """Parts that are not yet in the store, newer than its own."""
        self.votes: dict[str, Parts] = {}
        self._decoded: dict[str, tuple[bytes, Any]] = {}
        self.bank: tuple[bytes, QuestionBank] | None = None
        """The part with the walks from files, and the question bank that was read from it."""
        self.walks: ReadWalks = {}
        """The walks that were read from files."""
        self.reading: tuple[tuple[str, str], asyncio.Future[Walk]] | None = None
        """The walk from a file that is being read: its name and text, and the future result."""
        self._replica = token_hex(3)
        self._count = 0
        self._own: deque[tuple[float, News]] = deque(maxlen=KEPT)
        self._waiting: tuple[str, ...] = ()
        self._led = 0.0
        """Time of the last request of an instructor's page that has no stream."""

    @property
    def number(self) -> str:
        return f"{self._replica}.{self._count}"

    @property
    def used(self) -> bool:
        """True if the room has a listener, a recent request or unsaved parts."""
        return bool(self.listeners or self.unsaved) or monotonic() - self.asked < 2 * SILENCE

    @property
    def following(self) -> set[str]:
        """The names of the followers, with a stream or with repeated requests."""
        late = monotonic() - ASKED
        asking = (one for one, seen in self.polls.items() if seen > late)
        return {*(listener.name for listener in self.listeners if not listener.leads), *asking}

    @property
    def followers(self) -> int:
        return len(self.following)

    @property
    def names(self) -> set[str]:
        """The names of present and recent followers here. A phone between two streams counts as present."""
        now = monotonic()
        self.polls = {one: seen for one, seen in self.polls.items() if now - seen < 2 * SILENCE}
        self.seen = {one: seen for one, seen in self.seen.items() if now - seen < 2 * SILENCE}
        return {*self.streams, *self.polls, *self.seen}

    @property
    def places(self) -> int:
        """The number of places that are taken here, also by phones that left a moment ago."""
        return len(self.polls) + max(len(self.streams), len(self.seen))

    def follows(self, name: str) -> bool:
        late = monotonic() - 2 * SILENCE
        return name in self.streams or max(self.polls.get(name, 0.0), self.seen.get(name, 0.0)) > late

    def voter(self, token: str) -> str:
        """Return the name of a follower by a token of this room, or "" for any other text."""
        return voter_of(token, self.parts.get("key", b""))

    @property
    def is_led(self) -> bool:
        """True if an instructor's page is here; it keeps the room alive, and restores it if the store loses it."""
        return monotonic() - self._led < 2 * SILENCE or any(listener.leads for listener in self.listeners)

    @property
    def waiting(self) -> tuple[str, ...]:
        """The digits of remote controls that wait to be let in."""
        return tuple(waiting(self.parts))

    def part(self, name: str, kind: type[Kind]) -> Kind | None:
        """Return the current value of a part, decoded only once."""
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
        """Record a request of a member without a stream."""
        if leads:
            self._led = monotonic()
        else:
            self.polls[name_of(word)] = monotonic()

    def news_after(self, number: str) -> list[News]:
        """Return the news only for the instructor's page since a state that it knows."""
        replica, _, count = number.partition(".")
        if replica != self._replica or not count.isdecimal():
            return []
        late = monotonic() - OBEYED
        missed = [own for at, own in self._own if at > late or not own.deed]
        return [own for own in missed if int(own.number.partition(".")[2]) > int(count)]

    def deliver(self, parts: Parts) -> None:
        """Store new parts, and send them as one encoded event to everyone in the room."""
        self._count += 1
        self.recount = self.recount or bool({"answers", "question"} & parts.keys())
        if "question" in parts:
            self.answered = 0  # until they are counted
        self.parts |= {name: part for name, part in parts.items() if name not in (*LEADERS, "by")}
        known: dict[str, Any] = {name: self.part(name, kind) for name, kind in KINDS.items() if name in parts}
        if known:
            self.say(News(number=self.number, **known))
        if own := {name: parts[name] for name in LEADERS if name in parts}:
            fields = {name: msgspec.json.decode(part) for name, part in own.items()}
            if "answers" in own:  # only the last count matters, but no order may be lost
                self._own = deque((one for one in self._own if not one[1].answers), KEPT)
            news = msgspec.convert({"number": self.number, **fields}, News)
            self._own.append((monotonic(), news))
            self.say(news, leaders=True)
        if any(name.startswith(WAITS) for name in parts):
            self._say_waiting()

    def look(self) -> None:
        """Send changes that only time causes, for example that a phone has stopped waiting."""
        if self.waiting != self._waiting:
            self._count += 1
            self._say_waiting()

    def change(self, **facts: Any) -> None:
        """Set facts about the room, `here`, `answered` or `lost`, and send them to everyone in it."""
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
                listener.receive(event)

    def end(self) -> None:
        """End the class for everyone in the room."""
        self.say(News(number=self.number, ended=True))
        for listener in list(self.listeners):
            listener.end()


def name_of(word: str) -> str:
    """Return the name of a follower in a token; a key is its own name."""
    return word.partition(".")[0]


def as_event(news: News) -> bytes:
    return b"data: " + msgspec.json.encode(news) + b"\n\n"
