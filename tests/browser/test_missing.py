"""Features that a browser lacks and files it cannot fetch: a sentence reports them, everything else works, and files
come later.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.fixtures import READY
from tests.browser.tabs import calm_context
from tests.browser.waiting import played, unfold
from tests.serving.server import Server

pytestmark = pytest.mark.browser
Quiet = Callable[..., Page]
NO_STORAGE = """Object.defineProperty(globalThis, "localStorage", {
  get() { throw new DOMException("Access is denied for this document.", "SecurityError") }
})"""
LACKS = {
    "modules": "delete HTMLScriptElement.prototype.noModule",
    "DecompressionStream": "delete globalThis.DecompressionStream",
    "the selector :has()": "CSS.supports = rule => !rule.includes(':has')",
    "nested rules": "CSS.supports = rule => rule !== 'selector(&)'",
}
"""Scripts that remove a feature of the browser, or report that it is missing."""
BY_ANYTHING = 30_000


@pytest.fixture
def quiet(browser: Browser) -> Iterator[Quiet]:
    """Makes pages that may log missing features; none may throw."""
    contexts, faults = [], []

    def make(script: str = "", **options: Any) -> Page:
        context = calm_context(browser, {"width": 1280, "height": 720}, bypass_csp=True, **options)
        contexts.append(context)
        page = context.new_page()
        page.on("pageerror", lambda error: faults.append(str(error)))
        if script:
            page.add_init_script(script)
        return page

    yield make
    for context in contexts:
        context.close()
    assert not faults


def test_scripts_that_are_switched_off_are_named(quiet: Quiet, server: Server) -> None:
    page = quiet(java_script_enabled=False)
    page.goto(f"{server.url}?scene=coupled")
    expect(page.locator("noscript p")).to_be_in_viewport()
    expect(page.locator("noscript p")).to_contain_text("JavaScript, which is switched off")


@pytest.mark.parametrize("feature", LACKS)
def test_what_an_old_browser_lacks_is_named(browser: Browser, server: Server, feature: str) -> None:
    page = browser.new_page()
    page.add_init_script(LACKS[feature])
    page.goto(f"{server.url}?scene=coupled")
    alert = page.get_by_role("alert").filter(has_text=f"This browser does not have {feature},")
    expect(alert).to_contain_text("Firefox 121")
    expect(alert).to_be_in_viewport()
    page.close()


def test_scripts_that_cannot_be_fetched_are_missed_in_a_sentence(quiet: Quiet, server: Server) -> None:
    page = quiet()
    page.route("**/start.js", lambda route: route.abort())
    page.goto(f"{server.url}?scene=oscillator")
    expect(page.get_by_role("alert").filter(has_text="Part of this page could not be loaded")).to_be_in_viewport()


def test_a_browser_that_keeps_nothing_says_so_once(quiet: Quiet, server: Server) -> None:
    page = quiet(NO_STORAGE)
    page.goto(f"{server.url}?scene=coupled")
    page.wait_for_function(READY)
    remark = page.get_by_text("This browser stores nothing for this page")
    expect(remark).to_have_count(0)
    before = page.evaluate("document.documentElement.dataset.theme")
    page.locator("#theme").click()
    expect(remark).to_be_visible()
    page.get_by_role("status").filter(has=remark).get_by_role("button", name="Close").click()
    page.locator("#theme").click()
    assert page.evaluate("document.documentElement.dataset.theme") == before
    expect(remark).to_have_count(0)


def test_a_remote_control_needs_no_storage(quiet: Quiet, server: Server) -> None:
    page = quiet(NO_STORAGE.replace("localStorage", "sessionStorage"))
    page.goto(f"{server.url}?class=ABCD&remote=ticket")
    expect(page.locator("h1")).to_contain_text("This code has been used")


def test_without_bokeh_everything_but_the_curves_works(quiet: Quiet, server: Server) -> None:
    page = quiet()
    page.route("**/bokeh.min.js", lambda route: route.abort())
    page.goto(f"{server.url}?scene=coupled")
    page.wait_for_function(READY)
    lacks = page.get_by_text("The program that draws the curves could not be loaded. Trying again.")
    expect(lacks).to_be_visible()
    played(page, 3)
    expect(page.get_by_role("alert").filter(has_text="Not connected.")).to_be_visible()
    page.unroute("**/bokeh.min.js")
    page.locator("button", has_text="Try now").dispatch_event(
        "click"
    )  # visible or not, because the page also tries on its own
    page.wait_for_function("oscillations.plots.filter(plot => plot.box && !plot.absent).every(plot => plot.mounted)")
    expect(lacks).to_have_count(0)


def test_parts_asked_for_without_a_network_come_with_it(quiet: Quiet, server: Server) -> None:
    page = quiet()
    page.goto(f"{server.url}?scene=coupled")
    page.wait_for_function(f"{READY} && oscillations.page.print")
    unfold(page)
    page.context.set_offline(True)
    page.locator("details.about summary").click()
    for _ in range(2):
        page.get_by_role("button", name="Keys").click()
        page.get_by_role("button", name="Pictures", exact=True).click()
    remark = page.get_by_text("Part of this page could not be loaded")
    expect(remark).to_have_count(1)
    page.context.set_offline(False)
    expect(page.get_by_role("dialog", name="Save a picture")).to_be_visible(timeout=BY_ANYTHING)
    expect(remark).to_have_count(0)
    page.keyboard.press("Escape")
    expect(page.get_by_role("dialog", name="Keys")).to_be_visible()
    expect(page.locator("details.about table").first).to_be_visible()


def test_a_walk_asked_for_without_a_network_begins_with_it(quiet: Quiet, server: Server) -> None:
    page = quiet()
    page.goto(f"{server.url}?scene=coupled")
    page.wait_for_function(f"{READY} && oscillations.page.print")
    page.context.set_offline(True)
    page.locator(".walks summary").click()
    page.locator("[data-walk=d34]").click()
    expect(page.get_by_text("Part of this page could not be loaded")).to_be_visible()
    page.context.set_offline(False)
    page.wait_for_function("oscillations.walks.walk?.card", timeout=BY_ANYTHING)
    expect(page.get_by_role("button", name="Show the answer", exact=True)).to_be_visible()
