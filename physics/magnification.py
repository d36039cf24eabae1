"""The magnification of one driven oscillator over r = omega/omega_n, and its marks.

With zeta = c/(2 m omega_n), for a force, a shaken base and an unbalance,

    X/(F_0/k) = 1/(1 - r^2 + 2 i zeta r),   X/Y = (1 + 2 i zeta r)/(1 - r^2 + 2 i zeta r),
    X/(mu e/m) = r^2/(1 - r^2 + 2 i zeta r).

Source: J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), sections 2.9 to 2.12.
"""

import math

import numpy as np
from numpy.typing import ArrayLike

from physics.driven import Complexes, Drive, check_drive_kind
from physics.precision.exact import Array
from physics.valid import finite_array

_NEAR = np.geomspace(1e-4, 0.6, 24)


def magnification(r: ArrayLike, zeta: float, kind: Drive = "force") -> Complexes:
    """Return the complex amplitude over its scale: over F_0/k, over Y, or over mu e/m.

    Parameters
    ----------
    r : float or array_like (n,)
        Ratios of frequencies omega/omega_n.
    zeta : float
        The damping ratio c/(2 m omega_n), 0 or more.
    kind : {"force", "base", "unbalance"}
        The drive.

    Returns
    -------
    ndarray (n,) of complex
        X over its scale, within 4 u; inf where it is infinite.

    Raises
    ------
    ValueError
        If r has more than one dimension, or values that are not finite, or there is no drive of this kind.
    """
    check_drive_kind(kind)
    r = finite_array("r", r)
    below = (1 - r) * (1 + r) + 2j * zeta * r
    above = 1 + 2j * zeta * r if kind == "base" else r * r if kind == "unbalance" else np.ones_like(r)
    infinite = below == 0
    return np.where(infinite, math.inf, above / np.where(infinite, 1, below))


def highest(zeta: float, kind: Drive = "force") -> tuple[float, float] | None:
    """Return the peak of |X| over the frequency of the drive.

    Parameters
    ----------
    zeta : float
        The damping ratio c/(2 m omega_n), 0 or more.
    kind : {"force", "base", "unbalance"}
        The drive.

    Returns
    -------
    tuple of two floats, or None
        The r = omega/omega_n of the peak, and its height as in `magnification`; None if there is no peak.

    Raises
    ------
    ValueError
        If there is no drive of this kind.
    """
    check_drive_kind(kind)
    if not zeta:
        return 1.0, math.inf
    if kind == "base":
        w = math.sqrt(1 + 8 * zeta * zeta)
        return math.sqrt(2 / (1 + w)), (1 + w) ** 1.5 / (2 * zeta * math.sqrt(2 * (w + 3)))
    if 2 * zeta * zeta >= 1:
        return None
    r = math.sqrt(1 - 2 * zeta * zeta)
    return (r if kind == "force" else 1 / r), 1 / (2 * zeta * math.sqrt((1 - zeta) * (1 + zeta)))


def half_power(zeta: float) -> tuple[float, float]:
    """Return the points of half power: there the dashpot takes half of its maximum.

    Parameters
    ----------
    zeta : float
        The damping ratio c/(2 m omega_n), 0 or more.

    Returns
    -------
    tuple of two floats
        The r = omega/omega_n below and above 1. Their exact difference is 2 zeta.
    """
    above = math.sqrt(1 + zeta * zeta) + zeta
    return 1 / above, above


def past_half(zeta: float) -> float:
    """Return the r beyond which the response to a force and the power lost are both lower than half of theirs at 1.

    Parameters
    ----------
    zeta : float
        The damping ratio c/(2 m omega_n), 0 or more.

    Returns
    -------
    float
        The ratio r = omega/omega_n.
    """
    z = zeta * zeta
    return max(half_power(zeta)[1], math.sqrt(1 - 2 * z + 2 * zeta * math.sqrt(3 + z)))


def ratios(zeta: float, low: float, high: float, log: bool = False) -> Array:
    """Return values of r = omega/omega_n for a curve, closer together about 1, where a peak may be.

    Parameters
    ----------
    zeta : float
        The damping ratio c/(2 m omega_n), 0 or more.
    low, high : float
        The ends of the curve.
    log : bool
        True for even steps on a log axis.

    Returns
    -------
    ndarray (n,)
        The values of r in rising order.
    """
    sharp = [1 - zeta * _NEAR * 10, 1 + zeta * _NEAR * 10] if 0 < zeta < 0.1 else []
    even = np.geomspace(low, high, 91) if log else high * np.linspace(0.0, 1.0, 91)
    r: Array = np.unique(np.concatenate([even, 1 - _NEAR, 1 + _NEAR, *sharp, [1.0]]))
    return r[(r >= max(low, 0.0)) & (r <= high)]
