"""Numbers with more digits than doubles, motions as values, and curves or bands of what a grid can resolve."""

from __future__ import annotations

import math
from decimal import Decimal
from fractions import Fraction

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.damped import DampedOscillator
from physics.free_decay import FreeDecay
from physics.motion import Elementary, Harmonic, harmonic_motion, superposed
from physics.precision.elementary import LARGEST_EXPONENT, SMALLEST_EXPONENT, exponential, sine_cosine
from physics.precision.exact import (
    Array,
    binary,
    exact,
    pair_product,
    pair_quotient,
    pair_sum,
    precise,
    two_sum,
    within_an_ulp,
)
from physics.sampling import (
    Sinusoid,
    curve_or_band,
    periods,
    root_mean_square,
    time_window,
)
from physics.sinusoids import SLOW, Beat, ExactSinusoid, added, total
from tests.grids import tries
from tests.physics.truth import U

thorough = settings(max_examples=tries(200))


def test_within_an_ulp_of_what_is_no_double():
    root = Decimal(2).sqrt()
    at = math.sqrt(2)
    below, above = math.nextafter(at, 0.0), math.nextafter(at, 2.0)
    assert within_an_ulp(at, root) and within_an_ulp(below, root)
    assert not within_an_ulp(above, root)
    assert not within_an_ulp(at, -root)
    assert within_an_ulp(0.0, Decimal("4e-324")) and not within_an_ulp(0.0, Decimal("5e-324"))


low_part = st.floats(-1.0, 1.0)


def pair(hi, part):
    """hi and a low part below half an ulp of it, as arrays."""
    return two_sum(np.array([hi]), np.array([part * hi * 2.0**-54]))


def value(two):
    return mp.mpf(two[0][0]) + mp.mpf(two[1][0])


@thorough
@given(st.floats(SMALLEST_EXPONENT, LARGEST_EXPONENT), low_part)
def test_exponential(hi, part):
    argument = pair(hi, part)
    true = mp.exp(value(argument))
    assert abs(value(exponential(argument)) - true) <= mp.mpf(2) ** -95 * true


@thorough
@given(st.floats(-1e6, 1e6), low_part)
def test_sine_and_cosine(hi, part):
    argument = pair(hi, part)
    for found, true in zip(sine_cosine(argument), (mp.sin, mp.cos), strict=True):
        assert abs(value(found) - true(value(argument))) <= mp.mpf(2) ** -95


BITS = 3000
ZERO, ONE = Decimal(0), Decimal(1)
QUANTITIES = ("one", "other")
small = st.floats(-1.0, 1.0)


def swing(omega, a, b):
    """a cos(omega t) + b sin(omega t) and 2 b sin(omega t), as a sinusoid and as a function of mpmath."""
    w, sine = exact(omega), exact(b) * exact(omega)
    return ExactSinusoid(w, (exact(a), ZERO), (sine, 2 * sine)), lambda t: (
        mp.mpf(a) * mp.cos(mp.mpf(omega) * t) + mp.mpf(b) * mp.sin(mp.mpf(omega) * t),
        2 * mp.mpf(b) * mp.sin(mp.mpf(omega) * t),
    )


@thorough
@given(st.lists(st.tuples(st.floats(0.1, 10.0), small, small), min_size=1, max_size=3), st.floats(0.0, 14.0))
def test_the_sum_is_rounded_about_once(swings, decades):
    t = np.array([0.0, 1.0, 10.0**decades])
    parts = [swing(*one) for one in swings]
    found = total(t, QUANTITIES, quick=[sinusoid for sinusoid, _ in parts])
    size = sum(abs(a) + 2 * abs(b) for _, a, b in swings)
    for n, time in enumerate(t):
        for i in (0, 1):
            true = sum(function(mp.mpf(time))[i] for _, function in parts)
            assert abs(mp.mpf(found[i, n]) - true) <= math.ulp(found[i, n]) / 2 + 0.01 * U * size + 1e-300


