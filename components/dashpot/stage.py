"""The drawing of a mass on a spring and a dashpot on a wall."""

from __future__ import annotations

from components.language.expressions import Number
from components.language.shapes import Grab
from components.layout.stage import Shape, box, line, rectangle, shown_by, spring, wall
from components.paper.plots import PictureName

BELOW = 35
"""Pixels from the wall to the lowest position of the block, in addition to the range of motion."""
NARROW_BELOW = 27
"""The same pixels if the dashpot is next to the block."""
CUP = 11
"""Half the width of the cup, in pixels."""


HAS_SPRING, HAS_DASHPOT = PictureName("spring"), PictureName("dashpot")
"""Attributes of every case with a dashpot."""


def apparatus(
    x: Number,
    level: Number,
    side: Number,
    lowest: Number,
    stroke: Number,
    wire: Number,
    grab: Grab,
    lift: Number = 0.0,
    *,
    beside: bool = False,
) -> list[Shape]:
    """The block about (x, level), its spring, and its dashpot at the right, on the wall below.

    With `beside` the dashpot is to the right of the block, which then needs less room below. `lowest` is the lowest
    position of its lower edge, `stroke` its range of motion, `lift` the height of the wall, in pixels.
    """
    foot, floor = level + 0.5 * side, lowest + (NARROW_BELOW if beside else stroke + BELOW) - lift
    left, right = (x, x + 0.5 * side + CUP + 5) if beside else (x - 0.27 * side, x + 0.27 * side)
    hung, bottom = level if beside else foot, floor - 6
    piston = foot + (5 if beside else stroke + 0.5 * BELOW)
    depth = stroke + (NARROW_BELOW if beside else 16)
    top = bottom - depth
    return [
        wall(x - 0.5 * side - 16, floor, side + (60 if beside else 32), side="bottom"),
        spring(left, foot, left, floor, wire, height=9, show=HAS_SPRING),
        *shown_by(
            HAS_DASHPOT,
            rectangle(right - CUP, top, 2 * CUP, depth, style="liquid", tint="T"),
            line(right - CUP, top - 4, right - CUP, bottom, tint="T"),
            line(right + CUP, top - 4, right + CUP, bottom, tint="T"),
            line(right - CUP, bottom, right + CUP, bottom, tint="T"),
            line(right, bottom, right, floor, tint="T"),
            line(right, hung, right, piston, tint="T"),
            line(x, hung, right, hung, tint="T"),
            line(right - CUP + 4, piston, right + CUP - 4, piston, tint="T", style="sum"),
        ),
        box(x, foot, side, "*m*", tint="m1", grab=grab),
    ]
