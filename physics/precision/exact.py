"""Numbers carried beyond double precision: the numerical foundation of every motion.

A change of a parameter needs a handful of scalars, a plot needs them at a thousand times. So scalars are
worked out in 80-digit decimal arithmetic with unbounded exponents and rounded once; arrays stay in float64,
and where that is not enough a number is an unevaluated sum hi + lo of two doubles.

Sources: T. J. Dekker, Numer. Math. 18 (1971) 224 (two_product, with the splitting of G. W. Veltkamp);
D. E. Knuth, TAOCP 2, 4.2.2 (two_sum); W. Kahan on compensation; T. Ogita, S. M. Rump, S. Oishi, SIAM J. Sci.
Comput. 26 (2005) 1955 (sums and products of such pairs); W. J. Cody, W. Waite, Software Manual for the
Elementary Functions (1980), and S. Gal, B. Bachelis, ACM Trans. Math. Softw. 17 (1991) 26 (sine and cosine).
"""

import math
from contextlib import AbstractContextManager, nullcontext
from decimal import (
    MAX_EMAX,
    MIN_EMIN,
    ROUND_HALF_EVEN,
    Context,
    Decimal,
    DivisionByZero,
    InvalidOperation,
    Overflow,
    getcontext,
    localcontext,
)
from typing import Any

import numpy as np
from numpy.typing import NDArray

from physics.valid import DOUBLES

Array = NDArray[np.float64]
DoubleDouble = tuple[Array, Array]  # hi, lo: an unevaluated sum

DIGITS = 80
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534")
NOISE = Decimal("1e-60")  # if a sum cancels to this share, the rest is rounding error of the 80 digits

_CONTEXT = Context(
    prec=DIGITS,
    rounding=ROUND_HALF_EVEN,
    Emin=MIN_EMIN,
    Emax=MAX_EMAX,
    traps=[InvalidOperation, DivisionByZero, Overflow],
)
_STAY: AbstractContextManager[None] = nullcontext()
_POINTS = 32  # points of the circle with tabulated sine and cosine
_FAR = 2.0**50  # rad; larger phases are reduced in integers, one by one
_MANTISSA = 53  # bits of a double
FINE = 384  # bits after the point of a phase; a time of 53 bits leaves more than the 80 digits of them
_FACTORS = 1000  # powers of two up to here, and their inverses, are doubles
_VELTKAMP = 2.0**27 + 1.0


def precise() -> AbstractContextManager[Context | None]:
    """Open an 80-digit decimal context, `with precise(): ...`, or stay in the one that is open."""
    return _STAY if getcontext().prec >= DIGITS else localcontext(_CONTEXT)


def exact(x: float) -> Decimal:
    """Return the double x, digit for digit."""
    return Decimal(float(x))


def within_an_ulp(x: float, value: Decimal) -> bool:
    """Return True if x is within one ulp of value."""
    with precise():
        return abs(exact(x) - value) <= exact(math.ulp(x))


def rounded(quantity: str, value: Decimal) -> float:
    """Return the double nearest to value; ValueError names the `quantity` if there is none."""
    result = float(value)
    if math.isinf(result):
        raise ValueError(f"{quantity} = {value:.3e} leaves {DOUBLES}")
    return result


def split(value: Decimal) -> tuple[float, float]:
    """Return doubles (hi, lo) with hi + lo = value to 106 bits (hi = inf and lo = 0 beyond the range)."""
    hi = float(value)
    if math.isinf(hi):
        return hi, 0.0
    with precise():
        return hi, float(value - Decimal(hi))


def snapped(value: Decimal) -> Decimal:
    """Return the double from which value differs only by the rounding of its 80 digits; if there is none, value."""
    near = float(value)
    if math.isinf(near):
        return value
    double = Decimal(near)
    with precise():
        return double if abs(value - double) <= NOISE * abs(value) else value


def sum_of(a: Decimal, b: Decimal) -> Decimal:
    """Return a + b; 0 where they cancel down to the rounding of the 80 digits."""
    with precise():
        total = a + b
        return total if abs(total) > NOISE * (abs(a) + abs(b)) else Decimal(0)


def binary(value: Decimal) -> tuple[float, float, int]:
    """Return (hi, lo, e) with value = (hi + lo) 2**e and 0.5 <= |hi| <= 1, however large or small the value is."""
    if not value:
        return 0.0, 0.0, 0
    with precise():
        shift = 0 if -280 < value.adjusted() < 300 else math.floor(value.adjusted() * math.log2(10.0))
        scaled = value / Decimal(2) ** shift if shift else value
        whole = float(scaled)
        hi, exponent = math.frexp(whole)
        return hi, math.ldexp(float(scaled - Decimal(whole)), -exponent), exponent + shift


