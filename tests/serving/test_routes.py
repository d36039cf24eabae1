"""Every route of the server under every abuse: a worded refusal or the usual answer, and others are served."""

import re
from typing import NamedTuple

import pytest

from components.language.messages import File
from components.serving.assets import assets
from components.serving.csv_route import NumbersRoute
from components.serving.incoming import MOST_BYTES
from components.serving.server import Server
from components.session.worker import Replied
from tests.grids import sample
from tests.live_class.caller import Answered
from tests.serving.served import MUCH, FakeWorker, page_of, served, sessions
from tests.serving.server import Server as Running
from tools.attack.protocol import attack

PAGE, NUMBERS, SOCKET, METRICS, NOWHERE = "/", "/data.csv", "/ws", "/metrics", "/nowhere"
FILE = f"/assets/{next(iter(assets()))}"
PLAIN = {PAGE: 200, NUMBERS: 200, SOCKET: 403, FILE: 200, "/app": 302, "/app/": 302, METRICS: 200, NOWHERE: 404}
"""The status of a plain request, 200 for other routes."""
PAGES = (PAGE, NUMBERS, SOCKET)
"""The routes that answer only under the server's own names."""
READ_ONLY = "This page can only be read."
OTHER_NAME = "This server is not known by this address."
NO_SESSION = "A link cannot name a session"


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
    "a session in the link": Abuse({PAGE: 403}, NO_SESSION, query="bokeh-session-id=klass"),
    "too many a minute": Abuse(
        {PAGE: 429, NUMBERS: 429}, "Too many pages were opened from this network", settings={"arrivals": 1}
    ),
    "no place": Abuse({PAGE: 503}, "you are first in line", settings={"sessions": 1}),
    "no computing time": Abuse({NUMBERS: 429}, "Later.", seconds=1.5),
}


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
    assert headers["Permissions-Policy"].startswith("camera=(), ")
    assert "Server" not in headers
    assert (int(headers.get("Retry-After", "1")) >= 1) and (reply.status != 429 or "Retry-After" in headers)


ALONE = [name for name, abuse in ABUSES.items() if abuse.settings or abuse.seconds]


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
