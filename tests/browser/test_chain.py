"""The chain in Chromium: each mass can be dragged, a mode is a button, time is dragged downwards."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page

pytestmark = pytest.mark.browser
MASS = """p => {
  const {svg, named} = oscillations.page.stages[0]
  const {left, top, width, height} = svg.getBoundingClientRect()
  const {end} = oscillations.page.shown.view.axes.y
  return [left + 56 + ((width - 90) * p) / 9, top + height / 2 - (0.36 * height * named[`x${p}`]) / end]
}"""
SET = "name => oscillations.page.shown.settings[name].value"
PLUCKED = {"starts": "pluck", "N": 8, "m": 0.5, "k": 2, "a": 0.5, "p": 3}


def test_the_mass_at_the_pointer_is_taken(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="chain", **PLUCKED)
    page.get_by_role("button", name="Pause").click()
    x, y = page.evaluate(MASS, 6)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, y - 20, steps=4)
    page.wait_for_function(f"({SET})('p') === 6")
    page.mouse.up()
    page.wait_for_function("!oscillations.page.hand.grab")
    assert page.evaluate(SET, "starts") == "pluck"
    assert page.evaluate(SET, "h") > 0


def test_the_pulse_is_led_to_where_it_starts(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="chain")
    page.get_by_role("button", name="Pause").click()
    page.wait_for_function("oscillations.page.clock.t > 0")
    ring = page.get_by_role("slider", name="Pulse, start")
    box, spacing = ring.bounding_box(), "(oscillations.page.stages[0].svg.getBoundingClientRect().width - 90) / 4.5"
    assert box and ring.get_attribute("aria-orientation") is None
    metre = page.evaluate(spacing)
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + metre, y, steps=4)
    page.wait_for_function(f"Math.abs(({SET})('centre') - 1.8) < 0.02 && oscillations.page.clock.t === 0")
    page.mouse.up()
    page.wait_for_function("!oscillations.page.hand.grab")
    assert page.evaluate(SET, "h") == pytest.approx(0.4, abs=0.02)
    ring.press("ArrowLeft")
    page.wait_for_function(f"({SET})('centre') < 1.8")
    before = page.evaluate(SET, "h")
    ring.press("ArrowDown")
    page.wait_for_function(f"({SET})('h') < {before} && ({SET})('starts') === 'pulse'")


def test_a_mode_is_a_button(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="chain", view="modes", **PLUCKED)
    assert page.locator(".mode-row button").count() == 8
    page.get_by_role("button", name="Mode 4").click()
    page.wait_for_function(f"({SET})('starts') === 'mode' && ({SET})('j') === 4")
    page.wait_for_function("document.querySelector('.mode-row [aria-pressed=true]')?.textContent === '4'")


def test_the_time_is_dragged_downwards(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="chain")
    page.get_by_role("button", name="Pause").click()
    before = page.evaluate("oscillations.page.clock.t")
    pill = page.get_by_role("slider", name="Time")
    place = pill.bounding_box()
    assert place and pill.get_attribute("aria-orientation") == "vertical"
    x, y = place["x"] + place["width"] / 2, place["y"] + place["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, y + 60, steps=4)
    page.mouse.up()
    assert page.evaluate("oscillations.page.clock.t") > before + 1


def test_two_masses_open_in_coupled_with_the_same_system(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="chain", N=2, ends="fixed-free", starts="mass", p=1, m=2, k=3, h=0.3)
    page.get_by_role("link", name="Open in Coupled").click()
    page.wait_for_function("oscillations.page.spec.slug === 'coupled' && oscillations.page.shown")
    values = {name: page.evaluate(SET, name) for name in ("m1", "m2", "k1", "k2", "x1_0", "x2_0")}
    assert values == {"m1": 2, "m2": 2, "k1": 3, "k2": 3, "x1_0": 0.3, "x2_0": 0}
    page.get_by_role("link", name="Open in Chain").click()
    page.wait_for_function("oscillations.page.spec.slug === 'chain' && oscillations.page.shown")
    assert page.evaluate(SET, "h") == 0.3
