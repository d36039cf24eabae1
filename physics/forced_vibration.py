"""Forced vibration of one oscillator from its initial conditions: its parts, its energy, the mean powers.

The equations are those of physics.driven: x = x_p + x_c, the steady part and the free motion from what is left of the
initial conditions. Without damping at resonance there is no steady part; then x grows in proportion to t.

Source: J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), sections 2.9 to 2.12.
"""

import math
from cmath import phase
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from physics.driven import Drive, DrivenOscillator, Push, drawn
from physics.exact import Array
from physics.free_decay import FreeDecay
from physics.motion import ONE, Elementary, ExactMotion, Harmonic, MotionPolynomial, harmonic_motion
from physics.sampling import Sinusoid
from physics.transient import FILE
from physics.valid import in_range

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(4)


class MeanPowers(NamedTuple):
    """The power of the drive and of the dashpot (n,) in W at the times t, each the mean of the last drive period."""

    t: Array
    P_in: Array
    P_lost: Array


@dataclass(frozen=True, kw_only=True)
class ForcedVibration:
    """A motion of a driven oscillator from x(0) = x_0 (m), x'(0) = v_0 (m/s).

    `size` is F_0 in N, Y in m, or mu e in kg m; `omega` is the frequency of the drive in rad/s.
    """

    oscillator: DrivenOscillator
    kind: Drive
    size: float
    omega: float
    x_0: float
    v_0: float

    @property
    def is_driven(self) -> bool:
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
        from_rest = Elementary(
            symbol="x_driven", exact=lambda t: self.at(t)[0], played=self.push, size=self._size, omega=self.fastest
        )
        return MotionPolynomial(((ONE, (from_rest,)), (ONE, (replace(self.free.x, symbol="x_free"),))), self._exact)

    @cached_property
    def x_p(self) -> ExactMotion:
        """The steady part in m."""
        return rotating("x_p", self.X, self.omega)

    @cached_property
    def drive(self) -> ExactMotion:
        """size sin(omega t): the force in N, the displacement of the base in m, or what turns, seen from the side."""
        return rotating("drive", complex(self.size), self.omega)

    def at(self, t: Array) -> tuple[Array, Array]:
        """Return x and v (n,) in doubles, as they are drawn."""
        x, v = drawn(self.push, t)
        fading = self.free.fadings
        return x + fading[0].at(t), v + fading[1].at(t)

    def powers(self, t: Array) -> tuple[Array, Array]:
        """Return the power that the drive puts in and the power that the dashpot takes (n,), in W."""
        one, (x, v) = self.oscillator, self.at(t)
        if self.kind == "base":
            y = self.size * np.sin(self.omega * t)
            rate = self.size * self.omega * np.cos(self.omega * t)
            return -(one.k * (x - y) + one.c * (v - rate)) * rate, one.c * (v - rate) ** 2
        force = self.size if self.kind == "force" else self.size * self.omega * self.omega
        return force * np.sin(self.omega * t) * v, one.c * v * v

    def mean_powers(self, end: float, count: int) -> MeanPowers:
        """Return the mean powers at `count` + 1 times up to `end` in s. ValueError beyond the range of doubles."""
        period, step = 2 * math.pi / self.omega, end / count
        t = np.linspace(0.0, end, count + 1)
        earlier = np.maximum(np.arange(count + 1) - count * (period / end), 0.0)
        inner = (t[:-1, None] + step * (1 + _NODES) / 2).ravel()
        found = []
        with np.errstate(over="ignore", invalid="ignore"):
            for inside, at in zip(self.powers(inner), self.powers(t), strict=True):
                pieces = inside.reshape(count, -1) @ _WEIGHTS * step / 2
                done = np.concatenate([[0.0], np.cumsum(pieces)])
                before = _between(step, in_range("the work", done), in_range("the power", at), earlier)
                found.append((done - before) / period)
        return MeanPowers(t, *found)

    def _exact(self, t: Array) -> Array:
        return self.oscillator.motion(self.omega, self.size, self.x_0, self.v_0, t, self.kind, FILE).x

    def _size(self) -> float:
        """About the largest displacement from rest in m."""
        steady = abs(self.X)
        force = math.hypot(self.push.re, self.push.im)
        return steady if math.isfinite(steady) else force / self.push.omega_n / self.push.omega_n


def rotating(symbol: str, X: complex, omega: float) -> ExactMotion:
    """Return the motion Im(X exp(i omega t))."""
    played = Harmonic((Sinusoid(abs(X), omega, phase(X)),))
    return harmonic_motion(symbol, played, lambda t: np.asarray((X * np.exp(1j * omega * t)).imag))


def _between(step: float, heights: Array, slopes: Array, places: Array) -> Array:
    """Return the cubics through heights with slopes, `step` apart in time, at places counted in steps from the first.

    Places are not divided by `step`, which is 0 in the shortest windows.
    """
    i = np.minimum(places.astype(int), len(heights) - 2)
    s, rise = places - i, heights[i + 1] - heights[i]
    first, last = slopes[i] * step, slopes[i + 1] * step
    found: Array = heights[i] + s * (first + s * (3 * rise - 2 * first - last + s * (first + last - 2 * rise)))
    return found
