"""Response and lags of a chain with dashpots over many drive frequencies, in doubles.

wall --k1, c1-- [m1] --k2, c2-- [m2],   F_0 sin(omega t) on mass 1,   x_i = Im(X_i exp(i omega t))

With d(r) = omega^2 - r^2, which next to r is computed from the digits of r beyond a double, no sum cancels:

    X1 = F_0/m1 N/D,   X2 = F_0/m1 (omega_2^2 + i omega c2/m2)/D,   N = -d(omega_2) + i omega c2/m2,

    D = d(omega_-) d(omega_+) - c1 c2 omega^2/(m1 m2)
        - i omega (c2 (m1 + m2)/(m1 m2) d(omega_12) + c1/m1 d(omega_2)),

omega_-, omega_+ the natural frequencies without damping, omega_2 = sqrt(k2/m2), and omega_12 = sqrt(k1/(m1 + m2)) the
frequency of both masses as one. The lag of mass 1 is the angle of I and R; mass 2 lags behind mass 1 by the angle of a
motion over a moving base. Neither passes the cut of the angle, so nothing has to be unwrapped:

    I = c1/m1 omega |N|^2 + c2/m1 omega^5,
    R = -d(omega_-) d(omega_+) d(omega_2) - c2^2 (m1 + m2)/(m1 m2^2) omega^2 d(omega_12).

Source: beyond lecture D34, slide 8; J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), section 3.3.
"""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from physics.damped_chain import Complexes, DampedChain
from physics.particular import from_roots
from physics.precision.exact import Array, binary, exact, precise
from physics.valid import finite_array

_COMFORT = 2.0**60  # if omega, the dampings and F_0/m1 are between 1/this and this, no product leaves the doubles


_EVEN = np.concatenate([np.linspace(0.002, 1.6, 160), np.geomspace(1.6, 100.0, 40)])
_WIDTHS = np.array(
    [0.0, *np.geomspace(0.02, 60.0, 64)]
)  # distances from a root in its widths, so dense that a loop is round


class BodeCurves(NamedTuple):
    """Response and lags at n drive frequencies.

    Attributes
    ----------
    X : ndarray (2, n) of complex
        The complex amplitudes X1 and X2 in m.
    lags : ndarray (2, n)
        The lags of both masses behind the force in rad.
    """

    X: Complexes
    lags: Array


def bode_curves(chain: DampedChain, omega: ArrayLike, F_0: float = 1.0) -> BodeCurves:
    """Return the response and the lags at n drive frequencies: those of DampedChain.response and DampedChain.lags.

    Parameters
    ----------
    chain : DampedChain
        Masses, springs and dashpots.
    omega : float or array_like (n,)
        Drive frequencies in rad/s, above 0. ValueError if one is negative or not finite.
    F_0 : float
        The amplitude of the force on mass 1 in N.

    Returns
    -------
    BodeCurves
        Amplitudes within 8 u, lags within 8 u of a radian. X is inf where no steady amplitude exists, and at all
        frequencies if an amplitude leaves the range of doubles.
    """
    frequencies = np.atleast_1d(finite_array("omega", omega))
    scaled = _ScaledChain.of(chain, F_0, frequencies)
    if not scaled.comfortable:
        try:
            return BodeCurves(chain.response(frequencies, F_0), chain.lags(frequencies))
        except ValueError:
            return BodeCurves(np.full((2, frequencies.size), np.inf, np.complex128), chain.lags(frequencies))
    w, square = scaled.omega, scaled.omega**2
    slow, fast, two, both = (difference for difference, _ in from_roots(w, scaled.roots))
    one, link, ratio = scaled.first, scaled.second, scaled.ratio
    tied = float(scaled.roots[2]) ** 2
    N = -two + 1j * w * link
    D = slow * fast - one * link * square - 1j * w * (link * ratio * both + one * two)
    pole = D == 0.0
    with np.errstate(invalid="ignore"):
        X: Complexes = scaled.size * np.array([N, tied + 1j * w * link], np.complex128) / np.where(pole, 1.0, D)
    X[:, pole] = np.where(X[:, pole] == 0.0, 0.0, np.inf)
    fed = one * w * np.abs(N) ** 2 + link * (ratio - 1.0) * w**5
    first = np.arctan2(fed, 0.0 - slow * fast * two - link**2 * ratio * square * both)
    first[N == 0.0] = np.pi  # no motion has no lag: the limit from lower frequencies
    behind = np.arctan2(link * w**3, (link * w) ** 2 - tied * two)
    return BodeCurves(X, np.array([first, first + behind]))


