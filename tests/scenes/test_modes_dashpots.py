"""Scene modes with dashpots: the arrows of Solve leave the line exactly where c1 k2 is not c2 k1."""

from __future__ import annotations

import cmath
import itertools
import math

import numpy as np
import pytest

from components.scenes.forced import Forced
from components.scenes.modes import ModesScene
from components.state.shared_system import brought, taken_along
from physics.braked_modes import braked_modes, in_line
from physics.coupled import TwoMassChain
from tests.page.scripts import played

CHAINS = [
    (2.0, 1.0, 4.0, 2.0),
    (0.7, 3.0, 1.0, 5.0),
    (1.0, 0.04, 0.96, 0.04),
    (1.0, 1.0, 0.0, 2.0),
    (1.0, 1.0, 2.0, 0.0),
]
DASHPOTS = [*itertools.product((0.0, 1e-9, 0.05, 3.0), (0.0, 1e-9, 0.1, 3.0)), (1e12, 1.0), (1.0, 1e12)]


def scenes(c1: float, c2: float) -> list[ModesScene]:
    names = ("m1", "m2", "k1", "k2")
    return [ModesScene(task="solve", c1=c1, c2=c2, **dict(zip(names, chain, strict=True))) for chain in CHAINS]


@pytest.mark.parametrize(("c1", "c2"), [pair for pair in DASHPOTS if any(pair)])
def test_each_mode_obeys_newtons_laws_and_the_sentence_says_how_its_arrows_stand(c1: float, c2: float) -> None:
    for scene in scenes(c1, c2):
        chain = TwoMassChain(m1=scene.m1, m2=scene.m2, k1=scene.k1, k2=scene.k2)
        both = braked_modes(chain, c1, c2)
        for one in both:
            (X1, X2), s = one.shape, one.exponents[0]
            link = (scene.k2 + c2 * s) * (X1 - X2)
            parts = [scene.m1 * s * s * X1, (scene.k1 + c1 * s) * X1, link, scene.m2 * s * s * X2]
            size = sum(map(abs, parts)) + (scene.k2 + abs(c2 * s)) * (abs(X1) + abs(X2))
            assert abs(parts[0] + parts[1] + parts[2]) <= 1e-12 * size and abs(parts[3] - parts[2]) <= 1e-12 * size
            assert s.real <= 0 and math.isclose(max(abs(X1), abs(X2)), 1.0, rel_tol=1e-15)
        said = scene.shown.forms["arrows"]
        if not all(one.swings for one in both):
            assert said == "creeps"
            continue
        off = [abs(math.sin(cmath.phase(X2 / X1))) for X1, X2 in (one.shape for one in both) if X1 and X2]
        assert said == ("line" if in_line(chain, c1, c2) else "apart")
        assert all((angle < 1e-15) == (said == "line") for angle in off)


def test_the_arrows_wind_inward_at_a_constant_angle() -> None:
    """As the browser plays them, by the slow mode's numbers of LECTURE-BEYOND 3.4."""
    scene = ModesScene(task="solve", c2=0.2)
    sizes, angles = [], []
    for t in (0.0, 3.0, 11.0):
        now = played(scene.shown, t * 10.0 ** -scene.shown.axes["t"].exponent)
        one, two = (complex(float(now[f"x{i}_slow"]), float(now[f"y{i}_slow"])) for i in (1, 2))
        sizes.append(abs(one))
        angles.append(math.degrees(cmath.phase(two / one)))
    assert angles == pytest.approx([-3.8082] * 3, abs=1e-3)
    assert sizes[1] / sizes[0] == pytest.approx(math.exp(-0.0166003 * 3), rel=1e-5)
    assert np.all(np.diff(sizes) < 0)
    assert scene.shown.values["slow_ratio"] == "1.99 at −3.81°" and scene.shown.values["slow_angle"] == "3.81"


@pytest.mark.parametrize("task", ["guess", "sweep", "hunt"])
def test_the_other_views_say_that_they_leave_the_dashpots_out(task: str) -> None:
    assert any("without the dashpots" in note for note in ModesScene(task=task, c1=0.1).shown.notes)
    assert not any("dashpots" in note for note in ModesScene(task=task).shown.notes)


def test_dashpots_go_along_with_the_chain() -> None:
    shared = taken_along(Forced(c1=0.3, c2=0.1), {})
    assert {"c1": 0.3, "c2": 0.1}.items() <= brought(ModesScene, shared).items()


@pytest.mark.parametrize(("c1", "c2"), [(0.4, 0.2), (0.2, 0.0), (0.0, 3.0), (1e12, 1.0)])
def test_about_these_numbers_checks_the_exponents(c1: float, c2: float) -> None:
    for scene in scenes(c1, c2):
        for table in scene.about(scene.shown).tables:
            assert table.rows and all(row.off <= table.limit for row in table.rows), (scene.values, table)
