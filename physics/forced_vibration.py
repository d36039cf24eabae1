"""Forced vibration of one oscillator from its initial conditions: its parts, its energy, the mean powers.

The equations are in physics.driven: x = x_p + x_c, the steady part and the free motion from what is left of the
initial conditions. At resonance with no damping there is no steady part; then x grows in proportion to t.

Source: J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), sections 2.9 to 2.12.
"""

import math
from cmath import phase
from copy import copy
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from physics.driven import Drive, DrivenOscillator, Push, drawn
from physics.free_decay import FreeDecay
from physics.motion import ONE, Elementary, ExactMotion, Harmonic, MotionPolynomial, harmonic_motion
from physics.precision.exact import Array
from physics.sampling import Sinusoid, drawable
from physics.transient import FILE
from physics.valid import in_range

_APART, _LONG = 4.0, 12  # parts that are at most so many times as large as their sum, or as a window from rest, show
_UNSEEN = 0.002  # of the largest |x|: less than half a pixel of the tallest plot
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(4)


class MeanPowers(NamedTuple):
    """The power of the drive and of the dashpot (n,) in W at the times t, each the mean of the last drive period.

    Before t = 0 the powers count as 0.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Times in s.
    P_in, P_lost : ndarray, shape (n,)
        What the drive puts in and what the dashpot takes, in W.
    """

    t: Array
    P_in: Array
    P_lost: Array


@dataclass(frozen=True, kw_only=True)
class ForcedVibration:
    """A motion of a driven oscillator from x(0) = x_0 (m), x'(0) = v_0 (m/s).

    Parameters
    ----------
    oscillator : DrivenOscillator
        The mass on its spring and its dashpot.
    kind : {"force", "base", "unbalance"}
        The kind of drive.
    size : float
        The amplitude of the drive, 0 or more: F_0 in N, Y in m, or mu e in kg m.
    omega : float
        The frequency of the drive in rad/s, 0 or more.
    x_0, v_0 : float
        The displacement in m and the velocity in m/s at t = 0.
    """

    oscillator: DrivenOscillator
    kind: Drive
    size: float
    omega: float
    x_0: float
    v_0: float

    @property
    def is_driven(self) -> bool:
        """True if the drive has a size and a frequency."""
        return bool(self.size and self.omega)

    @property
    def fastest(self) -> float:
        """The highest frequency in the motion in rad/s."""
        return max(self.oscillator.free.omega_d, self.omega if self.is_driven else 0.0)

    @cached_property
    def X(self) -> complex:
        """The steady part is x_p = Im(X exp(i omega t)) in m; infinite at an undamped resonance."""
        return self.oscillator.response(self.omega, self.size, self.kind)

    @cached_property
    def push(self) -> Push:
        """The motion from rest as numbers for a signal."""
        return self.oscillator.push(self.omega, self.size, self.kind)

    @cached_property
    def free(self) -> FreeDecay:
        """The free motion from the initial conditions."""
        return FreeDecay(oscillator=self.oscillator.free, x_0=self.x_0, v_0=self.v_0)

    @cached_property
    def transient(self) -> FreeDecay:
        """The free motion that is left without the steady part."""
        x_0, v_0 = self.x_0 - self.X.imag, self.v_0 - self.omega * self.X.real
        return FreeDecay(oscillator=self.oscillator.free, x_0=x_0, v_0=v_0)

    @cached_property
    def x(self) -> ExactMotion:
        """The displacement in m. It is played as the motion from rest and the free motion, which are always regular."""
        twin = copy(self)  # a copy that does not refer to this motion
        from_rest = Elementary(
            symbol="x_driven", exact=lambda t: twin.at(t)[0], played=self.push, size=twin._size, omega=self.fastest
        )
        return MotionPolynomial(((ONE, (from_rest,)), (ONE, (replace(self.free.x, symbol="x_free"),))), twin._exact)

    @cached_property
    def x_p(self) -> ExactMotion:
        """The steady part in m."""
        return rotating("x_p", self.X, self.omega)

    @cached_property
    def drive(self) -> ExactMotion:
        """size sin(omega t): the force in N, the displacement of the base in m, or what turns, seen from the side."""
        return rotating("drive", complex(self.size), self.omega)

    def at(self, t: Array) -> tuple[Array, Array]:
        """Return x and v (n,) in doubles, as they are drawn.

        Parameters
        ----------
        t : ndarray, shape (n,)
            Times in s, 0 or more.

        Returns
        -------
        tuple of ndarray, each (n,)
            x in m and v in m/s.

        Raises
        ------
        ValueError
            If a number is not possible, or t has more than one dimension.
        """
        x, v = drawn(self.push, t)
        fading = self.free.fadings
        return x + fading[0].at(t), v + fading[1].at(t)

    def from_rest(self, t: Array) -> Array:
        """Return x (n,) in m from rest in doubles.

        Parameters
        ----------
        t : ndarray, shape (n,)
            Times in s, 0 or more.

        Returns
        -------
        ndarray (n,)
            x in m.

        Raises
        ------
        ValueError
            If a number is not possible, or t has more than one dimension.
        """
        return drawn(self.push, t)[0]

    def powers(self, t: Array) -> tuple[Array, Array]:
        """Return the power that the drive puts in and the power that the dashpot takes (n,), in W.

        Parameters
        ----------
        t : ndarray, shape (n,)
            Times in s, 0 or more.

        Returns
        -------
        tuple of ndarray, each (n,)
            The power of the drive and the power of the dashpot in W.

        Raises
        ------
        ValueError
            If a number is not possible, or t has more than one dimension.
        """
        one, (x, v) = self.oscillator, self.at(t)
        if self.kind == "base":
            y = self.size * np.sin(self.omega * t)
            rate = self.size * self.omega * np.cos(self.omega * t)
            return -(one.k * (x - y) + one.c * (v - rate)) * rate, one.c * (v - rate) ** 2
        force = self.size if self.kind == "force" else self.size * self.omega * self.omega
        return force * np.sin(self.omega * t) * v, one.c * v * v

    def mean_powers(self, end: float, count: int) -> MeanPowers:
        """Return the mean powers at `count` + 1 times up to `end` in s.

        Parameters
        ----------
        end : float
            The last time in s, above 0. The first one is 0.
        count : int
            The number of steps between the times, 1 or more.

        Returns
        -------
        MeanPowers
            The times in s and the powers in W, each (count + 1,).

        Raises
        ------
        ValueError
            If a number is not possible, or the powers or the work leave the range of doubles.
        ZeroDivisionError
            If the frequency of the drive is 0.
        """
        period, step = 2 * math.pi / self.omega, end / count
        t = np.linspace(0.0, end, count + 1)
        earlier = np.maximum(np.arange(count + 1) - count * (period / end), 0.0)
        inner = (t[:-1, None] + step * (1 + _NODES) / 2).ravel()
        found = []
        with np.errstate(over="ignore", invalid="ignore"):
            for power in self.powers(np.concatenate([t, inner])):
                pieces = power[count + 1 :].reshape(count, -1) @ _WEIGHTS * step / 2
                done = np.concatenate([[0.0], np.cumsum(pieces)])
                before = _between(step, in_range("the work", done), in_range("the power", power[: count + 1]), earlier)
                found.append((done - before) / period)
        return MeanPowers(t, *found)

    def _exact(self, t: Array) -> Array:
        return self.oscillator.motion(self.omega, self.size, self.x_0, self.v_0, t, self.kind, FILE).x

    def _size(self) -> float:
        """About the largest displacement from rest in m."""
        steady = abs(self.X)
        force = math.hypot(self.push.re, self.push.im)
        return steady if math.isfinite(steady) else force / self.push.omega_n / self.push.omega_n


