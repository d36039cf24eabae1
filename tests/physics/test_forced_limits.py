"""The driven chain without a drive, on long curves, at the edge of the range, and against an integrator."""

import numpy as np
import pytest

from physics.coupled import TwoMassChain, free_motion
from physics.forced import (
    forced_motion,
    particular_solution,
)

LECTURE = TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0)


@pytest.mark.parametrize(("F_0", "omega"), [(0.0, 1.0), (0.0, 0.3), (5.0, 0.0)])
def test_no_force_is_the_free_motion(F_0, omega):
    t = np.linspace(0.0, 9.0, 30)
    driven = forced_motion(LECTURE, F_0, omega, t, (1.0, 0.5), (0.25, -0.5))
    assert np.array_equal(driven.x, free_motion(LECTURE, (1.0, 0.5), (0.25, -0.5), t).x)
    assert np.all(particular_solution(LECTURE, 0.0, [0.0, 1.0, 3.0]) == 0.0)


def test_a_long_curve_is_the_same_as_its_points():
    omega = np.linspace(0.0, 5.0, 401)
    curve = particular_solution(LECTURE, 2.0, omega)
    points = np.array([particular_solution(LECTURE, 2.0, w) for w in omega]).T
    resonant = np.isinf(points)
    assert np.array_equal(np.isinf(curve), resonant) and np.count_nonzero(resonant) == 4
    curve, points = curve[~resonant], points[~resonant]
    assert np.all(np.abs(curve - points) <= 2 * np.spacing(np.abs(points)))


def test_a_curve_at_the_edge_of_the_range():
    chain = TwoMassChain(m1=1e-300, m2=1e-290, k1=1e-295, k2=1e-305)
    curve = particular_solution(chain, 1e-300, [0.0, 1e-10, 1e3, 1e200])
    for n, omega in enumerate((0.0, 1e-10, 1e3, 1e200)):
        assert curve[:, n].tolist() == particular_solution(chain, 1e-300, omega).tolist()
    assert particular_solution(chain, 1e-300, []).shape == (2, 0)
