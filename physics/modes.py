"""Looking for the modes of two masses and two springs (lecture D34, slides 2 to 4).

    wall --k1-- [m1] --k2-- [m2]        x1 = X1 sin(omega t + phi), x2 = X2 sin(omega t + phi)

    A (X1, X2)^T = 0,   A = [[m1 omega^2 - k1 - k2, k2], [k2, m2 omega^2 - k2]]

At any omega each row alone fixes a shape:

    row 1:  X2/X1 = (k1 + k2 - m1 omega^2)/k2        row 2:  X2/X1 = k2/(k2 - m2 omega^2)

A motion needs both. They agree only where

    D = det A = k2 (k2 - m2 omega^2) (row 1 - row 2) = m1 m2 omega^4 - b omega^2 + k1 k2

vanishes. In terms of forces: to move with X sin(omega t), mass j needs -m_j omega^2 X_j. The springs give
-k1 X1 + k2 (X2 - X1) and -k2 (X2 - X1), and a hand would have to add the difference.

Values at one trial omega are computed without error and rounded once to 80 digits, so they are zero only at a mode,
not at the next double, and nothing overflows. Curves are in float64.
"""

from __future__ import annotations

from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal, Inexact, localcontext
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from physics.coupled import TwoMassChain, Vector, free_modes
from physics.precision.exact import Array, exact, precise
from physics.valid import check_finite, check_not_negative

_WHOLE = Context(prec=10_000, Emin=MIN_EMIN, Emax=MAX_EMAX, traps=[Inexact])
"""No sum or product here has more digits: D of doubles has 8300 at most."""


class Trial(NamedTuple):
    """The equations A X = 0 at one trial omega, in 80 digits.

    Attributes
    ----------
    matrix : tuple of tuple of Decimal
        A in N/m, row by row.
    determinant : Decimal
        D = det A in N^2/m^2.
    rows : tuple of Decimal or None
        The ratio X2/X1 that each row of A demands: infinite if it demands X1 = 0, None if every ratio fulfils it.
    apart : Decimal or None
        Row 1 less row 2; None if one of them is not a number.
    """

    matrix: tuple[Vector, Vector]
    determinant: Decimal
    rows: tuple[Decimal | None, Decimal | None]
    apart: Decimal | None


class TrialForces(NamedTuple):
    """The forces on each mass at full swing: needed by the motion, given by the springs, missing; N, in 80 digits.

    Attributes
    ----------
    amplitude : tuple of Decimal
        X1 and X2 in m.
    needed : tuple of Decimal
        The forces -m_j omega^2 X_j in N.
    springs : tuple of Decimal
        The forces of the springs in N.
    missing : tuple of Decimal
        Needed less springs in N: what a hand would have to add.
    """

    amplitude: Vector
    needed: Vector
    springs: Vector
    missing: Vector


class Quadratic(NamedTuple):
    """m1 m2 omega^4 - b omega^2 + k1 k2 = 0 in 80 digits: why both roots are real and positive.

    Delta = b^2 - fourfold, so sqrt(Delta) <= b; and Delta = difference^2 + coupling, so Delta > 0.

    Attributes
    ----------
    leading : Decimal
        m1 m2 in kg^2.
    b : Decimal
        m1 k2 + m2 (k1 + k2) in kg N/m.
    constant : Decimal
        k1 k2 in N^2/m^2.
    fourfold : Decimal
        4 m1 m2 k1 k2 in kg^2 N^2/m^2.
    difference : Decimal
        m1 k2 - m2 (k1 + k2) in kg N/m.
    coupling : Decimal
        4 m1 m2 k2^2 in kg^2 N^2/m^2.
    Delta : Decimal
        The discriminant in kg^2 N^2/m^2.
    root : Decimal
        sqrt(Delta) in kg N/m.
    """

    leading: Decimal
    b: Decimal
    constant: Decimal
    fourfold: Decimal
    difference: Decimal
    coupling: Decimal
    Delta: Decimal
    root: Decimal


