"""Axes of plots, each declared once: its range in SI units is computed from the case of a picture."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from msgspec.structs import replace

from components.language.expressions import Expression, named
from components.quantities.axes import TIME_AXIS, Axis, Range, nice_axis, whole_axis


@dataclass(eq=False)
class PlotAxis:
    """An axis of a plot, or of numbers in texts only.

    `range` returns both ends in SI units. `room` moves both ends by this factor away from 0, or extends the whole axis.
    `count` is the largest number of steps between ticks. A `whole` axis has ticks at both ends only, for parts of a
    total; a `plain` one has no ticks. `seen` is the range that must be visible, if not the whole range. `name` is used
    in links and covers. `like` is an axis of the same quantity; both then have the same unit.
    """

    unit: str
    range: Callable[[Any], Range | Axis]
    name: str = ""
    room: float = 1.0
    count: int = 4
    whole: bool = False
    plain: bool = False
    seen: Callable[[Any], Range] | None = None
    like: PlotAxis | None = None

    @property
    def counting(self) -> PlotAxis:
        """The axis whose unit is used for numbers: `like`, or itself."""
        return self.like or self

    @property
    def is_time(self) -> bool:
        return self.name == TIME_AXIS

    def axis(self, case: Any) -> Axis:
        """Return the axis that fits a case. If both ends are equal, the range is widened."""
        found = self.range(case)
        if isinstance(found, Axis):
            return found
        low, high = found
        if low == high:
            low, high = low - abs(low), high + (abs(high) or 1.0)
        seen = self.seen(case) if self.seen else (low, high)
        if self.whole:
            axis = whole_axis(high, self.unit)
            return replace(axis, end=self.room * axis.end, drawn=(0.0, axis.end))
        ends = self.room * low, self.room * high
        if self.plain:
            return Axis(*ends, self.unit, drawn=seen)
        return replace(nice_axis(*ends, self.unit, self.count, exact=True), drawn=seen)

    @property
    def unit_text(self) -> str:
        """The unit with its power of ten, in a text."""
        return rf"\val{{{self.name}_unit}}"

    @property
    def share(self) -> Expression:
        """One unit of the axis, relative to its upper end."""
        return named(f"{self.name}_share")


def axis(unit: str, range: Callable[[Any], Range | Axis], name: str = "", **more: Any) -> PlotAxis:
    """Return an axis of a plot: see `PlotAxis`. It has the name of its plot unless it has its own."""
    return PlotAxis(unit, range, name, **more)


TIME = axis("s", lambda c: (0.0, c.own_end), TIME_AXIS, count=3)
"""The axis of the time window."""
