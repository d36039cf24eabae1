"""The background of a plane of roots s: its axes, and the half plane that has no roots."""

from __future__ import annotations

from components.language.expressions import Number
from components.layout.stage import Shape, line, rectangle, text, wall


def root_plane(sides: tuple[Number, Number, Number, Number], x0: Number, y0: Number, below_zero: str) -> list[Shape]:
    """Return the background shapes of a frame with these sides in pixels: left, right, top, bottom.

    s = 0 is at (x0, y0). The right half plane is hatched, because roots there need `below_zero`: negative damping.
    """
    left, right, top, bottom = sides
    legend = "up: swings faster", "left: decays faster", f"right: only for {below_zero}"
    return [
        rectangle(x0, top, right - x0, bottom - top, style="body", tint="k2fill"),
        line(left, y0, x0, y0, style="floor", tint="ink"),
        wall(x0, top, bottom - top, side="right"),
        *(text(left + 4, bottom - 8 - 16 * i, words, "start", tint="mute") for i, words in enumerate(legend)),
    ]
