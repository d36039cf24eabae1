"""Sessions: trusted proxies, limits for each network, the waiting line, and the end of each session."""

import asyncio
import logging
import re
from html import unescape
from socket import IPPROTO_TCP, TCP_NODELAY
from time import thread_time
from unittest.mock import Mock

import pytest
from bokeh.document import Document
from bokeh.io.doc import _PATCHED_CURDOCS
from bokeh.server.session import ServerSession
from bokeh.util.token import generate_jwt_token, generate_session_id

from app import open_page
from components.serving.admission import FORGOTTEN, IDLE, RETURNS, Guest, Queue, ordinal, visitor_to_drop
from components.serving.sockets import MOST_MISSED, MOST_PINGS, Socket, metered
from components.serving.tokens import opens_session
from components.serving.visitors import MINUTE, Arrivals, Rate, networks, visitor
from tests.live_class.caller import Answered, until
from tests.serving.served import page_of, served, sessions, url
from tests.serving.visitor import Caller, contents, event, header, patch, refused, said, token_of


class House:
    """A queue, its places, and a clock set by the test."""

    def __init__(self, places: int) -> None:
        self.taken, self.now = 0, 0.0
        self.queue = Queue(places, lambda: self.taken, lambda: self.now)

    def knock(self, ticket: str = "", network: str = "") -> tuple[int, str]:
        place, ticket = self.queue.knock(ticket, network)
        self.taken += place == 0
        return place, ticket


def test_who_came_first_is_let_in_first_and_nobody_passes_the_line() -> None:
    house = House(3)
    assert [house.knock() for _ in range(3)] == [(0, "")] * 3
    (first, one), (second, two) = house.knock(), house.knock()
    house.taken = 2
    assert (first, second) == (1, 2) and house.knock(two) == (1, two) and house.knock()[0] == 2
    assert house.knock(one) == (0, "") and house.knock(two) == (1, two)
    house.now = FORGOTTEN - 1
    _, three = house.knock()
    house.now = FORGOTTEN  # the others ask no more, and have given up their places
    assert house.knock(three) == (1, three) and house.knock(two)[0] == 2


