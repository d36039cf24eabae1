"""A walk on paper: with the numbers of its file, on few pages, prepared while a class sees something else."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.classroom import CONNECTED, LED, Open, joined, sent, tap, taught
from tests.browser.waiting import QUIET
from tests.serving.server import Server

pytestmark = pytest.mark.browser

NO_PRINTER = "() => { globalThis.print = () => {} }"
STANDS = "JSON.stringify([oscillations.shown.state, oscillations.messages.number, oscillations.walks.walk.place])"
NEWS = "JSON.stringify([oscillations.news.picture, oscillations.news.question])"
FILLED = """[...document.querySelectorAll(".handout .sheet")].map(sheet => sheet.offsetHeight / 950)"""
"""The share of each printed page's height that its steps take."""
POINTS = """[...document.querySelectorAll(".handout svg text")].filter(one => one.textContent.trim()).map(one =>
  parseFloat(getComputedStyle(one).fontSize) * one.ownerSVGElement.getScreenCTM().a * 0.75)"""
"""The type of the labels on paper."""
HANDOUT = "Print a handout of this walk"


def printed(page: Page, steps: int, name: str = HANDOUT) -> Locator:
    """The pages that a button prints, one article a step."""
    page.evaluate(NO_PRINTER)
    page.locator(".walks summary").click()
    page.get_by_role("button", name=name).click()
    pages = page.locator(".handout")
    expect(pages.locator("article")).to_have_count(steps, timeout=60_000)
    page.evaluate("document.querySelector('.handout').remove = () => {}")  # it is printed several times
    return pages


def counted(page: Page) -> list[int]:
    """The number of pages on each paper."""
    page.emulate_media(media="print")
    # The tree of pages has several nodes, each with its number of pages; the root has all.
    return [max(map(int, re.findall(rb"/Count (\d+)", page.pdf(format=paper)))) for paper in ("A4", "Letter")]


def test_a_walk_is_printed_with_space_for_answers_and_apart_from_it_the_answers(
    server: Server, new_page: Callable[..., Page]
) -> None:
    page = new_page(fresh=True)
    page.goto(f"{server.url}?walk=tour")
    page.wait_for_function(f"{CONNECTED} && oscillations.walks.walk?.card")
    pages = printed(page, 5)
    expect(pages.locator(".boxes li").first).to_be_attached()
    boxes = page.locator(".printed-pictures svg").evaluate_all("all => all.map(one => one.viewBox.baseVal.width)")
    assert len(boxes) >= 5 and min(boxes) > 100  # a view that has just come has its place before it is drawn
    assert "?" not in "".join(pages.locator("svg").all_text_contents())  # what is hidden has left no trace
    filled = page.evaluate(FILLED)
    assert 2 <= len(filled) <= 5 and min(filled) >= 0.6 and max(filled) <= 1, filled
    assert counted(page) == [len(filled)] * 2
    assert min(page.evaluate(POINTS)) > 6.9
    page.locator(".handout").evaluate("one => one.replaceWith()")
    page.emulate_media(media="screen")
    answers = printed(page, 5, "Print the answers of this walk")
    expect(answers).to_contain_text("the same 1.00 s")
    assert "?" not in "".join(answers.locator(".why").all_text_contents())
    assert page.evaluate("oscillations.walks.walk.answers.of('tour-01')") is None  # nothing was answered


@pytest.mark.slow  # a walk of 21 steps
def test_a_handout_that_is_printed_during_a_class_moves_nothing_and_fills_its_pages(window: Open) -> None:
    lecture, code = taught(window, "walk=d34&step=d34-05&projector")
    phone = joined(window, code)
    tap(phone, 0)
    sent(phone)
    lecture.wait_for_function(f"{QUIET} && {LED}.votes.tally?.now.answered === 1")
    before, news = lecture.evaluate(STANDS), phone.evaluate(NEWS)
    orders: list[str] = []
    lecture.on("request", lambda request: orders.append(request.url) if request.url.endswith("/lead") else None)
    printed(lecture, 21)
    expect(lecture.locator("iframe, .offer")).to_have_count(0)
    assert lecture.evaluate(STANDS) == before and not orders
    assert phone.evaluate(NEWS) == news and lecture.evaluate(f"{LED}.news.here") == 1
    filled = lecture.evaluate(FILLED)
    assert min(filled) > 0.6 * max(filled), "no page is half empty"
    assert 6 < len(filled) < 21 and counted(lecture) == [len(filled)] * 2


@pytest.mark.slow  # a walk of 16 steps
def test_a_handout_has_the_numbers_of_the_file(server: Server, new_page: Callable[..., Page]) -> None:
    """The page itself asks with this visitor's own numbers."""
    page = new_page(fresh=True, bypass_csp=False)
    page.goto(f"{server.url}?walk=d31&step=d31-02")
    expect(page.locator(".asked-line")).to_contain_text("One swing takes")
    own = page.evaluate("oscillations.walks.walk.numbers")
    pages = printed(page, 16)
    expect(pages.locator("article").nth(1)).to_contain_text("One swing takes 1.00 s")
    assert own and page.evaluate("oscillations.walks.walk.numbers") == own


def test_a_handout_that_cannot_be_prepared_says_so(server: Server, new_page: Callable[..., Page]) -> None:
    page = new_page(fresh=True)
    page.goto(f"{server.url}?walk=tour")
    page.wait_for_function(f"{CONNECTED} && oscillations.walks.walk?.card")
    page.route(re.compile(r"\?scene="), lambda route: route.fulfill(body="a page of another kind"))
    page.clock.install()
    page.locator(".walks summary").click()
    page.get_by_role("button", name=HANDOUT).click()
    expect(page.locator("iframe")).to_have_count(1)
    page.clock.run_for(30_000)
    expect(page.get_by_text("The handout could not be prepared.")).to_be_visible()
    expect(page.locator("iframe, .offer")).to_have_count(0)
