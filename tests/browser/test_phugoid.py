"""The phugoid in Chromium: presets as pictures, other units, views, the clock, links."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.browser.boxes import BROKEN
from tests.browser.waiting import passed, redrawn, seek

pytestmark = pytest.mark.browser
Open = Callable[..., Page]

HEIGHTS = "[...oscillations.shown.view.columns.path.y]"
OUTLINES = """[...document.querySelectorAll('svg.stage > g')].filter(g => !g.querySelector('text'))
  .map(g => g.innerHTML.replaceAll(' style=""', '').replace(/-?\\d+(\\.\\d+)?/g, number => Math.round(number)))"""
PAUSE = "oscillations.clock.playing = false"


def drawn(page: Page) -> list[str]:
    """The outlines on the paper, which another unit must not change."""
    shapes: list[str] = page.evaluate(OUTLINES)
    return shapes


def test_presets_are_pictures_and_change_the_flight(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="phugoid", folded=True)
    page.evaluate(PAUSE)
    before = page.evaluate(HEIGHTS)
    loop = page.get_by_role("button", name="Loop, 1")
    expect(loop.locator("svg path")).to_be_visible()
    loop.click()
    expect(loop).to_have_attribute("aria-pressed", "true")
    expect(page.locator("[data-value=verdict]").first).to_contain_text("loops")
    assert page.evaluate(HEIGHTS) != before
    for view in ("Period", "Energy", "Limits"):
        page.get_by_role("tab", name=view, exact=True).click()
        page.wait_for_function(f"oscillations.shown.settings.view.value === {view.lower()!r}")
        assert page.evaluate(BROKEN) == 0
    page.wait_for_url(re.compile("excess=1.*view=limits"))
    for size in ("scrollHeight - p.clientHeight", "scrollWidth - p.clientWidth"):
        assert page.evaluate(f"(p => p.{size})(document.querySelector('.panel'))") <= 0


def test_another_unit_changes_labels_and_not_the_drawing(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="phugoid")
    seek(page, 7)
    field, before = page.locator("input[name=v_0]"), drawn(page)
    assert field.input_value() == "150"
    page.get_by_role("button", name="knots").click()
    expect(field).to_have_value("88.87")
    expect(page.get_by_label("v0, speed of steady flight, knots").first).to_be_visible()
    redrawn(page)
    assert drawn(page) == before
    field.fill("200")
    field.press("Enter")
    expect(page.locator("[data-value=tau]").first).to_have_text("46.6")
    field.fill("-5")
    field.press("Enter")
    expect(page.locator("#problem-v_0")).to_contain_text("−5 knots is not possible")


def test_a_flag_of_the_period_plot_is_the_button_of_its_aircraft(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="phugoid")
    page.get_by_role("button", name="Speed of: Glider").click()
    expect(page.get_by_role("button", name="Glider", exact=True)).to_have_attribute("aria-pressed", "true")
    assert page.evaluate("oscillations.shown.settings.v_0.value") == pytest.approx(90 * 0.3048)


def test_with_large_letters_the_name_of_the_dashed_path_is_not_behind_the_mass(
    new_page: Callable[..., Page], open_scene: Open
) -> None:
    page = open_scene(new_page(390, 844), scene="phugoid", view="height")
    page.evaluate("document.documentElement.style.fontSize = '200%'")
    passed(page)
    name = page.locator("svg text").filter(has_text="dashed: small swings")
    expect(name).to_be_visible()
    assert name.evaluate("""name => [...name.closest("svg").querySelectorAll(".mass, .spring")]
      .every(part => part.compareDocumentPosition(name) & Node.DOCUMENT_POSITION_FOLLOWING)""")
