"""One damped oscillator at every damping: against many digits, across the seam of critical damping, in its limits.

Zeros, turns, settling and the energy lost are compared with the reference cases.
"""

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from physics.damped import DampedOscillator
from physics.free_decay import FreeDecay
from tests.grids import tries
from tests.physics.references import each, reference
from tests.physics.truth import U, ulps

BITS = 4000
BOUND = 2.0  # u of the sum of the sizes of both parts
NEAR_CRITICAL = [2.0, math.nextafter(2.0, 3.0), math.nextafter(2.0, 1.0)]  # m = k = 1 is critical at c = 2
NEAR_CRITICAL += [2 * (1 + apart) for apart in (1e-9, -1e-9, 1e-5, -1e-5)]
SPECIAL = [
    *(((1.0, c, 1.0), (1.0, -0.4), (0.0, 1e-9, 0.1, 1.0, 5.0, 30.0, 300.0)) for c in NEAR_CRITICAL),
    # Stiff: rates c and 1/c; the start of the fast part alone, too, keeps its digits.
    *(
        ((1.0, c, 1.0), start, (0.0, 1e-3 / c, 1 / c, 30 / c, 1.0, c, 100 * c))
        for c in (1e3, 1e8, 1e150)
        for start in ((1.0, 0.0), (1.0, -c), (0.0, 1.0))
    ),
    # At the ends of the doubles. A motion whose acceleration exceeds doubles is refused, so x starts small.
    ((1e-300, 1e-10, 1e280), (1e-300, 0.0), (0.0, 1e-293, 1e-290)),
    ((1e300, 1e-300, 1e-300), (1.0, 0.0), (0.0, 1e287, 1e290)),
    ((5e-324, 1.0, 1e-300), (1e-300, 0.0), (0.0, 1e-15, 1e-12)),
    ((1.0, 1e-300, 1.0), (1.0, 0.0), (0.0, 1e-3, 1.0)),
    ((1e-150, 2e150, 1e300), (1e-300, 0.0), (0.0, 1e-228, 1e-225)),
    # Without damping or without a spring.
    ((2.0, 0.0, 3.0), (0.3, -1.0), (0.0, 1.0, 1e3, 1e6)),
    ((2.0, 4.0, 0.0), (1.0, 3.0), (0.0, 0.5, 1e3)),
    ((2.0, 0.0, 0.0), (1.0, 3.0), (0.0, 0.5, 1e3)),
]


def truth(oscillator, x_0, v_0, t):
    """(value, size) of x, v and a: the sum of two exponentials, at critical damping its limit."""
    m, c, k, x, v, t = map(mp.mpf, (oscillator.m, oscillator.c, oscillator.k, x_0, v_0, t))
    root = mp.sqrt(c * c - 4 * m * k)
    p, q = (-c + root) / (2 * m), (-c - root) / (2 * m)
    a = -(c * v + k * x) / m
    return [part(start, rate, p, q, t) for start, rate in ((x, v), (v, a), (a, -(c * a + k * v) / m))]


def part(start, rate, p, q, t):
    """While both exponentials are still equal, sizes are measured in the initial displacement and velocity."""
    if p == q:
        bent = rate - p * start
        return mp.exp(p * t) * (start + bent * t), mp.exp(p * t) * (abs(start) + abs(bent) * t)
    A, B = (rate - q * start) / (p - q), (p * start - rate) / (p - q)
    value = mp.re(A * mp.exp(p * t) + B * mp.exp(q * t))
    apart = abs(A) * mp.exp(mp.re(p) * t) + abs(B) * mp.exp(mp.re(q) * t)
    together = mp.exp(mp.re(p) * t) * (abs(start) + abs(rate - mp.re(p) * start) * t)
    return value, min(apart, together) if abs(p - q) * t < 1 else apart


def check(oscillator, x_0, v_0, times):
    motion = oscillator.motion(x_0, v_0, times)
    for n, t in enumerate(times):
        for row, (value, size) in zip((motion.x, motion.v, motion.a), truth(oscillator, x_0, v_0, t), strict=True):
            assert abs(mp.mpf(row[n]) - value) <= BOUND * U * size + mp.mpf("1e-255") * (abs(x_0) + abs(v_0))


def logarithmic(low, high):
    return st.floats(low, high).map(lambda exponent: 10.0**exponent)