@pytest.mark.parametrize(
    ("omega", "t", "b"),
    [
        *((omega, t, 0.25) for omega in (1e30, 1e-300) for t in (1e25, 1e-300, -1e5)),
        *((phase, 1.0, 1.0) for phase in (SLOW * (1 - 1e-9), SLOW * (1 + 1e-9), 1e-3, 1e-200)),
    ],
)
def test_phases_up_to_1e60_and_very_slow_ones(omega, t, b):
    """A very slow sinusoid keeps the digits of its sine."""
    sinusoid, function = swing(omega, 0.5 if b < 1 else 0.0, b)
    found = added([sinusoid], np.array([t]), QUANTITIES)
    assert found[:, 0] == pytest.approx([float(value) for value in function(mp.mpf(t))], rel=2e-15)


@thorough
@given(st.floats(0.5, 2.0), st.floats(-1.0, 1.0), small, small, small)
def test_a_beat_that_has_not_begun(s, turned, a, b, c):
    """d t is at most 1/16; with d = 0 the growth is t."""
    t = np.array([1e-3, 1.0, 50.0])
    d = turned * SLOW / 50.0
    coefficients = [(exact(value), ZERO) for value in (a, b, c)]
    found = total(t, QUANTITIES, beats=[Beat(exact(s), exact(d), *coefficients)])[0]
    for value, time in zip(found, map(mp.mpf, t), strict=True):
        slow = mp.sin(d * time) / mp.mpf(d) if d else time
        true = a * mp.cos(d * time) * mp.sin(s * time) + (b * mp.cos(s * time) + c * mp.sin(s * time)) * slow
        assert abs(value - true) <= math.ulp(value) / 2 + 0.1 * U * (abs(a) + (abs(b) + abs(c)) * time) + 1e-300


def decay(m: float = 1.0, c: float = 0.4, k: float = 4.0, x_0: float = 1.0, v_0: float = 0.0) -> FreeDecay:
    return FreeDecay(oscillator=DampedOscillator(m=m, c=c, k=k), x_0=x_0, v_0=v_0)


@pytest.fixture
def t() -> Array:
    return np.linspace(0.0, 10.0, 101)


def wave(omega: float) -> Elementary:
    return harmonic_motion("x", Harmonic((Sinusoid(1.0, omega, 0.3),)), lambda t: np.sin(omega * t + 0.3))


@pytest.mark.parametrize("omegas", [(1.0, 1000.0), (1000.0, 1001.0), (800.0, 1000.0)])
def test_a_superposition_knows_its_band_and_its_averages(t: Array, omegas: tuple[float, float]) -> None:
    """A slow part moves the band, close frequencies beat, others add up."""
    whole, fine = superposed("x", *map(wave, omegas)), np.linspace(0.0, 10.0, 200_001)
    values, averaged = whole.at(fine), whole * whole
    low, high = (np.interp(fine, t, edge.at(t)) for edge in whole.band(10.0))
    assert np.all(low <= values + 0.02) and np.all(values <= high + 0.02)
    assert values.max() == pytest.approx(high.max(), abs=0.02)
    assert np.trapezoid(averaged.mean.at(t), t) == pytest.approx(np.trapezoid(values**2, fine), rel=0.02)
    assert whole.size() == 2.0 and whole.omega == max(omegas)


T = np.linspace(0.0, 10.0, 601)


WINDOWS = [(1.0, 2.0, 4), (1.0, 1.5, 4), (1.0, 1.25, 8), (1.0, 1.02, 100), (1.0, 1.0, 100), (1e-200, 2e-200, 4)]


@pytest.mark.parametrize(("slow", "fast", "in_slow_periods"), WINDOWS)
def test_the_window_is_4_slow_or_2_beat_periods(slow, fast, in_slow_periods):
    assert time_window(slow, fast) == pytest.approx(in_slow_periods * 2 * math.pi / slow, rel=1e-12)
    assert time_window(0.0, fast) == periods(fast, 4.0) == pytest.approx(8 * math.pi / fast)
    assert time_window(0.0, 0.0) == 10.0


@pytest.mark.parametrize(
    ("components", "slow", "width"),
    [
        ([Sinusoid(1.0, 1.0, 0.0), Sinusoid(0.5, 1e6, 0.2)], np.sin(T), 0.5),
        ([Sinusoid(1.0, 1e5, 0.0), Sinusoid(-0.5, 1e9, 0.0)], np.zeros_like(T), 1.5),
    ],
)
def test_fast_components_are_a_band_about_the_slow_ones(components, slow, width):
    found = curve_or_band(components, T)
    assert found.curve is None
    assert found.lo == pytest.approx(slow - width, abs=1e-14) and found.hi == pytest.approx(slow + width, abs=1e-14)


