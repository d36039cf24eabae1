"""Long work in slices, between which the event loop turns for everybody else."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Iterable
from time import monotonic
from typing import TypeVar

SLICE = 0.01
"""Seconds of work at a time."""

Item = TypeVar("Item")


async def by_and_by(items: Iterable[Item]) -> AsyncIterator[Item]:
    """Items one by one, with a pause as often as a slice is over."""
    end = monotonic() + SLICE
    for item in items:
        if monotonic() > end:
            await asyncio.sleep(0)
            end = monotonic() + SLICE
        yield item
