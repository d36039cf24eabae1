"""Health and metrics for proxies and operators, the log, and the end of a server."""

import asyncio
import json
import logging
import re
import signal
from pathlib import Path

import pytest
from prometheus_client.parser import text_string_to_metric_families

from app import FIGURES
from components.serving.server import Server as Serving
from tests.live_class.caller import until
from tests.serving.served import page_of, served, url
from tests.serving.server import Server, serving
from tests.serving.visitor import Caller, Visitor, ask, said


async def figures(server: Serving) -> dict[str, float]:
    families = text_string_to_metric_families((await page_of(server, "/metrics")).text)
    samples = [sample for family in families for sample in family.samples if "le" not in sample.labels]
    names = (f"{one.name} {one.labels.get('what', '')}".strip().removeprefix("oscillations_") for one in samples)
    return dict(zip(names, (one.value for one in samples), strict=True))


async def test_figures_count_what_happens() -> None:
    async with served(figures=FIGURES) as server:
        before = await figures(server)
        visitor, caller = await Visitor.arrive(url(server)), await Caller.arrive(url(server))
        await visitor.move("x_0", 0.5)
        await caller.write(*said([[[[[[]]]]]]))
        await caller.closed()
        await page_of(server, "/nowhere")
        logging.getLogger("components").error("of the test")
        await until(lambda: b"loop_lag_seconds_count 0.0" not in server.context.metrics.text())
        now = await figures(server)
        assert now["arrivals_total"] - before["arrivals_total"] == 2
        assert now["change_seconds_count"] == 2  # the other says that the page is ready
        assert (now["sessions"], now["sockets"], now["measurements"], now["line"]) == (2, 1, 0, 0)
        assert (now["errors_total"], now["build_info"]) == (1, 1)
        assert (now["refused_total socket 1008"], now["refused_total request 404"]) == (1, 1)
        assert now["process_resident_memory_bytes"] > 1e7
        await visitor.depart()


async def test_figures_are_for_this_machine_and_those_who_are_named_and_the_log_may_name_visitors(
    caplog: pytest.LogCaptureFixture,
) -> None:
    caplog.set_level("INFO")
    named = ("198.51.100.0/24", "2001:db8::7")
    asked = {"198.51.100.9": 200, "2001:db8::7": 200, "203.0.113.9": 404, "2001:db8::8": 404}
    async with served(trusted_proxies=("127.0.0.1",), metrics_for=named) as server, served(log_visitors=True) as alone:
        for address, status in asked.items():
            reply = await page_of(server, "/metrics", X_Forwarded_For=address)
            assert reply.status == status and ("oscillations_" in reply.text) == (status == 200)
        assert (await page_of(server, "/liveness", X_Forwarded_For="203.0.113.9")).status == 200
        assert (await page_of(alone, "/metrics")).status == 200
        assert (await page_of(alone, "/app?k2=3")).status == 302
        assert re.search(r"302 GET /app\?k2=3 [\d.]+ 127\.0\.0\.1", caplog.text)
        assert (await page_of(alone, "/metrics", X_Forwarded_For="127.0.0.1")).status == 404, "by an unknown proxy"


def test_a_server_announces_its_end_sends_visitors_away_and_logs_none_of_them(tmp_path: Path) -> None:
    """The log also says first that the server starts, and names a misspelt variable."""

    async def end(server: Server) -> None:
        caller = await Caller.arrive(server.url)
        server.process.send_signal(signal.SIGTERM)
        while ask(server.url, "/readiness").status == 200:
            await asyncio.sleep(0.01)
        assert ask(server.url, "/liveness").status == 200
        assert await caller.closed() == (1001, "The server is shutting down.")

    options = ("--notice-seconds", "1", "--log-format", "json")
    with serving(tmp_path / "log", options=options, environment={"SESIONS": "5"}) as server:
        for path, method in (("/?k2=31337", "GET"), ("/?bokeh-session-id=31337", "GET"), ("/%00", "PUT")):
            ask(server.url, path, method)
        asyncio.run(end(server))
        assert server.process.wait(10) == 0
    text = server.log.read_text()
    lines = [json.loads(line) for line in text.splitlines()]
    messages = [line["message"] for line in lines]
    assert messages[0] == "The server starts" and messages[-1] == "The lecture has ended"
    assert [line["level"] for line in lines if "Did you mean SESSIONS?" in line["message"]] == ["WARNING"]
    assert not any(line["level"] in ("ERROR", "CRITICAL") for line in lines)
    asked = [(line["status"], line["path"]) for line in lines if "status" in line]
    assert asked[:3] == [(200, "/"), (403, "/"), (404, "/%00")]
    assert not re.search(r"127\.0\.0\.1|31337", text.replace(f"http://127.0.0.1:{server.port}/", ""))
