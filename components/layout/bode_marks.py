"""Marks on plots over the drive frequency: frequencies as upright lines, and peaks with their widths at half power."""

from __future__ import annotations

from typing import Any

from components.language.expressions import Number
from components.layout.stage import PlotFrame, Shape, circle, line


def upright(on: PlotFrame, x: Number, tint: str, **look: Any) -> Shape:
    """A thin line across a plot."""
    return line(x, on.top, x, on.bottom, tint=tint, style="thin", **look)


def peak(x: Number, y: Number, low: Number, high: Number, half: Number, **look: Any) -> tuple[Shape, Shape]:
    """A peak, and the line between the frequencies `low` and `high` of half its power, at the height `half`."""
    return circle(x, y, 4.5, **look), line(low, half, high, half, **look)
