"""The animated picture: shapes declared in Python and drawn by the browser.

Every number of a shape may be an expression in named quantities: the scene's signals (x1, x2, ... at the instant
shown, in the unit of their axis), its scalars, and W and H, the size of the stage in pixels; `t` is that instant in the
unit of the time axis; `wide` is 1 where plots stand beside the stage and 0 on a phone, `narrow` the reverse.
"""

from __future__ import annotations

from math import log10
from typing import Any, TypeAlias, cast

from msgspec.structs import replace

from components.language.numbers import Expression, Number, var
from components.language.shapes import (
    Anchor,
    AnyShape,
    Arc,
    Arrow,
    Box,
    Circle,
    Label,
    Layers,
    Line,
    Path,
    Side,
    Spring,
    Wall,
    Wave,
)
from components.layout.text import runs

Shape: TypeAlias = AnyShape
Looks: TypeAlias = dict[str, Any]
"""Further attributes of a shape, as its builder takes them: each kind has its own."""

W, H = var("W"), var("H")
WIDE, NARROW, LOW, HALL, T = var("wide"), var("narrow"), var("low"), var("hall"), var("t")


def on_x(plot: str, value: Number) -> Expression:
    """The place of a value of a plot's horizontal axis, in pixels of the stage: stage and plots share lines."""
    return var(f"{plot}.x0") + var(f"{plot}.x1") * value


def on_y(plot: str, value: Number) -> Expression:
    """The place of a value on the vertical axis of a plot; the value is in the unit of the axis, as signals are."""
    return var(f"{plot}.y0") + var(f"{plot}.y1") * value


def shown_by(names: str, *shapes: Shape) -> list[Shape]:
    """The shapes, drawn only while none of these further scalars (names with spaces between) is 0 either."""
    return [replace(one, show=(*names.split(), *one.show)) for one in shapes]


def spring(x1: Number, y1: Number, x2: Number, y2: Number, wire: Number = 2.5, **more: Any) -> Shape:
    """A zigzag of nine teeth between two points: stretch is pitch, stiffness is the width of the wire."""
    return Spring(x1=x1, y1=y1, x2=x2, y2=y2, wire=wire, **{"tint": "k", **_common(more)})


def wire(k: float) -> float:
    """Width of a spring's wire: 1.5 to 4 pixels with the logarithm of the stiffness."""
    return min(max(2.2 + 0.9 * log10(k), 1.5), 4.0) if k > 0 else 0.0


def box(x: Number, y: Number, side: Number, label: str = "", **more: Any) -> Shape:
    """A square mass, given by the middle of its foot."""
    return Box(x=x, y=y, side=side, label=runs(label), **_common(more))


def line(x1: Number, y1: Number, x2: Number, y2: Number, **more: Any) -> Shape:
    return Line(x1=x1, y1=y1, x2=x2, y2=y2, **_common(more))


def arrow(x1: Number, y1: Number, x2: Number, y2: Number, **more: Any) -> Shape:
    """An arrow; with a `gap` it is moved ahead along itself by so many pixels."""
    return Arrow(x1=x1, y1=y1, x2=x2, y2=y2, **_common(more))


def circle(x: Number, y: Number, r: Number, **more: Any) -> Shape:
    return Circle(x=x, y=y, r=r, **_common(more))


def path(d: str, x: Number = 0.0, y: Number = 0.0, turn: Number = 0.0, **more: Any) -> Shape:
    """A fixed outline (SVG path data), moved to (x, y) and turned by `turn` radians, clockwise on the screen.

    With `dx` and `dy` its right end is turned into that direction; `sx` and `sy` scale it.
    """
    return Path(d=d, x=x, y=y, turn=turn, **_common(more))


def arc(x: Number, y: Number, r: Number, start: Number, end: Number, **more: Any) -> Shape:
    """Part of a circle, between two angles in rad from straight down, counted to the right (anticlockwise)."""
    return Arc(x=x, y=y, r=r, start=start, end=end, **_common(more))


def wave(x: Number, y: Number, length: Number, size: Number, turns: Number, phase: Number = 0.0, **more: Any) -> Shape:
    """size sin(2 pi turns s + phase) upwards over a length from (x, y); with a `depth` filled down to there."""
    return Wave(x=x, y=y, length=length, size=size, turns=turns, phase=phase, **_common(more))


def layers(
    x: Number, y: Number, length: Number, height: Number, count: int, size: Number, turns: Number, **more: Any
) -> Shape:
    """`count` slices of a medium from (x, y) to the right, their edges displaced along it by size sin(2 pi turns s)."""
    return Layers(x=x, y=y, length=length, height=height, count=count, size=size, turns=turns, **_common(more))


def text(x: Number, y: Number, words: str, anchor: str = "middle", **more: Any) -> Shape:
    """Words: source for `components.layout.text.runs`."""
    return Label(x=x, y=y, words=runs(words), anchor=cast(Anchor, anchor), **_common(more))


def wall(x: Number, y: Number, length: Number, side: str = "left", **more: Any) -> Shape:
    """A hatched wall; (x, y) is its upper or left end, `side` where the solid is.

    `depth` is the size of its hatching, 10 pixels where not given.
    """
    return Wall(x=x, y=y, length=length, side=cast(Side, side), **_common(more))


def _common(more: Looks) -> Looks:
    """Attributes as a shape has them: those not given are left out, the scalars of `show` come as words of one text."""
    given = {name: value for name, value in more.items() if value is not None}
    return {**given, "show": tuple(given["show"].split())} if "show" in given else given
