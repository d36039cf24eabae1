"""The short form of `make deploy-test`: one replica fails, another ends, and one with other static files takes over."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest

from tests.attack.caller import ask
from tests.serving.server import ROOT
from tools.deploy.site import deployed, upgraded
from tools.deploy.trials import trial


@pytest.mark.slow
@pytest.mark.timeout(300)  # three servers start
def test_nothing_is_lost_when_a_replica_fails_another_ends_and_a_later_version_takes_over(tmp_path: Path) -> None:
    with deployed(tmp_path, (ROOT, ROOT, upgraded(tmp_path / "later"))) as site:
        page = ask(site.url, "/?scene=oscillator")
        assert page.status == 200
        assert not {"Server", "Via"} & set(page.headers)
        assert [ask(site.url, path).status for path in ("/metrics", "/liveness", "/readiness")] == [404] * 3

        def happening() -> None:
            site.kill(0)
            site.end(1)

        result = asyncio.run(trial(site, 6, happening))
        assert result.lost == []
        assert result.returned >= 1
        assert site.complaints() == []
        site.kill(2)
        unavailable = ask(site.url, "/?scene=coupled&k2=3")
        assert unavailable.status in (502, 503) and not {"Server", "Via"} & set(unavailable.headers)
        assert "The lecture does not answer now" in unavailable.text and 'http-equiv="refresh"' in unavailable.text
    log = (tmp_path / "proxy.log").read_text()
    assert "http.log.error" in log
    assert not [line for line in log.splitlines() if "k2=3" in line or "remote_ip" in line]
