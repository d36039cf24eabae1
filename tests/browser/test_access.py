"""Keyboard access: where the Tab key leads."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from tests.grids import spread

pytestmark = pytest.mark.browser
Open = Callable[..., Page]


def test_skip_links_lead_to_the_picture_and_to_the_controls(page: Page, open_scene: Open) -> None:
    open_scene(page, folded=True, scene="coupled")
    page.keyboard.press("Tab")
    expect(page.get_by_role("link", name="Skip to the picture")).to_be_focused()
    page.keyboard.press("Tab")
    link = page.get_by_role("link", name="Skip to the controls")
    expect(link).to_be_focused()
    expect(link).to_be_in_viewport()
    page.keyboard.press("Enter")
    expect(page.get_by_role("complementary", name="Controls")).to_be_focused()
    page.keyboard.press("Tab")
    expect(page.locator("input[name=x1_0-slider]")).to_be_focused()


SHOWN = "one => (s => [s.backgroundColor, s.borderBottomColor, s.outlineStyle])(getComputedStyle(one))"


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_forced_colours_distinguish_pressed_buttons_and_the_current_page(
    scheme: str, new_page: Callable[..., Page], open_scene: Open
) -> None:
    page = open_scene(new_page(forced_colors="active", color_scheme=scheme), scene="coupled")
    for pressed, other in (
        (".chip[aria-pressed=true]", ".chip[aria-pressed=false]"),
        (".group .seg [aria-pressed=true]", ".group .seg [aria-pressed=false]"),
        (".nav nav [aria-current=page]", ".nav nav a:not([aria-current])"),
    ):
        one, another = (page.locator(selector).first.evaluate(SHOWN) for selector in (pressed, other))
        assert one != another, pressed
    adjusted = "one => getComputedStyle(one).forcedColorAdjust"
    assert page.locator("input[type=range]").first.evaluate(adjusted) == "none", "its track has its colours"


NAMES = """() => [...document.querySelectorAll("button, [role=slider], input")]
  .filter(one => one.checkVisibility() && !one.closest(".seg"))
  .map(one => `${one.localName} ${one.type ?? ""} ${one.getAttribute("aria-label") ?? one.textContent.trim()}`)"""


@pytest.mark.parametrize("slug", spread([*SCENES]))
def test_no_two_things_to_press_have_one_name(slug: str, page: Page, open_scene: Open) -> None:
    """Except the words of a choice, which its group names."""
    open_scene(page, scene=slug)
    page.evaluate("oscillations.change(() => ({covered: oscillations.plots.map(p => `plot:${p.block.name}`)}))")
    page.wait_for_function("oscillations.shown.state.covered.length === oscillations.plots.length")
    names = page.evaluate(NAMES)
    assert sorted(names) == sorted(set(names))


PARTS = """() => [".view-task", ".block.stage", ".transport", ".tabs", ".block.plot", ".keys-of-view", ".panel .chips"]
  .map(one => [...document.querySelectorAll(one)].find(host => host.checkVisibility()))
  .map(host => host.getBoundingClientRect().top)"""


@pytest.mark.parametrize("slug", ["forced", "coupled"])
def test_on_a_phone_the_key_control_is_between_plots_and_presets(
    slug: str, new_page: Callable[..., Page], open_scene: Open
) -> None:
    page = open_scene(new_page(390, 844, has_touch=True, is_mobile=True), scene=slug)
    tops = page.evaluate(PARTS)
    assert tops == sorted(tops)
