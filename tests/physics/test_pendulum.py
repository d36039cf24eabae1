"""Pendulum against Jacobi functions in arbitrary precision, up to the last double below pi."""

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.pendulum import Pendulum, amplitude_at_excess, excess
from physics.reference.single import period_ratio, swing
from tests.grids import tries

U = 2.0**-53
LAST = math.nextafter(math.pi, 0)
AMPLITUDES = (0.0, 1e-300, 1e-9, 0.1, 1.0, -2.0, 3.0, 3.14, 3.141592, math.pi - 1e-10, LAST, math.pi)
amplitudes = pytest.mark.parametrize("theta_0", AMPLITUDES)


@amplitudes
@pytest.mark.parametrize("periods", [1.0, 1e12])
def test_motion_within_4_u_of_its_amplitudes(theta_0, periods):
    pendulum = Pendulum(l=1.3, g=9.81)
    t = np.random.default_rng(7).uniform(0, periods * pendulum.period(theta_0), 40)
    motion = pendulum.motion(theta_0, t)
    with mp.workdps(60 if abs(theta_0) > 1e-100 else 640):
        omega = mp.sqrt(mp.mpf(9.81) / mp.mpf(1.3))
        fastest = 2 * omega * mp.sin(abs(mp.mpf(theta_0)) / 2)
        strongest = omega**2 * (mp.sin(abs(theta_0)) if abs(theta_0) < math.pi / 2 else 1)
        for i, time in enumerate(t):
            theta, rate, acceleration = swing(mp, omega, theta_0, mp.mpf(float(time)))
            assert abs(motion.theta[i] - theta) <= 4 * U * abs(theta_0)
            assert abs(motion.theta_dot[i] - rate) <= 4 * U * fastest
            assert abs(motion.theta_ddot[i] - acceleration) <= 6 * U * strongest


@settings(max_examples=tries(300))
@given(st.one_of(st.floats(1e-140, math.pi), st.floats(0, 40).map(lambda n: math.pi - 2.0**-n)))
def test_period_and_excess_are_rounded_once(theta_0):
    with mp.workdps(340):
        ratio = period_ratio(mp, theta_0)
        assert abs(excess(theta_0) - (ratio - 1)) <= 0.51 * math.ulp(excess(theta_0))
        period = Pendulum(l=2.0, g=3.0).period(theta_0)
        assert abs(period - 2 * mp.pi * mp.sqrt(mp.mpf(2) / 3) * ratio) <= 0.51 * math.ulp(period)


@pytest.mark.parametrize("theta_0", [0.0, 1e-150, 1e-9, 0.01, 1.0, 3.0, 3.14159, math.pi])
def test_amplitude_is_the_inverse_of_excess(theta_0):
    """The largest excess belongs to the last double below pi."""
    condition = 3 if theta_0 < 2 else 1e-15 / max(math.pi - theta_0, 1e-15) / U
    found = amplitude_at_excess(excess(theta_0))
    assert found == (theta_0 if theta_0 in (0.0, math.pi) else pytest.approx(theta_0, rel=condition * U))


def test_at_rest_it_stays():
    rest = Pendulum(l=1.0, g=9.81).motion(0.0, [0.0, 1.0])
    assert not np.any([rest.theta, rest.theta_dot, rest.theta_ddot])
