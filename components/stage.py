"""The animated picture, declared in Python and drawn by the browser.

A stage is a list of shapes. Every number of a shape may be an expression in named quantities: the scene's signals
(x1, x2, ... at the instant shown, in the unit of their axis), its scalars, and W and H, the size of the stage in
pixels; `t` is that instant in the unit of the time axis; `wide` is 1 where plots stand beside the stage and 0 on a
phone, `narrow` the reverse. Expressions are polynomials, so the browser evaluates them without running any code it
was sent.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Union

Number = Union[int, float, "Expression"]
Shape = dict[str, Any]


@dataclass(frozen=True)
class Expression:
    """A polynomial in named quantities: a sum of (coefficient, names) products."""

    terms: tuple[tuple[float, tuple[str, ...]], ...]

    def __add__(self, other: Number) -> Expression:
        return Expression(self.terms + as_expression(other).terms)

    __radd__ = __add__

    def __neg__(self) -> Expression:
        return self * -1

    def __sub__(self, other: Number) -> Expression:
        return self + -as_expression(other)

    def __rsub__(self, other: Number) -> Expression:
        return as_expression(other) - self

    def __mul__(self, other: Number) -> Expression:
        right = as_expression(other).terms
        return Expression(tuple((a * b, m + n) for a, m in self.terms for b, n in right))

    __rmul__ = __mul__

    def __truediv__(self, other: float) -> Expression:
        return self * (1 / other)

    def wire(self) -> list[list[Any]]:
        """The form the browser reads: a list of [coefficient, name, name, ...]."""
        return [[coefficient, *names] for coefficient, names in self.terms]


def as_expression(value: Number) -> Expression:
    return value if isinstance(value, Expression) else Expression(((float(value), ()),))


def var(name: str) -> Expression:
    """A named quantity of the stage."""
    return Expression(((1.0, (name,)),))


W, H = var("W"), var("H")
WIDE, NARROW, T = var("wide"), var("narrow"), var("t")


def on_x(plot: str, value: Number) -> Expression:
    """Where a value of the horizontal axis of a plot stands, in pixels of the stage: stage and plots share lines."""
    return var(f"{plot}.x0") + var(f"{plot}.x1") * value


def on_y(plot: str, value: Number) -> Expression:
    """The same on the vertical axis; the value is in the unit of the axis, as signals are."""
    return var(f"{plot}.y0") + var(f"{plot}.y1") * value


def shape(kind: str, *, tint: str = "ink", **attributes: Any) -> Shape:
    """A shape; expressions among its attributes become their wire form.

    Common attributes: `tint` (colour class), `style` (more classes), `show` (names of scalars, with spaces: drawn while
    none is 0), `inside` (the plot whose frame cuts it), `drag` (the parameter that dragging it sets, with `drag_unit`,
    the pixels of one unit).
    """
    wired = {key: value.wire() if isinstance(value, Expression) else value for key, value in attributes.items()}
    return {"kind": kind, "tint": tint, **{key: value for key, value in wired.items() if value is not None}}


def spring(x1: Number, y1: Number, x2: Number, y2: Number, wire: Number = 2.5, **more: Any) -> Shape:
    """A zigzag of nine teeth between two points: stretch is pitch, stiffness is the width of the wire."""
    return shape("spring", x1=x1, y1=y1, x2=x2, y2=y2, wire=wire, **{"tint": "k", **more})


def block(x: Number, y: Number, side: Number, label: str = "", **more: Any) -> Shape:
    """A square mass, given by the middle of its foot."""
    return shape("block", x=x, y=y, side=side, label=label, **more)


def line(x1: Number, y1: Number, x2: Number, y2: Number, **more: Any) -> Shape:
    return shape("line", x1=x1, y1=y1, x2=x2, y2=y2, **more)


def arrow(x1: Number, y1: Number, x2: Number, y2: Number, **more: Any) -> Shape:
    """An arrow; with a `gap` it is moved ahead along itself by so many pixels."""
    return shape("arrow", x1=x1, y1=y1, x2=x2, y2=y2, **more)


def circle(x: Number, y: Number, r: Number, **more: Any) -> Shape:
    return shape("circle", x=x, y=y, r=r, **more)


def path(d: str, x: Number = 0, y: Number = 0, turn: Number = 0, **more: Any) -> Shape:
    """A fixed outline (SVG path data), moved to (x, y) and turned by `turn` radians, clockwise on the screen.

    With `dx` and `dy` its right end is turned into that direction; `sx` and `sy` scale it.
    """
    return shape("path", d=d, x=x, y=y, turn=turn, **more)


def arc(x: Number, y: Number, r: Number, start: Number, end: Number, **more: Any) -> Shape:
    """Part of a circle, between two angles in rad from straight down, counted to the right (anticlockwise)."""
    return shape("arc", x=x, y=y, r=r, start=start, end=end, **more)


def wave(x: Number, y: Number, length: Number, size: Number, turns: Number, phase: Number = 0, **more: Any) -> Shape:
    """size sin(2 pi turns s + phase) upwards over a length from (x, y); with a `depth` filled down to there."""
    return shape("wave", x=x, y=y, length=length, size=size, turns=turns, phase=phase, **more)


def layers(
    x: Number, y: Number, length: Number, height: Number, count: int, size: Number, turns: Number, **more: Any
) -> Shape:
    """`count` slices of a medium from (x, y) to the right, their edges displaced along it by size sin(2 pi turns s)."""
    return shape("layers", x=x, y=y, length=length, height=height, count=count, size=size, turns=turns, **more)


def text(x: Number, y: Number, words: str, anchor: str = "middle", **more: Any) -> Shape:
    """Words; `{name}` is a signal or a value shown live, `_1` a subscript, `*x*` a symbol in serif italic."""
    return shape("text", x=x, y=y, words=words, anchor=anchor, **more)


def wall(x: Number, y: Number, length: Number, side: str = "left", **more: Any) -> Shape:
    """A hatched wall; (x, y) is its upper or left end, `side` where the solid is: left, top or bottom.

    `depth` is the size of its hatching, 10 pixels where not given.
    """
    return shape("wall", x=x, y=y, length=length, side=side, **more)
