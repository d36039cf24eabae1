"""Pendulum and phugoid against Jacobi functions, Taylor series in many digits and book values; the nine analogues."""

import math
from decimal import Decimal

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.analogues import ANALOGUES, G
from physics.lanchester import CUSP_EXCESS, LINEAR_PERIOD, excess_at_period_excess, invariant, period_excess
from physics.pendulum import Pendulum, amplitude_at_excess, excess
from physics.phugoid import EXCESS_AT_LATENESS, flight, linear_flight
from physics.reference.single import flight_points, period_ratio, swing
from tests.grids import sample, tries
from tests.physics.truth import U, log_uniform

LAST = math.nextafter(math.pi, 0)
AMPLITUDES = (0.0, 1e-300, 1e-9, 0.1, 1.0, -2.0, 3.0, 3.14, 3.141592, math.pi - 1e-10, LAST, math.pi)


@pytest.mark.parametrize("theta_0", AMPLITUDES)
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


NEAR_CUSP = (np.nextafter(CUSP_EXCESS, 0), CUSP_EXCESS, np.nextafter(CUSP_EXCESS, 1))
EXCESSES = (1e-9, 0.01, 0.1511, 0.4585, 0.6, 0.73, 0.732, *NEAR_CUSP, 0.7321, 0.74, 1.0, 3.0, 100.0, 1e6)


def test_at_the_cusp_the_period_is_2_22_percent_longer():
    assert period_excess(CUSP_EXCESS) == pytest.approx(0.0222, abs=5e-5)
    assert invariant(CUSP_EXCESS) == pytest.approx(0.0, abs=4 * U)
    assert invariant(0.0) == 2 / 3
    for lateness, speed in EXCESS_AT_LATENESS.items():
        assert excess_at_period_excess(lateness) == pytest.approx(speed, rel=1e-9)
        assert period_excess(speed) == pytest.approx(lateness, rel=1e-9)


ROLES = {
    "spring": lambda p: (p["m"], p["k"]),
    "shaft": lambda p: (p["J"], p["k_t"]),
    "pendulum": lambda p: (p["m"] * p["l"] ** 2, p["m"] * p["g"] * p["l"]),
    "rocking": lambda p: (p["m"] * (p["d"] ** 2 + p["r"] ** 2), p["m"] * G * p["d"]),
    "floating": lambda p: (p["m"], p["rho"] * G * p["A"]),
    "circuit": lambda p: (p["L"], 1 / p["C"]),
    "string": lambda p: (4e-4 * p["L"] / 2, (p["n"] * math.pi) ** 2 * p["T"] / (2 * p["L"])),
    "wave": lambda p: (p["rho"] * p["wavelength"] / (4 * math.pi), p["rho"] * p["g"] / 2),
    "pipe": lambda p: (1.2 * AREA * p["L"] / 2, 1.2 * AREA * p["c"] ** 2 * (p["n"] * math.pi) ** 2 / (2 * p["L"])),
}
"""Inertia and stiffness by the table of the lecture."""
AREA = 1e-3


@pytest.mark.parametrize("slug", ANALOGUES)
@settings(max_examples=tries(100))
@given(data=st.data())
def test_roles_frequency_and_energy_follow_the_table(slug, data):
    system = ANALOGUES[slug]
    values = {True: st.integers(1, 20), False: log_uniform(-100, 100)}
    p = {parameter.name: data.draw(values[parameter.whole]) for parameter in system.parameters}
    tuned, (inertia, stiffness) = system.at(p), ROLES[slug](p)
    assert tuned.omega_n == pytest.approx(math.sqrt(stiffness / inertia), rel=8 * U, abs=0)
    assert tuned.inertia == pytest.approx(inertia, rel=8 * U, abs=0)
    assert tuned.stiffness == pytest.approx(stiffness, rel=8 * U, abs=0)
    start = 3 * system.swing
    assert tuned.energy(start) == pytest.approx(stiffness * start**2 / 2, rel=12 * U)
    if system.length_of is None:
        assert tuned.exact_energy(start) == tuned.energy(start)
    else:  # the exact motion of a pendulum, and the height to which it is lifted
        assert tuned.pendulum.omega_0 == pytest.approx(tuned.omega_n, rel=4 * U)
        for angle in (0.0, 1e-200, -1e-9, 1.0, 3.0):
            lifted = stiffness * 2 * math.sin(angle / 2) ** 2
            assert tuned.exact_energy(angle) == pytest.approx(lifted, rel=12 * U, abs=1e-300)
    assert (tuned.pendulum is None) == (system.length_of is None)


@pytest.mark.parametrize("excess", sample(EXCESSES))
def test_flight_is_within_32_u_in_the_first_period_and_32_more_in_each_later_one(excess):
    """Two quantities stay constant over ten linear periods."""
    whole = flight(1.0, 1.0, excess, np.linspace(0, 10 * LINEAR_PERIOD, 4001))
    C = whole.u - whole.V**3 / 3
    assert np.max(np.abs(C - invariant(excess))) <= 1e-14 * max(1.0, abs(invariant(excess)))
    np.testing.assert_allclose(whole.h + whole.V**2 / 2, 0.5, atol=2e-15 * max(1.0, np.max(whole.V) ** 2))
    t = LINEAR_PERIOD * np.array([0.1, 0.45, 0.8, 3.3])
    motion, true = flight(1.0, 1.0, excess, t), flight_points(1.0, 1.0, excess, t.tolist())
    most = 32 * U * max(1, excess**2) * (1 + t // LINEAR_PERIOD)
    for name, values in (("h", motion.h), ("v", motion.gain(1.0, 1.0))):
        for value, point, room in zip(values.tolist(), true[name], most.tolist(), strict=True):
            assert abs(Decimal(value) - point.value) <= Decimal(room) * point.size, name


@pytest.mark.parametrize("excess", [1e-300, 1e-12, 1e-6, -1e-6])
def test_small_disturbances_follow_the_linear_theory_to_second_order(excess):
    t = np.linspace(0, 1.5 * LINEAR_PERIOD, 50)
    exact, linear = flight(1.0, 1.0, excess, t), linear_flight(1.0, 1.0, excess, t)
    assert exact.x[0] == pytest.approx(0.0, abs=1e-14)
    assert np.all(np.abs(exact.x - linear.x) <= 3 * excess**2 * (1 + t) + 1e-13)
    np.testing.assert_allclose(exact.h / excess, linear.h / excess, atol=3 * abs(excess) + 1e-14)
    np.testing.assert_allclose(exact.w / excess, linear.w / excess, atol=3 * abs(excess) + 1e-14)


@pytest.mark.parametrize("excess", [0.1, 0.6, 1.0, -0.5])
def test_rates_are_the_derivatives_of_the_flight(excess):
    v_0, g, step = 45.72, 9.80665, 1e-3
    t = np.linspace(1, 40, 100)
    ahead, behind = (flight(v_0, g, excess, t + shift) for shift in (step, -step))
    names = ("u", "w", "V")
    for name, rate in zip(names, flight(v_0, g, excess, t).rates(v_0, g), strict=True):
        slope = (getattr(ahead, name) - getattr(behind, name)) / (2 * step)
        assert rate == pytest.approx(slope, abs=2e-4 * g)
    at_rest = flight(v_0, g, -1.0, [0.0]).rates(v_0, g)
    assert [float(rate[0]) for rate in at_rest] == pytest.approx([0.0, -g, 0.0])
