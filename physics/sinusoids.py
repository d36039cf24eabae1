"""Sums of sinusoids with 80-digit coefficients at many times, rounded about once.

A motion of the chain is, for each of its quantities, sum_k a_k cos(omega_k t) + b_k sin(omega_k t)/omega_k. Sine and
cosine come from a table of 4,096 points of the circle and the angle from the nearest of them, less than 0.0008 rad. A
point is a head of 22 bits and a tail; so is a coefficient, its head with 26 bits, counted in one unit for all
coefficients of a quantity. Then all products of heads are multiples of one number, their sum is exact in whatever
order it is formed, also by a matrix product of the library, and what is left to round is 1,000 times smaller than the
result: errors are 0.5 ulp of the result and less than 0.01 u of the coefficients.

Where omega t is below 1/16 throughout, sin(omega t)/omega is written as t (1 + small), which is regular at omega = 0.

If many quantities are the same few sinusoids times different numbers, as the masses of a long chain are, combined()
evaluates each sinusoid once and splits its values in the same way.

Sources: S. Gal, B. Bachelis, ACM Trans. Math. Softw. 17 (1991) 26 (tables); T. Ogita, S. M. Rump, S. Oishi, SIAM J.
Sci. Comput. 26 (2005) 1955, and S. M. Rump, T. Ogita, S. Oishi, SIAM J. Sci. Comput. 31 (2008) 189 (sums without
error from parts on a grid).
"""

import math
from collections.abc import Iterable, Sequence
from decimal import Decimal
from functools import cache
from itertools import zip_longest
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from physics.precision.curves import ScaledCurve
from physics.precision.exact import (
    FINE,
    PI,
    Array,
    binary,
    exact,
    halves,
    precise,
    remainders,
    shifted,
    split,
    two_product,
    two_sum,
)
from physics.valid import rows_in_range

SLOW = 0.0625  # rad; sin(x)/x and cos(x) are 1 + small up to here

_POINTS = 4096
_HEAD = 22  # bits of a sine in the table
_COEFFICIENT, _REST = 26, 50  # bits of the head of a coefficient, and after it
_UNIT = 2.0**_HEAD
_FAR = 2.0**51  # points; past it a phase is reduced in integers, angle by angle
_MASK = (1 << _REST) - 1
_HALF = 1 << (FINE - 1)  # in units of 2^-FINE
_NONE = Decimal(0)
_NOTHING = -(10**8)  # the exponent of 0

Coefficients = Sequence[Decimal]
_SMALL = [np.array([[(-1) ** k / math.factorial(2 * k + odd)] for odd in (0, 1)]) for k in range(4, 0, -1)]


class ExactSinusoid(NamedTuple):
    """cosine[i] cos(omega t) + sine[i] sin(omega t)/omega for each quantity i.

    Attributes
    ----------
    omega : Decimal
        The frequency in rad/s.
    cosine, sine : sequence of Decimal
        A coefficient for each quantity, in its unit and in its unit per second.
    """

    omega: Decimal
    cosine: Coefficients
    sine: Coefficients


class Beat(NamedTuple):
    """sine[i] cos(d t) sin(s t) + (growing_cosine[i] cos(s t) + growing_sine[i] sin(s t)) sin(d t)/d.

    Attributes
    ----------
    s, d : Decimal
        Frequencies in rad/s: half the sum of two close ones, and half their difference.
    sine : sequence of Decimal
        A coefficient for each quantity, in its unit.
    growing_cosine, growing_sine : sequence of Decimal
        Coefficients in its unit per second.
    """

    s: Decimal
    d: Decimal
    sine: Coefficients
    growing_cosine: Coefficients
    growing_sine: Coefficients


class Weighted(NamedTuple):
    """row[i] times a curve for each quantity i.

    Attributes
    ----------
    curve : ScaledCurve
        The curve, not above 1.
    row : sequence of Decimal
        A coefficient for each quantity.
    """

    curve: ScaledCurve
    row: Coefficients


def added(sinusoids: Iterable[ExactSinusoid], t: Array, quantities: Sequence[str]) -> Array:
    """Return the sum of sinusoids, each slow or quick by the latest of the times.

    Parameters
    ----------
    sinusoids : iterable of ExactSinusoid
        The sinusoids; those without amplitude are left out.
    t : ndarray (n,)
        Times in s.
    quantities : sequence of str
        The names of the quantities, for the message of an error.

    Returns
    -------
    ndarray (quantities, n)
        The values, each in its unit.

    Raises
    ------
    ValueError
        If a quantity, which the message names, leaves the range of doubles.
    """
    reach = exact(np.abs(t).max(initial=0.0))
    kinds: tuple[list[ExactSinusoid], list[ExactSinusoid]] = [], []
    with precise():
        for one in sinusoids:
            if any(one.cosine) or any(one.sine):
                kinds[abs(one.omega) * reach < SLOW].append(one)
    return total(t, quantities, *kinds)


