r"""A motion as the sum of the responses to slices of a push: m x'' + c x' + k x = F(t) from rest.

A short slice of a push, from u to u + du, acts like an impulse F(u) du, which leaves the motion h(t - u) F(u) du. The
motion is the sum of them all, the convolution x = integral of h(t - u) F(u) du. A slice of the width w at the middle of
which its impulse acts is short if omega_n w is: it moves the mass too far by about (omega_n w)^2/24.

Source: J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), section 2.9; L. Meirovitch, Analytical Methods in
Vibrations (1967), section 1.5.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from physics.damped import DampedOscillator
from physics.free_decay import FreeDecay
from physics.motion import ONE, Elementary, ExactMotion, MotionPolynomial, SampledCycle
from physics.precision.exact import Array

_FEWEST = 400  # steps of a window at which the sum is sampled
_LATER = 8  # extra steps beyond the window, because samples are periodic


class Tail(NamedTuple):
    """The motion that one impulse leaves: times t (n,) in s from the impulse on, displacements x (n,) in m.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Times in s.
    x : ndarray, shape (n,)
        Displacements in m.
    """

    t: Array
    x: Array


@dataclass(frozen=True, kw_only=True)
class SlicedPush:
    """A push on a damped oscillator until `end` in s, cut into `count` slices, and a free motion from x_0, v_0.

    Parameters
    ----------
    oscillator : DampedOscillator
        The mass on its spring and its dashpot.
    force : callable
        A function that returns F (n,) in N at times (n,) in s.
    end : float
        The end of the push in s.
    count : int
        The number of slices.
    x_0, v_0 : float
        The displacement in m and the velocity in m/s at t = 0 of the free motion.
    """

    oscillator: DampedOscillator
    force: Callable[[Array], Array]
    end: float
    count: int
    x_0: float = 0.0
    v_0: float = 0.0

    @property
    def ends(self) -> Array:
        """The begin and the end (count, 2) of each slice, in s."""
        ends: Array = self.end / self.count * (np.arange(self.count)[:, None] + np.array([0.0, 1.0]))
        return ends

    @property
    def times(self) -> Array:
        """The middles (count,) of the slices, in s."""
        return self.end * (np.arange(self.count) + 0.5) / self.count

    @cached_property
    def forces(self) -> Array:
        """The force (count,) in N of each slice."""
        return self.force(self.times)

    @property
    def sizes(self) -> Array:
        """The impulse (count,) in N s of each slice."""
        return self.forces * (self.end / self.count)

    @cached_property
    def x(self) -> ExactMotion:
        """The sum in m of the responses to the slices and of the free motion, in doubles."""
        steps, (x, v) = self._steps, self._sampled
        sliced = Elementary(
            symbol="x_sliced",
            exact=self._at,
            played=SampledCycle(self.end * (steps + _LATER) / steps, x, v),
            size=lambda: float(np.abs(x).max()),
            omega=self.oscillator.omega_d,
        )
        return MotionPolynomial(((ONE, (sliced,)), (ONE, (self._free.x,)))) if self.x_0 or self.v_0 else sliced

    def miss(self, x: Array) -> float:
        """Return the largest distance in m of the sum from the motion from rest, given at `instants` (n,).

        Parameters
        ----------
        x : ndarray, shape (n,)
            The displacement of the motion from rest in m at `instants`.

        Returns
        -------
        float
            The largest distance in m.
        """
        return float(np.abs(self._sampled[0][: self._steps + 1] - x).max())

    @property
    def reach(self) -> float:
        """The largest |x| in m of the sum."""
        free = self._free.fadings[0].at(self.instants) if self.x_0 or self.v_0 else 0.0
        return float(np.abs(self._sampled[0][: self._steps + 1] + free).max())

    @property
    def instants(self) -> Array:
        """The times (n,) in s at which the sum is sampled, including the middles of the slices."""
        return np.linspace(0.0, self.end, self._steps + 1)

    @cached_property
    def _free(self) -> FreeDecay:
        return FreeDecay(oscillator=self.oscillator, x_0=self.x_0, v_0=self.v_0)

    @property
    def _steps(self) -> int:
        return 2 * self.count * math.ceil(_FEWEST / (2 * self.count))

    @cached_property
    def _sampled(self) -> tuple[Array, Array]:
        """The sum and its rate at these times and a few later ones; halfway in a jump of the rate."""
        steps = self._steps
        t = np.linspace(0.0, self.end * (steps + _LATER) / steps, steps + _LATER + 1)
        push = np.zeros_like(t)
        push[steps // (2 * self.count) : steps : steps // self.count] = self.sizes
        x, v = (of.at(t) for of in self.oscillator.struck[:2])
        v[0] /= 2
        return np.convolve(push, x)[: t.size], np.convolve(push, v)[: t.size]

    def _at(self, t: Array) -> Array:
        later: Array = t - self.times[:, None]
        left = np.where(later > 0, self.oscillator.struck[0].at(np.maximum(later, 0.0)), 0.0)
        return np.asarray(self.sizes @ left)


def tails(oscillator: DampedOscillator, times: Array, sizes: Array, end: float, points: int) -> list[Tail]:
    """Return what impulses of these sizes in N s at these times in s leave until `end`, as so many points in all.

    Parameters
    ----------
    oscillator : DampedOscillator
        The mass on its spring and its dashpot.
    times : ndarray, shape (m,)
        The times of the impulses in s, up to `end`.
    sizes : ndarray, shape (m,)
        The impulses in N s.
    end : float
        The end of the window in s.
    points : int
        The points of all tails together. Each tail has at least 2, so there may be up to 2 m more.

    Returns
    -------
    list of Tail
        The tail of each impulse: times in s from that of the impulse to `end`, displacements in m.
    """
    whole = float(np.sum(end - times)) or 1.0
    spans = [np.linspace(at, end, 2 + int(points * (end - at) / whole)) for at in times.tolist()]
    counts, t = [span.size for span in spans], np.concatenate(spans)
    x = np.repeat(sizes, counts) * oscillator.struck[0].at(t - np.repeat(times, counts))
    return [Tail(*pair) for pair in zip(spans, np.split(x, np.cumsum(counts)[:-1]), strict=True)]


def joined(tails: list[Tail]) -> Tail:
    """Return tails as one path, to the end of the window and back.

    Parameters
    ----------
    tails : list of Tail
        One tail or more.

    Returns
    -------
    Tail
        All times in s and displacements in m; every second tail is reversed.
    """
    ways = [slice(None, None, -1 if i % 2 else 1) for i in range(len(tails))]
    return Tail(*(np.concatenate([tail[row][way] for tail, way in zip(tails, ways, strict=True)]) for row in (0, 1)))


def outline(ends: Array, heights: Array) -> tuple[Array, Array]:
    """Return the outline of slices between these ends (n, 2), of these heights (n,), from 0 up and down again.

    Parameters
    ----------
    ends : ndarray, shape (n, 2)
        The begin and the end of each slice in s.
    heights : ndarray, shape (n,)
        The height of each slice.

    Returns
    -------
    tuple of ndarray, each (4 n,)
        The times of the corners in s, and their heights in the unit of `heights`.
    """
    up = np.zeros((heights.size, 4))
    up[:, 1:3] = heights[:, None]
    return np.repeat(ends, 2, axis=1).ravel(), up.ravel()
