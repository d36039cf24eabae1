"""A driven motion as the scene sees it: how it is driven, its steady part, what it does at first, and its window."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from components.quantities.motion import scaled
from components.scene.frames import Windowed
from components.scene.traces import Floats, samples
from physics.damped import Fading
from physics.driven import Drive, DrivenOscillator, Push, drawn, half_power, lag, magnification
from physics.sampling import drawable, periods

KINDS: tuple[Drive, ...] = ("force", "base", "unbalance")
SWINGS, LONG = 6, 12
"""Natural periods in a window; those of a motion that hardly dies."""
HARDLY = 0.02
"""The damping ratio up to which it hardly dies."""
ALIKE = 0.02
"""rad; without a dashpot a drive that gets no further from the own swing in the window is at resonance."""
APART = 4.0
"""The parts are drawn while they are less than this many times as large as their sum."""
UNSEEN = 0.002
"""The share of the largest |x| that is less than half a pixel of the tallest plot."""


@dataclass(frozen=True, kw_only=True)
class DrivenCase(Windowed):
    """An oscillator, its drive (`size` is F_0 in N, Y in m, mu e in kg m), its start."""

    oscillator: DrivenOscillator
    kind: Drive
    size: float
    omega: float
    x_0: float
    v_0: float

    @cached_property
    def omega_n(self) -> float:
        return self.oscillator.free.omega_n

    @cached_property
    def zeta(self) -> float:
        return self.oscillator.free.zeta

    @cached_property
    def r(self) -> float:
        return scaled(0, self.omega, 1 / self.omega_n)

    @property
    def pushed(self) -> bool:
        return bool(self.size and self.omega)

    @cached_property
    def lasting(self) -> float:
        swings = LONG if self.zeta < HARDLY else SWINGS
        slow = min(self.omega_n, 2.5 * self.omega) if self.pushed else self.omega_n
        end = periods(slow, swings)
        return float(f"{end:.2g}") or end

    @property
    def fastest(self) -> float:
        return max(self.oscillator.free.omega_d, self.omega if self.pushed else 0.0)

    @cached_property
    def t(self) -> Floats:
        return np.linspace(0.0, self.end, samples(self.end, self.fastest))

    @property
    def shaken(self) -> bool:
        """Whether the base moves."""
        return self.kind == "base" and self.pushed

    @cached_property
    def resonant(self) -> bool:
        """Whether there is no steady part: at resonance without a dashpot."""
        return self.oscillator.at_resonance(self.omega)

    @cached_property
    def grows(self) -> bool:
        """Whether, without a dashpot, the drive is at resonance as far as the window tells."""
        detuning = abs(self.push.detuning) * self.end
        return not self.oscillator.c and (self.resonant or detuning < ALIKE)

    @property
    def swells(self) -> bool:
        """Whether the swing grows, under a push."""
        return self.grows and self.pushed

    @cached_property
    def X(self) -> complex:
        """The steady part x_p = Im(X exp(i omega t)) in m; infinite at an undamped resonance."""
        return self.oscillator.response(self.omega, self.size, self.kind)

    @cached_property
    def ratio(self) -> complex:
        """X over F_0/k, over Y, or over m_0 e/m."""
        return complex(magnification(self.r, self.zeta, self.kind)[0])

    @cached_property
    def lag(self) -> float:
        """The angle in rad by which x lags the drive."""
        return lag(self.ratio)

    @cached_property
    def M(self) -> float:
        """The magnification."""
        return abs(self.ratio)

    @property
    def steady(self) -> bool:
        """Whether the steady part has a size."""
        return not self.grows and math.isfinite(self.M)

    @cached_property
    def push(self) -> Push:
        return self.oscillator.push(self.omega, self.size, self.kind)

    @cached_property
    def free(self) -> tuple[Fading, Fading]:
        """x and v of the start alone."""
        x, v, _ = self.oscillator.free.fading(self.x_0, self.v_0)
        return x, v

    @cached_property
    def complementary(self) -> Fading:
        """x beside the steady part."""
        return self.oscillator.free.fading(*self.start)[0]

    @cached_property
    def start(self) -> tuple[float, float]:
        """The start of the complementary part, in m and m/s."""
        return self.x_0 - self.X.imag, self.v_0 - scaled(0, self.omega, self.X.real)

    def drawn(self, t: Floats) -> tuple[Floats, Floats]:
        """x and v in doubles, as they are drawn."""
        x, v = drawn(self.push, t)
        return x + self.free[0].at(t), v + self.free[1].at(t)

    @cached_property
    def _sampled(self) -> float:
        """The largest |x| at the instants that are drawn, in m."""
        return float(np.abs(self.drawn(self.t)[0]).max())

    @cached_property
    def reach(self) -> float:
        """The largest |x| in the window, in m; of parts that are too fast for a line, the bound."""
        if not (self.split and (self.steady_is_fast or self.dying_is_fast)):
            return self._sampled
        return float((np.abs(self.slow_part) + self.fast_size).max())

    @property
    def tallest(self) -> float:
        """The largest displacement that is drawn, of the mass or of its base, in m; 1 where nothing moves."""
        return max(self.reach, self.size if self.kind == "base" else 0.0) or 1.0

    @property
    def steady_is_fast(self) -> bool:
        """Whether the steady part, or the base, is too fast for a line."""
        return self.pushed and not drawable(self.omega, self.t)

    @property
    def dying_is_fast(self) -> bool:
        """Whether the complementary part is too fast for a line."""
        return not drawable(self.oscillator.free.omega_d, self.t)

    @cached_property
    def ringing(self) -> Floats:
        """The size in m that is left of the complementary part, which swings, at the instants that are drawn."""
        one = self.complementary
        size = math.hypot(one.start, one.rate / one.swing) if one.swing else abs(one.start) + sum(map(abs, one.late))
        return np.asarray(size * np.exp(-one.slow * self.t))

    @cached_property
    def fast_size(self) -> Floats:
        """The size in m of what of x is too fast for a line; two parts that beat slowly swing as one."""
        steady, one = self.steady_is_fast * abs(self.X), self.complementary
        if not (self.steady_is_fast and self.dying_is_fast and drawable(one.swing - self.omega, self.t)):
            return steady + self.dying_is_fast * self.ringing
        beat = complex(-one.slow, one.swing - self.omega) * self.t
        return np.asarray(np.abs(self.X + complex(one.rate / one.swing, one.start) * np.exp(beat)))

    @cached_property
    def slow_part(self) -> Floats:
        """The sum of those parts of x that are slow enough for a line, in m, at the instants that are drawn."""
        steady = (self.X * np.exp(1j * self.omega * self.t)).imag if not self.steady_is_fast else np.zeros_like(self.t)
        return steady if self.dying_is_fast else steady + self.complementary.at(self.t)

    @cached_property
    def settled(self) -> int:
        """The index of the first instant from which nothing is seen of ringing that is too fast for a line."""
        return int(np.count_nonzero(self.ringing > UNSEEN * self.tallest)) if self.dying_is_fast else 0

    @property
    def trembles(self) -> bool:
        """Whether the steady part is too fast for a line, and large enough to be seen."""
        return self.steady_is_fast and abs(self.X) > UNSEEN * self.tallest

    @cached_property
    def split(self) -> bool:
        """Whether the motion is shown in its parts: near an undamped resonance these are huge and opposite."""
        if not self.pushed or self.grows:
            return False
        return abs(self.X) <= APART * max(self._sampled, abs(self.X) / LONG) and math.isfinite(abs(self.X))

    @cached_property
    def growth(self) -> float:
        """The growth from swing to swing of an undamped resonance, in m."""
        return scaled(0, math.pi, math.hypot(self.push.re, self.push.im), 1 / self.omega, 1 / self.omega)

    @property
    def rate(self) -> float:
        """The growth in m/s."""
        return self.growth * self.omega / (2 * math.pi)

    @cached_property
    def half_power(self) -> tuple[float, float] | None:
        """omega below and above omega_n at which the dashpot takes half of its most, where that is drawn."""
        if self.kind != "force" or not 0.02 < self.zeta < 0.6:
            return None
        below, above = half_power(self.zeta)
        return below * self.omega_n, above * self.omega_n

    @property
    def past_half(self) -> float:
        """The r beyond which response and power are lower than half of Q."""
        z = self.zeta * self.zeta
        return max(half_power(self.zeta)[1], math.sqrt(1 - 2 * z + 2 * self.zeta * math.sqrt(3 + z)))

    @cached_property
    def work(self) -> float:
        """The work of a cycle of the steady part in J, all of it the dashpot's."""
        stroke = self.X - self.size if self.kind == "base" else self.X
        return scaled(0, math.pi, self.oscillator.c, self.omega, abs(stroke), abs(stroke))
