"""Long work, split into slices. Between two slices the event loop serves other visitors."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Iterable
from contextlib import asynccontextmanager
from time import monotonic
from typing import TypeVar
from weakref import WeakValueDictionary

SLICE = 0.01
"""Seconds of work in one slice."""
MOST = 200
"""Largest number of items in one slice."""

Item = TypeVar("Item")
Result = TypeVar("Result")


class Slices:
    """Long work of all classes. Each turn of the event loop does one slice of it."""

    def __init__(self) -> None:
        self._turn = asyncio.Lock()

    async def map(self, act: Callable[[Item], Result], items: Iterable[Item]) -> list[Result]:
        """Return the results of `act` for all items. Work that was begun at the same time takes turns."""
        todo, done = list(items), list[Result]()
        while len(done) < len(todo):
            async with self._turn:
                end = monotonic() + SLICE
                for item in todo[len(done) : len(done) + MOST]:
                    done.append(act(item))
                    if monotonic() >= end:
                        break
                await asyncio.sleep(0)  # so that each turn of the event loop has one slice
        return done


class Turns:
    """Expensive requests: one at a time for each network, so that no network has more slices than another."""

    def __init__(self) -> None:
        self._locks: WeakValueDictionary[str, asyncio.Lock] = WeakValueDictionary()

    @asynccontextmanager
    async def of(self, network: str) -> AsyncIterator[None]:
        lock = self._locks.get(network) or asyncio.Lock()
        self._locks[network] = lock
        async with lock:
            yield