@settings(max_examples=tries(150))
@given(
    logarithmic(-3, 3), logarithmic(-3, 3), logarithmic(-8, 8), st.floats(-1, 1), st.floats(-1, 1), logarithmic(-6, 3)
)
@example(1.0, 1.0, 1.0, 1.0, 0.0, 1.0)
def test_motion_is_within_two_u(m, k, zeta, x_0, v_0, turns):
    omega = math.sqrt(k / m)
    oscillator = DampedOscillator(m=m, c=2 * zeta * math.sqrt(k * m), k=k)
    check(oscillator, x_0, v_0 * omega, [0.0, turns / omega, turns / omega / zeta, turns * zeta / omega])


@pytest.mark.parametrize(("numbers", "start", "times"), SPECIAL)
def test_motion_in_limits_is_within_two_u(numbers, start, times):
    with mp.workprec(12000):
        check(DampedOscillator(**dict(zip("mck", numbers, strict=True))), *start, times)


@pytest.mark.parametrize("c", [0.0, 0.1, 1.9, 2 - 1e-12, 2.0, 2 + 1e-12, 2.1, 50.0, 1e6])
def test_decays_add_up_to_the_motion(c):
    oscillator, t = DampedOscillator(m=1.0, c=c, k=1.0), np.linspace(0.0, 40.0, 200)
    total = np.zeros_like(t)
    for amplitude, slope, rate, omega, phase in oscillator.decays(0.7, -0.4):
        total += (amplitude + slope * t) * np.exp(-rate * t) * np.sin(omega * t + phase)
    assert np.max(np.abs(total - oscillator.motion(0.7, -0.4, t).x)) < 1e-9


@given(*[logarithmic(-100, 100)] * 3)
def test_frequencies_are_rounded_once(m, c, k):
    oscillator = DampedOscillator(m=m, c=c, k=k)
    a, square = mp.mpf(c) / (2 * mp.mpf(m)), mp.mpf(k) / mp.mpf(m)
    assert ulps(oscillator.omega_n, mp.sqrt(square)) <= 0.51
    assert ulps(oscillator.omega_d, mp.sqrt(max(square - a**2, 0))) <= 0.51
    assert ulps(oscillator.zeta, a / mp.sqrt(square)) <= 0.51


def near(value, text, most):
    """Return True if a value is within `most` ulps of the case's number, or both are missing."""
    if text is None:
        return value is None or not math.isfinite(value)
    return ulps(value, mp.mpf(text)) <= most


@each(reference("beyond", "damped"))
def test_rates_moments_and_the_energy_lost_are_those_of_the_reference(case):
    one = DampedOscillator(m=case["m"], c=case["c"], k=case["k"])
    motion = FreeDecay(oscillator=one, x_0=case["x_0"], v_0=case["v_0"])
    assert one.regime == ("critical" if case["critical_within_an_ulp"] else case["regime"])
    assert all(near(value, text, 1) for value, text in zip(one.rates, case["rates"], strict=True))
    assert near(one.log_decrement, case["log_decrement"], 4)
    if case["x_0"]:  # the cases do not look for a second zero after the one at the start
        assert near(motion.first_zero, case["first_zero"], 8)
    assert near(motion.first_turn, case["first_turn"], 8)
    for share, true in case["settled"].items():
        found = motion.settled(float(share))
        assert (found is None) == (true is None)
        assert found is None or found == pytest.approx(float(true), rel=1e-8)
    lost = motion.lost(case["t"])
    assert np.all(np.diff(lost) >= 0)
    for t, value, text in zip(case["t"], lost, case["lost"], strict=True):
        true = mp.mpf(text) if case["c"] and t else 0
        assert abs(mp.mpf(float(value)) - true) <= 64 * U * abs(true) + mp.mpf("1e-300")


def test_top_speed_is_where_the_acceleration_is_zero_and_a_mass_at_rest_has_no_moments():
    one = DampedOscillator(m=1.0, c=0.4, k=4.0)
    found = one.motion(1.0, 0.0, [FreeDecay(oscillator=one, x_0=1.0, v_0=0.0).first_top_speed])
    assert abs(found.a[0]) < 1e-14 and found.x[0] == pytest.approx(-0.1 * found.v[0])
    rest = FreeDecay(oscillator=one, x_0=0.0, v_0=0.0)
    assert (rest.first_zero, rest.first_turn, rest.settled(0.02)) == (None, None, None)
    assert not rest.lost([0.0, 1.0]).any()
