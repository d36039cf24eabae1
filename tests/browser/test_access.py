"""For those who use no mouse: where the Tab key leads."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

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
    expect(page.get_by_role("button", name="Both")).to_be_focused()


SHOWN = "one => (s => [s.backgroundColor, s.borderBottomColor, s.outlineStyle])(getComputedStyle(one))"


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_forced_colours_tell_apart_what_is_pressed_and_where_one_is(
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
