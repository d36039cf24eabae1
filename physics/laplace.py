"""The motion of the damped and driven chain as a sum of exponentials, from its Laplace transform.

With kappa = k2 + c s, rho_i = m_i (x_i0 s + v_i0) +- c (x_10 - x_20), and c1 x_10 more in rho_1, J = rho_1 + rho_2,
f = F_0 omega/(s^2 + omega^2) and own = m1 s^2 + c1 s + k1 the equations of physics.transient give

    P x1 = m2 s^2 (rho_1 + f) + kappa (J + f),        P x2 = own rho_2 + kappa (J + f),
    P (x2 - x1) = own rho_2 - m2 s^2 (rho_1 + f),     P = own (m2 s^2 + kappa) + m2 s^2 kappa.

Coefficients are rational numbers, without error; exponents and residues have the digits asked for.

Source of the equations: see physics.transient.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import combinations, zip_longest
from typing import Any, NamedTuple

from physics.coupled import TwoMassChain
from physics.precision.polynomials import Polynomial, added, context, numbers, order, product, trimmed
from physics.precision.roots import horner, mismatch, roots, taxicab

Rows = tuple[Any, ...]  # numbers of mpmath for x1, x2, the elongation x2 - x1 and, where they belong, v1 and v2

NOTHING: Polynomial = (Fraction(0),)
_SAME = 1e-6  # relative distance below which two exponents make one term in doubles
_SPARE = 20  # digits that are left of the smaller part of an exponent
_MOST_DIGITS = 4000  # even doubles at both their ends need no more


class Driven(NamedTuple):
    """The chain, its dashpots, the drive and the initial conditions.

    Attributes
    ----------
    chain : TwoMassChain
        Masses and springs.
    c : float
        The damping between the masses in N s/m.
    F_0 : float
        The amplitude of the force F_0 sin(omega t) on mass 1 in N.
    omega : float
        The drive frequency in rad/s.
    x_0, v_0 : tuple of two floats
        Displacements in m and velocities in m/s of both masses at t = 0.
    c1 : float
        The damping parallel to spring 1 in N s/m.
    """

    chain: TwoMassChain
    c: float
    F_0: float
    omega: float
    x_0: tuple[float, float]
    v_0: tuple[float, float]
    c1: float = 0.0


class Transform(NamedTuple):
    """A Laplace transform: x1, x2, x2 - x1 are (start + drive/(s^2 + omega^2))/P; common powers of s are left out.

    Attributes
    ----------
    start, drive : tuple of three Polynomial
        What the initial conditions and the drive give of x1, x2 and x2 - x1.
    P : Polynomial
        The common denominator. All coefficients are rational numbers in SI units, the constant first.
    """

    start: tuple[Polynomial, ...]
    drive: tuple[Polynomial, ...]
    P: Polynomial


class ExponentialTerm(NamedTuple):
    """Re(amplitude exp(exponent t)), Im(exponent) >= 0.

    Attributes
    ----------
    exponent : mpmath number
        The exponent in 1/s.
    amplitude : tuple of mpmath numbers
        The complex amplitudes of x1, x2 and x2 - x1 in m, of v1 and v2 in m/s.
    size : tuple of mpmath numbers
        What the residues were summed from, as sizes, in the same units.
    """

    exponent: Any
    amplitude: Rows
    size: Rows


@dataclass(frozen=True, eq=False)
class Expansion:
    """A motion as constant + drift t + the sum of terms + Im(steady exp(i omega t)), each of x1, x2 and x2 - x1.

    Attributes
    ----------
    ctx : mpmath context
        Makes the numbers below, with the digits asked for.
    omega : mpmath number
        The drive frequency in rad/s.
    P : list of mpmath numbers
        The coefficients of the transform's denominator, the constant first.
    start, drive : list of lists of mpmath numbers
        The coefficients of the transform's polynomials, one list for each quantity.
    zeros : int
        How many roots of P are 0.
    exponents : list of mpmath numbers
        The other roots of P in 1/s.
    """

    ctx: Any
    omega: Any
    P: list[Any]
    start: list[list[Any]]
    drive: list[list[Any]]
    zeros: int
    exponents: list[Any]

    @cached_property
    def mismatch(self) -> Any:
        """The relative error with which the exponents reproduce P."""
        return mismatch(self.P[self.zeros :], self.exponents)

    @cached_property
    def terms(self) -> list[tuple[Any, Rows]]:
        """Exponents, Im >= 0, and the amplitudes of Re(amplitude exp(exponent t))."""
        return [(p, self._residues(p)) for p in self.exponents if p.imag >= 0]

    @cached_property
    def steady(self) -> Rows:
        """X of x_p = Im(X exp(i omega t)); inf where P(i omega) = 0."""
        if not any(map(any, self.drive)):
            return (self.ctx.zero,) * 3
        at = self.ctx.j * self.omega
        below = self.P[-1] * at**self.zeros * self.ctx.fprod(at - p for p in self.exponents) * self.omega
        if not below:
            return (self.ctx.inf,) * 3
        over = 1 / below
        return tuple(horner(polynomial, at) * over for polynomial in self.drive)

    @cached_property
    def at_rest(self) -> list[Rows]:
        """The factors of 1, t, t^2/2 and so on: a term for each exponent of 0, and at least a constant and a drift."""
        none, Q, square = self.ctx.zero, self.P[self.zeros :], self.omega**2 or self.ctx.one
        columns = []
        for one, two in zip(self.start, self.drive, strict=True):
            over = [a + b / square for a, b in zip_longest(one, two[:2], fillvalue=none)]
            series: list[Any] = []
            for j in range(self.zeros):
                known = sum((Q[i] * series[j - i] for i in range(1, min(j + 1, len(Q)))), none)
                series.append(((over[j] if j < len(over) else none) - known) / Q[0])
            columns.append([*reversed(series), none, none][: max(2, self.zeros)])
        return list(zip(*columns, strict=True))

    @cached_property
    def waves(self) -> list[ExponentialTerm]:
        """Every Re(amplitude exp(exponent t)) of the sum; rows of x1, x2, x2 - x1, v1, v2."""
        waves = []
        for p, A in self.terms:
            size = self._sizes(p)
            waves.append(ExponentialTerm(p, (*A, *(a * p for a in A[:2])), (*size, *(a * abs(p) for a in size[:2]))))
        if any(self.steady):
            turning = self.ctx.mpc(0, self.omega)
            A = tuple(-self.ctx.j * X for X in self.steady)
            A = (*A, *(a * turning for a in A[:2]))
            waves.append(ExponentialTerm(turning, A, tuple(map(abs, A))))
        return waves

    def distinct(self) -> Iterator[tuple[Any, list[Rows]]]:
        """Return the exponents, none near another, each with the rows A_j of Re(sum_j A_j t^j exp(exponent t)).

        Near exponents m + d_k about their mean m add sum_k A_k exp(d_k t) exp(m t): a polynomial times exp(m t).

        Returns
        -------
        iterator of (exponent, list of rows)
            Exponents in 1/s, Im >= 0, and the rows A_j of x1, x2 and x2 - x1 in m/s^j. The last exponent is 0, with the
            constant and, if there is one, the drift.
        """
        if self._apart:
            yield from ((p, [A]) for p, A in self.terms)
        else:
            yield from self._gathered()
        constant, drift = self.at_rest  # no more, as a chain has no more exponents of 0 than moving masses
        yield self.ctx.mpc(0), [constant, drift] if any(drift) else [constant]

    @property
    def _apart(self) -> bool:
        """True if no exponent is near another: of two with Im >= 0, or one and its conjugate."""
        upper = [p for p, _ in self.terms]
        meet = any(_near(p, q) for p, q in combinations(upper, 2))
        return not meet and not any(p.imag and _near(p, self.ctx.conj(p)) for p in upper)

    def _gathered(self) -> Iterator[tuple[Any, list[Rows]]]:
        rest = [pair for term in self.terms for pair in self._both(*term)]
        while rest:
            first = rest[0][0]
            near = [pair for pair in rest if _near(first, pair[0])]
            rest = [pair for pair in rest if pair not in near]
            mean = self.ctx.fsum(p for p, _ in near) / len(near) if len(near) > 1 else first
            if mean.imag >= 0:
                yield mean, [self._power(near, mean, j) for j in range(len(near))]

    def _both(self, p: Any, A: Rows) -> list[tuple[Any, Rows]]:
        """A term and its conjugate, of which Re is half the sum."""
        if not p.imag:
            return [(p, A)]
        return [(p, tuple(a / 2 for a in A)), (self.ctx.conj(p), tuple(self.ctx.conj(a) / 2 for a in A))]

    def _power(self, near: list[tuple[Any, Rows]], mean: Any, j: int) -> Rows:
        both = 2 if mean.imag else 1
        factors = [(p - mean) ** j / self.ctx.factorial(j) * both for p, _ in near]
        return tuple(self.ctx.fdot(factors, column) for column in zip(*(A for _, A in near), strict=True))

    def _residues(self, p: Any) -> Rows:
        over = 1 / self._below(p)
        rows = (a * over for a in self._above(p, self._shaken(p), horner))
        return tuple(rows) if p.imag else tuple(self.ctx.mpc(a.real) for a in rows)

    def _sizes(self, p: Any) -> Rows:
        """The sums of sizes that the residues of an exponent come from."""
        over = 1 / abs(self._below(p))
        return tuple(a * over for a in self._above(p, abs(self._shaken(p)), _size))

    def _above(self, p: Any, shaken: Any, at: Callable[[Sequence[Any], Any], Any]) -> list[Any]:
        """start + drive/shaken at p, or the same of their sizes."""
        rows = [at(polynomial, p) for polynomial in self.start]
        if not any(map(any, self.drive)):
            return rows
        over = 1 / shaken
        return [a + at(polynomial, p) * over for a, polynomial in zip(rows, self.drive, strict=True)]

    def _below(self, p: Any) -> Any:
        """P'(p), half of it where a conjugate adds the same."""
        others = self.ctx.fprod(p - other for other in self.exponents if other is not p)
        return self.P[-1] * p**self.zeros * others / (2 if p.imag else 1)

    def _shaken(self, p: Any) -> Any:
        """p^2 + omega^2"""
        return (p - self.ctx.j * self.omega) * (p + self.ctx.j * self.omega)


