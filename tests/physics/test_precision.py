"""The numerical foundation: error-free transformations, sines of any phase, exponentials, roots, sums of sinusoids."""

import math
from decimal import Decimal
from fractions import Fraction

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath.ctx_mp import MPContext

from physics.precision.elementary import LARGEST_EXPONENT, SMALLEST_EXPONENT, exponential, sine_cosine
from physics.precision.exact import (
    binary,
    exact,
    precise,
    rounded,
    sin_cos,
    snapped,
    split,
    sum_of,
    two_product,
    two_sum,
    within_an_ulp,
)
from physics.precision.roots import mismatch, roots
from physics.sinusoids import SLOW, Beat, ExactSinusoid, added, total
from tests.grids import tries
from tests.physics.truth import U

thorough = settings(max_examples=tries(200))
anything = st.floats(-1e100, 1e100).filter(lambda x: x == 0.0 or abs(x) > 1e-100)


@thorough
@given(anything, anything)
def test_sums_and_products_lose_nothing(a, b):
    s, e = two_sum(a, b)
    assert s == a + b and Fraction(s) + Fraction(e) == Fraction(a) + Fraction(b)
    p, e = two_product(a, b)
    assert p == a * b and Fraction(p) + Fraction(e) == Fraction(a) * Fraction(b)


@pytest.mark.parametrize("digits", ["1.5e400", "-2.25e-500", "3", "0.1", "-7e307", "4.9e-324"])
def test_binary_has_no_bounds(digits):
    hi, lo, exponent = binary(Decimal(digits))
    with precise():
        back = (Decimal(hi) + Decimal(lo)) * Decimal(2) ** exponent
        assert 0.5 <= abs(hi) <= 1.0 and abs(back / Decimal(digits) - 1) < Decimal("1e-31")
    assert binary(Decimal(0)) == (0.0, 0.0, 0)


def test_split_and_rounded():
    hi, lo = split(Decimal("0.1"))
    assert hi == 0.1 and lo == float(Fraction(1, 10) - Fraction(0.1))
    assert split(Decimal("1e400")) == (math.inf, 0.0)
    assert rounded("x", Decimal("0.1")) == 0.1


def test_within_an_ulp_of_what_is_no_double():
    root = Decimal(2).sqrt()
    at = math.sqrt(2)
    below, above = math.nextafter(at, 0.0), math.nextafter(at, 2.0)
    assert within_an_ulp(at, root) and within_an_ulp(below, root)
    assert not within_an_ulp(above, root)
    assert not within_an_ulp(at, -root)
    assert within_an_ulp(0.0, Decimal("4e-324")) and not within_an_ulp(0.0, Decimal("5e-324"))


def test_noise_is_not_a_number():
    with precise():
        third = Decimal(1) / 3
        assert sum_of(third * 3, Decimal(-1)) == 0 and sum_of(third, Decimal(-1)) != 0
        assert snapped(third * 3) == 1 and snapped(third) == third


@thorough
@given(st.floats(-300.0, 300.0), st.floats(-10.0, 15.0), st.floats(-1.0, 1.0), st.floats(-3.0, 3.0))
def test_phases_of_any_frequency(exponent, turns, low, phase):
    omega = 10.0**exponent
    t = 10.0 ** min(turns - exponent, 307.0)
    lo = omega * U * low
    sine, cosine = sin_cos(omega, lo, np.array([t, -t, 0.0]), phase)
    with mp.workprec(2400):
        for n, s in enumerate((t, -t, 0.0)):
            true = (mp.mpf(omega) + mp.mpf(lo)) * mp.mpf(s) + mp.mpf(phase)
            assert abs(mp.mpf(sine[n]) - mp.sin(true)) <= 0.6 * U
            assert abs(mp.mpf(cosine[n]) - mp.cos(true)) <= 0.6 * U


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


DIGITS = MPContext()
DIGITS.dps = 120


@pytest.mark.parametrize("spread", [1, 30, 300])
@thorough
@given(st.lists(st.floats(0.1, 1.0), min_size=2, max_size=5), st.lists(st.floats(-1.0, 1.0), min_size=5, max_size=5))
def test_the_roots_make_up_the_polynomial(spread, mantissas, exponents):
    pairs = zip(mantissas, exponents, strict=False)
    coefficients = [DIGITS.mpf(m) * DIGITS.mpf(10) ** (spread * e) for m, e in pairs]
    found = roots(DIGITS, coefficients)
    assert len(found) == len(coefficients) - 1
    assert {(z.real, abs(z.imag)) for z in found if z.imag > 0} == {(z.real, -z.imag) for z in found if z.imag < 0}
    assert mismatch(coefficients, found) < mp.mpf("1e-25")


@pytest.mark.parametrize("multiplicity", [2, 3, 4])
def test_a_multiple_root_keeps_its_share_of_the_digits(multiplicity):
    coefficients = [DIGITS.binomial(multiplicity, k) for k in range(multiplicity + 1)]
    found = roots(DIGITS, coefficients)
    assert all(abs(z + 1) < DIGITS.mpf(10) ** (5 - 120 // multiplicity) for z in found)
    assert len(set(found)) == multiplicity


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