def test_networks_take_turns_for_our_tickets_and_the_line_has_an_end(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, most in (("LONGEST", 40), ("OF_A_NETWORK", 10)):
        monkeypatch.setattr(f"components.serving.admission.{name}", most)
    house = House(0)
    assert house.knock("mine")[1] != "mine"
    flood = [house.knock("", "a") for _ in range(50)]
    assert len(house.queue) == 11 and house.knock(flood[9][1], "a") == flood[9] == (11, flood[9][1])
    assert house.knock("", "b")[0] == 3
    house.queue.places = 4  # a visitor from another network is admitted before most of the flood
    assert house.knock("", "c") == (0, "")
    for n in range(40):
        _, ticket = house.knock("", str(n))
    assert len(house.queue) == 40 and house.knock(ticket, "new")[0] == 41 - 3


def test_who_has_been_silent_for_long_gives_way_and_else_the_quietest_of_a_network_that_has_most_places() -> None:
    now = 1000.0
    guests = {n: Guest("a", now - n) for n in range(8)} | {n: Guest("b", now - n) for n in (8, 9)}
    fewer = {n: guest for n, guest in guests.items() if n}  # “a” has seven of ten places
    idle = {**guests, 10: Guest("b", now - IDLE)}
    for there, network, leaves in ((guests, "c", 7), (guests, "a", None), (fewer, "c", None), ({}, "a", None)):
        assert visitor_to_drop(there, 10, network, now) == leaves
    assert visitor_to_drop(idle, 11, "a", now) == 10
    assert [ordinal(n) for n in (1, 10, 11, 22, 113)] == ["first", "tenth", "11th", "22nd", "113th"]


async def test_idle_visitors_of_one_network_do_not_keep_all_others_out() -> None:
    async with served(sessions=4, trusted_proxies=("127.0.0.1",)) as server:

        async def statuses(*addresses: str) -> list[int]:
            return [(await page_of(server, X_Forwarded_For=address)).status for address in addresses]

        token = token_of((await page_of(server, X_Forwarded_For="192.0.2.1")).text)
        active = await Caller.connect(url(server), token)
        assert await statuses(*["192.0.2.1"] * 4, "198.51.100.1", "198.51.100.2") == [200] * 3 + [503, 200, 503]
        gone = next(session for session in sessions(server) if session.expiration_requested)
        late = await Caller.connect(url(server), gone.token)
        assert (await late.closed())[0] == 1013  # another visitor's place now
        admission = server.context.admission
        for session, guest in list(admission.guests.items()):
            admission.guests[session] = guest._replace(last_active=guest.last_active - IDLE)
        admission.note_activity(next(s for s in sessions(server) if s.token == token))
        assert (await statuses(*(f"203.0.{n}.1" for n in range(5)))).count(200) == 3  # the active visitor stays
        assert active.socket.close_code is None
        await active.depart()


async def test_a_waiting_visitor_gets_a_page_without_a_session_and_keeps_the_link_and_the_place() -> None:
    async with served(sessions=1, unused_seconds=0.5) as server:
        caller = await Caller.arrive(url(server))
        reply = await page_of(server, "/?scene=coupled&k2=3&ticket=none")
        assert (reply.status, reply.headers["Retry-After"]) == (503, "20")
        assert "you are first in line" in reply.text
        (address,) = {unescape(one) for one in re.findall(r'(?:url=|href=")(\?[^"]*)"', reply.text)}
        assert re.fullmatch(r"\?scene=coupled&k2=3&ticket=[\w-]{12}", address)
        for headers in ({}, {"Page-Ticket": address.rpartition("=")[2]}):  # as a link, or as a page that comes back
            again = await page_of(server, f"/{'' if headers else address}", **headers)
            assert again.headers["Page-Ticket"] == reply.headers["Page-Ticket"]
            assert "you are first in line" in again.text and len(server.context.admission.queue) == 1
        await caller.depart()
        await until(lambda: not sessions(server))
        opened = await page_of(server, f"/{address}")
        assert contents(token_of(opened.text))["arguments"].keys() == {"scene", "k2"}


@pytest.mark.parametrize(
    ("peer", "forwarded", "found"),
    [
        ("203.0.113.9", "198.51.100.1", "203.0.113.9"),
        ("10.0.0.2", "192.0.2.66, 198.51.100.1, 10.0.0.3", "198.51.100.1"),
        ("fd00::1", "2001:db8::7", "2001:db8::7"),
        ("10.0.0.2", "", "10.0.0.2"),
        ("10.0.0.2", "192.0.2.66, unknown", "10.0.0.2"),
        ("10.0.0.2", "10.0.0.4, 10.0.0.3", "10.0.0.4"),
    ],
)
def test_forwarded_addresses_are_believed_from_named_proxies_only(peer: str, forwarded: str, found: str) -> None:
    assert visitor(peer, forwarded, networks(["10.0.0.0/24", "fd00::1"])) == found


def test_a_class_arrives_at_once_and_a_flood_of_its_network_does_not() -> None:
    now = 0.0
    arrivals = Arrivals(300, lambda: now)
    assert [arrivals.admit(f"192.0.2.{i % 200}") for i in range(300)] == [0.0] * 300
    assert arrivals.admit("192.0.2.7") == pytest.approx(0.2)
    assert arrivals.admit("198.51.100.7") == 0.0
    now = 0.2
    assert arrivals.admit("192.0.2.7") == 0.0 < arrivals.admit("192.0.2.7")
    now = 1000.0
    assert [arrivals.admit("192.0.2.7") for _ in range(301)][299:] == [0.0, pytest.approx(0.2)]
    one = Arrivals(1, lambda: 0.0)
    assert [one.admit(f"2001:db8:0:{part}::1") > 0 for part in ("1", "2", "100")] == [False, True, False]


def test_many_names_allow_no_more_and_a_large_charge_is_paid_in_full(monkeypatch: pytest.MonkeyPatch) -> None:
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
    rate.charge("greedy", 20.0)
    for now, waits in ((461.0, True), (522.0, True), (583.0, True), (660.0, False)):
        assert not rate.admit(f"another {now}") and (rate.wait("greedy") > 0) is waits
    assert len(rate) <= 2, "names that came long ago are forgotten"


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
        secret, payload = server.context.secret, {"page": "old"}
        old = generate_jwt_token(generate_session_id(secret, True), secret, True, payload, expiration=-1000)
        assert (await page(old)).status == 200


SECRET = "a secret of sixteen letters"
PULL = (header("PULL-DOC-REQ"), "{}", "{}")
WORD = "the word that is for the log"


async def test_a_token_opens_its_session_on_every_server_with_the_secret() -> None:
    async with served(bokeh_secret_key=SECRET) as first, served(bokeh_secret_key=SECRET) as second, served() as other:
        token = token_of((await page_of(first, "/?scene=coupled&k2=7")).text)
        caller = await Caller.connect(url(second), token)
        await until(lambda: len(sessions(second)) == 1)
        assert sessions(second)[0].document.title == sessions(first)[0].document.title
        name = generate_session_id(secret_key=SECRET.encode(), signed=True)
        late, good = (generate_jwt_token(name, SECRET.encode(), True, expiration=seconds) for seconds in (-1, 60))
        assert opens_session(good, SECRET.encode())
        for server, wrong in ((other, token), (first, late), (first, name)):
            assert await refused(url(server), wrong) == 403
        assert other.context.secret != second.context.secret and len(other.context.secret) > 32
        await caller.depart()


async def test_what_fails_for_one_visitor_is_said_in_a_sentence_logged_once_and_leaves_no_document_to_others(
    caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    fail = Mock(side_effect=ArithmeticError(WORD))

    def failing(document: Document) -> None:
        open_page(document)
        document.on_event("document_ready", lambda _: fail())

    before = len(_PATCHED_CURDOCS)
    async with served(fail, bokeh_secret_key=SECRET) as server, served(failing, bokeh_secret_key=SECRET) as sound:
        page = await page_of(server)
        assert page.status == 500 and page.quiet and WORD not in page.text
        assert "Something went wrong on the server" in page.text
        caller = await Caller.connect(url(server), token_of((await page_of(sound)).text))
        assert (await caller.closed())[0] == 1011 and WORD in caplog.text
        monkeypatch.setattr(ServerSession, "pull", fail)
        for message, code in ((patch(event("document_ready")), 1011), (said(None, model="p0"), 1008), (PULL, 1011)):
            caplog.clear()
            caller = await Caller.arrive(url(sound))
            await caller.write(*message)
            found, reason = await caller.closed()
            assert found == code and (code == 1008 or "Something went wrong on the server" in reason)
            errors = [record.levelno for record in caplog.records if record.exc_info]
            assert errors == [logging.ERROR] * (code == 1011) and (WORD in caplog.text) is (code == 1011)
    assert len(_PATCHED_CURDOCS) == before


async def test_a_socket_is_closed_that_misses_two_pings_or_sends_pings_without_end_and_all_at_the_end() -> None:
    async with served() as server:
        caller, silent, noisy = [await Caller.arrive(url(server)) for _ in range(3)]
        silent.socket.protocol._send_pong = lambda _: None  # type: ignore[union-attr]
        for _ in range(MOST_MISSED + 1):
            for socket in list(server.context.admission.sockets):
                socket.pulse()
            await caller.write(*PULL)
            for _ in range(3):  # the answer comes after the pong
                await caller.receive()
        assert await silent.closed() == (1001, "No answer to two pings.")
        assert len(server.context.admission.sockets) == 2
        for _ in range(MOST_PINGS):
            noisy.socket.ping(b"")
        assert await noisy.closed() == (1008, "Too many pings.")
        await server.end()
        assert (await caller.closed())[0] == 1001


async def test_a_page_has_one_socket_which_delays_no_answer() -> None:
    async with served() as server:
        token = token_of((await page_of(server)).text)
        first, second = [await Caller.connect(url(server), token) for _ in range(2)]
        assert await first.closed() == (1008, "This page has a newer connection.")
        await until(lambda: len(server.context.admission.sockets) == 1)
        (socket,) = server.context.admission.sockets
        assert isinstance(socket, Socket) and socket.ws_connection is not None
        assert socket.ws_connection.stream.socket.getsockopt(IPPROTO_TCP, TCP_NODELAY)
        await second.greeted()
        await second.write(*PULL)
        assert await second.receive()
        await second.depart()


async def test_nobody_pays_for_what_another_asks_for_meanwhile() -> None:
    async def busy(seconds: float) -> None:
        end = thread_time() + seconds
        while thread_time() < end:
            pass
        await asyncio.sleep(0.01)
        await asyncio.sleep(0)

    other = asyncio.create_task(busy(0.2))
    took = await metered(busy(0.01))
    await other
    assert 0.01 <= took < 0.1