def transform(driven: Driven) -> Transform:
    """Return the Laplace transform, without error, for any doubles.

    Parameters
    ----------
    driven : Driven
        The chain, its drive and its initial conditions.

    Returns
    -------
    Transform
        The transform, with rational coefficients.
    """
    chain = driven.chain
    m1, m2, k1, k2, c, c1 = map(Fraction, (chain.m1, chain.m2, chain.k1, chain.k2, driven.c, driven.c1))
    (x1, x2), (v1, v2) = (map(Fraction, pair) for pair in (driven.x_0, driven.v_0))
    F = Fraction(driven.F_0) * Fraction(driven.omega)
    pull = c * (x1 - x2)
    rho1, rho2 = (m1 * v1 + pull + c1 * x1, m1 * x1), (m2 * v2 - pull, m2 * x2)
    kappa, own1, own2 = (k2, c), (k1, c1, m1), (Fraction(0), Fraction(0), m2)
    both = product(kappa, added(rho1, rho2))
    one, two = product(own2, rho1), product(own1, rho2)
    start: tuple[Polynomial, ...] = (added(one, both), added(two, both), added(two, product((Fraction(-1),), one)))
    drive: tuple[Polynomial, ...] = ((F * k2, F * c, F * m2), (F * k2, F * c), (Fraction(0), Fraction(0), -F * m2))
    P = added(product(own1, added(own2, kappa)), product(own2, kappa))
    shared = min(order(polynomial) for polynomial in (*start, *drive, P))
    start, drive = (tuple(trimmed(polynomial[shared:]) or NOTHING for polynomial in many) for many in (start, drive))
    return Transform(start, drive, P[shared:])


