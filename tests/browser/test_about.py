"""About these numbers in Chromium: no request while closed, a request when opened and after a change, all within its
panel.
"""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, WebSocket, expect

from components.scenes import SCENES
from tests.browser.waiting import QUIET, passed
from tests.grids import spread

pytestmark = pytest.mark.browser
Open = Callable[..., Page]

SLUGS = [slug for slug, scene in SCENES.items() if scene.is_checked()]
LATER = 700  # ms, much longer than the pause after which a request is sent
FIT = """() => {
  const page = document.documentElement, about = document.querySelector('.about')
  const parts = [about, ...about.querySelectorAll('table, p')]
  return {
    page: page.scrollWidth <= innerWidth,
    about: parts.every(part => part.scrollWidth <= about.clientWidth),
    panel: document.querySelector('.panel').scrollWidth <= innerWidth,
  }
}"""
HIGH = "document.documentElement.scrollHeight > innerHeight"


def asked(page: Page) -> list[str]:
    """Grows by every message that requests the numbers; a repeated message keeps its number and counts once."""
    questions: list[str] = []

    def told(payload: str | bytes) -> None:
        if isinstance(payload, str) and '"about"' in payload:
            number = re.findall(r'\["number",\d+\]', payload)[0]
            if number not in questions:
                questions.append(number)

    def opened(socket: WebSocket) -> None:
        socket.on("framesent", told)

    page.on("websocket", opened)
    return questions


def wait_moment(page: Page) -> None:
    """Wait until delayed work is done and all messages are answered."""
    page.clock.fast_forward(LATER)
    page.wait_for_function(QUIET)


def settle(page: Page) -> None:
    """Wait until nothing is requested and the answer is visible."""
    wait_moment(page)
    page.wait_for_function("!document.querySelector('.about [aria-busy]')")


def unfold(page: Page) -> None:
    page.locator(".about summary").click()
    expect(page.locator(".about tbody, .about table").first).to_be_visible(timeout=30_000)  # a worker may be starting


def test_it_is_asked_when_opened_and_after_a_change_and_never_while_folded(
    new_page: Callable[..., Page], open_scene: Open
) -> None:
    page = new_page(fresh=True)
    questions = asked(page)
    page.clock.install()
    open_scene(page, scene="coupled")
    expect(page.locator(".about")).not_to_have_attribute("open", "")
    settle(page)
    assert not questions

    unfold(page)
    assert len(questions) == 1
    table = page.locator(".about table").first
    before = table.text_content()
    page.locator('input[name="k2-slider"]').press("ArrowRight")
    expect(table).not_to_have_text(before or "")
    settle(page)
    count = len(questions)

    page.evaluate("for (let n = 0; n < 9; n++) oscillations.about.update()")
    expect(page.locator(".about-body")).to_have_attribute("aria-busy", "true")
    settle(page)
    assert len(questions) == count + 1

    page.evaluate("() => { oscillations.about.update(); document.querySelector('.about').open = false }")
    page.locator('input[name="k2-slider"]').press("ArrowRight")
    wait_moment(page)
    assert len(questions) == count + 1


@pytest.mark.parametrize("slug", spread(SLUGS))
def test_it_stays_within_the_panel(slug: str, page: Page, open_scene: Open) -> None:
    open_scene(page, scene=slug, folded=True)
    assert not page.evaluate(HIGH)
    unfold(page)
    assert not page.evaluate(HIGH)
    assert all(page.evaluate(FIT).values()), page.evaluate(FIT)
    top = "document.querySelector('.{}').getBoundingClientRect().top"
    assert page.evaluate(f"{top.format('about')} - {top.format('panel')}") > -1
    expect(page.locator(".about .bound").first).to_be_in_viewport()
    page.set_viewport_size({"width": 390, "height": 844})
    passed(page)
    assert all(page.evaluate(FIT).values()), page.evaluate(FIT)
