"""Label collisions in a figure, as in static/scene/label_collisions.js: of two overlapping texts the later one moves up
or down, or is left out."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

AIR = 2.0
"""Pixels between neighbouring texts."""
FAR = 3.5
"""The most lines by which a text moves up or down."""
POINT = 9.0
"""Pixels from a point to the text beside it."""
DROP = 0.37
"""Fraction of its size by which such a text is lower than its point."""
ABOVE, BELOW = 0.78, 0.24
"""Fractions of its size by which a text is above and below its base line."""
TOUCH = 0.01
WIDTHS = {"ijl'|": 0.23, " .,:;!/ftI[]ᵢⱼₗ": 0.29, "()-r°": 0.35, "₀₁₂₃₄₅₆₇₈₉₊₋ₙₚₛₜₐₑₕₖₒᵣᵤᵥₓ²": 0.36,
          "+−=×<>~": 0.59, "ABEKPSVXYCDHNRUGOQω": 0.72, "mMw%W": 0.86}  # fmt: skip
SIZES = {one: width for letters, width in WIDTHS.items() for one in letters}
LETTER, BOLD = 0.56, 1.08
"""The width of any other letter, and how much wider bold ones are, in Helvetica."""


class TextBox(NamedTuple):
    """A rectangle in pixels, y downwards."""

    left: float
    right: float
    top: float
    bottom: float

    def moved(self, across: float, down: float) -> TextBox:
        """Return the box, moved to the right and down."""
        return TextBox(self.left + across, self.right + across, self.top + down, self.bottom + down)

    def meets(self, other: TextBox) -> bool:
        """Return whether two boxes overlap; boxes that only touch do not."""
        wide = self.left < other.right - TOUCH and other.left < self.right - TOUCH
        return wide and self.top < other.bottom - TOUCH and other.top < self.bottom - TOUCH


def text_width(text: str, size: float, bold: bool = False) -> float:
    """Return the width of a text of one line in pixels, to about a tenth; only the browser knows it exactly."""
    return size * sum(SIZES.get(letter, LETTER) for letter in text) * (BOLD if bold else 1.0)


def box_of(row: dict[str, Any]) -> TextBox:
    """Return the box of a text, with some air on both sides."""
    size = float(row["font"].removesuffix("px"))
    width = text_width(row["text"], size, row["bold"] == "bold")
    left = row["x"] - width * {"left": 0.0, "center": 0.5, "right": 1.0}[row["align"]]
    return TextBox(left - AIR / 2, left + width + AIR / 2, row["y"] - ABOVE * size, row["y"] + BELOW * size)


def without_collisions(rows: Iterable[dict[str, Any]], room: TextBox) -> Iterator[dict[str, Any]]:
    """Yield texts that do not overlap and do not leave the room.

    Texts inside boxes come first and stay in place. The others follow in their order, moved as little as possible.
    Texts left or right of the room are left out.
    """
    placed: list[TextBox] = []
    for row in sorted(rows, key=lambda row: row["anchor"] != "inside"):
        if box_of(row).right < room.left or box_of(row).left > room.right:
            continue
        moves = [(row, (0.0, 0.0))]
        if row["anchor"] != "inside":
            moves = [(one, move) for one in _wishes(row) if (move := _move(box_of(one), room, placed))]
        if moves:
            wish, (across, down) = min(moves, key=lambda pair: math.hypot(*pair[1]))
            placed.append(box_of(wish).moved(across, down))
            yield wish | {"x": wish["x"] + across, "y": wish["y"] + down}


def _wishes(row: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the places of a text, best first: one beside a point is on its right or on its left."""
    if row["anchor"] != "beside":
        return [row]
    low = row["y"] + DROP * (box_of(row).bottom - box_of(row).top)
    sides = ((POINT, "left"), (-POINT, "right"))
    return [row | {"x": row["x"] + across, "y": low, "align": align} for across, align in sides]


def _move(box: TextBox, room: TextBox, placed: list[TextBox]) -> tuple[float, float] | None:
    """Return the shortest move of a text into the room and then up or down to a free place, or None.

    A text wider than the room is not moved across."""
    wide = box.right - box.left > room.right - room.left
    across = 0.0 if wide else max(min(0.0, room.right - box.right), room.left - box.left)
    inward = max(min(0.0, room.bottom - box.bottom), room.top - box.top)
    most = FAR * (box.bottom - box.top)
    box = box.moved(across, inward)
    downs = [0.0, *(down for one in placed for down in (one.top - box.bottom, one.bottom - box.top))]
    for down in sorted(downs, key=abs):
        to = box.moved(0.0, down)
        if abs(down) > most or to.top < room.top or to.bottom > room.bottom:
            continue
        if not any(to.meets(one) for one in placed):
            return across, inward + down
    return None
