"""A mass between two walls."""

import numpy as np
import pytest

from components.scenes import SCENES


@pytest.mark.parametrize(("k1", "k2"), [(2.0, 2.0), (4.0, 0.1), (0.1, 4.0)])
def test_the_stiffnesses_add(k1: float, k2: float) -> None:
    scene = SCENES["walls"](m=2.0, k1=k1, k2=k2, x_0=0.5)
    time = scene.sources["time"].data
    np.testing.assert_allclose(time["x"], 0.5 * np.cos(np.sqrt((k1 + k2) / 2.0) * time["t"]), atol=1e-12)
    assert scene.numbers["k"].value == k1 + k2


def test_the_springs_may_be_exchanged() -> None:
    one, other = (SCENES["walls"](k1=a, k2=b).sources["time"].data["x"] for a, b in ((3.0, 0.5), (0.5, 3.0)))
    np.testing.assert_array_equal(one, other)


def test_a_motion_too_fast_to_draw_is_a_band_and_its_energies_are_means() -> None:
    scene = SCENES["walls"](k1=3.0, k2=1.0, x_0=0.5, window=1e4)
    np.testing.assert_allclose(scene.shown.sources["band"]["x_hi"], 0.5)
    energies = scene.shown.sources["time"]
    np.testing.assert_allclose(energies["V1_V2"], 0.25 * 4.0 * 0.5**2)
