"""Curves over time as hi + lo pairs, and linear combinations of them rounded once.

A motion of the chain is a small matrix of 80-digit coefficients times a few curves: cos(omega t),
sin(omega t)/omega and, under a drive, the response g of a mode that starts from rest,

    g'' + omega_n^2 g = sin(omega t),   g(0) = g'(0) = 0.

Every curve has bounded entries and a decimal scale, so that nothing overflows on the way. The product is a
compensated dot product, so that what remains is the rounding of the result.

Source: lecture D34, slides 6 to 8 (the response); T. Ogita, S. M. Rump, S. Oishi, SIAM J. Sci. Comput. 26 (2005) 1955.
"""

import math
from collections.abc import Sequence
from decimal import Decimal
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from physics.precision.exact import Array, DoubleDouble, angle, binary, exact, on_circle, pair_product, precise, two_sum
from physics.valid import in_range

_SLOW = Decimal(2) ** -10  # rad; below it sin(x)/x takes three terms of its series
_EARLY = Decimal(2)  # rad; below it the closed form of g cancels and its series takes over
_TERMS = 15  # of that series: the next one is below 1e-18 of the first


class ScaledCurve(NamedTuple):
    """A curve (hi + lo) scale over n times.

    Attributes
    ----------
    hi, lo : ndarray (n,)
        An unevaluated sum of two doubles.
    scale : Decimal
        The factor of all entries, of any size.
    """

    hi: Array
    lo: Array
    scale: Decimal

    def times(self, factor: Decimal) -> "ScaledCurve":
        """Return the curve times `factor`."""
        with precise():
            return ScaledCurve(self.hi, self.lo, self.scale * factor)


def reach(t: Array) -> Decimal:
    """Return the largest |t|."""
    return exact(np.max(np.abs(t), initial=0.0))


def power_of_two(near: Decimal) -> tuple[int, Decimal]:
    """Return (e, 2**e) with near <= 2**e, as close as a power of two gets."""
    with precise():
        exponent = binary(near)[2]
        return exponent, Decimal(2) ** exponent


def turning(omega: Decimal, t: Array) -> tuple[ScaledCurve, ScaledCurve]:
    """Return the curves cos(omega t) and sin(omega t)/omega, which is t for omega = 0."""
    with precise():
        slow = abs(omega) * reach(t) < _SLOW
    if slow:
        return _hardly_turning(omega, t)
    sine, cosine = on_circle(*angle(omega, t))
    with precise():
        return ScaledCurve(*cosine, Decimal(1)), ScaledCurve(*sine, 1 / omega)


def _hardly_turning(omega: Decimal, t: Array) -> tuple[ScaledCurve, ScaledCurve]:
    exponent, unit = power_of_two(reach(t))
    time = np.ldexp(t, -exponent)
    with precise():
        square = (float(omega * unit) * time) ** 2
    cosine = -square / 2.0 * (1.0 - square / 12.0 * (1.0 - square / 30.0))
    sine = -square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0))
    return ScaledCurve(*two_sum(1.0, cosine), Decimal(1)), ScaledCurve(*two_sum(time, time * sine), unit)


def response(omega: Decimal, omega_n: Decimal, t: Array) -> tuple[ScaledCurve, ScaledCurve]:
    """Return the response of a mode to sin(omega t) from rest, resonance included.

    Near resonance g comes from half the sum s and half the difference d of the frequencies, elsewhere from
    two divided sines, and at first from its series.

    Parameters
    ----------
    omega : Decimal
        The frequency of the drive in rad/s, above 0.
    omega_n : Decimal
        The natural frequency in rad/s, 0 or more.
    t : ndarray (n,)
        Times in s.

    Returns
    -------
    tuple of two ScaledCurve
        g in s^2 and g' in s.
    """
    with precise():
        s, d = (omega + omega_n) / 2, (omega - omega_n) / 2
        near, half = 2 * abs(d) <= s, omega / 2
        factor = 1 / (2 * omega_n) if near else -omega / (4 * s * d)
    (cos_s, over_s), (cos_d, over_d) = turning(s, t), turning(d, t)
    if near:
        late = difference(product(cos_d, over_s), product(cos_s, over_d)).times(factor)
    else:
        late = difference(turning(omega, t)[1], turning(omega_n, t)[1]).times(factor)
    start = is_early((omega, omega_n), t)
    g = replaced(late, start, early((omega, omega_n), t[start], 3)) if np.any(start) else late
    return g, product(over_s, over_d).times(half)


