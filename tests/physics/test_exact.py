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