class Transfer(NamedTuple):
    """X1 and X2 as functions of s = i omega/unit: polynomials over the product of all s - p of the poles.

    Attributes
    ----------
    unit : float
        The unit of s in rad/s.
    above : tuple of two tuples of three floats
        The coefficients of X1 and of X2 in m, constants first.
    poles : tuple of complex
        The poles p, without unit.
    """

    unit: float
    above: tuple[tuple[float, float, float], tuple[float, float, float]]
    poles: tuple[complex, ...]


def transfer(chain: DampedChain, F_0: float = 1.0) -> Transfer | None:
    """Return the response as a function of i omega in doubles, for a hand on its curve.

    Parameters
    ----------
    chain : DampedChain
        Masses, springs and dashpots.
    F_0 : float
        The amplitude of the force on mass 1 in N.

    Returns
    -------
    Transfer or None
        None if its numbers may leave the range of doubles.
    """
    scaled = _ScaledChain.of(chain, F_0, np.ones(0))
    if not scaled.comfortable:
        return None
    size, unit = scaled.size, 2.0**scaled.exponent
    tied = size * float(scaled.roots[2]) ** 2, size * scaled.second
    return Transfer(unit, ((*tied, size), (*tied, 0.0)), tuple((chain.roots / unit).tolist()))


def locus_frequencies(roots: Iterable[complex], fast: float) -> Array:
    """Return drive frequencies at which X1 and X2 are smooth curves in the complex plane.

    They are closer together about the imaginary part of each root, in its widths, and reach 100 times `fast`.

    Parameters
    ----------
    roots : iterable of complex
        The exponents of the free motion in 1/s; only those that swing count.
    fast : float
        The frequency in rad/s that sets the range.

    Returns
    -------
    ndarray (n,)
        Drive frequencies in rad/s, rising, above 0.
    """
    swinging = [root for root in roots if root.imag]
    loops = [abs(root.imag) + side * -root.real * _WIDTHS for root in swinging for side in (-1, 1)]
    omega: Array = np.unique(np.concatenate([fast * _EVEN, *loops]))
    return omega[omega > 0]


class _ScaledChain(NamedTuple):
    """In a unit of time near the fast mode's: F_0/m1, c1/m1, c2/m2, omega and the roots of the d(r).

    `ratio` is (m1 + m2)/m1; the unit is 2^-exponent s.
    """

    exponent: int
    size: float
    first: float
    second: float
    ratio: float
    omega: Array
    roots: list[Decimal]

    @classmethod
    def of(cls, damped: DampedChain, F_0: float, omega: Array) -> _ScaledChain:
        chain = damped.chain
        slow, fast = chain.exact_modes
        m1, m2, k1, _ = chain.exact_parameters
        exponent = binary(fast.omega)[2] if fast.omega else 0
        with precise():
            unit = Decimal(2) ** exponent
            roots = slow.omega, fast.omega, chain.exact_antiresonance, (k1 / (m1 + m2)).sqrt()
            return cls(
                exponent,
                float(exact(F_0) / m1 / unit**2),
                float(exact(damped.c1) / m1 / unit),
                float(exact(damped.c2) / m2 / unit),
                float((m1 + m2) / m1),
                np.ldexp(omega, -exponent),
                [root / unit for root in roots],
            )

    @property
    def comfortable(self) -> bool:
        ends = float(self.omega.min(initial=1.0)), float(self.omega.max(initial=1.0))
        factors = abs(self.size), self.first, self.second, self.ratio, self.ratio - 1.0, *ends
        return all(1 / _COMFORT < factor < _COMFORT for factor in factors if factor) and bool(self.omega.all())
