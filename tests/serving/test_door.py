"""Who comes in when all places are taken."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from html import unescape
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from components.serving.door import FORGOTTEN, LONGEST, Door, ordinal
from tests.attack.caller import ask, contents, token_of
from tests.serving.server import Server, serving


class House:
    """A door, the places behind it and a clock that is set by hand."""

    def __init__(self, places: int) -> None:
        self.taken, self.now = 0, 0.0
        self.door = Door(places, lambda: self.taken, lambda: self.now)

    def knock(self, ticket: str = "") -> tuple[int, str]:
        place, ticket = self.door.knock(ticket)
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
    for _ in range(LONGEST + 5):
        place, ticket = house.knock()
    assert place == LONGEST + 1
    assert house.knock(ticket)[0] == LONGEST + 1


@pytest.mark.parametrize(
    ("number", "word"), [(1, "first"), (4, "fourth"), (10, "tenth"), (11, "11th"), (22, "22nd"), (113, "113th")]
)
def test_places_are_counted_in_words(number: int, word: str) -> None:
    assert ordinal(number) == word


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server with one place, which is free again soon after its visitor has left."""
    options = ("--sessions", "1", "--unused-seconds", "0.5")
    with serving(tmp_path_factory.mktemp("server") / "log", options=options) as running:
        yield running
        assert not running.complaints(), running.log.read_text()


def test_who_waits_is_told_so_without_a_session_and_keeps_the_link(server: Server) -> None:
    assert ask(server.url).status == 200
    reply = ask(server.url, "/?scene=coupled&k2=3&ticket=none")
    assert (reply.status, reply.headers["Retry-After"]) == (503, "20")
    assert "you are first in line" in reply.text
    addresses = {unescape(address) for address in re.findall(r'(?:url=|href=")(\?[^"]*)"', reply.text)}
    (address,) = addresses
    assert re.fullmatch(r"\?scene=coupled&k2=3&ticket=[\w-]{12}", address)
    while (reply := ask(server.url, f"/{address}")).status == 503:
        pass
    assert contents(token_of(reply.text))["arguments"].keys() == {"scene", "k2"}


@pytest.mark.browser
def test_the_waiting_page_opens_when_there_is_a_place(
    server: Server, browser: Browser, screenshot: Callable[[Page, str], Path]
) -> None:
    first, second = browser.new_page(), browser.new_page()
    told: list[str] = []
    second.on("console", lambda message: told.extend([message.text] if message.type == "error" else []))
    first.goto(server.url)
    expect(first.locator("html[data-ready=true]")).to_be_attached(timeout=30_000)
    second.goto(f"{server.url}?scene=coupled&k2=3")
    expect(second.get_by_role("heading")).to_have_text("All 1 places are taken")
    expect(second.locator("#now text")).to_have_text(re.compile(r"^[2-9]\.\d s"))
    screenshot(second, "waiting")
    first.close()
    expect(second.locator("html[data-ready=true]")).to_be_attached(timeout=40_000)
    expect(second).to_have_url(re.compile(r"\?scene=coupled&k2=3$"))
    assert [text for text in told if "status of 503" not in text] == []
    second.close()
