"""Trials in which a replica fails or is upgraded: visitors lose nothing that they set."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from components.scenes import SCENES
from tests.page.headless_page import Page
from tools.deploy.guest import ReturningVisitor
from tools.deploy.site import DeployedSite, upgraded

PACE = 0.25
"""Seconds between two changes of a guest."""


@dataclass(frozen=True)
class FailureTrial:
    """The outcome of a trial."""

    longest: float
    """Longest time in s that a change took."""
    returned: int
    lost: list[str]
    """Descriptions of guests who see another value than they set."""


async def trial(site: DeployedSite, guests: int, happening: Callable[[], None], after: float = 1.0) -> FailureTrial:
    """Guests change values; `happening` runs after `after` seconds; they continue for as long again."""
    visitors = [ReturningVisitor(site.url, cookies=bool(i % 2)) for i in range(guests)]
    await asyncio.gather(*(visitor.arrive("scene=coupled") for visitor in visitors))
    over = asyncio.Event()

    async def change(number: int, visitor: ReturningVisitor) -> str:
        step = 0
        while not over.is_set() or step < 3:
            step += 1
            value = 1 + number / 100 + step / 1000
            await visitor.change({"k2": value})
            await asyncio.sleep(PACE)
        return _lost(visitor, value)

    changing = [asyncio.create_task(change(number, visitor)) for number, visitor in enumerate(visitors)]
    await asyncio.sleep(after)
    await asyncio.to_thread(happening)
    await asyncio.sleep(after)
    over.set()
    lost = [finding for finding in await asyncio.gather(*changing) if finding]
    await asyncio.gather(*(visitor.leave() for visitor in visitors))
    return FailureTrial(
        max(visitor.longest for visitor in visitors), sum(visitor.returns for visitor in visitors), lost
    )


def _lost(visitor: ReturningVisitor, value: float) -> str:
    """Describe the value that a guest set and no longer sees; empty if nothing is lost."""
    answer = visitor.answer
    page = Page(SCENES["coupled"]())
    true = page.send({"type": "open", "state": {**answer["state"], "parameters": {"k2": value}}, "number": 1})
    for name, shown, meant in (
        ("control", answer["settings"]["k2"]["value"], value),
        ("link", answer["query"], true["query"]),
        ("numbers", answer["view"]["values"], true["view"]["values"]),
        ("motion", answer["view"]["signals"], true["view"]["signals"]),
    ):
        if shown != meant:
            return f"{name}: {shown} in place of {meant}"
    return ""


def failure(site: DeployedSite, guests: int, number: int) -> FailureTrial:
    """Kill a replica; start it again when the guests have left."""
    result = asyncio.run(trial(site, guests, lambda: site.kill(number)))
    site.start(number)
    return result


def upgrade(site: DeployedSite, guests: int, folder: Path) -> FailureTrial:
    """Replace the replicas one by one by copies with other static files."""
    code = upgraded(folder)

    def roll() -> None:
        for number in range(len(site.ports)):
            site.end(number)
            site.start(number, code)

    return asyncio.run(trial(site, guests, roll))
