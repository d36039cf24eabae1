"""The particular solution of the driven chain, the response curve and the absorber (lecture D34, slides 8 and
9).

With F_0 sin(omega t) on mass 1 the chain can move as x_i = Xp_i sin(omega t),

    Xp1 = (k2 - m2 omega^2) F_0/D,   Xp2 = k2 F_0/D,   D = m1 m2 (omega^2 - omega_-^2)(omega^2 - omega_+^2).

Mass 1 is at rest at omega^2 = k2/m2. D and k2 - m2 omega^2 lose their digits near their roots; so one
frequency is worked out in rational numbers, and a curve from factors omega -+ root with the roots as hi + lo.
"""

import math
from collections.abc import Iterator, Sequence
from decimal import Decimal
from fractions import Fraction

import numpy as np
from numpy.typing import ArrayLike

from physics.coupled import TwoMassChain
from physics.precision.exact import (
    Array,
    DoubleDouble,
    exact,
    pair_product,
    pair_quotient,
    pair_sum,
    precise,
    split,
    three_doubles,
    two_product,
    two_sum,
)
from physics.valid import DOUBLES, check_finite, check_not_negative, finite_array

_COMFORT = Decimal("1e40")  # factors of D within this and its inverse cannot over- or underflow


def particular_solution(chain: TwoMassChain, F_0: float, omega: ArrayLike) -> Array:
    """Return the signed amplitudes Xp1, Xp2 of the particular solution Xp sin(omega t).

    One frequency is worked out in rational numbers and rounded once; a curve is within 2 ulp.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    F_0 : float
        The amplitude of the force on mass 1 in N.
    omega : float or array_like, shape (n,)
        Drive frequencies in rad/s, 0 or more.

    Returns
    -------
    ndarray, shape (2,) or (2, n)
        Amplitudes in m. +inf where no steady amplitude exists, at a natural frequency exactly, whichever sign it has
        on the two sides.

    Raises
    ------
    ValueError
        If a number is not possible, or an amplitude leaves the range of doubles.
    """
    frequencies = finite_array("omega", omega)
    check_drive(F_0, float(frequencies.min(initial=0.0)))
    F_0 = float(F_0)
    if np.ndim(omega) and _comfortable(chain, F_0, frequencies):
        return _response_curve(chain, F_0, frequencies)
    each = [rounded_amplitudes(chain, w, exact_amplitudes(chain, F_0, w)) for w in frequencies.tolist()]
    return np.array(each).reshape(-1, 2).T if np.ndim(omega) else each[0]


def antiresonance(chain: TwoMassChain) -> float:
    """Return the frequency sqrt(k2/m2) of the `chain` in rad/s at which mass 1 is at rest, correctly rounded."""
    return float(chain.exact_antiresonance)


def at_natural_frequency(omega: float) -> ValueError:
    """Return the ValueError that says that no particular solution exists at `omega` in rad/s."""
    return ValueError(
        f"the drive at omega = {omega:.6g} rad/s is at a natural frequency, where no particular solution exists: "
        "another frequency is needed"
    )


def check_drive(F_0: float, omega: float) -> None:
    """Raise ValueError if F_0 is not a finite force in N, or omega not a finite frequency in rad/s, 0 or more."""
    check_finite("a force in N", F_0=F_0)
    check_not_negative("a drive frequency in rad/s", omega=omega)


def exact_amplitudes(chain: TwoMassChain, F_0: float, omega: float) -> tuple[Fraction, Fraction] | None:
    """Return the amplitudes of the particular solution without rounding.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    F_0 : float
        The amplitude of the force on mass 1 in N.
    omega : float
        The frequency of the drive in rad/s, 0 or more.

    Returns
    -------
    tuple of two Fractions, or None
        Xp1 and Xp2 in m; None at a natural frequency.
    """
    one, two, link, scale = _matrix(chain, omega)
    F, above, D = Fraction(F_0), (two, link), one * two - link**2
    if not F:
        return F, F
    if not link:
        above, D = (1, 0), one
    if not D:
        return None
    X1, X2 = (Fraction(part * scale * F.numerator, D * F.denominator) for part in above)
    return X1, X2


