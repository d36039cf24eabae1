"""Texts for screen readers: the contents of a plot and the effect of a change, checked against the drawing."""

from __future__ import annotations

import math
import re
from collections.abc import Callable

import numpy as np
import pytest
from playwright.sync_api import Page, expect

from components.quantities.formatting import short, three
from components.scenes import SCENES
from tests.browser.descriptions import described

pytestmark = pytest.mark.browser

Open = Callable[..., Page]


def test_a_change_is_announced_in_one_sentence_of_the_scenes_values(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    described(page, "x1")
    heard = page.locator(".page > [role=status]")
    expect(heard).to_have_text("")
    before, now = SCENES["coupled"]().shown.values, SCENES["coupled"](k2=3.0).shown.values
    page.evaluate("oscillations.send({type: 'set', values: {k2: 3}})")
    told = [
        f"Slow mode {now['omega_minus']} rad/s, was {before['omega_minus']} rad/s",
        f"fast mode {now['omega_plus']} rad/s, was {before['omega_plus']} rad/s",
        f"energy {now['E_total']} J, was {before['E_total']} J.",
    ]
    expect(heard).to_have_text("; ".join(told))
    page.evaluate("oscillations.send({type: 'set', values: {v1_0: 1}})")
    expect(heard).to_have_text(re.compile(r"^Energy [\d.]+ J, was [\d.]+ J; unchanged: slow mode, fast mode\.$"))


def test_the_lags_are_described_with_their_plots_and_announced_after_a_change(page: Page, open_scene: Open) -> None:
    forced: dict[str, float] = {"c1": 0.1, "c2": 0.1}
    texts = [SCENES["forced"](**forced, omega=omega, view="nyquist").shown.values for omega in (0.8, 0.7)]
    lags = [f"ass 1 {one['phase1']}; mass 2 {one['phase2']}" for one in texts]
    assert lags[0] != lags[1] and "°" in lags[0]
    open_scene(page, scene="forced", view="bode", omega=0.8, **forced)
    assert f"M{lags[0]}. Horizontal" in described(page, "lag")
    page.evaluate("oscillations.send({type: 'set', values: {omega: 0.7}})")
    heard = "; ".join(f"mass {i} {texts[1][f'phase{i}']}, was {texts[0][f'phase{i}']}" for i in (1, 2))
    expect(page.locator(".page > [role=status]")).to_contain_text(heard)
    open_scene(page, scene="forced", view="nyquist", omega=0.7, **forced)
    assert f"M{lags[1]}; work of a cycle {texts[1]['work']} J. Horizontal" in described(page, "nyquist")


def test_a_hidden_number_is_not_announced(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    described(page, "x1")
    state = "{...oscillations.shown.state, covered: ['value:omega_minus', 'plot:x2']}"
    page.evaluate(f"oscillations.send({{type: 'open', state: {state}}})")
    page.evaluate("oscillations.send({type: 'set', values: {k1: 9}})")
    expect(page.locator(".page > [role=status]")).to_have_text(re.compile("^Fast mode .*"))
    assert "slow" not in (page.locator(".page > [role=status]").text_content() or "").lower()
    assert described(page, "x2").endswith("Covered until you press Reveal.")
    open_scene(page, walk="d31", step="d31-04")
    assert described(page, "x").endswith("Covered until you press Show the answer.")


def test_a_turning_point_is_described_where_the_motion_turns(page: Page, open_scene: Open) -> None:
    """Not at the nearest drawn point."""
    open_scene(page, scene="oscillator")
    scene = SCENES["oscillator"]()
    omega_n = math.sqrt(scene.k / scene.m)
    lowest = (math.pi + math.atan2(scene.v_0 / omega_n, scene.x_0)) / omega_n
    found = re.search(r"lowest (\S+) m at (\S+) s, highest", described(page, "x"))
    assert found
    assert [float(part.replace("−", "-")) for part in found.groups()] == [
        float(f"{-math.hypot(scene.x_0, scene.v_0 / omega_n):.3g}"),
        float(f"{lowest:.3g}"),
    ]


@pytest.mark.parametrize("k2", [2.0, 7.0])
def test_a_plot_is_described_by_its_own_numbers(page: Page, open_scene: Open, k2: float) -> None:
    open_scene(page, scene="coupled", k2=k2)
    scene = SCENES["coupled"](k2=k2)
    time = scene.sources["time"].data
    text = described(page, "x1")
    x = time["x1"]
    found = re.search(r"x1: from (\S+) m to (\S+) m, lowest (\S+) m at (\S+) s, highest (\S+) m at (\S+) s\.", text)
    assert found, text
    numbers = [float(part.replace("−", "-")) for part in found.groups()]
    true = [x[0], x[-1], x.min(), x.max()]
    assert np.allclose([*numbers[:3], numbers[4]], true, rtol=5e-3, atol=2e-3), (text, true)
    assert np.allclose(np.interp([numbers[3], numbers[5]], time["t"], x), [x.min(), x.max()], atol=0.02), text
    assert f"Horizontal axis 0 s to {short(scene.shown.axes['t'].end)} s" in text
    open_scene(page, scene="coupled", view="energy", k2=k2)
    T2 = time["T1_V1_V2_T2"] - time["T1_V1_V2"]
    assert f"T2: between 0 J and {three(float(np.ptp(np.maximum(T2, 0.0))))[:3]}" in described(page, "energy")


def test_what_leaves_the_frame_is_said_to(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="absorber", view="stroke")
    assert "highest outside the frame" in described(page, "stroke")


def test_the_figure_has_the_description_as_its_own(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="oscillator")
    described(page, "x")
    figures = page.get_by_role("img", name="Displacement against time")
    told = re.compile(r"^Displacement against time\. Horizontal axis 0 s to 2 s")
    expect(figures).to_have_accessible_description(told)
