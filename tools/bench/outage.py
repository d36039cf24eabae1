"""A class on two replicas behind the real proxy, which share a Valkey: one is killed while the instructor drags."""

from __future__ import annotations

import asyncio
import time
from contextlib import closing
from pathlib import Path
from urllib.parse import urlsplit

from tests.live_class.caller import Class
from tests.live_class.served import Valkey
from tests.serving.server import ROOT
from tests.serving.visitor import Visitor
from tools.bench.followers import Hearing, drag, values
from tools.deploy.site import DeployedSite, deployed

AGAIN = 0.2
"""Seconds between tries of a follower that is lost: a page's are as many at first."""


class Returning:
    """One follower through the proxy, who comes back when it is lost."""

    def __init__(self, url: str, room: Class, token: str) -> None:
        self._host = urlsplit(url)
        lines = [f"GET /class/{room.code}/events HTTP/1.1", f"Host: {self._host.netloc}"]
        self._head = "\r\n".join([*lines, f"Authorization: Bearer {token}", "", ""]).encode()
        self.parts: list[Hearing] = []
        self.back = 0.0

    async def follow(self) -> None:
        """Until it hears something."""
        while True:
            try:
                _, hearing = await asyncio.get_running_loop().create_connection(
                    lambda: Hearing(self._head), self._host.hostname, self._host.port
                )
            except OSError:
                await asyncio.sleep(AGAIN)
                continue
            while not (hearing.heard or hearing.lost):
                await asyncio.sleep(0.01)
            if hearing.heard:
                self.parts.append(hearing)
                return
            await asyncio.sleep(AGAIN)

    async def stay(self) -> None:
        """Come back once."""
        while not self.parts[-1].lost:
            await asyncio.sleep(0.01)
        lost = time.time()
        await self.follow()
        self.back = time.time() - lost

    def last(self, shown: dict[int, float]) -> float | None:
        """The newest picture's value."""
        known = [shown[key] for _, key in self.parts[-1].heard if key in shown]
        return known[-1] if known else None


async def outlived(folder: Path, count: int, seconds: float) -> tuple[int, list[float], int]:
    """The number lost with a replica, the seconds until each was back, and the number that lack the last picture."""
    with closing(Valkey()) as valkey, deployed(folder, (ROOT, ROOT), REDIS_URL=valkey.url) as site:
        return await _class_of(site, count, seconds)


async def _class_of(site: DeployedSite, count: int, seconds: float) -> tuple[int, list[float], int]:
    Hearing.EVENTS.clear()
    room = await Class.open(site.url)
    visitor = await Visitor.arrive(f"http://127.0.0.1:{site.ports[1]}/", "scene=coupled")
    await visitor.send({"type": "lead", "code": room.code, "key": room.key})
    followers = [Returning(site.url, room, await room.token()) for _ in range(count)]
    await asyncio.gather(*(one.follow() for one in followers))
    staying = [asyncio.create_task(one.stay()) for one in followers]
    await drag(visitor, seconds / 2)
    await asyncio.to_thread(site.kill, 0)
    sent = await drag(visitor, max(seconds / 2, 5.0))
    await asyncio.sleep(2.0)
    shown, newest = values("k2"), list(sent)[-1]
    back = [one.back for one in followers if one.back]
    missed = sum(one.last(shown) != newest for one in followers)
    for task, one in zip(staying, followers, strict=True):
        task.cancel()
        one.parts[-1].transport.close()
    await visitor.depart()
    return len(back), back, missed
