"""Axes: a range in SI units, a suitable unit, and round numbers for its labels."""

from __future__ import annotations

import math
from decimal import Decimal
from functools import cached_property
from typing import TypeVar

import numpy as np
from msgspec import Struct
from msgspec.structs import replace
from numpy.typing import NDArray

from components.language.picture import Digits, Ruler
from components.quantities.formatting import at_tick, power_unit, ten, three

TIME_AXIS = "t"
"""The name of the axis of the time window, which the clock runs through."""
Range = tuple[float, float]
Scaled = TypeVar("Scaled", float, NDArray[np.float64])
LEAST = 1e-10
"""The smallest value, in the unit of its axis, that a live number resolves, with 12 decimals. Without this limit,
numbers
on an axis that has become far too large would have hundreds of decimals.
"""


class Axis(Struct, frozen=True, dict=True):  # `replace` of a Struct is ten times as fast as of a dataclass
    """The range of an axis in SI units, and its labels: in units of `factor` (in SI) times 10**exponent.

    Ticks are labelled by their numbers, or by `labels` if given. With a `power` the axis shows that power of the
    number: columns and handles have omega, the axis shows omega^2. `drawn` is the part of the range that must be
    visible, if not all of it; `own` is the range that the scene has chosen, if the frame has another one. `count` is
    the largest number of steps between round numbers. `si` is the SI unit, if `unit` is another one or "". `zero` is
    False if the scene labels its zero.
    """

    start: float
    end: float
    unit: str = ""
    exponent: int = 0
    suffix: str = ""
    ticks: tuple[float, ...] = ()
    log: bool = False
    factor: float = 1.0
    power: int = 1
    labels: tuple[str, ...] = ()
    drawn: Range | None = None
    own: Range | None = None
    count: int = 4
    si: str = ""
    zero: bool = True

    @property
    def chosen(self) -> Range:
        """Return the range that the scene has chosen."""
        return self.own or (self.start, self.end)

    @property
    def seen(self) -> Range:
        """Return the range of values that must be in the frame, from the lower to the upper end."""
        return ordered(self.drawn or self.chosen)

    def places(self, values: NDArray[np.float64] | float) -> NDArray[np.float64]:
        """Return the positions of values on this axis, in its unit; base-ten logarithms on a log axis."""
        measured = np.asarray(values, dtype=float) / self.factor
        if self.log:
            return np.log10(np.maximum(measured, 5e-324))
        return scale_by_ten(measured, -(self.exponent // self.power)) ** self.power

    def place(self, value: float) -> float:
        """Return the position of a value on this axis, in its unit, for scalars and marks. Raises OverflowError beyond
        the range of doubles.
        """
        if self.log or self.power != 1:
            return float(self.places(value))
        place = float(scale_by_ten(value / self.factor, -self.exponent))
        if math.isinf(place) and not math.isinf(value):
            raise OverflowError(f"{value} has no place on an axis in units of {self.factor}e{self.exponent}")
        return place

    def value(self, place: float) -> float:
        """Return the value at a position of this axis: the inverse of `place`."""
        if self.log:
            return float(10.0**place * self.factor)
        return float(place ** (1 / self.power) * 10.0 ** (self.exponent / self.power) * self.factor)

    @property
    def full_unit(self) -> str:
        """Return the unit with the power of ten before it."""
        return f"{self.suffix}{self.unit}"

    @property
    def gap(self) -> str:
        """Return the space between a number and the unit: none before a degree sign."""
        return "" if self.full_unit == "°" else " "

    def digits(self, signed: bool = False) -> Digits:
        """Return the format of a live number on this axis: its decimals, and if its sign is always shown."""
        largest = max(LEAST, *(abs(self.place(end)) for end in self.chosen))
        return Digits(max(0, 2 - math.floor(math.log10(largest))), signed)

    def number(self, value: float) -> str:
        """Return a value in this axis' unit, with three digits."""
        return three(self.place(value))

    @cached_property
    def ruler(self) -> Ruler:
        """Return the axis as a message contains it."""
        labels = [at_tick(tick) for tick in self.ticks]
        if self.log:
            powers = all(tick.is_integer() for tick in self.ticks)
            labels = [ten(round(tick)) if powers else at_tick(10.0**tick) for tick in self.ticks]
        if self.labels:
            labels = list(self.labels)
        elif self.ticks and self.unit:
            labels[-1] += self.gap + self.full_unit
        start, end = self.place(self.start), self.place(self.end)
        ticks = tuple(float(tick) for tick in self.ticks)
        return Ruler(
            start=start,
            end=end,
            ticks=ticks,
            labels=tuple(labels),
            unit=self.full_unit,
            exponent=self.exponent,
            factor=self.factor,
            power=self.power,
            log=self.log,
        )


ONE = Axis(-1.0, 1.0)
"""The axis of pure numbers of order one: sines, cosines, shares."""


def ordered(span: Range) -> Range:
    """Return the range from its lower to its upper end."""
    return min(span), max(span)


def scale_by_ten(values: Scaled, exponent: int) -> Scaled:
    """Return values * 10**exponent, in two steps so that no power of ten leaves the range of doubles."""
    half = exponent // 2
    return values * 10.0**half * 10.0 ** (exponent - half) if exponent else values


def nice_axis(
    low: float, high: float, unit: str = "", count: int = 4, exact: bool = False, factor: float = 1.0
) -> Axis:
    """An axis over [low, high] with at most `count` + 1 round ticks. It is extended beyond the curve, unless `exact`.

    `factor` is the unit of its labels in SI: 0.3048 for feet.
    """
    drawn = (low, high)
    if not high > low:
        middle = abs(low) or factor
        low, high = low - middle, high + middle
    exponent, suffix = power_unit(max(abs(low), abs(high)) / factor)
    bare = Axis(low, high, unit, exponent, suffix, factor=factor)
    a, b = bare.place(low), bare.place(high)
    margin = 0.0 if exact else 0.08 * (high - low)
    ticks = nice_ticks(a, b, count)
    # A tick on one side of 0 has a counterpart on the other side.
    least, most = bare.place(low - margin), bare.place(high + margin)
    ticks = tuple(sorted({*ticks, *(-tick for tick in ticks if least <= -tick <= most)}))
    return replace(bare, start=low - margin, end=high + margin, ticks=ticks, drawn=drawn, count=count)


def squared_axis(end: float, unit: str, count: int = 5) -> Axis:
    """Return an axis of the squares of numbers from 0 to `end`, whose exponents may be twice those of doubles."""
    exponent = 6 * (Decimal(end).adjusted() // 3) if not 1e-3 <= end < 1e2 else 0
    bare = Axis(0.0, end, unit, exponent, f"{ten(exponent)} " if exponent else "", power=2)
    return replace(bare, ticks=nice_ticks(0.0, bare.place(end), count), count=count)


def round_ticks(axis: Axis) -> tuple[float, ...]:
    """Return round numbers over the final range of an axis."""
    ends = ordered((axis.place(axis.start), axis.place(axis.end)))
    return tuple(tick for tick in nice_ticks(*ends, axis.count) if tick or axis.zero)


def nice_ticks(low: float, high: float, count: int) -> tuple[float, ...]:
    """Return multiples of a round step within [low, high]: at most `count` + 1, at least two if the range allows."""
    part = (high - low) / count
    if not 0 < part < math.inf:
        raise ArithmeticError(f"no ticks from {low} to {high}")
    power = 10.0 ** math.floor(math.log10(part))
    for step in (f * power for f in (1, 2, 2.5, 4, 5, 10)):
        first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
        if last - first <= count:
            break
    return tuple(step * i for i in range(first, last + 1))


def log_axis(low: float, high: float, unit: str = "", count: int = 5, factor: float = 1.0) -> Axis:
    """Return a logarithmic axis with ticks at powers of ten; if fewer than two are in the range, at other round
    numbers.
    """
    start, end, low, high = low, high, low / factor, high / factor
    least, most = math.log10(low) - 1e-9, math.log10(high) + 1e-9
    first, last = math.ceil(least), math.floor(most)
    step = max(1, math.ceil((last - first) / count))
    ticks = tuple(float(p) for p in range(first, last + 1, step))
    if len(ticks) < 2:
        round_ones = (n + math.log10(digit) for n in range(first - 1, last + 1) for digit in (1, 2, 5))
        ticks = tuple(tick for tick in round_ones if least <= tick <= most)
    if len(ticks) < 2 and 1e-300 < low < 0.999 * high:
        ticks = tuple(math.log10(tick) for tick in nice_ticks(low, high, count))
    return Axis(start, end, unit, ticks=ticks, log=True, factor=factor, count=count)


def square_axes(across: Range, up: Range, unit: str = "") -> tuple[Axis, Axis]:
    """Return two axes of one length, for a plane, with some room around both ranges."""
    half = 0.54 * max(high - low for low, high in (across, up))
    first, second = ((low + high) / 2 for low, high in (across, up))
    x, y = (nice_axis(middle - half, middle + half, unit, 4, exact=True) for middle in (first, second))
    return x, y


def whole_axis(end: float, unit: str) -> Axis:
    """Return an axis from 0 to `end` with both ends labelled, for shares of a total."""
    axis = nice_axis(0.0, end, unit, exact=True)
    top = float(f"{axis.place(axis.end):.3g}")
    return replace(axis, ticks=(0.0, top), labels=("0", f"{at_tick(top)}{axis.gap}{axis.full_unit}"))


def time_axis(end: float) -> Axis:
    """Return the axis of a time window from 0 to `end` seconds."""
    return nice_axis(0.0, end, "s", 3, exact=True)


def widest(*ranges: tuple[float, float]) -> tuple[float, float]:
    """Return the smallest range that contains all of these."""
    return min(low for low, _ in ranges), max(high for _, high in ranges)
