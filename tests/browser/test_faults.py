"""In a Chromium: links beyond doubles open pages that work, and what is lost on the way is asked for anew."""

from __future__ import annotations

from collections.abc import Callable
from urllib.parse import parse_qsl

import pytest
from playwright.sync_api import Browser, Page, expect

from components.scenes import SCENES
from tests.attack.stage import faults_of
from tests.browser.fixtures import READY
from tests.browser.waiting import QUIET, unfold
from tests.grids import spread
from tests.scenes.checks import EXTREME_LINKS
from tests.serving.server import Server

pytestmark = pytest.mark.browser
Open = Callable[..., Page]

PATIENCE = "oscillations.messages.patience = 1000"
LOSE_A_MESSAGE = """
const {wire} = oscillations.messages, {send} = wire
globalThis.said = []
wire.send = message => { if (said.push(message.number) > 1) send(message) }
"""
LOSE_AN_ANSWER = """
const {messages} = oscillations, {wire} = messages, {send} = wire
globalThis.said = []
wire.send = message => { said.push(message.number); send(message) }
messages.receive = () => { delete messages.receive }
"""
HEAR_TWICE = """
const {messages} = oscillations, {receive, hear} = messages
globalThis.heard = []
messages.receive = function (message) { receive.call(this, message); receive.call(this, message) }
messages.hear = (told, asked) => { heard.push(told.answer); hear(told, asked) }
"""


@pytest.mark.parametrize("query", EXTREME_LINKS)
def test_a_link_beyond_doubles_opens_a_page_that_works(page: Page, open_scene: Open, query: str) -> None:
    open_scene(page, **dict(parse_qsl(query)))
    type_in(page, "m2", "3")
    page.wait_for_function("oscillations.shown.settings.m2.value === 3")


@pytest.mark.parametrize("lose", [LOSE_A_MESSAGE, LOSE_AN_ANSWER], ids=["message", "answer"])
def test_what_is_lost_on_the_way_is_said_anew(page: Page, open_scene: Open, lose: str) -> None:
    open_scene(page, scene="coupled")
    page.evaluate(f"() => {{ {PATIENCE}; {lose} }}")
    type_in(page, "k2", "7")
    page.wait_for_function("oscillations.shown.settings.k2.value === 7")
    lost, again = page.evaluate("said.slice(0, 2)")
    assert again == lost, "the server applies a number once"


def test_an_answer_that_comes_late_is_not_heard(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    page.evaluate(f"() => {{ {HEAR_TWICE} }}")
    for value in (7, 8):
        type_in(page, "k2", str(value))
        page.wait_for_function(f"oscillations.shown.settings.k2.value === {value}")
    page.wait_for_function(QUIET)
    heard = page.evaluate("heard")
    assert len(heard) == len(set(heard)) >= 2
    expect(page.locator(".notice")).to_be_hidden()


@pytest.mark.parametrize("slug", spread([*SCENES]))
def test_extreme_pictures_are_drawn_with_numbers(page: Page, open_scene: Open, slug: str) -> None:
    open_scene(page, scene=slug)
    assert list(faults_of(page, SCENES[slug], size=12, start=1)) == []


def test_a_phase_beyond_doubles_is_drawn_somewhere(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="oscillator", window=1.7976931348623157e308, k=78.77)
    page.evaluate("oscillations.page.clock.seek(oscillations.page.clock.end)")
    assert page.evaluate("() => { const {page} = oscillations; page.draw(page.clock.t); return page.clock.t > 100 }")


def test_a_picture_that_fails_does_not_keep_the_next_from_being_shown(browser: Browser, server: Server) -> None:
    """Without the fixture of pages, which a fault in the console would fail."""
    page = browser.new_page(bypass_csp=True)
    page.goto(f"{server.url}?scene=coupled")
    page.wait_for_function(READY)
    unfold(page)
    page.evaluate("() => { const {page} = oscillations; page.apply = () => { delete page.apply; throw Error('!') } }")
    type_in(page, "k2", "7")
    page.wait_for_function("!Object.hasOwn(oscillations.page, 'apply')")
    type_in(page, "k2", "8")
    page.wait_for_function("oscillations.shown.settings.k2.value === 8")
    page.close()


def type_in(page: Page, name: str, text: str) -> None:
    box = page.locator(f"input[name={name}]")
    box.fill(text)
    box.press("Enter")
