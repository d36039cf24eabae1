"""exp, sin and cos of arrays as hi + lo to about 2^-98, for sums in which most of that cancels.

physics.precision.exact.on_circle spends a tenth of this on a motion whose modes do not cancel. Both reduce their
argument to a point of a table and finish with a series; here the first terms of the series carry two doubles as well.

Source: D. H. Bailey, Y. Hida, X. S. Li, Quad-double arithmetic (LBNL-46996, 2000), section 3.
"""

import math
from collections.abc import Sequence
from decimal import Decimal

import numpy as np

from physics.precision.exact import (
    COSINES,
    SINES,
    DoubleDouble,
    nearest_point,
    pair_product,
    pair_sum,
    precise,
    reduced,
    split,
    three_doubles,
    two_sum,
)

SMALLEST_EXPONENT, LARGEST_EXPONENT = -600.0, 700.0  # limits between which exp and its low part are doubles
_PARTS = 32  # of an octave, tabulated
_CARRIED = 7  # number of terms of a series that need two doubles


def exponential(exponent: DoubleDouble) -> DoubleDouble:
    """Return exp of the `exponent` hi + lo (n,), hi from SMALLEST_EXPONENT to LARGEST_EXPONENT."""
    count = np.rint(exponent[0] / _OCTAVE[0])
    part = np.mod(count, _PARTS).astype(np.intp)
    r = reduced(*exponent, count, _OCTAVE)
    hi, lo = pair_product((_POWERS[0][part], _POWERS[1][part]), _series(r, _EXPONENTIAL))
    octaves = ((count - part) / _PARTS).astype(np.intp)
    return np.ldexp(hi, octaves), np.ldexp(lo, octaves)


def sine_cosine(theta: DoubleDouble) -> tuple[DoubleDouble, DoubleDouble]:
    """Return sin and cos of theta = hi + lo (n,) in rad, |hi| up to 2**50."""
    point, r = nearest_point(*theta)
    square = pair_product(r, r)
    sine, cosine = pair_product(r, _series(square, _SINE)), _series(square, _COSINE)
    (s, s_lo), (c, c_lo) = ((hi[point], lo[point]) for hi, lo in (SINES, COSINES))
    return (
        pair_sum(pair_product((s, s_lo), cosine), pair_product((c, c_lo), sine)),
        pair_sum(pair_product((c, c_lo), cosine), pair_product((-s, -s_lo), sine)),
    )


def _series(x: DoubleDouble, coefficients: Sequence[tuple[float, float]]) -> DoubleDouble:
    """The highest power first (Horner), the last few in two doubles."""
    plain, carried = coefficients[:-_CARRIED], coefficients[-_CARRIED:]
    value = np.full_like(x[0], plain[0][0])
    for hi, _ in plain[1:]:
        value = value * x[0] + hi
    result: DoubleDouble = value, np.zeros_like(value)
    for coefficient in carried:
        result = pair_sum(pair_product(result, x), coefficient)
    return two_sum(*result)


def _reciprocals(factorials: range, sign: int) -> list[tuple[float, float]]:
    """sign^k/n! for the n given, the last one first."""
    with precise():
        return [split(Decimal(sign) ** k / math.factorial(n)) for k, n in enumerate(factorials)][::-1]


def _powers() -> DoubleDouble:
    """2^(j/32) for j < 32."""
    with precise():
        hi, lo = np.transpose([split((Decimal(2).ln() * j / _PARTS).exp()) for j in range(_PARTS)])
        return hi, lo


def _octave() -> tuple[float, float, float]:
    with precise():
        return three_doubles(Decimal(2).ln() / _PARTS)


_EXPONENTIAL = _reciprocals(range(14), 1)
_SINE = _reciprocals(range(1, 20, 2), -1)
_COSINE = _reciprocals(range(0, 20, 2), -1)
_POWERS = _powers()
_OCTAVE = _octave()
