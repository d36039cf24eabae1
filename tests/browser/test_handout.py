"""A walk on paper: with the numbers of its file, on few pages, prepared while a class sees something else."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.browser.classroom import CONNECTED, LED, Open, joined, taught
from tests.browser.waiting import QUIET
from tests.serving.server import Server

pytestmark = [pytest.mark.browser, pytest.mark.slow]  # each goes through a walk of sixteen steps

NO_PRINTER = "() => { globalThis.print = () => {} }"
STANDS = "JSON.stringify([oscillations.shown.state, oscillations.messages.number, oscillations.walks.walk.place])"
NEWS = "JSON.stringify([oscillations.news.picture, oscillations.news.question])"
FILLED = "[...document.querySelectorAll('.handout .sheet')].map(sheet => sheet.offsetHeight)"


def printed(page: Page, name: str = "Print a handout of this walk", steps: int = 21) -> None:
    page.evaluate(NO_PRINTER)
    page.locator(".walks summary").click()
    page.get_by_role("button", name=name).click()
    expect(page.locator(".handout article")).to_have_count(steps, timeout=60_000)


def pages(page: Page, paper: str) -> int:
    page.evaluate("document.querySelector('.handout').remove = () => {}")  # it is printed twice
    return max(int(count) for count in re.findall(rb"/Count (\d+)", page.pdf(format=paper)))


def test_a_handout_that_is_printed_during_a_class_moves_nothing_and_fills_its_pages(window: Open) -> None:
    lecture, code = taught(window, "walk=d34&step=d34-05&projector")
    phone = joined(window, code)
    phone.locator(".answers button").first.click()
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered")
    lecture.wait_for_function(QUIET)
    before, news = lecture.evaluate(STANDS), phone.evaluate(NEWS)
    orders: list[str] = []
    lecture.on("request", lambda request: orders.append(request.url) if request.url.endswith("/lead") else None)
    printed(lecture)
    expect(lecture.locator("iframe, .offer")).to_have_count(0)
    assert lecture.evaluate(STANDS) == before and not orders
    assert phone.evaluate(NEWS) == news
    assert lecture.evaluate(f"{LED}.news.here") == 1
    filled = lecture.evaluate(FILLED)
    assert min(filled) > 0.6 * max(filled), "no page is half empty"
    assert [pages(lecture, paper) for paper in ("A4", "Letter")] == [12, 12]


def test_a_handout_has_the_numbers_of_the_file(server: Server, new_page: Callable[..., Page]) -> None:
    """The page itself asks with this visitor's own numbers."""
    page = new_page(fresh=True, bypass_csp=False)
    page.goto(f"{server.url}?walk=d31&step=d31-02")
    expect(page.locator(".asked-line")).to_contain_text("One swing takes")
    own = page.evaluate("oscillations.walks.walk.numbers")
    assert own
    printed(page, steps=16)
    expect(page.locator(".handout article").nth(1)).to_contain_text("One swing takes 1.00 s")
    assert page.evaluate("oscillations.walks.walk.numbers") == own


def test_a_handout_that_cannot_be_prepared_says_so(server: Server, new_page: Callable[..., Page]) -> None:
    page = new_page(fresh=True)
    page.goto(f"{server.url}?walk=tour")
    page.wait_for_function(f"{CONNECTED} && oscillations.walks.walk?.card")
    page.route(re.compile(r"\?scene="), lambda route: route.fulfill(body="a page of another kind"))
    page.clock.install()
    page.locator(".walks summary").click()
    page.get_by_role("button", name="Print a handout of this walk").click()
    expect(page.locator("iframe")).to_have_count(1)
    page.clock.run_for(30_000)
    expect(page.get_by_text("The handout could not be prepared.")).to_be_visible()
    expect(page.locator("iframe, .offer")).to_have_count(0)
