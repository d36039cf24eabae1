"""Stores of rooms: the interface, and a store in the memory of a single process."""

from __future__ import annotations

from abc import ABC, abstractmethod
from asyncio import Event
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from time import monotonic, time
from typing import NamedTuple

LIFE = 4 * 3600.0
"""Seconds from the last sign of its instructor to the end of a room, even if phones still follow."""
ALONE = 20 * 60.0
"""Seconds after which a room without instructor and followers ends; a break in a lecture is shorter."""
QUIET = 60.0
"""Seconds without a sign after which a room may be replaced by another, if all places are taken."""
MOST_ROOMS = 500
MOST_VOTES = 5000
"""Maximum number of answers to one vote."""
MOST_BYTES = 8 * 2**20
"""Maximum number of bytes of one room: thousands of sketches."""
ALL_BYTES = 44 * 2**20
"""Maximum number of bytes of all rooms. The store of compose.yaml has 64 MB, and needs the rest for other data."""
RESERVE = 12 * 2**20
"""Bytes of `ALL_BYTES` that answers cannot use, because pictures and questions need them."""
OF_AN_ANSWER = 160
"""Overhead of an answer in a store, in bytes; measured: 80 in Valkey, 122 in memory."""
OF_A_VOTE = 400
"""Bytes that a store needs for the first answer to a vote; 390 were measured in Valkey."""
OWNER = "owner"
"""The part of a room with its owner, the network that opened it. The bytes of a room count towards the share of its
owner."""
MOST_COUNTS = 20_000
"""Largest number of events, by name, that are counted at the same time (see `Store.count`)."""
SLOTS = 12
"""Number of parts into which a time span is divided to count events. An event expires at most one part too late."""
SEEN = 30.0
"""Seconds for which a replica's count of its followers is valid."""

Parts = Mapping[str, bytes]
"""The data of a room: its parts by name."""
Receive = Callable[[str, Parts], None]
"""A listener to the store: called with the code of a room and its new parts, or with no parts if the room has ended."""


class UnreachableError(Exception):
    """A refusal because the store does not answer."""


class FullError(ValueError):
    """A refusal because a limit is reached; the sentence says which one."""


OF_A_ROOM = "The server cannot store more answers of this class. It keeps the earlier ones."
OF_THE_STORE = "The memory for live classes is full: changes do not reach everybody until a class ends."
OF_COUNTS = "Too many networks are counted."


def size_of(parts: Parts) -> int:
    """Return the number of bytes that parts of a room take."""
    return sum(len(name) + len(part) for name, part in parts.items())


