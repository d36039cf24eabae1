"""Scene energy: the hanging mass, its potential well, the zero of V, and quantities that gravity does not change."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from components.scenes.energy import Energy
from components.scenes.energy.case import PLANETS
from tests.scenes.checks import columns

CASE = {"m": 0.8, "k": 17.0, "g": 3.71, "x_0": -0.12, "v_0": 0.9}
datums = pytest.mark.parametrize("datum", ["equilibrium", "separate", "slide"])


@datums
def test_energies_of_the_motion_from_the_ceiling(datum: str) -> None:
    """The energies follow from the displacement from the natural length, with the actual spring and weight."""
    scene = Energy(**CASE, datum=datum)
    m, k, g = CASE["m"], CASE["k"], CASE["g"]
    data, sag = columns(scene), m * g / k
    start = [CASE["x_0"] + sag, CASE["v_0"]]
    found = solve_ivp(
        lambda _, y: [y[1], g - k / m * y[0]], (0, data["t"][-1]), start, t_eval=data["t"], rtol=1e-11, atol=1e-13
    )
    stretch, speed = found.y
    np.testing.assert_allclose(data["x"], stretch - sag, atol=1e-9)
    np.testing.assert_allclose(data["T"], m * speed**2 / 2, atol=1e-9)
    spring, gravity = k * stretch**2 / 2, -m * g * (stretch - sag)
    shift = 0.0 if datum == "separate" else k * sag**2 / 2
    np.testing.assert_allclose(data["V"], spring + gravity - shift, atol=1e-9)
    np.testing.assert_allclose(data["T"] + data["V"], columns(scene, "time")["total"][0], rtol=1e-14)
    if datum == "separate":
        np.testing.assert_allclose(data["spring"], spring, atol=1e-9)
        np.testing.assert_allclose(data["gravity"], gravity, atol=1e-9)


def test_gravity_moves_the_equilibrium_and_nothing_else() -> None:
    scene = Energy()
    motion, values = columns(scene), scene.shown.values
    for slug, (_, g) in PLANETS.items():
        scene.set(scene.action(slug))
        assert scene.g == g
        assert scene.shown.scalars[f"here_{slug}"] == 1.0
        for name in ("x", "T", "V"):
            np.testing.assert_array_equal(columns(scene)[name], motion[name])
        assert scene.shown.values["omega"] == values["omega"]
        delta = scene.m * g / scene.k
        assert -scene.shown.scalars["natural"] == pytest.approx(delta)


def test_other_planets_are_marked_where_the_mass_would_hang() -> None:
    scalars = Energy().shown.scalars
    assert scalars["planet1"] - scalars["natural"] == pytest.approx(3.71 / 39.4)
    assert scalars["planet0"] - scalars["natural"] == pytest.approx(1.62 / 39.4)


def test_the_button_of_the_planet_in_force_is_known() -> None:
    scene = Energy()
    assert scene.here() == ["earth"]
    scene.set(scene.action("jupiter"))
    assert scene.here() == ["jupiter"]
    scene.g = 10.0
    assert scene.here() == []
