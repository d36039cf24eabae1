"""Scene absorber: its motion against Newton's laws, its goals, its tuning, and the lightest solution."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from components.scenes import SCENES
from components.scenes.absorber import Absorber
from components.session.opening import opened
from components.state.link import read_query
from physics.absorber import den_hartog
from tests.page.headless_page import Page, apply_message, change, set_values, take_preset
from tests.page.scripts import played
from tests.scenes.checks import as_arguments, check_picture
from tests.scenes.sentences import said

M1, K1, F_0 = 100.0, 250e3, 500.0
OWN = {"own": True, "omega": 1.0, "tuning": "free", "damping": "added", "view": "rest"}
TWICE = {**OWN, "m1": 400.0, "k1": 625.0, "F_0": 100.0, "m2": 225.0, "k2": 144.0, "x1_0": 0.3}
"""At c = 216 its exponents are one pair twice, and t exp(s t) outlasts exp(s t)."""
PLAYED: list[dict[str, Any]] = [
    {},
    {"k2": 30e3},
    {"damping": "added", "c": 200.0},
    {"view": "rest"},
    {"view": "rest", "tuning": "detached"},
    {"view": "rest", **{**OWN, "damping": "none"}, "m1": 2.0, "k1": 4.0, "F_0": 1.0, "m2": 1.0, "k2": 2.0},
    *(
        {"view": "rest", "damping": "added", "tuning": "free", **values}
        for values in ({"c": 313.7, "k2": 27.4e3}, {"c": 2000.0}, {"c": 20.0, "omega": 40.0})
    ),
    *({**TWICE, "c": c} for c in (216.0, 216.0000001, 216.01, 230.0)),
    {**OWN, "m1": 1.0, "k1": 1.0, "F_0": 1.0, "omega": 0.7, "m2": 1.0, "k2": 0.0, "c": 1.0},
]
"""Machines without and with damping, steady or from the start, at a resonance, and with equal exponents."""


def parts_of(scene: Absorber) -> tuple[float, float]:
    """The spring and the dashpot between both masses."""
    attached = scene.tuning != "detached"
    return attached * scene.k2, attached * (scene.damping == "added") * scene.c


def solved(scene: Absorber, t: np.ndarray) -> np.ndarray:
    """x1, x2, v1, v2 (4, n) by Newton's laws, from the start of the view."""
    k2, c = parts_of(scene)
    m1, k1, m2, omega, F_0 = scene.m1, scene.k1, scene.m2, scene.omega, scene.F_0

    def rates(t: float, y: np.ndarray) -> list[float]:
        x1, x2, v1, v2 = y
        link = k2 * (x2 - x1) + c * (v2 - v1)
        return [v1, v2, (F_0 * math.sin(omega * t) - k1 * x1 + link) / m1, -link / m2]

    start = np.array([scene.x1_0, scene.x2_0, scene.v1_0, scene.v2_0])
    if scene.view != "rest":
        link = k2 + 1j * c * omega
        X = np.linalg.solve([[k1 + link - m1 * omega**2, -link], [-link, link - m2 * omega**2]], [F_0, 0.0])
        start = np.array([*X.imag, *(1j * omega * X).imag])
    return np.asarray(solve_ivp(rates, (0, t[-1]), start, "DOP853", t, rtol=1e-11, atol=1e-14).y)


@pytest.mark.parametrize("values", PLAYED, ids=str)
def test_what_is_drawn_and_played_obeys_newtons_laws(values: dict[str, Any]) -> None:
    scene = Absorber(**values)
    shown, data = scene.shown, scene.sources["rest"].data
    t = data["t"] if scene.view == "rest" else np.linspace(0.0, 0.5, 200)
    y = solved(scene, t)
    size = np.abs(y[:2]).max()
    if scene.view == "rest":
        np.testing.assert_allclose(data["x1"], y[0], atol=1e-7 * size)
        parts = data["x1_p"] + data["x1_c"] if "x1_p" in data else data["x1"]
        np.testing.assert_allclose(parts, data["x1"], atol=1e-9 * size)
    now = played(shown, t / 10.0 ** shown.axes["t"].exponent)
    moved = [now[name] * 10.0 ** shown.axes[f"X{name[1]}"].exponent for name in ("x1", "x2")]
    np.testing.assert_allclose(moved, y[:2], atol=1e-4 * size)
    k2, c = parts_of(scene)
    pull = k2 * (y[1] - y[0]) + c * (y[3] - y[2])
    np.testing.assert_allclose(now["pull_now"], pull, atol=1e-3 * np.abs(pull).max())


@pytest.mark.parametrize("values", [{"c": 313.7, "k2": 27.4e3}, {"c": 2000.0}, {"c": 20.0, "omega": 40.0}])
def test_after_the_time_that_is_told_hardly_anything_is_left_of_the_transient(values: dict[str, float]) -> None:
    scene = Absorber(**values, damping="added", view="rest", tuning="free")
    drawn, shown = scene.sources["rest"].data, scene.shown
    assert np.abs(drawn["x1"]).max() <= 1e-3 * float(shown.values["rest1"]) * 1.005
    late = drawn["t"] > float(shown.values["dies"].removesuffix(" s"))
    assert np.all(np.abs(drawn["x1_c"][late]) < 0.02 * np.abs(drawn["x1_c"]).max())
    assert shown.forms["why_rest"] == "damped" and "at most 1 %" not in said(scene, "why_rest")


def drawn_to(told: dict[str, Any]) -> float:
    """The width of one metre on the stage, although the picture uses the unit of its axis."""
    axis = told["view"]["axes"]["X1"]
    return float(told["view"]["scalars"]["metre"] / axis["factor"] / 10.0 ** axis["exponent"])