def on_heads(values: Sequence[Decimal]) -> tuple[Array, Array]:
    """Return numbers of at most 1 as heads of 22 bits and what is left of them, for combined().

    Parameters
    ----------
    values : sequence of Decimal
        The numbers.

    Returns
    -------
    tuple of two ndarrays, each (n,)
        Heads and rests.
    """
    with precise():
        heads = [round(float(value) * _UNIT) / _UNIT for value in values]
        rests = [float(value - Decimal(head)) for value, head in zip(values, heads, strict=True)]
    return np.array(heads), np.array(rests)


def combined(
    rows: tuple[Array, Array], sinusoids: Sequence[ExactSinusoid], t: Array, quantities: Sequence[str]
) -> Array:
    """Return the sum of sinusoids of one quantity each, times the row of each.

    Parameters
    ----------
    rows : tuple of two ndarrays, each (sinusoids, quantities)
        Heads and rests of the rows, from on_heads().
    sinusoids : sequence of ExactSinusoid
        The sinusoids; no frequency is 0.
    t : ndarray (n,)
        Times in s.
    quantities : sequence of str
        Their names. ValueError names the quantity that leaves the range of doubles.

    Returns
    -------
    ndarray (quantities, n)
        The values. Errors are 0.5 ulp of the result and less than 0.01 u of the amplitudes.
    """
    if not sinusoids:
        return np.zeros((len(quantities), t.size))
    heads, tails = _circle([one.omega for one in sinusoids], t)
    with precise():
        sines = [b / one.omega for one in sinusoids for b in one.sine]
    lead, rest, exponents = _on_a_grid([sines, [a for one in sinusoids for a in one.cosine]])
    common = max((e for e in exponents if e > _NOTHING), default=0)
    lead, rest = (np.ldexp(part, np.array(exponents)[:, np.newaxis] - common).T for part in (lead, rest))
    low = np.einsum("ck,ckn->kn", rest, heads) + np.einsum("ck,ckn->kn", lead + rest, tails)
    whole = np.einsum("ck,ckn->kn", lead, heads)
    first = np.rint(whole * _UNIT) / _UNIT
    last = (whole - first) + low
    head, tail = (part.T for part in rows)
    values = head @ first + (tail @ first + (head + tail) @ last)
    with np.errstate(over="ignore"):
        return rows_in_range(quantities, shifted(values, np.array(common)))


def apart(sinusoids: Sequence[ExactSinusoid], t: Array, quantities: Sequence[str]) -> Array:
    """Return each sinusoid as added() has it alone; in one sum, of as many more rows.

    Parameters
    ----------
    sinusoids : sequence of ExactSinusoid
        The sinusoids.
    t : ndarray (n,)
        Times in s.
    quantities : sequence of str
        The names of the quantities, for the message of an error.

    Returns
    -------
    ndarray (sinusoids, quantities, n)
        The values, each in its unit.

    Raises
    ------
    ValueError
        If a quantity, which the message names, leaves the range of doubles.
    """
    count, none = len(sinusoids), [_NONE] * len(quantities)
    rows = [
        ExactSinusoid(one.omega, *([*none * i, *part, *none * (count - 1 - i)] for part in (one.cosine, one.sine)))
        for i, one in enumerate(sinusoids)
    ]
    return added(rows, t, [*quantities] * count).reshape(count, len(quantities), t.size)


def total(
    t: Array, quantities: Sequence[str], quick: Sequence[ExactSinusoid] = (), slow: Sequence[ExactSinusoid] = (),
    beats: Sequence[Beat] = (), curves: Iterable[Weighted] = (),
) -> Array:  # fmt: skip
    """Return the sum of sinusoids, beats and curves.

    Parameters
    ----------
    t : ndarray (n,)
        Times in s.
    quantities : sequence of str
        The name of each quantity in an error message.
    quick, slow : sequence of ExactSinusoid
        Sinusoids. The slow ones turn by less than 1/16 rad at all times t.
    beats, curves : sequence of Beat, iterable of Weighted
        Beats, whose d turns by less than 1/16 rad too, and curves. Coefficients left out at the end are 0.

    Returns
    -------
    ndarray (quantities, n)
        The sums.

    Raises
    ------
    ValueError
        If a quantity leaves the range of doubles.
    """
    curves = list(curves)
    if not (quick or slow or beats or curves) or not t.size:
        return np.zeros((len(quantities), t.size))
    heads, tails, columns, more = _as_rows(t, len(quantities), quick, slow, beats)
    values, exponents = _summed(heads, tails, columns, [*curves, *more])
    with np.errstate(over="ignore"):
        return rows_in_range(quantities, shifted(values, exponents))


