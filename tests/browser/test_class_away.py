"""A class of three phones whose server is killed and restarted while they answer, and whose lead changes computers."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect

from tests.browser.classroom import CONNECTED, LED, counted
from tests.browser.tabs import calm_context
from tests.browser.waiting import clicked
from tests.reconnect.site import Site

pytestmark = pytest.mark.browser

BACK = 30_000
"""Milliseconds that pages may take to come back by themselves."""
SENT = "Sent. You can change it"


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


@pytest.mark.slow
@pytest.mark.timeout(300)  # five windows
def test_no_answer_is_lost_when_the_server_is_killed(contexts: list[BrowserContext], tmp_path: Path) -> None:
    with Site(tmp_path) as site:
        lecture, *phones = (context.new_page() for context in contexts[:4])
        lecture.goto(f"{site.url}?walk=d31&step=d31-03")
        lecture.wait_for_function(CONNECTED)
        lecture.keyboard.press("t")
        lecture.wait_for_function(f"{LED}?.news.question?.step === 'd31-03'")
        code: str = lecture.evaluate(f"{LED}.room.code")
        for phone in phones:
            phone.goto(f"{site.url}{code}")
        put(phones, "d31-03")
        for phone in phones[:2]:
            tap(phone, 0)
            expect(phone.get_by_text(SENT)).to_be_visible()

        site.kill()
        tap(phones[2], 1)
        expect(phones[2].get_by_text("Not sent yet; trying again.")).to_be_visible()
        site.start()
        expect(phones[2].get_by_text(SENT)).to_be_visible(timeout=BACK)
        expect(lecture.locator(".votes")).to_contain_text("3 of 3 have answered", timeout=BACK)
        clicked(lecture)
        counted(lecture, "2", "1", "0")
