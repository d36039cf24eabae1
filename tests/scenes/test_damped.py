"""The damped mass: c and zeta as one quantity, and where its power is greatest."""

from __future__ import annotations

import math

import numpy as np
import pytest

from components.scenes import SCENES
from physics.damped import DampedOscillator

DAMPED = SCENES["damped"]


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
