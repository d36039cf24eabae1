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
from contextlib import AbstractContextManager
from decimal import (
    MAX_EMAX,
    MIN_EMIN,
    ROUND_HALF_EVEN,
    Context,
    Decimal,
    DivisionByZero,
    InvalidOperation,
    Overflow,
    localcontext,
)
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Pair = tuple[Array, Array]  # hi, lo: an unevaluated sum

DIGITS = 80
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534")
NOISE = Decimal("1e-60")  # what is left of a sum that cancels so far is rounding of the 80 digits

_CONTEXT = Context(
    prec=DIGITS,
    rounding=ROUND_HALF_EVEN,
    Emin=MIN_EMIN,
    Emax=MAX_EMAX,
    traps=[InvalidOperation, DivisionByZero, Overflow],
)
_POINTS = 32  # of the circle, with tabulated sine and cosine
_FAR = 2.0**50  # rad; past it a phase is reduced in decimal, angle by angle
_VELTKAMP = 2.0**27 + 1.0


def precise() -> AbstractContextManager[Context]:
    """Open an 80-digit decimal context: `with precise(): ...`."""
    return localcontext(_CONTEXT)


def exact(x: float) -> Decimal:
    """The double x, digit for digit."""
    return Decimal(float(x))


def rounded(quantity: str, value: Decimal) -> float:
    """The double nearest to value; ValueError names the quantity if there is none."""
    result = float(value)
    if math.isinf(result):
        raise ValueError(f"{quantity} = {value:.3e} leaves the range of doubles")
    return result


def split(value: Decimal) -> tuple[float, float]:
    """Doubles (hi, lo) with hi + lo = value to 106 bits (hi = inf and lo = 0 beyond the range)."""
    hi = float(value)
    if math.isinf(hi):
        return hi, 0.0
    with precise():
        return hi, float(value - Decimal(hi))


def snapped(value: Decimal) -> Decimal:
    """The double that value is but for the rounding of its 80 digits, if there is one, else value."""
    hi = float(value)
    if math.isinf(hi):
        return value
    with precise():
        return Decimal(hi) if abs(value - Decimal(hi)) <= NOISE * abs(value) else value


def sum_of(a: Decimal, b: Decimal) -> Decimal:
    """a + b, and zero where they cancel down to the rounding of the 80 digits."""
    with precise():
        total = a + b
        return total if abs(total) > NOISE * (abs(a) + abs(b)) else Decimal(0)


def binary(value: Decimal) -> tuple[float, float, int]:
    """(hi, lo, e) with value = (hi + lo) 2**e and 0.5 <= |hi| <= 1, however large or small the value is."""
    if not value:
        return 0.0, 0.0, 0
    with precise():
        shift = 0 if -280 < value.adjusted() < 300 else math.floor(value.adjusted() * math.log2(10.0))
        scaled = value / Decimal(2) ** shift if shift else value
        whole = float(scaled)
        hi, exponent = math.frexp(whole)
        return hi, math.ldexp(float(scaled - Decimal(whole)), -exponent), exponent + shift


def two_sum(a: Any, b: Any) -> Pair:
    """(s, e) with s = fl(a + b) and s + e = a + b exactly (Knuth)."""
    s = a + b
    z = s - a
    return s, (a - (s - z)) + (b - z)


def halves(a: Any) -> Pair:
    """(hi, lo) of 26 bits each with hi + lo = a exactly (Veltkamp); |a| < 2**996."""
    c = _VELTKAMP * a
    hi = c - (c - a)
    return hi, a - hi