def test_twice_the_force_is_seen_as_twice_the_swing_until_the_stage_has_no_room() -> None:
    page = Page(Absorber())
    first = page.opening()
    scale, tick = drawn_to(first), first["view"]["values"]["tick"]
    for force in (250.0, 100.0, 700.0):
        told = set_values(page, F_0=force)
        assert (drawn_to(told), told["view"]["values"]["tick"]) == (pytest.approx(scale), tick), force
    small = drawn_to(set_values(page, F_0=5e4))
    assert small < 0.5 * scale
    assert drawn_to(set_values(page, F_0=700.0)) == pytest.approx(small), "it grows by Fit alone"
    assert drawn_to(change(page, frame=None)) > 2 * small


def met(scene: Absorber) -> list[bool]:
    return [bool(scene.shown.scalars[f"met{i}"]) for i in range(3)]


def lightest_tuned(omega: float) -> float:
    """The mass at which a tuned absorber's resonances are 20 % away: the roots of D at 0.8 and 1.2 omega."""
    below, above = ((K1 - M1 * (s * omega) ** 2) * (1 - s**2) / (s**2 * omega**2) for s in (0.8, 1.2))
    return max(below, above)


@pytest.mark.parametrize("damping", [0.02, 1e5])
def test_the_highest_peak_is_drawn(damping: float) -> None:
    """With much damping the two masses move as one, at another natural frequency than those without damping."""
    scene = Absorber(damping="added", c=damping)
    w, swing = (scene.sources["sweep"].data[name] for name in ("w", "swing"))
    fine = np.linspace(w[0], w[-1], 400_001)
    s, link = 1j * fine, scene.k2 + 1j * fine * scene.c
    other = scene.m2 * s**2 + link
    exact = np.abs(scene.F_0 * other / ((scene.m1 * s**2 + scene.k1 + link) * other - link**2))
    assert swing.max() > 0.99 * exact.max()


@pytest.mark.parametrize("label", ["Below", "Resonant", "Above"])
def test_goals_can_be_met_from_the_lightest_mass_on(label: str) -> None:
    scene = Absorber()
    assert take_preset(scene, label) == {}
    mass = lightest_tuned(scene.omega)
    scene.m2 = mass * (1 - 1e-3)
    assert met(scene) == [False, True, True]
    assert scene.shown.values["lightest"] == "none yet"
    scene.m2 = mass * (1 + 1e-3)
    assert met(scene) == [True, True, True]
    assert scene.shown.values["lightest"] == f"{mass * (1 + 1e-3):.4g} kg"


def test_score_is_the_lightest_mass_of_this_machine() -> None:
    scene = Absorber(m2=30.0)
    assert scene.shown.values["lightest"] == "30 kg"
    scene.m2 = 26.0
    scene.m2 = 40.0
    assert scene.shown.values["lightest"] == "26 kg"
    scene.set({"damping": "added", "c": 0.1, "m2": 25.5})
    assert scene.shown.values["lightest"] == "26 kg"
    scene.omega = 47.0
    assert scene.shown.values["lightest"] == "none yet"


def test_a_link_and_a_state_carry_the_lightest_solution_which_is_looked_at_again() -> None:
    page = Page(Absorber(m2=30.0))
    told = set_values(page, m2=40.0)
    assert told["view"]["values"]["lightest"] == "30 kg"
    again = opened(SCENES, read_query(as_arguments(told["query"]), SCENES))
    assert again.now.shown.values["lightest"] == "30 kg"
    state = {**told["state"], "parameters": {**told["state"]["parameters"], "lightest": 3.0}}
    assert change(page, **state)["view"]["values"]["lightest"] == "40 kg", "no absorber of 3 kg does it"
    assert set_values(page, lightest=3.0)["errors"], "nobody sets it"


def test_knob_drags_the_valley() -> None:
    scene = Absorber()
    assert apply_message(scene, {"type": "set", "values": {"_valley": 40.0}}) == {}
    assert (scene.k2, scene.tuning, scene.values["_valley"]) == (25600.0, "free", 40.0)
    data = scene.sources["sweep"].data
    low = np.argmin(np.where((data["w"] > 36) & (data["w"] < 44), data["swing"], np.inf))
    assert data["w"][low] == pytest.approx(40.0, abs=1e-9)


def test_den_hartogs_optimum() -> None:
    scene = Absorber(damping="added")
    assert apply_message(scene, {"type": "act", "name": "optimum"}) == {}
    best = den_hartog(M1, K1, 16.0)
    assert (scene.k2, scene.c) == (pytest.approx(best.k2, rel=5e-4), pytest.approx(best.c, rel=5e-4))
    assert scene.sources["sweep"].data["swing"].max() == pytest.approx(best.height * F_0 / K1, rel=5e-3)
    assert scene.shown.values["over_height"] == "0.27 %"
    heights = [scene.shown.scalars[f"{name}_y"] for name in "PQ"]
    assert heights == pytest.approx([1e3 * best.height * F_0 / K1] * 2, rel=1e-3)
    assert scene.shown.forms["why"] == "damped"


def test_a_motion_from_rest_that_cannot_be_drawn_takes_its_view_alone_away() -> None:
    machine = {"own": True, "m1": 1e130, "k1": 1e-32, "F_0": 1e57, "omega": 1e113, "m2": 1e26, "k2": 1e145}
    scene = Absorber(**machine, tuning="free")
    check_picture(scene)
    assert not scene.sources["rest"].data and len(scene.sources["sweep"].data["w"])
    with pytest.raises(ValueError, match="outside the range of doubles"):
        scene.view = "rest"
    assert scene.view == "goals"
