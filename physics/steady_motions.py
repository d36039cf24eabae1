"""Motions under a push in doubles, for drawing: within 1e-9 of the largest value.

In a piece in which the force is F + F' tau the motion from x_0, v_0 is that of physics.pushed,

    x = A x_0 + B v_0 + F/m E2 + F'/m E3,

with A, B, E2, E3 by the form that keeps its digits: a power series at first, then exponentials. The steady motion
starts at the fixed point of a period, (1 - M) state = q. Where 1 - M loses more than five digits, near the resonance of
a harmonic or for a very quick push, the state comes from numbers of mpmath.

Source: beyond lecture D31, as in physics.pushed; J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), sections 2.1
and 3.1.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, reduce
from itertools import pairwise
from typing import NamedTuple, TypeVar

import numpy as np

from physics.damped import DampedOscillator
from physics.free_decay import FreeDecay
from physics.motion import Elementary, ExactMotion, SampledCycle, constant
from physics.periodic import PeriodicPush
from physics.precision.exact import Array
from physics.pushed import PushedMass

_SINGULAR = 1e-5  # of the determinant of 1 - M, below which doubles keep too few digits
_TERMS = 25  # of the power series, up to the phase 1
_SHORT = 1e-3  # of z, below which (1 - (1 - exp(-z))/z)/z takes four terms of its series
_FEWEST, _MOST, _PER_SWING = 256, 1024, 16  # samples: the fewest, the most, those of a swing

_PERIODS = 2.0**60  # beyond so many, times are not told apart

V = TypeVar("V", float, Array)  # at one time or at several


class PushResponse(NamedTuple):
    """A, B, E2, E3 and the rate of B (n,) at some times after the start of a piece, in powers of s.

    Attributes
    ----------
    A, slope : ndarray, shape (n,)
        A and the rate of B, without a unit.
    B : ndarray, shape (n,)
        B in s.
    E2 : ndarray, shape (n,)
        E2 in s^2.
    E3 : ndarray, shape (n,)
        E3 in s^3.
    """

    A: Array
    B: Array
    E2: Array
    E3: Array
    slope: Array


@dataclass(frozen=True, kw_only=True)
class SteadyMotion:
    """The steady motion of a damped oscillator with a spring under a push that repeats, and other motions under it.

    The browser plays it by samples of a period, or if that is longer than the window up to `end` in s, of this window.

    Parameters
    ----------
    oscillator : DampedOscillator
        The mass on its spring and its dashpot; k is above 0.
    push : PeriodicPush
        The push on the mass, which repeats.
    end : float
        The end of the window in s.

    Raises
    ------
    ValueError
        If there is no spring, or the push does not repeat.
    """

    oscillator: DampedOscillator
    push: PeriodicPush
    end: float = math.inf

    def __post_init__(self) -> None:
        if not self.oscillator.k or self.push.once:
            raise ValueError(
                "A steady motion in pieces needs a spring and a push that repeats: k above 0 N/m is needed"
            )

    @cached_property
    def mass(self) -> PushedMass:
        """The mass under the push."""
        return self.oscillator.pushed(self.push)

    @property
    def period(self) -> float:
        """The period of the push in s."""
        return 2 * math.pi / self.push.omega

    @cached_property
    def x(self) -> ExactMotion:
        """The displacement in m."""
        return Elementary(
            symbol="x_p",
            exact=lambda t: self.mass.steady(t).x,
            played=SampledCycle(float(self._instants[-1]), *self._samples),
            size=lambda: self.size,
            omega=max(self.oscillator.omega_d, self.push.omega),
        )

    @cached_property
    def force(self) -> ExactMotion:
        """The push in N; a jump takes a sample."""
        t, size = self._instants, abs(self.push.size)
        F = self.force_at(t)
        rates = np.gradient(F, t) if self.push.kind == "triangle" else np.zeros_like(F)
        played = SampledCycle(float(t[-1]), F, rates)
        return Elementary(symbol="F", exact=self.mass.force, played=played, size=lambda: size, omega=self.push.omega)

    @cached_property
    def size(self) -> float:
        """The largest |x| in m."""
        whole = self.period <= self.end
        return float(np.abs(self._samples[0] if whole else self.at(np.linspace(0.0, self.period, _MOST + 1))[0]).max())

    @cached_property
    def starts(self) -> list[tuple[float, float]]:
        """x and v at the start of each piece."""
        maps, whole = self._maps, self._period_map
        if self.push.alternates:  # the fixed point of half a period, turned over
            whole = _one_by_one(maps[: len(maps) // 2])
            whole[:2] *= -1
        (a, b, p), (c, d, q), _ = whole.tolist()
        below = (1 - a) * (1 - d) - b * c
        if not below > _SINGULAR:
            return self.mass.starts
        return self._through(((1 - d) * p + b * q) / below, (c * p + (1 - a) * q) / below)

    def at(self, t: Array) -> tuple[Array, Array]:
        """The steady x and v (n,) at the times t (n,) in s.

        Parameters
        ----------
        t : ndarray, shape (n,)
            Times in s.

        Returns
        -------
        tuple of ndarray, each (n,)
            x in m and v in m/s.

        Raises
        ------
        ValueError
            If no steady motion exists: at a resonance without a dashpot.
        """
        return self._in_pieces(np.mod(t, self.period), self.starts)

    def force_at(self, t: Array) -> Array:
        """Return F (n,) in N at the times t (n,) in s; impulses are left out, because their force is not finite.

        Parameters
        ----------
        t : ndarray, shape (n,)
            Times in s.

        Returns
        -------
        ndarray (n,)
            F in N.
        """
        share, F = np.mod(t, self.period) / self.period, np.zeros_like(t)
        for piece in self.push.pieces:
            began = float(piece.begin)
            F = np.where(share >= began, float(piece.force) + float(piece.rise) * (share - began), F)
        return F

    def from_start(self, x_0: float, v_0: float, t: Array) -> tuple[Array, Array]:
        """Return x and v (n,) from x(0) = x_0 and v(0) = v_0 at rising times t (n,) in s, at a resonance too.

        Parameters
        ----------
        x_0, v_0 : float
            The displacement in m and the velocity in m/s at t = 0.
        t : ndarray, shape (n,)
            Times in s, 0 or more, in rising order.

        Returns
        -------
        tuple of ndarray, each (n,)
            x in m and v in m/s.
        """
        counts = np.floor(np.minimum(t / self.period, _PERIODS))
        return self.after(x_0, v_0, counts, np.maximum(t - counts * self.period, 0.0))

    def after(self, x_0: float, v_0: float, periods: Array, rest: Array) -> tuple[Array, Array]:
        """Return x and v (n,) from such a start, at times `rest` (n,) in s after so many periods (n,), in rising order.

        Parameters
        ----------
        x_0, v_0 : float
            The displacement in m and the velocity in m/s at t = 0.
        periods : ndarray, shape (n,)
            Whole numbers of periods since t = 0, in rising order.
        rest : ndarray, shape (n,)
            Times in s since the last of these periods ended, from 0 to a period.

        Returns
        -------
        tuple of ndarray, each (n,)
            x in m and v in m/s.
        """
        counts, places = np.unique(periods, return_inverse=True)
        state, states = np.array([x_0, v_0, 1.0]), []
        for before, count in pairwise((0.0, *counts.tolist())):
            state = np.linalg.matrix_power(self._period_map, int(count - before)) @ state
            states.append(state)
        x, v, _ = np.array(states)[places].T
        return self._in_pieces(rest, self._through(x, v))

    def _through(self, x: V, v: V) -> list[tuple[V, V]]:
        """x and v at the start of each piece of a period, from those before it."""
        states = [(x, v + self.jump)]
        for into_x, into_v, _ in self._maps[:-1]:
            x, v = states[-1]
            states.append(((into_x[0] * x + into_x[1] * v + into_x[2]), (into_v[0] * x + into_v[1] * v + into_v[2])))
        return states

    @cached_property
    def _period_map(self) -> Array:
        jump = np.eye(3)
        jump[1, 2] = self.jump
        return _one_by_one([jump, *self._maps])

    @property
    def jump(self) -> float:
        """The velocity in m/s that an impulse adds."""
        return self.push.size / self.oscillator.m if self.push.impulsive else 0.0

    @cached_property
    def _instants(self) -> Array:
        """The times in s at which a motion is sampled, from 0 to the end of a period or beyond that of the window."""
        whole = self.period <= self.end
        span = self.period if whole else 1.02 * self.end  # samples repeat: they must not begin again in the window
        swings = self.oscillator.omega_d * span / (2 * math.pi)
        return np.linspace(0.0, span, 8 * math.ceil(min(max(_PER_SWING * swings, _FEWEST), _MOST) / 8) + 1)

    @cached_property
    def _samples(self) -> tuple[Array, Array]:
        t = self._instants
        rest = t if t[-1] == self.period else np.mod(t, self.period)  # before an impulse at the end, not after it
        return self._in_pieces(rest, self.starts)

    @cached_property
    def _maps(self) -> list[Array]:
        """The map of each piece, from x, v and 1 at its start to those at its end: a matrix (3, 3)."""
        one, found = self.oscillator, []
        spans = np.array([float(piece.end - piece.begin) for piece in self.push.pieces]) * self.period
        for F, rise, r in zip(
            *self._forces, map(PushResponse._make, zip(*self._response(spans), strict=True)), strict=True
        ):
            x, v = (F * r.E2 + rise * r.E3) / one.m, (F * r.B + rise * r.E2) / one.m
            found.append(np.array([[r.A, r.B, x], [-one.k / one.m * r.B, r.slope, v], [0.0, 0.0, 1.0]]))
        return found

    def _in_pieces(self, rest: Array, starts: Sequence[tuple[V, V]]) -> tuple[Array, Array]:
        """x and v (n,) at times from the start of a period, from those at the start of each of its pieces."""
        one, pieces = self.oscillator, self.push.pieces
        begins = np.array([float(piece.begin) * self.period for piece in pieces])
        places = np.searchsorted(begins, rest, side="right") - 1
        x, v = (np.stack([np.broadcast_to(of, rest.shape) for of in each]) for each in zip(*starts, strict=True))
        x, v = (each[places, np.arange(rest.size)] for each in (x, v))
        F, rise = (np.array(each, float)[places] / one.m for each in self._forces)
        r = self._response(rest - begins[places])
        found = r.A * x + r.B * v + F * r.E2, r.slope * v - one.k / one.m * r.B * x + F * r.B
        return (found[0] + rise * r.E3, found[1] + rise * r.E2) if np.any(rise) else found

    @property
    def _forces(self) -> tuple[list[float], list[float]]:
        """The force in N at the start of each piece, and its rise in N/s."""
        pieces = self.push.pieces
        return [float(one.force) for one in pieces], [float(one.rise) / self.period for one in pieces]

    def _response(self, tau: Array) -> PushResponse:
        one = self.oscillator
        (slow, fast), swing, square = one.rates, one.omega_d, one.k / one.m
        apart, damping, faded = fast - slow, one.c / one.m, np.exp(-slow * tau)
        turned = faded * np.cos(swing * tau)
        grown = np.sin(swing * tau) / swing if swing else -np.expm1(-apart * tau) / apart if apart else tau
        B = faded * grown
        slope = (turned if swing else np.exp(-fast * tau)) - slow * B
        A = turned + slow * B
        E2 = (1 - A) / square
        E3 = (tau - B - damping * E2) / square
        parted = apart * tau > 1
        E2[parted], E3[parted] = _of_exponentials(slow, fast, tau[parted])
        early = max(one.omega_n, fast) * tau <= 1
        E2[early], E3[early] = _series(damping, square, tau[early])
        return PushResponse(A, B, E2, E3, slope)


@dataclass(frozen=True, kw_only=True)
class RestAfterPush:
    """The rest in which a damped oscillator with a spring ends after a push that does not repeat.

    It has the names of SteadyMotion.

    Parameters
    ----------
    oscillator : DampedOscillator
        The mass on its spring and its dashpot.
    push : PeriodicPush
        A step or one impulse.
    """

    oscillator: DampedOscillator
    push: PeriodicPush

    @property
    def mass(self) -> PushedMass:
        return self.oscillator.pushed(self.push)

    @property
    def place(self) -> float:
        """The displacement in m: a step keeps the spring stretched, an impulse does not."""
        return 0.0 if self.push.impulsive else self.push.size / self.oscillator.k

    @property
    def size(self) -> float:
        return abs(self.place)

    @property
    def jump(self) -> float:
        """The velocity in m/s that the push gives at once."""
        return self.push.size / self.oscillator.m if self.push.impulsive else 0.0

    @property
    def x(self) -> ExactMotion:
        return constant(self.place)

    @property
    def force(self) -> ExactMotion:
        """The push in N, without an impulse."""
        return constant(0.0 if self.push.impulsive else self.push.size)

    def at(self, t: Array) -> tuple[Array, Array]:
        """Return x and v (n,) of the rest.

        Parameters
        ----------
        t : ndarray, shape (n,)
            Times in s.

        Returns
        -------
        tuple of ndarray, each (n,)
            x in m, the same at all times, and v in m/s, which is 0.
        """
        return np.full_like(t, self.place), np.zeros_like(t)

    def from_start(self, x_0: float, v_0: float, t: Array) -> tuple[Array, Array]:
        """Return x and v (n,) from x(0) = x_0 and v(0) = v_0 at the times t (n,) in s.

        Parameters
        ----------
        x_0, v_0 : float
            The displacement in m and the velocity in m/s at t = 0, before an impulse.
        t : ndarray, shape (n,)
            Times in s, 0 or more.

        Returns
        -------
        tuple of ndarray, each (n,)
            x in m and v in m/s.
        """
        free = FreeDecay(oscillator=self.oscillator, x_0=x_0 - self.place, v_0=v_0 + self.jump)
        return self.place + free.fadings[0].at(t), free.fadings[1].at(t)


def _one_by_one(maps: list[Array]) -> Array:
    """The map (3, 3) that applies these one after the other."""
    return reduce(lambda done, one: one @ done, maps, np.eye(3))


def _of_exponentials(slow: float, fast: float, tau: Array) -> tuple[Array, Array]:
    """E2 and E3 (n,) where both exponentials have parted."""
    (first, of_first), (second, of_second) = _means(slow * tau), _means(fast * tau)
    scale = tau / (fast - slow) if tau.size else tau
    return (first - second) * scale, (of_first - of_second) * scale * tau


def _means(z: Array) -> tuple[Array, Array]:
    """f = (1 - exp(-z))/z and (1 - f)/z (n,), regular at z = 0."""
    short, safe = z < _SHORT, np.maximum(z, _SHORT)
    f = np.where(short, 1 - z / 2 * (1 - z / 3 * (1 - z / 4)), -np.expm1(-safe) / safe)
    return f, np.where(short, (1 - z / 3 * (1 - z / 4 * (1 - z / 5))) / 2, (1 - f) / safe)


def _series(damping: float, square: float, tau: Array) -> tuple[Array, Array]:
    """E2 and E3 (n,) as power series: each rate of change follows from the two before it.

    The rates are multiplied by powers of tau: those of a quick mass alone leave the range of doubles.
    """
    decay, turn, share = damping * tau, square * tau * tau, 0.5
    before, now = np.zeros_like(tau), np.ones_like(tau)
    E2, E3 = np.zeros_like(tau), np.zeros_like(tau)
    for n in range(3, _TERMS):
        E2, E3 = E2 + now * share, E3 + now * (share / n)
        before, now = now, -decay * now - turn * before
        share /= n
    return E2 * tau**2, E3 * tau**3
