"""The cost of a course: every scene compared with an empty page of Panel, an arriving class, and its members who drag.

`make load` runs it after measuring one visitor. It prints a table and saves it as build/load/course.md.
"""

from __future__ import annotations

import argparse
import asyncio
from collections.abc import Iterator
from pathlib import Path
from statistics import median

import psutil

from components.scenes import SCENES
from tests.serving.server import Server
from tools.bench.crowd import arrive, depart, drag, dragged, memory, p95, replicas
from tools.bench.load import EMPTY_LOG, IDLE, REPORT, busy, machine, panel_serving

COURSE = REPORT.with_name("course.md")
ROUNDS = 5
DEAREST = ("coupled", "forced")
"""The scenes that a class is measured in."""


async def opening(server: Server, query: str, sessions: int) -> tuple[float, float]:
    """CPU in ms and memory in MB of each session; the first ones, which warm up, are not counted."""
    process = psutil.Process(server.process.pid)
    _, first = await arrive([server], query, sessions)
    await asyncio.sleep(IDLE)
    before, held = busy(process), memory(server)
    _, visitors = await arrive([server], query, sessions)
    await asyncio.sleep(IDLE)
    cost = 1000 * (busy(process) - before) / sessions, (memory(server) - held) / sessions
    await depart([*first, *visitors])
    return cost


async def changing(server: Server, slug: str, changes: int) -> tuple[float, float]:
    """Return CPU time in ms and bytes in kB of a change: medians of ROUNDS rounds, after one that warms up."""
    process = psutil.Process(server.process.pid)
    _, (visitor,) = await arrive([server], f"scene={slug}", 1)
    name, low, high = dragged(SCENES[slug])
    values = [low + (high - low) * step / changes for step in range(changes)]
    costs, sizes = [], []
    for _ in range(1 + ROUNDS):
        values.reverse()
        before, sent = busy(process), visitor.bytes
        for value in values:
            await visitor.move(name, value)
        await asyncio.sleep(IDLE)
        costs.append(1000 * (busy(process) - before) / changes)
        sizes.append((visitor.bytes - sent) / changes / 1000)
    await depart([visitor])
    return median(costs[1:]), median(sizes[1:])


async def crowded(servers: list[Server], slug: str, visitors: int) -> str:
    """A class that arrives, a tenth of which then drags."""
    seconds, there = await arrive(servers, f"scene={slug}", visitors)
    waits = await drag(there[: max(1, visitors // 10)], dragged(SCENES[slug]), 10, 10)  # spread over the servers too
    await depart(there)
    return f"| {slug} | {seconds:.1f} s | {1000 * p95(waits):.0f} ms |"


def rows(options: argparse.Namespace, folder: Path) -> Iterator[str]:
    with panel_serving(EMPTY_LOG) as server:
        empty, _ = asyncio.run(opening(server, "", options.sessions))
    yield "| scene | a session: CPU | × empty page | memory | a change: CPU | bytes |\n|---|---|---|---|---|---|"
    with replicas(1, folder) as (server,):
        for slug in options.scenes:
            cpu, held = asyncio.run(opening(server, f"scene={slug}", options.sessions))
            change, size = asyncio.run(changing(server, slug, options.changes))
            yield f"| {slug} | {cpu:.0f} ms | {cpu / empty:.2f} | {held:.2f} MB | {change:.1f} ms | {size:.1f} kB |"
    yield f"\n| {options.visitors} visitors, two replicas | all are in within | p95 of a change |\n|---|---|---|"
    with replicas(2, folder) as servers:
        for slug in DEAREST:
            yield asyncio.run(crowded(servers, slug, options.visitors))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sessions", type=int, default=30, help="sessions opened in each scene (%(default)s)")
    parser.add_argument("--changes", type=int, default=40, help="changes in each scene (%(default)s)")
    parser.add_argument("--visitors", type=int, default=300, help="of a class (%(default)s)")
    parser.add_argument("--scenes", nargs="*", default=list(SCENES), help="by default all")
    options = parser.parse_args()
    COURSE.parent.mkdir(parents=True, exist_ok=True)
    lines = [f"{machine()}\n"]
    for row in rows(options, COURSE.parent):
        print(row, flush=True)
        lines.append(row)
    COURSE.write_text("\n".join([*lines, ""]), encoding="utf-8")


if __name__ == "__main__":
    main()