def shifted(values: Array, exponents: NDArray[np.int_]) -> Array:
    """Return values 2^exponents, by a product where that is as exact and faster."""
    if max(-exponents.min(), exponents.max()) < _FACTORS:
        return values * np.ldexp(1.0, exponents)
    return np.ldexp(values, exponents)


def two_sum(a: Any, b: Any) -> DoubleDouble:
    """Return (s, e) with s = fl(a + b) and s + e = a + b exactly (Knuth)."""
    s = a + b
    z = s - a
    return s, (a - (s - z)) + (b - z)


def halves(a: Any) -> DoubleDouble:
    """Return (hi, lo) of 26 bits each with hi + lo = a exactly (Veltkamp); |a| < 2**996."""
    c = _VELTKAMP * a
    hi = c - (c - a)
    return hi, a - hi


def two_product(a: Any, b: Any) -> DoubleDouble:
    """Return (p, e) with p = fl(a b) and p + e = a b exactly (Dekker); |a|, |b|, |a b| < 2**996, |a b| > 2**-968."""
    p = a * b
    a_hi, a_lo = halves(a)
    b_hi, b_lo = halves(b)
    return p, ((a_hi * b_hi - p) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo


def pair_sum(a: tuple[Any, Any], b: tuple[Any, Any]) -> DoubleDouble:
    """Return a + b for pairs (hi, lo); where the high parts cancel to nothing the low ones remain, digit for digit."""
    s, e = two_sum(a[0], b[0])
    return two_sum(s, e + (a[1] + b[1]))


def pair_product(a: tuple[Any, Any], b: tuple[Any, Any]) -> DoubleDouble:
    """Return a b for pairs (hi, lo), to about 104 bits."""
    p, e = two_product(a[0], b[0])
    return p, e + (a[0] * b[1] + a[1] * b[0])


def pair_quotient(a: tuple[Any, Any], b: tuple[Any, Any]) -> Any:
    """Return a/b for pairs (hi, lo), rounded to one double: the quotient of the high parts, corrected once."""
    first = a[0] / b[0]
    p, e = two_product(first, b[0])
    return first + ((a[0] - p) - e + a[1] - first * b[1]) / b[0]


def sin_cos(omega_hi: float, omega_lo: float, t: Array, phase: float = 0.0) -> tuple[Array, Array]:
    """Return the sine and cosine of a phase, rounded about once while |omega t| < 1e15.

    Parameters
    ----------
    omega_hi, omega_lo : float
        The frequency in rad/s as a sum of two doubles.
    t : ndarray (n,)
        Times in s, any finite ones.
    phase : float
        The phase in rad at t = 0.

    Returns
    -------
    tuple of two ndarrays, each (n,)
        sin and cos of (omega_hi + omega_lo) t + phase.
    """
    with precise():
        theta, rest = angle(exact(omega_hi) + exact(omega_lo), t)
    theta, shift = two_sum(theta, phase)
    sine, cosine = on_circle(theta, rest + shift)
    return sine[0], cosine[0]


def angle(omega: Decimal, t: Array) -> DoubleDouble:
    """Return omega t in rad as hi + lo, known to 1e-16 rad up to 1e15 rad; above 2**50 rad modulo 2 pi."""
    if not omega:
        return np.zeros_like(t), np.zeros_like(t)
    hi, lo, exponent = binary(omega)
    with np.errstate(over="ignore"):
        scaled = np.ldexp(t, exponent)
    far = np.abs(scaled) > _FAR
    scaled = np.where(far, 0.0, scaled)
    theta, rest = two_product(hi, scaled)
    rest = rest + lo * scaled
    if far.any():
        with precise():
            turns = remainders(omega / (2 * PI), t[far], 1)
        theta[far], rest[far] = np.transpose([_in_doubles(turn * _TURN >> FINE) for turn in turns])
    return theta, rest


def _in_doubles(units: int) -> tuple[float, float]:
    """(hi, lo) of a number below 1024 that is counted in units of 2^-FINE."""
    hi = units / (1 << FINE)
    return hi, (units - int(math.ldexp(hi, FINE))) / (1 << FINE)


def remainders(rate: Decimal, t: Array, whole: int) -> list[int]:
    """Return remainders of rate t, exact however many turns are left out.

    A time is an integer below 2^53 times a power of two: the rate is reduced once for each power.

    Parameters
    ----------
    rate : Decimal
        Turns per second.
    t : ndarray (n,)
        Times in s.
    whole : int
        The modulus in turns.

    Returns
    -------
    list of int
        rate t modulo `whole`, in units of 2^-FINE turns.
    """
    mantissas, exponents = np.frexp(t)
    above, below = rate.as_integer_ratio()
    modulus = whole << FINE
    units: dict[int, int] = {}
    for e in set(exponents.tolist()):
        shift = e - _MANTISSA + FINE
        units[e] = (above << max(0, shift)) // (below << max(0, -shift)) % modulus
    integers = np.ldexp(mantissas, _MANTISSA).astype(np.int64).tolist()
    return [integer * units[e] % modulus for integer, e in zip(integers, exponents.tolist(), strict=True)]


def on_circle(theta: Array, rest: Array) -> tuple[DoubleDouble, DoubleDouble]:
    """Return sin and cos of theta + rest in rad, each as hi + lo; |theta| up to 2**50, |rest| up to the ulp of theta.

    The library's functions are off by half an ulp, some vectorised ones by four. Here the phase is reduced to
    the nearest of 32 points of the circle with 2 pi/32 in three doubles (Cody and Waite), and the point is
    turned by what remains, less than 0.2 rad, whose series need only float64.
    """
    point, (r, r_lo) = nearest_point(theta, rest)
    square = r * r
    versine = square * _polynomial(square, 1 / 479001600, -1 / 3628800, 1 / 40320, -1 / 720, 1 / 24, -1 / 2)
    excess = square * _polynomial(square, 1 / 6227020800, -1 / 39916800, 1 / 362880, -1 / 5040, 1 / 120, -1 / 6)
    excess = r_lo + r * excess
    (s, s_lo), (c, c_lo) = ((hi[point], lo[point]) for hi, lo in (SINES, COSINES))
    return (
        _turned(s, s_lo + s * versine + c * excess, c, c_lo, r),
        _turned(c, c_lo + c * versine - s * excess, -s, -s_lo, r),
    )


def _polynomial(x: Array, *coefficients: float) -> Array:
    """The highest power first (Horner)."""
    result = np.full_like(x, coefficients[0])
    for coefficient in coefficients[1:]:
        result = result * x + coefficient
    return result


def _turned(start: Array, correction: Array, slope: Array, slope_lo: Array, r: Array) -> DoubleDouble:
    """start + slope r + correction, the product without error."""
    p, e = two_product(slope, r)
    hi, lo = two_sum(start, p)
    return two_sum(hi, lo + (e + slope_lo * r + correction))


def nearest_point(theta: Array, rest: Array) -> tuple[NDArray[np.intp], DoubleDouble]:
    """Return which of the 32 points of the circle is nearest to theta + rest in rad, and the angle from it (hi, lo)."""
    count = np.rint(theta / _STEP[0])
    return np.mod(count, _POINTS).astype(np.intp), reduced(theta, rest, count, _STEP)


def reduced(theta: Array, rest: Array, count: Array, step: tuple[float, float, float]) -> DoubleDouble:
    """Return an angle less a whole number of steps; the leading subtraction is exact.

    Parameters
    ----------
    theta, rest : ndarray (n,)
        The angle theta + rest in rad.
    count : ndarray (n,)
        Whole numbers of steps, next to theta/step.
    step : tuple of three floats
        The step in rad as an unevaluated sum.

    Returns
    -------
    tuple of two ndarrays, each (n,)
        theta + rest - count step in rad as hi + lo.
    """
    p1, e1 = two_product(count, step[0])
    p2, e2 = two_product(count, step[1])
    r, low1 = two_sum(theta - p1, -e1)
    r, low2 = two_sum(r, -p2)
    r, low3 = two_sum(r, rest)
    return two_sum(r, low1 + low2 + low3 - e2 - count * step[2])


def three_doubles(value: Decimal) -> tuple[float, float, float]:
    """Return three doubles whose unevaluated sum is the value to 159 bits."""
    first, second = split(value)
    with precise():
        return first, second, float(value - Decimal(first) - Decimal(second))


def _step() -> tuple[float, float, float]:
    """2 pi/32."""
    with precise():
        return three_doubles(2 * PI / _POINTS)


def _points() -> tuple[DoubleDouble, DoubleDouble]:
    """Sines and cosines of the 32 points as hi + lo, the first from half angles, the others by addition."""
    with precise():
        c, s = Decimal(0), Decimal(1)
        for _ in range(3):
            c, s = ((1 + c) / 2).sqrt(), ((1 - c) / 2).sqrt()
        sines, cosines = [Decimal(0)], [Decimal(1)]
        for _ in range(_POINTS - 1):
            sines.append(sines[-1] * c + cosines[-1] * s)
            cosines.append(cosines[-1] * c - sines[-2] * s)
    return _pairs(sines), _pairs(cosines)


def _pairs(values: list[Decimal]) -> DoubleDouble:
    hi, lo = np.transpose([split(value) if abs(value) > Decimal("1e-70") else (0.0, 0.0) for value in values])
    return hi, lo


_STEP = _step()
with precise():
    _TURN = int(2 * PI * (1 << FINE))
SINES, COSINES = _points()
