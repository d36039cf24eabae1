"""Bode and Nyquist of the driven chain: lags, peaks, and the work of a cycle as a depth."""

from __future__ import annotations

import math

import numpy as np
import pytest

from components.language.shapes import AnyShape
from components.scenes import SCENES
from components.state.page_state import fitted
from physics.bode import chain_resonances
from physics.bode_curves import locus_frequencies
from physics.damped_chain import DampedChain
from tests.page.hand import Hand, grabs
from tests.scenes.visible_sentences import Draw, visible_text

LIGHT = {"c1": 0.1, "c2": 0.1}
STRONG = {"c1": 1.0, "c2": 2.0}
UNEVEN = {"m1": 2.0, "k1": 4.0, "k2": 2.0, "c1": 0.2}
CHAINS = [LIGHT, UNEVEN, STRONG, {"k2": 0.0, "c1": 0.3}, {"c1": 4.0, "c2": 1e-9}]


def chain_of(values: dict[str, float]) -> DampedChain:
    equal = {"m1": 1.0, "m2": 1.0, "k1": 1.0, "k2": 1.0}
    return DampedChain(**{name: one for name, one in (equal | values).items() if name[0] in "mkc"})


def drawn(draw: Draw) -> dict[str, float]:
    names = ("m1", "m2", "k1", "k2", "c1", "c2")
    return {name: draw.size(-1, 1) if name[0] != "c" else draw.some(draw.size(-3, 1)) for name in names}


@pytest.mark.parametrize("values", CHAINS)
def test_the_dots_are_on_the_curves(values: dict[str, float]) -> None:
    scene = SCENES["forced"](**values, view="bode", omega=1.1)
    scalars, axes, lags = scene.shown.scalars, scene.shown.axes, scene.sources["lag"].data
    assert scalars["now"] == pytest.approx(math.log10(1.1))
    for i, lag in zip((1, 2), chain_of(values).lags(1.1), strict=True):
        assert np.all(lags[f"phi{i}"] >= 0) and np.all(lags[f"phi{i}"] <= (i + 1e-15) * math.pi)
        if f"phi{i}_at" in scalars:
            assert scalars[f"phi{i}_at"] == pytest.approx(math.degrees(lag))
            assert np.interp(1.1, lags["w"], lags[f"phi{i}"]) == pytest.approx(lag, abs=0.02)
    assert ("phi2_at" in scalars) == bool(values.get("k2", 1.0)), "no motion, no lag"
    plane = scene.sources["nyquist"].data
    near = np.argmin(np.hypot(plane["re1"] - scalars["re1_at"], plane["im1"] - scalars["im1_at"]))
    assert plane["omega"][near] == pytest.approx(1.1, rel=0.02) and axes["re"].unit == "m"


def test_the_push_never_takes_back_in_a_cycle_and_its_work_is_a_depth() -> None:
    draw = Draw("nyquist")
    for _ in range(25):
        values = drawn(draw)
        omega, F_0 = draw.size(-1, 1), draw.size(-1, 1)
        scene = SCENES["forced"](**values, view="nyquist", omega=omega, F_0=F_0)
        plane = scene.sources["nyquist"].data
        assert np.all(plane["im1"] <= 0)
        damped = chain_of(values)
        works = damped.works(omega, F_0)
        assert sum(works) == pytest.approx(-math.pi * F_0 * damped.response(omega, F_0)[0].imag, rel=1e-12)
        assert ("no work in a cycle" in visible_text(scene)) == (not any(works))


def test_peaks_widths_and_dips_are_marked_in_the_view_that_shows_them() -> None:
    scene, found = SCENES["forced"](**LIGHT, view="bode"), chain_resonances(chain_of(LIGHT))
    scalars, up = scene.shown.scalars, scene.shown.axes["X"]
    for i, one in zip((1, 2), (found.X1, found.X2), strict=True):
        for n, peak in enumerate(one.peaks):
            assert scalars[f"peak{i}_{n}"] == pytest.approx(math.log10(peak.omega))
            assert scalars[f"up{i}_{n}"] == pytest.approx(up.place(peak.height))
            low, high = peak.half_power
            assert (f"is_wide{i}_{n}" in scalars) == bool(low and high)
        assert scalars[f"dip{i}"] == pytest.approx(math.log10(one.dips[0].omega))
    assert "peaks at 0.617 (width 0.0383) and 1.62 (width 0.256) rad/s" in visible_text(scene)
    assert not any(name.startswith("peak") for name in SCENES["forced"](**LIGHT).shown.scalars)


def test_without_dashpots_the_lags_jump_and_a_mass_at_rest_has_none() -> None:
    scene = SCENES["forced"](view="bode", omega=1.0)
    assert set(np.round(scene.sources["lag"].data["phi1"] / math.pi, 12)) == {0.0, 1.0}
    assert set(np.round(scene.sources["lag"].data["phi2"] / math.pi, 12)) == {0.0, 1.0, 2.0}


def dot(i: int) -> AnyShape:
    """The grabbed dot of a mass in the complex plane."""
    return next(shape for shape, grab in grabs(SCENES["forced"]) if grab.label.endswith(f"loops of mass {i}"))


def place(values: dict[str, float], i: int, omega: float) -> tuple[float, float]:
    """Where that dot is for a drive frequency, in pixels."""
    at = Hand(fitted(SCENES["forced"].at({**values, "view": "nyquist", "omega": omega})), dot(i), wide=True, t=0.0).at()
    return at or pytest.fail("not drawn")


@pytest.mark.parametrize("values", [LIGHT, STRONG, UNEVEN, {"c1": 1e-3, "c2": 1e-3}])
@pytest.mark.parametrize("i", [1, 2])
def test_the_dot_of_nyquist_follows_the_hand_along_its_loops(values: dict[str, float], i: int) -> None:
    slow, fast = chain_of(values).chain.modes().omega.tolist()
    roots = [root for root in chain_of(values).roots.tolist() if root.imag > 0]
    every = locus_frequencies(roots, fast)[::24]
    way = every[(every > 0.5 * slow) & (every < 1.5 * fast)]
    places = [place(values, i, omega) for omega in way]
    hand = Hand(fitted(SCENES["forced"].at({**values, "view": "nyquist", "omega": way[0]})), dot(i), wide=True, t=0.0)
    hand.take()
    for omega, (x, y) in zip(way, places, strict=True):
        hand.set(hand.move((x, y)))
        assert math.dist(hand.at(moved=False) or (), (x, y)) < 2.0, omega
    assert hand.scene.values["omega"] > fast, "it has gone round both loops"


def test_the_dot_of_nyquist_stays_on_its_curve_where_the_hand_leaves_it() -> None:
    hand = Hand(fitted(SCENES["forced"].at({**LIGHT, "view": "nyquist", "omega": 0.55})), dot(1), wide=True, t=0.0)
    hand.take()
    x, y = hand.at() or (0.0, 0.0)
    ways = ((0.0, 40.0), (60.0, 60.0), (-200.0, 30.0))
    found = [(hand.move((x + dx, y + dy)), hand.at()) for dx, dy in ways]
    for values, moved in found:
        assert math.dist(place(LIGHT, 1, values["omega"]), moved or ()) < 1.0
