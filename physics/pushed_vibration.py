"""One oscillator under a push, from its initial conditions: its parts, and the harmonics of a push that repeats.

A push F = f_0 + sum of f_n cos(n omega t + ..) moves the mass like so many sines at once: harmonic n by |X_n| =
|f_n| M(n r)/k, with M of physics.magnification and r = omega/omega_n.

Source: J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), sections 1.4 and 2.1.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from physics.damped import DampedOscillator
from physics.forced_vibration import MeanPowers, VibrationBand
from physics.free_decay import FreeDecay
from physics.magnification import highest
from physics.motion import ONE, Elementary, ExactMotion, MotionPolynomial, SampledCycle
from physics.periodic import PeriodicPush
from physics.precision.exact import Array
from physics.push_powers import mean_powers
from physics.pushed import PushedMass
from physics.sampling import drawable
from physics.steady_motions import RestAfterPush, SteadyMotion

_APART, _LONG = 4.0, 12  # as in physics.forced_vibration
_DRAWN, _NEAR = 100, 3  # lines that are drawn; lines next to the peak
WIDE = 0.35
"""Damping ratio above which a peak is too wide to be met by one harmonic."""
_NONE = 1e-12  # of the first line: a smaller one is a rounding error
_RESONANT = 1e-3  # of k, what spring and inertia leave to the dashpot: below it doubles lose digits
_ON_PEAK = 0.02  # distance of n r from the peak at which a harmonic without damping counts as on it


class Harmonics(NamedTuple):
    """Lines n (count,) of a push: |f_n| in N, and the amplitudes |X_n| in m of the motion, infinite at a resonance.

    Attributes
    ----------
    n : ndarray, shape (count,)
        The numbers of the lines.
    f : ndarray, shape (count,)
        |f_n| in N.
    X : ndarray, shape (count,)
        |X_n| in m.
    """

    n: Array
    f: Array
    X: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class PushedVibration:
    """A motion of a damped oscillator with a spring from x_0 in m and v_0 in m/s, in a window with the instants t (n,).

    It has the names of ForcedVibration and of SampledVibration.

    Parameters
    ----------
    oscillator : DampedOscillator
        The mass on its spring and its dashpot; k is above 0.
    push : PeriodicPush
        The push on the mass.
    x_0, v_0 : float
        The displacement in m and the velocity in m/s at t = 0.
    t : ndarray, shape (n,)
        The instants of the window in s.
    """

    oscillator: DampedOscillator
    push: PeriodicPush
    x_0: float
    v_0: float
    t: Array

    @cached_property
    def steady(self) -> SteadyMotion | RestAfterPush:
        """The motion that is left when the transient has died."""
        if self.push.once:
            return RestAfterPush(oscillator=self.oscillator, push=self.push)
        return SteadyMotion(oscillator=self.oscillator, push=self.push, end=float(self.t[-1]))

    @property
    def fastest(self) -> float:
        """The highest frequency in rad/s."""
        return max(self.oscillator.omega_d, 0.0 if self.push.once else self.push.omega)

    @property
    def exists(self) -> bool:
        """True if there is a steady motion."""
        return self.steady.mass.steady_exists

    @cached_property
    def largest(self) -> float:
        """The largest |x| at these instants, in m."""
        return float(np.abs(self.steady.from_start(self.x_0, self.v_0, self.t)[0]).max())

    def mean_powers(self, end: float, count: int) -> MeanPowers | None:
        """Return the mean powers of the last period up to `end` in s; None of a push that does not repeat.

        Parameters
        ----------
        end : float
            The last time in s.
        count : int
            The number of times, at least.

        Returns
        -------
        MeanPowers or None
            The times in s and the powers in W.
        """
        if isinstance(self.steady, RestAfterPush):
            return None
        return mean_powers(self.steady, self.x_0, self.v_0, end, count)

    def from_rest(self, t: Array) -> Array:
        """Return x (n,) in m from rest at the times t (n,) in s, in rising order, in doubles.

        Parameters
        ----------
        t : ndarray, shape (n,)
            Times in s, 0 or more, in rising order.

        Returns
        -------
        ndarray (n,)
            x in m.
        """
        return self.steady.from_start(0.0, 0.0, t)[0]

    @cached_property
    def is_fast(self) -> bool:
        """True if the motion is too fast for a line."""
        return not drawable(self.fastest, self.t)

    @cached_property
    def split(self) -> bool:
        """True if the motion is shown in its parts."""
        return self._has_parts and not self.is_fast

    @cached_property
    def _has_parts(self) -> bool:
        """True if there are parts, and these do not nearly cancel."""
        return self.exists and self.steady.size <= _APART * max(self.largest, self.steady.size / _LONG)

    @property
    def rings(self) -> bool:
        """False: a band is as long as the window."""
        return False

    @property
    def tallest(self) -> float:
        """The largest displacement in m; 1 if nothing moves."""
        return (self._bound if self.is_fast else self.largest) or 1.0

    @property
    def bands(self) -> dict[str, VibrationBand]:
        """The bands of x, and of the push over the stiffness, as far as they are too fast for a line."""
        found, none = {}, np.zeros_like(self.t)
        if self.is_fast:
            middle, size = self._band
            found["x"] = VibrationBand(middle - size, middle + size)
        if not (self.push.once or drawable(self.push.omega, self.t)):
            high = self.push.size / self.oscillator.k
            found["F_over_k"] = VibrationBand(none - (high if self.push.alternates else 0.0), none + high)
        return found

    @cached_property
    def x(self) -> ExactMotion:
        """The displacement in m. It is played as the sum of its parts; if these cancel, from samples."""
        if self._has_parts:
            return MotionPolynomial(((ONE, (self.x_p,)), (ONE, (self.transient.x,))), self._exact)
        t = np.linspace(0.0, 1.02 * float(self.t[-1]), 1 + max(self.t.size, 512))  # samples repeat after the window
        return Elementary(
            symbol="x",
            exact=self._exact,
            played=SampledCycle(float(t[-1]), *self.steady.from_start(self.x_0, self.v_0, t)),
            size=lambda: self.largest,
            omega=self.fastest,
        )

    @property
    def x_p(self) -> ExactMotion:
        """The steady part in m."""
        return self.steady.x

    @property
    def drive(self) -> ExactMotion:
        """The push in N."""
        return self.steady.force

    @cached_property
    def transient(self) -> FreeDecay:
        """The free motion that is left without the steady part."""
        x, v = self.steady.at(np.zeros(1))
        speed = self.v_0 + self.steady.jump - float(v[0])
        return FreeDecay(oscillator=self.oscillator, x_0=self.x_0 - float(x[0]), v_0=speed)

    def _exact(self, t: Array) -> Array:
        """x (n,) within 4 u of the largest x from rest, and 2 u of the free motion from x_0 and v_0."""
        from_rest = self.steady.mass.from_rest(t).x
        if not (self.x_0 or self.v_0):
            return from_rest
        return from_rest + FreeDecay(oscillator=self.oscillator, x_0=self.x_0, v_0=self.v_0).x.at(t)

    @cached_property
    def _bound(self) -> float:
        return self.steady.size + self.transient.reach() if self.exists else self.largest

    @property
    def _band(self) -> tuple[Array, Array]:
        """The middle and half the height (n,) in m of what x stays within."""
        if self.push.once:
            return self.steady.at(self.t)[0], self.transient.envelope.at(self.t)
        return np.zeros_like(self.t), np.full_like(self.t, self._bound)


@dataclass(frozen=True, kw_only=True)
class PushHarmonics:
    """The harmonics of a push on a damped oscillator with a spring.

    Parameters
    ----------
    oscillator : DampedOscillator
        The mass on its spring and its dashpot; k is above 0.
    push : PeriodicPush
        The push on the mass, which repeats.
    """

    oscillator: DampedOscillator
    push: PeriodicPush

    @property
    def r(self) -> float:
        """The frequency of the push over the natural frequency."""
        return self.push.omega / self.oscillator.omega_n

    @cached_property
    def mass(self) -> PushedMass:
        """The mass under the push."""
        return self.oscillator.pushed(self.push)

    def lines(self, n: Iterable[int]) -> Harmonics:
        """Return these lines n > 0 in doubles: within 1e-12, next to a resonance within 5 u.

        Parameters
        ----------
        n : iterable of int
            The numbers of the lines, above 0.

        Returns
        -------
        Harmonics
            n, |f_n| in N and |X_n| in m, in the order given.
        """
        n, one = np.array(list(n), float), self.oscillator
        f, turn = self.push.sizes(n), n * self.push.omega
        with np.errstate(all="ignore"):
            left = np.hypot(one.k - one.m * turn**2, one.c * turn)
            X = f / left
        for i in np.flatnonzero(left < _RESONANT * one.k):
            X[i] = abs(self.mass.line(int(n[i])).X)
        return Harmonics(n, f, X)

    def drawn(self, end: float) -> Harmonics:
        """Return the lines that the push has up to a frequency in rad/s, at most 100, and the first one.

        Parameters
        ----------
        end : float
            The highest frequency in rad/s.

        Returns
        -------
        Harmonics
            The lines n from 1 to 100 that are part of the push, with n omega up to `end`, and n = 1.
        """
        n, f, X = self._first
        here = (n * self.push.omega <= max(end, self.push.omega)) & (f > _NONE * f[0])
        return Harmonics(n[here], f[here], X[here])

    @cached_property
    def _first(self) -> Harmonics:
        return self.lines(range(1, _DRAWN + 1))

    def has_line(self, n: int) -> bool:
        """Return True if the push has the line n, but for rounding errors: a width of 0.2 is a fifth.

        Parameters
        ----------
        n : int
            The number of the line, above 0.

        Returns
        -------
        bool
            True if |f_n| is more than 1e-12 times |f_1|.
        """
        f = self.push.sizes(np.array([1.0, n], float))
        return bool(f[1] > _NONE * f[0])

    @property
    def resonant(self) -> int:
        """The number of the harmonic that is exactly at a resonance without damping, 0 if none is.

        Then no steady motion exists.
        """
        return 0 if self.mass.steady_exists else self.mass.resonant_line or 0

    @cached_property
    def on_peak(self) -> int:
        """The n whose frequency is on the peak of the response, whether the push has it or not; 0 if there is none.

        n r is within 0.02 of the peak, or the response is at least 0.7 of its maximum.
        """
        peak = highest(self.oscillator.zeta)
        if not peak or self.oscillator.zeta > WIDE:
            return 0
        n = max(1, round(peak[0] / self.r))
        return n if abs(n * self.r - peak[0]) <= max(0.7 * self.oscillator.zeta, _ON_PEAK) else 0

    @cached_property
    def strongest(self) -> tuple[int, float]:
        """The n above 0 of the harmonic that moves the mass most, and |X_n| in m."""
        near = round(1 / self.r) if self.r > 1e-12 else 0
        candidates = {*range(1, 13), *range(max(1, near - _NEAR), near + _NEAR + 1)}
        if self.push.kind == "pulses" and self.push.width < 0.05:
            candidates |= set(range(1, 200))
        n, f, X = self.lines(sorted(candidates))
        best = int(n[np.argmax(np.where(f > _NONE * f[0], X, 0.0))])
        return best, abs(self.mass.line(best).X)
