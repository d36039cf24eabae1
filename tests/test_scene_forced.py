"""Scene forced through its callbacks: set a parameter, read the data sources."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from components.controls import apply_message
from components.scenes.forced import Forced

GOLDEN = (math.sqrt(5) + 1) / 2


def integrated(scene: Forced, times: np.ndarray) -> np.ndarray:
    def rates(t: float, y: np.ndarray) -> list[float]:
        x1, x2, v1, v2 = y
        pull, drive = scene.k2 * (x2 - x1), scene.F_0 * math.sin(scene.omega * t)
        return [v1, v2, (-scene.k1 * x1 + pull + drive) / scene.m1, -pull / scene.m2]

    start = [scene.x1_0, scene.x2_0, scene.v1_0, scene.v2_0]
    return solve_ivp(rates, (0, times[-1]), start, "DOP853", times, rtol=1e-12, atol=1e-12).y[:2]


@pytest.mark.parametrize(
    "values",
    [
        {},
        {"omega": 1 / GOLDEN},
        {"omega": GOLDEN},
        {"omega": 1 / GOLDEN + 1e-9},
        {"k1": 0.0, "omega": 0.3},
        {"k2": 0.0},
    ],
)
def test_curves_are_the_motion(values: dict[str, float]) -> None:
    scene = Forced(**values)
    data = scene.sources["time"].data
    np.testing.assert_allclose([data["x1"], data["x2"]], integrated(scene, data["t"]), atol=1e-7)


def test_total_is_complementary_plus_particular() -> None:
    data = Forced(x1_0=0.5, v2_0=-1.0).sources["time"].data
    for i in (1, 2):
        np.testing.assert_allclose(data[f"x{i}_c"] + data[f"x{i}_p"], data[f"x{i}"], atol=1e-13)


def test_the_lectures_figure() -> None:
    """Slide 8: poles at 0.618 and 1.618, zero of Xp1 at 1, axes 0 to 2.5 and -5 to 5, signs change at each pole."""
    scene = Forced(curve="signed", axes="lecture")
    axes, scalars = scene.shown.axes, scene.shown.scalars
    assert (axes["omega"].wire()["start"], axes["omega"].wire()["end"]) == (0.0, 2.6) or axes["omega"].wire()[
        "end"
    ] == pytest.approx(2.5, rel=0.01)
    assert (axes["X"].wire()["start"], axes["X"].wire()["end"]) == (-5.0, 5.0)
    assert scalars["mark_minus"] == pytest.approx(1 / GOLDEN)
    assert scalars["mark_plus"] == pytest.approx(GOLDEN)
    assert scalars["mark_still"] == 1.0
    signs = [(np.sign(b["Xp1"][5]), np.sign(b["Xp2"][5])) for b in (scene.sources[f"branch{i}"].data for i in range(3))]
    assert signs == [(1, 1), (-1, -1), (1, 1)] or signs == [(1, 1), (-1, -1), (-1, 1)]


def test_no_branch_runs_across_a_pole() -> None:
    scene = Forced(curve="signed")
    poles = (scene.shown.scalars["mark_minus"], scene.shown.scalars["mark_plus"])
    for i in range(3):
        omega = scene.sources[f"branch{i}"].data["omega"]
        assert not any(omega[0] < pole < omega[-1] for pole in poles)


def test_lecture_axes_are_not_offered_without_a_wall() -> None:
    scene = Forced(k1=0.0, axes="lecture")
    assert scene.shown.axes["X"].unit == "m"
    assert scene.shown.forms["lecture"] == ""
    assert any("k₁" in note for note in scene.shown.notes)


def test_steady_start_leaves_no_complementary_part() -> None:
    scene = Forced()
    assert apply_message(scene, {"type": "act", "name": "steady"}) == {}
    data = scene.sources["time"].data
    assert np.abs(data["x1_c"]).max() < 1e-15 and np.abs(data["x2_c"]).max() < 1e-15
    assert apply_message(scene, {"type": "act", "name": "rest"}) == {}
    assert (scene.v1_0, scene.v2_0) == (0.0, 0.0)


def test_steady_start_is_refused_at_resonance() -> None:
    scene = Forced(k2=0.0, omega=1.0)
    errors = apply_message(scene, {"type": "act", "name": "steady"})
    assert "natural frequency" in errors["action"]


def test_refusals_write_numbers_as_they_are_typed() -> None:
    errors = apply_message(Forced(), {"type": "typed", "name": "omega", "text": "1e300"})
    assert "= 1e300 rad/s" in errors["omega"]


def test_near_resonance_the_parts_give_way_to_the_envelope() -> None:
    scene = Forced(omega=1 / GOLDEN)
    data, limit = scene.sources["time"].data, scene.sources["limit"].data
    assert "x1_p" not in data and scene.shown.forms["x1_p"] == ""
    assert any("huge and opposite" in note for note in scene.shown.notes)
    np.testing.assert_allclose(limit["x1_growth"], limit["t"] * limit["x1_growth"][-1] / limit["t"][-1], rtol=1e-12)
    assert np.all(limit["x1_beat"] <= limit["x1_growth"] * (1 + 1e-12))
    # The other mode's share stays bounded while the envelope grows.
    late = data["t"] > data["t"][-1] / 2
    assert np.abs(data["x1"][late]).max() == pytest.approx(limit["x1_growth"][-1], rel=0.2)


def test_work_is_the_gain_of_energy() -> None:
    for values in ({}, {"omega": 1 / GOLDEN}, {"x1_0": 1.0, "v2_0": -2.0}):
        data = Forced(**values).sources["energy"].data
        np.testing.assert_allclose(data["work"], data["gain"], atol=1e-13 * np.abs(data["gain"]).max())


def test_the_slider_spans_two_and_a_half_natural_frequencies() -> None:
    scene = Forced()
    scene.set({"k1": 100.0})
    from physics.coupled import TwoMassChain

    fast = TwoMassChain(m1=1, m2=1, k1=100, k2=1).modes().omega[1]
    assert scene.param.omega.softbounds == (0.0, 2.5 * fast)


def test_antiresonance_stops_mass_1() -> None:
    scene = Forced(omega=1.0)
    assert scene.shown.values["Xp1"] in ("+0.00", "−0.00")
    assert scene.shown.values["Xp2"] == "−1.00"


@pytest.mark.parametrize(("shown", "least"), [("size", 0.0), ("signed", 0.0), ("log", 1e-3)])
def test_curve_of_mass_1_comes_down_to_its_zero(shown: str, least: float) -> None:
    scene = Forced(m1=2.0, k1=2.0, m2=0.1, k2=0.1, curve=shown)
    swing = scene.sources["response"].data["Xp1"]
    assert np.abs(swing).min() <= least
    assert np.all(np.abs(swing) > 0) == (shown == "log")
