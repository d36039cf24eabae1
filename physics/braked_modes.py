"""Free motions exp(s t) of the two-mass chain with dashpots, their complex shapes, and which of them form a mode.

    wall --k1, c1-- [m1] --k2, c2-- [m2]        P(s) = 0, see physics.transient

    X2/X1 = (k2 + c2 s)/(m2 s^2 + c2 s + k2) = (m1 s^2 + (c1 + c2) s + k1 + k2)/(k2 + c2 s)

The damping is proportional if c1 k2 = c2 k1 (T. K. Caughey and M. E. J. O'Kelly, J. Appl. Mech. 32 (1965) 583). Each
mode then keeps the shape that it has without dashpots, and both of its roots. Without proportional damping two
different roots have two different shapes, so two real roots never form a mode.

Roots and shapes are computed with 120 digits or more and rounded once. Equalities between parameters are tested
without error on the numbers as they are written in decimals: 0.3 is 3/10.
"""

from collections.abc import Sequence
from enum import StrEnum
from fractions import Fraction
from typing import Any, NamedTuple

from physics.coupled import TwoMassChain
from physics.exact import exact, precise
from physics.laplace import Driven, Expansion, resolved
from physics.roots import taxicab

DIGITS = 120
NEAR = 1e-6
"""Roots that are closer than this share of their modulus count as one root."""

Roots = tuple[Any, ...]  # numbers of mpmath
Direction = tuple[Any, Any]  # X1 and X2, numbers of mpmath


class Kind(StrEnum):
    """Kinds of free motion of a chain with dashpots, in the order in which they are tested."""

    DRIFT_BOTH = "drift_both"  # k1 = c1 = 0
    DRIFT_TWO = "drift_two"  # k2 = c2 = 0
    REST_EACH = "rest_each"  # k1 = k2 = 0, both dashpots
    REST_BOTH = "rest_both"  # k1 = 0, c1 > 0
    REST_TWO = "rest_two"  # k2 = 0, c2 > 0
    PROPORTIONAL = "proportional"
    EXCEPTIONAL = "exceptional"  # both modes have become one
    PARTED = "parted"  # two pairs of equal modulus, beyond the exceptional point
    TWO_PAIRS = "two_pairs"
    ONE_PAIR = "one_pair"
    CREEPING = "creeping"  # four real roots: two creep, two die quickly
    FOUR_REAL = "four_real"


class BrakedMode(NamedTuple):
    """Free motions of one shape: x_i = Re(shape[i] exp(s t)) for each of the `exponents` s in 1/s.

    Exponents are real, the slowest first, or one of each conjugate pair, Im(s) > 0. The larger part of the shape has
    modulus 1; X1 is real and not negative.
    """

    exponents: tuple[complex, ...]
    shape: tuple[complex, complex]

    @property
    def swings(self) -> bool:
        """Whether its root is not real, as far as NEAR tells."""
        return _turns(self.exponents[0])

    @property
    def repeats(self) -> int:
        """The number of times that its root occurs if all of its exponents are one root; else 1."""
        first, *others = self.exponents
        if any(abs(s - first) > NEAR * abs(first) for s in others):
            return 1
        return sum(2 if s.imag and not self.swings else 1 for s in self.exponents)


class BrakedModes(NamedTuple):
    """Free motions of a chain, by their shapes.

    Modes come slow first. Other motions come with the one that swings first, then by their rates; a rest is the last.
    """

    kind: Kind
    modes: tuple[BrakedMode, ...]

    @property
    def crossed(self) -> bool:
        """Whether of two pairs the one of the smaller modulus swings faster."""
        return self.kind is Kind.TWO_PAIRS and self.modes[0].exponents[0].imag > self.modes[1].exponents[0].imag