def test_mean_squares_average_the_fast_part_only():
    carrier = 2 * math.pi * 4 * 60  # four cycles from one sample to the next
    slow, fast = Sinusoid(2.0, 1.0, 0.0), [Sinusoid(1.0, carrier, 0.0), Sinusoid(0.6, carrier + 2.0, 1.0)]
    found = root_mean_square([slow, *fast], T) ** 2
    fine = np.linspace(0.0, 10.0, 600 * 400 + 1)
    x = 2 * np.sin(fine) + sum(a * np.sin(w * fine + phase) for a, w, phase in fast)
    assert np.mean((x**2)[200:-201].reshape(599, 400), axis=1) == pytest.approx(found[1:-1], abs=0.02)
    assert root_mean_square([slow], T, 0.5 * T) == pytest.approx(np.abs(2 * np.sin(T) + 0.5 * T), abs=1e-14)
    assert root_mean_square([Sinusoid(1e200, 1e9, 0.0)], T) == pytest.approx(np.full_like(T, 1e200 / math.sqrt(2.0)))
    assert not np.any(root_mean_square([], T))


@thorough
@given(*[st.floats(0.5, 2.0)] * 2, *[st.floats(-1.0, 1.0)] * 2)
def test_pairs_carry_100_bits(a, b, a_lo, b_lo):
    x, y = two_sum(a, a_lo * U / 2), two_sum(b, b_lo * U / 2)
    exactly = [Fraction(hi) + Fraction(lo) for hi, lo in (x, y)]
    for (hi, lo), true in ((pair_sum(x, y), sum(exactly)), (pair_product(x, y), math.prod(exactly))):
        assert abs(Fraction(hi) + Fraction(lo) - true) <= Fraction(2) ** -100 * 4
    quotient = exactly[0] / exactly[1]
    assert abs(Fraction(pair_quotient(x, y)) - quotient) <= Fraction(math.ulp(float(quotient))) * 51 / 100
    assert pair_sum((a, 1e-20), (-a, 3e-20)) == (1e-20 + 3e-20, 0.0), "what cancellation leaves"


@pytest.mark.parametrize("digits", ["1.5e400", "-2.25e-500", "3", "0.1", "-7e307", "4.9e-324"])
def test_binary_has_no_bounds(digits):
    hi, lo, exponent = binary(Decimal(digits))
    with precise():
        back = (Decimal(hi) + Decimal(lo)) * Decimal(2) ** exponent
        assert 0.5 <= abs(hi) <= 1.0 and abs(back / Decimal(digits) - 1) < Decimal("1e-31")
    assert binary(Decimal(0)) == (0.0, 0.0, 0)


def test_the_mean_of_a_fast_motion_is_that_over_a_cycle() -> None:
    free = decay(m=2.0, c=1e-3, k=50.0, v_0=1.0)
    whole = np.linspace(0.0, 2 * math.pi / free.oscillator.omega_d, 4001)
    for motion in (free.x, 25.0 * free.x**2, free.v**2, 3.0 - free.v**2, 2.0 * (free.x**2 + free.v**2)):
        averaged = np.trapezoid(motion.at(whole), whole) / whole[-1]
        size = np.max(np.abs(motion.at(whole)))
        assert motion.mean.at(whole)[2000] == pytest.approx(averaged, abs=2e-3 * size)


def test_a_fast_motion_stays_within_its_band(t: Array) -> None:
    free = decay(v_0=-2.0)
    assert free.v.band(0.0) is None and (free.x * free.v).band(0.0) is None
    for motion in (free.x, 3.0 - 2.0 * free.x, 4.0 * free.x**2 + 1.0, free.x**2 - 0.5 * free.x):
        low, high = motion.band(0.0) or pytest.fail("it has no band")
        margin = 1e-12 * np.max(np.abs(high.at(t)))
        assert np.all(low.at(t) - margin <= motion.at(t)) and np.all(motion.at(t) <= high.at(t) + margin)
