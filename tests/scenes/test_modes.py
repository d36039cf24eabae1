"""Scene modes through its callbacks: four views of one chain."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest

from components.scenes.modes import VIEWS, ModesScene
from tests.page.headless_page import apply_message, take_preset
from tests.scenes.checks import check_picture

views = pytest.mark.parametrize("view", VIEWS)
GOLDEN = (math.sqrt(5) - 1) / 2


# Guess


def test_the_guess_of_the_mockup() -> None:
    values = ModesScene(view="guess").shown.values
    assert [values[name] for name in ("a11", "a12", "a22", "D", "square")] == [
        "−0.220",
        "2.00",
        "0.890",
        "−4.20",
        "2.89",
    ]
    assert [values[name] for name in ("row1", "row2", "apart")] == ["+0.110", "−2.25", "2.36"]
    assert [values[f"{row}{i}_N"] for row in ("need", "give", "add") for i in (1, 2)] == [
        "−5.78 N",
        "+2.31 N",
        "−7.60 N",
        "+3.60 N",
        "+1.82 N",
        "−1.29 N",
    ]
    assert (values["omega_slow"], values["omega_fast"]) == ("1.00", "2.00")
    assert (values["r_slow"], values["r_fast"]) == ("+2.00", "−1.00")
    assert (values["k1k2"], values["k2k2"]) == ("8.00", "−4.00")


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
    assert [values[n] for n in ("m1m2", "b", "k1k2_", "Delta", "root", "difference", "coupling")] == [
        "2.00",
        "10.0",
        "8.00",
        "36.0",
        "6.00",
        "−2.00",
        "32.0",
    ]
    assert [values[n] for n in ("gamma", "delta", "slow_ratio", "fast_ratio", "product")] == [
        "−0.500",
        "1.50",
        "+2.00",
        "−1.00",
        "−2.00",
    ]


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


# Sweep


# All views


def test_what_is_compared_has_the_names_by_which_the_views_tell_it() -> None:
    told = {name for view in VIEWS for name in ModesScene(view=view, answer="shown").shown.values}
    compared = {name for one in ModesScene().readouts() for name in (one.name, *one.also)}
    assert compared - told == {"ratio_slow", "ratio_fast"}


@views
def test_presets_in_every_view(view: str) -> None:
    scene = ModesScene(view=view)
    for label in scene.presets:
        assert take_preset(scene, label) == {}
        assert (scene.preset(), scene.values["view"]) == (label, view)
        check_picture(scene)


@views
def test_corners_are_drawn_or_refused_in_words(view: str) -> None:
    """Any combination of values that physics allows."""
    pick = random.Random(view)
    sizes = (1e-300, 1e-150, 1e-12, 1.0, 1e12, 1e150, 1e300)
    drawn = 0
    for _ in range(60):
        values = {name: pick.choice(sizes) for name in ("m1", "m2")}
        values |= {name: pick.choice((0.0, *sizes)) for name in ("k1", "k2", "omega", "x1_0", "x2_0")}
        choices = {"swept": pick.choice(("m1", "m2", "k1", "k2"))}
        scene = ModesScene()
        try:
            scene.set(
                {
                    **values,
                    **choices,
                    "ratio": pick.choice((-1, 1)) * pick.choice(sizes),
                    "answer": "shown",
                    "view": view,
                }
            )
        except ValueError as reason:
            assert "range of doubles" in str(reason)
            continue
        drawn += 1
        check_picture(scene)
    assert drawn > 20
