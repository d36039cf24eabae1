"""`make class`: a live class on loopback, its instructor dragging and playing, raw clients following and two Chromiums.

For each size: the time from the slider to the followers (their own clocks are the server's), the server's CPU, bytes an
update; the first size once more after its server was killed and has the class again; then answers and sketches of all
at once, a phone that wakes, and two replicas of which one is killed. The last lines are rows for docs/measured.md.
ARGS="--followers 300 --seconds 30"
"""

from __future__ import annotations

import argparse
import asyncio
import math
import resource
import statistics
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import psutil
from playwright.async_api import Browser

from tests.live_class.caller import Class, called
from tests.serving.server import Server, serving
from tests.serving.visitor import Visitor
from tools.bench.crowd import SETTINGS, p95
from tools.bench.followers import Hearing, drag, followed, sizes, values
from tools.bench.outage import outlived
from tools.bench.screens import SKETCHED, Phones, chromium, taught, woken

CHOICE = {"walk": "d31", "step": "d31-03"}
SKETCH = {"walk": "d34", "step": "d34-14"}
ANSWERS = 300
WAKES = 5
PARCEL = 200
"""Answers that are given back at once."""
PATIENCE = 10.0
"""Seconds for the last picture to come."""


@dataclass
class ClassFigures:
    """The costs of a class of one size. Times are in s, including those measured by Chromium."""

    followers: int
    waits: list[float] = field(default_factory=list)
    reach: list[float] = field(default_factory=list)
    seen: list[float] = field(default_factory=list)
    reach_seen: list[float] = field(default_factory=list)
    cpu: float = 0.0
    bytes: int = 0
    updates: int = 0
    missed: int = 0
    when: str = ""

    @property
    def head(self) -> str:
        return f"{self.followers:,} followers{self.when}"

    def cells(self) -> list[str]:
        """In the order of `ROWS`."""
        return [
            *map(spread, (self.waits, self.seen, self.reach, self.reach_seen)),
            f"{100 * self.cpu:.0f} % of a core",
            f"{self.bytes / 1000:.1f} kB",
            f"{self.missed} of {self.followers}",
        ]


ROWS = (
    ("from the slider to raw clients: median, p95, worst", ""),
    ("from the slider to what two Chromiums have painted", ""),
    ("play, pause, seek: raw clients", "0.30 s"),
    ("play, pause, seek: two Chromiums, in the frame", "0.30 s"),
    ("server CPU while the instructor drags", ""),
    ("an update on the wire, at most", "5 kB"),
    ("followers without the last picture", "0"),
)


def spread(waits: Sequence[float]) -> str:
    """Median, p95 and worst."""
    if not waits:
        return ""
    return ", ".join(f"{one:.2f}" for one in (statistics.median(waits), p95(waits), max(waits))) + " s"


async def measured(
    server: Server, count: int, seconds: float, browser: Browser | None = None, room: Class | None = None
) -> ClassFigures:
    """A class of a size, in a new room or this one, whose instructor drags for a time, then plays and seeks."""
    figures, room = ClassFigures(count), room or await Class.open(server.url)
    Hearing.EVENTS.clear()
    visitor = await Visitor.arrive(server.url, "scene=coupled")
    await visitor.send({"type": "lead", "code": room.code, "key": room.key})
    hearing = await followed(room, [server.url], count)
    phones = await Phones.join(browser, room)
    process = psutil.Process(server.process.pid)
    before, begun = process.cpu_times(), time.monotonic()
    sent = await drag(visitor, seconds)
    used, lasted = process.cpu_times(), time.monotonic() - begun
    shown = await settled(hearing, list(sent)[-1])
    for one in hearing:
        seen = [(at, shown[key]) for at, key in one.heard if key in shown]
        figures.waits += [at - sent[value] for at, value in seen if value in sent]
        figures.missed += seen[-1][1] != list(sent)[-1]
    figures.seen = await phones.waits(sent, "values")
    figures.cpu = (used.user + used.system - before.user - before.system) / lasted
    figures.bytes, figures.updates = max(sizes()), len(sizes())
    figures.reach, begun_at = await _played(room, hearing)
    figures.reach_seen = await phones.waits(begun_at, "clocks")
    for one in hearing:
        one.transport.close()
    await phones.leave()
    await visitor.depart()
    return figures


async def settled(hearing: Sequence[Hearing], last: float) -> dict[int, float]:
    """The value of k2 in each event, once all have the last or a while is over."""
    end = time.monotonic() + PATIENCE
    while True:
        await asyncio.sleep(0.5)
        shown = values("k2")
        there = all(any(shown.get(key) == last for _, key in one.heard[-20:]) for one in hearing)
        if there or time.monotonic() > end:
            return shown


async def _played(room: Class, hearing: list[Hearing]) -> tuple[list[float], dict[float, float]]:
    """The waits of each follower for several orders of the clock; and the time of each order, by its instant."""
    waits, begun_at = [], {}
    for turn in range(10):
        counts = [len(one.heard) for one in hearing]
        begun_at[float(turn)] = begun = time.time()
        await room.order("clock", t=float(turn), rate=turn % 2, end=20.0, at=1000 * begun)
        await asyncio.sleep(0.5)
        for one, count in zip(hearing, counts, strict=True):
            came = [at for at, key in one.heard[count:] if b'"clock"' in Hearing.EVENTS[key]]
            waits.append(came[0] - begun if came else math.inf)
    return waits, begun_at


