"""Fit in a browser: visible if there is a reason; the button, the key or a double click fits the frame again."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
WINDOW = "oscillations.shown.view.axes.t.end"


def heavier(page: Page) -> None:
    """Four times the mass, typed: the window stays, so the doubled period is visible."""
    before = page.evaluate(WINDOW)
    field = page.locator("input[name=m].field, input[name=m]").last
    field.fill("4")
    field.press("Enter")
    page.wait_for_function("oscillations.shown.settings.m.value === 4")
    assert page.evaluate(WINDOW) == before


def test_fit_by_button_key_and_double_click(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="oscillator")
    button = page.get_by_role("button", name="Fit", exact=True)
    expect(button).not_to_be_visible()
    plot = page.locator(".plot-area").first

    def press_key() -> None:
        page.locator("h1").focus()
        page.keyboard.press("0")

    for deed in (button.click, press_key, plot.dblclick):
        heavier(page)
        expect(button).to_be_visible()
        page.evaluate("document.activeElement.blur()")
        window = page.evaluate(WINDOW)
        deed()
        expect(button).not_to_be_visible()
        assert page.evaluate(WINDOW) == pytest.approx(2 * window)
        page.get_by_role("button", name="Pushed back").click()
        page.wait_for_function("oscillations.shown.settings.m.value === 1")
        expect(button).not_to_be_visible()
