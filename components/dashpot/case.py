"""The base class of cases of one mass on a spring and a dashpot, in free motion."""

from __future__ import annotations

from functools import cached_property

from components.language.picture import Pace
from components.quantities.motion import pace
from components.scene.case import Case
from physics.damped import DampedOscillator
from physics.free_decay import FreeDecay


class DashpotCase(Case):
    """The oscillator m, c, k and its free motion from x_0, v_0, in SI units."""

    m: float
    c: float
    k: float
    x_0: float
    v_0: float

    @cached_property
    def one(self) -> DampedOscillator:
        return DampedOscillator(m=self.m, c=self.c, k=self.k)

    @cached_property
    def free(self) -> FreeDecay:
        return FreeDecay(oscillator=self.one, x_0=self.x_0, v_0=self.v_0)

    @cached_property
    def own_end(self) -> float:
        """The end of the time window in s, if no frame sets it: a number of two digits."""
        return self.window or float(f"{self.lasting:.2g}") or self.lasting

    @property
    def pace(self) -> Pace:
        return pace(self.one.omega_n, self.one.omega_n)

    @property
    def spring(self) -> bool:
        """True if there is a spring."""
        return self.k > 0

    @property
    def dashpot(self) -> bool:
        """True if there is a dashpot."""
        return self.c > 0
