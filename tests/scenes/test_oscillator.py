"""Scene oscillator: the turning arrow, its lead, and its ticks."""

from __future__ import annotations

import math

import numpy as np
import pytest

from components.scenes.oscillator import OscillatorScene
from tests.page.scripts import played
from tests.scenes.checks import columns


@pytest.mark.parametrize("x_0, v_0", [(0.1, -0.8), (-0.1, -0.8), (0.15, 0.0), (0.0, 0.8)])
def test_the_tip_of_the_arrow_is_on_the_level_of_x(x_0: float, v_0: float) -> None:
    scene = OscillatorScene(x_0=x_0, v_0=v_0)
    omega, shown = math.sqrt(scene.k / scene.m), scene.shown
    now = played(shown, columns(scene)["t"] / 10.0 ** shown.axes["t"].exponent)
    C = math.hypot(x_0, v_0 / omega)
    np.testing.assert_allclose(C * now["sine"], columns(scene)["x"], atol=1e-12)
    np.testing.assert_allclose(C * now["cosine"], columns(scene)["v"] / omega, atol=1e-12)


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
