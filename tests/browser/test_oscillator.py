"""The scenes oscillator and energy in Chromium: shared lines, a slider, gravity, the datum, the link."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.browser.boxes import BROKEN
from tests.browser.waiting import seek

pytestmark = pytest.mark.browser
Open = Callable[..., Page]

FITS = "document.documentElement.scrollWidth <= innerWidth && document.documentElement.scrollHeight <= innerHeight"


def level(page: Page, selector: str, way: str) -> float:
    """The position of the middle or an edge of an element, from the top of the window."""
    return float(page.evaluate(f"(b => {way})(document.querySelector('{selector}').getBoundingClientRect())"))


def dot(page: Page, plot: str, tint: str) -> float:
    """The height of the dot on a curve."""
    find = f"oscillations.plots.find(p => p.block.name === '{plot}').dots.find(d => d.curve.tint === '{tint}').dot"
    return float(page.evaluate(f"(b => b.top + b.height / 2)({find}.getBoundingClientRect())"))


def test_mass_and_curve_are_on_one_level(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="oscillator", view="formulas")
    expect(page.locator("h1")).to_have_text("A swing is a turning arrow, seen from the side")
    for t in (0.2, 0.685, 1.4):
        seek(page, t)
        assert level(page, "svg.stage rect.mass", "b.top + b.height / 2") == pytest.approx(dot(page, "x", "m1"), abs=1)
        assert dot(page, "v", "T") == pytest.approx(dot(page, "plane", "ink"), abs=1)
        assert dot(page, "a", "F") == pytest.approx(dot(page, "law", "ink"), abs=1)
    assert page.evaluate(BROKEN) == 0
    assert page.evaluate(FITS)


def test_the_bar_of_t_on_v_and_the_curve_of_v_are_level(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="energy", view="energy")
    for t in (0.3, 1.09):
        seek(page, t)
        V, T = (level(page, f"svg.stage .{tint} > .body", "b.top") for tint in ("V", "T"))
        bottom = level(page, "svg.stage .T > .body", "b.bottom")
        assert [V, bottom] == pytest.approx([dot(page, "energy", "V")] * 2, abs=1)
        assert pytest.approx(dot(page, "energy", "total"), abs=1) == T
    assert page.evaluate(BROKEN) == 0
    assert page.evaluate(FITS)


FOCUS = """() => (e => e === document.body ? null : (e.getAttribute('aria-label') || e.textContent).trim())
  (document.activeElement)"""


def test_the_tab_key_stops_only_where_keys_do_something_and_each_stop_has_its_own_name(
    new_page: Callable[..., Page], open_scene: Open
) -> None:
    page = open_scene(new_page(reduced_motion="reduce"), scene="energy")
    assert page.evaluate("oscillations.clock.playing") is False
    stops = []
    for _ in range(60):
        page.keyboard.press("Tab")
        name = page.evaluate(FOCUS)
        if name is None:
            break
        stops.append(name)
    plots = page.evaluate("oscillations.plots.map(p => p.block.title)")
    assert not set(plots) & set(stops)
    paper = stops[stops.index("Light or dark") + 1 : stops.index("Restart")]
    assert (
        len(set(paper)) == len(paper)
        and "Kinetic energy: T" in paper
        and any(name.startswith("Time,") for name in paper)
    )
    assert stops.index("Pictures") == len(stops) - 1


@pytest.mark.parametrize(
    ("scene", "view", "plot", "says"),
    [
        ("oscillator", "speed", "v", r"^v −?\d[\d.]* m/s$"),
        ("energy", "well", "well", r"^V \d[\d.]* J$"),
        ("analogues", "large", "late", r"^longer by \d[\d.]* %$"),
        ("phugoid", "", "period", r"^τ \d[\d.]* s$"),
    ],
)
def test_the_numbers_at_the_pointer_have_their_unit(
    page: Page, open_scene: Open, scene: str, view: str, plot: str, says: str
) -> None:
    open_scene(page, scene=scene, **({"view": view} if view else {}))
    area = page.evaluate(
        f"(p => (b => [b.x + p.frame.left + 0.6 * p.frame.width, b.y + p.frame.top + 0.5 * p.frame.height])"
        f"(p.host.getBoundingClientRect()))(oscillations.plots.find(p => p.block.name === '{plot}'))"
    )
    page.mouse.move(*area)
    expect(page.locator(".reading:visible span").first).to_have_text(re.compile(says))