async def voted(room: Class, count: int, asked: dict[str, Any], answer: dict[str, Any]) -> tuple[float, float]:
    """Seconds in which so many answers come in; and the time at which the last did."""
    tokens = await asyncio.gather(*(room.token() for _ in range(count)))
    begun = time.time()
    replies = await asyncio.gather(*(room.vote(token, **asked, **answer) for token in tokens))
    assert {reply.status for reply in replies} == {204}
    return time.time() - begun, time.time()


async def answered(server: Server, count: int, asked: dict[str, Any], answer: dict[str, Any]) -> tuple[float, float]:
    """Seconds in which so many answers come in, and from the last until the instructor's count has all."""
    room = await Class.open(server.url)
    await room.order("put", **asked)
    took, last = await voted(room, count, asked, answer)
    while (await room.tally())["now"]["answered"] < count:
        await asyncio.sleep(0.05)
    return took, time.time() - last


async def sketched(server: Server, count: int, browser: Browser) -> tuple[float, float]:
    """The seconds until all sketches are in, and until the instructor's screen has them."""
    async with taught(browser, server.url, *SKETCH.values()) as (page, room):
        all_seen = asyncio.ensure_future(page.evaluate(SKETCHED, count))
        took, last = await voted(room, count, SKETCH, drawing())
        return took, await all_seen / 1000 - last


def drawing() -> dict[str, Any]:
    return {"curves": {"Xp1": [round(500 + 400 * math.sin(i / 9)) for i in range(101)]}}


def table(sizes: Sequence[ClassFigures], more: Sequence[tuple[str, str, str]]) -> str:
    """Return rows in Markdown; figures measured for one size only are in the first column."""
    heads = [one.head for one in sizes]
    lines = [("a live class", *heads, "aim"), ("---",) * (len(heads) + 2)]
    for (what, aim), *cells in zip(ROWS, *(one.cells() for one in sizes), strict=True):
        lines.append((what, *cells, aim))
    lines += [(what, cell, *[""] * (len(heads) - 1), aim) for what, cell, aim in more]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


async def asked_all(server: Server, browser: Browser | None) -> list[tuple[str, str, str]]:
    """Answers, sketches and phones that wake."""
    came, counted = await answered(server, ANSWERS, CHOICE, {"option": 1})
    rows = [(f"{ANSWERS} answers: all in, then all counted", f"{came:.1f} s, then {counted:.2f} s", "5 s")]
    if browser:
        came, seen = await sketched(server, ANSWERS, browser)
        what = f"{ANSWERS} sketches: all in, then all on the instructor's screen"
        rows.append((what, f"{came:.1f} s, then {seen:.2f} s", "1 s after the last"))
        waits = await woken(browser, await Class.open(server.url), server.port, WAKES)
        rows.append(("a phone wakes: until it shows what is", spread(waits), "1 s"))
    return rows


async def restarted(
    folder: Path, count: int, seconds: float, browser: Browser | None = None
) -> tuple[ClassFigures, float]:
    """A class whose server was killed, and the seconds in which the next one has it again, with so many answers."""
    with serving(folder / "killed", environment=SETTINGS) as server:
        room = await Class.open(server.url)
        await room.order("put", **CHOICE)
        await voted(room, count, CHOICE, {"option": 1})
        path = f"/class/{room.code}/answers?question={'/'.join(CHOICE.values())}/1"
        kept = list((await called(room.url, path, word=room.key)).json.items())
        server.process.kill()
    with serving(folder / "again", environment=SETTINGS) as server:
        room.url, begun = server.url, time.monotonic()
        await called(room.url, f"/class/{room.code}/lead", "PUT", {}, room.key)
        await room.order("put", **CHOICE)
        for first in range(0, len(kept), PARCEL):
            await room.order("restore", answers=dict(kept[first : first + PARCEL]))
        assert (await room.tally())["now"]["answered"] == count
        took = time.monotonic() - begun
        figures = await measured(server, count, seconds, browser, room)
        figures.when = ", after a restart"
        print(*server.complaints(), sep="\n")
    return figures, took


async def whole(options: argparse.Namespace, folder: Path) -> None:
    async with chromium() as browser:
        with serving(folder / "log", environment=SETTINGS) as server:
            figures = [await measured(server, count, options.seconds, browser) for count in options.followers]
            rows = await asked_all(server, browser)
            print(*server.complaints(), sep="\n")
        again, took = await restarted(folder, options.followers[0], options.seconds, browser)
    rows.append((f"a killed server has the class again, with {again.followers:,} answers", f"{took:.1f} s", ""))
    lost, back, missed = await outlived(folder, ANSWERS, options.seconds / 3)
    what = f"two replicas behind the proxy, one killed: its {lost} of {ANSWERS} followers are back"
    rows += [(what, spread(back), ""), ("and lack the last picture", f"{missed}", "0")]
    print(table([*figures, again], rows), flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--followers", type=int, nargs="*", default=[300, 3000], help="sizes (%(default)s)")
    parser.add_argument("--seconds", type=float, default=30.0, help="that the instructor drags (%(default)s)")
    options = parser.parse_args()
    _, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))
    with tempfile.TemporaryDirectory() as name:
        asyncio.run(whole(options, Path(name)))


if __name__ == "__main__":
    main()
