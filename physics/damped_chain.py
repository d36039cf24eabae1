"""Two masses, two springs and two dashpots: roots, complex shapes, and which free motions form a mode.

    wall --k1, c1-- [m1] --k2, c2-- [m2]        x_i = Re(X_i exp(s t)),  P(s) = 0, see physics.transient

    X2/X1 = (k2 + c2 s)/(m2 s^2 + c2 s + k2) = (m1 s^2 + (c1 + c2) s + k1 + k2)/(k2 + c2 s)

The damping is proportional if c1 k2 = c2 k1 (T. K. Caughey and M. E. J. O'Kelly, J. Appl. Mech. 32 (1965) 583). Each
mode then keeps its undamped shape, and both of its roots. Otherwise two different roots have two different shapes, so
two real roots never form a mode.

Roots and shapes are computed with 120 digits or more and rounded once. Equalities between parameters are tested
without error on the numbers as they are written in decimals: 0.3 is 3/10.

Source: lecture D34, slides 2 to 4, and its notes, which allow for a frequency with an imaginary part.
"""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from enum import StrEnum
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from physics.absorber import checked_damping, damped_lags, damped_solution, swing_and_stroke
from physics.coupled import TwoMassChain
from physics.laplace import Driven, Expansion, resolved
from physics.precision.exact import PI, Array, exact, precise, rounded
from physics.precision.roots import taxicab
from physics.valid import check_not_negative, in_range, keep_doubles

DIGITS = 120
NEAR = 1e-6
"""Roots that are closer than this share of their modulus count as one root."""
_NOISE = 1e-25  # relative to a modulus; a fourfold root is known to a quarter of the digits

Complexes = NDArray[np.complex128]
Roots = tuple[Any, ...]  # numbers of mpmath
Direction = tuple[Any, Any]  # X1 and X2, numbers of mpmath
BOTH, TWO = (1 + 0j, 1 + 0j), (0j, 1 + 0j)


class Kind(StrEnum):
    """Kinds of free motion of a chain with dashpots, in the order in which they are tested."""

    UNDAMPED = "undamped"  # c1 = c2 = 0
    DRIFT_BOTH = "drift_both"  # k1 = c1 = 0
    DRIFT_TWO = "drift_two"  # k2 = c2 = 0
    REST_EACH = "rest_each"  # k1 = k2 = 0, both dashpots
    REST_BOTH = "rest_both"  # k1 = 0, c1 > 0
    REST_TWO = "rest_two"  # k2 = 0, c2 > 0
    PROPORTIONAL = "proportional"
    EXCEPTIONAL = "exceptional"  # both modes have become one
    PARTED = "parted"  # two pairs with equal modulus, beyond the exceptional point
    TWO_PAIRS = "two_pairs"
    ONE_PAIR = "one_pair"
    CREEPING = "creeping"  # four real roots: two creep, two die quickly
    FOUR_REAL = "four_real"


class ComplexMode(NamedTuple):
    """Free motions of one shape: x_i = Re(shape[i] exp(s t)) for each of the `exponents` s in 1/s.

    Attributes
    ----------
    exponents : tuple of complex
        Real ones, the slowest first, or one of each conjugate pair, Im(s) > 0; in 1/s.
    shape : tuple of complex
        X1 and X2. The larger part has modulus 1; X1 is real and not negative.
    """

    exponents: tuple[complex, ...]
    shape: tuple[complex, complex]

    @property
    def swings(self) -> bool:
        """True if its root is not real, within the tolerance NEAR."""
        return _turns(self.exponents[0])

    @property
    def repeats(self) -> int:
        """The number of times that its root occurs if all of its exponents are one root; else 1."""
        first, *others = self.exponents
        if any(abs(s - first) > NEAR * abs(first) for s in others):
            return 1
        return sum(2 if s.imag and not self.swings else 1 for s in self.exponents)


class ComplexModes(NamedTuple):
    """Free motions of a chain, by their shapes.

    Attributes
    ----------
    kind : Kind
        The kind of free motion.
    modes : tuple of ComplexMode
        Modes come slow first. Other motions come with the one that swings first, then by their rates; a rest is the
        last.
    """

    kind: Kind
    modes: tuple[ComplexMode, ...]

    @property
    def crossed(self) -> bool:
        """True if the one of two pairs with the smaller modulus swings faster."""
        return self.kind is Kind.TWO_PAIRS and self.modes[0].exponents[0].imag > self.modes[1].exponents[0].imag


