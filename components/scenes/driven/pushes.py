"""The drive of the driven mass: a sine, or a push of another shape; the motion under it, and its powers."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Literal

import numpy as np

from components.dashpot import DashpotCase
from components.scene.traces import Columns
from physics.driven import Drive, DrivenOscillator
from physics.forced_vibration import ForcedVibration
from physics.periodic import PeriodicPush
from physics.pushed_vibration import WIDE, PushedVibration, PushHarmonics

FEWEST, MOST, PER_PERIOD = 60, 240, 16
"""The times at which powers are computed: the fewest, the most, those in a period."""
PushShape = Literal["sine", "square", "triangle", "pulses"]


class PushedCase(DashpotCase):
    """A motion of a mass on a spring and a dashpot under a drive, in SI units."""

    kind: Drive
    push: PushShape
    width: float
    F_0: float
    Y: float
    moment: float
    omega: float

    @property
    def amount(self) -> float:
        """The size of the drive: F_0 in N, Y in m, or m_0 e in kg m."""
        return {"force": self.F_0, "base": self.Y, "unbalance": self.moment}[self.kind]

    @cached_property
    def vibration(self) -> ForcedVibration:
        oscillator = DrivenOscillator(m=self.m, c=self.c, k=self.k)
        return ForcedVibration(
            oscillator=oscillator, kind=self.kind, size=self.amount, omega=self.omega, x_0=self.x_0, v_0=self.v_0
        )

    @property
    def is_driven(self) -> bool:
        return self.vibration.is_driven

    @property
    def is_sine(self) -> bool:
        """True if a sine drives it, or nothing."""
        return self.kind != "force" or self.push == "sine" or not self.is_driven

    @cached_property
    def repeated(self) -> PeriodicPush | None:
        """The push, if it is not a sine."""
        if self.is_sine or self.push == "sine":
            return None
        return PeriodicPush(kind=self.push, size=self.F_0, omega=self.omega, width=self.width)

    @cached_property
    def harmonics(self) -> PushHarmonics | None:
        """The harmonics of a push that is not a sine."""
        return PushHarmonics(oscillator=self.one, push=self.repeated) if self.repeated else None

    @cached_property
    def moved(self) -> ForcedVibration | PushedVibration:
        """The motion under the drive, whatever its shape."""
        if not self.repeated:
            return self.vibration
        return PushedVibration(oscillator=self.one, push=self.repeated, x_0=self.x_0, v_0=self.v_0, t=self.times)

    def met(self) -> str:
        """The word for which harmonic of the push meets the peak of the response."""
        found = self.harmonics
        if not found:
            return "sine" if self.is_driven else "idle"
        n, strongest = found.on_peak, found.strongest[0]
        if found.resonant:
            return "grows"
        if not n:
            return "wide" if self.one.zeta > WIDE else "between"
        return "missing" if not found.has_line(n) else "hit" if n == strongest else "beaten"

    @cached_property
    def power(self) -> Columns:
        """The mean powers of a sine; none if nothing pushes, or if they are too fast for a line."""
        if not (self.is_driven and self.is_sine):
            return {}
        wanted = PER_PERIOD * self.end * max(self.highest, self.omega) / (2 * math.pi)
        if wanted > 4 * MOST:
            return {}
        return self.vibration.mean_powers(self.end, int(min(max(wanted, FEWEST), MOST)))._asdict()

    @property
    def power_range(self) -> tuple[float, float]:
        """The lowest and the highest power that is drawn, in W."""
        values = np.concatenate([[0.0], *(self.power[name] for name in ("P_in", "P_lost") if self.power)])
        return float(values.min()), float(values.max()) or 1.0

    @property
    def power_ends(self) -> tuple[float, float]:
        low, high = self.power_range
        return 1.1 * low, 1.15 * high
