"""A finger on a plot: a scroll that starts there sets nothing, a tap acts when it ends, a move sideways drags."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page

from components.scenes import SCENES
from tests.browser.touch import Finger
from tests.browser.waiting import turned

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
STATE = """() => {
  const {shown, clock, host} = oscillations.page
  const values = Object.entries(shown.settings).map(([name, {value}]) => [name, value])
  return JSON.stringify([values, clock.t, host.messages.last])
}"""
"""All values, the instant, and the number of the last message."""
PLOTS = """() => oscillations.page.plots
  .filter(({host, absent, block: {handles, time, pick}}) => !absent && host.checkVisibility() &&
    host.style.touchAction !== "none" && (handles.length || time || pick))
  .map(({block}) => block.name)"""
PLACE = """name => {
  const plot = oscillations.page.plots.find(({block}) => block.name === name)
  plot.host.scrollIntoView({block: "center"})
  const {left, top} = plot.host.getBoundingClientRect()
  const {frame} = plot
  return [left + frame.left + 0.7 * frame.width, top + frame.top + 0.6 * frame.height]
}"""
SET = "name => oscillations.page.shown.settings[name].value"
PLUCKED = {"starts": "pluck", "N": 8, "m": 0.5, "k": 2, "a": 0.5, "p": 3}


def phone(new_page: Callable[..., Page]) -> Page:
    return new_page(390, 844, has_touch=True, is_mobile=True)


SCROLLED = [slug for slug in SCENES if slug != "accuracy"]
"""Every plot of accuracy has a handle at its vertical axis: a finger on it does not scroll."""
EACH = [slug if slug == "chain" else pytest.param(slug, marks=pytest.mark.slow) for slug in SCROLLED]


@pytest.mark.parametrize("slug", EACH)
def test_a_scroll_that_begins_on_a_plot_sets_nothing(
    slug: str, new_page: Callable[..., Page], open_scene: Open
) -> None:
    page = open_scene(phone(new_page), scene=slug)
    finger, tried = Finger(page), set[str]()
    for view in SCENES[slug].views:
        turned(page, slug, {"view": view.slug})
        page.evaluate("oscillations.page.clock.playing = false")
        for name in set(page.evaluate(PLOTS)) - tried:
            tried.add(name)
            x, y = page.evaluate(PLACE, name)
            before, top = page.evaluate(STATE), page.evaluate("scrollY")
            finger.down(x, y)
            for far in range(10, 90, 10):
                finger.move(x + 2, y - far)
            finger.up()
            page.wait_for_function("top => scrollY !== top", arg=top)
            assert page.evaluate(STATE) == before, (view.slug, name)
    assert tried, "no plot acts on a press"


@pytest.mark.parametrize("view", ["spectrum", "modes"])
def test_a_tap_starts_a_mode_and_a_move_sideways_drags_it(
    view: str, new_page: Callable[..., Page], open_scene: Open
) -> None:
    page = open_scene(phone(new_page), scene="chain", view=view, **PLUCKED)
    finger = Finger(page)
    (name,) = page.evaluate(PLOTS)
    x, y = page.evaluate(PLACE, name)
    finger.down(x, y)
    assert page.evaluate(SET, "starts") == "pluck", "a press alone may be the begin of a scroll"
    finger.up()
    page.wait_for_function(f"({SET})('starts') === 'mode'")
    page.wait_for_function(f"({SET})('j') === 6")
    finger.down(x, y)
    for far in range(0, 100, 10):
        finger.move(x - far, y)
    page.wait_for_function(f"({SET})('j') < 5")
    finger.up()
    page.wait_for_function("!oscillations.page.busy?.held")
    assert page.evaluate(SET, "starts") == "mode"


def test_a_tap_moves_the_instant_and_the_clock_plays_on(new_page: Callable[..., Page], open_scene: Open) -> None:
    page = open_scene(phone(new_page), scene="coupled")
    page.evaluate("oscillations.page.clock.playing = true; oscillations.page.clock.seek(0)")
    (name, *_) = page.evaluate(PLOTS)
    end = page.evaluate("oscillations.page.shown.view.axes.t.end")
    finger = Finger(page)
    finger.down(*page.evaluate(PLACE, name))
    finger.up()
    page.wait_for_function("end => oscillations.page.clock.t > 0.68 * end && oscillations.page.clock.playing", arg=end)
