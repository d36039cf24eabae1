"""Time windows, and what to draw where a motion is too fast for the grid.

A curve drawn from fewer than about twelve samples a cycle is not the motion: its peaks are missed, and below
two samples it is another, slower oscillation (aliasing). Such components are not drawn as a curve, but as
the band that they fill: components A_k sin(omega_k t + phi_k) whose frequencies are close move as one, with
the slowly varying amplitude

    |sum_k A_k exp(i ((omega_k - omega_ref) t + phi_k))|,

and reach both ends of it within a cycle.

Source: C. E. Shannon, Proc. IRE 37 (1949) 10 (sampling).
"""

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from physics.precision.exact import Array, sin_cos
from physics.valid import DOUBLES

SAMPLES_PER_CYCLE = 12  # the least; a peak is then drawn at 97 % or more of its height
SLOW_PERIODS, BEAT_PERIODS, MOST_PERIODS = 4, 2, 100
NOTHING_OSCILLATES = 10.0  # s, the window of two free masses


class Sinusoid(NamedTuple):
    """amplitude sin(omega t + phase); SI and rad, omega >= 0.

    Attributes
    ----------
    amplitude : float
        The amplitude in SI units.
    omega : float
        The frequency in rad/s, 0 or more.
    phase : float
        The phase in rad at t = 0.
    """

    amplitude: float
    omega: float
    phase: float


class CurveOrBand(NamedTuple):
    """A motion on a grid as it can be drawn: a curve, or None and the band (lo, hi) that the motion fills.

    Attributes
    ----------
    curve : ndarray (n,) or None
        The values of the motion; None if it is too fast for the grid.
    lo, hi : ndarray (n,)
        The lower and the upper edge of the band; both are the curve if there is one.
    """

    curve: Array | None
    lo: Array
    hi: Array


def time_window(omega_slow: float, omega_fast: float) -> float:
    """Return four slow or two beat periods, the longer, but at most 100 slow ones.

    A zero frequency is a drift: then the fast one counts; without any frequency the window is 10 s.

    Parameters
    ----------
    omega_slow, omega_fast : float
        Frequencies in rad/s, 0 or more.

    Returns
    -------
    float
        The window in s.

    Raises
    ------
    ValueError
        If the window leaves the range of doubles.
    """
    slow = omega_slow or omega_fast
    if not slow:
        return NOTHING_OSCILLATES
    beat = omega_fast - omega_slow
    in_slow_periods = BEAT_PERIODS * slow / beat if beat * MOST_PERIODS > BEAT_PERIODS * slow else math.inf
    return periods(slow, min(max(SLOW_PERIODS, in_slow_periods), MOST_PERIODS))


def periods(omega: float, count: float) -> float:
    """Return the duration of a number of periods of one frequency.

    Parameters
    ----------
    omega : float
        The frequency in rad/s, above 0.
    count : float
        The number of periods, above 0.

    Returns
    -------
    float
        The duration in s.

    Raises
    ------
    ValueError
        If it leaves the range of doubles, as it does at omega = 0.
    """
    window = 2.0 * math.pi * count / float(omega) if omega else math.inf
    if not 0.0 < window < math.inf:
        raise ValueError(f"a time window of {count:g} periods at omega = {omega:.6g} rad/s leaves {DOUBLES}")
    return window


def drawable(omega: float, t: Array) -> bool:
    """Return True if a grid has at least SAMPLES_PER_CYCLE samples in a cycle of omega.

    Parameters
    ----------
    omega : float
        The frequency in rad/s; its sign does not matter.
    t : ndarray (n,)
        The grid: rising times in s.

    Returns
    -------
    bool
        True if a line on this grid shows the oscillation.
    """
    return abs(omega) <= highest_drawn(t)


def highest_drawn(t: Array) -> float:
    """Return the highest frequency that a grid shows as a line.

    Parameters
    ----------
    t : ndarray (n,)
        The grid: rising times in s.

    Returns
    -------
    float
        The frequency in rad/s at the largest step of the grid; inf without a step.
    """
    return highest_at(float((t[1:] - t[:-1]).max(initial=0.0)))


def highest_at(step: float) -> float:
    """Return the highest frequency that instants at equal steps show as a line.

    Parameters
    ----------
    step : float
        The step in s.

    Returns
    -------
    float
        The frequency in rad/s; inf for a step of 0.
    """
    return 2.0 * math.pi / SAMPLES_PER_CYCLE / step if step else math.inf


def curve_or_band(components: Iterable[Sinusoid], t: Array, base: Array | None = None) -> CurveOrBand:
    """Return the sum of components and a smooth base as a curve if t resolves all of them, else as a band.

    Parameters
    ----------
    components : iterable of Sinusoid
        The oscillations.
    t : ndarray (n,)
        The grid: rising times in s.
    base : ndarray (n,) or None
        The base at these times; None is 0.

    Returns
    -------
    CurveOrBand
        The curve or the band, in the unit of the amplitudes.
    """
    line, groups = _resolved(components, t, base)
    if not groups:
        return CurveOrBand(line, line, line)
    size = np.sum([_amplitude(group, t) for group in groups], axis=0)
    return CurveOrBand(None, line - size, line + size)


def root_mean_square(components: Sequence[Sinusoid], t: Array, base: Array | None = None) -> Array:
    """Return the size of a sum of components and a base: the root of its square, averaged over unresolved cycles.

    With velocities this gives the mean kinetic energy: products of different fast groups average out, and
    each has half the square of its amplitude. It is formed in units of the largest term, so that no square
    overflows.

    Parameters
    ----------
    components : sequence of Sinusoid
        The oscillations.
    t : ndarray (n,)
        The grid: rising times in s.
    base : ndarray (n,) or None
        The base at these times; None is 0.

    Returns
    -------
    ndarray (n,)
        The size, in the unit of the amplitudes.
    """
    line = np.zeros_like(t) if base is None else base
    unit = max([abs(c.amplitude) for c in components] + [float(np.max(np.abs(line), initial=0.0))])
    if not unit:
        return np.zeros_like(t)
    scaled = [c._replace(amplitude=c.amplitude / unit) for c in components]
    line, groups = _resolved(scaled, t, line / unit)
    for group in groups:
        line = np.hypot(line, _amplitude(group, t) / math.sqrt(2.0))
    return unit * np.abs(line)


def _resolved(components: Iterable[Sinusoid], t: Array, base: Array | None) -> tuple[Array, list[list[Sinusoid]]]:
    """The sum of all that t resolves, and the rest in groups whose differences of frequency it resolves."""
    line = np.zeros_like(t) if base is None else base.copy()
    groups: list[list[Sinusoid]] = []
    for component in sorted(components, key=lambda c: c.omega):
        if drawable(component.omega, t):
            line += component.amplitude * sin_cos(component.omega, 0.0, t, component.phase)[0]
        elif groups and drawable(component.omega - groups[-1][0].omega, t):
            groups[-1].append(component)
        else:
            groups.append([component])
    return line, groups


def _amplitude(group: Sequence[Sinusoid], t: Array) -> Array:
    """The modulus of the complex amplitude of a group."""
    imaginary, real = np.zeros_like(t), np.zeros_like(t)
    for amplitude, omega, phase in group:
        sine, cosine = sin_cos(omega - group[0].omega, 0.0, t, phase)
        imaginary += amplitude * sine
        real += amplitude * cosine
    return np.hypot(real, imaginary)
