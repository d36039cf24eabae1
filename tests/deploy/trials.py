"""Trials of visitors while a replica fails or is upgraded: nothing that they set is lost."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from components.scenes import SCENES
from tests.deploy.guest import Guest
from tests.deploy.site import Site, upgraded
from tests.page.headless_page import Page

PACE = 0.25
"""Seconds from one change of a guest to the next."""


@dataclass(frozen=True)
class Trial:
    """The outcome of a trial for the guests."""

    longest: float
    """Seconds that a change took at most."""
    returned: int
    lost: list[str]
    """Sentences on guests who see something other than what they set."""


async def trial(site: Site, guests: int, happening: Callable[[], None], after: float = 1.0) -> Trial:
    """Guests change things, something happens after so many seconds, and they go on as long again."""
    visitors = [Guest(site.url, cookies=bool(i % 2)) for i in range(guests)]
    await asyncio.gather(*(visitor.arrive("scene=coupled") for visitor in visitors))
    over = asyncio.Event()

    async def change(number: int, visitor: Guest) -> str:
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
    return Trial(max(visitor.longest for visitor in visitors), sum(visitor.returns for visitor in visitors), lost)


def _lost(visitor: Guest, value: float) -> str:
    """The value that a guest set and no longer sees, in words; empty where all is as set."""
    told = visitor.told
    page = Page(SCENES["coupled"]())
    true = page.say({"type": "open", "state": {**told["state"], "parameters": {"k2": value}}, "number": 1})
    for name, shown, meant in (
        ("control", told["settings"]["k2"]["value"], value),
        ("link", told["query"], true["query"]),
        ("numbers", told["view"]["values"], true["view"]["values"]),
        ("motion", told["view"]["signals"], true["view"]["signals"]),
    ):
        if shown != meant:
            return f"{name}: {shown} in place of {meant}"
    return ""


def failure(site: Site, guests: int, number: int) -> Trial:
    """A replica fails; it is there again when the guests have gone."""
    result = asyncio.run(trial(site, guests, lambda: site.kill(number)))
    site.start(number)
    return result


def upgrade(site: Site, guests: int, folder: Path) -> Trial:
    """One replica after the other ends and comes back with other static files."""
    code = upgraded(folder)

    def roll() -> None:
        for number in range(len(site.ports)):
            site.end(number)
            site.start(number, code)

    return asyncio.run(trial(site, guests, roll))
