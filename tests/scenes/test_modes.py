"""Scene modes through its callbacks: four views of one chain."""

from __future__ import annotations

import math

import numpy as np
import pytest

from components.scenes.modes import VIEWS, ModesScene
from tests.page.headless_page import apply_message

GOLDEN = (math.sqrt(5) - 1) / 2


# Guess


def test_curves_cross_at_the_modes_and_D_vanishes_there() -> None:
    scene = ModesScene(view="guess")
    det = scene.sources["det"].data
    signs = np.flatnonzero(np.diff(np.sign(det["D"])))
    np.testing.assert_allclose(det["w"][signs], [1.0, 2.0], atol=0.02)
    np.testing.assert_allclose(det["D"], 2 * det["w"] ** 4 - 10 * det["w"] ** 2 + 8, atol=1e-12)
    line, below, above = (scene.sources[name].data for name in ("row1", "row2_below", "row2_above"))
    straight = np.poly1d(np.polyfit(line["w"] ** 2, line["row1"], 1))
    for branch, name, square, ratio in ((below, "row2_below", 1.0, 2.0), (above, "row2_above", 4.0, -1.0)):
        gap = branch[name] - straight(branch["w"] ** 2)
        crossing = np.interp(0.0, gap, branch["w"] ** 2)
        assert crossing == pytest.approx(square, abs=0.01)
        assert straight(crossing) == pytest.approx(ratio, abs=0.01)


@pytest.mark.parametrize(("mode", "omega", "ratio"), [("slow", 1.0, 2.0), ("fast", 2.0, -1.0)])
def test_at_a_mode_the_rows_are_one_equation_and_nothing_is_to_be_added(mode: str, omega: float, ratio: float) -> None:
    shown = ModesScene(view="guess", omega=omega, ratio=ratio).shown
    assert shown.forms["agree"] == f"same_{mode}"
    assert shown.values["D"] == "0.00"
    assert [shown.values[f"add{i}_N"] for i in (1, 2)] == ["+0.00 N", "+0.00 N"]
    assert shown.values["you_add"] == "no extra force: a mode"


def test_the_flag_leads_to_a_mode_that_no_double_holds() -> None:
    """m1 = m2, k1 = k2: the golden ratio. The flag sets the nearest double, and the buttons its shape."""
    scene = ModesScene(view="guess")
    scene.set(ModesScene.presets["All equal"])
    assert scene.shown.scalars["w_slow_si"] == pytest.approx(GOLDEN, rel=1e-15)
    scene.omega = scene.shown.scalars["w_slow_si"]
    assert scene.shown.forms["agree"] == "same_slow"
    assert apply_message(scene, {"type": "act", "name": "row1"}) == {}
    assert scene.ratio == pytest.approx(1 / GOLDEN, rel=1e-14)
    assert scene.shown.values["add2_N"] == "+0.00 N"


def test_nearly_a_mode_is_said_to_be_near() -> None:
    shown = ModesScene(view="guess", omega=1.0005).shown
    assert shown.forms["agree"] == "near_slow"
    assert shown.values["you_add"] == "force of your hand"


def test_as_a_mass_wants_takes_its_force_away() -> None:
    for i in (1, 2):
        scene = ModesScene(view="guess")
        assert apply_message(scene, {"type": "act", "name": f"row{i}"}) == {}
        assert scene.shown.values[f"add{i}_N"] == "+0.00 N"
        assert scene.shown.values[f"add{3 - i}_N"] != "+0.00 N"


def test_no_ratio_says_that_mass_1_rests() -> None:
    scene = ModesScene(view="guess", k2=1.0, omega=1.0)
    assert scene.shown.forms["row2_says"] == "pole"
    errors = apply_message(scene, {"type": "act", "name": "row2"})
    assert "X₁ = 0" in errors["action"]
    assert scene.ratio == -0.8


def test_hardly_an_ulp_from_a_zero_is_the_zero() -> None:
    """In the default chain mass 2 alone, mass 1 held, swings at sqrt(2), and mass 1 alone at sqrt(3): no doubles."""
    scene = ModesScene(view="guess")
    for omega in (math.sqrt(2), math.nextafter(math.sqrt(2), 0.0)):
        scene.set({"omega": omega})
        values = scene.shown.values
        assert [scene.shown.forms[name] for name in ("row2_says", "agree", "D")] == ["pole", "pole", "value"]
        assert (values["a22"], values["D"]) == ("0.00", "−4.00")
        assert "X₁ = 0" in apply_message(scene, {"type": "act", "name": "row2"})["action"]
    scene.set({"omega": math.sqrt(3)})
    assert (scene.shown.values["a11"], scene.shown.values["row1"]) == ("0.00", "+0.00")
    for omega, mode in ((math.nextafter(1.0, 2.0), "slow"), (math.nextafter(2.0, 1.0), "fast")):
        scene.set({"omega": omega})
        assert scene.shown.forms["agree"] == f"same_{mode}"
        assert (scene.shown.values["D"], scene.shown.values["apart"]) == ("0.00", "0.00")


def test_the_longest_arrow_fits_and_their_lengths_are_the_forces() -> None:
    scalars = ModesScene(view="guess", omega=0.7, ratio=3.0).shown.scalars
    arrows = np.array([scalars[f"{row}{i}_N"] for i in (1, 2) for row in ("need", "give")])
    forces = np.array([-2 * 0.49 / 3, -4 / 3 + 2 * (1 - 1 / 3), -0.49, -2 * (1 - 1 / 3)])
    np.testing.assert_allclose(arrows, 0.17 * forces / np.abs(forces).max(), rtol=1e-12, atol=1e-15)


def test_the_guess_swings_at_the_trial_frequency_from_full_swing() -> None:
    shown = ModesScene(view="guess").shown
    (wave,) = shown.signals["x2"].sines
    omega, phase = wave.omega, wave.phase
    assert (omega * 10 ** -shown.axes["t"].exponent, phase) == (1.7, math.pi / 2)


# Solve


def test_the_lectures_numbers() -> None:
    values = ModesScene(view="solve").shown.values
    wanted = {"m1m2": "2.00", "b": "10.0", "k1k2_": "8.00", "Delta": "36.0", "root": "6.00", "difference": "−2.00"}
    wanted |= {"coupling": "32.0", "gamma": "−0.500", "delta": "1.50", "product": "−2.00"}
    assert wanted.items() <= values.items()


def test_arrows_of_a_mode_turn_together_or_opposite() -> None:
    signals = ModesScene(view="solve").shown.signals
    for mode, sign in (("slow", 1), ("fast", -1)):
        one, two = (signals[f"x{i}_{mode}"].sines[0] for i in (1, 2))
        assert (one.omega, one.phase) == (two.omega, two.phase)
        assert math.copysign(1, two.size / one.size) == sign


def test_no_wall_is_said() -> None:
    shown = ModesScene(view="solve", k1=0.0).shown
    assert shown.forms["below"] == "zero"
    assert shown.values["slow_omega"] == "0.00"


# All views


def test_what_is_compared_has_the_names_by_which_the_views_tell_it() -> None:
    told = {name for view in VIEWS for name in ModesScene(view=view, answer="shown").shown.values}
    compared = {name for one in ModesScene().readouts() for name in (one.name, *one.also)}
    assert compared - told == {"ratio_slow", "ratio_fast"}
