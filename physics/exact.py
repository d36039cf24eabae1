"""Numbers carried beyond double precision: the numerical foundation of every motion.

A change of a parameter needs a handful of scalars, a plot needs them at a thousand times. So scalars are
worked out in 80-digit decimal arithmetic with unbounded exponents and rounded once; arrays stay in float64,
and where that is not enough a number is an unevaluated sum hi + lo of two doubles.

Sources: T. J. Dekker, Numer. Math. 18 (1971) 224 (two_product, with the splitting of G. W. Veltkamp);
D. E. Knuth, TAOCP 2, 4.2.2 (two_sum); W. Kahan on compensation; T. Ogita, S. M. Rump, S. Oishi, SIAM J. Sci.
Comput. 26 (2005) 1955 (sums and products of such pairs).
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
_VELTKAMP = 2.0**27 + 1.0
_FAR = 2.0**53  # rad; past it a phase is reduced in decimal, angle by angle


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


def angle(omega: Decimal, t: Array) -> Pair:
    """omega t as hi + lo, known to 1e-16 rad up to 1e15 rad; above 2**53 rad modulo 2 pi."""
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
    """sin and cos of theta + rest, each as hi + lo: as near as numpy.sin and numpy.cos of a double are.

    The low part turns the pair by a small angle; 1 - cos(rest) = 2 sin(rest / 2)**2 keeps that exact enough.
    """
    s, c = np.sin(theta), np.cos(theta)
    turn, versine = np.sin(rest), 2.0 * np.sin(0.5 * rest) ** 2
    return two_sum(s, c * turn - s * versine), two_sum(c, -s * turn - c * versine)


def sin_cos(omega_hi: float, omega_lo: float, t: Array, phase: float = 0.0) -> tuple[Array, Array]:
    """sin and cos of (omega_hi + omega_lo) t + phase, off by at most 1.1 u while |omega t| < 1e15.

    t (n,) in s; any finite omega and t. Dekker's product gives omega t without error.
    """
    with precise():
        theta, rest = angle(exact(omega_hi) + exact(omega_lo), t)
    theta, shift = two_sum(theta, phase)
    sine, cosine = circle(theta, rest + shift)
    return sine[0], cosine[0]
