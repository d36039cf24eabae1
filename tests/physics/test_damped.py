"""One damped oscillator at every damping: against many digits, across the seam of critical damping, in its limits."""

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from physics.damped import DampedOscillator
from physics.oscillator import Oscillator
from tests.grids import tries
from tests.physics.chain_truth import U, ulps

BOUND = 2.0  # u of the sum of the sizes of both parts
NEXT = math.nextafter(2.0, 3.0), math.nextafter(2.0, 1.0)  # m = k = 1 is critical at c = 2


@pytest.fixture(autouse=True)
def strict():
    with np.errstate(all="raise", under="ignore"), mp.workprec(4000):
        yield


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
        return mp.exp(p * t) * (start + (rate - p * start) * t), mp.exp(p * t) * (
            abs(start) + abs(rate - p * start) * t
        )
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


@pytest.mark.parametrize("c", [2.0, *NEXT, 2 * (1 + 1e-9), 2 * (1 - 1e-9), 2 * (1 + 1e-5), 2 * (1 - 1e-5)])
def test_across_critical_damping(c):
    times = [0.0, 1e-9, 0.1, 1.0, 5.0, 30.0, 300.0]
    check(DampedOscillator(m=1.0, c=c, k=1.0), 1.0, -0.4, times)
    critical = DampedOscillator(m=1.0, c=2.0, k=1.0).motion(1.0, -0.4, times)
    here = DampedOscillator(m=1.0, c=c, k=1.0).motion(1.0, -0.4, times)
    assert np.max(np.abs(here.x - critical.x)) <= 2 * abs(c - 2.0) + U


@pytest.mark.parametrize("c", [1e3, 1e8, 1e150])
def test_stiff(c):
    """Rates c and 1/c; the start of the fast part alone, too, keeps its digits."""
    oscillator = DampedOscillator(m=1.0, c=c, k=1.0)
    times = [0.0, 1e-3 / c, 1 / c, 30 / c, 1.0, c, 100 * c]
    check(oscillator, 1.0, 0.0, times)
    check(oscillator, 1.0, -c, times)
    check(oscillator, 0.0, 1.0, times)


@pytest.mark.parametrize(
    ("m", "c", "k"),
    [
        (1e-300, 1e-10, 1e280),
        (1e300, 1e-300, 1e-300),
        (5e-324, 1.0, 1e-300),
        (1.0, 1e-300, 1.0),
        (1e-150, 2e150, 1e300),
    ],
)
def test_at_the_ends_of_the_doubles(m, c, k):
    """A motion whose velocity or acceleration exceeds doubles is refused, so x alone starts small."""
    oscillator = DampedOscillator(m=m, c=c, k=k)
    slowest = max(oscillator.omega_n, 1e-290)
    with mp.workprec(12000):
        check(oscillator, 1e-300 if k / m > 1e4 else 1.0, 0.0, [0.0, 1e-3 / slowest, 1.0 / slowest])


def test_without_damping_it_is_the_oscillator():
    t = np.linspace(0.0, 1e6, 500)
    damped, plain = (
        DampedOscillator(m=2.0, c=0.0, k=3.0).motion(0.3, -1.0, t),
        Oscillator(m=2.0, k=3.0).motion(0.3, -1.0, t),
    )
    for one, other in ((damped.x, plain.x), (damped.v, plain.v), (damped.a, plain.a)):
        assert np.max(np.abs(one - other)) <= 5 * U * np.max(np.abs(other))


def test_without_a_spring_it_comes_to_rest():
    t = np.array([0.0, 0.5, 1e3])
    motion = DampedOscillator(m=2.0, c=4.0, k=0.0).motion(1.0, 3.0, t)
    assert motion.x == pytest.approx(1.0 + 1.5 * (1.0 - np.exp(-2.0 * t)), rel=1e-15)
    assert motion.v == pytest.approx(3.0 * np.exp(-2.0 * t), rel=1e-15)
    drift = DampedOscillator(m=2.0, c=0.0, k=0.0).motion(1.0, 3.0, t)
    assert np.array_equal(drift.x, 1.0 + 3.0 * t)


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
