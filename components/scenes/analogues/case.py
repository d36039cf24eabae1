"""One system of the scene analogues, released at rest, next to the spring with the same frequency."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from components.scene.frames import Windowed
from components.scene.traces import Floats, resolved
from physics.analogue import Analogue, Tuned
from physics.oscillator import Oscillator
from physics.pendulum import Pendulum, PendulumMotion, excess
from physics.sampling import periods
from physics.valid import DOUBLES

DEGREE = math.pi / 180
MOST_HALF_WAVES = 12
"""Largest number of half waves; more would not be visible in a picture."""
SWINGS = 3.5
NODES, MOST_NODES = 96, 512
"""Number of points per oscillation between which the browser interpolates: of a small one, and of one with the largest
amplitude."""
TINY = 1e-9
"""Amplitude in rad; smaller oscillations have the same shape to the last digit."""


class Swings(NamedTuple):
    """A pendulum's angle and rate over one period, and its amplitude."""

    theta: Floats
    theta_dot: Floats
    size: float

    @property
    def share(self) -> tuple[Floats, Floats]:
        """The angle relative to its amplitude, and its rate."""
        return self.theta / self.size, self.theta_dot / self.size

    @property
    def root(self) -> tuple[Floats, Floats]:
        """The square root of V relative to its maximum, and its rate."""
        half = math.sin(self.size / 2)
        return np.sin(self.theta / 2) / half, np.cos(self.theta / 2) * self.theta_dot / (2 * half)


@dataclass(frozen=True, kw_only=True)
class AnalogueCase(Windowed):
    """The chosen system, released at rest from q_0 (SI, rad), and the equivalent spring and mass."""

    system: Analogue
    p: dict[str, float]
    q_0: float

    @cached_property
    def tuned(self) -> Tuned:
        return self.system.at(self.p)

    @cached_property
    def spring(self) -> Oscillator:
        return Oscillator(m=self.tuned.inertia, k=self.tuned.stiffness)

    @cached_property
    def omega(self) -> float:
        return self.tuned.omega_n

    @cached_property
    def pendulum(self) -> Pendulum | None:
        return self.tuned.pendulum

    @cached_property
    def excess(self) -> float:
        """The relative delay T/T_0 - 1; 0 for a linear system."""
        return excess(self.q_0) if self.pendulum else 0.0

    @cached_property
    def period(self) -> float:
        """The period in s. Raises ValueError if it leaves the range of doubles."""
        period = self.pendulum.period(self.q_0) if self.pendulum else self.spring.period
        if math.isinf(period):
            raise ValueError(f"the period leaves {DOUBLES}")
        return period

    @cached_property
    def lasting(self) -> float:
        return periods(2 * math.pi / self.period, SWINGS)

    @property
    def half_waves(self) -> float:
        """The number of half waves in a picture."""
        return min(self.p.get("n", 1.0), MOST_HALF_WAVES)

    @property
    def drawable(self) -> bool:
        """True if both motions are slow enough to be drawn as lines."""
        return resolved(self.end, self.omega)

    @cached_property
    def energy(self) -> float:
        """T + V in J of the linear system."""
        return self.tuned.energy(self.q_0)

    @property
    def exact_energy(self) -> float:
        """T + V in J at any amplitude."""
        return self.tuned.exact_energy(self.q_0)

    @cached_property
    def swings(self) -> Swings:
        """One cycle of a pendulum, which the clock repeats."""
        count = min(math.ceil(NODES * (1 + self.excess)), MOST_NODES)
        motion, size = self.swing(np.linspace(0.0, self.period, count + 1))
        return Swings(motion.theta, motion.theta_dot, size)

    def swing(self, t: Floats) -> tuple[PendulumMotion, float]:
        """The exact motion and its amplitude: q_0, or a small amplitude for which the shape is the same."""
        size = math.copysign(max(abs(self.q_0), TINY), self.q_0)
        if self.pendulum is None:
            raise TypeError(f"{self.system.name} is linear: its motion is that of the spring")
        return self.pendulum.motion(size, t), size
