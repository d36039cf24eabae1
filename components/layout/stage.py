"""The animated drawing: shapes declared in Python and drawn by the browser.

Every number of a shape may be an expression in named quantities:

    x1, x2, ...     signals of the scene at the current instant, in the unit of their axis
    scalars         numbers of the picture that do not move
    W, H            width and height of the stage in pixels
    t               the current instant in the unit of the time axis
    wide, narrow    1 if plots are next to the stage, and 0 on a phone; `narrow` is the reverse
"""

from __future__ import annotations

from dataclasses import dataclass
from math import log10
from typing import Any, TypeAlias, cast

from msgspec.structs import replace

from components.language.expressions import Expression, Name, Number, named
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
"""Further keyword arguments of a builder: the other fields of its shape in components.language.shapes."""

W, H, T = named("W"), named("H"), named("t")
WIDE, NARROW, LOW, HALL = named("wide"), named("narrow"), named("low"), named("hall")
STACKED = named("stacked")
"""A number that is 1 if blocks are in one column, or if the plots whose lines continue on the stage are hidden."""


@dataclass(frozen=True)
class OfTheStage:
    """A scalar from the browser that selects shapes by the layout of the screen."""

    name: str


ON_WIDE, ON_NARROW, AT_DESK, IN_HALL = (OfTheStage(one) for one in ("wide", "narrow", "desk", "hall"))


@dataclass(frozen=True)
class PlotFrame:
    """The frame of a plot, in pixels of the stage, so that shapes on the stage can continue lines of the plot."""

    name: str

    @property
    def part(self) -> str:
        """The name of the plot among the parts of a sheet."""
        return f"plot:{self.name}"

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
        """The pixels per unit of the horizontal axis."""
        return self.at("x1")

    @property
    def per_y(self) -> Expression:
        """The pixels per unit of the vertical axis, counted downwards: a negative number."""
        return self.at("y1")

    def x(self, value: Number) -> Expression:
        """Return the horizontal position of a value, which is in the unit of the axis, as signals are."""
        return self.at("x0") + self.per_x * value

    def y(self, value: Number) -> Expression:
        """Return the vertical position of a value, which is in the unit of the axis."""
        return self.at("y0") + self.per_y * value

    def at(self, what: str) -> Expression:
        """Return a coordinate of the frame: left, right, top, bottom, the zero of an axis (x0), or its unit (x1)."""
        return named(f"{self.name}.{what}")


def wide(on_wide: Number, narrow: Number) -> Expression:
    """Return the first number if the stage is next to a plot, and the second one on phones."""
    return WIDE * on_wide + NARROW * narrow


def shown_by(by: ShownBy, *shapes: Shape) -> list[Shape]:
    """Return the shapes, which are then also hidden while one of these scalars is 0."""
    return [replace(one, show=(*_shown(by), *one.show)) for one in shapes]


def _shown(by: ShownBy) -> tuple[str, ...]:
    return tuple(one.name for one in (by if isinstance(by, tuple) else (by,)))


def spring(x1: Number, y1: Number, x2: Number, y2: Number, wire: Number = 2.5, **more: Any) -> Shape:
    """Return a spring with nine teeth between two points. A stiffer spring has a thicker wire."""
    return Spring(x1=x1, y1=y1, x2=x2, y2=y2, wire=wire, **{"tint": "k", **_common(more)})


def wire(k: float) -> float:
    """Return the width of a spring's wire: 1.5 to 4 pixels with the logarithm of the stiffness."""
    return min(max(2.2 + 0.9 * log10(k), 1.5), 4.0) if k > 0 else 0.0


def box(x: Number, y: Number, side: Number, label: str = "", **more: Any) -> Shape:
    """Return a square mass; (x, y) is the middle of its lower edge."""
    return Box(x=x, y=y, side=side, label=runs(label), **_common(more))


def line(x1: Number, y1: Number, x2: Number, y2: Number, **more: Any) -> Shape:
    return Line(x1=x1, y1=y1, x2=x2, y2=y2, **_common(more))


def arrow(x1: Number, y1: Number, x2: Number, y2: Number, **more: Any) -> Shape:
    """Return an arrow; `gap` moves it forward by so many pixels."""
    return Arrow(x1=x1, y1=y1, x2=x2, y2=y2, **_common(more))


def circle(x: Number, y: Number, r: Number, **more: Any) -> Shape:
    return Circle(x=x, y=y, r=r, **_common(more))


def path(d: str, x: Number = 0.0, y: Number = 0.0, turn: Number = 0.0, **more: Any) -> Shape:
    """Return a fixed shape from SVG path data, moved to (x, y) and turned by `turn` radians, clockwise on the screen.

    With `dx` and `dy` its right side points in that direction; `sx` and `sy` scale it.
    """
    return Path(d=d, x=x, y=y, turn=turn, **_common(more))


def rectangle(x: Number, y: Number, width: Number, height: Number, **more: Any) -> Shape:
    """Return a filled rectangle with its upper left corner at (x, y)."""
    return path("M0 0H1V1H0Z", x, y, sx=width, sy=height, **more)


def arc(x: Number, y: Number, r: Number, start: Number, end: Number, **more: Any) -> Shape:
    """Return a part of a circle between two angles in rad, measured from straight down, anticlockwise."""
    return Arc(x=x, y=y, r=r, start=start, end=end, **_common(more))


def wave(x: Number, y: Number, length: Number, size: Number, turns: Number, phase: Number = 0.0, **more: Any) -> Shape:
    """Return a sine curve from (x, y) over a length: size sin(2 pi turns s + phase), s from 0 to 1."""
    return Wave(x=x, y=y, length=length, size=size, turns=turns, phase=phase, **_common(more))


def layers(
    x: Number, y: Number, length: Number, height: Number, count: int, size: Number, turns: Number, **more: Any
) -> Shape:
    """Return `count` slices of a medium that begins at (x, y) and extends to the right.

    The edge at the fraction s of the length is displaced to the right by `size` sin(2 pi `turns` s).
    """
    return Layers(x=x, y=y, length=length, height=height, count=count, size=size, turns=turns, **_common(more))


def text(x: Number, y: Number, words: str, anchor: str = "middle", **more: Any) -> Shape:
    """Return a short text, in the notation of `components.layout.text.runs`."""
    return Label(x=x, y=y, words=runs(words), anchor=cast(Anchor, anchor), **_common(more))


def wall(x: Number, y: Number, length: Number, side: str = "left", **more: Any) -> Shape:
    """Return a hatched wall. (x, y) is its upper or left end; the hatching is on the `side`."""
    return Wall(x=x, y=y, length=length, side=cast(Side, side), **_common(more))


def beads(**given: Any) -> Shape:
    """Return the masses of a modal signal with their springs: components.language.shapes.Beads."""
    return Beads(**_common(given))


def _common(more: Looks) -> Looks:
    """Return the attributes of a shape, without missing ones, and with names in place of declared objects."""
    given = {name: value for name, value in more.items() if value is not None}
    if "show" in given:
        given["show"] = _shown(given["show"])
    if "inside" in given:
        given["inside"] = given["inside"].name
    return given
