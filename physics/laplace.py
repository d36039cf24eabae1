"""The motion of the damped and driven chain as a sum of exponentials, from its Laplace transform.

With kappa = k2 + c s, rho_i = m_i (x_i0 s + v_i0) +- c (x_10 - x_20), J = rho_1 + rho_2 and f = F_0 omega/(s^2 +
omega^2) the equations of physics.transient give

    P x1 = m2 s^2 (rho_1 + f) + kappa (J + f),        P x2 = (m1 s^2 + k1) rho_2 + kappa (J + f),
    P (x2 - x1) = (m1 s^2 + k1) rho_2 - m2 s^2 (rho_1 + f).

Coefficients are rational numbers, without error; exponents and residues have the digits asked for.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property, lru_cache
from itertools import zip_longest
from typing import Any, NamedTuple

from mpmath.ctx_mp import MPContext

from physics.coupled import TwoMassChain
from physics.roots import mismatch, roots, taxicab

Polynomial = tuple[Fraction, ...]  # coefficients, the constant first
Rows = tuple[Any, ...]  # numbers of mpmath for x1, x2, the elongation x2 - x1 and, where they belong, v1 and v2

NOTHING: Polynomial = (Fraction(0),)
_SAME = 1e-6  # relative distance below which two exponents make one term in doubles


class Driven(NamedTuple):
    """The chain, its dashpot, the drive and the start."""

    chain: TwoMassChain
    c: float
    F_0: float
    omega: float
    x_0: tuple[float, float]
    v_0: tuple[float, float]


class Transform(NamedTuple):
    """x1, x2 and x2 - x1 are (start + drive/(s^2 + omega^2))/P; common powers of s are left out."""

    start: tuple[Polynomial, ...]
    drive: tuple[Polynomial, ...]
    P: Polynomial


class ExponentialTerm(NamedTuple):
    """Re(amplitude exp(exponent t)), Im(exponent) >= 0; sizes are what the residues were summed from."""

    exponent: Any
    amplitude: Rows
    size: Rows


@dataclass(frozen=True)
class Expansion:
    """x = constant + drift t + the sum of terms + Im(steady exp(i omega t)), each of x1, x2 and x2 - x1.

    The exponents are the roots of P/s^k, whose coefficients these are.
    """

    ctx: Any
    omega: Any
    terms: list[ExponentialTerm]
    constant: Rows
    drift: Rows
    steady: Rows
    coefficients: list[Any]
    exponents: list[Any]

    @cached_property
    def mismatch(self) -> Any:
        """The relative error with which the exponents reproduce P."""
        return mismatch(self.coefficients, self.exponents)

    def waves(self) -> Iterator[ExponentialTerm]:
        """Every Re(amplitude exp(exponent t)) of the sum; rows of x1, x2, x2 - x1, v1, v2."""
        for p, A, size in self.terms:
            yield ExponentialTerm(p, (*A, *(a * p for a in A[:2])), (*size, *(a * abs(p) for a in size[:2])))
        if any(self.steady):
            turning = self.ctx.mpc(0, self.omega)
            A = tuple(-self.ctx.j * X for X in self.steady)
            A = (*A, *(a * turning for a in A[:2]))
            yield ExponentialTerm(turning, A, tuple(map(abs, A)))

    def distinct(self) -> Iterator[tuple[Any, list[Rows]]]:
        """Exponents, none near another, each with the rows A_j of Re(sum_j A_j t^j exp(exponent t)).

        Near exponents m + d_k about their mean m add sum_k A_k exp(d_k t) exp(m t): a polynomial times exp(m t).
        """
        rest = [pair for term in self.terms for pair in self._both(term)]
        while rest:
            first = rest[0][0]
            near = [pair for pair in rest if taxicab(pair[0] - first) < _SAME * taxicab(first)]
            rest = [pair for pair in rest if pair not in near]
            mean = self.ctx.fsum(p for p, _ in near) / len(near) if len(near) > 1 else first
            if mean.imag >= 0:
                yield mean, [self._power(near, mean, j) for j in range(len(near))]
        yield self.ctx.mpc(0), [self.constant, self.drift] if any(self.drift) else [self.constant]

    def _both(self, term: ExponentialTerm) -> list[tuple[Any, Rows]]:
        """A term and its conjugate, of which Re is half the sum."""
        p, A, _ = term
        if not p.imag:
            return [(p, A)]
        return [(p, tuple(a / 2 for a in A)), (self.ctx.conj(p), tuple(self.ctx.conj(a) / 2 for a in A))]

    def _power(self, near: list[tuple[Any, Rows]], mean: Any, j: int) -> Rows:
        both = 2 if mean.imag else 1
        if len(near) == 1:
            return tuple(both * a for a in near[0][1])
        factors = [(p - mean) ** j / self.ctx.factorial(j) * both for p, _ in near]
        return tuple(self.ctx.fdot(factors, column) for column in zip(*(A for _, A in near), strict=True))


def transform(driven: Driven) -> Transform:
    """Without error, for any doubles."""
    chain = driven.chain
    m1, m2, k1, k2, c = map(Fraction, (chain.m1, chain.m2, chain.k1, chain.k2, driven.c))
    (x1, x2), (v1, v2) = (map(Fraction, pair) for pair in (driven.x_0, driven.v_0))
    F = Fraction(driven.F_0) * Fraction(driven.omega)
    pull = c * (x1 - x2)
    rho1, rho2 = (m1 * v1 + pull, m1 * x1), (m2 * v2 - pull, m2 * x2)
    kappa, own1, own2 = (k2, c), (k1, Fraction(0), m1), (Fraction(0), Fraction(0), m2)
    both = _product(kappa, _sum(rho1, rho2))
    one, two = _product(own2, rho1), _product(own1, rho2)
    start: tuple[Polynomial, ...] = (_sum(one, both), _sum(two, both), _sum(two, _product((Fraction(-1),), one)))
    drive: tuple[Polynomial, ...] = ((F * k2, F * c, F * m2), (F * k2, F * c), (Fraction(0), Fraction(0), -F * m2))
    P = (k1 * k2, c * k1, m1 * k2 + m2 * k1 + m2 * k2, c * (m1 + m2), m1 * m2)
    shared = min(_power(polynomial) for polynomial in (*start, *drive, P))
    start, drive = (tuple(polynomial[shared:] or NOTHING for polynomial in many) for many in (start, drive))
    return Transform(start, drive, P[shared:])


@cache
def _context(digits: int) -> Any:
    """Numbers of that many digits; making one takes longer than the sum."""
    ctx = MPContext()
    ctx.dps = digits
    return ctx


@lru_cache(maxsize=16)
def expansion(driven: Driven, digits: int) -> Expansion:
    """The sum in numbers of that many digits."""
    ctx = _context(digits)
    exact = transform(driven)
    P = _numbers(ctx, exact.P)
    start, drive = ([_numbers(ctx, polynomial) for polynomial in many] for many in exact[:2])
    zeros = _power(exact.P)
    exponents = roots(ctx, P[zeros:]) if len(P) > zeros + 1 else []
    if not driven.c:
        exponents = [ctx.mpc(0, p.imag) for p in exponents]
    omega, terms = ctx.mpf(driven.omega), []
    for i, p in enumerate(exponents):
        if p.imag < 0:
            continue
        others = [p - other for j, other in enumerate(exponents) if j != i]
        below = P[-1] * p**zeros * ctx.fprod(others) / (2 if p.imag else 1)
        shaken = (p - ctx.j * omega) * (p + ctx.j * omega)
        pairs = [_at(a, b, p, shaken) for a, b in zip(start, drive, strict=True)]
        residues = (a / below if p.imag else ctx.mpc((a / below).real) for a, _ in pairs)
        terms.append(ExponentialTerm(p, tuple(residues), tuple(b / abs(below) for _, b in pairs)))
    constant, drift = _at_rest(ctx, zeros, P, start, drive, omega)
    return Expansion(
        ctx, omega, terms, constant, drift,
        steady=_steady(ctx, exponents, zeros, P[-1], drive, omega),
        coefficients=P[zeros:],
        exponents=exponents,
    )  # fmt: skip


def _at(start: list[Any], drive: list[Any], p: Any, shaken: Any) -> tuple[Any, Any]:
    """start + drive/shaken at p, and the same of the sizes of all that is added."""
    free, free_size = _value(start, p)
    pushed, pushed_size = _value(drive, p)
    if not pushed_size:
        return free, free_size
    return free + pushed / shaken, free_size + pushed_size / abs(shaken)


def _at_rest(
    ctx: Any, zeros: int, P: list[Any], start: list[list[Any]], drive: list[list[Any]], omega: Any
) -> tuple[Rows, Rows]:
    """What exponents of 0 add: a constant, and a drift where there are two of them."""
    none = (ctx.zero,) * 3
    if not zeros:
        return none, none
    square = omega**2 or ctx.one
    over = [
        [a + b / square for a, b in zip_longest(one[:2], two[:2], fillvalue=ctx.zero)]
        for one, two in zip(start, drive, strict=True)
    ]
    first = tuple(row[0] / P[zeros] for row in over)
    if zeros == 1:
        return first, none
    Q1 = P[3] if len(P) > 3 else ctx.zero
    second = tuple(((row[1] if len(row) > 1 else 0) - b * Q1) / P[2] for row, b in zip(over, first, strict=True))
    return second, first


def _steady(ctx: Any, exponents: list[Any], zeros: int, leading: Any, drive: list[list[Any]], omega: Any) -> Rows:
    """X of x_p = Im(X exp(i omega t)); inf where P(i omega) = 0."""
    if not any(map(any, drive)):
        return (ctx.zero,) * 3
    at = ctx.j * omega
    below = leading * at**zeros * ctx.fprod(at - p for p in exponents) * omega
    return tuple(_value(over, at)[0] / below if below else ctx.inf for over in drive)


def _value(polynomial: Sequence[Any], z: Any) -> tuple[Any, Any]:
    near = taxicab(z)
    value, size = 0 * z, 0 * near
    for a in reversed(polynomial):
        value, size = value * z + a, size * near + abs(a)
    return value, size


def _numbers(ctx: Any, polynomial: Polynomial) -> list[Any]:
    return [ctx.mpf(a.numerator) / a.denominator for a in polynomial]


def _product(a: Polynomial, b: Polynomial) -> Polynomial:
    result = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, one in enumerate(a):
        for j, two in enumerate(b):
            result[i + j] += one * two
    return tuple(result)


def _sum(a: Polynomial, b: Polynomial) -> Polynomial:
    return tuple(one + two for one, two in zip_longest(a, b, fillvalue=Fraction(0)))


def _power(polynomial: Polynomial) -> int:
    """How many factors s can be taken out; more than any other has, of nothing."""
    return next((k for k, a in enumerate(polynomial) if a), 99)
