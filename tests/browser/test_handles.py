"""Handles, plots and links between scenes: dragged by a finger on a phone, the time by the mouse."""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import pairwise

import pytest
from playwright.sync_api import Locator, Page, expect

from components.scenes import SCENES
from tests.browser.touch import Finger
from tests.browser.waiting import passed, turned

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
UNANCHORED = ":root, body {overflow-anchor: none}"
"""A browser without scroll anchoring."""
STANDS = "([block, top]) => Math.abs(block.getBoundingClientRect().top - top) <= 1"
"""True if a block is where it was. Lines that appear above move it until the next frame at most."""
BOXES = """plot => [plot.querySelector(".pill"), ...plot.querySelectorAll(".scale text")].map(part => {
  const {top, height} = part.getBoundingClientRect(), bare = part.matches("text") ? height / 6 : 0
  return [top + bare, top + height - bare]
})"""
"""Top and bottom, in pixels, of a plot's handle, then of each number at its vertical axis without the room under a
digit.
"""


def middle(handle: Locator) -> tuple[float, float]:
    handle.evaluate("handle => handle.scrollIntoView({block: 'center'})")
    box = handle.bounding_box()
    assert box
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def top(block: Locator) -> float:
    """The position of a block in the window."""
    return float(block.evaluate("block => block.getBoundingClientRect().top"))


@pytest.mark.parametrize(
    ("query", "name", "way", "moves"),
    [
        ({"scene": "forced"}, "Drive frequency", (40, 0), "omega.value > 0.9"),
        ({"scene": "absorber"}, "Frequency to which the absorber is tuned", (40, 0), "k2.value > 40000"),
        ({"scene": "modes", "view": "guess"}, "Trial shape X2/X1", (0, -40), "ratio.value > 0"),
        ({"scene": "modes", "view": "hunt"}, "Start of mass 2", (0, -40), "x2_0.value > 0.8"),
        ({"scene": "modes", "view": "sweep"}, "k₂, swept", (-40, 0), "k2.value < 0.5"),
        ({"scene": "accuracy", "view": "time"}, "Accepted error", (0, -40), "wanted.value > 1e-5"),
    ],
)
def test_a_finger_drags_a_handle_from_where_it_has_taken_it_and_not_the_page(
    query: dict[str, str], name: str, way: tuple[int, int], moves: str, new_page: Callable[..., Page], open_scene: Open
) -> None:
    page = open_scene(new_page(390, 844, has_touch=True, is_mobile=True), **query)
    handle = page.get_by_role("slider", name=name, exact=True)
    page.add_style_tag(content=UNANCHORED)
    x, y = middle(handle)
    plot = page.locator(".block.plot").filter(has=handle)
    before = top(plot)
    finger = Finger(page)
    finger.down(x + 9, y - 9)
    finger.move(x + 9 + way[0], y - 9 + way[1])
    page.wait_for_function(f"oscillations.shown.settings.{moves}")
    page.wait_for_function(STANDS, arg=[plot.element_handle(), before])
    box = handle.bounding_box()
    assert box
    gone = (box["x"] + box["width"] / 2 - x, box["y"] + box["height"] / 2 - y)
    assert gone[way[1] != 0] == pytest.approx(sum(way), abs=3), "no leap to where the finger is"
    finger.up()


@pytest.mark.parametrize("part", [".grip[aria-label^='Mass 1']", ".pill[data-grab=omega]", "[name=omega-slider]"])
def test_lines_that_come_above_move_nothing_under_a_hand(part: str, page: Page, open_scene: Open) -> None:
    page.set_viewport_size({"width": 390, "height": 700})
    open_scene(page, scene="forced")
    page.add_style_tag(content=UNANCHORED)
    page.evaluate("oscillations.clock.playing = false")
    held = page.locator(part).first
    page.mouse.move(*middle(held))
    page.mouse.down()
    passed(page)
    before = top(held)
    page.evaluate("document.querySelector('h1').style.paddingBottom = '50px'")
    passed(page)
    assert top(held) == pytest.approx(before, abs=1)
    page.evaluate("""() => {
      document.querySelector("h1").style.paddingBottom = "70px"
      document.body.style.height = `${document.body.offsetHeight - 20}px`
    }""")
    passed(page)
    assert top(held) == pytest.approx(before, abs=1), "the page is as tall as before"
    page.mouse.up()
    page.evaluate("document.body.removeAttribute('style'); document.querySelector('h1').style.paddingBottom = ''")
    passed(page)
    if "grip" not in part:
        assert top(held) < before - 20, "nothing is held any more"