def trial(chain: TwoMassChain, omega: float) -> Trial:
    """The two equations at a trial omega in rad/s.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    omega : float
        The trial frequency in rad/s, 0 or more.

    Returns
    -------
    Trial
        A in N/m, its determinant in N^2/m^2, and the ratios of its rows.

    Raises
    ------
    ValueError
        If the frequency is not possible.
    """
    k2 = exact(chain.k2)
    with localcontext(_WHOLE):
        one, two = _diagonal(chain, omega)
        first, second, D, both = -one, -two, one * two - k2 * k2, -k2 * two
    with precise():
        return Trial(
            matrix=((+one, +k2), (+k2, +two)),
            determinant=+D,
            rows=(_fixed(first, k2), _fixed(k2, second)),
            apart=D / both if both else None,
        )


def _diagonal(chain: TwoMassChain, omega: float) -> Vector:
    """A11 and A22, in the precision that is set."""
    check_not_negative("an angular frequency in rad/s", omega=omega)
    m1, m2, k1, k2 = chain.exact_parameters
    square = exact(omega) * exact(omega)
    return m1 * square - k1 - k2, m2 * square - k2


def _fixed(over: Decimal, under: Decimal) -> Decimal | None:
    """The shape X2/X1 = over/under."""
    if under:
        return _over(over, under)
    return Decimal("inf") if over else None


def _over(value: Decimal, unit: Decimal) -> Decimal:
    """value/unit, and a zero without a sign."""
    with precise():
        return +(value / unit)


def trial_forces(chain: TwoMassChain, omega: float, ratio: float) -> TrialForces:
    """The forces in a motion of the shape X2/X1 = ratio at omega; the larger amplitude is 1 m.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    omega : float
        The trial frequency in rad/s, 0 or more.
    ratio : float
        X2/X1, finite.

    Returns
    -------
    TrialForces
        Amplitudes in m and forces in N, two numbers each: of mass 1 and of mass 2.

    Raises
    ------
    ValueError
        If a number is not possible.
    """
    check_finite("a ratio", ratio=ratio)
    _, _, k1, k2 = chain.exact_parameters
    r, size = exact(ratio), exact(max(1.0, abs(ratio)))
    with localcontext(_WHOLE):
        one, two = _diagonal(chain, omega)
        pull = k2 * (r - 1)
        springs = (pull - k1, -pull)
        missing = (-(one + k2 * r), -(k2 + two * r))
        needed = (springs[0] + missing[0], springs[1] + missing[1])
    amplitude = (Decimal(1), r)
    return TrialForces(*((_over(one, size), _over(two, size)) for one, two in (amplitude, needed, springs, missing)))


def quadratic(chain: TwoMassChain) -> Quadratic:
    """The coefficients of the equation for omega^2, and its discriminant in both of its forms.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.

    Returns
    -------
    Quadratic
        Sums and products without error, each rounded to 80 digits.
    """
    m1, m2, k1, k2 = chain.exact_parameters
    with localcontext(_WHOLE):
        leading, constant, fourfold, coupling = m1 * m2, k1 * k2, 4 * m1 * m2 * k1 * k2, 4 * m1 * m2 * k2 * k2
        b, difference = m1 * k2 + m2 * (k1 + k2), m1 * k2 - m2 * (k1 + k2)
        Delta = b * b - fourfold
    with precise():
        return Quadratic(
            leading=+leading,
            b=+b,
            constant=+constant,
            fourfold=+fourfold,
            difference=+difference,
            coupling=+coupling,
            Delta=+Delta,
            root=(+Delta).sqrt(),
        )


