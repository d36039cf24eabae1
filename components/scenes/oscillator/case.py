"""A motion of the oscillator over its window."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

from components.quantities.motion import QUARTER, scaled
from components.scene.frames import Windowed
from components.scene.traces import resolved
from physics.oscillator import Oscillator, OscillatorConstants
from physics.sampling import periods, time_window

MOST_SWINGS = 6
"""In a longer window a quarter period is too short to be marked."""


@dataclass(frozen=True, kw_only=True)
class Oscillation(Windowed):
    """A motion over its window, and what is shown beside it."""

    oscillator: Oscillator
    x_0: float
    v_0: float
    view: str

    @cached_property
    def omega(self) -> float:
        return self.oscillator.omega_n

    @cached_property
    def constants(self) -> OscillatorConstants:
        return self.oscillator.constants(self.x_0, self.v_0)

    @cached_property
    def lasting(self) -> float:
        return periods(self.omega, 2) if self.omega else time_window(0.0, 0.0)

    @property
    def drawable(self) -> bool:
        """Whether x, v and a are slow enough for lines."""
        return resolved(self.end, self.omega)

    @property
    def turns(self) -> bool:
        """Whether there is an arrow to turn: neither a free mass nor one at rest."""
        return self.omega > 0 and self.constants.C > 0

    @cached_property
    def amplitudes(self) -> tuple[float, ...]:
        """C, omega C and omega^2 C, of x, v and a; of a free mass, its constant speed."""
        if not self.omega:
            return abs(self.x_0), abs(self.v_0), 0.0
        return tuple(scaled(0, self.constants.C, *[self.omega] * i) for i in range(3))

    @property
    def loop(self) -> tuple[float, int]:
        """The time for which the planes (x, v) and (x, a) are drawn, and the points: one turn; of a free mass, all."""
        return (self.oscillator.period, 145) if self.omega else (self.end, 2)

    @cached_property
    def last_peak(self) -> float:
        """The last peak of x in the window, in periods; 0 where those of v and a before it leave no room for marks."""
        swings = self.end / self.oscillator.period
        if not (self.turns and self.drawable and swings <= MOST_SWINGS):
            return 0.0
        first = ((QUARTER - self.constants.phi) % (2 * math.pi)) / (2 * math.pi)
        last = first + math.floor(swings - first)
        return last if last >= 0.5 else 0.0
