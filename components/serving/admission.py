"""Admission: the number of visitors with a session, the waiting line, and who is dropped for it."""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Callable, Collection, Hashable, Mapping
from secrets import token_urlsafe
from time import monotonic
from typing import Any, NamedTuple, Protocol, TypeVar
from weakref import WeakKeyDictionary

from bokeh.server.session import ServerSession
from bokeh.util.token import get_token_payload

from components.serving.metrics import Looked
from components.serving.visitors import Arrivals, Rate

Key = TypeVar("Key", bound=Hashable)

ASK_AGAIN = 20
"""Seconds until a waiting page asks again."""
FORGOTTEN = 2.5 * ASK_AGAIN
"""Seconds without a request after which a place in the line is lost."""
LONGEST = 2000
"""Length of the line. When it is full, new visitors are refused and may try again."""
OF_A_NETWORK = LONGEST // 4
"""Maximum number of tickets of one network."""
IDLE = 600.0
"""Seconds of idleness after which a visitor may be dropped when the server is full."""
SHARE = 0.75
"""The share of the places that a network keeps while others wait. Beyond it, its quietest visitor is dropped."""
RETURNS = 10
"""Reconnections of one page per minute that do not count as arrivals. A network has this many times its allowed
arrivals."""

ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")


class Guest(NamedTuple):
    """A visitor with a session: their network, and the time of their last message."""

    network: str
    last_active: float


class InLine(NamedTuple):
    """A ticket: the network that got it, and the time of its last use."""

    network: str
    seen: float


class Queue:
    """Admit visitors while there are places. The others get tickets, and networks take turns."""

    def __init__(
        self,
        places: int,
        taken: Callable[[], int],
        clock: Callable[[], float] = monotonic,
        free_place: Callable[[str], bool] = lambda network: False,
        held: Callable[[], Mapping[str, int]] = dict,
    ) -> None:
        """`held` returns the number of places of each network; `free_place` tries to free one for a visitor of a
        network."""
        self.places = places
        self._taken = taken
        self._clock = clock
        self._free_place = free_place
        self._held = held
        self._line: dict[str, InLine] = {}
        """Tickets in the order of arrival."""

    def __len__(self) -> int:
        """The number of waiting visitors, including some that have left without a message."""
        return len(self._line)

    def knock(self, ticket: str, network: str = "") -> tuple[int, str]:
        """Return the place in the line for a ticket, or for a new visitor, and the ticket for next time. Place 0 is
        admitted.
        """
        now = self._clock()
        self._line = {other: one for other, one in self._line.items() if now - one.seen < FORGOTTEN}
        if ticket not in self._line:
            ticket = token_urlsafe(9)
            has = sum(one.network == network for one in self._line.values())
            if len(self._line) < LONGEST and has < OF_A_NETWORK:
                self._line[ticket] = InLine(network, now)
        else:
            self._line[ticket] = self._line[ticket]._replace(seen=now)
        free = max(0, self.places - self._taken())
        before = self._before(ticket)
        if before < free or (before == free and ticket in self._line and self._free_place(network)):
            self._line.pop(ticket, None)
            return 0, ""
        return before - free + 1, ticket

    def _before(self, ticket: str) -> int:
        """Return the number of visitors that are let in earlier. Networks with fewer places come first, in the order of
        arrival."""
        turns = Counter(self._held())
        order = []
        for place, (other, one) in enumerate(self._line.items()):
            order.append((turns[one.network], place, other))
            turns[one.network] += 1
        return next((i for i, (*_, other) in enumerate(sorted(order)) if other == ticket), len(order))


class OpenSocket(Protocol):
    """The socket of an admitted visitor."""

    connection: Any
    gone: asyncio.Event

    def drop(self, code: int, reason: str) -> None: ...

    def pulse(self) -> None: ...


class Admission:
    """The visitors with a session, by their sessions and sockets, and the waiting line."""

    def __init__(self, places: int, arrivals: int, sessions: Callable[[], Collection[ServerSession]]) -> None:
        """`arrivals` is the number of pages that one network may open in a minute; `sessions` returns the existing
        sessions.
        """
        self.sockets: set[OpenSocket] = set()
        self.guests: WeakKeyDictionary[ServerSession, Guest] = WeakKeyDictionary()
        self.queue = Queue(places, taken=self.taken, free_place=self._free_place, held=self._held)
        self.arrivals = Arrivals(arrivals)
        self.returns = Rate(RETURNS)
        self.returning = Arrivals(RETURNS * arrivals)
        self._sessions = sessions

    def figures(self) -> Looked:
        return {
            "line": ("Visitors who wait for a place", lambda: len(self.queue)),
            "sessions": ("Sessions, with and without a visitor", self.taken),
            "sockets": ("Visitors who are connected", lambda: len(self.sockets)),
        }

    def taken(self) -> int:
        """The number of places that are taken."""
        return sum(not session.expiration_requested for session in self._sessions())

    def note_activity(self, session: ServerSession) -> None:
        """Record that a visitor has arrived, or sent a message."""
        guest = self.guests.get(session)
        network = guest.network if guest else get_token_payload(session.token).get("network", "")
        self.guests[session] = Guest(network, monotonic())

    def wait(self, visitor: str, page: str) -> float:
        """Return the seconds until a page may be opened. Pages that reconnect, if not too often, are not counted."""
        if page and not self.returns.admit(page) and not self.returning.admit(visitor):
            return 0.0
        return self.arrivals.admit(visitor)

    def _in(self) -> dict[ServerSession, Guest]:
        return {session: guest for session, guest in self.guests.items() if not session.expiration_requested}

    def _held(self) -> Counter[str]:
        return Counter(guest.network for guest in self._in().values())

    def _free_place(self, network: str) -> bool:
        """Drop a visitor for one of a network; return False if nobody may be dropped."""
        leaves = visitor_to_drop(self._in(), self.queue.places, network, monotonic())
        if leaves is None:
            return False
        leaves.request_expiration()
        for socket in [one for one in self.sockets if one.connection and one.connection.session is leaves]:
            socket.drop(1013, "All places are taken, and others wait.")
        return True


def visitor_to_drop(guests: Mapping[Key, Guest], places: int, network: str, now: float) -> Key | None:
    """Return the visitor to drop for a new one of a network when the server is full.

    It is a visitor who has been idle for long; otherwise the quietest one of another network that exceeds its share.
    """
    quietest = sorted(guests, key=lambda key: guests[key].last_active)
    if quietest and now - guests[quietest[0]].last_active >= IDLE:
        return quietest[0]
    held = Counter(guest.network for guest in guests.values())
    large = {one for one, count in held.items() if count > SHARE * places and one != network}
    return next((key for key in quietest if guests[key].network in large), None)


def ordinal(number: int) -> str:
    """Return an ordinal: first, ..., tenth, 11th, ... 21st."""
    if number <= len(ORDINALS):
        return ORDINALS[number - 1]
    ending = "th" if number % 100 in (11, 12, 13) else {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th")
    return f"{number}{ending}"
