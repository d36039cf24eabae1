"""The chain with dashpots parallel to its springs, driven from any start: particular solution and transient.

    wall --k1, c1-- [m1] --k2, c-- [m2]        F_0 sin(omega t) on m1

The equations are in physics.absorber, with an additional -c1 x1' on mass 1. A free motion x_i = X_i exp(s t) is
possible at the roots of

    P(s) = m1 m2 s^4 + (m1 c + m2 (c1 + c)) s^3 + (m1 k2 + m2 (k1 + k2) + c1 c) s^2 + (c1 k2 + c k1) s + k1 k2,

the exponents of the complex modes, and the motion is a sum over these,

    x_i = Im(X_i exp(i omega t)) + Re(sum_s A_is exp(s t)),

each A_is a residue of the Laplace transform of x_i. The sum is the transient; without damping it does not decay. Where
exponents nearly coincide, with each other or with i omega, and at first, where x_2 starts like t^4, terms are far
larger than their sum. So the sum is formed in pairs of doubles and, where it cancels beyond these, in as many digits
as it takes (A. Ziv, ACM Trans. Math. Softw. 17 (1991) 410).

Sources: K. A. Foss, J. Appl. Mech. 25 (1958) 361 (complex modes); J. P. Den Hartog, Mechanical Vibrations, 4th ed.
(1956), section 3.3.
"""

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial.polynomial import polyval
from numpy.typing import ArrayLike, NDArray

from physics.absorber import damped_solution
from physics.coupled import QUANTITIES, Motion, TwoMassChain
from physics.forced import REST, forced_motion
from physics.laplace import Driven, Expansion, expansion, resolved
from physics.particular import at_natural_frequency
from physics.precision.curves import ScaledCurve, product, rounded_once, scaled_sum
from physics.precision.elementary import LARGEST_EXPONENT, SMALLEST_EXPONENT, exponential, sine_cosine
from physics.precision.exact import Array, angle, pair_product, precise, rounded
from physics.precision.roots import taxicab
from physics.valid import check_finite, check_not_negative, finite_array, in_range

Complexes = NDArray[np.complex128]


class Effort(NamedTuple):
    """Exactness that a sum must reach, and the work that it may take.

    A value is good if its uncertainty is at most `error`, relative to it, or to its curve's maximum if `of_largest`.

    Attributes
    ----------
    error : float
        The largest relative uncertainty of a value.
    of_largest : bool
        True if it is relative to the maximum of the curve.
    digits : int
        The bound on the digits at one time.
    work : float
        The bound on the digits of all times together: 2,500 take about 0.02 s.
    """

    error: float = 2.0**-60  # once rounded within 0.51 ulp
    of_largest: bool = False
    digits: int = 10_000
    work: float = math.inf


EXACT = Effort()
"""Every number within 0.51 ulp, however long it takes."""
FILE = Effort(work=100_000)
"""Every number within 0.51 ulp, for a file of numbers: at most about half a second."""
DRAWING = Effort(2.0**-41, of_largest=True, digits=960, work=2_500)
"""Within 1e-12 of the largest of its curve, for a picture: about 0.02 s."""
StateRow = tuple[Decimal, ...]  # of x1, x2, x2 - x1, v1, v2

DIGITS = 120
_IN_PAIRS = 2.0**-101  # error of a term in pairs of doubles, relative to its size, for each radian of its phase
_NEGLIGIBLE = 1e-260  # exp(SMALLEST_EXPONENT)
_DIED_OUT = -1e5  # of an exponent: e^-1e5 is negligible, and slow to compute with mpmath
_REPRODUCED = 1e-24  # largest error of a coefficient of P, and for each radian of phase
_LEFT = 1e-85  # of the sizes that a residue was summed from, what can be wrong with it


class Decaying(NamedTuple):
    """A term Re(sum_j amplitudes[j] t^j exp(exponent t)): the part of one complex mode.

    Attributes
    ----------
    exponent : complex
        Its real part (1/s) is minus the rate of decay, its imaginary part the frequency in rad/s, 0 or more.
    amplitudes : ndarray of complex
        (1, 3), in m for x1, x2 and x2 - x1; (2, 3) for two equal exponents, or where the chain drifts, and so on.
    """

    exponent: complex
    amplitudes: Complexes

    @property
    def rate(self) -> "Decaying":
        """Its rate of change, in m/s."""
        slopes = self.amplitudes[1:] * np.arange(1, len(self.amplitudes))[:, None]
        return Decaying(self.exponent, self.exponent * self.amplitudes + np.vstack([slopes, 0 * self.amplitudes[:1]]))

    def at(self, t: Array) -> Array:
        """Return x1, x2 and x2 - x1 (3, n).

        Parameters
        ----------
        t : ndarray, shape (n,)
            Times in s.

        Returns
        -------
        ndarray, shape (3, n)
            The term in m.
        """
        with np.errstate(under="ignore"):
            return np.asarray((polyval(t, self.amplitudes) * np.exp(self.exponent * t)).real)


