"""A class of three phones whose server is killed and restarted while they answer, and whose lead moves to another
computer.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect

from tests.browser.classroom import CONNECTED, LED, counted, draw
from tests.browser.tabs import calm_context
from tests.browser.waiting import clicked
from tests.live_class.caller import call
from tests.reconnect.site import Site

pytestmark = pytest.mark.browser

BACK = 30_000
"""Milliseconds in which pages must reconnect."""
COPIED = f"{LED}.copies.answers.size === 2 && !{LED}.copies.stale.size"
SENT = "You can change it"


@pytest.fixture
def contexts(browser: Browser) -> Iterator[list[BrowserContext]]:
    """The browsers of the instructor, of three phones, and of a second computer. They log errors while the server is
    away."""
    sizes = ((1280, 844), (390, 844), (390, 844), (390, 844), (1280, 844))
    made = [calm_context(browser, {"width": w, "height": h}, bypass_csp=True) for w, h in sizes]
    yield made
    for context in made:
        context.close()


def put(phones: list[Page], step: str) -> None:
    for phone in phones:
        phone.wait_for_function(
            "step => oscillations.asked.question?.step === step && oscillations.asked.card", arg=step, timeout=BACK
        )


def tap(phone: Page, option: int) -> None:
    phone.locator(f".answers [data-option='{option}']").click()


def killed(site: Site, phone: Page, answer: Callable[[], None]) -> None:
    """A phone answers while there is no server."""
    site.kill()
    answer()
    expect(phone.get_by_text("Not sent yet; trying again.")).to_be_visible()
    site.start()
    expect(phone.get_by_text(SENT)).to_be_visible(timeout=BACK)


def begun(context: BrowserContext, site: Site) -> Page:
    """The instructor's page with a class that asks its first question."""
    lecture = context.new_page()
    lecture.goto(f"{site.url}?walk=d31&step=d31-03")
    lecture.wait_for_function(CONNECTED)
    lecture.keyboard.press("t")
    lecture.wait_for_function(f"{LED}?.news.question?.step === 'd31-03'")
    return lecture


def taken_over(lecture: Page, context: BrowserContext) -> Page:
    """The page of another computer, which takes the lead."""
    lecture.keyboard.press("j")
    with lecture.expect_response(re.compile("/word$")) as answer:
        lecture.get_by_role("button", name="Another computer").click()
    other = context.new_page()
    other.goto(answer.value.json()["address"])
    other.wait_for_function(f"{LED}?.news.number && oscillations.walks.walk?.card", timeout=BACK)
    other.wait_for_function(COPIED)  # the answers that the first computer had copied
    return other


@pytest.mark.slow
@pytest.mark.timeout(300)  # five windows
def test_no_answer_is_lost_when_the_server_is_killed(contexts: list[BrowserContext], tmp_path: Path) -> None:
    with Site(tmp_path) as site:
        lecture = begun(contexts[0], site)
        code = lecture.evaluate(f"{LED}.room.code")
        phones = [context.new_page() for context in contexts[1:4]]
        for phone in phones:
            phone.goto(f"{site.url}{code}")
        put(phones, "d31-03")
        for phone in phones[:2]:
            tap(phone, 0)
            expect(phone.get_by_text(SENT)).to_be_visible()
        killed(site, phones[2], lambda: tap(phones[2], 1))
        expect(lecture.locator(".votes")).to_contain_text("3 of 3 have answered", timeout=BACK)
        clicked(lecture)
        counted(lecture, "2", "1", "0")
        lecture.wait_for_function(CONNECTED, timeout=BACK)
        clicked(lecture)
        lecture.wait_for_function("oscillations.walks.walk.lesson")
        clicked(lecture)
        clicked(lecture)
        put(phones, "d31-04")
        for phone in phones[:2]:
            draw(phone, lambda x: 0.2 + 0.6 * x)
            expect(phone.get_by_text(SENT)).to_be_visible()
        other = taken_over(lecture, contexts[4])
        killed(site, phones[2], lambda: draw(phones[2], lambda x: 0.8 - 0.6 * x))
        expect(other.locator(".votes")).to_contain_text("3 of 3 have answered", timeout=BACK)
        key = other.evaluate(f"{LED}.room.key")
        assert call(site.url, f"/class/{code}/stored", word=key).json == {"answers": 6, "questions": 2}
        other.wait_for_function(CONNECTED, timeout=BACK)
        clicked(other, "PageUp")  # to the question that this computer has never shown
        put(phones, "d31-03")
        other.wait_for_function("oscillations.walks.walk.lesson", timeout=BACK)
        counted(other, "2", "1", "0")
