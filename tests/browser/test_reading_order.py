"""Screen readers and the Tab key meet the parts of a page from top to bottom, whatever its layout."""

from __future__ import annotations

from collections.abc import Callable
from typing import cast

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from tests.browser.fixtures import READY
from tests.browser.waiting import passed, turned
from tests.grids import spread
from tests.serving.server import Server

pytestmark = pytest.mark.browser
SIZES = ((390, 844), (320, 568), (844, 390), (1024, 768), (1280, 720))
INVERTED = r"""() => {
  const texts = "p, h1, h2, table, .item, .note, summary, label"
  const stops = "a[href], button, input, select, [tabindex]"
  const isSeen = part => part.checkVisibility({visibilityProperty: true, opacityProperty: true}) &&
    !part.closest(".heard, .skip, .foot") // the foot of a card stays at the bottom of the screen
  const pictures = ".plot-area, .block.stage" // what is over a picture has no order from top to bottom
  const parts = [...document.querySelectorAll(`.page :is(${texts}, ${stops}, ${pictures})`)]
    .filter(part => isSeen(part) && !part.parentElement.closest(`${pictures}, ${texts}, button`))
  const range = document.createRange()
  const boxed = part => {
    range.selectNodeContents(part)
    let {left, right, top, bottom} = (part.matches(texts) ? range : part).getBoundingClientRect()
    for (let holder = part; holder !== document.body; holder = holder.parentElement) {
      if (getComputedStyle(holder).overflowX === "visible") continue
      const frame = holder.getBoundingClientRect() // what is scrolled out of it is not seen
      ;[left, right] = [Math.max(left, frame.left), Math.min(right, frame.right)]
    }
    return {part, left, right, top, bottom, name: part.ariaLabel || part.textContent.trim() || part.className}
  }
  const boxes = parts.map(boxed).filter(({left, right, top, bottom}) => right - left > 1 && bottom - top > 1)
  const isBefore = (one, other) => {
    if (one.part.closest(".control") && one.part.closest(".control") === other.part.closest(".control")) return false
    const across = Math.min(one.right, other.right) - Math.max(one.left, other.left)
    const along = Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top)
    const least = Math.min(one.bottom - one.top, other.bottom - other.top)
    return (one.bottom <= other.top + 3 && across > 3) || (along > least / 2 && one.right <= other.left + 3)
  }
  return boxes.flatMap((one, i) => boxes.slice(i + 1).filter(later => isBefore(later, one))
    .map(later => `“${later.name.slice(0, 40)}” comes after “${one.name.slice(0, 40)}”`))
}"""
"""Parts of which one is above the other, or left of it in the same line, but later in the document."""


def inverted(page: Page, width: int, height: int) -> list[str]:
    """The parts in the wrong order in a window of this size."""
    page.set_viewport_size({"width": width, "height": height})
    passed(page)
    return [f"{width} x {height}: {fault}" for fault in cast(list[str], page.evaluate(INVERTED))]


@pytest.mark.parametrize("slug", spread([*SCENES]))
def test_parts_follow_one_another_as_they_are_seen(slug: str, turning: Page) -> None:
    found = []
    for view in SCENES[slug].views:
        turned(turning, slug, {"view": view.slug})
        for size in SIZES:
            found += [f"{view.name}, {fault}" for fault in inverted(turning, *size)]
    assert turning.locator("[tabindex]:not([tabindex='0'], [tabindex='-1'])").count() == 0
    assert not found, "\n".join(found)


def test_turning_a_phone_keeps_the_focus(new_page: Callable[..., Page], open_scene: Callable[..., Page]) -> None:
    page = open_scene(new_page(390, 844), scene="forced", view="response")
    slider = page.locator("input[name=omega-slider]")
    for size in ((844, 390), (1280, 720), (390, 844)):
        slider.focus()
        page.set_viewport_size({"width": size[0], "height": size[1]})
        passed(page)
        expect(slider).to_be_focused()
        assert inverted(page, *size) == []


@pytest.mark.parametrize("step", ["tour/tour-03", "d34/d34-05", "d34/d34-16"])
def test_a_step_is_read_as_it_is_seen_before_and_after_its_answer(
    step: str, new_page: Callable[..., Page], server: Server
) -> None:
    walk, name = step.split("/")
    page = new_page(390, 844)
    page.goto(f"{server.url}?walk={walk}&step={name}")
    page.wait_for_function(f"{READY} && document.querySelector('.asked .card')")
    assert inverted(page, 390, 844) == []
    page.evaluate("oscillations.walks.walk.show(true)")
    page.wait_for_function("oscillations.walks.walk.lesson && !document.querySelector('.asked')")
    assert inverted(page, 390, 844) == []
