"""Admission of visitors when all places are taken."""

from __future__ import annotations

import asyncio
import re
from collections.abc import Iterator
from html import unescape

import pytest
from playwright.sync_api import Browser, expect

from app import SHEETS, open_page
from components.serving.admission import FORGOTTEN, IDLE, LONGEST, OF_A_NETWORK, Guest, Queue, ordinal, visitor_to_drop
from components.serving.server import Server as Serving
from components.serving.settings import Settings
from tests.attack.caller import Caller, Reply, ask, connect, contents, token_of
from tests.serving.server import Server, serving


class House:
    """A queue, its places, and a clock set by the test."""

    def __init__(self, places: int) -> None:
        self.taken, self.now = 0, 0.0
        self.queue = Queue(places, lambda: self.taken, lambda: self.now)

    def knock(self, ticket: str = "") -> tuple[int, str]:
        place, ticket = self.queue.knock(ticket)
        self.taken += place == 0
        return place, ticket


def test_all_come_in_while_there_are_places() -> None:
    house = House(3)
    assert [house.knock() for _ in range(3)] == [(0, "")] * 3
    assert house.knock()[0] == 1


def test_who_came_first_is_let_in_first_and_nobody_passes_the_line() -> None:
    house = House(1)
    house.knock()
    (first, one), (second, two) = house.knock(), house.knock()
    assert (first, second) == (1, 2)
    house.taken = 0
    assert house.knock(two) == (1, two)
    assert house.knock()[0] == 2
    assert house.knock(one) == (0, "")
    assert house.knock(two) == (1, two)


def test_a_place_in_the_line_is_given_up_by_who_asks_no_more() -> None:
    house = House(1)
    house.knock()
    _, one = house.knock()
    house.now = FORGOTTEN - 1
    _, two = house.knock()
    house.now = FORGOTTEN
    assert house.knock(two) == (1, two)
    assert house.knock(one)[0] == 2


def test_tickets_are_ours_and_the_line_has_an_end() -> None:
    house = House(1)
    house.knock()
    assert house.knock("mine")[1] != "mine"
    for n in range(LONGEST + 5):
        place, ticket = house.queue.knock("", str(n))
    assert place == LONGEST + 1
    assert house.queue.knock(ticket, "new")[0] == LONGEST + 1


def test_networks_take_turns_and_one_of_them_does_not_fill_the_line() -> None:
    house = House(1)
    house.knock()
    flood = [house.queue.knock("", "a") for _ in range(2100)]
    assert len(house.queue) == OF_A_NETWORK
    assert house.queue.knock("", "b")[0] == 2
    assert sum(house.queue.knock(ticket, "a")[0] <= LONGEST for _, ticket in flood[:600]) >= OF_A_NETWORK
    house.queue.places = 31  # places are free: a visitor from another network is admitted
    assert house.queue.knock("", "c") == (0, "")


def test_who_has_been_silent_for_long_gives_way_and_else_the_quietest_of_a_network_that_has_most_places() -> None:
    now = 1000.0
    guests = {n: Guest("a", now - n) for n in range(8)} | {n: Guest("b", now - n) for n in (8, 9)}
    assert visitor_to_drop(guests, 10, "c", now) == 7
    assert visitor_to_drop(guests, 10, "a", now) is None
    assert (
        visitor_to_drop({n: guest for n, guest in guests.items() if n}, 10, "c", now) is None
    )  # it has seven of ten places
    assert visitor_to_drop({**guests, 10: Guest("b", now - IDLE)}, 11, "a", now) == 10
    assert visitor_to_drop({}, 10, "a", now) is None


async def test_idle_visitors_of_one_network_do_not_keep_all_others_out() -> None:
    settings = Settings(address="127.0.0.1", port=0, sessions=4, trusted_proxies=("127.0.0.1",))
    server = Serving(open_page, settings, sheets=SHEETS)
    url = f"http://127.0.0.1:{server.port}/"

    async def page(address: str) -> Reply:
        return await asyncio.to_thread(ask, url, "/?scene=coupled", **{"X-Forwarded-For": address})

    first = await page("192.0.2.1")
    socket = await connect(url, token_of(first.text))
    assert [(await page("192.0.2.1")).status for _ in range(4)] == [200] * 3 + [503]
    assert [(await page(f"198.51.100.{n}")).status for n in (1, 2)] == [200, 503]
    gone = next(session for session in server.lecture.get_sessions("/") if session.expiration_requested)
    back = await connect(url, gone.token)
    while await back.read_message() is not None:
        pass
    assert back.close_code == 1013  # the place belongs to another visitor now
    back.close()
    admission = server.context.admission
    for session, guest in list(admission.guests.items()):
        admission.guests[session] = guest._replace(last_active=guest.last_active - IDLE)
    admission.note_activity(next(s for s in server.lecture.get_sessions("/") if s.token == token_of(first.text)))
    tickets = [await page(f"203.0.{n}.1") for n in range(5)]
    assert sum(reply.status == 200 for reply in tickets) == 3  # the active visitor stays
    assert socket.close_code is None
    await Caller(socket).depart()
    await server.end()


@pytest.mark.parametrize(
    ("number", "word"), [(1, "first"), (4, "fourth"), (10, "tenth"), (11, "11th"), (22, "22nd"), (113, "113th")]
)
def test_places_are_counted_in_words(number: int, word: str) -> None:
    assert ordinal(number) == word


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server with one place, which is free soon after its visitor has left."""
    options = ("--sessions", "1", "--unused-seconds", "0.5")
    with serving(tmp_path_factory.mktemp("server") / "log", options=options) as running:
        yield running
        assert not running.complaints(), running.log.read_text()


def test_waiting_visitors_get_a_page_without_a_session_and_keep_the_link(server: Server) -> None:
    assert ask(server.url, "/?scene=oscillator").status == 200
    reply = ask(server.url, "/?scene=coupled&k2=3&ticket=none")
    assert (reply.status, reply.headers["Retry-After"]) == (503, "20")
    assert "you are first in line" in reply.text
    addresses = {unescape(address) for address in re.findall(r'(?:url=|href=")(\?[^"]*)"', reply.text)}
    (address,) = addresses
    assert re.fullmatch(r"\?scene=coupled&k2=3&ticket=[\w-]{12}", address)
    while (reply := ask(server.url, f"/{address}")).status == 503:
        pass
    assert contents(token_of(reply.text))["arguments"].keys() == {"scene", "k2"}


@pytest.mark.slow
@pytest.mark.browser
def test_the_waiting_page_opens_when_there_is_a_place(server: Server, browser: Browser) -> None:
    first, second = browser.new_page(), browser.new_page()
    told: list[str] = []
    second.on("console", lambda message: told.extend([message.text] if message.type == "error" else []))
    first.goto(f"{server.url}?scene=oscillator")
    expect(first.locator("html[data-ready=true]")).to_be_attached(timeout=30_000)
    second.goto(f"{server.url}?scene=coupled&k2=3")
    expect(second.get_by_role("heading")).to_have_text("All 1 places are taken")
    expect(second.locator("#now text")).to_have_text(re.compile(r"^[2-9]\.\d s"))
    first.close()
    expect(second.locator("html[data-ready=true]")).to_be_attached(timeout=40_000)
    expect(second).to_have_url(re.compile(r"\?scene=coupled&k2=3&view=motion$"))
    assert [text for text in told if "status of 503" not in text] == []
    second.close()
