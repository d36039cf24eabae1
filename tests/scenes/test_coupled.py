"""Scene coupled: what its stage and plane draw, and its start given by modes, there and back to the last digits."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.chain import EQUILIBRIUM, WALL
from components.chain import of_scene as chain_of
from components.scenes import SCENES
from components.scenes.coupled import Coupled
from physics.coupled import TwoMassChain, free_modes
from physics.modal_start import amplitudes_and_phases, modes_given, start_given
from tests.grids import tries
from tests.page.hand import Hand, grabs
from tests.page.headless_page import Page, say, set_values


@pytest.mark.parametrize(
    "values", [{"k2": 5.0}, {"m1": 10.0, "x1_0": -2.0}, {"x2_0": 2.0, "v1_0": 5.0}, {"k1": 0.0, "v1_0": 3.0}]
)
def test_blocks_never_meet(values: dict[str, float]) -> None:
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


U = 2.0**-53


@pytest.mark.parametrize("values", [{}, {"k2": 0.0}, {"m1": 10.0, "m2": 0.1, "k1": 10.0, "k2": 1.0}])
def test_labels_are_on_the_directions_inside_the_plane(values: dict[str, float]) -> None:
    scene = Coupled(**values)
    scalars, axis, lines = scene.shown.scalars, scene.shown.axes["x"], scene.sources["modes"].data
    for mode in ("slow", "fast"):
        x, y = scalars[f"{mode}_name1"], scalars[f"{mode}_name2"]
        assert x * lines[f"{mode}2"][1] == pytest.approx(y * lines[f"{mode}1"][1])
        assert all(axis.place(axis.start) < at < axis.place(axis.end) for at in (x, y))


SIZE, TWO_SIZES = st.floats(-6, 6).map(lambda power: 10**power), st.tuples(*2 * (st.floats(0.01, 2),))
TWO_PHASES = st.tuples(*2 * (st.integers(-3000, 3000).map(lambda one: one / 1000),))


@settings(max_examples=tries(120))
@given(SIZE, SIZE, SIZE, SIZE | st.just(0.0), TWO_SIZES, TWO_PHASES)
def test_a_motion_by_its_modes_comes_back_to_the_last_digits(
    m1: float, m2: float, k1: float, k2: float, sizes: tuple[float, float], phases: tuple[float, float]
) -> None:
    chain = TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2)
    free = modes_given(chain, sizes, phases)
    back = amplitudes_and_phases(free)
    for j, omega in enumerate(chain.modes().omega):
        assert back[0][j] == pytest.approx(sizes[j] if omega else abs(sizes[j] * math.sin(phases[j])), rel=4 * U)
        assert not omega or abs(phases[j] - back[1][j]) < 4 * U * math.pi
    x_0, v_0 = start_given(free)
    for i in (0, 1):
        shape = [float(mode.shape[i]) for mode in chain.exact_modes]
        with mp.workdps(60):
            parts = [A * mp.sin(mp.mpf(phi)) * s for A, phi, s in zip(sizes, phases, shape, strict=True)]
            assert abs(x_0[i] - sum(parts)) <= 2 * U * sum(abs(part) for part in parts)
    again = free_modes(chain, x_0, v_0)
    reach = np.abs(free.amplitude).sum() + np.abs(again.amplitude).sum()
    assert np.abs(again.amplitude - free.amplitude).max() <= 1e-9 * reach


def test_the_choice_changes_nothing_and_leads_back_exactly() -> None:
    start = {"x1_0": 0.37, "x2_0": -0.2, "v1_0": 1 / 3, "k2": 0.77}
    page = Page(SCENES["coupled"](**start))
    before = page.opening()
    told = say(page, "choose", name="given_by", value="modes")
    assert told["errors"] == {} and told["view"]["forms"]["given_by_modes"] == "shown"
    for name in ("x1", "x2_fast"):
        one, other = (view["view"]["columns"]["time"][name] for view in (before, told))
        assert np.abs(one - other).max() < 1e-4
    told = say(page, "choose", name="given_by", value="values")
    assert {name: told["state"]["parameters"][name] for name in start} == start


LABEL = "Slow mode, start, by mass 1"


def test_a_hand_on_a_mode_sets_its_amplitude_and_phase_and_the_other_goes_on() -> None:
    page = Page(SCENES["coupled"]())
    set_values(page, X_slow=0.5, X_fast=0.1 + 0.2, phi_slow=0.3, phi_fast=1.1)
    _, shape = (shape for shape, grab in grabs(SCENES["coupled"]) if grab.label == LABEL)
    slow, fast = chain_of(page.scene).modes().omega
    turned = 1.1 + 0.7 * fast
    told = say(page, "set", values=Hand(page.now, shape, wide=True, t=0.7).take(), holding=True)
    scene = page.scene
    assert told["errors"] == {} and scene.values["given_by"] == "modes"
    assert scene.X_fast == 0.1 + 0.2 and scene.phi_fast == pytest.approx(math.remainder(turned, 2 * math.pi), rel=1e-14)
    assert scene.X_slow == pytest.approx(0.5 * abs(math.sin(0.3 + 0.7 * slow)), abs=0.005)
    assert scene.phi_slow == math.pi / 2
    say(page, "set", values={"phi_slow": -math.pi / 2}, holding=False)
    scene = page.scene
    assert scene.X_fast == 0.1 + 0.2 and scene.x1_0 == pytest.approx(0.3 * math.sin(turned) - scene.X_slow)


def test_a_drift_is_not_given_by_a_phase() -> None:
    page = Page(SCENES["coupled"](k1=0.0, v1_0=0.5))
    told = say(page, "choose", name="given_by", value="modes")
    assert "A drift has no amplitude and no phase" in told["errors"]["given_by"]
    assert "given_by" not in told["state"]["parameters"]
    page = Page(SCENES["coupled"](k1=0.0))
    assert say(page, "choose", name="given_by", value="modes")["errors"] == {}
