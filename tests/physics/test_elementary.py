"""exp, sin and cos in two doubles, and roots of polynomials in many digits."""

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath.ctx_mp import MPContext

from physics.precision.elementary import LARGEST_EXPONENT, SMALLEST_EXPONENT, exponential, sine_cosine
from physics.precision.exact import two_sum
from physics.precision.roots import mismatch, roots
from tests.grids import tries

BITS = 400
thorough = settings(max_examples=tries(200))
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
