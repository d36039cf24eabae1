"""Scene forced through its callbacks: set a parameter, read the data sources."""

from __future__ import annotations

import math

import numpy as np
import pytest

from components.chain.forces import LENGTH
from components.scenes.forced import Forced
from components.scenes.forced.response import response_plot
from physics.coupled import TwoMassChain
from physics.forced import particular_solution
from tests.page.headless_page import apply_message, take_preset
from tests.page.scripts import played

GOLDEN = (math.sqrt(5) + 1) / 2


def test_the_lectures_figure() -> None:
    """Slide 8: axes 0 to 2.5 and -5 to 5, signs change at each pole."""
    scene = Forced(curve="signed", axes="lecture")
    axes = scene.shown.axes
    assert axes["omega"].ruler.start == 0.0 and axes["omega"].ruler.end == pytest.approx(2.5, rel=0.05)
    assert (axes["X"].ruler.start, axes["X"].ruler.end) == (-5.0, 5.0)
    branches = [scene.sources[f"branch{i}"].data for i in range(4)]
    signs = [(np.sign(b["Xp1"][5]), np.sign(b["Xp2"][5])) for b in branches]
    assert signs == [(1, 1), (-1, -1), (1, -1), (-1, 1)]


@pytest.mark.parametrize("values", [{}, {"k1": 0.0}, {"k2": 0.0}, {"m1": 2.0, "k1": 2.0, "m2": 0.1, "k2": 0.1}])
@pytest.mark.parametrize("shown", ["size", "log"])
def test_what_swings_against_the_push_is_dashed(values: dict[str, float], shown: str) -> None:
    """Each branch is drawn with one line sample: the sign of the particular solution is seen without asking for it."""
    scene = Forced(**values, curve=shown)
    chain = TwoMassChain(m1=scene.m1, m2=scene.m2, k1=scene.k1, k2=scene.k2)
    drawn = {(one.source, one.y): one.width for one in response_plot().curves}
    branches = [scene.sources[f"branch{i}"].data.get("omega", np.empty(0))[1:-1] for i in range(4)]
    assert sum(w.size for w in branches) > 100
    for i, w in enumerate(branches):
        for name, X in zip(("Xp1", "Xp2"), particular_solution(chain, 1.0, w), strict=True):
            assert not np.any(X < 0 if drawn[f"branch{i}", name] == "sum" else X > 0), (i, name)


def test_a_dot_that_has_left_the_frame_is_marked() -> None:
    marks = ("Xp1_over", "Xp2_over", "Xp1_under", "Xp2_under")
    assert [Forced(omega=0.6).shown.scalars[name] for name in marks] == [1, 1, 0, 0]
    assert [Forced(omega=0.65, curve="signed").shown.scalars[name] for name in marks] == [0, 0, 1, 1]
    assert [Forced().shown.scalars[name] for name in marks] == [0, 0, 0, 0]


def test_growth_at_resonance_is_said_and_drawn() -> None:
    """m1 = 2, m2 = 1, k1 = 4, k2 = 2 at omega_- = 1: M_- = 6 kg, so x1 grows by F_0/(2 M_- omega_-) = 1/12 m/s."""
    scene = Forced(m1=2.0, k1=4.0, k2=2.0, omega=1.0)
    assert scene.shown.forms["steady"] == "resonance"
    limit, data = scene.sources["limit"].data, scene.sources["time"].data
    np.testing.assert_allclose(limit["x1_beat"], limit["t"] / 12, rtol=1e-14)
    np.testing.assert_array_equal(limit["x1_fall"], -limit["x1_beat"])
    # The difference from the envelope is the share of the fast mode, which stays bounded.
    assert np.all(np.abs(data["x1"]) < np.interp(data["t"], limit["t"], limit["x1_beat"]) + 0.2)


def test_forces_on_demand_are_newtons_law() -> None:
    assert "F1" not in Forced().shown.signals
    scene = Forced(view="forces", x1_0=0.5, v2_0=-1.0)
    x, now = scene.sources["time"].data, played(scene.shown, scene.sources["time"].data["t"])
    (F1, F2), step = (now["F1"], now["F2"]), x["t"][1] - x["t"][0]
    for F, m, name in ((F1, scene.m1, "x1"), (F2, scene.m2, "x2")):
        np.testing.assert_allclose(F[1:-1], m * np.diff(x[name], 2) / step**2, atol=0.01)
    scalars = scene.shown.scalars
    assert scalars["newton"] * max(np.abs(F1).max(), np.abs(F2).max(), scene.F_0) == pytest.approx(LENGTH)
    assert scalars["push"] == pytest.approx(scalars["newton"] * scene.F_0)


def test_near_resonance_the_parts_give_way_to_the_envelope() -> None:
    scene = Forced(omega=(1 + 1e-9) / GOLDEN)
    data, limit = scene.sources["time"].data, scene.sources["limit"].data
    assert scene.shown.forms["x1_p"] == ""
    np.testing.assert_allclose(limit["x1_beat"], limit["t"] * limit["x1_beat"][-1] / limit["t"][-1], rtol=1e-12)
    # The other mode's share stays bounded while the envelope grows.
    late = data["t"] > data["t"][-1] / 2
    assert np.abs(data["x1"][late]).max() == pytest.approx(limit["x1_beat"][-1], rel=0.2)


@pytest.mark.parametrize("label", ["At slow", "At fast"])
def test_hardly_an_ulp_from_a_natural_frequency_is_resonance(label: str) -> None:
    scene = Forced()
    take_preset(scene, label)
    natural = scene.omega
    seen = []
    for omega in (natural, math.nextafter(natural, 0.0), math.nextafter(natural, math.inf)):
        scene.set({"omega": omega})
        seen.append(scene.shown.forms["steady"])
        if seen[-1] != "resonance":
            continue
        assert (scene.shown.values["D"], scene.shown.values["Xp1"]) == ("0.00", "+∞")
        assert "drive_at" not in scene.shown.scalars
        assert not any("huge" in note for note in scene.shown.notes)
        before = scene.shown
        (error,) = apply_message(scene, {"type": "act", "name": "steady"}).values()
        assert "is at a natural frequency, where no particular solution exists: another" in error
        assert scene.shown is before
    # The frequency is between two doubles; only these two are at most an ulp away.
    assert seen[0] == "resonance" and seen.count("resonance") == 2


def test_work_is_the_gain_of_energy() -> None:
    for values in ({}, {"omega": 1 / GOLDEN}, {"x1_0": 1.0, "v2_0": -2.0}):
        data = Forced(**values, view="work").sources["energy"].data
        np.testing.assert_allclose(data["work"], data["gain"], atol=1e-13 * np.abs(data["gain"]).max())


def test_the_slider_spans_two_and_a_half_natural_frequencies() -> None:
    scene = Forced()
    scene.set({"k1": 100.0})
    fast = TwoMassChain(m1=1, m2=1, k1=100, k2=1).modes().omega[1]
    assert scene.shown.spans["omega"] == (0.0, 2.5 * fast)


@pytest.mark.parametrize(("shown", "least"), [("size", 0.0), ("signed", 0.0), ("log", 1e-3)])
def test_curve_of_mass_1_comes_down_to_its_zero(shown: str, least: float) -> None:
    scene = Forced(m1=2.0, k1=2.0, m2=0.1, k2=0.1, curve=shown)
    swing = scene.sources["response"].data["Xp1"]
    assert np.abs(swing).min() <= least
    assert np.all(np.abs(swing) > 0) == (shown == "log")