@dataclass(frozen=True, kw_only=True)
class DampedModes:
    """The motion of a chain with dashpots under F_0 sin(omega t) on mass 1, from any start.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    c : float
        The damping between the masses in N s/m, 0 or more.
    F_0 : float
        The amplitude of the force on mass 1 in N, finite.
    omega : float
        The drive frequency in rad/s, 0 or more.
    x_0, v_0 : tuple of float
        Displacements in m and velocities in m/s of masses 1 and 2 at t = 0; at rest in equilibrium by default.
    c1 : float
        The damping parallel to spring 1 in N s/m, 0 or more.

    Raises
    ------
    ValueError
        If a number is not possible.
    """

    chain: TwoMassChain
    c: float
    F_0: float
    omega: float
    x_0: tuple[float, float] = REST
    v_0: tuple[float, float] = REST
    c1: float = 0.0

    def __post_init__(self) -> None:
        check_not_negative("a damping in N s/m", c=self.c, c1=self.c1)
        check_finite("a force in N", F_0=self.F_0)
        check_not_negative("a drive frequency in rad/s", omega=self.omega)
        check_finite("a displacement in m", x1_0=self.x_0[0], x2_0=self.x_0[1])
        check_finite("a velocity in m/s", v1_0=self.v_0[0], v2_0=self.v_0[1])

    @cached_property
    def particular(self) -> Complexes:
        """X (3,) of x1, x2 and x2 - x1, x_p = Im(X exp(i omega t)); ValueError at an undamped resonance."""
        self._check_particular()
        return _complexes(expansion(self._driven, DIGITS).steady)

    @cached_property
    def transient(self) -> tuple[Decaying, ...]:
        """The motion less x_p, in terms: in doubles, exponents closer than 1e-6 taken as equal."""
        self._check_particular()
        found = resolved(self._driven, DIGITS).distinct()
        terms = [Decaying(_complex(p), np.array([_complexes(row) for row in rows])) for p, rows in found]
        return tuple(term for term in terms if np.any(term.amplitudes))

    def motion(self, t: ArrayLike, effort: Effort = EXACT) -> Motion:
        """Return the motion at times t (n,): with damping as exact as `effort` says, without see forced_motion.

        Parameters
        ----------
        t : array_like, shape (n,)
            Times in s.
        effort : Effort
            The exactness, and the limit of the work; ignored without damping.

        Returns
        -------
        Motion
            x, v and e, each (2, n).

        Raises
        ------
        ValueError
            If a time is not finite, if a result leaves the range of doubles, or if the motion takes more work than
            `effort` allows.
        """
        t = finite_array("t", t)
        if not (self.c or self.c1):
            return forced_motion(self.chain, self.F_0, self.omega, t, self.x_0, self.v_0)
        if self._stays:
            still = np.repeat(np.array(self._start)[:, None], t.size, axis=1)
            return Motion(t, still[:2], still[3:], still[[0, 2]])
        values = summed(lambda digits: expansion(self._driven, digits), t, effort)
        values[:, t == 0.0] = np.array(self._start)[:, None]
        x1, x2, e2, v1, v2 = (in_range(name, row) for name, row in zip(QUANTITIES, values, strict=True))
        return Motion(t, np.array([x1, x2]), np.array([v1, v2]), np.array([x1, e2]))

    def complementary(self, t: ArrayLike) -> Array:
        """The transient alone, x1, x2, x2 - x1 (3, n), from its terms in doubles.

        Parameters
        ----------
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        ndarray, shape (3, n)
            The transient in m.

        Raises
        ------
        ValueError
            At an undamped resonance, if a time is not finite, or if an amplitude leaves the range of doubles.
        """
        t = finite_array("t", t)
        return sum((term.at(t) for term in self.transient), np.zeros((3, t.size)))

    def particular_motion(self, t: ArrayLike) -> Array:
        """The particular motion alone, x1, x2, x2 - x1 (3, n).

        Parameters
        ----------
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        ndarray, shape (3, n)
            The particular motion in m.

        Raises
        ------
        ValueError
            At an undamped resonance, if a time is not finite, or if an amplitude leaves the range of doubles.
        """
        return np.asarray((self.particular[:, None] * np.exp(1j * self.omega * finite_array("t", t))).imag)

    def drawn(self, t: ArrayLike) -> tuple[Array, Array]:
        """Return x1, x2, x2 - x1 and their rates of change (3, n), from the terms in doubles.

        Parameters
        ----------
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        tuple of ndarray, each (3, n)
            Displacements in m, and their rates of change in m/s.

        Raises
        ------
        ValueError
            At an undamped resonance, if a time is not finite, or if an amplitude leaves the range of doubles.
        """
        t = finite_array("t", t)
        turned = self.particular[:, None] * np.exp(1j * self.omega * t)
        rates = sum((term.rate.at(t) for term in self.transient), (1j * self.omega * turned).imag)
        return turned.imag + self.complementary(t), rates

    @property
    def _driven(self) -> Driven:
        return Driven(self.chain, self.c, self.F_0, self.omega, self.x_0, self.v_0, self.c1)

    @property
    def _stays(self) -> bool:
        """True if the start is at rest with no force on either mass."""
        (x1, x2), chain = self.x_0, self.chain
        pushed = (self.F_0 and self.omega) or (chain.k1 and x1) or (chain.k2 and x1 != x2)
        return not pushed and not any(self.v_0)

    @property
    def _start(self) -> tuple[float, float, float, float, float]:
        (x1, x2), (v1, v2) = self.x_0, self.v_0
        return x1, x2, x2 - x1, v1, v2

    def _check_particular(self) -> None:
        driven = self.F_0 and self.omega  # at omega = 0 the force F_0 sin(omega t) is 0
        if driven and np.any(np.isinf(damped_solution(self.chain, self.c, self.F_0, self.omega, self.c1))):
            raise at_natural_frequency(self.omega)


