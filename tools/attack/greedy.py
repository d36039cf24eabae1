"""One client repeats the most expensive requests while thirty other visitors work.

For each kind of request this measures the 95th percentile of the others' waits, over five rounds that alternate with
five calm ones, and the longest time for which the server's event loop was blocked, from its own metrics.
"""

from __future__ import annotations

import asyncio
import re
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import suppress
from itertools import count, cycle
from statistics import median, quantiles
from time import monotonic
from typing import Any, NamedTuple

from tests.live_class.caller import SKETCH, Class, called, drawn
from tests.serving.visitor import Visitor
from tools.attack.result import AttackResult

OTHERS, ROUNDS, SECONDS, PAUSE = 30, 5, 2.0, 0.1
"""Number of other visitors, rounds of each kind, seconds per round, seconds between two changes of a visitor."""
TIMES, HELD = 3.0, 0.05
"""Largest ratio of the others' wait to that of a calm round, and most seconds for which the event loop may be blocked.
"""
AT_ONCE = 8
"""Requests that the greedy client has open at the same time."""
START = "scene=absorber&damping=added"
SLOW = "?scene=absorber&damping=added&m1=1e300&played=rest&x2_0=-1.3&window="
FILES = (
    "scene=forced&c2=0.3&window=1e16",
    "scene=driven&window=1e155",
    "scene=forced&m1=1e20&m2=9.999999990686774e19&c1=1.797e308",
    "scene=forced&omega=3147989031245930&m1=1e-300&c2=0.48158075046840454&v1_0=1e155&v2_0=0.31864389676684013",
    "scene=coupled&window=1e176",
    "scene=coupled",
)
"""Links with the most expensive files, and two ordinary ones."""
Message = dict[str, Any]
GREEDY: dict[str, Message] = {
    "a walk of slow links": {
        "type": "walk",
        "name": "mine",
        "text": 'title = "t"\n'
        + "".join(f'[[step]]\nid = "s{i}"\nfrom = "d31-03"\ncover = []\nstate = "{SLOW}{1 + i}"\n' for i in range(60)),
    },
    "a walk of long formulas": {
        "type": "walk",
        "name": "mine",
        "text": 'title = "t"\n'
        + "".join(f'[[step]]\nid = "s{i}"\nfrom = "d31-03"\nfollows = "{"x_1" * 300}"\n' for i in range(45)),
    },
    "dotted keys": {"type": "walk", "name": "mine", "text": "a." * 20_000 + "a = 1"},
    "a light absorber": {"type": "set", "values": {"m2": 1e-300}},
    "many digits": {"type": "set", "values": {"m1": 1e300}},
    "an enormous window": {"type": "set", "values": {"window": 1e176}},
}
"""The most expensive messages of one page. `_clients` adds requests of other pages."""
PHONES = 200
"""Phones in the greedy client's class. Each has sent a sketch."""
OF_A_CLASS = (
    "GET /class/CODE/summary",
    "GET /class/CODE/answers.csv",
    "POST /class/CODE/lead restore",
    "POST /class/CODE/word",
)
GreedyAct = Callable[[], Awaitable[object]]


class Waits(NamedTuple):
    """Times measured in a round, in s: 95 % of the waits of other visitors were shorter than `p95`; the event loop was
    blocked for at most `held`.
    """

    p95: float
    held: float


async def greedy(url: str) -> list[AttackResult]:
    """Measure each kind of greedy client."""
    others = await asyncio.gather(*(Visitor.arrive(url, "scene=coupled") for _ in range(OTHERS)))
    found = [await _compared(url, others, name, acts) async for name, acts in _clients(url)]
    await asyncio.gather(*(other.depart() for other in others))
    return found


