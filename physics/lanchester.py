"""The phugoid of any size, without units (F. W. Lanchester, Aerodonetics, 1908; lecture D31, slide 10).

Speeds in v_0, times in v_0/g, lengths in v_0^2/g; V the speed, theta the angle of the path, u = V cos(theta)
forward, w = V sin(theta) up, x along the ground, h above the level flight of equal energy:

    du/dt = -V w,   dw/dt = V u - 1,   dx/dt = u,   h = (1 - V^2)/2,   C = u - V^3/3 = const.

C = 2/3 is level flight, C = 0 the cusp (speed excess sqrt(3) - 1), below 0 are loops. The motion is symmetric
about its lowest and its highest point, so half a period is solved, by Taylor series, and mirrored. p = u - 1
and q = V - 1 stand in for u and V, so that a small disturbance keeps its digits.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import hypot, pi, sqrt
from operator import mul
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from physics.precision.exact import Array
from physics.valid import is_number, shown

CUSP_EXCESS = sqrt(3) - 1
LINEAR_PERIOD = sqrt(2) * pi  # in v_0/g
LARGEST_EXCESS = 1e6
EXCESS_AT_LATENESS = {0.001: 0.15114630935641565, 0.01: 0.4585246908361407}  # T/T_0 - 1: excess in v_0

ORDER = 26
LAST_TERM = 2e-17  # of a Taylor series, relative to the disturbance: less than its rounding
FREE_FALL = 1e-9  # at this speed the lift is 1e-18 of the weight
LINEAR = 1e-20  # below this excess the motion is linear to the last bit: one solution, scaled

_Series: TypeAlias = tuple[list[float], list[float], list[float]]  # ORDER + 1 coefficients of x - t, p and w


@dataclass(frozen=True, kw_only=True)
class LanchesterPeriod:
    """One period from the lowest point, ends included, in units of v_0, v_0/g and v_0^2/g.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Times in v_0/g.
    x, h : ndarray, shape (n,)
        Distance along the ground, and height above the level flight of equal energy, in v_0^2/g.
    u, w : ndarray, shape (n,)
        Speeds forward and up in v_0.
    period : float
        The period in v_0/g.
    advance : float
        The distance along the ground in a period, in v_0^2/g.
    C : float
        The constant u - V^3/3 of the motion.
    loops : bool
        True if the path loops.
    """

    t: Array
    x: Array
    h: Array
    u: Array
    w: Array
    period: float
    advance: float
    C: float
    loops: bool


def lanchester(excess: float, n: int = 401) -> LanchesterPeriod:
    """Return one period, at n equal steps of time, ends included.

    Parameters
    ----------
    excess : float
        The speed in level flight is 1 + excess, in v_0; from -1, standstill, to 1e6.
    n : int
        The number of times.

    Returns
    -------
    LanchesterPeriod
        The motion from its lowest point on.

    Raises
    ------
    ValueError
        If the excess is not possible.
    """
    half = half_period(bottom_excess(excess))
    t = np.linspace(0, 2 * half.duration, n)
    x, p, w = half.at(t)
    return LanchesterPeriod(
        t=t, x=x, h=height(p, w), u=1 + p, w=w,
        period=2 * half.duration, advance=2 * half.advance, C=invariant(excess), loops=half.loops,
    )  # fmt: skip


def invariant(excess: float) -> float:
    """Return C = V - V^3/3 at V = 1 + excess: 2/3 in level flight, 0 at the cusp, negative for loops.

    Parameters
    ----------
    excess : float
        The speed excess in v_0, from -1, standstill, to 1e6.

    Returns
    -------
    float
        C, without unit.

    Raises
    ------
    ValueError
        If the excess is not possible.
    """
    excess = check_excess(excess)
    return 2 / 3 - excess * excess * (1 + excess / 3)


def period_excess(excess: float) -> float:
    """Return T/T_0 - 1 of the motion of this speed excess, to 1e-15; T_0 is the linear period.

    Parameters
    ----------
    excess : float
        The speed excess in v_0, from -1, standstill, to 1e6.

    Returns
    -------
    float
        T/T_0 - 1.

    Raises
    ------
    ValueError
        If the excess is not possible.
    """
    return 2 * half_period(bottom_excess(excess)).duration / LINEAR_PERIOD - 1


def excess_at_period_excess(wanted: float) -> float:
    """Return the speed excess v'/v_0, smaller than at the cusp, at which T/T_0 - 1 has the wanted value.

    Parameters
    ----------
    wanted : float
        T/T_0 - 1, from 0 to its value at the cusp.

    Returns
    -------
    float
        The speed excess in v_0, from 0 to sqrt(3) - 1.

    Raises
    ------
    ValueError
        If no such motion has this value.
    """
    from scipy.optimize import brentq

    largest = period_excess(CUSP_EXCESS)
    if not 0 <= wanted <= largest:
        raise ValueError(f"T/T_0 - 1 = {wanted!r} is not possible: choose from 0 at rest to {largest:.4g} at the cusp")
    return float(brentq(lambda excess: period_excess(excess) - wanted, 0.0, CUSP_EXCESS, xtol=1e-15))


@dataclass(frozen=True)
class HalfPeriod:
    """The flight from the lowest point to the highest, as Taylor series in pieces of time.

    Attributes
    ----------
    starts : ndarray, shape (pieces,)
        The time at which each piece starts, in v_0/g.
    coefficients : ndarray, shape (ORDER + 1, 3, pieces)
        Taylor coefficients of x - t, p and w.
    duration : float
        Half the period in v_0/g.
    advance : float
        The distance along the ground in that time, in v_0^2/g.
    loops : bool
        True if the path loops.
    """

    starts: Array
    coefficients: Array
    duration: float
    advance: float
    loops: bool

    def at(self, t: Array) -> tuple[Array, Array, Array]:
        """Return x, p, w at any times: the falling half is the mirror image of the rising one.

        Parameters
        ----------
        t : ndarray, shape (n,)
            Times from the lowest point in v_0/g.

        Returns
        -------
        tuple of three ndarrays, each (n,)
            x in v_0^2/g, and p = u - 1 and w in v_0.
        """
        period = 2 * self.duration
        whole = np.floor(t / period)
        rest = t - whole * period
        falls = rest > self.duration
        x, p, w = self._rising(np.clip(np.where(falls, period - rest, rest), 0, self.duration))
        return 2 * self.advance * whole + np.where(falls, 2 * self.advance - x, x), p, np.where(falls, -w, w)

    def _rising(self, t: Array) -> tuple[Array, Array, Array]:
        piece = np.searchsorted(self.starts, t, side="right") - 1
        series = self.coefficients.take(piece, axis=2)
        drift, p, w = _polynomial(reversed(series), t - self.starts[piece])
        return t + drift, p, w


@lru_cache(maxsize=256)
def half_period(excess: float) -> HalfPeriod:
    """Return the flight of this speed excess from its lowest point to its highest.

    Parameters
    ----------
    excess : float
        The speed excess at the lowest point in v_0, 0 or more.

    Returns
    -------
    HalfPeriod
        The flight, as Taylor series.
    """
    pieces = list(_pieces(max(excess, LINEAR)))
    scale = min(excess / LINEAR, 1.0)
    last = pieces[-1]
    duration = last.start + last.length
    return HalfPeriod(
        starts=np.array([piece.start for piece in pieces]),
        coefficients=np.ascontiguousarray(scale * np.array([piece.series for piece in pieces]).T),
        duration=duration,
        advance=duration + scale * _polynomial(reversed(last.series[0]), last.length),
        loops=excess > CUSP_EXCESS,
    )


class _Piece(NamedTuple):
    """A stretch of time from its start on, and the Taylor series of x - t, p and w in it."""

    start: float
    series: _Series
    length: float


def _pieces(excess: float) -> Iterator[_Piece]:
    """The pieces of the flight from the lowest point until w is zero again."""
    t, state = 0.0, (0.0, excess, 0.0)
    while True:
        _, p, w = state
        if hypot(1 + p, w) < FREE_FALL:
            yield _Piece(t, _free_fall(*state), w)
            return
        series = _taylor(*state)
        step = _step(series, LAST_TERM * max(abs(p), abs(w)))
        drift, p, w = (_polynomial(reversed(one), step) for one in series)
        if w <= 0:
            yield _Piece(t, series, _top(series[2], step))
            return
        yield _Piece(t, series, step)
        t, state = t + step, (drift, p, w)


def _taylor(*state: float) -> _Series:
    """Each order of the equations of motion gives the next one; V^2/2 = 1/2 - h, with dh/dt = w, gives the speed.

    In plain numbers: there are too few for arrays. sum(map(mul, a, reversed(b))), written out as it is called eighty
    times a piece, is the newest coefficient of the product of two series.
    """
    drift, p, w = ([value] for value in state)
    speed = hypot(1 + p[0], w[0])
    q = [(p[0] * (2 + p[0]) + w[0] * w[0]) / (1 + speed)]
    later: list[float] = []  # q but for its first
    for n in range(ORDER):
        if n > 0:
            later.append(-(w[n - 1] / n + sum(map(mul, later, reversed(later))) / 2) / speed)
            q.append(later[-1])
        drift.append(p[n] / (n + 1))
        forward = -(w[n] + sum(map(mul, q, reversed(w)))) / (n + 1)
        up = (p[n] + q[n] + sum(map(mul, p, reversed(q)))) / (n + 1)
        p.append(forward)
        w.append(up)
    return drift, p, w


def _step(series: _Series, least: float) -> float:
    """The step over which the last two terms of p and of w stay below `least`."""
    _, p, w = series
    return float(min((least / max(abs(p[n]), abs(w[n]))) ** (1 / n) for n in (ORDER - 1, ORDER)))


def _free_fall(drift: float, p: float, w: float) -> _Series:
    rest = [0.0] * (ORDER - 1)
    return [drift, p, *rest], [p, 0.0, *rest], [w, -1.0, *rest]


def _polynomial(falling: Iterable[Any], t: Any) -> Any:
    """The value of a series by Horner's rule, its coefficients from the highest order down; numbers or arrays."""
    value = 0.0
    for coefficient in falling:
        value = value * t + coefficient
    return value