def is_early(frequencies: Sequence[Decimal], t: Array) -> NDArray[np.bool_]:
    """Return (n,) True where no phase of `frequencies` (rad/s) at times t (s) passes 2 rad.

    Closed forms cancel there, so series are used.
    """
    with precise():
        first: NDArray[np.bool_] = np.abs(t) <= float(_EARLY / max(frequencies))
    return first


def early(frequencies: Sequence[Decimal], t: Array, power: int) -> ScaledCurve:
    """Return omega t^power sum_k (-1)^k h_k / (2 k + power)!, omega the first frequency, up to phases of 2 rad.

    h_k is the sum of all products of k of the (omega_i t)^2, repetitions included. These are divided
    differences of sin(omega t)/omega in omega^2: with two frequencies and the power 3 the response g, with
    three and the power 5 the response of a mass driven only by the other one; a power less, the velocities.

    Parameters
    ----------
    frequencies : sequence of Decimal
        Frequencies in rad/s, that of the drive first.
    t : ndarray (n,)
        Times in s, at which no phase passes 2 rad.
    power : int
        The power of t of the first term.

    Returns
    -------
    ScaledCurve
        The sum, in s^(power - 1).
    """
    exponent, unit = power_of_two(reach(t))
    time = np.ldexp(t, -exponent)
    with precise():
        squares = [-((float(omega * unit) * time) ** 2) for omega in frequencies]
        scale = frequencies[0] * unit**power / math.factorial(power)
    h = [np.ones_like(t) for _ in frequencies]
    rest = np.zeros_like(t)
    for k in range(1, _TERMS):
        for i, square in enumerate(squares):
            h[i] = square * h[i] + (h[i - 1] if i else 0.0)
        rest += h[-1] * (math.factorial(power) / math.factorial(2 * k + power))
    factor = ScaledCurve(time, np.zeros_like(t), Decimal(1))
    leading = factor
    for _ in range(power - 1):
        leading = product(leading, factor)
    return ScaledCurve(*two_sum(leading.hi, leading.lo + leading.hi * rest), scale)


def product(a: ScaledCurve, b: ScaledCurve) -> ScaledCurve:
    """Return the curve a b."""
    hi, lo = pair_product((a.hi, a.lo), (b.hi, b.lo))
    with precise():
        return ScaledCurve(hi, lo, a.scale * b.scale)


def difference(a: ScaledCurve, b: ScaledCurve) -> ScaledCurve:
    """Return the curve a - b."""
    scale = max(abs(a.scale), abs(b.scale))
    a, b = rescaled(a, scale), rescaled(b, scale)
    s, e = two_sum(a.hi, -b.hi)
    return ScaledCurve(s, e + (a.lo - b.lo), scale)


def rescaled(a: ScaledCurve, scale: Decimal) -> ScaledCurve:
    """Return the curve a with another `scale`, at least as large as its own."""
    with precise():
        hi, lo, exponent = binary(a.scale / scale)
    factor = ScaledCurve(np.asarray(math.ldexp(hi, exponent)), np.asarray(math.ldexp(lo, exponent)), scale)
    return product(ScaledCurve(a.hi, a.lo, Decimal(1)), factor)


