"""Scene coupled through its callbacks: set a parameter, read the data sources."""

from __future__ import annotations

import math

import numpy as np
import pytest

from components.quantities.formatting import signed, three
from components.scenes.coupled import Coupled
from physics.coupled import TwoMassChain, free_modes
from tests.page.scripts import values_of

EDGES = ("zero", "T1", "T1_V1", "T1_V1_V2", "T1_V1_V2_T2")
"""The edges of the energies in their stack."""


def test_energies_are_stacked_to_a_flat_top() -> None:
    data = Coupled(v1_0=1.0).sources["time"].data
    edges = np.array([data[name] for name in EDGES])
    assert np.all(np.diff(edges, axis=0) >= 0)
    np.testing.assert_allclose(edges[-1], edges[-1, 0], rtol=1e-14)


def test_energies_of_the_modes_are_two_flat_lines() -> None:
    scene = Coupled(energy="modes")
    flat = scene.sources["time"].data
    np.testing.assert_allclose([flat["E_slow"], flat["E_fast"]], [[1 / 3] * 301, [8 / 3] * 301], rtol=1e-14)
    assert "T1" not in scene.sources["time"].data


def test_beats_exchange_all_energy() -> None:
    scene = Coupled()
    scene.set(Coupled.presets["Beats"])
    data = scene.sources["time"].data
    assert data["t"][-1] == pytest.approx(4 * math.pi / (math.sqrt(1.2) - math.sqrt(0.8)))
    first = data["T1_V1"]
    assert first.min() < 0.02 * first.max()
    assert np.abs(data["x2"]).max() == pytest.approx(5 * np.abs(data["x1"]).max(), rel=0.02)


def test_no_wall_is_a_drift() -> None:
    scene = Coupled(k1=0.0, v1_0=0.3, v2_0=0.3, view="formulas")
    shown = scene.shown
    assert shown.forms["x1_slow"] == "drift"
    data = scene.sources["time"].data
    centre = (scene.m1 * data["x1"] + scene.m2 * data["x2"]) / (scene.m1 + scene.m2)
    np.testing.assert_allclose(np.diff(centre) / np.diff(data["t"]), 0.3, rtol=1e-9)


def test_a_motion_too_fast_to_draw_is_its_envelope() -> None:
    scene = Coupled(k2=1e8)
    band, time = scene.sources["band"].data, scene.sources["time"].data
    assert "x1" not in time
    assert "x1_slow" in time
    free = free_modes(TwoMassChain(m1=2, m2=1, k1=4, k2=1e8), (1, 0), (0, 0))
    t = np.linspace(0, band["t"][-1], 20_011)
    slow, fast = free.parts(t)
    x1 = (slow + fast).x[0]
    low, high = (np.interp(t, band["t"], band[name]) for name in ("x1_lo", "x1_hi"))
    assert np.all(x1 >= low - 2e-3) and np.all(x1 <= high + 2e-3)
    assert x1.max() > high.max() - 0.01 and x1.min() < low.min() + 0.01
    assert any("band" in note for note in scene.shown.notes)
    edges = np.array([time[name] for name in EDGES])
    np.testing.assert_allclose(edges[-1], edges[-1, 0], rtol=1e-9)


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


def test_without_any_spring_both_drifts_are_told_as_one() -> None:
    scene = Coupled(k1=0.0, k2=0.0, v1_0=1.0)
    columns = scene.sources["time"].data
    np.testing.assert_array_equal(columns["x1_slow"], columns["x1"])
    assert "x1_fast" not in columns and scene.shown.forms["x1_fast"] == ""
    assert scene.shown.forms["slow_omega"] == "two"


@pytest.mark.parametrize("label", ["Slow", "Fast"])
def test_one_mode_alone_has_no_beat(label: str) -> None:
    scene = Coupled()
    scene.set(Coupled.presets[label])
    assert (scene.shown.forms["beat"], scene.shown.values["beat_period"]) == ("one", "none")
    scene.set({"v1_0": 0.5})
    assert (scene.shown.forms["beat"], scene.shown.values["beat_period"]) == ("apart", "none")


def test_a_drift_has_no_beat() -> None:
    assert Coupled(k1=0.0).shown.forms["beat"] == "drift"


def test_four_constants_follow_from_four_starting_values() -> None:
    """M = m1 + m2 r^2 is 6 and 3 kg; X sin(phi) and omega X cos(phi) are the start, weighed by the shape."""
    scene = Coupled(x1_0=0.5, x2_0=-0.4, v1_0=1.0, v2_0=0.3, view="formulas")
    values = scene.shown.values
    assert (values["M_minus"], values["M_plus"]) == ("6.00", "3.00")
    for name, r, M in (("minus", 2.0, 6.0), ("plus", -1.0, 3.0)):
        assert values[f"q_{name}"] == signed((2 * 0.5 + r * -0.4) / M)
        assert values[f"rate_{name}"] == signed((2 * 1.0 + r * 0.3) / M)
    free = free_modes(TwoMassChain(m1=2, m2=1, k1=4, k2=2), (0.5, -0.4), (1.0, 0.3))
    energies = [M * (w * X) ** 2 / 2 for M, w, X in zip((6, 3), free.omega, free.amplitude[:, 0], strict=True)]
    assert [values["E_minus"], values["E_plus"]] == [three(energy) for energy in energies]


def test_without_the_spring_between_the_constants_are_each_masss_own() -> None:
    assert Coupled(k2=0.0).shown.forms["constants"] == "loose"


def test_names_stand_on_the_directions_inside_the_plane() -> None:
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
    assert scene.shown.values["force_unit"] == "N" and "F1" not in Coupled().shown.signals
