"""The absorber in Chromium: the knob, the goals, the machine's facts, damping, a link, and no cut texts."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.browser.boxes import BROKEN

pytestmark = pytest.mark.browser
Open = Callable[..., Page]

CUT_OFF = "(p => p.scrollHeight - p.clientHeight)(document.querySelector('.panel'))"


def number(page: Page, name: str) -> str:
    return page.locator(f"[data-value={name}]").first.text_content() or ""


def test_student_finds_the_lightest_absorber(
    page: Page, open_scene: Open, screenshot: Callable[[Page, str], Path]
) -> None:
    open_scene(page, scene="absorber")
    screenshot(page, "absorber")
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


def test_own_machine_and_damping_open_when_asked_for(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="absorber", folded=True)
    expect(page.locator("input[name=omega]")).to_be_hidden()
    expect(page.locator("input[name=c]")).to_be_hidden()
    page.get_by_text("Beyond the lecture: damping").click()
    page.get_by_role("button", name="Add damping").click()
    page.get_by_role("button", name="Den Hartog's optimum").click()
    expect(page.locator("input[name=c]")).to_have_value("313.7")
    assert page.evaluate(CUT_OFF) <= 0
    page.get_by_role("button", name="Own", exact=True).click()
    expect(page.locator("input[name=omega]")).to_be_visible()
    assert page.evaluate(CUT_OFF) <= 0


def test_phone_has_the_goals_before_the_plot(
    new_page: Callable[..., Page], open_scene: Open, screenshot: Callable[[Page, str], Path]
) -> None:
    page = open_scene(new_page(width=390, height=844, has_touch=True), scene="absorber")
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    swing = page.get_by_role("img", name="Swing of the machine").bounding_box()
    goals = page.get_by_role("img", name="The goals, met or not").bounding_box()
    assert swing and goals
    assert goals["y"] + goals["height"] <= swing["y"] + 1
    expect(page.get_by_text("less vibration from")).to_be_hidden()
    screenshot(page, "absorber-phone")
