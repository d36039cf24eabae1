"""The navigation: scenes by lecture; lectures without the current scene fold if there is no room."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from tests.browser.views import GRID

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
MOST = 13
"""Number of scenes that fit in the navigation at 1024 pixels."""
MORE = """count => {
  const last = [...document.querySelectorAll(".nav .scene-group")].at(-1), own = last.cloneNode(true)
  const links = [...Array(count)].map(() => last.querySelector("a").cloneNode(true))
  own.querySelector(".lecture").textContent = own.querySelector("button").textContent = "Beyond the slides"
  own.querySelector(".scenes").replaceChildren(...links)
  if (count) last.after(own)
}"""
"""Adds scenes in their own lecture."""
OFF_LINE = """() => {
  const range = document.createRange()
  range.selectNodeContents(document.querySelector(".scene-menu summary"))
  const [text, line] = [range, document.querySelector(".nav")].map(one => one.getBoundingClientRect())
  return Math.abs(text.top + text.bottom - line.top - line.bottom) / 2
}"""
RUN_TOGETHER = """() => {
  const stand = [...document.querySelectorAll(".nav > *, .nav nav :is(a, button, .lecture)")]
    .filter(one => one.checkVisibility() && !one.matches(".skip, nav") && one.getBoundingClientRect().width)
  const boxes = stand.map(one => [one.textContent.trim(), one.getBoundingClientRect()])
  return boxes.flatMap(([name, box], i) => [
    ...(box.right > innerWidth + 0.5 || box.left < -0.5 ? [`${name} leaves the screen`] : []),
    ...boxes.slice(i + 1)
      .filter(([, other]) => box.left < other.right - 0.5 && other.left < box.right - 0.5
        && box.top < other.bottom - 0.5 && other.top < box.bottom - 0.5)
      .map(([other]) => `${name} lies on ${other}`),
  ])
}"""


def titles(lecture: str) -> list[str]:
    return [scene.title for scene in SCENES.values() if scene.lecture == lecture]


def test_nothing_in_it_runs_into_anything_on_any_screen(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    found = []
    for width, height in GRID:
        page.set_viewport_size({"width": width, "height": height})
        found += [f"{width} x {height}: {fault}" for fault in page.evaluate(RUN_TOGETHER)]
    assert not found, "\n".join(found)


def test_it_has_room_for_thirteen_scenes(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    page.evaluate(MORE, max(0, MOST - len(SCENES)))
    assert page.locator(".nav .scenes a").count() == max(MOST, len(SCENES))
    for width in (1000, 1024, 1160, 1280, 1519, 1520, 1920):
        page.set_viewport_size({"width": width, "height": 800})
        assert page.evaluate(RUN_TOGETHER) == [], width


def test_a_folded_lecture_opens_by_mouse_and_keys(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    folded = page.locator(".nav .scene-group > button:visible")
    expect(page.locator(".nav .scenes a:visible")).to_have_text(
        [s.title for s in SCENES.values() if s.lecture == "D34"]
    )
    first = folded.first
    first.click()
    expect(first).to_have_attribute("aria-expanded", "true")
    page.locator(".panel").click(position={"x": 4, "y": 4})
    expect(first).to_have_attribute("aria-expanded", "false")
    first.focus()
    for key, title in (("ArrowDown", "Oscillator"), ("ArrowDown", "Energy"), ("ArrowUp", "Oscillator")):
        page.keyboard.press(key)
        expect(page.get_by_role("link", name=title)).to_be_focused()
    page.keyboard.press("Escape")
    expect(first).to_be_focused()
    expect(first).to_have_attribute("aria-expanded", "false")
    page.keyboard.press("Enter")
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    expect(page.get_by_role("heading", level=1)).to_have_text(SCENES["oscillator"].headline)
    expect(page.locator(".nav .scenes a:visible")).to_have_text(titles("D31"))


def test_on_a_narrow_screen_all_scenes_are_in_one_list(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    for width, height, to in ((820, 900, "energy"), (390, 844, "phugoid"), (320, 640, "energy")):
        page.set_viewport_size({"width": width, "height": height})
        assert page.evaluate(OFF_LINE) < 1, "the scene stands in the middle of its line"
        page.locator(".scene-menu summary").click()
        expect(page.locator(".nav .scenes a:visible")).to_have_text([scene.title for scene in SCENES.values()])
        expect(page.locator(".nav .scene-group > button:visible")).to_have_count(0)
        assert page.evaluate(RUN_TOGETHER) == [], width
        page.locator(f".nav .scenes a[data-scene={to}]").click()
        expect(page.get_by_role("heading", level=1)).to_have_text(SCENES[to].headline)
        expect(page.locator(".nav .scenes a:visible")).to_have_count(0)
