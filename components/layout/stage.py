"""The animated drawing: shapes declared in Python and drawn by the browser.

Every number of a shape may be an expression in named quantities: the scene's signals (x1, x2, ... at the current
instant, in the unit of their axis), its scalars, and W and H, the size of the stage in pixels; `t` is the instant in
the unit of the time axis; `wide` is 1 if plots are next to the stage and 0 on a phone, `narrow` the reverse.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import log10
from typing import Any, TypeAlias, cast

from msgspec.structs import replace

from components.language.numbers import Expression, Name, Number, named
from components.language.shapes import (
    Anchor,
    AnyShape,
    Arc,
    Arrow,
    Beads,
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
ShownBy: TypeAlias = Name | tuple[Name, ...]
"""The scalars that decide whether a shape is drawn."""
Looks: TypeAlias = dict[str, Any]
"""Further attributes of a shape, as its builder takes them: each kind has its own."""

W, H, T = named("W"), named("H"), named("t")
WIDE, NARROW, LOW, HALL = named("wide"), named("narrow"), named("low"), named("hall")
STACKED = named("stacked")
"""1 if blocks are stacked, or if the plots that the stage continues are hidden."""


@dataclass(frozen=True)
class OfTheStage:
    """A scalar from the browser that selects shapes by the layout of the screen."""

    name: str


ON_WIDE, ON_NARROW, AT_DESK, IN_HALL = (OfTheStage(one) for one in ("wide", "narrow", "desk", "hall"))


@dataclass(frozen=True)
class PlotFrame:
    """The frame of the plot of this name, in pixels of the stage: stage and plots share lines."""

    name: str

    @property
    def left(self) -> Expression:
        return self.at("left")

    @property
    def right(self) -> Expression:
        return self.at("right")

    @property
    def top(self) -> Expression:
        return self.at("top")

    @property
    def bottom(self) -> Expression:
        return self.at("bottom")

    @property
    def per_x(self) -> Expression:
        """The pixels that one of the horizontal axis takes."""
        return self.at("x1")

    @property
    def per_y(self) -> Expression:
        """The pixels that one of the vertical axis takes, downwards: it is negative."""
        return self.at("y1")

    def x(self, value: Number) -> Expression:
        """The place of a value of the horizontal axis, in the unit of the axis, as signals are."""
        return self.at("x0") + self.per_x * value

    def y(self, value: Number) -> Expression:
        """The place of a value of the vertical axis."""
        return self.at("y0") + self.per_y * value

    def at(self, what: str) -> Expression:
        """A place of the frame: left, right, top, bottom, of an axis its zero (x0) and the pixels of one (x1)."""
        return named(f"{self.name}.{what}")


def wide(on_wide: Number, narrow: Number) -> Expression:
    """Return a number for stages next to plots, and another one for phones."""
    return WIDE * on_wide + NARROW * narrow


def shown_by(by: ShownBy, *shapes: Shape) -> list[Shape]:
    """The shapes, drawn only while none of these further scalars is 0 either."""
    return [replace(one, show=(*_shown(by), *one.show)) for one in shapes]


def _shown(by: ShownBy) -> tuple[str, ...]:
    return tuple(one.name for one in (by if isinstance(by, tuple) else (by,)))


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


def rectangle(x: Number, y: Number, width: Number, height: Number, **more: Any) -> Shape:
    """A filled rectangle with its upper left corner at (x, y)."""
    return path("M0 0H1V1H0Z", x, y, sx=width, sy=height, **more)


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


def beads(**given: Any) -> Shape:
    """The masses of a modal signal on their springs: components.language.shapes.Beads."""
    return Beads(**_common(given))


def _common(more: Looks) -> Looks:
    """Return the attributes of a shape: missing ones are dropped, named things are replaced by their declarations."""
    given = {name: value for name, value in more.items() if value is not None}
    if "show" in given:
        given["show"] = _shown(given["show"])
    if "inside" in given:
        given["inside"] = given["inside"].name
    return given