def summed(expand: Callable[[int], Expansion], t: Array, effort: Effort = EXACT) -> Array:
    """Return x1, x2, x2 - x1, v1, v2 (5, n) of a sum at the times t (n,), except at t = 0, as exact as `effort` says.

    Parameters
    ----------
    expand : callable
        Gives the sum, an Expansion, in so many digits.
    t : ndarray, shape (n,)
        Times in s.
    effort : Effort
        The exactness, and the limit of the work.

    Returns
    -------
    ndarray, shape (5, n)
        Displacements in m, then velocities in m/s.

    Raises
    ------
    ValueError
        If a value takes more work than `effort` allows, or one that needs more digits leaves the range of doubles.
    """
    values, sure = in_pairs(expand(DIGITS), t, effort)
    left = effort.work
    for n in np.flatnonzero(~sure & (t != 0.0)):
        values[:, n], spent = _in_many_digits(expand, float(t[n]), min(effort.digits, left))
        left -= spent
    return values


class _Summand(NamedTuple):
    """A curve, its coefficients in x1, x2, x2 - x1, v1, v2, and the doubt (n,) that each unit of a size brings."""

    curve: ScaledCurve
    row: StateRow
    sizes: StateRow
    doubt: Array


def in_pairs(modes: Expansion, t: Array, effort: Effort) -> tuple[Array, NDArray[np.bool_]]:
    """Return x1, x2, x2 - x1, v1, v2 as (5, n), and where they are as exact as `effort` says.

    Parameters
    ----------
    modes : Expansion
        The sum.
    t : ndarray, shape (n,)
        Times in s.
    effort : Effort
        The exactness; its limits of work have no effect.

    Returns
    -------
    tuple of ndarray
        The values (5, n) in m and m/s, and bools (n,): True where all five are exact enough.
    """
    summands = [*_waves(modes, t), *_drift(modes, t)]
    rows = list(zip(*(summand.row for summand in summands), strict=True))
    with np.errstate(over="ignore", invalid="ignore"):
        values, exponents = scaled_sum(rows, [summand.curve for summand in summands])
        doubt = np.zeros_like(values[0])
        for summand in summands:
            doubt += _scaled(summand.sizes, exponents) * summand.doubt
        enough = effort.error * np.where(np.isfinite(values[0]), np.abs(values[0]), 0.0)
        if effort.of_largest:
            enough = enough.max(axis=1, keepdims=True, initial=0.0)
        sure = np.all(doubt <= enough, axis=0)
        return rounded_once(values, exponents), sure & bool(modes.mismatch < _REPRODUCED)


def _waves(modes: Expansion, t: Array) -> Iterator[_Summand]:
    for p, row, sizes in modes.waves:
        cosine, sine, doubt = _decaying(p, t)
        sizes = _decimals(abs(a) + _LEFT * b for a, b in zip(row, sizes, strict=True))
        yield _Summand(cosine, _decimals(a.real for a in row), sizes, doubt)
        if p.imag:
            yield _Summand(sine, _decimals(-a.imag for a in row), sizes, 0.0 * t)


