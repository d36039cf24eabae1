"""Scene coupled through its callbacks: set a parameter, read the data sources."""

from __future__ import annotations

import math

import numpy as np
import pytest

from components.scenes.coupled import Coupled
from tests.page.scripts import values_of


@pytest.mark.parametrize(
    "values", [{"k2": 5.0}, {"m1": 10.0, "x1_0": -2.0}, {"x2_0": 2.0, "v1_0": 5.0}, {"k1": 0.0, "v1_0": 3.0}]
)
def test_blocks_never_meet(values: dict[str, float]) -> None:
    from components.chain import EQUILIBRIUM, WALL

    scene = Coupled(**values)
    data, scalars = scene.sources["time"].data, scene.shown.scalars
    metre = scalars["metre"] * 10.0 ** -scene.shown.axes["x"].exponent
    one, two = (EQUILIBRIUM[i] + metre * data[f"x{i + 1}"] for i in (0, 1))
    assert np.all(one - scalars["side1"] / 2 > WALL)
    assert np.all(two - one > (scalars["side1"] + scalars["side2"]) / 2)
    assert np.all(two + scalars["side2"] / 2 <= 1)


def test_the_clock_plays_a_slow_period_in_four_to_ten_seconds() -> None:
    for values in ({}, {"k1": 1e-6, "k2": 1e-6}, {"m1": 1e-9, "m2": 1e-9}, {"k1": 0.0}):
        scene = Coupled(**values)
        slow, fast = (sum(one.omega for one in scene.shown.signals[name].sines) for name in ("x1_slow", "x1_fast"))
        unit = 10.0 ** scene.shown.axes["t"].exponent
        assert 4 <= 2 * math.pi / (slow or fast) * unit / scene.shown.pace.auto <= 10 + 1e-9


def test_labels_are_on_the_directions_inside_the_plane() -> None:
    for values in ({}, {"k2": 0.0}, {"m1": 10.0, "m2": 0.1, "k1": 10.0, "k2": 1.0}):
        scene = Coupled(**values)
        scalars, axis = scene.shown.scalars, scene.shown.axes["x"]
        for mode in ("slow", "fast"):
            x, y = scalars[f"{mode}_name1"], scalars[f"{mode}_name2"]
            lines = scene.sources["modes"].data
            assert x * lines[f"{mode}2"][1] == pytest.approx(y * lines[f"{mode}1"][1])
            assert all(axis.place(axis.start) < at < axis.place(axis.end) for at in (x, y))


def test_forces_are_the_springs_pull() -> None:
    scene = Coupled(view="forces", x1_0=0.4, x2_0=0.8)
    now = values_of(scene.shown.signals, scene.shown.scalars, 0.0)
    np.testing.assert_allclose([now["F1"], now["F2"]], [-4 * 0.4 - 2 * (0.4 - 0.8), 2 * (0.4 - 0.8)])