def two_product(a: Any, b: Any) -> Pair:
    """(p, e) with p = fl(a b) and p + e = a b exactly (Dekker); |a|, |b|, |a b| < 2**996, |a b| > 2**-968."""
    p = a * b
    a_hi, a_lo = halves(a)
    b_hi, b_lo = halves(b)
    return p, ((a_hi * b_hi - p) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo


def pair_sum(a: tuple[Any, Any], b: tuple[Any, Any]) -> Pair:
    """a + b; where the leading parts cancel to nothing the low ones remain, digit for digit."""
    s, e = two_sum(a[0], b[0])
    return two_sum(s, e + (a[1] + b[1]))


def pair_product(a: tuple[Any, Any], b: tuple[Any, Any]) -> Pair:
    """a b to about 104 bits."""
    p, e = two_product(a[0], b[0])
    return p, e + (a[0] * b[1] + a[1] * b[0])


def pair_quotient(a: tuple[Any, Any], b: tuple[Any, Any]) -> Any:
    """a/b rounded to one double: the quotient of the leading parts, corrected once."""
    first = a[0] / b[0]
    p, e = two_product(first, b[0])
    return first + ((a[0] - p) - e + a[1] - first * b[1]) / b[0]


def sin_cos(omega_hi: float, omega_lo: float, t: Array, phase: float = 0.0) -> tuple[Array, Array]:
    """sin and cos of (omega_hi + omega_lo) t + phase, rounded about once while |omega t| < 1e15.

    t (n,) in s; any finite omega and t.
    """
    with precise():
        theta, rest = angle(exact(omega_hi) + exact(omega_lo), t)
    theta, shift = two_sum(theta, phase)
    sine, cosine = circle(theta, rest + shift)
    return sine[0], cosine[0]


def angle(omega: Decimal, t: Array) -> Pair:
    """omega t as hi + lo, known to 1e-16 rad up to 1e15 rad; above 2**50 rad modulo 2 pi."""
    hi, lo, exponent = binary(omega)
    with np.errstate(over="ignore"):
        scaled = np.ldexp(t, exponent)
    far = np.abs(scaled) > _FAR
    scaled = np.where(far, 0.0, scaled)
    theta, rest = two_product(hi, scaled)
    rest = rest + lo * scaled
    for i in np.flatnonzero(far):
        theta[i], rest[i] = split(_modulo_turn(omega, t[i]))
    return theta, rest


def _modulo_turn(omega: Decimal, t: float) -> Decimal:
    time = exact(t)
    with precise() as context:
        context.prec += omega.adjusted() + time.adjusted()
        return (omega / (2 * PI) * time % 1) * (2 * PI)


def circle(theta: Array, rest: Array) -> tuple[Pair, Pair]:
    """sin and cos of theta + rest, each as hi + lo; |theta| up to 2**50, |rest| up to the ulp of theta.

    The library's functions are off by half an ulp, some vectorised ones by four. Here the phase is reduced to
    the nearest of 32 points of the circle with 2 pi/32 in three doubles (Cody and Waite), and the point is
    turned by what remains, less than 0.2 rad, whose series need only float64.
    """
    count = np.rint(theta / _STEP[0])
    point = np.mod(count, _POINTS).astype(np.intp)
    r, r_lo = _reduced(theta, rest, count)
    square = r * r
    versine = square * _polynomial(square, 1 / 479001600, -1 / 3628800, 1 / 40320, -1 / 720, 1 / 24, -1 / 2)
    excess = square * _polynomial(square, 1 / 6227020800, -1 / 39916800, 1 / 362880, -1 / 5040, 1 / 120, -1 / 6)
    excess = r_lo + r * excess
    (s, s_lo), (c, c_lo) = ((hi[point], lo[point]) for hi, lo in (_SINES, _COSINES))
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


def _turned(start: Array, correction: Array, slope: Array, slope_lo: Array, r: Array) -> Pair:
    """start + slope r + correction, the product without error."""
    p, e = two_product(slope, r)
    hi, lo = two_sum(start, p)
    return two_sum(hi, lo + (e + slope_lo * r + correction))


def _reduced(theta: Array, rest: Array, count: Array) -> Pair:
    """theta + rest - count 2 pi/32 as hi + lo; its leading subtraction is exact."""
    p1, e1 = two_product(count, _STEP[0])
    p2, e2 = two_product(count, _STEP[1])
    r, low1 = two_sum(theta - p1, -e1)
    r, low2 = two_sum(r, -p2)
    r, low3 = two_sum(r, rest)
    return two_sum(r, low1 + low2 + low3 - e2 - count * _STEP[2])


def _step() -> tuple[float, float, float]:
    """2 pi/32 as three doubles."""
    with precise():
        step = 2 * PI / _POINTS
        first, second = split(step)
        return first, second, float(step - Decimal(first) - Decimal(second))


def _points() -> tuple[Pair, Pair]:
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


def _pairs(values: list[Decimal]) -> Pair:
    hi, lo = np.transpose([split(value) if abs(value) > Decimal("1e-70") else (0.0, 0.0) for value in values])
    return hi, lo


_STEP = _step()
_SINES, _COSINES = _points()
