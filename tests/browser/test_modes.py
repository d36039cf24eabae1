"""Scene modes in a browser: the knobs on both axes, the flags, the four views, the hunt."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.browser.waiting import turned

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
Keep = Callable[[Page, str], Path]


def test_guess_with_the_knobs_and_the_flags(page: Page, open_scene: Open, screenshot: Keep) -> None:
    open_scene(page, scene="modes", view="guess", theme="light")
    screenshot(page, "modes-guess")
    knob = page.get_by_role("slider", name="Trial frequency, squared")
    knob.press("ArrowRight")
    page.wait_for_function("oscillations.shown.settings.omega.value > 1.7")
    page.get_by_role("slider", name="Trial shape X2/X1", exact=True).press("ArrowUp")
    page.wait_for_function("oscillations.shown.settings.ratio.value > -0.8")
    page.get_by_role("button", name="Go to the fast mode").click()
    expect(page.get_by_text("Both equations agree: the fast mode.")).to_be_visible()
    page.get_by_role("button", name="Use equation 1").click()
    page.wait_for_function("oscillations.shown.settings.ratio.value === -1")
    expect(page.get_by_text("no extra force: a mode")).to_be_visible()
    page.wait_for_url(re.compile("omega=2"))


def at(page: Page, plot: str, x: float, y: float) -> tuple[float, float]:
    """The position of a point of a plot on the page."""
    page.wait_for_function(f"oscillations.plots.find(p => p.block.name === '{plot}').box")
    found = page.evaluate(f"""(p => {{
      const box = p.host.getBoundingClientRect()
      return [box.x + p.px({x}), box.y + p.py({y})] }})(oscillations.plots.find(p => p.block.name === '{plot}'))""")
    return found[0], found[1]


def drag(page: Page, start: tuple[float, float], end: tuple[float, float]) -> None:
    page.mouse.move(*start)
    page.mouse.down()
    page.mouse.move(*end, steps=4)
    page.mouse.up()


def test_hunt_by_dragging_the_start(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="modes", view="hunt")
    drag(page, at(page, "plane", 0.9, 0.2), at(page, "plane", 0.5, 1.0))
    expect(page.get_by_text("Found: a straight line, the slow mode.")).to_be_visible()
    expect(page.get_by_text("The directions of the modes:")).to_be_hidden()
    page.get_by_role("button", name="Reveal").click()
    expect(page.get_by_text("The directions of the modes:")).to_be_visible()
    before = page.evaluate("oscillations.clock.t")
    page.wait_for_function(f"oscillations.clock.t !== {before}")


def test_views_on_a_narrow_phone(new_page: Callable[..., Page], open_scene: Open) -> None:
    page = open_scene(new_page(320, 800, has_touch=True), scene="modes")
    for view in ("guess", "solve", "roots", "sweep", "hunt"):
        for values in ({}, {"k2": 1e8}, {"m2": 1e-6}, {"m1": 1.2345e-100, "k1": 1e100}):
            turned(page, "modes", {"view": view, **values})
            assert page.evaluate("document.documentElement.scrollWidth") == 320, (view, values)
        chip = page.get_by_role("button", name="All equal")
        chip.scroll_into_view_if_needed()
        chip.click(timeout=3000)
        page.wait_for_function("oscillations.shown.settings.m1.value === 1")


def test_transport_on_a_phone_is_under_the_stage_in_sight(new_page: Callable[..., Page], open_scene: Open) -> None:
    page = open_scene(new_page(390, 844, has_touch=True), scene="modes")
    top = "parseFloat(getComputedStyle(document.querySelector('.transport')).top)"
    height = "([...document.querySelectorAll('.stage.block:not(.still)')].find(b => b.offsetHeight)?.offsetHeight) ?? 0"
    for name in ("Solve", "Hunt", "Guess"):
        page.get_by_role("tab", name=name, exact=True).click()
        page.wait_for_function(f"oscillations.shown.settings.view.value === '{name.lower()}'")
        assert page.evaluate(top) == page.evaluate(height)