class VibrationBand(NamedTuple):
    """The lower and the upper edge of a band.

    Attributes
    ----------
    low, high : ndarray, shape (n,)
        The edges in m.
    late : ndarray, shape (m,), or None
        The values in m at the last m instants, if a line shows the motion there because what is too fast has died.
    """

    low: Array
    high: Array
    late: Array | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class SampledVibration:
    """A forced vibration over the instants t (n,) in s: which parts of it are too fast for a line there.

    With `is_split` it is shown in its parts, unless these are huge and opposite, as near an undamped resonance.

    Parameters
    ----------
    vibration : ForcedVibration
        The motion.
    t : ndarray, shape (n,)
        The instants in s.
    is_split : bool
        True to show the motion in its parts.
    """

    vibration: ForcedVibration
    t: Array
    is_split: bool

    @cached_property
    def largest(self) -> float:
        """The largest |x| at these instants, in m."""
        return float(np.abs(self.vibration.at(self.t)[0]).max())

    @cached_property
    def split(self) -> bool:
        """True if the motion is shown in its parts."""
        size = abs(self.vibration.X) if self.is_split and self.vibration.is_driven else math.inf
        return math.isfinite(size) and size <= _APART * max(self.largest, size / _LONG)

    @cached_property
    def reach(self) -> float:
        """The largest |x| in the window, in m; of parts that are too fast for a line, the bound."""
        if not (self.split and (self._steady_is_fast or self._transient_is_fast)):
            return self.largest
        return float((np.abs(self._slow_part) + self._fast_size).max())

    @property
    def tallest(self) -> float:
        """The largest displacement, of the mass or of its base, in m; 1 if nothing moves."""
        return max(self.reach, self.vibration.size if self.vibration.kind == "base" else 0.0) or 1.0

    @property
    def rings(self) -> bool:
        """True if x and the transient are too fast for a line at first alone."""
        return self.split and not self._trembles and 0 < self._settled < self.t.size

    @cached_property
    def bands(self) -> dict[str, VibrationBand]:
        """The bands of x, its parts x_p and x_c, and the base y, as far as something too fast for a line is seen.

        If a part has died so far that nothing is seen of it, the band is as narrow as the line that continues it.
        """
        nothing, vibration = np.zeros_like(self.t), self.vibration
        if not self.split:
            fast = not drawable(vibration.fastest, self.t)
            return dict.fromkeys(("x", "y"), _around(nothing, self.reach)) if fast else {}
        found = {}
        if self._trembles:
            found["x_p"] = _around(nothing, abs(vibration.X))
        if self._trembles or self._settled:
            found["x"] = _around(self._slow_part, self._fast_size)
        if self._settled:
            found["x_c"] = _around(nothing, self._ringing)
        if vibration.kind == "base" and self._steady_is_fast:
            found["y"] = _around(nothing, vibration.size)
        if self.rings:  # lines are drawn in doubles: more digits would take longer than a picture may
            t = self.t[self._settled :]
            found["x"] = found["x"]._replace(late=vibration.at(t)[0])
            found["x_c"] = found["x_c"]._replace(late=vibration.transient.fadings[0].at(t))
        return found

    @cached_property
    def _steady_is_fast(self) -> bool:
        return self.vibration.is_driven and not drawable(self.vibration.omega, self.t)

    @cached_property
    def _transient_is_fast(self) -> bool:
        return not drawable(self.vibration.oscillator.free.omega_d, self.t)

    @property
    def _trembles(self) -> bool:
        """True if the steady part is too fast for a line, and large enough to be seen."""
        return self._steady_is_fast and abs(self.vibration.X) > _UNSEEN * self.tallest

    @cached_property
    def _ringing(self) -> Array:
        """The amplitude in m that is left of the transient."""
        one = self.vibration.transient.fadings[0]
        size = math.hypot(one.start, one.rate / one.swing) if one.swing else abs(one.start) + sum(map(abs, one.late))
        return np.asarray(size * np.exp(-one.slow * self.t))

    @cached_property
    def _fast_size(self) -> Array:
        """The amplitude in m of what of x is too fast for a line; two parts that beat slowly move as one."""
        X, omega, one = self.vibration.X, self.vibration.omega, self.vibration.transient.fadings[0]
        if not (self._steady_is_fast and self._transient_is_fast and drawable(one.swing - omega, self.t)):
            return self._steady_is_fast * abs(X) + self._transient_is_fast * self._ringing
        beat = complex(-one.slow, one.swing - omega) * self.t
        return np.asarray(np.abs(X + complex(one.rate / one.swing, one.start) * np.exp(beat)))

    @cached_property
    def _slow_part(self) -> Array:
        """The sum in m of the parts of x that are slow enough for a line."""
        steady = np.zeros_like(self.t) if self._steady_is_fast else self.vibration.x_p.at(self.t)
        return steady if self._transient_is_fast else steady + self.vibration.transient.fadings[0].at(self.t)

    @cached_property
    def _settled(self) -> int:
        """The index of the first instant from which nothing is seen of a transient that is too fast for a line."""
        return int(np.count_nonzero(self._ringing > _UNSEEN * self.tallest)) if self._transient_is_fast else 0


