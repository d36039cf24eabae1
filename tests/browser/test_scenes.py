"""Single scenes: parts that are level with one another, pictures to choose from, units, a queue."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from physics.analogues import ANALOGUES
from tests.browser.waiting import redrawn, seek, turned, type_in, unfold

pytestmark = pytest.mark.browser
Open = Callable[..., Page]


def level(page: Page, selector: str, way: str) -> float:
    """The position of the middle or an edge of an element, from the top of the window."""
    return float(page.evaluate(f"(b => {way})(document.querySelector('{selector}').getBoundingClientRect())"))


def dot(page: Page, plot: str, tint: str) -> float:
    """The height of the dot on a curve."""
    find = f"oscillations.plots.find(p => p.block.name === '{plot}').dots.find(d => d.curve.tint === '{tint}').dot"
    return float(page.evaluate(f"(b => b.top + b.height / 2)({find}.getBoundingClientRect())"))


def test_masses_and_bars_are_level_with_their_curves(desk: Page) -> None:
    turned(desk, "oscillator", {"view": "formulas", "x_0": 0.15, "v_0": 0.0})
    for t in (0.2, 0.685, 1.4):
        seek(desk, t)
        assert level(desk, "svg.stage rect.mass", "b.top + b.height / 2") == pytest.approx(dot(desk, "x", "m1"), abs=1)
        assert dot(desk, "v", "T") == pytest.approx(dot(desk, "plane", "ink"), abs=1)
        assert dot(desk, "a", "F") == pytest.approx(dot(desk, "law", "ink"), abs=1)
    turned(desk, "energy", {"view": "energy"})
    for t in (0.3, 1.09):
        seek(desk, t)
        V, T = (level(desk, f"svg.stage .{tint} > .body", "b.top") for tint in ("V", "T"))
        bottom = level(desk, "svg.stage .T > .body", "b.bottom")
        assert [V, bottom] == pytest.approx([dot(desk, "energy", "V")] * 2, abs=1)
        assert pytest.approx(dot(desk, "energy", "total"), abs=1) == T


def test_each_picture_chooses_its_system_and_moves(desk: Page) -> None:
    turned(desk, "analogues", {"view": "roles"})
    tiles = desk.get_by_role("group", name="System").get_by_role("button")
    for tile, (slug, system) in zip(tiles.all(), ANALOGUES.items(), strict=True):
        tile.click()
        expect(tile).to_have_attribute("aria-pressed", "true")
        desk.locator("summary:visible", has_text=system.name).click()
        first, other = system.parameters[0].name, "pipe_L" if slug == "spring" else "spring_m"
        expect(desk.locator(f"input[name={slug}_{first}]")).to_be_visible()
        expect(desk.locator(f"input[name={other}]")).to_be_hidden()
        assert desk.evaluate("(p => p.scrollHeight - p.clientHeight)(document.querySelector('.panel'))") <= 0, slug
    desk.wait_for_url(re.compile("system=pipe"))
    turned(desk, "analogues", {"view": "motion", "system": "circuit"})
    speed = desk.locator("[data-value=speed]").first
    expect(speed).to_have_text("played 200\u202f000 times slower")
    desk.get_by_role("button", name="Slower").click()
    expect(speed).not_to_have_text("played 200\u202f000 times slower")
    desk.get_by_role("button", name="Auto speed").click()
    expect(speed).to_have_text("played 200\u202f000 times slower")
    place, places = "document.querySelectorAll('.tile')[2].querySelector('circle').getAttribute('cx')", set()
    for t in (5, 12):
        seek(desk, t)
        places.add(desk.evaluate(place))
    assert len(places) == 2


def test_another_unit_changes_labels_and_not_the_drawing_and_pictures_are_presets(desk: Page) -> None:
    outlines = """[...document.querySelectorAll('svg.stage > g')].filter(g => !g.querySelector('text'))
      .map(g => g.innerHTML.replaceAll(' style=""', '').replace(/-?\\d+(\\.\\d+)?/g, number => Math.round(number)))"""
    turned(desk, "phugoid", {})
    unfold(desk)
    seek(desk, 7)
    field, before = desk.locator("input[name=v_0]"), desk.evaluate(outlines)
    assert field.input_value() == "150"
    desk.get_by_role("button", name="knots").click()
    expect(field).to_have_value("88.87")
    expect(desk.get_by_label("v0, speed of steady flight, knots").first).to_be_visible()
    redrawn(desk)
    assert desk.evaluate(outlines) == before
    type_in(desk, "v_0", "200")
    expect(desk.locator("[data-value=tau]").first).to_have_text("46.6")
    type_in(desk, "v_0", "-5")
    expect(desk.locator("#problem-v_0")).to_contain_text("−5 knots is not possible")

    turned(desk, "phugoid", {"view": "period"})
    loop = desk.get_by_role("button", name="Loop, 1")
    expect(loop.locator("svg path")).to_be_visible()
    loop.click()
    expect(loop).to_have_attribute("aria-pressed", "true")
    expect(desk.locator("[data-value=verdict]").first).to_contain_text("loops")
    desk.wait_for_url(re.compile("excess=1"))
    desk.get_by_role("button", name="Speed of: Glider").click()  # a flag of the plot
    expect(desk.get_by_role("button", name="Glider", exact=True)).to_have_attribute("aria-pressed", "true")
    assert desk.evaluate("oscillations.shown.settings.v_0.value") == pytest.approx(90 * 0.3048)


def test_a_measurement_is_run_skips_a_method_and_is_cancelled(desk: Page) -> None:
    turned(desk, "accuracy", {"limit": 3, "system": "wide"})
    desk.get_by_role("button", name="Run", exact=True).click()
    stepping = re.compile("(Verlet|Newmark|RK4|DOP853|Radau|LSODA) is running")  # the others come first and are quick
    expect(desk.locator(".transport [role=status]")).to_contain_text(stepping, timeout=60_000)
    expect(desk.locator(".count")).to_contain_text("of 60 s")
    desk.get_by_role("button", name="Skip this method").click()
    desk.get_by_role("button", name="Cancel").click()
    expect(desk.locator(".count")).to_contain_text("methods measured here")
    expect(desk.get_by_role("button", name="Run again")).to_be_visible()
