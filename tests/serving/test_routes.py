"""Every route of the server under every abuse: a worded refusal or the usual answer, and others are served. Health and
metrics, the log, and the end of a server. `panel serve app.py`.
"""

import asyncio
import html
import json
import logging
import re
import signal
from pathlib import Path
from typing import NamedTuple

import panel.models  # noqa: F401  # what is pulled is of its classes
import pytest
from bokeh.client import pull_session
from prometheus_client.parser import text_string_to_metric_families

from app import FIGURES
from components.language.messages import File
from components.scenes import SCENES
from components.serving.assets import assets
from components.serving.csv_route import NumbersRoute
from components.serving.incoming import MOST_BYTES
from components.serving.server import Server
from components.session.worker import Replied
from tests.grids import sample
from tests.live_class.caller import Answered, until
from tests.serving.served import MUCH, FakeWorker, page_of, served, sessions, url
from tests.serving.server import Server as Running
from tests.serving.server import serving, serving_panel
from tests.serving.visitor import Caller, Visitor, ask, said
from tools.attack.protocol import attack

PAGE, NUMBERS, SOCKET, METRICS, NOWHERE = "/", "/data.csv", "/ws", "/metrics", "/nowhere"
FILE = f"/assets/{next(iter(assets()))}"
PLAIN = {PAGE: 200, NUMBERS: 200, SOCKET: 403, FILE: 200, "/app": 302, "/app/": 302, METRICS: 200, NOWHERE: 404}
"""The status of a plain request, 200 for other routes."""
PAGES = (PAGE, NUMBERS, SOCKET)
"""The routes that answer only under the server's own names."""
READ_ONLY = "This page can only be read."
OTHER_NAME = "This server is not known by this address."


class Abuse(NamedTuple):
    """A request to each route, and the routes that refuse it; the others answer it like a plain request."""

    refused: dict[str, int] = {}
    says: str = ""
    method: str = "GET"
    query: str = ""
    headers: dict[str, str] = {}
    settings: dict[str, int] = {}
    seconds: float = 0.0
    """The time for which the worker asks clients to wait."""


WRITES = {"*": 405, SOCKET: 403, NOWHERE: 404}
ABUSES = {
    "nothing": Abuse(),
    "HEAD": Abuse({METRICS: 405}, method="HEAD"),
    **{method: Abuse(WRITES, READ_ONLY, method) for method in sample(("POST", "PUT", "DELETE", "PATCH", "OPTIONS"))},
    "TRACE": Abuse({"*": 405}, READ_ONLY, "TRACE"),
    "another host": Abuse(dict.fromkeys(PAGES, 403), OTHER_NAME, headers={"Host": "attacker.example"}),
    "no host": Abuse(dict.fromkeys(PAGES, 403), OTHER_NAME, headers={"Host": "["}),
    "a long link": Abuse({PAGE: 414, NUMBERS: 414}, "This link is too long", query="x" * 9000),
    "a session in the link": Abuse({PAGE: 403}, "A link cannot name a session", query="bokeh-session-id=klass"),
    "too many a minute": Abuse(
        {PAGE: 429, NUMBERS: 429}, "Too many pages were opened from this network", settings={"arrivals": 1}
    ),
    "no place": Abuse({PAGE: 503}, "you are first in line", settings={"sessions": 1}),
    "no computing time": Abuse({NUMBERS: 429}, "Later.", seconds=1.5),
}
ALONE = [name for name, abuse in ABUSES.items() if abuse.settings or abuse.seconds]
FILED = Replied(file=File(answer=None, name="coupled.csv", kind="text/csv", content=b"x1 [m]\n"))


