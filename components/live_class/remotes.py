"""Phones as remote controls of a room: the waiting ones, by the two digits that they show, and the accepted one. The
room stores them, so that the instructor's page still sees them after it reconnects or reloads.
"""

from __future__ import annotations

from collections.abc import Container
from random import SystemRandom
from time import time

import msgspec

from components.live_class.codes import digest, is_key
from components.live_class.store import Parts

WAITS = "waits "
"""The prefix of the part of a waiting phone; its digits follow."""
CONTROL = "control"
"""The name of the part of the accepted phone: the digest of its key."""
PATIENCE = 60.0
"""Seconds for which a phone may wait."""
DIGITS = range(10, 100)


class Waiting(msgspec.Struct, frozen=True):
    """A waiting phone: the digest of its key, and the end of its wait in seconds since 1970."""

    key: str
    until: float


def waiting(parts: Parts) -> dict[str, Waiting]:
    """Return the phones that wait now, by their digits."""
    found = {name.removeprefix(WAITS): part for name, part in parts.items() if name.startswith(WAITS) and part}
    read = {digits: msgspec.json.decode(part, type=Waiting) for digits, part in found.items()}
    return {digits: one for digits, one in sorted(read.items()) if one.until > time()}


def new_digits(taken: Container[str]) -> str:
    """Return two digits to compare on two screens. Raises ValueError if all are in use by waiting phones."""
    free = [digits for digits in map(str, DIGITS) if digits not in taken]
    if not free:
        raise ValueError("Too many remote controls are waiting. Try again in a minute.")
    return SystemRandom().choice(free)


def begun(digits: str, key: str) -> Parts:
    """Return the parts of a room that store a waiting phone."""
    one = Waiting(digest(key).decode(), time() + PATIENCE)
    return {WAITS + digits: msgspec.json.encode(one)}


def decided(parts: Parts, digits: str, is_in: bool) -> Parts:
    """Return the parts that accept or reject a phone. Raises ValueError, with a reason, if none has these digits."""
    one = waiting(parts).get(digits)
    if one is None:
        raise ValueError("No remote control with these digits is waiting.")
    return {WAITS + digits: b""} | ({CONTROL: one.key.encode()} if is_in else {})


def is_in(parts: Parts, key: str) -> bool:
    return is_key(key, parts.get(CONTROL, b""))


def waits(parts: Parts, key: str) -> bool:
    return any(is_key(key, one.key.encode()) for one in waiting(parts).values())
