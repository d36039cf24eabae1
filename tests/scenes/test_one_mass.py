"""Scenes with one mass: the arrow of the oscillator, gravity in energy, and the dashpot of damped."""

from __future__ import annotations

import math

import numpy as np
import pytest

from components.scenes import SCENES
from components.scenes.energy import Energy
from components.scenes.energy.case import PLANETS
from components.scenes.oscillator import OscillatorScene
from physics.damped import DampedOscillator
from tests.page.scripts import played
from tests.scenes.checks import columns

DAMPED = SCENES["damped"]


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


def test_gravity_moves_the_equilibrium_and_nothing_else() -> None:
    scene = Energy()
    motion, omega, hang = columns(scene), scene.shown.values["omega"], scene.m / scene.k
    assert scene.here() == ["earth"]
    for slug, (_, g) in PLANETS.items():
        scene.set(scene.action(slug))
        scalars = scene.shown.scalars
        assert (scene.here(), scene.g, scalars[f"here_{slug}"], scene.shown.values["omega"]) == ([slug], g, 1.0, omega)
        for name in ("x", "T", "V"):
            np.testing.assert_array_equal(columns(scene)[name], motion[name])
        assert -scalars["natural"] == pytest.approx(hang * g)
    others = Energy().shown.scalars
    assert [others[f"planet{i}"] - others["natural"] for i in (0, 1)] == pytest.approx([1.62 * hang, 3.71 * hang])
    scene.g = 10.0
    assert scene.here() == []


def test_c_and_zeta_are_one_quantity() -> None:
    scene = DAMPED(zeta=0.5)
    assert scene.c == pytest.approx(math.sqrt(39.48)) and scene.zeta == 0.5
    scene.c = 2 * math.sqrt(39.48)
    assert scene.zeta == pytest.approx(1.0)
    scene.m = 4.0
    assert scene.zeta == pytest.approx(0.5), "c is kept"
    scene.keep = "zeta"
    scene.k = 4 * 39.48
    assert scene.zeta == pytest.approx(0.5) and scene.c == pytest.approx(4 * math.sqrt(39.48)), "zeta is kept"
    assert "zeta" in scene.value.off_default() and "c" not in scene.value.off_default()
    given = [{"zeta": 1.0}, {"zeta": 1.0, "c": 12.566622, "keep": "c"}, {"zeta": 1.0, "c": 3.0, "keep": "zeta"}]
    assert all(DAMPED.at(one).c == pytest.approx(12.566622) for one in given), "by a link"


@pytest.mark.parametrize("zeta", [0.02, 0.1, 0.306, 0.49, 0.51, 0.9, 1.5])
@pytest.mark.parametrize("start", [{}, {"v_0": 2.0}, {"v_0": -0.1}, {"x_0": 0.0, "v_0": 1.0}])
def test_the_power_is_greatest_where_it_is_said_to_be(zeta: float, start: dict[str, float]) -> None:
    """Before x = 0 on its way there, but not close to it: with much damping halfway."""
    scene = DAMPED(zeta=zeta, **start)
    t = np.linspace(0.0, 5.0, 50_001)
    motion = DampedOscillator(m=scene.m, c=scene.c, k=scene.k).motion(scene.x_0, scene.v_0, t)
    top = int(np.argmax(np.abs(motion.v)))
    at = scene.shown.forms["fastest"]
    assert (at == "at_start") == (top == 0)
    if at == "before":
        assert motion.x[top] * motion.v[top] < 0 and (motion.x[top:] * motion.x[top] < 0).any()