def braked_modes(chain: TwoMassChain, c1: float, c2: float) -> BrakedModes:
    """The free motions of the chain; at least one of the dashpots is there."""
    driven = Driven(chain, c2, 0.0, 0.0, (1.0, 0.0), (0.0, 1.0), c1)
    found = resolved(driven, DIGITS)
    if not (chain.k1 and chain.k2):
        return _without_a_spring(driven, found)
    if in_line(chain, c1, c2):
        shapes = [_rounded(_scaled(found.ctx, *map(str, mode.shape)), real=True) for mode in chain.exact_modes]
        groups = _by_mode(*_pairs_and_real(found))
        return BrakedModes(Kind.PROPORTIONAL, tuple(map(BrakedMode, map(_doubles, groups), shapes)))
    modes = _gathered(driven, found)
    kind = _kind_by_roots(driven, found, modes)
    if kind is Kind.PARTED:
        modes.sort(key=lambda one: -one.exponents[0].real)
    return BrakedModes(kind, tuple(modes))


def in_line(chain: TwoMassChain, c1: float, c2: float) -> bool:
    """Whether c1 k2 = c2 k1 in the numbers as written: proportional damping."""
    return written(c1) * written(chain.k2) == written(c2) * written(chain.k1)


def meeting(chain: TwoMassChain, c1: float, c2: float) -> tuple[float, float]:
    """The dashpots in the ratio of these at which both pairs have the same modulus and decay rate.

    It is the exceptional point if the pairs of c1 and c2 have the same modulus.
    """
    m1, m2, _, _ = chain.exact_parameters
    one, two = exact(c1), exact(c2)
    with precise():
        slow, fast = chain.exact_modes
        square = (m1 * two + m2 * (one + two)) ** 2 - 4 * m1 * m2 * one * two
        share = 2 * m1 * m2 * (fast.omega - slow.omega) / square.sqrt()
        return float(share * one), float(share * two)


def written(value: float) -> Fraction:
    """The number that the shortest decimal text of a double stands for."""
    return Fraction(repr(float(value)))


def _without_a_spring(driven: Driven, found: Expansion) -> BrakedModes:
    chain, c1, c2 = driven.chain, driven.c1, driven.c
    pairs, real = _pairs_and_real(found)
    both, two = (1 + 0j, 1 + 0j), (0j, 1 + 0j)
    if not (chain.k1 or c1) or not (chain.k2 or c2):
        moving = (*pairs, *real)
        rests = (0j,) * (2 - len(real) - 2 * len(pairs))
        other = BrakedMode((*rests, *_doubles(moving)), _shape(driven, found.ctx, moving[-1], real=True))
        if chain.k1 or c1:
            return BrakedModes(Kind.DRIFT_TWO, (BrakedMode((0j, 0j), two), other))
        return BrakedModes(Kind.DRIFT_BOTH, (BrakedMode((0j, 0j), both), other))
    if not (chain.k1 or chain.k2):
        modes = tuple(BrakedMode((0j, complex(s)), _shape(driven, found.ctx, s)) for s in real)
        return BrakedModes(Kind.REST_EACH, modes)
    kind, rest = (Kind.REST_TWO, two) if chain.k1 else (Kind.REST_BOTH, both)
    return BrakedModes(kind, (*_gathered(driven, found), BrakedMode((0j,), rest)))


def _pairs_and_real(found: Expansion) -> tuple[list[Any], list[Any]]:
    """One root of each pair, and the real ones; both sorted by modulus, without roots at 0."""
    by_size = sorted(found.exponents, key=abs)
    return [s for s in by_size if s.imag > 0], [s for s in by_size if not s.imag]


def _by_mode(pairs: list[Any], real: list[Any]) -> list[Roots]:
    """The roots of the slow and of the fast mode with proportional damping.

    The fast mode stops swinging first. If neither swings, both of its roots enclose those of the slow mode.
    """
    if len(pairs) == 2:
        return [(s,) for s in pairs]
    return [(pairs[0],), tuple(real)] if pairs else [(real[1], real[2]), (real[0], real[3])]