def slot_of(now: float, seconds: float) -> int:
    """Return the number of the slot in which a time lies; a span of so many seconds has `SLOTS` slots."""
    return int(now * SLOTS // seconds)


class Store(ABC):
    """Rooms under their codes. A room that does not exist has no parts, and nothing can be stored in it.

    The bytes of all rooms are limited. The rooms of one owner may grow as long as they take no more bytes than are free
    afterwards, so that no owner can take everything. `OWNER` is the part that names the owner of a room; a
    room without it has a separate share.
    """

    @abstractmethod
    async def open(self, code: str, parts: Parts) -> bool:
        """Open a room, in place of an abandoned one if all are taken. Return False if the code is taken or there is no
        place."""

    @abstractmethod
    async def parts(self, code: str) -> Parts: ...

    @abstractmethod
    async def keep(self, code: str, parts: Parts) -> bool:
        """Replace parts of a room and send them to all listeners. Even without parts this is a sign of the instructor,
        which keeps the room alive. Return False if there is no such room. Raises FullError if the parts are too large
        for the share of its owner."""

    @abstractmethod
    async def publish(self, code: str, parts: Parts) -> None:
        """Send parts to all listeners without storing them."""

    @abstractmethod
    async def end(self, code: str) -> None:
        """Delete the room and all answers; listeners get an update without parts."""

    @abstractmethod
    async def rooms(self) -> int:
        """The number of rooms."""

    @abstractmethod
    async def vote(
        self, code: str, question: str, voter: str, answer: bytes, most: int = MOST_VOTES, replace: bool = True
    ) -> bool:
        """Store an answer; it replaces the voter's last one to the same question only if `replace`. Return False if
        there are `most` already. Raises FullError if the room, or its owner, has too many bytes."""

    @abstractmethod
    async def unvote(self, code: str, question: str, voter: str) -> None:
        """Delete an answer."""

    @abstractmethod
    async def votes(self, code: str, question: str) -> Parts:
        """Return the answers by their voters."""

    @abstractmethod
    async def questions(self, code: str) -> list[str]:
        """Return the questions that have been answered, in the order of their first answers."""

    @abstractmethod
    async def present(self, code: str, replica: str, names: Collection[str]) -> int:
        """Record the followers at a replica. Return the number at all replicas; a phone at two of them counts once.
        Followers keep the room alive."""

    @abstractmethod
    async def name(self, code: str, replica: str, names: Collection[str]) -> None:
        """Record the names of present and recent followers at a replica."""

    @abstractmethod
    async def named(self, code: str) -> set[str]:
        """Return the names of the followers at all replicas."""

    @abstractmethod
    async def count(self, name: str, seconds: float, more: int = 1) -> int:
        """Add `more` to the count of an event; return its count in the last so many seconds, at all replicas.

        An event expires after this time, or at most a twelfth of it later. Raises UnreachableError if too many names
        are counted already, because the count is then unknown.
        """

    @abstractmethod
    async def lend(self, name: str, key: bytes, value: bytes, seconds: float) -> None:
        """Store a value under a name for some seconds, in place of an earlier one. It can be taken once, with the
        key."""

    @abstractmethod
    async def take(self, name: str, key: bytes) -> bytes:
        """Remove and return the value of a name; b"" if there is none or the key is wrong."""

    @abstractmethod
    async def time(self) -> float:
        """Return the time of the store's clock, with which replicas compare theirs, in seconds since 1970."""

    @abstractmethod
    async def listen(self, receive: Receive, ready: Callable[[], None]) -> None:
        """Call `receive` with all updates after the call of `ready`. Raises UnreachableError when the updates end."""

    @abstractmethod
    async def close(self) -> None:
        """Close the connections."""


class _Lent(NamedTuple):
    key: bytes
    value: bytes
    until: float


@dataclass
class _Count:
    until: float
    slots: dict[int, int] = field(default_factory=dict)
    """The number of events in each part of the span."""


@dataclass
class _Room:
    parts: dict[str, bytes]
    led: float
    """Time until which the room exists without another sign of its instructor."""
    ends: float
    votes: dict[str, dict[str, bytes]] = field(default_factory=dict)
    here: dict[str, tuple[Collection[str], float]] = field(default_factory=dict)
    names: dict[str, set[str]] = field(default_factory=dict)
    size: int = 0
    """Bytes of its parts and answers."""


class MemoryStore(Store):
    """A store in the memory of one process."""

    def __init__(
        self,
        life: float = LIFE,
        rooms: int = MOST_ROOMS,
        clock: Callable[[], float] = monotonic,
        alone: float = ALONE,
        size: int = MOST_BYTES,
        counts: int = MOST_COUNTS,
    ) -> None:
        self._life, self._alone = life, min(alone, life)
        self._most, self._size, self._most_counts = rooms, size, counts
        self._clock = clock
        self._rooms: dict[str, _Room] = {}
        self._counts: dict[str, _Count] = {}
        self._counts_looked = 0.0
        self._lent: dict[str, _Lent] = {}
        self._listeners: list[Receive] = []

    async def open(self, code: str, parts: Parts) -> bool:
        self._forget()
        now = self._clock()
        if len(self._rooms) >= self._most:
            quietest = min(self._rooms, key=lambda one: self._rooms[one].ends)
            if self._rooms[quietest].ends <= now + self._alone - QUIET:
                del self._rooms[quietest]
        if code in self._rooms or len(self._rooms) >= self._most:
            return False
        self._rooms[code] = _Room(dict(parts), now + self._life, now + self._alone, size=size_of(parts))
        return True

    async def parts(self, code: str) -> Parts:
        self._forget()
        return dict(self._rooms[code].parts) if code in self._rooms else {}

    async def keep(self, code: str, parts: Parts) -> bool:
        self._forget()
        if code not in self._rooms:
            return False
        room, now = self._rooms[code], self._clock()
        more = size_of(parts) - size_of({name: room.parts[name] for name in parts if name in room.parts})
        if self._exceeds_share(code, more, ALL_BYTES):
            raise FullError(OF_THE_STORE)
        room.size += more
        room.parts.update(parts)
        room.led, room.ends = now + self._life, now + self._alone
        if parts:
            await self.publish(code, parts)
        return True

    async def publish(self, code: str, parts: Parts) -> None:
        for receive in self._listeners:
            receive(code, parts)

    async def end(self, code: str) -> None:
        self._rooms.pop(code, None)
        await self.publish(code, {})

    async def rooms(self) -> int:
        self._forget()
        return len(self._rooms)

    async def vote(
        self, code: str, question: str, voter: str, answer: bytes, most: int = MOST_VOTES, replace: bool = True
    ) -> bool:
        self._forget()
        if code not in self._rooms:
            return False
        room = self._rooms[code]
        answers = room.votes.get(question, {})
        if voter in answers and not replace:
            return True
        if voter not in answers and len(answers) >= most:
            return False
        more = self._cost(answer) - self._cost(answers.get(voter)) + (0 if question in room.votes else OF_A_VOTE)
        if room.size + more > self._size or self._exceeds_share(code, more, ALL_BYTES - RESERVE):
            raise FullError(OF_A_ROOM)
        room.size += more
        room.votes.setdefault(question, answers)[voter] = answer
        return True

    @staticmethod
    def _cost(answer: bytes | None) -> int:
        return 0 if answer is None else len(answer) + OF_AN_ANSWER

    def _exceeds_share(self, code: str, more: int, limit: int) -> bool:
        """Return True if a room's owner cannot have so many more bytes, because its rooms would exceed the free
        memory."""
        if more <= 0:
            return False
        owner = self._rooms[code].parts.get(OWNER)
        own = [room for each, room in self._rooms.items() if each == code or (owner and room.parts.get(OWNER) == owner)]
        taken = sum(room.size for room in self._rooms.values())
        return sum(room.size for room in own) + more > limit - taken

    async def unvote(self, code: str, question: str, voter: str) -> None:
        if code in self._rooms:
            room = self._rooms[code]
            room.size -= self._cost(room.votes.get(question, {}).pop(voter, None))

    async def votes(self, code: str, question: str) -> Parts:
        return dict(self._rooms[code].votes.get(question, {})) if code in self._rooms else {}

    async def questions(self, code: str) -> list[str]:
        return list(self._rooms[code].votes) if code in self._rooms else []

    async def present(self, code: str, replica: str, names: Collection[str]) -> int:
        now = self._clock()
        if code not in self._rooms:
            return 0
        room = self._rooms[code]
        room.here[replica] = names, now + SEEN
        if names:
            room.ends = max(room.ends, min(now + self._alone, room.led))
        return len(set().union(*(told for told, until in room.here.values() if until > now)))

    async def name(self, code: str, replica: str, names: Collection[str]) -> None:
        if code in self._rooms:
            self._rooms[code].names[replica] = set(names)

    async def named(self, code: str) -> set[str]:
        return set().union(*self._rooms[code].names.values()) if code in self._rooms else set()

    async def count(self, name: str, seconds: float, more: int = 1) -> int:
        now = self._clock()
        if name not in self._counts and len(self._counts) >= self._most_counts:
            self._forget_counts(now)
            if len(self._counts) >= self._most_counts:
                raise UnreachableError(OF_COUNTS)
        slot, known = slot_of(now, seconds), self._counts.get(name) or _Count(now)
        known.slots = {one: times for one, times in known.slots.items() if one >= slot - SLOTS}
        if more:
            known.slots[slot] = known.slots.get(slot, 0) + more
            known.until = now + seconds + seconds / SLOTS
            self._counts[name] = known
        return sum(known.slots.values())

    def _forget_counts(self, now: float) -> None:
        """Delete the rooms that are over, at most once a second."""
        if now >= self._counts_looked + 1:
            self._counts = {one: count for one, count in self._counts.items() if count.until > now}
            self._counts_looked = now

    async def lend(self, name: str, key: bytes, value: bytes, seconds: float) -> None:
        self._lent = {other: kept for other, kept in self._lent.items() if kept.until > self._clock()}
        self._lent[name] = _Lent(key, value, self._clock() + seconds)

    async def take(self, name: str, key: bytes) -> bytes:
        lent = self._lent.get(name)
        if not lent or lent.key != key or lent.until <= self._clock():
            return b""
        del self._lent[name]
        return lent.value

    async def time(self) -> float:
        return time()

    async def listen(self, receive: Receive, ready: Callable[[], None]) -> None:
        self._listeners.append(receive)
        ready()
        try:
            await Event().wait()
        finally:
            self._listeners.remove(receive)

    async def close(self) -> None:
        """Do nothing, because there are no connections."""

    def _forget(self) -> None:
        """Return the rooms without a sign for this long."""
        now = self._clock()
        for code in [code for code, room in self._rooms.items() if min(room.ends, room.led) <= now]:
            del self._rooms[code]
            for receive in self._listeners:
                receive(code, {})
