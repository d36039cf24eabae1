"""Many visitors at once: the time until all pages are open, the waits during drags, and the memory used afterwards."""

from __future__ import annotations

import asyncio
import math
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path

import psutil

from components.scene import Scene
from tests.scenes.checks import quantities
from tests.serving.server import Server, serving
from tests.serving.visitor import Visitor

AT_ONCE = 24
"""Visitors that one client lets arrive at a time: so many connections a class opens through one access point."""
Slider = tuple[str, float, float]
"""The name of a parameter, and from where to where it is moved."""
SETTINGS = {"BOKEH_SECRET_KEY": "a secret of more than thirty-two letters", "ARRIVALS": "1000000", "SESSIONS": "100000"}


@contextmanager
def replicas(count: int, folder: Path, **settings: str) -> Iterator[list[Server]]:
    """So many processes with one secret."""
    with ExitStack() as stack:
        logs = [folder / f"replica-{number}.log" for number in range(count)]
        yield [stack.enter_context(serving(log, environment=SETTINGS | settings)) for log in logs]


def dragged(scene: type[Scene]) -> Slider:
    """A slider of the scene, and the part of it that a hand goes through."""
    name, quantity = next(iter(quantities(scene).items()))
    low, high = quantity.softbounds
    middle = float(quantity.default or 0.3 * high)
    return name, max(low, 0.8 * middle), min(high, 1.2 * middle)


async def arrive(servers: Sequence[Server], query: str, count: int) -> tuple[float, list[Visitor]]:
    """Seconds until all are in, and the visitors, spread over the servers."""
    gate = asyncio.Semaphore(AT_ONCE)

    async def one(number: int) -> Visitor:
        async with gate:
            return await Visitor.arrive(servers[number % len(servers)].url, query)

    begun = time.monotonic()
    visitors = await asyncio.gather(*(one(number) for number in range(count)))
    return time.monotonic() - begun, list(visitors)


async def drag(
    visitors: Sequence[Visitor], slider: tuple[str, float, float], rate: float, seconds: float
) -> list[float]:
    """Seconds that each answer took: every visitor moves a slider `rate` times a second, if answers keep up."""
    name, low, high = slider
    waits: list[float] = []

    async def one(number: int, visitor: Visitor) -> None:
        await asyncio.sleep(number / len(visitors) / rate)
        end = time.monotonic() + seconds
        step = number
        while (begun := time.monotonic()) < end:
            step += 1
            await visitor.move(name, low + (high - low) * (0.5 + 0.5 * math.sin(0.7 * step)))
            waits.append(time.monotonic() - begun)
            await asyncio.sleep(max(0.0, begun + 1 / rate - time.monotonic()))

    await asyncio.gather(*(one(number, visitor) for number, visitor in enumerate(visitors)))
    return waits


async def depart(visitors: Sequence[Visitor]) -> None:
    await asyncio.gather(*(visitor.depart() for visitor in visitors))


def memory(server: Server) -> float:
    """MB that the process holds."""
    return float(psutil.Process(server.process.pid).memory_info().rss) / 1e6


def p95(waits: Sequence[float]) -> float:
    return sorted(waits)[math.ceil(0.95 * len(waits)) - 1]