def _as_rows(
    t: Array, count: int, quick: Sequence[ExactSinusoid], slow: Sequence[ExactSinusoid], beats: Sequence[Beat]
) -> tuple[Array, Array, list[Coefficients], list[Weighted]]:
    """Heads and tails (rows, n) of the functions to sum, the coefficients of each row, and curves to add to them."""
    heads, tails = _circle([*(one.omega for one in quick), *(beat.s for beat in beats)], t)
    curves = [part for j, beat in enumerate(beats, len(quick)) for part in _growing(beat, t, heads[:, j], tails[:, j])]
    with precise():
        columns: list[Coefficients] = [[b / one.omega for b in one.sine] for one in quick]
    columns += [beat.sine for beat in beats] + [one.cosine for one in quick] + [[_NONE] * count] * len(beats)
    head_rows, tail_rows = heads.reshape(-1, t.size), tails.reshape(-1, t.size)
    for one in slow:
        versine, excess = _small(one.omega, t)
        time, unit = _counted(t)
        head_rows, tail_rows = np.vstack([head_rows, np.ones_like(t)]), np.vstack([tail_rows, versine])
        columns.append(one.cosine)
        curves.append(Weighted(ScaledCurve(time, time * excess, unit), one.sine))
    return head_rows, tail_rows, columns, curves


def _growing(beat: Beat, t: Array, heads: Array, tails: Array) -> list[Weighted]:
    """Sine and cosine of s t times sin(d t)/d; the tail of the sine becomes the tail of cos(d t) sin(s t)."""
    versine, excess = _small(beat.d, t)
    time, unit = _counted(t)
    hi = time * heads
    time_hi, time_lo = halves(time)
    lost = (time_hi * heads - hi) + time_lo * heads
    sine, cosine = hi
    sine_rest, cosine_rest = lost + time * (tails + excess * (heads + tails))
    tails[0] += versine * (heads[0] + tails[0])
    return [
        Weighted(ScaledCurve(cosine, cosine_rest, unit), beat.growing_cosine),
        Weighted(ScaledCurve(sine, sine_rest, unit), beat.growing_sine),
    ]


def _counted(t: Array) -> tuple[Array, Decimal]:
    """t in a power of two not below the largest of them, and that power."""
    exponent = math.frexp(np.abs(t).max(initial=0.0))[1]
    return shifted(t, np.array(-exponent)), _power_of_two(exponent)


def _small(omega: Decimal, t: Array) -> tuple[Array, Array]:
    """cos(x) - 1 and sin(x)/x - 1 at x = omega t, up to 1/16."""
    with np.errstate(over="ignore", invalid="ignore"):
        square = np.nan_to_num((float(omega) * t) ** 2)
    both = np.broadcast_to(_SMALL[0], (2, t.size))
    for coefficients in _SMALL[1:]:
        both = both * square + coefficients
    versine, excess = both * square
    return versine, excess


def _circle(frequencies: Sequence[Decimal], t: Array) -> tuple[Array, Array]:
    """Heads and tails of sin(omega t) and cos(omega t), each (2, frequencies, n)."""
    if not frequencies:
        return np.empty((2, 0, t.size)), np.empty((2, 0, t.size))
    index, r = _nearest(frequencies, t)
    points = _TABLE.take(index, axis=1)
    heads, rests = points[:2], points[2:]
    whole, square = heads + rests, r * r
    excess = r + r * square * (square / 120 - 1 / 6)
    tails = rests + whole * (square * (square / 24 - 1 / 2))
    tails[0] += whole[1] * excess
    tails[1] -= whole[0] * excess
    return heads, tails


def _nearest(frequencies: Sequence[Decimal], t: Array) -> tuple[NDArray[np.int_], Array]:
    """The nearest point of the table to each phase, and the angle in rad from it; (frequencies, n)."""
    with precise():
        speeds = [omega * _POINTS_A_RADIAN for omega in frequencies]
    hi, lo, exponents = (np.array(column)[:, np.newaxis] for column in zip(*map(binary, speeds), strict=True))
    with np.errstate(over="ignore"):
        time = shifted(t, exponents)
    far = np.abs(time) > _FAR
    any_far = bool(far.any())
    if any_far:
        time = np.where(far, 0.0, time)
    place, rest = two_product(hi, time)
    whole = np.rint(place)
    part = (place - whole) + (rest + lo * time)
    if any_far:
        for j in np.flatnonzero(far.any(axis=1)):
            places = remainders(speeds[j], t[far[j]], _POINTS)
            nearest = [(place + _HALF) >> FINE for place in places]
            whole[j, far[j]] = nearest
            part[j, far[j]] = [(place - (n << FINE)) / (_HALF << 1) for place, n in zip(places, nearest, strict=True)]
    return whole.astype(np.int64) & (_POINTS - 1), part * _STEP


