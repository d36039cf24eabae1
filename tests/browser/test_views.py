"""The tabs of a scene, and the first screen of each view."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from components.layout.views import View
from components.scenes import SCENES
from tests.browser.boxes import faults
from tests.browser.waiting import passed, redrawn, seek

pytestmark = pytest.mark.browser
VIEWS = [pytest.param(slug, view, id=f"{slug}-{view.slug}") for slug, scene in SCENES.items() for view in scene.views]
SCREENS = ((390, 844), (320, 568), (844, 390), (853, 480), (1250, 590), (1280, 720), (1920, 1080))
IN_VIEWS = [slug for slug, scene in SCENES.items() if scene.views]
BOTTOMS = """parts => {
  const found = [...oscillations.page.sheet.hosts].filter(([block]) => parts.includes(block.part))
  const keys = [...document.querySelectorAll(".keys-of-view:not([hidden]) > :not(h2, [hidden])")]
    .map(host => [{part: "keys"}, host])
  return [...found, ...keys].map(([{part}, host]) =>
    [part, Math.round(host.getBoundingClientRect().bottom + scrollY), host.checkVisibility()])
}"""
LINES = """(() => {
  const task = [...document.querySelectorAll(".view-task")].find(one => one.checkVisibility())
  const {lineHeight, paddingTop, paddingBottom} = getComputedStyle(task)
  return Math.round((task.clientHeight - parseFloat(paddingTop) - parseFloat(paddingBottom)) / parseFloat(lineHeight))
})()"""
HEADLINE = """(() => {
  const lines = document.createRange()
  lines.selectNodeContents(document.querySelector("h1"))
  return new Set([...lines.getClientRects()].map(({top}) => Math.round(top))).size
})()"""
SIDE_BY_SIDE = """(() => {
  const seen = kind => [...document.querySelectorAll(`.block.${kind}`)].filter(one => one.checkVisibility())
    .map(one => one.getBoundingClientRect()).sort((one, other) => one.top - other.top)[0]
  const [stage, plot] = [seen("plot.path") ?? seen("stage"), seen("plot:not(.path)")] // a path is a picture, too
  const {bottom} = document.querySelector(".transport").getBoundingClientRect() // of the picture with its clock
  return !stage || !plot || (stage.right <= plot.left + 1 && stage.top < plot.bottom && plot.top < bottom)
})()"""
CHOSEN = """() => [...document.querySelectorAll("[role=tab][aria-selected=true]")].map(tab => tab.textContent)"""
FOCUSED = "() => document.activeElement.textContent"


@pytest.mark.parametrize(("slug", "view"), VIEWS)
def test_a_phones_first_screen_has_all_that_the_task_names(
    slug: str, view: View, new_page: Callable[..., Page], open_scene: Callable[..., Page]
) -> None:
    page = open_scene(new_page(width=390, height=844), folded=True, scene=slug, view=view.slug)
    redrawn(page)
    names = list(view.names)
    bottoms = [one for one in page.evaluate(BOTTOMS, names) if one[0] in names]
    assert {one[0] for one in bottoms} == set(names)
    assert [one for one in bottoms if not (one[2] and one[1] <= 844)] == []
    assert page.evaluate(LINES) <= 3 and page.evaluate(HEADLINE) <= 2
    page.set_viewport_size({"width": 320, "height": 568})
    passed(page)
    assert [one for one in page.evaluate(BOTTOMS, names) if not (one[2] and one[1] <= 2 * 568)] == []
    page.set_viewport_size({"width": 844, "height": 390})
    passed(page)
    assert page.evaluate(SIDE_BY_SIDE)
    for play in page.locator(".transport .play:visible").all():
        expect(play).to_be_in_viewport(ratio=1)


@pytest.mark.slow
@pytest.mark.parametrize(("slug", "view"), VIEWS)
def test_nothing_overlaps_or_is_cut_in_any_view(
    slug: str, view: View, new_page: Callable[..., Page], open_scene: Callable[..., Page]
) -> None:
    page = open_scene(new_page(width=1280, height=720), scene=slug, view=view.slug)
    found = []
    for width, height in SCREENS:
        found += seen(page, width, height)
    page.evaluate("document.documentElement.style.fontSize = '200%'")
    found += [f"text of 200 %, {fault}" for fault in seen(page, 390, 844)]
    assert not found, "\n".join(found)


def seen(page: Page, width: int, height: int) -> list[str]:
    """The faults in a window of this size."""
    page.set_viewport_size({"width": width, "height": height})
    passed(page)
    seek(page, 0.0)
    return [f"{width} x {height}: {fault}" for fault in faults(page)]


@pytest.mark.parametrize("slug", IN_VIEWS)
def test_keys_choose_a_view_and_the_focus_goes_along(slug: str, page: Page, open_scene: Callable[..., Page]) -> None:
    names = [view.name for view in SCENES[slug].views]
    open_scene(page, scene=slug, view=SCENES[slug].views[0].slug)
    page.keyboard.press(";")
    page.wait_for_function(f"({CHOSEN})() == {names[1]!r}")
    page.keyboard.press(",")
    page.wait_for_function(f"({CHOSEN})() == {names[0]!r}")
    page.locator("[role=tab]").first.focus()
    page.keyboard.press("ArrowLeft")
    page.wait_for_function(f"({FOCUSED})() == {names[-1]!r}")
    page.keyboard.press("Home")
    page.wait_for_function(f"({FOCUSED})() == {names[0]!r}")
    controlled = page.locator("[role=tab]").first.get_attribute("aria-controls")
    assert page.locator(f"#{controlled}[role=tabpanel]").count() == 1
    page.get_by_role("button", name="Undo").click()
    page.wait_for_function(f"({CHOSEN})() == {names[-1]!r}")


def test_what_a_hand_has_set_stays_in_another_view(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="damped", view="motion")
    slider = page.locator("input[name=zeta-slider]")
    slider.focus()
    slider.press("ArrowRight")
    page.get_by_role("button", name="Hold").click()
    zeta = slider.input_value()
    page.get_by_role("tab", name="Roots").click()
    page.wait_for_function(f"({CHOSEN})() == 'Roots'")
    assert slider.input_value() == zeta
    assert page.evaluate("oscillations.page.shown.held !== null")
    assert "view=roots" in page.url
