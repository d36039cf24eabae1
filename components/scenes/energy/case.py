"""A hanging mass as the scene sees it: its start, its window, from where V is counted, and the axes that follow."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from msgspec.structs import replace

from components.quantities.axes import Axis, nice_axis, nice_ticks, time_axis
from components.quantities.declared import Declared, DrawnAxis, by_name
from components.quantities.numbers import at_tick, power_unit, three
from components.scene.frames import Windowed
from components.scene.traces import Floats, samples
from physics.exact import exact, precise, rounded
from physics.hanging import HangingMass
from physics.oscillator import OscillatorConstants
from physics.sampling import periods

FARTHEST = 6.0
"""Amplitudes up to which the natural length is in the picture."""


@dataclass(frozen=True, kw_only=True)
class HangingCase(Windowed):
    """A hanging mass, its start, and from where V is counted."""

    system: HangingMass
    x_0: float
    v_0: float
    datum: str

    @property
    def separate(self) -> bool:
        """Whether V is the sum of spring and gravity, without the constant of the slide."""
        return self.datum == "separate"

    @property
    def apart(self) -> bool:
        """Whether V is drawn term by term."""
        return self.datum in ("separate", "slide")

    @cached_property
    def omega(self) -> float:
        return self.system.omega_n

    @cached_property
    def constants(self) -> OscillatorConstants:
        return self.system.oscillator.constants(self.x_0, self.v_0)

    @cached_property
    def lasting(self) -> float:
        return periods(2 * self.omega, 6)

    @cached_property
    def t(self) -> Floats:
        return np.linspace(0.0, self.end, samples(self.end, 2 * self.omega))

    @cached_property
    def E(self) -> float:
        """T_max; and V_max counted from equilibrium."""
        return self.system.total_energy(self.x_0, self.v_0)

    @cached_property
    def shift(self) -> float:
        return self.system.datum_shift if self.separate else 0.0

    @cached_property
    def total(self) -> float:
        return self.E + self.shift

    @property
    def constant(self) -> float:
        """k delta_st^2/2, which the slide takes off."""
        return self.system.datum_shift

    @cached_property
    def weight(self) -> float:
        """m g C, the largest of the energy of gravity."""
        with precise():
            return rounded("the energy m g C", exact(self.system.m) * exact(self.system.g) * exact(self.constants.C))


class Axes(Declared[HangingCase]):
    t, x, x_well, E, E_time = DrawnAxis.some(5)


def axes_of(case: HangingCase) -> dict[str, Axis]:
    """The energies over time have the axis of the well, whose level has its number there alone."""
    energy = _energy_axis(case)
    total, labelled = energy.place(case.total), zip(energy.ticks, energy.labels, strict=True)
    beside = replace(energy, labels=tuple("" if tick == total else label for tick, label in labelled))
    x = _x_axis(case)
    own = {Axes.t: time_axis(case.own_end), Axes.x: x, Axes.x_well: _well_axis(case, x)}
    return by_name({**own, Axes.E: energy, Axes.E_time: beside})


def _x_axis(case: HangingCase) -> Axis:
    """Downwards, from above the natural length, unless that is far away, to below the lowest point."""
    C, delta = case.constants.C, case.system.delta_st
    high = max(1.25 * C, 1.12 * delta if delta <= FARTHEST * C or not C else 0.0) or 1.0
    low = 1.25 * C or 0.5 * high
    exponent, suffix = power_unit(max(high, low))
    seen = (-delta if 1.12 * delta == high else -C, C)
    bare = Axis(low, -high, "m", exponent, suffix, drawn=seen)
    return replace(bare, ticks=nice_ticks(bare.place(-high), bare.place(0.95 * low), 2))


def _well_axis(case: HangingCase, x: Axis) -> Axis:
    """The axis of the well, in the unit of x; the well is drawn a little beyond the turning points."""
    end = 1.18 * case.constants.C or x.start
    ticks = nice_ticks(x.place(-end), x.place(end), 2)
    C = case.constants.C
    return replace(x, start=-end, end=end, ticks=ticks, drawn=(-C, C))


def _energy_axis(case: HangingCase) -> Axis:
    """The axis from the lowest to the highest energy drawn; the sum T + V has its own tick."""
    top, bottom = case.total, 0.0
    if case.apart:
        top, bottom = case.E + case.constant + case.weight, -case.weight
    if case.datum == "slide":
        bottom = -max(case.weight, case.constant)
    room = 0.11 * (top - bottom) or 1.0
    axis = nice_axis(bottom - (room / 2 if bottom else 0.0), top + room, "J", 2, exact=True)
    total, span = axis.place(case.total), axis.place(axis.end) - axis.place(axis.start)
    ticks = tuple(sorted({*(tick for tick in axis.ticks if abs(tick - total) > 0.16 * span), total}))
    labels = tuple(f"{three(tick)} {axis.full_unit}" if tick == total else at_tick(tick) for tick in ticks)
    return replace(axis, ticks=ticks, labels=labels, drawn=(bottom, top))
