r"""Paths of the roots of a damped chain while its dashpots grow, and where roots meet on the way.

The dashpots are (c1, c2) = base + value direction, so P(s) is a polynomial in s and in the value. Two roots meet on
the real axis at simple roots of its discriminant; at double ones both pairs meet at once. That happens at one point
(c1, c2) of a chain at most, the exceptional point: with b = sqrt(k1 k2/(m1 m2)) it lies on the ray of direction
+-(b (m1 + m2) - k1, k2 - b m2), and P = m1 m2 (s^2 + a s + b)^2 there.

As one dashpot grows two roots end in the roots of dP/dc, one in 0 and one in -infinity:

    c1:  s (m2 s^2 + c2 s + k2)     mass 2 on mass 1 at rest
    c2:  s ((m1 + m2) s^2 + c1 s + k1)     one block on spring 1

If both grow in proportion, two roots creep to -k1/c1 and -k2/c2.

Source: beyond lecture D34, whose notes allow for a frequency with an imaginary part.
"""

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import permutations
from typing import Literal, NamedTuple

import numpy as np
from numpy.polynomial import polynomial
from numpy.typing import ArrayLike

from physics.coupled import TwoMassChain
from physics.damped import DampedOscillator
from physics.damped_chain import Complexes, DampedChain
from physics.precision.exact import Array, precise, sum_of
from physics.precision.polynomials import Polynomial, added, positive_roots, product
from physics.valid import finite_array

_STEPS, _DECADES = 300, 3
_NEAR = 1e-4  # of a value where roots meet: the path is vertical there
_OFF = 1e-9  # of its distance from 0: a point so near to a path is on it
_ORDERS = np.array(list(permutations(range(4))))
Dashpots = tuple[float, float]
Varied = Literal["c1", "c2", "both"]
_DISCRIMINANT = (
    (256, "aaaeee"), (-192, "aabdee"), (-128, "aaccee"), (144, "aacdde"), (-27, "aadddd"), (144, "abbcee"),
    (-6, "abbdde"), (-80, "abccde"), (18, "abcddd"), (16, "acccce"), (-4, "acccdd"), (-27, "bbbbee"), (18, "bbbcde"),
    (-4, "bbbddd"), (-4, "bbccce"), (1, "bbccdd"),
)  # fmt: skip
"""Terms of the discriminant of a s^4 + b s^3 + c s^2 + d s + e."""


class ExceptionalPoint(NamedTuple):
    """Dashpots in N s/m at which both modes are one, and the double roots in 1/s: one of a pair, or two real ones.

    Attributes
    ----------
    c1, c2 : float
        The dampings in N s/m.
    roots : tuple of complex
        The double roots in 1/s: the one of a pair with Im(s) > 0, or two real ones, the slower first.
    """

    c1: float
    c2: float
    roots: tuple[complex, ...]


class RootMeeting(NamedTuple):
    """The value on a path at which two roots meet, or, where it is `double`, two pairs.

    Attributes
    ----------
    value : float
        The value, above 0.
    double : bool
        True if two pairs meet.
    """

    value: float
    double: bool


def exceptional_point(chain: TwoMassChain) -> ExceptionalPoint | None:
    """The exceptional point of a chain, each number rounded once, or None.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.

    Returns
    -------
    ExceptionalPoint or None
        Dampings in N s/m and double roots in 1/s; None if a stiffness is 0, or a damping would be negative.
    """
    m1, m2, k1, k2 = chain.exact_parameters
    if not (k1 and k2):
        return None
    with precise():
        b = (k1 * k2 / (m1 * m2)).sqrt()
        d1, d2 = sum_of(b * (m1 + m2), -k1), sum_of(k2, -b * m2)
        if d1 * d2 < 0:
            return None
        d1, d2 = abs(d1), abs(d2)
        slow, fast = chain.exact_modes
        p3 = m1 * d2 + m2 * (d1 + d2)
        t = (fast.omega - slow.omega) / ((p3 / (2 * m1 * m2)) ** 2 - d1 * d2 / (m1 * m2)).sqrt()
        half = t * p3 / (4 * m1 * m2)
        excess = sum_of(half * half, -b)
        root = abs(excess).sqrt()
        if excess < 0:
            roots: tuple[complex, ...] = (complex(-half, root),)
        else:
            roots = (complex(-b / (half + root)), complex(-half - root))
        return ExceptionalPoint(float(t * d1), float(t * d2), roots)