def test_time_is_dragged_and_plays_on(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    page.evaluate("oscillations.clock.seek(1)")
    x, y = middle(page.get_by_role("slider", name="Time"))
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 200, y, steps=3)
    held = page.evaluate("oscillations.clock.t")
    assert held > 5
    assert not page.evaluate("oscillations.clock.playing")
    page.mouse.up()
    page.wait_for_function(f"oscillations.clock.t > {held}")


READ = """() => {
  const plot = oscillations.plots.find(plot => plot.block.handles.length && plot.host.checkVisibility())
  return [...plot.figure.model.below[0].major_label_overrides.values()].filter(Boolean).join()
}"""


def test_a_number_of_the_axis_is_read_whole_or_not_at_all(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="forced")
    for omega, read in ((0.5, "0,1,2 rad/s"), (0.97, "0,2 rad/s"), (1.03, "0,2 rad/s"), (0.5, "0,1,2 rad/s")):
        turned(page, "forced", {"omega": omega})
        passed(page)
        assert page.evaluate(READ) == read, omega


def test_help_is_also_of_the_handle_that_has_the_focus(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="forced")
    says = page.locator("#controls-says")
    handle = page.get_by_role("slider", name="Drive frequency", exact=True)
    handle.focus()
    expect(says).to_have_text("ω is the drive frequency. Type any value from 0 up.")
    page.get_by_role("tab", name="Motion").focus()
    expect(handle).to_have_accessible_description(re.compile("^ω is the drive frequency. Type any value from 0 up."))
    handle.focus()
    page.get_by_role("tab", name="Motion").focus()
    expect(says).to_have_text("")


def test_a_drag_over_a_plot_moves_the_instant_and_letting_go_plays_on(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    box = page.locator(".plot-area").first.bounding_box()
    assert box
    y = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + 0.4 * box["width"], y)
    page.mouse.down()
    first = page.evaluate("oscillations.clock.t")
    page.mouse.move(box["x"] + 0.7 * box["width"], y, steps=3)
    assert page.evaluate("oscillations.clock.t") > first + 1
    assert not page.evaluate("oscillations.clock.playing")
    page.mouse.up()
    page.wait_for_function("oscillations.clock.playing")


def test_a_handle_at_a_vertical_axis_cuts_no_number(page: Page, open_scene: Open) -> None:
    """Over all its values, also in the hall, where type is large and the plot low. Numbers do not touch."""
    open_scene(page, scene="modes", view="guess", ratio=1)
    plot = page.locator(".block.plot:visible").filter(has=page.locator(".pill"))
    seen = set()
    for key in ("", "p"):
        if key:
            page.keyboard.press(key)
        for ratio in range(-3, 4):
            page.evaluate("ratio => oscillations.page.send({type: 'set', values: {ratio}})", ratio)
            page.wait_for_function("ratio => oscillations.shown.settings.ratio.value === ratio", arg=ratio)
            passed(page)
            pill, *numbers = plot.first.evaluate(BOXES)
            seen.add(len(numbers))
            assert all(not lap(pill, number) for number in numbers), (key, ratio, pill, numbers)
            assert all(not lap(one, other) for one, other in pairwise(numbers)), (key, ratio, numbers)
    assert len(seen) > 1


def lap(one: list[float], other: list[float]) -> bool:
    return one[0] < other[1] - 1 and other[0] < one[1] - 1


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
