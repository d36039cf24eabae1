"""Tests of the proxy without the server: headers of error pages, timeouts, shutdown."""

from __future__ import annotations

import asyncio
import hmac
import json
import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from components.serving.assets import assets
from components.serving.headers import SAFE
from tests.attack.caller import Reply, ask
from tests.deploy.health import health_check
from tests.live_class.caller import Class, streams_closed
from tests.serving.server import ROOT, free_port, serving
from tools.deploy.site import COOKIE_SECRET, DeployedSite, behind_caddy, caddy, deployed

ASSET = f"/assets/{next(iter(assets()))}"


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Iterator[DeployedSite]:
    with deployed(tmp_path_factory.mktemp("site"), (ROOT,)) as running:
        yield running


def safety_headers(reply: Reply) -> dict[str, str]:
    return {name: reply.headers.get(name, "") for name in SAFE}


def test_the_proxys_own_pages_have_the_lectures_safety_headers(site: DeployedSite) -> None:
    own = ask(site.url, "/metrics")
    assert own.status == 404 and safety_headers(own) == safety_headers(ask(site.url, "/")) == SAFE
    assert own.headers["Content-Security-Policy"].startswith("default-src 'none'")
    assert "frame-ancestors" in ask(site.url, "/").headers["Content-Security-Policy"]


def test_the_replica_cookie_is_signed_and_not_sent_with_cached_files(site: DeployedSite) -> None:
    assert ask(site.url, "/").headers["Set-Cookie"].startswith("replica=")
    file = ask(site.url, ASSET)
    assert (file.status, "Set-Cookie" in file.headers) == (200, False)
    assert "immutable" in file.headers["Cache-Control"]
    written = hmac.new(COOKIE_SECRET.encode(), f"127.0.0.1:{site.ports[0]}".encode(), "sha256").hexdigest()
    assert ask(site.url, "/").headers["Set-Cookie"].startswith(f"replica={written};")


@pytest.mark.slow
@pytest.mark.timeout(240)
def test_the_proxy_drops_slow_requests_and_ends_despite_open_streams(tmp_path: Path) -> None:
    """A request that comes byte by byte is dropped; a stream of a class stays open."""

    @streams_closed()
    async def go(site: DeployedSite) -> None:
        room = await Class.open(site.url)
        stream = await room.follow()
        slow = [
            b"GET / HTTP/1.1\r\nHost: x\r\nX-Slow: ",
            b"POST /class HTTP/1.1\r\nHost: x\r\nContent-Length: 999\r\n\r\n",
        ]
        begun = [asyncio.create_task(dropped(site.port, start)) for start in slow]
        await asyncio.wait_for(asyncio.gather(*begun), 40)
        assert (await room.order("put", walk="d31", step="d31-03")).status == 204
        await stream.until(lambda event: event.get("question"))
        site.front.process.terminate()
        assert await asyncio.to_thread(site.front.process.wait, 9) == 0

    with deployed(tmp_path, (ROOT,)) as site:
        asyncio.run(go(site))


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


@pytest.mark.skipif(sys.platform == "win32", reason="no sh here")
def test_the_proxy_is_healthy_without_replicas(site: DeployedSite, tmp_path: Path) -> None:
    healthy = health_check(tmp_path, "proxy")
    assert healthy(80, site.port) == 0 and healthy(80, free_port()) != 0
    alone = {**behind_caddy(site)[1], "SITE": f"http://127.0.0.1:{(port := free_port())}", "UPSTREAMS": "127.0.0.1:1"}
    with serving(tmp_path / "log", port=port, command=behind_caddy(site)[0], environment=alone):
        assert healthy(80, port) == 0


def parts(recipe: Any) -> Iterator[dict[str, Any]]:
    """Yield all objects of a configuration, at any depth."""
    if isinstance(recipe, dict):
        yield recipe
    for part in recipe.values() if isinstance(recipe, dict) else recipe if isinstance(recipe, list) else ():
        yield from parts(part)


def test_hsts_is_sent_except_on_localhost_where_it_would_cover_all_ports() -> None:
    command = [caddy(), "adapt", "--config", str(ROOT / "Caddyfile"), "--adapter", "caddyfile"]
    adapted = subprocess.run(command, capture_output=True, text=True, check=True, env={"SITE": "lecture.example"})
    held = [
        part["match"]
        for part in parts(json.loads(adapted.stdout))
        if "Strict-Transport-Security" in str(part.get("handle", [{}])[0].get("response"))
    ]
    assert len(held) == 2  # the lecture's pages, and the proxy's own pages
    assert all(match == [{"not": [{"host": ["localhost", "127.0.0.1", "::1"]}], "protocol": "https"}] for match in held)