def _decaying(p: Any, t: Array) -> tuple[ScaledCurve, ScaledCurve, Array]:
    """exp(Re(p) t) times cos and sin of Im(p) t, and their doubt."""
    with np.errstate(over="ignore", invalid="ignore"):
        exponent = np.nan_to_num(float(p.real) * t)
        gone, huge = exponent < SMALLEST_EXPONENT, exponent > LARGEST_EXPONENT
        size = exponential(angle(_decimal(p.real), np.where(gone | huge, 0.0, t)))
        size = np.where(gone, 0.0, size[0]), np.where(gone, 0.0, size[1])
        doubt = size[0] * (_IN_PAIRS + _IN_PAIRS * np.abs(float(abs(p)) * t))
        doubt = np.where(huge, np.inf, np.where(gone, _NEGLIGIBLE, doubt))
    if not p.imag:
        return ScaledCurve(*size, Decimal(1)), ScaledCurve(0.0 * t, 0.0 * t, Decimal(1)), doubt
    sine, cosine = sine_cosine(angle(_decimal(p.imag), t))
    return (
        ScaledCurve(*pair_product(size, cosine), Decimal(1)),
        ScaledCurve(*pair_product(size, sine), Decimal(1)),
        doubt,
    )


def _drift(modes: Expansion, t: Array) -> Iterator[_Summand]:
    """A polynomial in t: its terms, and a unit of each in the velocities of the term after it."""
    time, power = ScaledCurve(t, 0.0 * t, Decimal(1)), ScaledCurve(np.ones_like(t), 0.0 * t, Decimal(1))
    none = (0 * modes.omega,) * 3
    for n, (row, rate) in enumerate(pairwise([*modes.at_rest, none])):
        if n:
            power = time if n == 1 else product(power, time).times(1 / Decimal(n))
        values = (*row, *rate[:2])
        if any(values):
            with precise():
                doubt = _IN_PAIRS * float(power.scale) * np.abs(power.hi)
            yield _Summand(power, _decimals(values), _decimals(map(abs, values)), doubt)


def _in_many_digits(expand: Callable[[int], Expansion], t: float, most: float) -> tuple[list[float], int]:
    """x1, x2, x2 - x1, v1, v2 at one time: more and more digits until enough of them are left; how many there were."""
    digits, spent = DIGITS, 0
    while digits <= most:
        values, spent = _summed(expand(digits), t), spent + digits
        if values is not None:
            return [rounded(name, _decimal(value)) for name, value in zip(QUANTITIES, values, strict=True)], spent
        digits *= 2
    raise ValueError(
        f"the motion at t = {t:.3g} s takes more digits of arithmetic than are allowed: "
        "another time window or other values take fewer"
    )


def _summed(modes: Expansion, t: float) -> list[Any] | None:
    """The sum, or None if too many digits cancel, or the exponents do not reproduce the equations well enough."""
    ctx, radians = modes.ctx, 1.0
    total, doubt = [ctx.zero] * 5, [ctx.zero] * 5
    for n, (row, rate) in enumerate(pairwise([*modes.at_rest, (ctx.zero,) * 3])):
        power = ctx.mpf(t) ** n / math.factorial(n)
        total = [a + b * power for a, b in zip(total, (*row, *rate[:2]), strict=True)]
        doubt = [a + abs(b * power) for a, b in zip(doubt, (*row, *rate[:2]), strict=True)]
    for p, row, sizes in modes.waves:
        turned = ctx.exp(p * t) if p.real * t > _DIED_OUT else ctx.zero
        turns = 1 + taxicab(p) * abs(t)
        reach, radians = taxicab(turned) * turns, max(radians, turns)
        total = [a + (b * turned).real for a, b in zip(total, row, strict=True)]
        doubt = [a + b * reach for a, b in zip(doubt, sizes, strict=True)]
    nothing = ctx.ldexp(1, -1080)  # rounds to 0: a sum that is 0 has no digits to be sure of
    sure = all(1e5 * ctx.eps * a <= EXACT.error * max(abs(b), nothing) for a, b in zip(doubt, total, strict=True))
    return total if sure and modes.mismatch * radians < _REPRODUCED else None


def _scaled(row: StateRow, exponents: NDArray[np.int_]) -> Array:
    """The row over the powers of two, (rows, 1)."""
    with precise():
        return np.array([[float(a / Decimal(2) ** int(e))] for a, e in zip(row, exponents[:, 0], strict=True)])


def _decimal(value: Any) -> Decimal:
    """A number of mpmath to 80 digits."""
    sign, mantissa, exponent, _ = value._mpf_
    with precise():
        return Decimal(int(-mantissa if sign else mantissa)) * Decimal(2) ** int(exponent)


def _decimals(values: Iterable[Any]) -> StateRow:
    return tuple(map(_decimal, values))


def _complex(value: Any) -> complex:
    return complex(*(rounded("an amplitude", _decimal(part)) for part in (value.real, value.imag)))


def _complexes(values: Iterable[Any]) -> Complexes:
    return np.array([_complex(value) for value in values])
