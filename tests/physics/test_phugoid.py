"""Phugoid against book values, quadrature in 40 digits, solve_ivp, and its own invariant."""

import mpmath as mp
import numpy as np
import pytest

from physics.phugoid import (
    CUSP_EXCESS,
    EXCESS_AT_LATENESS,
    LINEAR_PERIOD,
    excess_at_period_excess,
    flight,
    invariant,
    lanchester,
    linear_flight,
    linear_phugoid,
    period_excess,
)

U = 2.0**-53
NEAR_CUSP = (np.nextafter(CUSP_EXCESS, 0), CUSP_EXCESS, np.nextafter(CUSP_EXCESS, 1))
EXCESSES = (1e-9, 0.01, 0.1511, 0.4585, 0.6, 0.73, 0.732, *NEAR_CUSP, 0.7321, 0.74, 1.0, 3.0, 100.0, 1e6)
units = pytest.mark.parametrize("excess", EXCESSES)


def quadrature_period(excess):
    """T = 2 integral of V dV/sqrt(V^2 - u^2) between the turning points, with the roots taken out."""
    fastest = 1 + mp.mpf(excess)
    C = fastest - fastest**3 / 3
    if C > 0:
        slowest = (mp.sqrt(12 - 3 * fastest**2) - fastest) / 2
    else:
        slowest = mp.findroot(lambda V: V**3 / 3 + V + C, min(-C, mp.cbrt(-3 * C)))

    def from_bottom(s):
        V = fastest - s * s
        return 2 * V / mp.sqrt((V * V + V * fastest + fastest**2 - 3) / 3 * (V + C + V**3 / 3))

    def from_top(s):
        V = slowest + s * s
        u = C + V**3 / 3
        if C > 0:
            return 2 * V / mp.sqrt((V + u) * (fastest - V) * (V + slowest + fastest) / 3)
        return 2 * V / mp.sqrt((V - u) * (V * V + V * slowest + slowest**2 + 3) / 3)

    middle = (fastest + slowest) / 2
    ends = [mp.sqrt(fastest - middle), mp.sqrt(middle - slowest)]
    graded = [0, *(ends[1] / 4**n for n in range(12, -1, -1))]
    return 2 * (mp.quad(from_bottom, [0, ends[0]]) + mp.quad(from_top, graded))


def test_at_the_cusp_the_period_is_2_22_percent_longer():
    assert period_excess(CUSP_EXCESS) == pytest.approx(0.0222, abs=5e-5)
    assert invariant(CUSP_EXCESS) == pytest.approx(0.0, abs=4 * U)
    assert invariant(0.0) == 2 / 3
    for lateness, excess in EXCESS_AT_LATENESS.items():
        assert excess_at_period_excess(lateness) == pytest.approx(excess, rel=1e-9)
        assert period_excess(excess) == pytest.approx(lateness, rel=1e-9)


@units
def test_period_against_quadrature(excess):
    with mp.workdps(40):
        true = quadrature_period(float(excess))
        assert abs(lanchester(excess, 3).period / true - 1) <= 4 * U


@units
def test_invariant_over_ten_linear_periods(excess):
    t = np.linspace(0, 10 * LINEAR_PERIOD, 4001)
    motion = flight(1.0, 1.0, excess, t)
    C = motion.u - motion.V**3 / 3
    assert np.max(np.abs(C - invariant(excess))) <= 1e-14 * max(1.0, abs(invariant(excess)))
    np.testing.assert_allclose(motion.h + motion.V**2 / 2, 0.5, atol=2e-15 * max(1.0, np.max(motion.V) ** 2))


@pytest.mark.parametrize("excess", [0.3, 1.0])
def test_motion_within_32_u_of_arbitrary_precision(excess):
    def rates(_, state):
        u, w, _ = state
        V = mp.hypot(u, w)
        return [-V * w, V * u - 1, u]

    t = [0.7, 2.3, 3.1]
    motion = flight(1.0, 1.0, excess, t)
    with mp.workdps(22):
        true = mp.odefun(rates, 0, [1 + mp.mpf(excess), 0, 0])
        for n, time in enumerate(t):
            for mine, exact in zip((motion.u, motion.w, motion.x), true(mp.mpf(time)), strict=True):
                assert abs(mine[n] - exact) <= 32 * U


@pytest.mark.parametrize("excess", [1e-300, 1e-12, 1e-6, -1e-6])
def test_small_disturbances_follow_the_linear_theory_to_second_order(excess):
    t = np.linspace(0, 1.5 * LINEAR_PERIOD, 50)
    exact, linear = flight(1.0, 1.0, excess, t), linear_flight(1.0, 1.0, excess, t)
    np.testing.assert_allclose(exact.h / excess, linear.h / excess, atol=3 * abs(excess) + 1e-14)
    np.testing.assert_allclose(exact.w / excess, linear.w / excess, atol=3 * abs(excess) + 1e-14)


def test_level_flight_stays_level():
    motion = flight(46.0, 9.81, 0.0, np.linspace(0, 100, 11))
    assert not motion.h.any() and np.all(motion.V == 46.0) and lanchester(0.0).period == LINEAR_PERIOD
    np.testing.assert_allclose(motion.x, 46.0 * motion.t, rtol=4 * U)


@pytest.mark.parametrize("excess", [0.3, CUSP_EXCESS, 1.0])
def test_a_period_is_closed_and_symmetric(excess):
    period = lanchester(excess, 401)
    np.testing.assert_allclose(period.h, period.h[::-1], atol=4e-15)
    np.testing.assert_allclose(period.w, -period.w[::-1], atol=1e-14)
    assert period.x[-1] == pytest.approx(period.advance, rel=4 * U)
    assert period.t[-1] == period.period
    assert (period.u.min() < -1e-9) == period.loops  # only on its back it flies backwards


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


@pytest.mark.parametrize(("v_0", "g"), [(1e-150, 1e-300), (1e150, 1e300), (1e-300, 1e-300), (1e150, 1e-5)])
def test_extreme_aircraft_fly_the_same_path(v_0, g):
    period = linear_phugoid(v_0, g).tau
    t = np.linspace(0, 2, 9)
    extreme, unit = flight(v_0, g, 0.6, t * period), flight(1.0, 1.0, 0.6, t * LINEAR_PERIOD)
    np.testing.assert_allclose(extreme.V / v_0, unit.V, rtol=1e-13)
    np.testing.assert_allclose(extreme.h / v_0 / v_0 * g, unit.h, rtol=1e-12, atol=1e-14)
