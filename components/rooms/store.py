"""Where rooms are kept: an interface, and the one that keeps them in the memory of a single process."""

from __future__ import annotations

from abc import ABC, abstractmethod
from asyncio import Event
from collections.abc import Callable, Mapping
from time import monotonic
from typing import NamedTuple

LIFE = 4 * 3600.0
"""Seconds after the last sign of its instructor, after which a room ends."""
MOST_ROOMS = 500
MOST_VOTES = 5000
"""Answers to one vote."""
SEEN = 30.0
"""Seconds for which a replica's word on how many follow it holds."""

Parts = Mapping[str, bytes]
"""A room by the names of its parts."""
Hear = Callable[[str, Parts], None]
"""What is called with the code of a room and the parts of it that are new; with none where the room has ended."""


class AwayError(Exception):
    """The store does not answer."""


class Store(ABC):
    """Rooms under their codes. A room that is not there has no parts, and nothing can be kept in it."""

    @abstractmethod
    async def open(self, code: str, parts: Parts) -> bool:
        """A new room; False where there is one of that code, or no place for any."""

    @abstractmethod
    async def parts(self, code: str) -> Parts: ...

    @abstractmethod
    async def keep(self, code: str, parts: Parts) -> bool:
        """Parts that take the place of those of their names, a sign of the instructor (also without any): all who
        listen are told, and the room lives on. False where it is not there."""

    @abstractmethod
    async def tell(self, code: str, parts: Parts) -> None:
        """Tell all who listen, and keep nothing."""

    @abstractmethod
    async def end(self, code: str) -> None:
        """Forget the room and all answers; who listens is told no parts."""

    @abstractmethod
    async def vote(self, code: str, question: str, voter: str, answer: bytes) -> bool:
        """Keep an answer in place of the voter's last to the same question; False where there is no place for it."""

    @abstractmethod
    async def votes(self, code: str, question: str) -> Parts:
        """The answers by their voters."""

    @abstractmethod
    async def questions(self, code: str) -> list[str]:
        """Those that have been answered, in the order of their first answers."""

    @abstractmethod
    async def present(self, code: str, replica: str, count: int) -> int:
        """Note how many follow a replica, and how many follow in all."""

    @abstractmethod
    async def count(self, name: str, seconds: float, more: int = 1) -> int:
        """How often something has happened in this span of so many seconds, at all replicas, with `more` of it now."""

    @abstractmethod
    async def lend(self, name: str, value: bytes, seconds: float) -> None:
        """Keep something that can be taken once, for a while."""

    @abstractmethod
    async def take(self, name: str) -> bytes: ...

    @abstractmethod
    async def listen(self, hear: Hear, ready: Callable[[], None]) -> None:
        """Tell of all that is kept and told from the moment on that `ready` is called; AwayError when that ends."""

    @abstractmethod
    async def close(self) -> None:
        """Let go of connections."""


class _Kept(NamedTuple):
    value: bytes
    until: float


class MemoryStore(Store):
    """For one process, with nothing installed."""

    def __init__(self, life: float = LIFE, rooms: int = MOST_ROOMS, clock: Callable[[], float] = monotonic) -> None:
        self._life = life
        self._most = rooms
        self._clock = clock
        self._rooms: dict[str, dict[str, bytes]] = {}
        self._ends: dict[str, float] = {}
        self._votes: dict[str, dict[str, dict[str, bytes]]] = {}
        self._here: dict[str, dict[str, tuple[int, float]]] = {}
        self._counts: dict[tuple[str, int], int] = {}
        self._lent: dict[str, _Kept] = {}
        self._ears: list[Hear] = []

    async def open(self, code: str, parts: Parts) -> bool:
        self._forget()
        if code in self._rooms or len(self._rooms) >= self._most:
            return False
        self._rooms[code] = dict(parts)
        self._votes[code] = {}
        self._ends[code] = self._clock() + self._life
        return True

    async def parts(self, code: str) -> Parts:
        self._forget()
        return dict(self._rooms.get(code, {}))

    async def keep(self, code: str, parts: Parts) -> bool:
        self._forget()
        if code not in self._rooms:
            return False
        self._rooms[code].update(parts)
        self._ends[code] = self._clock() + self._life
        if parts:
            await self.tell(code, parts)
        return True

    async def tell(self, code: str, parts: Parts) -> None:
        for hear in self._ears:
            hear(code, parts)

    async def end(self, code: str) -> None:
        for kept in (self._rooms, self._ends, self._votes, self._here):
            kept.pop(code, None)
        await self.tell(code, {})

    async def vote(self, code: str, question: str, voter: str, answer: bytes) -> bool:
        self._forget()
        if code not in self._rooms:
            return False
        answers = self._votes[code].setdefault(question, {})
        if voter not in answers and len(answers) >= MOST_VOTES:
            return False
        answers[voter] = answer
        return True

    async def votes(self, code: str, question: str) -> Parts:
        return dict(self._votes.get(code, {}).get(question, {}))

    async def questions(self, code: str) -> list[str]:
        return list(self._votes.get(code, {}))

    async def present(self, code: str, replica: str, count: int) -> int:
        now = self._clock()
        here = self._here.setdefault(code, {}) if code in self._rooms else {}
        here[replica] = count, now + SEEN
        return sum(number for number, until in here.values() if until > now)

    async def count(self, name: str, seconds: float, more: int = 1) -> int:
        now = self._clock()
        span = name, int(now // seconds)
        if len(self._counts) > 10_000:
            self._counts.clear()  # lets a few more happen, and no more than that
        self._counts[span] = self._counts.get(span, 0) + more
        return self._counts[span]

    async def lend(self, name: str, value: bytes, seconds: float) -> None:
        self._lent = {other: kept for other, kept in self._lent.items() if kept.until > self._clock()}
        self._lent[name] = _Kept(value, self._clock() + seconds)

    async def take(self, name: str) -> bytes:
        kept = self._lent.pop(name, None)
        return kept.value if kept and kept.until > self._clock() else b""

    async def listen(self, hear: Hear, ready: Callable[[], None]) -> None:
        self._ears.append(hear)
        ready()
        try:
            await Event().wait()
        finally:
            self._ears.remove(hear)

    async def close(self) -> None:
        self._rooms.clear()

    def _forget(self) -> None:
        """Rooms whose instructor has given no sign for so long."""
        now = self._clock()
        for code in [code for code, end in self._ends.items() if end <= now]:
            for kept in (self._rooms, self._ends, self._votes, self._here):
                kept.pop(code, None)
            for hear in self._ears:
                hear(code, {})