def determinant_curve(chain: TwoMassChain, omega: ArrayLike) -> tuple[Array, int]:
    """Return D at the frequencies omega (n,) in units of 10**exponent, and the exponent, 0 for 1e-150 <= |D| <= 1e150.

    Computed from its factors, so that it is within 32 u also near a root (u = 2^-53). For omega up to some
    1e3 omega_+.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    omega : array_like, shape (n,)
        Frequencies in rad/s, at least one.

    Returns
    -------
    tuple of ndarray and int
        D over 10**exponent N^2/m^2, (n,), and the exponent.
    """
    omega = np.asarray(omega, dtype=float)
    modes = chain.modes()
    unit = max(float(np.max(omega)), float(modes.omega[1]))
    factors = np.ones_like(omega)
    for hi, lo in zip(modes.omega, modes.omega_lo, strict=True):
        factors *= ((omega - hi - lo) / unit) * ((omega + hi) / unit)
    with precise():
        size = exact(chain.m1) * exact(chain.m2) * exact(unit) ** 4
        power = size.adjusted() if size else 0
        exponent = 0 if abs(power) <= 150 else 3 * (power // 3)
        return factors * float(size.scaleb(-exponent)), exponent


class Branches(NamedTuple):
    """A curve in pieces: frequencies (n,) and ratios X2/X1 (n,) of each.

    Attributes
    ----------
    omega : list of ndarray
        The frequencies of each piece in rad/s.
    ratio : list of ndarray
        The ratios X2/X1 of each piece.
    """

    omega: list[Array]
    ratio: list[Array]


def row_curves(chain: TwoMassChain, end: float, largest: float, count: int = 120) -> tuple[Branches, Branches]:
    """The shapes that row 1 and row 2 fix, for 0 <= omega <= end and |X2/X1| up to `largest` (> 1).

    In the plane of omega^2 row 1 is a straight line, of which the ends are given; row 2 is a hyperbola with a pole at
    k2/m2. With k2 = 0 row 1 is the upright line at k1/m1 (X1 = 0 elsewhere) and row 2 is 0.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    end : float
        The largest frequency in rad/s, above sqrt(k2/m2).
    largest : float
        The largest |X2/X1|, above 1.
    count : int
        The number of points of each branch of row 2.

    Returns
    -------
    tuple of Branches
        Row 1, one piece of 2 points, and row 2, a piece below the pole and one above it. With k2 = 0 row 2 is one piece
        of 2 points.
    """
    if not chain.k2:
        upright = np.full(2, np.sqrt(chain.k1) / np.sqrt(chain.m1))
        reach = np.array([-largest, largest])
        return Branches([upright], [reach]), Branches([np.array([0.0, end])], [np.zeros(2)])
    return _row_one(chain, end, largest), _row_two(chain, end, largest, count)


def _row_one(chain: TwoMassChain, end: float, largest: float) -> Branches:
    m1, _, k1, k2 = chain.exact_parameters
    with precise():
        both, far = k1 + k2, exact(largest)
        line = [min(both / k2, far), max((both - m1 * exact(end) ** 2) / k2, -far)]
        square = [max((both - k2 * r) / m1, Decimal(0)) for r in line]
        omega = [min(float(value.sqrt()), end) for value in square]
    return Branches([np.array(omega)], [np.array([float(r) for r in line])])


def _row_two(chain: TwoMassChain, end: float, largest: float, count: int) -> Branches:
    pole = float(np.sqrt(chain.k2) / np.sqrt(chain.m2))
    below = np.geomspace(1.0, largest, count)
    last = 1.0 / ((end / pole) ** 2 - 1.0) if end < 1e100 * pole else 0.0
    above = np.geomspace(largest, max(last, 1e-6), count)
    omega = np.append(pole * np.sqrt(1.0 + 1.0 / above[:-1]), end)
    return Branches([pole * np.sqrt(1.0 - 1.0 / below), omega], [below, -np.append(above[:-1], last)])


class Mixture(NamedTuple):
    """The shares of both modes in a motion from rest, and the width of its path. All are 0 where nothing moves.

    Attributes
    ----------
    slow, fast : float
        The share of each mode: its amplitude over both masses, as a part of the sum of both modes. A drift has no
        share.
    width : float
        The width of the path in the plane (x1, x2) over its length, at most.
    """

    slow: float
    fast: float
    width: float


def mixture(chain: TwoMassChain, x_0: ArrayLike) -> Mixture:
    """The mixture of a motion from rest at x_0 (2,); a small part keeps its digits.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    x_0 : array_like, shape (2,)
        Displacements in m at t = 0.

    Returns
    -------
    Mixture
        Shares and width without unit, computed with 80 digits.

    Raises
    ------
    ValueError
        If x_0 is not two finite numbers.
    """
    with precise():
        (a, b), (c, d) = (
            [q * part if mode.omega else Decimal(0) for part in mode.shape]
            for mode, q, _ in free_modes(chain, x_0, (0.0, 0.0)).each()
        )
        slow, fast = (a * a + b * b).sqrt(), (c * c + d * d).sqrt()
        if not (slow or fast):
            return Mixture(0.0, 0.0, 0.0)
        whole, across = slow + fast, abs(a * d - b * c) / max(slow, fast) ** 2
        return Mixture(float(slow / whole), float(fast / whole), float(across))
