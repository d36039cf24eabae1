"""The proxy of compose.yaml with one replica and with none: headers, its own pages, its health check."""

from __future__ import annotations

import hmac
import json
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from components.serving.assets import assets
from components.serving.headers import SAFE
from tests.attack.caller import ask
from tests.deploy.health import health_check
from tests.serving.server import ROOT, free_port, serving
from tools.deploy.site import COOKIE_SECRET, DeployedSite, behind_caddy, caddy, deployed

ASSET = f"/assets/{next(iter(assets()))}"


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Iterator[DeployedSite]:
    with deployed(tmp_path_factory.mktemp("site"), (ROOT,)) as running:
        yield running


def test_pages_of_the_proxy_and_of_the_lecture_have_the_same_safety_headers(site: DeployedSite) -> None:
    page, file = ask(site.url, "/"), ask(site.url, ASSET)
    for path in ("/metrics", "/liveness", "/readiness"):
        own = ask(site.url, path)
        assert own.status == 404 and SAFE.items() <= own.headers.items() and SAFE.items() <= page.headers.items()
        assert own.headers["Content-Security-Policy"].startswith("default-src 'none'")
    assert "frame-ancestors" in page.headers["Content-Security-Policy"]
    # The cookie that names the replica is signed, and not sent with cached files.
    written = hmac.new(COOKIE_SECRET.encode(), f"127.0.0.1:{site.ports[0]}".encode(), "sha256").hexdigest()
    assert page.headers["Set-Cookie"].startswith(f"replica={written};")
    assert (file.status, "Set-Cookie" in file.headers) == (200, False)
    assert "immutable" in file.headers["Cache-Control"]


@pytest.mark.skipif(sys.platform == "win32", reason="no sh here")
def test_a_proxy_without_replicas_is_healthy_and_says_that_the_lecture_does_not_answer(
    site: DeployedSite, tmp_path: Path
) -> None:
    healthy = health_check(tmp_path, "proxy")
    assert healthy(80, site.port) == 0 and healthy(80, free_port()) != 0
    alone = {**behind_caddy(site)[1], "SITE": f"http://127.0.0.1:{(port := free_port())}", "UPSTREAMS": "127.0.0.1:1"}
    with serving(tmp_path / "log", port=port, command=behind_caddy(site)[0], environment=alone) as proxy:
        assert healthy(80, port) == 0
        unavailable = ask(proxy.url, "/?scene=coupled&k2=3")
    assert unavailable.status in (502, 503) and not {"Server", "Via"} & set(unavailable.headers)
    assert "The lecture does not answer now" in unavailable.text and 'http-equiv="refresh"' in unavailable.text
    assert "http.log.error" in (log := proxy.log.read_text()) and not re.search("k2=3|remote_ip", log)


def test_hsts_is_sent_except_on_localhost_where_it_would_cover_all_ports() -> None:
    command = [caddy(), "adapt", "--config", str(ROOT / "Caddyfile"), "--adapter", "caddyfile"]
    adapted = subprocess.run(command, capture_output=True, text=True, check=True, env={"SITE": "lecture.example"})
    held = list[Any]()

    def note(part: dict[str, Any]) -> dict[str, Any]:
        if "Strict-Transport-Security" in str(part.get("handle", [{}])[0].get("response")):
            held.append(part["match"])
        return part

    json.loads(adapted.stdout, object_hook=note)
    assert len(held) == 2  # the lecture's pages, and the proxy's own pages
    assert all(match == [{"not": [{"host": ["localhost", "127.0.0.1", "::1"]}], "protocol": "https"}] for match in held)