async def _clients(url: str) -> AsyncIterator[tuple[str, list[GreedyAct]]]:
    """Yield the name of each greedy client and the requests that it repeats in parallel."""
    for name, message in GREEDY.items():
        page = await Visitor.arrive(url, START)
        yield name, [_changed(page, message)]
        await page.depart()
    for name, kind in (("files of pages", "csv"), ("errors of pages", "about")):
        pages = [await Visitor.arrive(url, query) for query in FILES]
        yield name, [_sending(page, {"type": kind}) for page in pages]
        await asyncio.gather(*(page.depart() for page in pages))
    yield "files by address", [_fetched(url, "/data.csv?" + query) for query, _ in zip(cycle(FILES), range(AT_ONCE))]
    client = await Class.open(url)
    await client.order("put", **SKETCH)
    for _ in range(PHONES):
        await client.vote(await client.token(), **SKETCH, **drawn(500))
    for name in OF_A_CLASS:
        yield name, [_sent(client, name)] * AT_ONCE


async def _compared(url: str, others: list[Visitor], name: str, acts: list[GreedyAct]) -> AttackResult:
    """Alternate calm rounds with rounds that include the greedy client."""
    calm, busy = list[Waits](), list[Waits]()
    for _ in range(ROUNDS):
        calm.append(await _round(url, others, []))
        busy.append(await _round(url, others, acts))
    before, meanwhile = (1000 * median(one.p95 for one in rounds) for rounds in (calm, busy))
    held = max(one.held for one in busy)
    detail = f"95 of 100 answers within {before:.0f} ms calm, {meanwhile:.0f} ms meanwhile, held {1000 * held:.0f} ms"
    return AttackResult(f"others go on: {name}", meanwhile <= TIMES * before and held <= HELD, detail)


async def _round(url: str, others: list[Visitor], acts: list[GreedyAct]) -> Waits:
    end, before = monotonic() + SECONDS, await _lags(url)
    tasks = [asyncio.create_task(_repeated(act, end)) for act in acts]
    waits = await asyncio.gather(*(_waits_of(other, end) for other in others))
    await asyncio.gather(*tasks)
    after = await _lags(url)
    held = max((bound for bound, seen in after.items() if seen > before.get(bound, 0)), default=0.0)
    return Waits(quantiles([wait for one in waits for wait in one], n=20)[-1], held)


async def _repeated(act: GreedyAct, end: float) -> None:
    with suppress(ConnectionError, TimeoutError):  # the server may send the greedy client away
        while monotonic() < end:
            await act()


async def _waits_of(visitor: Visitor, end: float) -> list[float]:
    """Change a value every `PAUSE` and return the wait for each answer."""
    waits = []
    for step in count():
        if monotonic() >= end:
            return waits
        start = monotonic()
        await visitor.move("k2", 1 + step % 100 / 100)
        waits.append(monotonic() - start)
        await asyncio.sleep(PAUSE)
    return waits


async def _lags(url: str) -> dict[float, float]:
    """Return how often the event loop was late, by the smallest bound that covers the delay."""
    text = (await called(url, "/metrics")).text
    found = re.findall(r'oscillations_loop_lag_seconds_bucket\{le="([\d.]+|\+Inf)"\} ([\d.e+]+)', text)
    counts = [(float(bound), float(seen)) for bound, seen in found]
    return {bound: seen - below for (bound, seen), (_, below) in zip(counts, [(0.0, 0.0), *counts], strict=False)}


def _sending(page: Visitor, message: Message) -> GreedyAct:
    return lambda: page.send(message)


def _changed(page: Visitor, message: Message) -> GreedyAct:
    """Return an action that asks for a different picture each time."""
    numbers = count()

    def act() -> Awaitable[Message]:
        more = {"values": {**message["values"], "x2_0": next(numbers) / 1e3}} if "values" in message else {}
        return page.send({**message, **more})

    return act


def _sent(client: Class, name: str) -> GreedyAct:
    numbers = count()
    return lambda: client.send(name, next(numbers))


def _fetched(url: str, *request: Any) -> GreedyAct:
    return lambda: called(url, *request)
