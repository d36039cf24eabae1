"""A damped motion as the scene sees it: its kind, its window, where it peaks and what its axes have to reach."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple

from components.quantities.motion import scaled
from components.scene.frames import Windowed
from physics.damped import DampedOscillator, Fading, FreeDecay
from physics.exact import exact, precise, rounded
from physics.sampling import NOTHING_OSCILLATES, periods

DampedKind = Literal["rest", "drift", "glide", "plain", "under", "critical", "over"]
SAME = 1e-6
"""As near to critical as that both roots are one."""
HARDLY = 0.9
"""From this damping ratio on, half a swing leaves less than two thousandths."""
MOST_PEAKS = 5
LASTING = 5.0
"""Times of the slower rate after which hardly anything is left."""


class Moment(NamedTuple):
    """A time in s with x in m and v in m/s."""

    t: float
    x: float
    v: float


@dataclass(frozen=True, kw_only=True)
class DampedCase(Windowed):
    """A damped oscillator and its start."""

    oscillator: DampedOscillator
    x_0: float
    v_0: float

    @cached_property
    def motion(self) -> FreeDecay:
        return FreeDecay(oscillator=self.oscillator, x_0=self.x_0, v_0=self.v_0)

    @cached_property
    def fadings(self) -> tuple[Fading, ...]:
        """x, then v, in their late parts."""
        return self.oscillator.fading(self.x_0, self.v_0)

    @property
    def fading(self) -> Fading:
        """x in its late parts."""
        return self.fadings[0]

    @cached_property
    def omega(self) -> float:
        return self.oscillator.omega_n

    @cached_property
    def kind(self) -> DampedKind:
        one = self.oscillator
        if not one.k:
            return "glide" if one.c else "drift"
        if not self.x_0 and not self.v_0:
            return "rest"
        if not one.c:
            return "plain"
        if one.regime == "critical" or abs(one.zeta - 1) < SAME:
            return "critical"
        return "under" if one.zeta < 1 else "over"

    @cached_property
    def said(self) -> str:
        """The fate of the motion in a word: the form of the sentence that holds."""
        if self.kind in ("glide", "drift"):
            return self.kind if self.v_0 else "still"
        if self.kind == "under":
            return "swing" if self.oscillator.zeta < HARDLY else "hardly"
        if self.kind not in ("critical", "over"):
            return self.kind
        if not self.x_0:
            return "never"
        if self.v_0 * self.x_0 < 0 and abs(self.v_0) > self.crossing_speed and self.motion.first_zero is not None:
            return "crosses"
        if self.v_0 * self.x_0 > 0:
            return "out"
        return "thrice" if self.kind == "critical" and not self.v_0 else "home"

    @property
    def swings(self) -> bool:
        return self.kind in ("plain", "under")

    @cached_property
    def lasting(self) -> float:
        one = self.oscillator
        if not one.k:
            rate = one.c / one.m
            end = LASTING / rate if rate else NOTHING_OSCILLATES
        else:
            lasting, tau = LASTING / one.rates[0] if one.rates[0] else math.inf, periods(self.omega, 1)
            end = max(2 * tau, min(lasting, 4 * tau) if one.zeta < 1 else lasting)
        if not 0 < end < math.inf:
            raise ValueError("the time in which this motion dies leaves the range of doubles")
        return float(f"{end:.2g}") or end

    @property
    def fastest(self) -> float:
        """The frequency in rad/s that the curves are sampled for: energies swing twice as fast as x."""
        return 2 * self.oscillator.omega_d if self.swings else self.oscillator.rates[1]

    @cached_property
    def peaks(self) -> tuple[Moment, ...]:
        """The first turns on the side of the first one, which is the largest; at rest the start is a turn."""
        if not self.swings:
            return ()
        first, tau = 0.0 if not self.v_0 else self.motion.first_turn or 0.0, 2 * math.pi / self.oscillator.omega_d
        return self._at([first + i * tau for i in range(MOST_PEAKS)])

    @cached_property
    def top(self) -> Moment:
        """Where the mass is fastest."""
        found = self.motion.first_top_speed
        moments = self._at([0.0] if found is None or self.kind == "rest" else [0.0, found])
        return max(moments, key=lambda moment: abs(moment.v))

    def _at(self, times: list[float]) -> tuple[Moment, ...]:
        motion = self.oscillator.motion(self.x_0, self.v_0, times)
        return tuple(map(Moment, times, motion.x.tolist(), motion.v.tolist()))

    @property
    def turning(self) -> float:
        """Where it first turns, in m; its start if it never does."""
        turn = self.motion.first_turn
        return self._at([0.0 if turn is None else turn])[0].x

    @cached_property
    def reach(self) -> float:
        """The largest |x| in the window, in m."""
        turn = self.motion.first_turn
        times = [0.0, self.end] if turn is None or turn > self.end else [0.0, turn, self.end]
        return max(abs(moment.x) for moment in self._at(times))

    @cached_property
    def E_0(self) -> float:
        """The energy at the start, in J."""
        one = self.oscillator
        with precise():
            kinetic, potential = exact(one.m) * exact(self.v_0) ** 2, exact(one.k) * exact(self.x_0) ** 2
            return rounded("the energy at the start", (kinetic + potential) / 2)

    @cached_property
    def P_max(self) -> float:
        """The greatest power in W."""
        return scaled(0, self.oscillator.c, self.top.v, self.top.v)

    @cached_property
    def greatest(self) -> float:
        """The greatest force of spring or dashpot in N, in the window."""
        return max(scaled(0, self.oscillator.k, self.reach), scaled(0, self.oscillator.c, abs(self.top.v)))

    @cached_property
    def envelope(self) -> float:
        """C in m of a swing, the size of its envelope at the start."""
        return self.oscillator.decays(self.x_0, self.v_0)[0].amplitude if self.swings else 0.0

    @cached_property
    def crossing_speed(self) -> float:
        """The speed inward in m/s beyond which it passes 0, where it does not swing."""
        return scaled(0, self.oscillator.rates[1], abs(self.x_0))

    @property
    def roots(self) -> Literal["bare", "pair", "real"]:
        """The kind of the roots in their plane: without a spring, a pair that swings, or both real."""
        return "bare" if not self.oscillator.k else "pair" if self.oscillator.zeta < 1 else "real"
