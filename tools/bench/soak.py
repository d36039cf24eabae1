"""`make soak`: rounds of visitors who come, change something and go. The server's memory must not grow.

After five rounds of 1,000 sessions the memory should be within 10 % of its value after the first.
"""

from __future__ import annotations

import argparse
import asyncio
import sys
import tempfile
from pathlib import Path
from urllib.request import urlopen

from components.scenes import SCENES
from tests.serving.server import Server
from tools.bench.crowd import arrive, depart, dragged, memory, replicas

AIM = 0.10
BATCH = 100
"""Visitors who are there at the same time."""


def soak(server: Server, rounds: int, sessions: int) -> list[float]:
    """MB after each round."""
    found = []
    for _ in range(rounds):
        asyncio.run(_round(server, sessions))
        found.append(memory(server))
    return found


async def _round(server: Server, sessions: int) -> None:
    slugs = list(SCENES)
    for start in range(0, sessions, BATCH):
        slug = slugs[start // BATCH % len(slugs)]
        _, visitors = await arrive([server], f"scene={slug}", min(BATCH, sessions - start))
        name, low, high = dragged(SCENES[slug])
        await asyncio.gather(*(visitor.move(name, (low + high) / 2) for visitor in visitors))
        await depart(visitors)
    async with asyncio.timeout(60):
        while await asyncio.to_thread(still_open, server):
            await asyncio.sleep(0.2)


def still_open(server: Server) -> float:
    """Sessions that are left, as /metrics says."""
    text = urlopen(f"{server.url}metrics", timeout=30).read().decode()
    line = next(line for line in text.splitlines() if line.startswith("oscillations_sessions "))
    return float(line.split()[1])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5, help="(%(default)s)")
    parser.add_argument("--sessions", type=int, default=1000, help="in a round (%(default)s)")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder, replicas(1, Path(folder), UNUSED_SECONDS="2") as (server,):
        found = soak(server, options.rounds, options.sessions)
        complaints = server.complaints()
    for number, held in enumerate(found, start=1):
        print(f"round {number}: {held:.1f} MB, {100 * (held / found[0] - 1):+.1f} %")
    print(*complaints, sep="\n")
    sys.exit(abs(found[-1] / found[0] - 1) > AIM or bool(complaints))


if __name__ == "__main__":
    main()
