"""The motion from its start as the absorber's scene draws it, against every digit of it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from components.scenes.absorber.case import AbsorberCase
from components.scenes.absorber.curves import DRAWN, moved, reach_alone, times

MACHINE = {"m1": 100.0, "k1": 250e3, "F_0": 500.0, "omega": 48.0, "m2": 16.0, "k2": 36864.0, "from_rest": True}
CASES: list[dict[str, Any]] = [
    {},
    {"x_0": (1e-3, -2e-3), "v_0": (0.1, 0.0)},
    {"k2": 0.0, "v_0": (0.0, 0.3)},
    {"omega": 1.0},
    {"c": 100.0},
    {"c": 1e4, "x_0": (1e-3, 0.0)},
    {"c": 1e-3},
]


@pytest.mark.parametrize("end", [1e-3, 1.0, 40.0])
@pytest.mark.parametrize("values", CASES, ids=str)
def test_what_is_drawn_is_the_motion(values: dict[str, Any], end: float) -> None:
    """In the shortest window x2 is a small difference of its parts."""
    case = AbsorberCase(**{**MACHINE, **values})
    found = moved(case, times(case, end))
    motion = case.damped.motion(found.t) if case.c else case.driven.motion(found.t)
    for row, true in zip(found.x, (*motion.x, motion.e[1]), strict=True):
        np.testing.assert_allclose(row, true, rtol=0.0, atol=DRAWN * np.abs(true).max())
    assert found.x[:2, 0].tolist() == list(case.x_0)


@pytest.mark.parametrize("values", [case for case in CASES if "c" not in case], ids=str)
def test_without_damping_both_parts_are_the_ones_of_the_physics(values: dict[str, Any]) -> None:
    case = AbsorberCase(**{**MACHINE, **values})
    found = moved(case, times(case, 1.0))
    assert found.particular is not None and found.complementary is not None
    for row in (0, 1):
        for part, true in (
            (found.particular, case.driven.particular_motion(found.t)),
            (found.complementary, case.driven.complementary(found.t)),
        ):
            np.testing.assert_allclose(part[row], true[row], rtol=0.0, atol=1e-13 * max(np.abs(true[row]).max(), 1e-9))


@pytest.mark.parametrize("omega", [48.0, 50.0])
def test_the_machine_alone_reaches_as_far_as_it_moves(omega: float) -> None:
    """At 50 rad/s it grows."""
    case = AbsorberCase(**{**MACHINE, "omega": omega})
    x = case.bare.motion(moved(case, times(case, 1.0)).t).x[0]
    assert reach_alone(case, 1.0) == pytest.approx(np.abs(x).max(), rel=1e-12)
