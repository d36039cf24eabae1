"""A mass on a spring and a dashpot as it stands on a wall: the piston never leaves its cup."""

from __future__ import annotations

from components.language.numbers import Number
from components.language.shapes import Grab
from components.layout.stage import Shape, box, line, path, shown_by, spring, wall

SQUARE = "M0 0H1V1H0Z"
BELOW = 35
"""Pixels that the wall lies below the lowest place of the block, besides a stroke."""
CUP = 11
"""Half the width of the cup, in pixels."""


def apparatus(
    x: Number, level: Number, side: Number, lowest: Number, stroke: Number, wire: Number, grab: Grab
) -> list[Shape]:
    """The block about (x, level), its spring at the left and its dashpot at the right, from the wall under them.

    `lowest` is the lowest place of its foot, `stroke` how far it moves, all in pixels.
    """
    foot, floor = level + 0.5 * side, lowest + stroke + BELOW
    left, right = x - 0.27 * side, x + 0.27 * side
    piston, bottom = foot + stroke + 0.5 * BELOW, floor - 6
    top = bottom - stroke - 16
    return [
        wall(x - 0.5 * side - 16, floor, side + 32, side="bottom"),
        spring(left, foot, left, floor, wire, height=9, show="has_spring"),
        *shown_by(
            "has_dashpot",
            path(SQUARE, right - CUP, top, sx=2 * CUP, sy=stroke + 16, style="liquid", tint="T"),
            line(right - CUP, top - 4, right - CUP, bottom, tint="T"),
            line(right + CUP, top - 4, right + CUP, bottom, tint="T"),
            line(right - CUP, bottom, right + CUP, bottom, tint="T"),
            line(right, bottom, right, floor, tint="T"),
            line(right, foot, right, piston, tint="T"),
            line(right - CUP + 4, piston, right + CUP - 4, piston, tint="T", style="sum"),
        ),
        box(x, foot, side, "*m*", tint="m1", grab=grab),
    ]
