"""The absorber in Chromium: the knob, the goals, the machine's facts, damping, a link, and no cut texts."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.browser.boxes import BROKEN

pytestmark = pytest.mark.browser
Open = Callable[..., Page]


def number(page: Page, name: str) -> str:
    return page.locator(f"[data-value={name}]").first.text_content() or ""


def test_student_finds_the_lightest_absorber(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="absorber")
    assert number(page, "found0").startswith("nearest is 16.1 % away")
    before = page.evaluate("[...oscillations.shown.view.columns.sweep.swing]")
    page.locator("input[name=m2]").fill("25.1")
    page.locator("input[name=m2]").press("Enter")
    expect(page.locator("[data-value=lightest]").first).to_have_text("25.1 kg")
    expect(page.get_by_role("button", name="Keep tuned")).to_have_attribute("aria-pressed", "true")
    assert page.evaluate("[...oscillations.shown.view.columns.sweep.swing]") != before
    knob = page.get_by_role("slider", name="Frequency to which the absorber is tuned")
    knob.focus()
    knob.press("ArrowLeft")
    expect(page.get_by_role("button", name="Free")).to_have_attribute("aria-pressed", "true")
    expect(knob).to_contain_text("47.7")
    page.get_by_role("img", name="Swing of the machine").click(position={"x": 330, "y": 90})
    expect(knob).not_to_contain_text("47.7")
    page.get_by_role("button", name="Detach").click()
    expect(page.get_by_text("no improvement")).to_be_visible()
    assert page.evaluate(BROKEN) == 0
