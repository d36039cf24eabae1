"""A live class on two replicas behind the real proxy, with a shared Valkey, continues when one replica is killed."""

from __future__ import annotations

import asyncio
import sys
from http.client import HTTPException
from pathlib import Path
from typing import Any

import pytest

from tests.live_class.caller import Answered, Class, Stream, called, streams_closed
from tests.live_class.stores import valkey_running
from tests.serving.server import ROOT
from tools.deploy.site import DeployedSite, deployed

CHOICE = {"walk": "d31", "step": "d31-03"}
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="no Valkey here")


async def ordered(room: Class, type: str, **order: Any) -> Answered:
    """Send an order until it is accepted, as the instructor's page does."""
    async with asyncio.timeout(20):
        while True:
            try:
                answer = await room.order(type, **order)
                if answer.status == 204:
                    return answer
            except (OSError, HTTPException):
                pass
            await asyncio.sleep(0.1)


@streams_closed()
async def lesson(site: DeployedSite) -> None:
    room = await Class.open(site.url)
    direct = [f"http://127.0.0.1:{port}/" for port in site.ports]
    streams = [await room.follow(url) for url in direct]
    through = await room.follow()
    await ordered(room, "put", **CHOICE)
    for stream in (*streams, through):
        await stream.until(lambda event: event.get("question"))
        # The connection may have gone through the other replica, which still counts it for some seconds.
        await stream.until(lambda event: event.get("here") == 3, 20)
    voters = [await room.follow(direct[i % 2]) for i in range(4)]
    for i, voter in enumerate(voters):
        assert (await room.vote(voter.word, direct[i % 2], **CHOICE, option=i % 2)).status == 204
    assert "X-Accel-Buffering: no" in through.headers
    site.kill(0)
    async with asyncio.timeout(30):
        while not streams[0].ended:
            await asyncio.sleep(0.02)
    back = await Stream(site.url, room.code, streams[0].word).open()
    whole = await back.until(lambda event: event.get("question"))
    assert whole["question"]["step"] == CHOICE["step"]
    await ordered(room, "show")
    for stream in (streams[1], back):
        await stream.until(lambda event: event.get("question", {}).get("lesson"))
    tally = (await called(direct[1], f"/class/{room.code}/tally", word=room.key)).json
    assert tally["now"]["options"] == [2, 2, 0]


@pytest.mark.slow
@pytest.mark.timeout(240)
def test_a_class_continues_when_a_replica_is_killed(tmp_path: Path) -> None:
    with valkey_running() as valkey, deployed(tmp_path, (ROOT, ROOT), REDIS_URL=valkey.url) as site:
        asyncio.run(lesson(site))
        assert site.complaints() == []
