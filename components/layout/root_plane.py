"""The background of a plane of roots s: its axes, and the half plane that has no roots."""

from __future__ import annotations

from components.language.numbers import Number
from components.layout.stage import Shape, line, rectangle, text, wall


def root_plane(sides: tuple[Number, Number, Number, Number], x0: Number, y0: Number, below_zero: str) -> list[Shape]:
    """Return the shapes under the roots, in a frame with these sides: left, right, top, bottom.

    The place s = 0 is at (x0, y0); roots on the right would need `below_zero`.
    """
    left, right, top, bottom = sides
    return [
        rectangle(x0, top, right - x0, bottom - top, style="body", tint="k2fill"),
        line(left, y0, x0, y0, style="floor", tint="ink"),
        wall(x0, top, bottom - top, side="right"),
        text(x0 + 16, y0 - 4, f"{below_zero}:", "start", tint="mute"),
        text(x0 + 16, y0 + 13, "not allowed", "start", tint="mute"),
        text(left + 4, bottom - 24, "left: dies faster", "start", tint="mute"),
        text(left + 4, bottom - 8, "up: swings faster", "start", tint="mute"),
    ]
