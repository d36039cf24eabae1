"""Sums of sinusoids: rounded about once, at any phase, on both sides of every seam."""

import math
from decimal import Decimal

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.precision.exact import exact
from physics.sinusoids import SLOW, Beat, ExactSinusoid, added, total
from tests.grids import tries
from tests.physics.chain_truth import U

BITS = 3000
ZERO, ONE = Decimal(0), Decimal(1)
QUANTITIES = ("one", "other")
small = st.floats(-1.0, 1.0)
thorough = settings(max_examples=tries(200))


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
