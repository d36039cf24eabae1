"""Polynomials with rational coefficients, the constant first: products, and real roots with their multiplicity.

Multiplicities are exact: the factors of each are separated by greatest common divisors (D. Y. Y. Yun, SYMSAC 1976, 26).
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cache, reduce
from itertools import zip_longest
from typing import Any

from mpmath.ctx_mp import MPContext

from physics.precision.roots import roots

Polynomial = tuple[Fraction, ...]

DIGITS = 120


def product(*factors: Polynomial) -> Polynomial:
    """Return the product of polynomials; 1 of none."""
    return reduce(_times, factors, (Fraction(1),))


def added(*terms: Polynomial) -> Polynomial:
    """Return the sum of polynomials."""
    return tuple(sum(column, Fraction(0)) for column in zip_longest(*terms, fillvalue=Fraction(0)))


def negative(a: Polynomial) -> Polynomial:
    """Return -a."""
    return tuple(-one for one in a)


def derivative(a: Polynomial) -> Polynomial:
    """Return the derivative of `a`."""
    return tuple(k * one for k, one in enumerate(a))[1:] or (Fraction(0),)


def trimmed(a: Polynomial) -> Polynomial:
    """Return `a` without its highest powers where these are 0; empty if it is 0."""
    while a and not a[-1]:
        a = a[:-1]
    return a


def order(a: Polynomial) -> int:
    """Return how often the factor s is contained in `a`; for a zero polynomial, more than any other has."""
    return next((k for k, one in enumerate(a) if one), 99)


@cache
def context(digits: int) -> Any:
    """Return a context of mpmath with so many decimal `digits`, cached because making one takes longer than a sum."""
    ctx = MPContext()
    ctx.dps = digits
    return ctx


def numbers(ctx: Any, a: Polynomial) -> list[Any]:
    """Return the coefficients of `a` as numbers of the context `ctx`."""
    return [ctx.mpf(one.numerator) / one.denominator for one in a]


def positive_roots(a: Polynomial) -> list[tuple[Any, int]]:
    """Return the real roots of `a` above 0, in 120 digits, each with its multiplicity, the smallest first."""
    ctx, a = context(DIGITS), trimmed(a)
    found = []
    for factor, times in _by_multiplicity(a[order(a) :]):
        if len(factor) > 1:
            found += [(s.real, times) for s in roots(ctx, numbers(ctx, factor)) if not s.imag and s.real > 0]
    return sorted(found)


def reduced(a: Polynomial, b: Polynomial) -> tuple[Polynomial, Polynomial]:
    """Return `a` and `b` without their common factors; `a` may be 0."""
    shared = _shared(a, b)
    return _divided(trimmed(a), shared)[0], _divided(trimmed(b), shared)[0]


def _by_multiplicity(a: Polynomial) -> Iterator[tuple[Polynomial, int]]:
    slope, times = derivative(a), 1
    shared = _shared(a, slope)
    one, two = _divided(a, shared)[0], _divided(slope, shared)[0]
    while len(one) > 1:
        rest = trimmed(added(two, negative(derivative(one))))
        factor = _shared(one, rest)
        yield factor, times
        one, two, times = _divided(one, factor)[0], _divided(rest, factor)[0], times + 1


def _shared(a: Polynomial, b: Polynomial) -> Polynomial:
    """The greatest common divisor, its highest coefficient 1."""
    a, b = trimmed(a), trimmed(b)
    while b:
        a, b = b, _divided(a, b)[1]
        b = tuple(one / b[-1] for one in b)
    return tuple(one / a[-1] for one in a)


def _divided(a: Polynomial, b: Polynomial) -> tuple[Polynomial, Polynomial]:
    """Quotient and remainder."""
    left, above = list(a), []
    while len(left) >= len(b):
        above.append(left[-1] / b[-1])
        for i, one in enumerate(reversed(b), 1):
            left[-i] -= above[-1] * one
        left.pop()
    return tuple(reversed(above)), trimmed(tuple(left))


def _times(a: Sequence[Fraction], b: Sequence[Fraction]) -> Polynomial:
    result = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, one in enumerate(a):
        for j, two in enumerate(b):
            result[i + j] += one * two
    return tuple(result)
