"""Scene modes through its callbacks: four views of one chain."""

from __future__ import annotations

import math

import numpy as np
import pytest

from components.scenes.modes import VIEWS, ModesScene
from tests.page.headless_page import apply_message

GOLDEN = (math.sqrt(5) - 1) / 2


# Guess


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
    """In the default chain mass 2 alone, mass 1 held, swings at sqrt(2), which is no double."""
    scene = ModesScene(view="guess")
    for omega in (math.sqrt(2), math.nextafter(math.sqrt(2), 0.0)):
        scene.set({"omega": omega})
        values = scene.shown.values
        assert [scene.shown.forms[name] for name in ("row2_says", "agree", "D")] == ["pole", "pole", "value"]
        assert (values["a22"], values["D"]) == ("0.00", "−4.00")
        assert "X₁ = 0" in apply_message(scene, {"type": "act", "name": "row2"})["action"]


def test_the_longest_arrow_fits_and_their_lengths_are_the_forces() -> None:
    scalars = ModesScene(view="guess", omega=0.7, ratio=3.0).shown.scalars
    arrows = np.array([scalars[f"{row}{i}_N"] for i in (1, 2) for row in ("need", "give")])
    forces = np.array([-2 * 0.49 / 3, -4 / 3 + 2 * (1 - 1 / 3), -0.49, -2 * (1 - 1 / 3)])
    np.testing.assert_allclose(arrows, 0.17 * forces / np.abs(forces).max(), rtol=1e-12, atol=1e-15)


def test_what_is_compared_has_the_names_by_which_the_views_tell_it() -> None:
    told = {name for view in VIEWS for name in ModesScene(view=view, answer="shown").shown.values}
    compared = {name for one in ModesScene().readouts() for name in (one.name, *one.also)}
    assert compared - told == {"ratio_slow", "ratio_fast"}