def _summed(
    heads: Array, tails: Array, columns: Sequence[Coefficients], curves: Sequence[Weighted]
) -> tuple[Array, NDArray[np.int_]]:
    """The sum as (rows, n), and the power of two (rows, 1) that it is counted in."""
    lead, rest, exponents = _on_a_grid(columns)
    with precise():
        scaled = [[c * curve.scale for c in row] for curve, row in curves]
    largest = map(max, zip_longest(exponents, *(map(_exponent, row) for row in scaled), fillvalue=_NOTHING))
    common = np.array([exponent if exponent > _NOTHING else 0 for exponent in largest])[:, np.newaxis]
    if curves:
        shift = np.array(exponents)[:, np.newaxis] - common
        lead, rest = np.ldexp(lead, shift), np.ldexp(rest, shift)
    whole, low = lead @ heads, rest @ heads + (lead + rest) @ tails
    for (curve, _), column in zip(curves, scaled, strict=True):
        rows = [i for i, c in enumerate(column) if c]
        if rows:
            hi, lo = _in_units([column[i] for i in rows], common[rows])
            hi_head, hi_tail = halves(hi)
            head, tail = halves(curve.hi)
            whole[rows], error = two_sum(whole[rows], hi_head * head)
            low[rows] += error + np.hstack([hi_head, hi_tail + lo, hi]) @ np.stack([tail, curve.hi, curve.lo])
    return whole + low, common


def _on_a_grid(columns: Sequence[Coefficients]) -> tuple[Array, Array, list[int]]:
    """The rows of coefficients as heads and rests (rows, columns), and the power of two of each row."""
    rows = list(zip_longest(*columns, fillvalue=_NONE))
    with precise():
        exponents = [_exponent(max(map(abs, row))) for row in rows]
        units = [_power_of_two(_COEFFICIENT + _REST - e) if e > _NOTHING else _NONE for e in exponents]
        whole = [[int(c * unit) for c in row] for row, unit in zip(rows, units, strict=True)]
    lead = np.array([[c >> _REST for c in row] for row in whole], dtype=np.float64)
    rest = np.array([[c & _MASK for c in row] for row in whole], dtype=np.float64)
    return lead * 2.0**-_COEFFICIENT, rest * 2.0 ** -(_COEFFICIENT + _REST), exponents


def _in_units(column: Coefficients, exponents: NDArray[np.int_]) -> tuple[Array, Array]:
    """The numbers in powers of two as hi + lo (rows, 1)."""
    with precise():
        pairs = [split(c * _power_of_two(-e)) for c, e in zip(column, exponents[:, 0].tolist(), strict=True)]
    hi, lo = np.array(pairs).T[..., np.newaxis]
    return hi, lo


def _exponent(value: Decimal) -> int:
    """The least e with |value| <= 2^e."""
    if not value:
        return _NOTHING
    size = abs(float(value))
    if 1e-290 < size < 1e290:
        return math.frexp(size)[1]
    return binary(value)[2]


@cache
def _power_of_two(exponent: int) -> Decimal:
    with precise():
        return Decimal(2) ** exponent


def _table() -> Array:
    """Heads of sine and cosine at every point, and what is left of them (4, points); an eighth of the turn is all."""
    with precise():
        c, s = Decimal(0), Decimal(1)
        for _ in range(_POINTS.bit_length() - 3):
            c, s = ((1 + c) / 2).sqrt(), ((1 - c) / 2).sqrt()
        eighth = [(Decimal(0), Decimal(1))]
        for _ in range(_POINTS // 8):
            sine, cosine = eighth[-1]
            eighth.append((sine * c + cosine * s, cosine * c - sine * s))
        exactly = [value for values in zip(*eighth, strict=True) for value in values]
        heads = [round(value * 2**_HEAD) / 2**_HEAD for value in exactly]
        rests = [float(value - Decimal(head)) for value, head in zip(exactly, heads, strict=True)]
    sines, cosines = np.array([heads, rests]).reshape(2, 2, -1).transpose(1, 0, 2)
    quarter = np.concatenate([sines, cosines[:, -2:0:-1]], axis=1)
    half = np.concatenate([quarter, np.concatenate([cosines, sines[:, -2:0:-1]], axis=1)], axis=1)
    every = np.concatenate([half, -half], axis=1)
    ahead = np.roll(every, -_POINTS // 4, axis=1)
    return np.array([every[0], ahead[0], every[1], ahead[1]])


with precise():
    _POINTS_A_RADIAN = _POINTS / (2 * PI)
_STEP = 2.0 * math.pi / _POINTS
_TABLE = _table()
