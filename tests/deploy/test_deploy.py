"""Three replicas behind the real proxy: pages and a class go on when one fails and another ends. Slow requests end."""

import asyncio
import sys
from contextlib import closing, suppress
from http.client import HTTPException
from pathlib import Path
from typing import Any

import pytest

from tests.live_class.caller import Class, Stream, streams_closed, until
from tests.live_class.questions import CHOICE
from tests.live_class.served import Valkey
from tests.serving.server import ROOT
from tests.serving.visitor import ask
from tools.deploy.site import DeployedSite, deployed, upgraded
from tools.deploy.trials import trial

SLOW = (b"GET / HTTP/1.1\r\nHost: x\r\nX-Slow: ", b"POST /class HTTP/1.1\r\nHost: x\r\nContent-Length: 999\r\n\r\n")
"""Requests that come byte by byte. The proxy drops them, but not a stream of a class."""


async def dropped(port: int, start: bytes) -> None:
    """Wait until the proxy closes a connection on which a request never ends."""
    reader, writer = await asyncio.open_connection("127.0.0.1", port)
    writer.write(start)
    with suppress(ConnectionError):
        while not reader.at_eof():
            with suppress(TimeoutError):
                await asyncio.wait_for(reader.read(4096), 0.5)
            writer.write(b"x")
            await writer.drain()
    writer.close()


async def ordered(room: Class, type: str, **order: Any) -> None:
    """Send an order until it is accepted, as the instructor's page does."""
    async with asyncio.timeout(20):
        while True:
            with suppress(OSError, HTTPException):
                if (await room.order(type, **order)).status == 204:
                    return
            await asyncio.sleep(0.1)


@streams_closed()
async def lesson(site: DeployedSite) -> None:
    slow = asyncio.gather(*(dropped(site.port, start) for start in SLOW))
    room = await Class.open(site.url)
    direct = [f"http://127.0.0.1:{port}/" for port in site.ports]
    streams = [await room.follow(url) for url in (*direct[:2], site.url)]
    await ordered(room, "put", **CHOICE)
    for stream in streams:
        await stream.until(lambda event: event.get("question"))
        # The connection may have gone through another replica, which still counts it for some seconds.
        await stream.until(lambda event: event.get("here") == 3)
    assert "X-Accel-Buffering: no" in streams[2].headers
    for i in range(4):
        url = direct[i % 3]
        await room.voted(await room.token(url), url=url, **CHOICE, option=i % 2)

    def happening() -> None:
        site.kill(0)
        site.end(1)

    result = await asyncio.to_thread(asyncio.run, trial(site, 6, happening))
    assert result.lost == [] and result.returned >= 1
    await until(lambda: streams[0].ended and streams[1].ended)
    back = await Stream.open(site.url, room.code, streams[0].word)
    await back.until(lambda event: event.get("question", {}).get("step") == CHOICE["step"])
    await ordered(room, "show")
    await back.until(lambda event: event.get("question", {}).get("lesson"))
    assert (await room.tally())["now"]["options"] == [2, 2, 0]
    await asyncio.wait_for(slow, 40)
    assert not back.ended
    site.front.process.terminate()
    assert await asyncio.to_thread(site.front.process.wait, 9) == 0  # despite the open stream


@pytest.mark.nightly
@pytest.mark.skipif(sys.platform == "win32", reason="no Valkey here")
@pytest.mark.timeout(300)  # three servers start
def test_nothing_is_lost_when_a_replica_fails_another_ends_and_a_later_version_takes_over(tmp_path: Path) -> None:
    codes = (ROOT, ROOT, upgraded(tmp_path / "later"))
    with closing(Valkey()) as valkey, deployed(tmp_path, codes, REDIS_URL=valkey.url) as site:
        page = ask(site.url, "/?scene=oscillator")
        assert page.status == 200 and not {"Server", "Via"} & set(page.headers)
        asyncio.run(lesson(site))
        assert site.complaints() == []
