"""The numerical foundation: error-free transformations, and sine and cosine of any phase."""

import math
from decimal import Decimal
from fractions import Fraction

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.precision.exact import (
    binary,
    on_circle,
    pair_product,
    pair_quotient,
    pair_sum,
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
from tests.grids import tries
from tests.physics.chain_truth import U

thorough = settings(max_examples=tries(200))
anything = st.floats(-1e100, 1e100).filter(lambda x: x == 0.0 or abs(x) > 1e-100)


@thorough
@given(anything, anything)
def test_sums_and_products_lose_nothing(a, b):
    s, e = two_sum(a, b)
    assert s == a + b and Fraction(s) + Fraction(e) == Fraction(a) + Fraction(b)
    p, e = two_product(a, b)
    assert p == a * b and Fraction(p) + Fraction(e) == Fraction(a) * Fraction(b)


@thorough
@given(*[st.floats(0.5, 2.0)] * 2, *[st.floats(-1.0, 1.0)] * 2)
def test_pairs_carry_100_bits(a, b, a_lo, b_lo):
    x, y = two_sum(a, a_lo * U / 2), two_sum(b, b_lo * U / 2)
    exactly = [Fraction(hi) + Fraction(lo) for hi, lo in (x, y)]
    hi, lo = pair_sum(x, y)
    assert abs(Fraction(hi) + Fraction(lo) - sum(exactly)) <= Fraction(2) ** -100 * 4
    hi, lo = pair_product(x, y)
    assert abs(Fraction(hi) + Fraction(lo) - exactly[0] * exactly[1]) <= Fraction(2) ** -100 * 4
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


@pytest.mark.parametrize("size", [1e-300, 1e-8, 0.3, 10.0, 1e5, 1e10, 1e15])
def test_sine_and_cosine_to_100_bits(size):
    random = np.random.default_rng(1)
    theta = size * random.uniform(-1.0, 1.0, 200)
    rest = np.spacing(np.abs(theta)) * random.uniform(-0.5, 0.5, 200)
    near = np.arange(1.0, 1e6, 9331.0) * np.pi
    theta, rest = np.append(theta, near), np.append(rest, np.zeros_like(near))
    sines, cosines = on_circle(theta, rest)
    with mp.workprec(1200):
        for n in range(theta.size):
            phase = mp.mpf(theta[n]) + mp.mpf(rest[n])
            for (hi, lo), true in ((sines, mp.sin(phase)), (cosines, mp.cos(phase))):
                assert abs(mp.mpf(hi[n]) + mp.mpf(lo[n]) - true) <= 0.1 * U * min(1, 2 * abs(phase) or 1)


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


def test_phases_past_all_bounds_are_still_on_the_circle():
    sine, cosine = sin_cos(1e300, 0.0, np.array([1e300, -1e250, 1e15, 0.0]))
    assert sine**2 + cosine**2 == pytest.approx(1.0, rel=1e-15)
    assert (sine[3], cosine[3]) == (0.0, 1.0)
    with mp.workprec(1200):
        assert float(mp.sin(mp.mpf(1e300) * mp.mpf(1e-285))) == sin_cos(1e300, 0.0, np.array([1e-285]))[0][0]
