"""Texts for screen readers: the contents of a plot and the effect of a change, checked against the drawing."""

from __future__ import annotations

import math
import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from tests.browser.waiting import turned

pytestmark = pytest.mark.browser

Open = Callable[..., Page]
HEARD = ".page > [role=status]"
SAYS = "document.getElementById('says-x').textContent"


def described(page: Page, name: str) -> str:
    """Return the description of a plot, once it has one."""
    page.wait_for_function('name => document.getElementById(`says-${name}`)?.textContent !== ""', arg=name)
    return str(page.evaluate("name => document.getElementById(`says-${name}`).textContent", name))


def changed(page: Page, **values: float) -> None:
    page.evaluate("values => oscillations.send({type: 'set', values})", values)


def test_a_change_is_announced_in_one_sentence_of_the_scenes_values(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    described(page, "x1")
    heard = page.locator(HEARD)
    expect(heard).to_have_text("")
    before, now = SCENES["coupled"]().shown.values, SCENES["coupled"](k2=3.0).shown.values
    changed(page, k2=3)
    told = [
        f"{name} {now[key]} {unit}, was {before[key]} {unit}"
        for name, key, unit in (
            ("Slow mode", "omega_minus", "rad/s"),
            ("fast mode", "omega_plus", "rad/s"),
            ("energy", "E_total", "J"),
        )
    ]
    expect(heard).to_have_text("; ".join(told) + ".")
    changed(page, v1_0=1)
    expect(heard).to_have_text(re.compile(r"^Energy [\d.]+ J, was [\d.]+ J; unchanged: slow mode, fast mode\.$"))
    state = "{...oscillations.shown.state, covered: ['value:omega_minus', 'plot:x2']}"
    page.evaluate(f"oscillations.send({{type: 'open', state: {state}}})")
    changed(page, k1=9)
    expect(heard).to_have_text(re.compile("^Fast mode .*"))
    assert "slow" not in (heard.text_content() or "").lower(), "a hidden number is announced"
    assert described(page, "x2").endswith("Covered until you press Reveal.")
    open_scene(page, walk="d31", step="d31-04")
    assert described(page, "x").endswith("Covered until you press Show the answer.")


def test_the_lags_are_described_with_their_plots_and_announced_after_a_change(page: Page, open_scene: Open) -> None:
    forced: dict[str, float] = {"c1": 0.1, "c2": 0.1}
    texts = [SCENES["forced"](**forced, omega=omega, view="nyquist").shown.values for omega in (0.8, 0.7)]
    lags = [f"ass 1 {one['phase1']}; mass 2 {one['phase2']}" for one in texts]
    assert lags[0] != lags[1] and "°" in lags[0]
    open_scene(page, scene="forced", view="bode", omega=0.8, **forced)
    assert f"M{lags[0]}. Horizontal" in described(page, "lag")
    changed(page, omega=0.7)
    heard = "; ".join(f"mass {i} {texts[1][f'phase{i}']}, was {texts[0][f'phase{i}']}" for i in (1, 2))
    expect(page.locator(HEARD)).to_contain_text(heard)
    open_scene(page, scene="forced", view="nyquist", omega=0.7, **forced)
    assert f"M{lags[1]}; work of a cycle {texts[1]['work']} J. Horizontal" in described(page, "nyquist")


def test_a_turning_point_is_described_where_the_motion_turns(page: Page, open_scene: Open) -> None:
    """Not at the nearest drawn point. The figure has the description as its own."""
    open_scene(page, scene="oscillator")
    scene = SCENES["oscillator"]()
    omega_n = math.sqrt(scene.k / scene.m)
    lowest = (math.pi + math.atan2(scene.v_0 / omega_n, scene.x_0)) / omega_n
    depth = math.hypot(scene.x_0, scene.v_0 / omega_n)
    assert f"lowest −{depth:.3g} m at {lowest:.3g} s, highest" in described(page, "x")
    figure = page.get_by_role("img", name="Displacement against time")
    told = re.compile(r"^Displacement against time\. Horizontal axis 0 s to 2 s")
    expect(figure).to_have_accessible_description(told)


def test_a_slow_push_is_heard_as_a_line_and_a_quick_one_stays_in_its_frame(desk: Page) -> None:
    turned(desk, "driven", {"view": "motion", "omega": 0.2})
    slow = described(desk, "x")
    assert "x: from " in slow and "highest 0.0507 m" in slow
    told = re.findall(r"x: up to (\S+) s too fast .* between (\S+) m and (\S+) m", slow.replace("−", "-"))
    seconds, low, high = map(float, told[0])
    assert 1 < seconds < 5 and -0.01 < low < 0 < high < 0.05
    turned(desk, "driven", {"view": "motion", "omega": 1e6})
    desk.wait_for_function(f"heard => ({SAYS}) !== heard", arg=slow)
    assert not re.search("too fast|outside the frame", desk.evaluate(SAYS))
