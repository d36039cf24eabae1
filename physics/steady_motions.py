"""Steady motions under a periodic push as values: exact at given times, playable piece by piece.

In a piece in which the force is F + F' tau, x = constant + slope tau + a free motion, with slope = F'/k and constant =
(F - c slope)/k. In doubles a quick push cancels: the error is some 4 max(1, omega/omega_n)^2 u of the largest x.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from physics.damped import DampedOscillator, Fading
from physics.exact import Array
from physics.motion import Elementary, ExactMotion
from physics.periodic import PeriodicPush


class PlayedPiece(NamedTuple):
    """A piece of a period by the numbers that play it: constant + slope tau + free, tau in s since `begin` in s."""

    begin: float
    constant: float
    slope: float
    free: Fading


class PlayedPieces(NamedTuple):
    """A motion of a period in s, in pieces."""

    period: float
    pieces: tuple[PlayedPiece, ...]

    def at(self, t: Array) -> Array:
        """The values (n,) at the times t (n,) in s, in doubles."""
        rest, values = np.mod(t, self.period), np.zeros_like(t)
        for begin, constant, slope, free in self.pieces:
            tau = np.maximum(rest - begin, 0.0)
            values = np.where(rest >= begin, constant + slope * tau + free.at(tau), values)
        return values


@dataclass(frozen=True, kw_only=True)
class SteadyMotion:
    """The steady motion of a damped oscillator with a spring under a push that repeats."""

    oscillator: DampedOscillator
    push: PeriodicPush

    def __post_init__(self) -> None:
        if not self.oscillator.k or self.push.once:
            raise ValueError(
                "A steady motion in pieces needs a spring and a push that repeats: k above 0 N/m is needed"
            )

    @cached_property
    def x(self) -> ExactMotion:
        """The displacement in m."""
        return self._quantity(0)

    @cached_property
    def v(self) -> ExactMotion:
        """The velocity in m/s."""
        return self._quantity(1)

    def _quantity(self, i: int) -> ExactMotion:
        mass, period = self.oscillator.pushed(self.push), self._played[i].period
        return Elementary(
            symbol="xv"[i], exact=lambda t: mass.steady(t)[1 + i], played=self._played[i], omega=self.push.omega,
            size=lambda: float(np.abs(mass.steady(np.linspace(0, period, 257))[1 + i]).max()),
        )  # fmt: skip

    @cached_property
    def _played(self) -> tuple[PlayedPieces, PlayedPieces]:
        one, period = self.oscillator, 2 * math.pi / self.push.omega
        found: tuple[list[PlayedPiece], list[PlayedPiece]] = ([], [])
        for piece, (x, v) in zip(self.push.pieces, one.pushed(self.push).starts, strict=True):
            slope = float(piece.rise) / period / one.k
            constant = (float(piece.force) - one.c * slope) / one.k
            free_x, free_v, _ = one.fading(x - constant, v - slope)
            begin = float(piece.begin) * period
            found[0].append(PlayedPiece(begin, constant, slope, free_x))
            found[1].append(PlayedPiece(begin, slope, 0.0, free_v))
        return PlayedPieces(period, tuple(found[0])), PlayedPieces(period, tuple(found[1]))
