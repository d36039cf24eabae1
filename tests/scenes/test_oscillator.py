"""Scene oscillator through its callbacks: the turning arrow, the solution written both ways, and its limits."""

from __future__ import annotations

import math

import numpy as np
import pytest

from components.scenes.oscillator import OscillatorScene
from tests.page.scripts import played
from tests.scenes.checks import columns

starts = pytest.mark.parametrize(
    "x_0, v_0", [(0.1, -0.8), (0.1, 0.8), (-0.1, -0.8), (-0.2, 0.3), (0.15, 0.0), (0.0, 0.8)]
)


def signal(scene: OscillatorScene, name: str, t: np.ndarray) -> np.ndarray:
    """A signal at times in s, in SI units, as the browser evaluates it."""
    axes = scene.shown.axes
    size = 10.0 ** axes[name].exponent if name in axes else 1.0
    return size * played(scene.shown, t / 10.0 ** axes["t"].exponent)[name]


@starts
def test_the_tip_of_the_arrow_is_on_the_level_of_x(x_0: float, v_0: float) -> None:
    scene = OscillatorScene(x_0=x_0, v_0=v_0)
    t = columns(scene)["t"]
    C = math.hypot(x_0, v_0 / math.sqrt(scene.k / scene.m))
    np.testing.assert_allclose(C * signal(scene, "sine", t), columns(scene)["x"], atol=1e-12)
    omega = math.sqrt(scene.k / scene.m)
    np.testing.assert_allclose(C * signal(scene, "cosine", t), columns(scene)["v"] / omega, atol=1e-12)


def test_marks_of_the_lead_stand_on_peaks_a_quarter_period_apart() -> None:
    scene = OscillatorScene(m=0.3, k=5.0, x_0=-0.1, v_0=0.4)
    scalars, data = scene.shown.scalars, columns(scene)
    quarter = math.pi / 2 / math.sqrt(5.0 / 0.3)
    for i, name in enumerate("xva"):
        peak = scalars[f"peak_{name}"]
        assert np.interp(peak, data["t"], data[name]) == pytest.approx(scalars[f"top_{name}"], rel=2e-3)
        assert scalars["peak_x"] - peak == pytest.approx(i * quarter, rel=1e-12)


def test_ticks_are_the_amplitudes_and_the_planes_share_them() -> None:
    scene = OscillatorScene(m=1.0, k=4.0, x_0=0.3, v_0=0.8)
    axes, loop = scene.shown.axes, columns(scene, "loop")
    for name, amplitude in (("x", 0.5), ("v", 1.0), ("a", 2.0)):
        np.testing.assert_allclose(axes[name].ticks, [-amplitude, 0, amplitude], rtol=1e-14)
        assert np.abs(loop[name]).max() == pytest.approx(amplitude, rel=1e-3)
    np.testing.assert_allclose(loop["a"], -4.0 * loop["x"], atol=1e-14)
    np.testing.assert_allclose((loop["x"] / 0.5) ** 2 + loop["v"] ** 2, 1.0, rtol=1e-13)


def test_the_force_on_demand_is_minus_k_x() -> None:
    scene = OscillatorScene(view="force", k=1e5, x_0=0.2, v_0=0.0)
    assert played(scene.shown, 0.0)["F"] == pytest.approx(-20.0)  # kN
