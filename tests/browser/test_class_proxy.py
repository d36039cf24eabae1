"""A phone that follows a class through a proxy that holds streams back, and one that wakes up."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.classroom import LED, Open, taught
from tests.browser.fixtures import READY
from tests.browser.tabs import calm_context
from tests.serving.server import Server
from tools.bench.between import between

pytestmark = [pytest.mark.browser, pytest.mark.slow]

Phone = Callable[[str, str], Page]

HIDDEN = """hidden => {
  Object.defineProperty(document, "hidden", {value: hidden, configurable: true})
  document.dispatchEvent(new Event("visibilitychange"))
}"""
"""A headless browser's page is always visible."""


@pytest.fixture
def phone(browser: Browser) -> Iterator[Phone]:
    """A function that opens a phone's page of a class at an address."""
    contexts = []

    def opened(url: str, code: str) -> Page:
        contexts.append(calm_context(browser, {"width": 390, "height": 844}, bypass_csp=True))
        page = contexts[-1].new_page()
        page.goto(f"{url}?class={code}")
        return page

    yield opened
    for context in contexts:
        context.close()


def test_a_phone_polls_if_a_proxy_holds_streams_back(server: Server, phone: Phone, window: Open) -> None:
    lecture, code = taught(window, "walk=d31&step=d31-01")
    with between(server.port, holds=True) as proxy:
        page = phone(proxy.url, code)
        expect(page.locator(".class-bar")).to_contain_text("Following")
        lecture.evaluate("oscillations.walks.walk.go(2)")
        expect(page.locator(".given")).to_contain_text("pulled out twice as far", timeout=30000)
        lecture.evaluate("oscillations.classes.led.end()")
        expect(page.get_by_role("heading", name="The class is over.")).to_be_visible(timeout=60000)  # its doubt: 30 s
        page.close()


def test_a_phone_that_wakes_up_has_what_was_shown_meanwhile(server: Server, phone: Phone, window: Open) -> None:
    lecture, code = taught(window, "scene=coupled")
    with between(server.port) as proxy:
        page = phone(proxy.url, code)
        page.wait_for_function(READY)
        lecture.wait_for_function(f"{LED}.news.here === 1")
        page.evaluate(HIDDEN, True)
        lecture.wait_for_function(f"{LED}.news.here === 0")  # a phone in a pocket is not counted
        proxy.silence()  # its open streams are dead when it wakes up
        lecture.evaluate("oscillations.open({scene: 'forced'})")
        lecture.wait_for_function("oscillations.page.spec.slug === 'forced'")
        assert page.evaluate("oscillations.page.spec.slug") == "coupled"
        page.evaluate(HIDDEN, False)
        page.wait_for_function("oscillations.page.spec.slug === 'forced'")
        expect(page.locator(".class-bar")).to_contain_text("Following")
        page.close()
