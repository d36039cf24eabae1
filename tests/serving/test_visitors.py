"""The client address that the server trusts, and the number of pages that one network may open."""

from __future__ import annotations

import pytest
from bokeh.util.token import generate_jwt_token, generate_session_id

from components.serving.admission import RETURNS
from components.serving.visitors import MINUTE, Arrivals, Rate, networks, visitor
from tests.attack.caller import contents, token_of
from tests.live_class.caller import Answered
from tests.serving.served import page_of, served, sessions

TRUSTED = networks(["10.0.0.0/24", "fd00::1"])


@pytest.mark.parametrize(
    ("peer", "forwarded", "found"),
    [
        ("203.0.113.9", "", "203.0.113.9"),
        ("203.0.113.9", "198.51.100.1", "203.0.113.9"),
        ("10.0.0.2", "198.51.100.1", "198.51.100.1"),
        ("10.0.0.2", "192.0.2.66, 198.51.100.1", "198.51.100.1"),
        ("10.0.0.2", "192.0.2.66, 198.51.100.1, 10.0.0.3", "198.51.100.1"),
        ("fd00::1", "2001:db8::7", "2001:db8::7"),
        ("10.0.0.2", "", "10.0.0.2"),
        ("10.0.0.2", "unknown", "10.0.0.2"),
        ("10.0.0.2", "10.0.0.4, 10.0.0.3", "10.0.0.4"),
    ],
)
def test_forwarded_addresses_are_believed_from_named_proxies_only(peer: str, forwarded: str, found: str) -> None:
    assert visitor(peer, forwarded, TRUSTED) == found


def test_a_class_arrives_at_once_and_a_flood_of_its_network_does_not() -> None:
    now = 0.0
    arrivals = Arrivals(300, lambda: now)
    assert [arrivals.admit(f"192.0.2.{i % 200}") for i in range(300)] == [0.0] * 300
    assert arrivals.admit("192.0.2.7") == pytest.approx(0.2)
    assert arrivals.admit("198.51.100.7") == 0.0
    now = 0.2
    assert arrivals.admit("192.0.2.7") == 0.0 < arrivals.admit("192.0.2.7")
    for i in range(1000):
        arrivals.admit(f"10.{i // 256}.{i % 256}.1")
    now = 1000.0
    assert [arrivals.admit("192.0.2.7") for _ in range(301)][299:] == [0.0, pytest.approx(0.2)]
    assert len(arrivals) == 1, "networks that came long ago are forgotten"
    one = Arrivals(1, lambda: 0.0)
    assert [one.admit(f"2001:db8:0:{part}::1") > 0 for part in ("1", "2", "100")] == [False, True, False]


def test_no_number_of_names_lets_anybody_do_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("components.serving.visitors.MOST_NAMES", 50)
    now, allowed = 0.0, list[float]()
    rate = Rate(5, lambda: now)
    for turn in range(4000):
        now += 0.1
        if not rate.admit("greedy"):
            allowed.append(now)
        rate.admit(f"made up {turn}")
        assert len(rate) <= 50
    assert max(sum(start <= at < start + MINUTE for at in allowed) for start in allowed) <= 2 * 5


def test_a_charge_of_more_than_a_minute_is_paid_off_in_full() -> None:
    now = 0.0
    rate = Rate(10, lambda: now)
    rate.charge("greedy", 40.0)
    waits = []
    for at in (0.0, 61.0, 122.0, 187.0):
        now = at
        rate.admit("another")
        waits.append(rate.wait("greedy") > 0)
    assert waits == [True, True, True, False]


async def test_a_page_knows_the_network_that_a_trusted_proxy_names() -> None:
    async with served(arrivals=1, trusted_proxies=("127.0.0.1",)) as server:
        for address, status in (("198.51.100.1", 200), ("198.51.100.1", 429), ("203.0.113.5", 200)):
            assert (await page_of(server, X_Forwarded_For=address)).status == status
        contexts = [session.document.session_context for session in sessions(server)]
        known = [context.token_payload["network"] for context in contexts if context]
        assert sorted(known) == ["198.51.100.0/24", "203.0.113.0/24"]


async def test_a_page_that_comes_back_is_not_counted_among_strangers() -> None:
    """A page is recognised by its earlier token, expired or not, with a rate limit that its successors share."""
    async with served(arrivals=2) as server:
        admission = server.context.admission
        for rate in (admission.arrivals, admission.returns, admission.returning):
            rate._clock = lambda: 0.0

        async def page(token: str = "") -> Answered:
            return await page_of(server, Page_Token=token)

        first, other, _ = [await page() for _ in range(3)]
        token, name = token_of(first.text), contents(token_of(first.text))["page"]
        assert name != contents(token_of(other.text))["page"]
        for forged in (token[:-4] + "AAAA", "a.b", contents(token)["session_id"], "é"):
            assert (await page(forged)).status == 429
        for _ in range(RETURNS):
            back = await page(token)
            assert back.status == 200 and contents(token_of(back.text))["page"] == name
            token = token_of(back.text)
        assert (await page(token)).status == 429
        secret = server.context.secret
        session = generate_session_id(secret, True)
        old = generate_jwt_token(session, secret, True, extra_payload={"page": "old"}, expiration=-1000)
        assert (await page(old)).status == 200
