"""Pendulum against Jacobi functions in arbitrary precision, up to the last double below pi."""

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from physics.pendulum import Pendulum, amplitude_at_excess, excess
from physics.reference.single import period_ratio, swing
from tests.grids import tries

U = 2.0**-53
LAST = math.nextafter(math.pi, 0)
AMPLITUDES = (1e-300, 1e-9, 0.1, 1.0, -2.0, 3.0, 3.14, 3.141592, math.pi - 1e-10, LAST, math.pi)
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


@pytest.mark.parametrize(("percent", "degrees"), [(0.1, 7.2441), (1.0, 22.8138), (5.0, 50.1040), (10.0, 69.3251)])
def test_amplitudes_at_which_the_period_is_off(percent, degrees):
    assert math.degrees(amplitude_at_excess(percent / 100)) == pytest.approx(degrees, abs=5e-5)


@pytest.mark.parametrize("theta_0", [1e-150, 1e-9, 0.01, 1.0, 3.0, 3.14159])
def test_amplitude_is_the_inverse_of_excess(theta_0):
    condition = 3 if theta_0 < 2 else 1e-15 / (math.pi - theta_0) / U
    assert amplitude_at_excess(excess(theta_0)) == pytest.approx(theta_0, rel=condition * U)


def test_the_largest_excess_belongs_to_the_last_double():
    assert amplitude_at_excess(excess(math.pi)) == math.pi
    assert amplitude_at_excess(0.0) == 0.0
    for wanted in (-1e-3, 1.001 * excess(math.pi), math.nan):
        with pytest.raises(ValueError, match="T/T_0 - 1"):
            amplitude_at_excess(wanted)


@pytest.mark.parametrize("theta_0", [0.2, 2.0, 3.1])
def test_motion_against_an_independent_solver(theta_0):
    t = np.linspace(0, 20, 200)
    motion = Pendulum(l=0.7, g=9.81).motion(theta_0, t)
    other = solve_ivp(
        lambda _, y: (y[1], -9.81 / 0.7 * math.sin(y[0])),
        (0, 20), (theta_0, 0.0), t_eval=t, method="DOP853", rtol=1e-12, atol=1e-12,
    ).y  # fmt: skip
    np.testing.assert_allclose(motion.theta, other[0], atol=2e-8)
    np.testing.assert_allclose(motion.theta_dot, other[1], atol=2e-7)


def test_energy_is_conserved_near_the_top():
    pendulum = Pendulum(l=1.0, g=1.0)
    motion = pendulum.motion(3.14, np.linspace(0, 3 * pendulum.period(3.14), 500))
    energy = motion.theta_dot**2 / 2 + 2 * np.sin(motion.theta / 2) ** 2
    np.testing.assert_allclose(energy, energy[0], rtol=0, atol=16 * U)


def test_at_rest_and_small():
    rest = Pendulum(l=1.0, g=9.81).motion(0.0, [0.0, 1.0])
    for values in (rest.theta, rest.theta_dot, rest.theta_ddot):
        np.testing.assert_array_equal(values, 0.0)
    pendulum = Pendulum(l=1.0, g=4 * math.pi**2)
    assert pendulum.omega_0 == pytest.approx(2 * math.pi, rel=U)
    np.testing.assert_allclose(pendulum.motion(1e-9, [0.0, 0.5]).theta, [1e-9, -1e-9], rtol=4 * U)


@pytest.mark.parametrize("theta_0", [math.nextafter(math.pi, 4), -4.0, math.nan, math.inf])
def test_a_start_beyond_the_top_is_refused(theta_0):
    for call in (
        excess,
        Pendulum(l=1.0, g=1.0).period,
        lambda theta: Pendulum(l=1.0, g=1.0).motion(theta, [0.0]),
    ):
        with pytest.raises(ValueError, match=r"an angle (of .* below the top|in rad is a finite number)"):
            call(theta_0)


@pytest.mark.parametrize(("l", "g", "name"), [(0.0, 1.0, "l"), (1.0, math.inf, "g")])
def test_lengths_and_gravity_are_positive(l, g, name):  # noqa: E741
    with pytest.raises(ValueError, match=f"{name} = "):
        Pendulum(l=l, g=g)
