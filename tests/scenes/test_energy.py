"""Scene energy: gravity moves the equilibrium and nothing else, and the buttons of the planets."""

from __future__ import annotations

import numpy as np
import pytest

from components.scenes.energy import Energy
from components.scenes.energy.case import PLANETS
from tests.scenes.checks import columns


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