def routes(server: Server) -> list[str]:
    """Return an address of each route in the server's own list."""
    *_, ours, _ = server.lecture.default_router.rules
    patterns = [rule.matcher.regex.pattern.removesuffix("$") for rule in ours.target.rules]
    examples = {r"/assets/(.*)": FILE, r".*": NOWHERE}
    found = [examples.get(pattern, pattern.replace("\\.", ".")) for pattern in patterns]
    assert all(re.fullmatch(pattern, path) for pattern, path in zip(patterns, found, strict=True)), "give an example"
    return found


def check_safe(reply: Answered) -> None:
    headers = reply.headers
    assert reply.quiet and (reply.status < 500 or reply.status == 503)
    assert headers["X-Content-Type-Options"] == "nosniff" and headers["Referrer-Policy"] == "no-referrer"
    policy = headers["Content-Security-Policy"]
    assert policy.endswith("frame-ancestors 'self'")
    assert {"default-src 'none'", "base-uri 'none'", "form-action 'none'"} <= set(policy.split("; "))
    assert headers["Permissions-Policy"].startswith("camera=(), ") and "Server" not in headers
    assert (int(headers.get("Retry-After", "1")) >= 1) and (reply.status != 429 or "Retry-After" in headers)


@pytest.mark.parametrize("alone", ["none", *ALONE])
async def test_every_route_refuses_abuse_in_words_and_serves_others(alone: str, subtests: pytest.Subtests) -> None:
    _, _, _, _, _, settings, seconds = ABUSES.get(alone, Abuse())
    reply = Replied(refused="Later.", is_busy=True, after=seconds) if seconds else FILED
    numbers = NumbersRoute(FakeWorker(reply), settings.get("arrivals", MUCH))
    async with served(extensions=[numbers], **settings) as server:
        paths = routes(server)
        assert len(paths) == 10
        for name in [alone] if alone in ABUSES else [name for name in ABUSES if name not in ALONE]:
            abuse, before = ABUSES[name], len(sessions(server))
            with subtests.test(name):
                for path in paths:
                    if settings:
                        await page_of(server, path)
                    reply = await page_of(server, f"{path}?{abuse.query}", abuse.method, **abuse.headers)
                    expected = abuse.refused.get(path, abuse.refused.get("*", PLAIN.get(path, 200)))
                    assert reply.status == expected, path
                    check_safe(reply)
                    if path in abuse.refused or "*" in abuse.refused:
                        assert abuse.says in reply.text or path in (SOCKET, NOWHERE), path
                opens = settings or (abuse.method == "GET" and PAGE not in abuse.refused)
                assert len(sessions(server)) - before == bool(opens)
        for path in paths:
            assert (await page_of(server, path, "POST", Content_Length=str(2 * MOST_BYTES))).status == 400, path
        assert (await page_of(server, "/liveness")).status == 200


def test_no_abuse_of_the_protocol_gets_through(server: Running) -> None:
    found = attack(server.url, short=True)
    assert [finding for finding in found if not finding.passed] == []
    assert len(found) > 90


async def figures(server: Server) -> dict[str, float]:
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


async def test_figures_are_for_named_readers_and_the_log_may_name_visitors(caplog: pytest.LogCaptureFixture) -> None:
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

    async def end(server: Running) -> None:
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


@pytest.mark.slow
def test_a_page_has_the_menu_and_says_how_the_lecture_is_started_and_what_of_a_link_cannot_be(tmp_path: Path) -> None:
    with serving_panel(tmp_path / "log") as server:
        address = f"http://localhost:{server.port}/app"
        session = pull_session(url=address, arguments={"scene": "coupled", "k2": "3", "k1": "many"})
        models = session.document.models
        text = html.unescape(" ".join(str(getattr(model, "text", "")) for model in models))
        fields = [model.value for model in models if type(model).__name__ == "TextInput"]
        session.close()
    assert all(f'href="?scene={slug}"' in text and scene.title in text for slug, scene in SCENES.items())
    for says in ("The whole lecture", "make run", "python -m components.serving --show", "“many” is not a number"):
        assert says in text
    assert {"3.00", "4.00"} <= set(fields)
