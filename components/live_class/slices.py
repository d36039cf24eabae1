"""Long work in slices, between which the event loop turns for everybody else."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Iterable
from contextlib import asynccontextmanager
from time import monotonic
from typing import TypeVar
from weakref import WeakValueDictionary

SLICE = 0.01
"""Seconds of work at a time."""
MOST = 200
"""Items of a slice."""

Item = TypeVar("Item")
Result = TypeVar("Result")


class Slices:
    """Long work of all classes, of which each turn of the event loop does one slice."""

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
                await asyncio.sleep(0)  # nobody else's slice is in this turn of the event loop
        return done


class Turns:
    """Requests that cost much: one at a time of each network, so that none has more slices than another."""

    def __init__(self) -> None:
        self._locks: WeakValueDictionary[str, asyncio.Lock] = WeakValueDictionary()

    @asynccontextmanager
    async def of(self, network: str) -> AsyncIterator[None]:
        lock = self._locks.get(network) or asyncio.Lock()
        self._locks[network] = lock
        async with lock:
            yield
