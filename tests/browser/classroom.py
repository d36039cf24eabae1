"""A class for tests: the instructor's window, phones that join it, and a hand that draws."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.fixtures import READY
from tests.browser.tabs import calm_context
from tests.serving.server import Server, serving

CONNECTED = f"{READY} && document.documentElement.dataset.connected === 'true'"
LED = "globalThis.oscillations?.classes?.led"
PAD = """(() => { const {plot} = oscillations.asked.card.question.pad
  const b = plot.host.getBoundingClientRect(), f = plot.frame
  return [b.left + f.left, b.top + f.top, f.width, f.height] })()"""

Open = Callable[[str, int, int], Page]


@pytest.fixture
def window(server: Server, new_page: Callable[..., Page]) -> Open:
    def go(query: str, width: int, height: int) -> Page:
        page = new_page(width=width, height=height)
        page.goto(f"{server.url}?{query}")
        return page

    return go


@pytest.fixture
def failing(server: Server, browser: Browser) -> Iterator[Open]:
    """Pages for a class in which requests fail on purpose; browsers log these as errors."""
    with _opened(browser, server) as go:
        yield go


@contextmanager
def walked(browser: Browser, folder: Path, name: str, walk: str) -> Iterator[Open]:
    """Pages of a server that has a walk from a file."""
    (folder / f"{name}.toml").write_text(walk, encoding="utf-8")
    with serving(folder / "log", environment={"WALKS": str(folder)}) as server, _opened(browser, server) as go:
        yield go


@contextmanager
def _opened(browser: Browser, server: Server) -> Iterator[Open]:
    """Pages of a server, each in its own context."""
    contexts = []

    def go(query: str, width: int, height: int) -> Page:
        contexts.append(calm_context(browser, {"width": width, "height": height}, bypass_csp=True))
        page = contexts[-1].new_page()
        page.goto(f"{server.url}?{query}")
        return page

    yield go
    for context in contexts:
        context.close()


def taught(window: Open, query: str) -> tuple[Page, str]:
    """An instructor's window with an open class, and its code."""
    page = window(query, 1920, 1080)
    page.wait_for_function(CONNECTED)
    page.keyboard.press("t")
    page.wait_for_function(LED)
    code: str = page.evaluate(f"{LED}.room.code")
    return page, code


def joined(window: Open, code: str, width: int = 390, height: int = 844) -> Page:
    page = window(f"class={code.lower()}", width, height)
    page.wait_for_function(f"{READY} && Boolean(oscillations.clock.lead)")
    return page


def put(lecture: Page, phone: Page, step: str) -> None:
    """Wait until hall and phone ask a step."""
    lecture.wait_for_function("step => oscillations.walks.walk?.step?.id === step", arg=step)
    phone.wait_for_function("step => oscillations.asked.question?.step === step && oscillations.asked.card", arg=step)


def remote_of(lecture: Page, window: Open, width: int = 390, height: int = 844) -> Page:
    """A phone that is accepted as the remote control."""
    lecture.keyboard.press("j")
    with lecture.expect_response(re.compile("/tickets$")) as answer:
        lecture.get_by_role("button", name="Remote control").click()
    remote = window(answer.value.json()["address"].partition("?")[2], width, height)
    lecture.get_by_role("button", name="Yes, connect it").click()
    remote.get_by_role("button", name="Close").click()
    expect(lecture.get_by_role("dialog")).to_have_count(0)
    return remote


def draw(page: Page, height: Callable[[float], float]) -> None:
    page.locator(".drawing").scroll_into_view_if_needed()
    left, top, width, tall = page.evaluate(PAD)
    for i in range(41):
        page.mouse.move(left + i / 40 * width, top + (1 - height(i / 40)) * tall)
        if not i:
            page.mouse.down()
    page.mouse.up()


def counted(lecture: Page, *counts: str) -> None:
    """Return the votes for each answer, in the order of the walk's file."""
    for i, count in enumerate(counts):
        expect(lecture.locator(f".answers [data-option='{i}'] .vote-count")).to_have_text(count)
