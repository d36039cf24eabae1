"""How many visitors come in, and in which order the others do."""

from __future__ import annotations

from collections.abc import Callable
from secrets import token_urlsafe
from time import monotonic

ASK_AGAIN = 20
"""Seconds, after which a waiting page asks again."""
FORGOTTEN = 2.5 * ASK_AGAIN
"""Seconds without a question, after which a place in the line is given up."""
LONGEST = 2000
"""Of a line; who comes after that has no place in it, and may come again."""

ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")


class Door:
    """Lets in as many as there are places for; the others have tickets, and are let in by turns."""

    def __init__(self, places: int, taken: Callable[[], int], clock: Callable[[], float] = monotonic) -> None:
        self.places = places
        self._taken = taken
        self._clock = clock
        self._line: dict[str, float] = {}
        """When each ticket was last seen, in the order in which they came."""

    def knock(self, ticket: str) -> tuple[int, str]:
        """The place in the line of who shows a ticket, or none, and the ticket for next time; 0 is to come in."""
        now = self._clock()
        self._line = {other: seen for other, seen in self._line.items() if now - seen < FORGOTTEN}
        if ticket not in self._line:
            ticket = token_urlsafe(9)
        if ticket in self._line or len(self._line) < LONGEST:
            self._line[ticket] = now
        free = max(0, self.places - self._taken())
        before = list(self._line).index(ticket) if ticket in self._line else len(self._line)
        if before < free:
            del self._line[ticket]
            return 0, ""
        return before - free + 1, ticket


def ordinal(number: int) -> str:
    """first, ..., tenth, 11th, ... 21st."""
    if number <= len(ORDINALS):
        return ORDINALS[number - 1]
    ending = "th" if number % 100 in (11, 12, 13) else {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th")
    return f"{number}{ending}"
