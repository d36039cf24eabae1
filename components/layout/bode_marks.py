"""Marks on plots over the drive frequency: frequencies as upright lines, and peaks with their widths at half power."""

from __future__ import annotations

from typing import Any

from components.language.expressions import Number
from components.layout.stage import PlotFrame, Shape, circle, line, text


def upright(on: PlotFrame, x: Number, tint: str, **look: Any) -> Shape:
    """A thin line across a plot."""
    return line(x, on.top, x, on.bottom, tint=tint, style="thin", **look)


def peak(x: Number, y: Number, low: Number, high: Number, half: Number, **look: Any) -> tuple[Shape, Shape]:
    """A peak, and the line between the frequencies `low` and `high` of half its power, at the height `half`."""
    return circle(x, y, 4.5, **look), line(low, half, high, half, **look)


def lag_axes(on: PlotFrame) -> list[Shape]:
    """Both axes of a complex plane, with the lags of arrows along them."""
    x, y = on.x(0), on.y(0)
    return [
        line(on.left, y, on.right, y, style="eq", tint="mute"),
        line(x, on.top, x, on.bottom, style="eq", tint="mute"),
        text(on.right - 4, y - 8, "lag 0", "end", tint="mute", style="halo"),
        text(x, on.bottom - 12, "lag 90°", "beside", tint="mute", style="halo"),
    ]
