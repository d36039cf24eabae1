"""A printed scene is one sheet: its pictures in ink, with parameters and link."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from tests.grids import spread

pytestmark = pytest.mark.browser


@pytest.mark.parametrize("slug", spread([*SCENES]))
def test_a_scene_is_one_sheet_in_ink(new_page: Callable[..., Page], open_scene: Callable[..., Page], slug: str) -> None:
    page = open_scene(new_page(color_scheme="dark", reduced_motion="reduce"), scene=slug)
    page.wait_for_function("oscillations.page.print")
    for landscape in (False, True):
        sheets = re.findall(rb"/Count (\d+)", page.pdf(format="A4", landscape=landscape))
        assert sheets == [b"1"], landscape
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    sheet = page.locator(".printed")
    expect(sheet.locator("h1")).to_have_text(SCENES[slug].headline)
    expect(sheet.locator(".printed-pictures > div").first).to_be_visible()
    expect(sheet).to_contain_text(page.url)
    expect(sheet).to_have_css("background-color", "rgb(255, 255, 255)")
    expect(page.locator(".nav")).to_be_hidden()
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    expect(sheet).to_have_count(0)


def test_a_phone_prints_the_pictures_of_a_desk(new_page: Callable[..., Page], open_scene: Callable[..., Page]) -> None:
    """The path of an aircraft is printed with it, once. An upright sheet has one column for a few pictures."""
    for width, height in ((390, 844), (1280, 720)):
        page = open_scene(new_page(width, height), scene="phugoid", view="height")
        page.wait_for_function("oscillations.page.print && oscillations.plots.filter(({box}) => box).length === 3")
        page.evaluate("dispatchEvent(new Event('beforeprint'))")
        page.emulate_media(media="print")
        pictures = page.locator(".printed-pictures > div")
        assert pictures.count() == 3, width
        share = pictures.last.evaluate("one => one.clientWidth / one.closest('.printed').clientWidth")
        assert share == pytest.approx(1 if height > width else 0.5, abs=0.01)
        page.evaluate("dispatchEvent(new Event('afterprint'))")


def test_points_over_a_plot_are_printed_with_it(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="phugoid", view="period")
    page.wait_for_function("oscillations.page.print && oscillations.plots.filter(({box}) => box).length === 2")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    pictures = page.locator(".printed-pictures > div")
    assert pictures.filter(has_text="period τ").count() == pictures.filter(has_text="Airliner").count() == 1
    assert pictures.count() == 1
    page.evaluate("dispatchEvent(new Event('afterprint'))")


def test_the_absorber_s_sheet_says_its_machine_and_has_each_plot_once_and_wide(
    page: Page, open_scene: Callable[..., Page]
) -> None:
    open_scene(page, scene="absorber", view="stroke")
    page.wait_for_function("oscillations.page.print && oscillations.plots.filter(({box}) => box).length === 2")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    sheet = page.locator(".printed")
    for told in ("m₁ = 100 kg", "k₁ = 250 kN/m", "F₀ = 500 N", "ω = 48.0 rad/s", "m₂ = 16.0 kg"):
        expect(sheet.locator("> p").first).to_contain_text(told)
    resonances = sheet.locator(".printed-pictures text").filter(has_text="fast ")
    expect(resonances).to_have_count(1)
    share = "one => one.closest('div').clientWidth / one.closest('.printed').clientWidth"
    assert resonances.evaluate(share) == pytest.approx(1, abs=0.01)
    page.evaluate("dispatchEvent(new Event('afterprint'))")
