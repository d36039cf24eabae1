"""The phugoid: an aircraft left alone trades height for speed and back (lecture D31, slides 8 to 10).

             ___                   V      speed along the path, v_0 in level flight
         .-''   ``-.               theta  angle of the path, up is positive
    ____/  V, theta \\____ ...      h      height above the level flight of equal energy
            | m g                  x      distance along the ground

Lift is m g (V/v_0)^2, square to the path; thrust cancels drag. Small perturbations obey
d2h'/dt2 + omega^2 h' = 0 with omega = sqrt(2) g/v_0, and v' = -(g/v_0) h'. The exchange of m g h for m V^2/2
is of first order and runs at omega; T and V of the spring that it mimics are quadratic and run at 2 omega.
Disturbances of any size are in physics.lanchester; here they get their units.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from decimal import Decimal
from functools import lru_cache
from itertools import accumulate, pairwise, starmap
from math import sqrt

import numpy as np
from numpy.typing import ArrayLike

from physics.lanchester import (
    CUSP_EXCESS,
    EXCESS_AT_LATENESS,
    FREE_FALL,
    LINEAR_PERIOD,
    LanchesterPeriod,
    bottom_excess,
    check_excess,
    excess_at_period_excess,
    half_period,
    height,
    invariant,
    lanchester,
    period_excess,
)
from physics.precision.exact import PI, Array, exact, precise, rounded
from physics.valid import check_positive, finite_array, in_range, rows_in_range

__all__ = [
    "CUSP_EXCESS",
    "EXCESS_AT_LATENESS",
    "LINEAR_PERIOD",
    "Flight",
    "LanchesterPeriod",
    "LinearPhugoid",
    "excess_at_period_excess",
    "flight",
    "invariant",
    "lanchester",
    "linear_flight",
    "linear_phugoid",
    "period_excess",
]


@dataclass(frozen=True, kw_only=True)
class LinearPhugoid:
    """The small motion of an aircraft: v_0 alone says which aircraft it is.

    Attributes
    ----------
    omega : float
        Angular frequency in rad/s.
    tau : float
        Period in s.
    """

    omega: float
    tau: float


@dataclass(frozen=True, kw_only=True)
class Flight:
    """A flight in SI units.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Times in s.
    x, h : ndarray, shape (n,)
        Distance along the ground in m, and height in m above level flight of equal energy.
    u, w, V : ndarray, shape (n,)
        Speeds forward, up and along the path in m/s.
    """

    t: Array
    x: Array
    h: Array
    u: Array
    w: Array
    V: Array

    def gain(self, v_0: float, g: float) -> Array:
        """Return V - v_0, from the height, so that a small one keeps its digits.

        It uses the energy of the exact flight: V^2 = v_0^2 - 2 g h.

        Parameters
        ----------
        v_0 : float
            The speed of level flight in m/s.
        g : float
            Gravity in m/s^2.

        Returns
        -------
        ndarray, shape (n,)
            V - v_0 in m/s.
        """
        return -2 * g * self.h / (v_0 + self.V)

    def rates(self, v_0: float, g: float) -> tuple[Array, Array, Array]:
        """Return du/dt, dw/dt and dV/dt.

        At standstill, up to 1e-9 v_0, dV/dt is taken as 0, between its two limits -g and g.

        Parameters
        ----------
        v_0 : float
            The speed of level flight in m/s.
        g : float
            Gravity in m/s^2.

        Returns
        -------
        tuple of three ndarrays, each (n,)
            Accelerations forward, up and along the path in m/s^2.
        """
        lift, moves = g * (self.V / v_0), FREE_FALL * v_0 < self.V
        sine = np.divide(self.w, self.V, out=np.zeros_like(self.V), where=moves)
        return -lift * (self.w / v_0), lift * (self.u / v_0) - g, -g * sine

    def split(self, sizes: Iterable[int]) -> "list[Flight]":
        """Return the several flights that were computed together at their joined times.

        Parameters
        ----------
        sizes : iterable of int
            How many of the times each flight has, in their order.

        Returns
        -------
        list of Flight
            The flights; each has its own arrays.
        """
        parts = starmap(slice, pairwise(accumulate(sizes, initial=0)))
        return [Flight(**{name: column[part].copy() for name, column in vars(self).items()}) for part in parts]


def linear_phugoid(v_0: float, g: float) -> LinearPhugoid:
    """Return omega = sqrt(2) g/v_0 and tau = sqrt(2) pi v_0/g, each rounded once.

    Parameters
    ----------
    v_0 : float
        The speed of level flight in m/s, above 0.
    g : float
        Gravity in m/s^2, above 0.

    Returns
    -------
    LinearPhugoid
        Frequency and period.

    Raises
    ------
    ValueError
        If a number is not possible, or a result leaves the range of doubles.
    """
    check_positive("a speed in m/s", v_0=v_0)
    check_positive("gravity in m/s^2", g=g)
    return _linear(float(v_0), float(g))


@lru_cache(maxsize=64)
def _linear(v_0: float, g: float) -> LinearPhugoid:
    with precise():
        omega = Decimal(2).sqrt() * exact(g) / exact(v_0)
        return LinearPhugoid(
            omega=rounded("the natural frequency omega", omega), tau=rounded("the period", 2 * PI / omega)
        )


def linear_flight(v_0: float, g: float, excess: float, t: ArrayLike) -> Flight:
    """Return the flight that is level at t = 0, to first order in the excess of speed.

    Parameters
    ----------
    v_0 : float
        The speed of level flight in m/s, above 0.
    g : float
        Gravity in m/s^2, above 0.
    excess : float
        The speed at t = 0 is v_0 (1 + excess); from -1, standstill, to 1e6.
    t : array_like, shape (n,)
        Times in s.

    Returns
    -------
    Flight
        Distances, heights and speeds, each (n,).

    Raises
    ------
    ValueError
        If a number is not possible, or a result leaves the range of doubles.
    """
    omega = linear_phugoid(v_0, g).omega
    v_0, g, excess = float(v_0), float(g), check_excess(excess)
    t = finite_array("t", t)
    phase = _phase(omega, t)
    speed, climb = excess * np.cos(phase), sqrt(2) * excess * np.sin(phase)
    return _in_si(v_0, g, t, (phase / sqrt(2) + climb / 2, -speed, 1 + speed, climb, 1 + speed))


def flight(v_0: float, g: float, excess: float, t: ArrayLike) -> Flight:
    """Return the exact flight that is level at t = 0, at any times.

    Within 32 u of v_0 and v_0^2/g in the first period (u = 2^-53), and 32 u more in each later one: the phase is
    rounded within 2 u.

    Parameters
    ----------
    v_0 : float
        The speed of level flight in m/s, above 0.
    g : float
        Gravity in m/s^2, above 0.
    excess : float
        The speed at t = 0 is v_0 (1 + excess); from -1, standstill, to 1e6.
    t : array_like, shape (n,)
        Times in s.

    Returns
    -------
    Flight
        Distances, heights and speeds, each (n,).

    Raises
    ------
    ValueError
        If a number is not possible, or a result leaves the range of doubles.
    """
    omega = linear_phugoid(v_0, g).omega
    v_0, g = float(v_0), float(g)
    half = half_period(bottom_excess(excess))
    t = finite_array("t", t)
    start = half.duration if excess < 0 else 0.0
    x, p, w = half.at(_phase(omega, t) / sqrt(2) + start)
    x_start = half.advance if excess < 0 else 0.0
    return _in_si(v_0, g, t, (x - x_start, height(p, w), 1 + p, w, np.hypot(1 + p, w)))


def _phase(omega: float, t: Array) -> Array:
    with np.errstate(over="ignore"):
        return in_range("the phase", omega * t)


def _in_si(v_0: float, g: float, t: Array, rows: Sequence[Array]) -> Flight:
    """A flight in SI units from x and h in v_0^2/g and u, w and V in v_0."""
    with precise():
        length = rounded("the length v_0^2/g", exact(v_0) ** 2 / exact(g))
    names = ("x", "h", "u", "w", "V")
    with np.errstate(over="ignore"):
        results = np.array([[length], [length], [v_0], [v_0], [v_0]]) * np.array(rows)
    return Flight(t=t, **dict(zip(names, rows_in_range(names, results), strict=True)))
