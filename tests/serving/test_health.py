"""Health and metrics for proxies and operators, and the end of a server."""

from __future__ import annotations

import asyncio
import json
import re
import signal
from pathlib import Path

import pytest
from prometheus_client.parser import text_string_to_metric_families

from tests.attack.caller import Caller, ask, said
from tests.serving.server import ROOT, Server, serving
from tests.serving.visitor import Visitor


@pytest.mark.parametrize("name", ["liveness", "readiness"])
def test_a_server_that_serves_says_so(server: Server, name: str) -> None:
    reply = ask(server.url, f"/{name}", Host="whatever.example")
    assert (reply.status, json.loads(reply.text)) == (200, {f"/{name}": True})


def figures(server: Server) -> dict[str, float]:
    families = text_string_to_metric_families(ask(server.url, "/metrics").text)
    return {sample.name: sample.value for family in families for sample in family.samples if "le" not in sample.labels}


def test_figures_count_what_happens(tmp_path: Path) -> None:
    async def go(server: Server) -> None:
        before = figures(server)
        visitor, caller = await Visitor.arrive(server.url), await Caller.arrive(server.url)
        await visitor.move("x_0", 0.5)
        await caller.send(*said([[[[[[]]]]]]))
        await caller.closed()
        ask(server.url, "/nowhere")
        now = figures(server)
        assert now["oscillations_arrivals_total"] - before["oscillations_arrivals_total"] == 2
        assert now["oscillations_change_seconds_count"] == 2  # the other says that the page is ready
        assert (now["oscillations_sessions"], now["oscillations_sockets"]) == (2, 1)
        assert now["oscillations_measurements"] == 0
        assert (now["oscillations_line"], now["oscillations_errors_total"], now["oscillations_answers"]) == (0, 0, 0)
        assert now["oscillations_build_info"] == 1
        assert now["process_resident_memory_bytes"] > 1e7
        async with asyncio.timeout(30):  # it is measured periodically
            while (
                figures(server)["oscillations_loop_lag_seconds_count"] <= before["oscillations_loop_lag_seconds_count"]
            ):
                await asyncio.sleep(0.05)
        text = ask(server.url, "/metrics").text
        assert 'oscillations_refused_total{what="socket 1008"} 1.0' in text
        assert 'oscillations_refused_total{what="request 404"} 1.0' in text
        await visitor.depart()

    with serving(tmp_path / "log") as server:
        asyncio.run(go(server))


def test_each_figure_has_its_alert_in_the_documentation(server: Server) -> None:
    told = {family.name for family in text_string_to_metric_families(ask(server.url, "/metrics").text)}
    listed = set(re.findall(r"^\| `(\w+?)(?:_total)?` \|", (ROOT / "docs" / "deployment.md").read_text("utf-8"), re.M))
    alerts = {name for name in listed if name.startswith(("oscillations_", "process_"))}
    assert alerts <= told
    assert {name for name in told if name.startswith("oscillations_") and not name.endswith("_created")} <= alerts


def test_figures_are_for_this_machine_and_those_who_are_named(tmp_path: Path) -> None:
    environment = {"TRUSTED_PROXIES": "127.0.0.1", "METRICS_FOR": "198.51.100.0/24, 2001:db8::7"}
    with serving(tmp_path / "log", environment=environment) as server:
        for address, status in (
            ("198.51.100.9", 200),
            ("2001:db8::7", 200),
            ("203.0.113.9", 404),
            ("2001:db8::8", 404),
        ):
            assert ask(server.url, "/metrics", X_Forwarded_For=address).status == status
        refused = ask(server.url, "/metrics", X_Forwarded_For="203.0.113.9")
        assert "There is no such page here." in refused.text and "oscillations_" not in refused.text
        assert ask(server.url, "/liveness", X_Forwarded_For="203.0.113.9").status == 200


def test_figures_are_not_for_who_comes_by_a_proxy_of_which_nothing_is_known(server: Server) -> None:
    assert ask(server.url, "/metrics").status == 200
    assert ask(server.url, "/metrics", X_Forwarded_For="127.0.0.1").status == 404


def test_the_end_is_announced_then_visitors_are_sent_away_then_all_is_over(tmp_path: Path) -> None:
    async def go(server: Server) -> None:
        caller = await Caller.arrive(server.url)
        server.process.send_signal(signal.SIGTERM)
        while ask(server.url, "/readiness").status == 200:
            await asyncio.sleep(0.01)
        assert ask(server.url, "/liveness").status == 200
        assert await caller.closed() == (1001, "The server is shutting down.")

    with serving(tmp_path / "log", options=("--notice-seconds", "1")) as server:
        asyncio.run(go(server))
        assert server.process.wait(10) == 0
        assert not server.complaints()
        assert "The lecture has ended" in server.log.read_text()


def test_the_log_has_no_visitor_in_it(tmp_path: Path) -> None:
    with serving(tmp_path / "log", options=("--log-format", "json")) as server:
        ask(server.url, "/?k2=31337")
        ask(server.url, "/?bokeh-session-id=31337")
        ask(server.url, "/%00", "PUT")
        ask(server.url, "/liveness")
    lines = [json.loads(line) for line in server.log.read_text().splitlines()]
    asked = [(line["status"], line["path"]) for line in lines if "status" in line]
    assert asked == [(200, "/"), (403, "/"), (404, "/%00")]
    text = server.log.read_text().replace(f"http://127.0.0.1:{server.port}/", "")
    assert not re.search(r"127\.0\.0\.1|31337", text)


def test_the_log_has_visitors_where_that_is_asked_for(tmp_path: Path) -> None:
    with serving(tmp_path / "log", options=("--log-visitors",)) as server:
        ask(server.url, "/?k2=3")
    assert re.search(r"200 GET /\?k2=3 [\d.]+ 127\.0\.0\.1", server.log.read_text())