@dataclass(frozen=True, kw_only=True)
class DampedChain:
    """Two masses, two springs and two dashpots, each dashpot parallel to the spring of its number.

    Parameters
    ----------
    m1, m2 : float
        Masses in kg, above 0.
    k1, k2 : float
        Stiffnesses in N/m, 0 or more.
    c1, c2 : float
        Dampings in N s/m, 0 or more.

    Raises
    ------
    ValueError
        If a number is not possible.
    """

    m1: float
    m2: float
    k1: float
    k2: float
    c1: float = 0.0
    c2: float = 0.0

    def __post_init__(self) -> None:
        keep_doubles(self, *(field.name for field in fields(self)))
        check_not_negative("a damping in N s/m", c1=self.c1, c2=self.c2)
        self.chain  # noqa: B018 (its limits are those of masses and springs)

    @classmethod
    def of(cls, chain: TwoMassChain, c1: float, c2: float) -> "DampedChain":
        """A chain with dashpots added.

        Parameters
        ----------
        chain : TwoMassChain
            The masses and springs.
        c1, c2 : float
            Dampings in N s/m parallel to springs 1 and 2, 0 or more.

        Returns
        -------
        DampedChain
            The chain with its dashpots.

        Raises
        ------
        ValueError
            If a damping is not possible.
        """
        return cls(m1=chain.m1, m2=chain.m2, k1=chain.k1, k2=chain.k2, c1=c1, c2=c2)

    @cached_property
    def chain(self) -> TwoMassChain:
        """The chain without its dashpots."""
        return TwoMassChain(m1=self.m1, m2=self.m2, k1=self.k1, k2=self.k2)

    @cached_property
    def roots(self) -> Complexes:
        """The roots of P in 1/s, (4,): by modulus, then the slower decay first; of a pair the upper one first.

        Each part is rounded once. ValueError if a root leaves the range of doubles.
        """
        return in_range("a root", np.array([complex(s) for s in self._roots]))

    @cached_property
    def shapes(self) -> Complexes:
        """X2/X1 of each root, (4,), each part rounded once; inf where mass 1 is at rest.

        Without a spring the masses may rest anywhere, so that roots at 0 determine no ratio. By convention it is 1 if
        both masses can drift, inf if only mass 2 can, and otherwise that of the other roots.
        """
        return np.array([self._ratio(i, s) for i, s in enumerate(self._roots)])

    def response(self, omega: ArrayLike, F_0: float = 1.0) -> Complexes:
        """Return the complex amplitudes under F_0 sin(omega t) on mass 1: x_i = Im(X_i exp(i omega t)).

        Parameters
        ----------
        omega : float or array_like, shape (n,)
            Drive frequencies in rad/s, 0 or more.
        F_0 : float
            The amplitude of the force in N.

        Returns
        -------
        ndarray of complex, shape (2,) or (2, n)
            X1, X2 in m, each part rounded once; inf where no steady amplitude exists.

        Raises
        ------
        ValueError
            If a number is not possible.
        """
        frequencies = checked_damping(self.c2, F_0, omega, self.c1).tolist()
        each = np.array([damped_solution(self.chain, self.c2, F_0, w, self.c1) for w in frequencies])
        return each.reshape(-1, 2).T if np.ndim(omega) else each[0]

    def lags(self, omega: ArrayLike) -> Array:
        """Return the lags of both masses behind the force, continuous in omega: see `damped_lags`.

        Parameters
        ----------
        omega : float or array_like, shape (n,)
            Drive frequencies in rad/s, 0 or more.

        Returns
        -------
        ndarray, shape (2,) or (2, n)
            Lags in rad.

        Raises
        ------
        ValueError
            If a frequency is not possible.
        """
        return damped_lags(self.chain, self.c2, omega, self.c1)

    def works(self, omega: float, F_0: float = 1.0) -> tuple[float, float]:
        """Return the energies that both dashpots take in a cycle of the steady motion, within 4 u.

        Parameters
        ----------
        omega : float
            The drive frequency in rad/s.
        F_0 : float
            The amplitude of the force on mass 1 in N.

        Returns
        -------
        tuple of float
            The energies of dashpots 1 and 2 in J.

        Raises
        ------
        ValueError
            If a number is not possible, or an energy leaves the range of doubles.
        """
        if not (self.c1 or self.c2):
            return 0.0, 0.0
        sizes = swing_and_stroke(self.chain, self.c2, F_0, omega, self.c1).tolist()
        with precise():
            pairs = zip((self.c1, self.c2), sizes, strict=True)
            one, two = (PI * exact(omega) * exact(c) * exact(X) ** 2 for c, X in pairs)
            return rounded("the work of a cycle", one), rounded("the work of a cycle", two)

    @property
    def proportional(self) -> bool:
        """True if c1 k2 = c2 k1 in the numbers as written."""
        return written(self.c1) * written(self.k2) == written(self.c2) * written(self.k1)

    @cached_property
    def meeting(self) -> tuple[float, float]:
        """The dashpots in the ratio of c1 and c2 at which both pairs have the same modulus and decay rate.

        It is the exceptional point if the pairs of c1 and c2 have the same modulus.
        """
        m1, m2, _, _ = self.chain.exact_parameters
        one, two = exact(self.c1), exact(self.c2)
        with precise():
            slow, fast = self.chain.exact_modes
            square = (m1 * two + m2 * (one + two)) ** 2 - 4 * m1 * m2 * one * two
            share = 2 * m1 * m2 * (fast.omega - slow.omega) / square.sqrt()
            return float(share * one), float(share * two)

    @cached_property
    def free_motions(self) -> ComplexModes:
        """The free motions by their shapes, and their kind."""
        if not (self.c1 or self.c2):
            return self._undamped()
        if not (self.k1 and self.k2):
            return self._without_a_spring()
        if self.proportional:
            shapes = [_rounded(self._mode_direction(j), real=True) for j in (0, 1)]
            groups = _by_mode(*self._pairs_and_real)
            return ComplexModes(Kind.PROPORTIONAL, tuple(map(ComplexMode, map(_doubles, groups), shapes)))
        modes = self._gathered()
        kind = self._kind_by_roots(modes)
        if kind is Kind.PARTED:
            modes.sort(key=lambda one: -one.exponents[0].real)
        return ComplexModes(kind, tuple(modes))

    @cached_property
    def expansion(self) -> Expansion:
        """P with its roots, in numbers of mpmath; the amplitudes are of some start."""
        return resolved(Driven(self.chain, self.c2, 0.0, 0.0, (1.0, 0.0), (0.0, 1.0), self.c1), DIGITS)

    @cached_property
    def _roots(self) -> list[Any]:
        """All four, as `roots` orders them, in numbers of mpmath."""
        groups: list[list[Any]] = []
        for s in sorted(self.expansion.exponents, key=abs):
            if groups and abs(s) - abs(groups[-1][0]) <= _NOISE * abs(s):
                groups[-1].append(s)
            else:
                groups.append([s])
        moving = [s for group in groups for s in sorted(group, key=lambda s: (-s.real, -s.imag))]
        moving = [s if abs(s.imag) > _NOISE * abs(s.real) else s - 1j * s.imag for s in moving]
        return [self.expansion.ctx.mpc(0)] * (4 - len(moving)) + moving

    def _ratio(self, i: int, s: Any) -> complex:
        """X2/X1 of a root, the i-th."""
        if s:
            group = next((j for j, group in enumerate(self._groups) if s in group), None)
            one, two = self._direction(s) if group is None else self._mode_direction(group)
        else:
            one, two = [mode.shape for mode in self.free_motions.modes for s in mode.exponents if not s][i]
        ratio = two / one if one else self.expansion.ctx.inf
        return complex(ratio.real if not s or not s.imag else ratio)

    @cached_property
    def _groups(self) -> list[Roots]:
        """The roots of the slow and of the fast mode, both of each pair, where the modes keep their shapes."""
        if not (self.k1 and self.k2) or not self.proportional:
            return []
        pairs, real = self._pairs_and_real
        return [(*group, *(s.conjugate() for s in group)) for group in _by_mode(pairs, real)]

    @cached_property
    def _pairs_and_real(self) -> tuple[list[Any], list[Any]]:
        """One root of each pair, and the real ones; both sorted by modulus, without roots at 0."""
        moving = [s for s in self._roots if s]
        return [s for s in moving if s.imag > 0], [s for s in moving if not s.imag]

    def _undamped(self) -> ComplexModes:
        modes = self.chain.exact_modes
        exponents = [(float(mode.omega) * 1j,) if mode.omega else (0j, 0j) for mode in modes]
        shapes = [_rounded(self._mode_direction(j), real=True) for j in (0, 1)]
        return ComplexModes(Kind.UNDAMPED, tuple(map(ComplexMode, exponents, shapes)))

    def _without_a_spring(self) -> ComplexModes:
        pairs, real = self._pairs_and_real
        if not (self.k1 or self.c1) or not (self.k2 or self.c2):
            moving = (*pairs, *real)
            rests = (0j,) * (2 - len(real) - 2 * len(pairs))
            other = ComplexMode((*rests, *_doubles(moving)), self._shape(moving[-1], real=True))
            if self.k1 or self.c1:
                return ComplexModes(Kind.DRIFT_TWO, (ComplexMode((0j, 0j), TWO), other))
            return ComplexModes(Kind.DRIFT_BOTH, (ComplexMode((0j, 0j), BOTH), other))
        if not (self.k1 or self.k2):
            return ComplexModes(Kind.REST_EACH, tuple(ComplexMode((0j, complex(s)), self._shape(s)) for s in real))
        kind, rest = (Kind.REST_TWO, TWO) if self.k1 else (Kind.REST_BOTH, BOTH)
        return ComplexModes(kind, (*self._gathered(), ComplexMode((0j,), rest)))

    def _gathered(self) -> list[ComplexMode]:
        """The motions without proportional damping: one for each root that is not near another."""
        pairs, real = self._pairs_and_real
        groups: list[list[Any]] = []
        for s in (*pairs, *real):
            near = next((group for group in groups if abs(group[0] - s) <= NEAR * abs(s)), None)
            if near:
                near.append(s)
            else:
                groups.append([s])
        modes = [ComplexMode(_doubles(group), self._shape(group[0])) for group in groups]
        return sorted(modes, key=lambda one: not one.swings)

    def _kind_by_roots(self, modes: Sequence[ComplexMode]) -> Kind:
        swinging = [one for one in modes if one.swings]
        if len(swinging) == 2:
            return Kind.PARTED if self._beyond else Kind.TWO_PAIRS
        if swinging:
            return Kind.ONE_PAIR if len(modes) > 1 else Kind.EXCEPTIONAL
        two_and_two = len(modes) == 4 and self.types == (1, 1, -1, -1)
        return Kind.CREEPING if two_and_two else Kind.FOUR_REAL

    @property
    def _beyond(self) -> bool:
        """True if both pairs have the same modulus: the ray (tau c1, tau c2) met the exceptional point at tau < 1."""
        m1, m2, k1, k2, c1, c2 = (written(getattr(self, field.name)) for field in fields(self))
        p4, p3, p2 = m1 * m2, m1 * c2 + m2 * (c1 + c2), m1 * k2 + m2 * (k1 + k2) + c1 * c2
        p1, p0 = c1 * k2 + c2 * k1, k1 * k2
        g = 4 * p4 * p2 - p3 * p3
        return p1 * p1 * p4 == p0 * p3 * p3 and (g < 0 or g * g < 64 * p4**3 * p0)

    @cached_property
    def types(self) -> tuple[int, ...]:
        """The sign of x^T (2 s M + C) x for each real root that is not 0, the slowest first.

        Where a pair meets the real axis a + root leaves to the right and a - root to the left.
        """
        signs = []
        for s in self._pairs_and_real[1]:
            one, two = (part.real for part in self._direction(s))
            size = 2 * s.real * (self.m1 * one**2 + self.m2 * two**2) + self.c1 * one**2 + self.c2 * (two - one) ** 2
            signs.append(1 if size > 0 else -1)
        return tuple(signs)

    def _shape(self, s: Any, *, real: bool = False) -> tuple[complex, complex]:
        return _rounded(self._direction(s), real=real or not _turns(s))

    def _direction(self, s: Any) -> Direction:
        """X1 and X2 of a root, from the equation with the larger terms."""
        ctx = self.expansion.ctx
        m1, m2, k1, k2, c1, c2 = (ctx.mpf(getattr(self, field.name)) for field in fields(self))
        link, own = k2 + c2 * s, k1 + c1 * s + m1 * s * s
        pairs = (m2 * s * s + link, link), (link, own + link)
        return self._scaled(*max(pairs, key=lambda pair: taxicab(pair[0]) + taxicab(pair[1])))

    def _mode_direction(self, j: int) -> Direction:
        """X1 and X2 of a mode without dashpots."""
        return self._scaled(*(self.expansion.ctx.mpf(str(part)) for part in self.chain.exact_modes[j].shape))

    def _scaled(self, one: Any, two: Any) -> Direction:
        """A direction with X1 real and not negative; its larger part has modulus 1."""
        one, two = self.expansion.ctx.mpc(one), self.expansion.ctx.mpc(two)
        size = max(abs(one), abs(two))
        turn = abs(one) / one / size if one else 1 / two
        return abs(one) / size, two * turn


def written(value: float) -> Fraction:
    """The rational number of a double's shortest decimal text.

    Parameters
    ----------
    value : float
        A finite number.

    Returns
    -------
    Fraction
        The number as it is written: 3/10 for 0.3.
    """
    return Fraction(repr(float(value)))


def _by_mode(pairs: list[Any], real: list[Any]) -> list[Roots]:
    """The roots of the slow and of the fast mode with proportional damping.

    The fast mode stops swinging first. If neither swings, its roots enclose both roots of the slow mode.
    """
    if len(pairs) == 2:
        return [(s,) for s in pairs]
    return [(pairs[0],), tuple(real)] if pairs else [(real[1], real[2]), (real[0], real[3])]


def _rounded(direction: Direction, *, real: bool) -> tuple[complex, complex]:
    one, two = direction
    return complex(one), complex(two.real if real else two)


def _turns(s: Any) -> bool:
    """True if a root is not near its conjugate."""
    return bool(2 * s.imag > NEAR * abs(s))


def _doubles(group: Sequence[Any]) -> tuple[complex, ...]:
    return tuple(map(complex, group))