@dataclass(frozen=True, kw_only=True)
class RootPath:
    """Roots of a chain whose dashpots in N s/m are base + value direction, the value from 0 on.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    base : tuple of float
        c1 and c2 in N s/m at the value 0.
    direction : tuple of float
        What a unit of the value adds to c1 and c2, in N s/m; at least one of them is above 0.
    """

    chain: TwoMassChain
    base: Dashpots
    direction: Dashpots

    @classmethod
    def of(cls, one: DampedChain, varied: Varied) -> "RootPath":
        """The path of "c1", of "c2", or of "both" in proportion; undamped, both grow like their springs, if any.

        Parameters
        ----------
        one : DampedChain
            The chain; a dashpot that is not varied stays as it is.
        varied : {"c1", "c2", "both"}
            What grows with the value.

        Returns
        -------
        RootPath
            Its value is c1 or c2 in N s/m, or for "both" the factor of the direction.
        """
        if varied == "both":
            pair = next((pair for pair in ((one.c1, one.c2), (one.k1, one.k2)) if any(pair)), (1.0, 1.0))
            return cls(chain=one.chain, base=(0.0, 0.0), direction=pair)
        if varied == "c1":
            return cls(chain=one.chain, base=(0.0, one.c2), direction=(1.0, 0.0))
        return cls(chain=one.chain, base=(one.c1, 0.0), direction=(0.0, 1.0))

    def at(self, value: float) -> DampedChain:
        """The chain with the dashpots of a value.

        Parameters
        ----------
        value : float
            The value, 0 or more.

        Returns
        -------
        DampedChain
            The chain with c1 and c2 in N s/m.

        Raises
        ------
        ValueError
            If a dashpot is negative or not finite.
        """
        c1, c2 = (a + value * b for a, b in zip(self.base, self.direction, strict=True))
        return DampedChain.of(self.chain, c1, c2)

    @cached_property
    def meetings(self) -> tuple[RootMeeting, ...]:
        """Values above 0 at which roots meet, each rounded once."""
        found = positive_roots(self._discriminant)
        return tuple(RootMeeting(float(value), times % 2 == 0) for value, times in found)

    @cached_property
    def limits(self) -> Complexes:
        """The limits of two roots as the value grows, in 1/s (2,): see above."""
        chain, (c1, c2), (d1, d2) = self.chain, self.base, self.direction
        if d1 and d2:
            return np.array([-chain.k1 / d1, -chain.k2 / d2], dtype=complex)
        left = (chain.m2, c2, chain.k2) if d1 else (chain.m1 + chain.m2, c1, chain.k1)
        one = DampedOscillator(**dict(zip(("m", "c", "k"), left, strict=True)))
        slow, fast = one.rates
        swing = one.omega_d
        return np.array([complex(-slow, swing), complex(-slow, -swing)] if swing else [-slow, -fast], dtype=complex)

    @cached_property
    def values(self) -> Array:
        """Values for a drawing, from 0 up, closer together where roots meet."""
        chain = self.chain
        omega = float(chain.modes().omega[1]) or 1.0
        unit = omega * min(chain.m1, chain.m2) / max(self.direction)
        near = 1 + np.concatenate([-1 * (grid := np.geomspace(_NEAR, 0.3, 12) ** 2), [0.0], grid])
        spread = unit * np.geomspace(10.0**-_DECADES, 10.0**_DECADES, _STEPS)
        meetings = [one.value for one in self.meetings]
        beyond = [value * np.geomspace(0.01, 1.0, 60) for value in meetings if value > spread[-1]]
        return np.unique(np.concatenate([[0.0], spread, *beyond, *(value * near for value in meetings)]))

    def roots(self, values: ArrayLike) -> Complexes:
        """The roots (n, 4) in 1/s, for a drawing: by companion matrices, half of the digits where roots meet.

        Parameters
        ----------
        values : array_like, shape (n,)
            Values of the path.

        Returns
        -------
        ndarray of complex, shape (n, 4)
            The roots in 1/s, in no order.

        Raises
        ------
        ValueError
            If a value is not finite.
        """
        values = finite_array("values", values)
        P = polynomial.polyval(values, self.scaled.T)
        companion = np.zeros((values.size, 4, 4))
        companion[:, [1, 2, 3], [0, 1, 2]] = 1.0
        companion[:, :, 3] = -(P[:4] / P[4]).T
        return np.asarray(self.unit * np.linalg.eigvals(companion))

    def branches(self, value: float) -> Complexes:
        """The roots in 1/s for a drawing (n, 4), along the path and through a value, which is the last row once more.

        Each column is one root: from row to row they move least.

        Parameters
        ----------
        value : float
            The value whose roots are the last row.

        Returns
        -------
        ndarray of complex, shape (n, 4)
            The roots in 1/s: a row for each of `values` and for the value, in rising order, then the last row.

        Raises
        ------
        ValueError
            If the value is not finite.
        """
        values = np.union1d(self.values, value)
        found = self.roots(values)
        far = np.abs(found[:-1, :, None] - found[1:, None, :])
        order, nearest = np.arange(4), far[:, np.arange(4), _ORDERS].sum(axis=2).argmin(axis=1)
        for row, best in enumerate(nearest, start=1):
            order = _ORDERS[best][order]
            found[row] = found[row][order]
        return np.concatenate([found, found[np.searchsorted(values, [value])]])

    @cached_property
    def exceptional(self) -> tuple[complex, ...]:
        """The double roots in 1/s at the exceptional point, if the path leads to it: a pair, or two real ones."""
        point = exceptional_point(self.chain)
        if point is None:
            return ()
        off, size = np.array([point.c1, point.c2]) - self.base, float(np.hypot(point.c1, point.c2))
        one, two = np.array(self.direction) / max(self.direction)
        is_on_it = abs(off[0] * two - off[1] * one) <= _OFF * size and off[0] * one + off[1] * two >= -_OFF * size
        return (*point.roots, *(s.conjugate() for s in point.roots))[:2] if is_on_it else ()

    def dragged(self, z: complex) -> float:
        """The value at which |P(z)| is least, in doubles: a root that is dragged to z sets it.

        Parameters
        ----------
        z : complex
            The point in 1/s.

        Returns
        -------
        float
            The value, 0 or more.
        """
        at = polynomial.polyval(z / self.unit, self.scaled)
        square = polynomial.polymul(at, at.conj()).real
        slope = np.trim_zeros(polynomial.polyder(square), "b")
        turns = polynomial.polyroots(slope) if slope.size else np.array([])
        able = [0.0, *(v.real for v in turns.tolist() if v.real > 0 and abs(v.imag) <= 1e-6 * abs(v))]
        return float(min(able, key=lambda value: float(polynomial.polyval(value, square))))

    @property
    def unit(self) -> float:
        """The frequency in rad/s by which roots are divided before they are computed in doubles."""
        return float(self.chain.modes().omega[1]) or 1.0

    @cached_property
    def scaled(self) -> Array:
        """P in doubles (5, 3), the highest coefficient 1, for roots in that unit; columns are powers of the value."""
        unit, (highest,) = Fraction(self.unit), self._P[4]
        rows = [[float(b * unit**i / (highest * unit**4)) for b in a] for i, a in enumerate(self._P)]
        return np.array([row + [0.0] * (3 - len(row)) for row in rows])

    @cached_property
    def _P(self) -> tuple[Polynomial, ...]:
        """The coefficients of P, the constant first, each a polynomial in the value."""
        chain = self.chain
        m1, m2, k1, k2 = ((Fraction(one),) for one in (chain.m1, chain.m2, chain.k1, chain.k2))
        c1, c2 = ((Fraction(a), Fraction(b)) for a, b in zip(self.base, self.direction, strict=True))
        return (
            product(k1, k2),
            added(product(c1, k2), product(c2, k1)),
            added(product(m1, k2), product(m2, k1), product(m2, k2), product(c1, c2)),
            added(product(m1, c2), product(m2, c1), product(m2, c2)),
            product(m1, m2),
        )

    @property
    def _discriminant(self) -> Polynomial:
        """The discriminant of P, or of what is left of it where the chain drifts."""
        parts = dict(zip("edcba", self._P, strict=True))
        if not (any(parts["e"]) or any(parts["d"])):
            return added(product(parts["b"], parts["b"]), product((Fraction(-4),), parts["a"], parts["c"]))
        terms = (product((Fraction(factor),), *(parts[one] for one in term)) for factor, term in _DISCRIMINANT)
        return added(*terms)
