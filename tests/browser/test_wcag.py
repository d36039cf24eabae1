"""Criteria of WCAG that no other test covers; docs/accessibility.md lists all of them."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from tests.browser.waiting import passed, turned

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
MOST_STOPS = 150
SPACING = """* { line-height: 1.5 !important; letter-spacing: 0.12em !important; word-spacing: 0.16em !important }
p { margin-bottom: 2em !important }"""
CUT = """() => [...document.querySelectorAll("h1, h2, p, label, button, a, summary, td, .chip")].filter(one => {
  const {overflowX, overflowY} = getComputedStyle(one)
  const wide = overflowX !== "visible" && one.scrollWidth > one.clientWidth + 1
  const high = overflowY !== "visible" && one.scrollHeight > one.clientHeight + 1
  return one.checkVisibility() && !one.closest(".heard") && (wide || high)
}).map(one => one.outerHTML.slice(0, 120))"""
SEEN = """() => {
  const one = document.activeElement
  for (let at = one; at && at !== document.body; at = at.parentElement) {
    const {outlineStyle, outlineWidth} = getComputedStyle(at)
    if (outlineStyle !== "none" && parseFloat(outlineWidth) >= 2) return true
  }
  return one === document.body || one.matches("input[type=range]") || one.outerHTML.slice(0, 120)
}"""


NAVIGATION = "[...document.querySelectorAll('.nav a, .nav button')].map(one => one.textContent || one.ariaLabel)"


def test_each_page_has_a_title_of_its_own_its_language_and_the_navigation_of_all(page: Page, open_scene: Open) -> None:
    found = set()
    open_scene(page, scene="oscillator")
    for slug, scene in SCENES.items():
        turned(page, slug, {})
        expect(page).to_have_title(f"{scene.headline} – Oscillations")
        assert page.evaluate("document.documentElement.lang") == "en"
        expect(page.get_by_role("button", name="Keys")).to_be_visible()
        found.add(tuple(page.evaluate(NAVIGATION)))
    assert len(found) == 1


@pytest.mark.parametrize(("width", "height"), [(1280, 720), (390, 844)])
def test_wider_text_loses_nothing(new_page: Callable[..., Page], open_scene: Open, width: int, height: int) -> None:
    page = open_scene(new_page(width, height, reduced_motion="reduce"), scene="coupled")
    before = page.evaluate(CUT)
    page.add_style_tag(content=SPACING)
    passed(page, 10)
    assert page.evaluate("document.documentElement.scrollWidth - innerWidth") <= 0
    assert [one for one in page.evaluate(CUT) if one not in before] == []


def test_the_focus_goes_round_is_seen_everywhere_and_changes_nothing(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    page.keyboard.press("Space")
    first, unseen = page.get_by_role("link", name="Skip to the picture"), []
    page.keyboard.press("Tab")
    state = page.evaluate("JSON.stringify(oscillations.shown.state)")
    for _ in range(MOST_STOPS):
        if (seen := page.evaluate(SEEN)) is not True:
            unseen.append(seen)
        page.keyboard.press("Tab")
        if first.evaluate("one => one === document.activeElement"):
            break
    else:
        pytest.fail("the Tab key does not come back")
    assert unseen == []
    assert page.evaluate("JSON.stringify(oscillations.shown.state)") == state