@lru_cache(maxsize=16)
def expansion(driven: Driven, digits: int) -> Expansion:
    """Return the sum in numbers of that many digits, computed on demand.

    Parameters
    ----------
    driven : Driven
        The chain, its drive and its initial conditions.
    digits : int
        The number of decimal digits.

    Returns
    -------
    Expansion
        The sum; the last 16 are remembered.
    """
    exact = transform(driven)
    return expanded(exact.P, exact.start, exact.drive, driven.omega, digits, undamped=not (driven.c or driven.c1))


def resolved(driven: Driven, digits: int) -> Expansion:
    """Return the sum, with enough digits for the real part of each exponent.

    It has that many digits, or as many more as leave a double's digits in the real parts: of a motion with little
    damping each is a small part.

    Parameters
    ----------
    driven : Driven
        The chain, its drive and its initial conditions.
    digits : int
        The least number of decimal digits.

    Returns
    -------
    Expansion
        The sum.
    """
    found = expansion(driven, digits)
    small = found.ctx.mpf(10) ** (_SPARE - digits)
    lost = any(p.imag and abs(p.real) < small * abs(p.imag) for p in found.exponents)
    return resolved(driven, 2 * digits) if lost and (driven.c or driven.c1) and digits < _MOST_DIGITS else found


def expanded(
    P: Polynomial,
    start: Sequence[Polynomial],
    drive: Sequence[Polynomial],
    omega: float,
    digits: int,
    *,
    undamped: bool = False,
) -> Expansion:
    """Return the sum that (start + drive/(s^2 + omega^2))/P is the transform of, in numbers of that many digits.

    Parameters
    ----------
    P : Polynomial
        The denominator: rational coefficients, the constant first. ArithmeticError if its roots are not found.
    start, drive : sequence of Polynomial
        The parts of the numerators, one polynomial for each quantity.
    omega : float
        The drive frequency in rad/s.
    digits : int
        The number of decimal digits.
    undamped : bool
        True to set the real parts of all exponents to 0.

    Returns
    -------
    Expansion
        The sum.
    """
    ctx = context(digits)
    coefficients = numbers(ctx, P)
    starts, drives = ([numbers(ctx, polynomial) for polynomial in many] for many in (start, drive))
    zeros = order(P)
    exponents = roots(ctx, coefficients[zeros:]) if len(coefficients) > zeros + 1 else []
    if undamped:
        exponents = [ctx.mpc(0, p.imag) for p in exponents]
    return Expansion(ctx, ctx.mpf(omega), coefficients, starts, drives, zeros, exponents)


def _near(p: Any, other: Any) -> bool:
    return bool(taxicab(p - other) < _SAME * taxicab(p))


def _size(polynomial: Sequence[Any], z: Any) -> Any:
    return horner([abs(a) for a in polynomial], taxicab(z))
