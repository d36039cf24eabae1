"""The drive of the driven mass: a sine, or a push of another shape; the motion under it, and its powers."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Literal

import numpy as np

from components.dashpot import DashpotCase
from components.scene.traces import Columns, Floats
from physics.driven import Drive, DrivenOscillator
from physics.forced_vibration import ForcedVibration
from physics.motion import Elementary, ExactMotion, SampledCycle
from physics.periodic import PeriodicPush
from physics.pushed_vibration import WIDE, PushedVibration, PushHarmonics

FEWEST, MOST, PER_PERIOD = 60, 240, 16
"""Number of times at which powers are computed: least, most, and per period."""
PushShape = Literal["sine", "square", "triangle", "pulses", "impulses", "step", "impulse"]
MOST_JOLTS = 200
FLASH, IN_FLASHES = 2, 32
"""An impulse is visible on the stage for FLASH of the IN_FLASHES samples of a period."""


class PushedCase(DashpotCase):
    """A motion of a mass on a spring and a dashpot under a drive, in SI units."""

    kind: Drive
    push: PushShape
    width: float
    F_0: float
    J: float
    Y: float
    moment: float
    omega: float

    @property
    def shape(self) -> PushShape:
        """The shape of the push; a shaken base and an unbalance have a sine."""
        return self.push if self.kind == "force" else "sine"

    @property
    def is_impulsive(self) -> bool:
        return self.shape in ("impulses", "impulse")

    @property
    def is_once(self) -> bool:
        """True if the push does not repeat."""
        return self.shape in ("step", "impulse")

    @property
    def has_width(self) -> bool:
        return self.shape == "pulses"

    @property
    def amount(self) -> float:
        """The size of the drive: F_0 in N, J in N s, Y in m, or m_0 e in kg m."""
        sizes = {"force": self.J if self.is_impulsive else self.F_0, "base": self.Y, "unbalance": self.moment}
        return sizes[self.kind]

    @cached_property
    def vibration(self) -> ForcedVibration:
        oscillator = DrivenOscillator(m=self.m, c=self.c, k=self.k)
        return ForcedVibration(
            oscillator=oscillator, kind=self.kind, size=self.amount, omega=self.omega, x_0=self.x_0, v_0=self.v_0
        )

    @property
    def is_driven(self) -> bool:
        return bool(self.amount and (self.omega or self.is_once))

    @property
    def is_sine(self) -> bool:
        """True if the drive is a sine, or if there is none."""
        return self.shape == "sine" or not self.is_driven

    @cached_property
    def pushed_by(self) -> PeriodicPush | None:
        """The push, if it is not a sine."""
        if self.is_sine or self.shape == "sine":
            return None
        return PeriodicPush(kind=self.shape, size=self.amount, omega=self.omega or 1.0, width=self.width)

    @cached_property
    def harmonics(self) -> PushHarmonics | None:
        """The harmonics of a push that repeats and is not a sine."""
        return PushHarmonics(oscillator=self.one, push=self.pushed_by) if self.pushed_by and not self.is_once else None

    @cached_property
    def moved(self) -> ForcedVibration | PushedVibration:
        """The motion under the drive, of any shape."""
        if not self.pushed_by:
            return self.vibration
        return PushedVibration(oscillator=self.one, push=self.pushed_by, x_0=self.x_0, v_0=self.v_0, t=self.times)

    @property
    def period_in_window(self) -> float | None:
        """The period of a push that is not a sine, as a share of the window; None if it is longer than the window."""
        share = 2 * math.pi / self.omega / self.end if self.pushed_by and not self.is_once else math.inf
        return share if share <= 1 else None

    @property
    def crest(self) -> float:
        """The first time at which the push is highest, as a share of the window."""
        if self.shape == "step":
            return 0.25
        return {"square": 0.25, "triangle": 0.25, "pulses": 0.5 * self.width}.get(self.shape, 0.0) * (
            self.period_in_window or 0.0
        )

    @property
    def jolts(self) -> Floats:
        """The times (n,) in s of the first impulses in the window, at most 200."""
        if self.is_once or not self.omega:
            return np.zeros(1)
        period = 2 * math.pi / self.omega
        return np.asarray(period * np.arange(1 + int(min(self.end / period, MOST_JOLTS - 1))), float)

    @property
    def mean_size(self) -> float:
        """The force to which harmonics are relative: F_0, or the mean force of impulses, in N."""
        return self.J * self.omega / (2 * math.pi) if self.is_impulsive else self.F_0

    @property
    def seen_push(self) -> ExactMotion:
        """The push as the stage shows it. An impulse, in N s, is visible for a moment."""
        if not self.is_impulsive or not self.is_driven:
            return self.moved.drive
        period = 1.02 * self.end if self.is_once else 2 * math.pi / self.omega
        flash = np.where(np.arange(IN_FLASHES + 1) < FLASH, self.J, 0.0)
        played = SampledCycle(period, flash, np.zeros_like(flash))
        return Elementary(symbol="F", exact=played.at, played=played, size=lambda: self.J)

    def met(self) -> str:
        """Return the name of the sentence on which harmonic of the push is at the peak of the response."""
        found = self.harmonics
        if not found:
            return "once" if self.is_driven and self.is_once else "sine" if self.is_driven else "idle"
        n, strongest = found.on_peak, found.strongest[0]
        if found.resonant:
            return "grows"
        if not n:
            return "wide" if self.one.zeta > WIDE else "between"
        return "missing" if not found.has_line(n) else "hit" if n == strongest else "beaten"

    @cached_property
    def power(self) -> Columns:
        """The mean powers; none without a push that repeats, or if they are too fast for a line."""
        if not self.is_driven:
            return {}
        wanted = PER_PERIOD * self.end * max(self.highest, self.omega) / (2 * math.pi)
        if wanted > 4 * MOST:
            return {}
        found = self.moved.mean_powers(self.end, int(min(max(wanted, FEWEST), MOST)))
        return found._asdict() if found else {}

    @property
    def power_range(self) -> tuple[float, float]:
        """The lowest and the highest power that is drawn, in W."""
        values = np.concatenate([[0.0], *(self.power[name] for name in ("P_in", "P_lost") if self.power)])
        return float(values.min()), float(values.max()) or 1.0

    @property
    def power_ends(self) -> tuple[float, float]:
        low, high = self.power_range
        return 1.1 * low, 1.15 * high
