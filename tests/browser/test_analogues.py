"""The analogues in Chromium: pictures to choose from, the controls that follow, flags, the text of the speed."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from physics.analogues import ANALOGUES
from tests.browser.boxes import BROKEN
from tests.browser.waiting import seek

pytestmark = pytest.mark.browser
Open = Callable[..., Page]


def test_each_picture_chooses_its_system(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="analogues", folded=True)
    tiles = page.get_by_role("group", name="System").get_by_role("button")
    assert tiles.count() == 9
    for tile, (slug, system) in zip(tiles.all(), ANALOGUES.items(), strict=True):
        tile.click()
        expect(tile).to_have_attribute("aria-pressed", "true")
        page.locator("summary:visible", has_text=system.name).click()
        first = system.parameters[0].name
        expect(page.locator(f"input[name={slug}_{first}]")).to_be_visible()
        other = "pipe_L" if slug == "spring" else "spring_m"
        expect(page.locator(f"input[name={other}]")).to_be_hidden()
        assert page.evaluate(BROKEN) == 0
        overflow = "(p => p.scrollHeight - p.clientHeight)(document.querySelector('.panel'))"
        assert page.evaluate(overflow) <= 0, slug
    page.wait_for_url(re.compile("system=pipe"))


def test_speed_is_stated_and_the_drawings_move(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="analogues", view="motion", system="circuit")
    speed = page.locator("[data-value=speed]").first
    expect(speed).to_have_text("played 200\u202f000 times slower")
    page.get_by_role("button", name="Slower").click()
    page.get_by_role("button", name="Auto speed").click()
    expect(speed).to_have_text("played 200\u202f000 times slower")
    seek(page, 5)
    place = "document.querySelectorAll('.tile')[2].querySelector('circle').getAttribute('cx')"
    before = page.evaluate(place)
    seek(page, 12)
    assert page.evaluate(place) != before