def _around(middle: Array, size: Array | float) -> VibrationBand:
    return VibrationBand(middle - size, middle + size)


def rotating(symbol: str, X: complex, omega: float) -> ExactMotion:
    """Return the motion Im(X exp(i omega t)).

    Parameters
    ----------
    symbol : str
        The symbol of the motion.
    X : complex
        The complex amplitude, in the unit of the motion.
    omega : float
        The frequency in rad/s.

    Returns
    -------
    ExactMotion
        The motion, which the browser plays as one sinusoid.
    """
    played = Harmonic((Sinusoid(abs(X), omega, phase(X)),))
    return harmonic_motion(symbol, played, lambda t: np.asarray((X * np.exp(1j * omega * t)).imag))


def _between(step: float, heights: Array, slopes: Array, places: Array) -> Array:
    """Return the cubics through heights with slopes, at intervals `step` in time, at positions in steps from the first.

    Places are not divided by `step`, which is 0 in the shortest windows.
    """
    i = np.minimum(places.astype(int), len(heights) - 2)
    s, rise = places - i, heights[i + 1] - heights[i]
    first, last = slopes[i] * step, slopes[i + 1] * step
    found: Array = heights[i] + s * (first + s * (3 * rise - 2 * first - last + s * (first + last - 2 * rise)))
    return found
