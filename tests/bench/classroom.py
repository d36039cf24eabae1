"""`make class`: a live class on loopback, its instructor dragging and playing, with raw clients as followers.

For each size: the time from the slider to the followers (their own clocks are the server's), the server's CPU, bytes an
update; then answers and sketches of all at once. ARGS="--followers 300 --seconds 30"
"""

from __future__ import annotations

import argparse
import asyncio
import math
import resource
import statistics
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import psutil

from tests.bench.crowd import SETTINGS, p95
from tests.bench.followers import Hearing, followed, sizes, values
from tests.bench.visitor import Visitor
from tests.rooms.caller import Class
from tests.serving.server import Server, serving

RATE = 20.0
"""Changes a second of the instructor's hand."""
CHOICE = {"walk": "d31", "step": "d31-03"}
SKETCH = {"walk": "d34", "step": "d34-14"}


@dataclass
class Figures:
    """What a class of one size costs; times in s."""

    followers: int
    waits: list[float] = field(default_factory=list)
    reach: list[float] = field(default_factory=list)
    cpu: float = 0.0
    bytes: int = 0
    updates: int = 0
    missed: int = 0

    def lines(self) -> list[str]:
        drag = f"median {statistics.median(self.waits):.3f} s, p95 {p95(self.waits):.3f}, worst {max(self.waits):.3f}"
        play = f"median {statistics.median(self.reach):.3f} s, p95 {p95(self.reach):.3f}, worst {max(self.reach):.3f}"
        return [
            f"{self.followers} followers: from slider to followers {drag}",
            f"  play and seek: {play}; {self.updates} updates, {self.bytes} bytes at most; {100 * self.cpu:.0f} % of a "
            f"core; {self.missed} followers without the last picture",
        ]


async def measured(server: Server, count: int, seconds: float) -> Figures:
    """A class of a size, whose instructor drags for so many seconds and then plays and seeks."""
    figures, room = Figures(count), await Class.open(server.url)
    Hearing.EVENTS.clear()
    visitor = await Visitor.arrive(server.url, "scene=coupled")
    await visitor.say({"type": "lead", "code": room.code, "key": room.key})
    hearing = await followed(room, [server.url], count)
    process = psutil.Process(server.process.pid)
    before, begun = process.cpu_times(), time.monotonic()
    sent = await _drag(visitor, seconds)
    used, lasted = process.cpu_times(), time.monotonic() - begun
    await asyncio.sleep(1.0)
    shown = values("k2")
    for one in hearing:
        seen = [(at, shown[key]) for at, key in one.heard if key in shown]
        figures.waits += [at - sent[value] for at, value in seen if value in sent]
        figures.missed += seen[-1][1] != list(sent)[-1]
    figures.cpu = (used.user + used.system - before.user - before.system) / lasted
    figures.bytes, figures.updates = max(sizes()), len(sizes())
    figures.reach = await _played(room, hearing)
    for one in hearing:
        one.transport.close()
    await visitor.depart()
    return figures


async def _drag(visitor: Visitor, seconds: float) -> dict[float, float]:
    """When each value was set."""
    sent: dict[float, float] = {}
    begun = time.monotonic()
    while (now := time.monotonic() - begun) < seconds:
        value = round(2 + math.sin(3 * now) + 1e-6 * len(sent), 9)
        sent[value] = time.time()
        await visitor.say({"type": "set", "values": {"k2": value}})
        await asyncio.sleep(max(0.0, now + 1 / RATE - (time.monotonic() - begun)))
    return sent


async def _played(room: Class, hearing: list[Hearing]) -> list[float]:
    """How long each of several orders of the clock took to each follower."""
    waits = []
    for turn in range(10):
        counts = [len(one.heard) for one in hearing]
        begun = time.time()
        await room.order("clock", t=float(turn), rate=turn % 2, end=20.0, at=1000 * begun)
        await asyncio.sleep(0.5)
        for one, count in zip(hearing, counts, strict=True):
            came = [at for at, key in one.heard[count:] if b'"clock"' in Hearing.EVENTS[key]]
            waits.append(came[0] - begun if came else math.inf)
    return waits


async def answered(server: Server, count: int, asked: dict[str, Any], answer: dict[str, Any]) -> tuple[float, float]:
    """Seconds in which so many answers come in, and from the last until the instructor's count has all."""
    room = await Class.open(server.url)
    await room.order("put", **asked)
    tokens = await asyncio.gather(*(room.token() for _ in range(count)))
    begun = time.monotonic()
    replies = await asyncio.gather(*(room.vote(token, **asked, **answer) for token in tokens))
    assert {reply.status for reply in replies} == {204}
    last = time.monotonic()
    while (await room.tally())["now"]["answered"] < count:
        await asyncio.sleep(0.05)
    return last - begun, time.monotonic() - last


def drawing() -> dict[str, Any]:
    return {"curves": {"Xp1": [round(500 + 400 * math.sin(i / 9)) for i in range(101)]}}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--followers", type=int, nargs="*", default=[300, 3000], help="sizes (%(default)s)")
    parser.add_argument("--seconds", type=float, default=30.0, help="that the instructor drags (%(default)s)")
    options = parser.parse_args()
    _, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))
    with tempfile.TemporaryDirectory() as name, serving(Path(name) / "log", environment=SETTINGS) as server:
        for count in options.followers:
            print(*asyncio.run(measured(server, count, options.seconds)).lines(), sep="\n", flush=True)
        for what, asked, answer in (("answers", CHOICE, {"option": 1}), ("sketches", SKETCH, drawing())):
            came, seen = asyncio.run(answered(server, 300, asked, answer))
            print(f"300 {what}: in {came:.2f} s, with the instructor {seen:.2f} s after the last", flush=True)
        print(*server.complaints(), sep="\n")


if __name__ == "__main__":
    main()