def _matrix(chain: TwoMassChain, omega: float) -> tuple[int, int, int, int]:
    """k1 + k2 - m1 omega^2, k2 - m2 omega^2 and k2 as whole numbers over the fourth: doubles are such over 2^n."""
    ratios = [value.as_integer_ratio() for value in (chain.m1, chain.m2, chain.k1, chain.k2)]
    scale = max(below for _, below in ratios)
    m1, m2, k1, k2 = (above * (scale // below) for above, below in ratios)
    p, q = (part**2 for part in float(omega).as_integer_ratio())
    return (k1 + k2) * q - m1 * p, k2 * q - m2 * p, k2 * q, scale * q


def rounded_amplitudes(chain: TwoMassChain, omega: float, exactly: tuple[Fraction, Fraction] | None) -> Array:
    """Return the amplitudes of the particular solution, rounded once.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    omega : float
        The frequency of the drive in rad/s.
    exactly : tuple of two Fractions, or None
        The amplitudes in m, from `exact_amplitudes`.

    Returns
    -------
    ndarray (2,)
        Xp1 and Xp2 in m; inf for None, as in `particular_solution`.

    Raises
    ------
    ValueError
        If an amplitude leaves the range of doubles.
    """
    if exactly is None:
        return np.array([math.inf, math.inf if chain.k2 else 0.0])
    X1, X2 = exactly
    return np.array(
        [
            _nearest(f"the amplitude Xp1 at omega = {omega:.6g} rad/s", X1),
            _nearest(f"the amplitude Xp2 at omega = {omega:.6g} rad/s", X2),
        ]
    )


def _nearest(quantity: str, value: Fraction) -> float:
    try:
        return float(value)
    except OverflowError:
        raise ValueError(f"{quantity} leaves {DOUBLES}") from None


def _comfortable(chain: TwoMassChain, F_0: float, omega: Array) -> bool:
    slow, fast = chain.exact_modes
    m1, m2, _, k2 = chain.exact_parameters
    with precise():
        factors = [
            slow.omega,
            fast.omega,
            exact(F_0) / m1,
            exact(F_0) * k2 / (m1 * m2),
            chain.exact_antiresonance,
        ]
    factors += [exact(w) for w in (np.max(omega, initial=0.0), np.min(omega[omega > 0.0], initial=1.0))]
    return all(1 / _COMFORT < abs(factor) < _COMFORT for factor in factors if factor)


def _response_curve(chain: TwoMassChain, F_0: float, omega: Array) -> Array:
    """Xp1, Xp2 (2, n) from the factors of D and of k2 - m2 omega^2, none of which cancels."""
    slow, fast = chain.exact_modes
    m1, m2, _, k2 = chain.exact_parameters
    if k2:
        (over, over_lo), first, second = from_roots(omega, (chain.exact_antiresonance, slow.omega, fast.omega))
        D = pair_product(first, second)
    else:
        over, over_lo = np.ones_like(omega), np.zeros_like(omega)
        (D,) = from_roots(omega, (fast.omega,))
    with precise():
        units = np.array([split(-exact(F_0) / m1), split(exact(F_0) * k2 / (m1 * m2))]).T[..., np.newaxis]
    at_root = D[0] == 0.0
    D[0][at_root] = 1.0
    above = np.array([over, np.ones_like(omega)]), np.array([over_lo, np.zeros_like(omega)])
    X: Array = pair_quotient(pair_product((units[0], units[1]), above), D)
    X[at_root & (X != 0.0)] = math.inf
    return X


def from_roots(omega: Array, roots: Sequence[Decimal]) -> Iterator[DoubleDouble]:
    """Return omega^2 - root^2 as hi + lo for each of the `roots`: 0 at the root alone.

    The square of the root is in three doubles.
    """
    with precise():
        squares = np.array([three_doubles(root * root) for root in roots]).T[..., np.newaxis]
    square, rest = two_product(omega, omega)
    leading, error = two_sum(square, -squares[0])
    low, low_error = two_sum(rest, -squares[1])
    return zip(*pair_sum((leading, error), (low, low_error - squares[2])), strict=True)


def determinant(chain: TwoMassChain, omega: float) -> float:
    """Return D = det A of the `chain` in N^2/m^2 at `omega` in rad/s, correctly rounded.

    ValueError if omega is not a finite number, 0 or more, or D leaves the range of doubles.
    """
    check_drive(0.0, omega)
    one, two, link, scale = _matrix(chain, omega)
    try:
        return (one * two - link**2) / scale**2
    except OverflowError:
        raise ValueError(f"the determinant D at omega = {omega:.6g} rad/s leaves {DOUBLES}") from None