def replaced(a: ScaledCurve, where: NDArray[np.bool_], b: ScaledCurve) -> ScaledCurve:
    """Return a curve with other values at some places.

    Parameters
    ----------
    a : ScaledCurve
        The curve, with n values.
    where : ndarray of bool (n,)
        The places.
    b : ScaledCurve
        The values for these places, in order.

    Returns
    -------
    ScaledCurve
        The new curve; it may share its arrays with a or b.
    """
    if np.all(where):
        return b
    scale = max(abs(a.scale), abs(b.scale))
    a, b = rescaled(a, scale), rescaled(b, scale)
    a.hi[where], a.lo[where] = b.hi, b.lo
    return a


def combined(rows: Sequence[Sequence[Decimal]], curves: Sequence[ScaledCurve], quantities: Sequence[str]) -> Array:
    """Return sums of curves, rounded once at the end.

    Parameters
    ----------
    rows : sequence of sequences of Decimal
        A row of coefficients for each sum, one for each curve.
    curves : sequence of ScaledCurve
        The curves, with n values each.
    quantities : sequence of str
        The name of each sum in an error message.

    Returns
    -------
    ndarray (rows, n)
        sum_k rows[i][k] curves[k].

    Raises
    ------
    ValueError
        If a sum leaves the range of doubles.
    """
    result = rounded_once(*scaled_sum(rows, curves))
    for quantity, row in zip(quantities, result, strict=True):
        in_range(quantity, row)
    return result


def scaled_sum(
    rows: Sequence[Sequence[Decimal]], curves: Sequence[ScaledCurve]
) -> tuple[DoubleDouble, NDArray[np.int_]]:
    """Return sum_k rows[i][k] curves[k] as hi + lo (rows, n), and the power of two (rows, 1) in which a row is counted.

    It is near the largest term of the row.
    """
    curves = [_normalised(curve) for curve in curves]
    coefficients, exponents = _coefficients(rows, curves)
    total = rest = np.zeros((len(rows), curves[0].hi.size))
    for (hi, lo), curve in zip(coefficients, curves, strict=True):
        if np.any(hi):
            p, e = pair_product((hi, lo), (curve.hi, curve.lo))
            total, carried = two_sum(total, p)
            rest = rest + (carried + e)
    return two_sum(total, rest), exponents


def rounded_once(value: DoubleDouble, exponents: NDArray[np.int_]) -> Array:
    """Return the value (hi, lo) as doubles (hi + lo) 2**exponents.

    A subnormal number is rounded from hi + lo too, not from hi, which is rounded already.
    """
    with np.errstate(over="ignore", invalid="ignore"):
        near = np.ldexp(value[0], exponents)
        lost = value[0] - np.ldexp(near, -exponents)
        return np.where(np.abs(lost) > 0, near + np.ldexp(lost + value[1], exponents), near)


def _normalised(curve: ScaledCurve) -> ScaledCurve:
    """Entries at most 1, the largest above 1/2; a curve that is zero has the scale zero."""
    largest, exponent = math.frexp(np.max(np.abs(curve.hi), initial=0.0))
    with precise():
        scale = curve.scale * Decimal(2) ** exponent if largest else Decimal(0)
    return ScaledCurve(np.ldexp(curve.hi, -exponent), np.ldexp(curve.lo, -exponent), scale)


def _coefficients(rows: Sequence[Sequence[Decimal]], curves: Sequence[ScaledCurve]) -> tuple[Array, NDArray[np.int_]]:
    """Rows times scales as hi + lo (curves, 2, rows, 1), at most 1, and the power of two of each row."""
    with precise():
        parts = [[binary(c * curve.scale) for c, curve in zip(row, curves, strict=True)] for row in rows]
    tops = [max((e for hi, _, e in row if hi), default=0) for row in parts]
    pairs = [
        [(math.ldexp(hi, e - top), math.ldexp(lo, e - top)) for hi, lo, e in row]
        for row, top in zip(parts, tops, strict=True)
    ]
    return np.array(pairs).transpose(1, 2, 0)[..., np.newaxis], np.array(tops)[:, np.newaxis]
