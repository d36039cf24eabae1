"""The order in which the answers of a choice are shown: one for a class, one for each visitor alone."""

from __future__ import annotations

BASIS, PRIME, MIX = 0x811C9DC5, 0x01000193, 0x85EBCA6B
"""FNV-1a, and a step of MurmurHash3."""


def order_of(step: str, count: int, seed: str) -> list[int]:
    """The places in the file, in the order shown; static/questions/order.js has the same."""
    return sorted(range(count), key=lambda i: _hash(f"{i}/{step}/{seed}"))


def _hash(text: str) -> int:
    found = BASIS
    for byte in text.encode():
        found = (found ^ byte) * PRIME % 2**32
    return (found ^ found >> 16) * MIX % 2**32