def _gathered(driven: Driven, found: Expansion) -> list[BrakedMode]:
    """The motions without proportional damping: one for each root that is not near another."""
    pairs, real = _pairs_and_real(found)
    groups: list[list[Any]] = []
    for s in (*pairs, *real):
        near = next((group for group in groups if abs(group[0] - s) <= NEAR * abs(s)), None)
        if near:
            near.append(s)
        else:
            groups.append([s])
    modes = [BrakedMode(_doubles(group), _shape(driven, found.ctx, group[0])) for group in groups]
    return sorted(modes, key=lambda one: not one.swings)


def _kind_by_roots(driven: Driven, found: Expansion, modes: Sequence[BrakedMode]) -> Kind:
    swinging = [one for one in modes if one.swings]
    if len(swinging) == 2:
        return Kind.PARTED if _beyond(driven) else Kind.TWO_PAIRS
    if swinging:
        return Kind.ONE_PAIR if len(modes) > 1 else Kind.EXCEPTIONAL
    two_and_two = len(modes) == 4 and _signs(driven, found) == [True, True, False, False]
    return Kind.CREEPING if two_and_two else Kind.FOUR_REAL


def _beyond(driven: Driven) -> bool:
    """Whether both pairs have the same modulus: the ray (tau c1, tau c2) met the exceptional point at tau < 1."""
    chain = driven.chain
    m1, m2, k1, k2, c1, c2 = map(written, (chain.m1, chain.m2, chain.k1, chain.k2, driven.c1, driven.c))
    p4, p3, p2 = m1 * m2, m1 * c2 + m2 * (c1 + c2), m1 * k2 + m2 * (k1 + k2) + c1 * c2
    p1, p0 = c1 * k2 + c2 * k1, k1 * k2
    g = 4 * p4 * p2 - p3 * p3
    return p1 * p1 * p4 == p0 * p3 * p3 and (g < 0 or g * g < 64 * p4**3 * p0)


def _signs(driven: Driven, found: Expansion) -> list[bool]:
    """Whether x^T (2 s M + C) x > 0 for each of the real roots, the slowest first."""
    signs = []
    for s in _pairs_and_real(found)[1]:
        one, two = (part.real for part in _direction(driven, found.ctx, s))
        mass = driven.chain.m1 * one**2 + driven.chain.m2 * two**2
        signs.append(2 * s.real * mass + driven.c1 * one**2 + driven.c * (two - one) ** 2 > 0)
    return signs


def _shape(driven: Driven, ctx: Any, s: Any, *, real: bool = False) -> tuple[complex, complex]:
    return _rounded(_direction(driven, ctx, s), real=real or not _turns(s))


def _direction(driven: Driven, ctx: Any, s: Any) -> Direction:
    """X1 and X2 of a root, from the equation with the larger terms."""
    chain = driven.chain
    m1, m2, k1, k2, c1, c2 = map(ctx.mpf, (chain.m1, chain.m2, chain.k1, chain.k2, driven.c1, driven.c))
    link, own = k2 + c2 * s, k1 + c1 * s + m1 * s * s
    pairs = (m2 * s * s + link, link), (link, own + link)
    return _scaled(ctx, *max(pairs, key=lambda pair: taxicab(pair[0]) + taxicab(pair[1])))


def _scaled(ctx: Any, one: Any, two: Any) -> Direction:
    """A direction with X1 real and not negative; its larger part has modulus 1."""
    one, two = ctx.mpc(one), ctx.mpc(two)
    size = max(abs(one), abs(two))
    turn = abs(one) / one / size if one else 1 / two
    return abs(one) / size, two * turn


def _rounded(direction: Direction, *, real: bool) -> tuple[complex, complex]:
    one, two = direction
    return complex(one), complex(two.real if real else two)


def _turns(s: Any) -> bool:
    """Whether a root is not near its conjugate."""
    return bool(2 * s.imag > NEAR * abs(s))


def _doubles(group: Sequence[Any]) -> tuple[complex, ...]:
    return tuple(map(complex, group))
