"""A class for tests: the instructor's window, phones that join it, and a hand that draws."""

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.browser.fixtures import CONNECTED, READY, Open
from tests.browser.waiting import stroke
from tests.serving.server import Server

LED = "globalThis.oscillations?.classes?.led"
FILLED = ".card .foot .filled"
FRAME = """(() => { const {pad, marker} = (oscillations.walks?.walk ?? oscillations.asked).card.question
  const {host, frame: f} = (pad ?? marker).plot, b = host.getBoundingClientRect()
  return [b.left + f.left, b.top + f.top, f.width, f.height] })()"""
"""The frame in which a sketch is drawn or a point is marked, on a phone or on a visitor's own page."""


def opening(make: Open, url: str) -> Open:
    """Opens addresses below `url` on new pages."""

    def go(query: str, width: int, height: int) -> Page:
        page = make(width=width, height=height)
        page.goto(f"{url}?{query}")
        return page

    return go


@pytest.fixture
def window(server: Server, new_page: Open) -> Open:
    return opening(new_page, server.url)


@pytest.fixture
def failing(server: Server, quiet: Open) -> Open:
    """Pages for a class in which requests fail on purpose; browsers log these as errors."""
    return opening(quiet, server.url)


def taught(window: Open, query: str, width: int = 1920, height: int = 1080) -> tuple[Page, str]:
    """An instructor's window with an open class, and its code."""
    page = window(query, width, height)
    page.wait_for_function(CONNECTED)
    page.keyboard.press("t")
    page.wait_for_function(LED)
    code: str = page.evaluate(f"{LED}.room.code")
    return page, code


def joined(window: Open, code: str, width: int = 390, height: int = 844) -> Page:
    page = window(f"class={code.lower()}", width, height)
    page.wait_for_function(f"{READY} && Boolean(oscillations.clock.lead)")
    return page


def put(step: str, lecture: Page, *phones: Page, timeout: float | None = None) -> None:
    """Wait until hall and phones ask a step."""
    lecture.wait_for_function("step => oscillations.walks.walk?.step?.id === step", arg=step, timeout=timeout)
    asked = "step => oscillations.asked.question?.step === step && oscillations.asked.card"
    for phone in phones:
        phone.wait_for_function(asked, arg=step, timeout=timeout)


def sent(phone: Page, timeout: float | None = None) -> None:
    """Wait until the class has the answer of a phone."""
    expect(phone.get_by_text("You can change it until the")).to_be_visible(timeout=timeout)


def ticket(lecture: Page, button: str, answer: str) -> str:
    """The address that the instructor's dialog shows."""
    lecture.keyboard.press("j")
    with lecture.expect_response(re.compile(f"/{answer}$")) as response:
        lecture.get_by_role("button", name=button).click()
    return str(response.value.json()["address"])


def remote_of(lecture: Page, window: Open, width: int = 390, height: int = 844) -> Page:
    """A phone that is accepted as the remote control, by the digits that it shows."""
    remote = window(ticket(lecture, "Remote control", "tickets").partition("?")[2], width, height)
    expect(remote.locator("h1")).to_have_text(re.compile(r"^\d\d$"))
    expect(lecture.get_by_role("dialog")).to_contain_text(f"show {remote.locator('h1').inner_text()}?")
    lecture.get_by_role("button", name="Yes, connect it").click()
    remote.get_by_role("button", name="Close").click()
    expect(lecture.get_by_role("dialog")).to_have_count(0)
    return remote


def onward(remote: Page, words: str) -> None:
    """Press the button that leads on. Another button with these words is hidden once this one has them."""
    remote.locator(".remote-deeds .filled", has_text=words).click()


def draw(page: Page, height: Callable[[float], float], count: int = 40) -> None:
    """Draw a curve: heights and positions as shares of the frame."""
    page.locator(".drawing").scroll_into_view_if_needed()
    left, top, width, tall = page.evaluate(FRAME)
    shares = [i / count for i in range(count + 1)]
    stroke(page.mouse, [(left + share * width, top + (1 - height(share)) * tall) for share in shares])


def counted(lecture: Page, *counts: str) -> None:
    """Return the votes for each answer, in the order of the walk's file."""
    for i, count in enumerate(counts):
        expect(lecture.locator(f".answers [data-option='{i}'] .vote-count")).to_have_text(count)