def _top(w: Sequence[float], step: float) -> float:
    """The zero of the falling w: Newton's method from the zero of the chord over the step."""
    rate = [order * coefficient for order, coefficient in enumerate(w)][1:]
    root = step * w[0] / (w[0] - _polynomial(reversed(w), step))
    for _ in range(6):
        root -= _polynomial(reversed(w), root) / _polynomial(reversed(rate), root)
    return float(root)


def height(p: Array, w: Array) -> Array:
    """Return h = (1 - V^2)/2 without cancellation.

    Parameters
    ----------
    p, w : ndarray, shape (n,)
        u - 1, the speed forward less that of level flight, and the speed up, in v_0.

    Returns
    -------
    ndarray, shape (n,)
        The height in v_0^2/g.
    """
    return -(p * (2 + p) + w * w) / 2


def bottom_excess(excess: float) -> float:
    """Return the speed excess at the lowest point; a start with less speed than v_0 is the highest point.

    Parameters
    ----------
    excess : float
        The speed excess in v_0, from -1, standstill, to 1e6.

    Returns
    -------
    float
        The speed excess at the lowest point in v_0, 0 or more.

    Raises
    ------
    ValueError
        If the excess is not possible.
    """
    excess = check_excess(excess)
    if excess >= 0:
        return excess
    root = sqrt(9 - 6 * excess - 3 * excess * excess)
    rounded = -2 * excess * (3 + excess) / (root + 3 + excess)
    return min(rounded, CUSP_EXCESS)  # a start above the level line never loops


def check_excess(excess: float) -> float:
    """Return a speed excess as a float.

    Parameters
    ----------
    excess : float
        The speed excess in v_0, from -1, standstill, to 1e6.

    Returns
    -------
    float
        The same number.

    Raises
    ------
    ValueError
        If it is not possible.
    """
    if not (is_number(excess) and -1 <= excess <= LARGEST_EXCESS):
        raise ValueError(
            f"a speed excess of {shown(excess)} v_0 is not possible: choose from -1 (standstill) to {LARGEST_EXCESS:g}"
        )
    return float(excess)
