"""Shapes: the parts of a stage. Every number of a shape may be an expression; sizes are pixels of the stage."""

from __future__ import annotations

from typing import Literal, TypeAlias

from msgspec import Struct

from components.language.numbers import Number
from components.language.text import Runs

Anchor: TypeAlias = Literal["start", "middle", "end", "beside"]
Side: TypeAlias = Literal["left", "right", "top", "bottom"]


class Way(Struct, frozen=True, kw_only=True, tag_field="kind"):
    """A rule that makes a value of `parameter`, of which one is `size` in SI, of the place of a hand; "" sets nothing.

    `moves` is the signal or scalar, counted on `axis` ("" for one without), that is drawn where the hand is, at once.
    A flick adds its velocity to the start of the parameter `rate`.
    """

    parameter: str = ""
    moves: str = ""
    axis: str = ""
    size: float = 1.0
    rate: str = ""


class Stretch(Way, frozen=True, kw_only=True):
    """A way along a line: 0 stands at the pixel `zero`, one of the axis is `unit` pixels long, to the right or down; a
    hand takes it no lower than `least` and no higher than `most`, both in SI."""

    across: Literal["x", "y"]
    zero: Number
    unit: Number
    least: float | None = None
    most: float | None = None


class Along(Stretch, frozen=True, kw_only=True, tag="along"):
    """A way whose value is the place of the hand."""


class Share(Stretch, frozen=True, kw_only=True, tag="share"):
    """A way to set one of two parts of a value: `share` times the place of the hand, and the signal `rest`."""

    share: Number
    rest: str


class Quotient(Stretch, frozen=True, kw_only=True, tag="quotient"):
    """A way that sets the value of `over`, divided by the place of the hand."""

    over: str


class Root(Stretch, frozen=True, kw_only=True, tag="root"):
    """A way to hold a root of s^2 + 2 z s + 1 by its distance p to the left of the imaginary axis, and to set z: p on
    the circle, (p + 1/p)/2 on the real axis, where it is beyond 1 or says `real`."""

    real: bool = False


class Swung(Stretch, frozen=True, kw_only=True, tag="swung"):
    """A way that takes the place of the hand, times `counted`, as a turning point of a sine: the value is its
    amplitude, or where `of` says so its phase, in rad. What moves is `share` of it. A flick gives it a velocity; `turn`
    is the signal of its argument."""

    of: Literal["amplitude", "phase"]
    counted: Number
    share: Number
    turn: str


class Turn(Way, frozen=True, kw_only=True, tag="turn"):
    """A way about a point (x, y): the angle in rad, from straight down, counted to the right (anticlockwise): 0 stands
    at `zero`, one is `unit` rad. Of a circle seen from the side `tall` is the height over the width."""

    x: Number
    y: Number
    zero: float = 0.0
    unit: float = 1.0
    tall: float = 1.0


class Trade(Way, frozen=True, kw_only=True, tag="trade"):
    """A way that trades height for speed without loss: the excess of speed in level flight at a height, by the height
    `head` (v_0^2/g); no higher than where the speed is used up."""

    zero: Number
    unit: Number
    head: str


AnyWay: TypeAlias = Along | Share | Quotient | Root | Swung | Turn | Trade


class Begin(Struct, frozen=True):
    """The start of a motion from what is seen: `parameter` takes the value of the signal `of` on `axis`, or 0. Of what
    goes on as it was every digit is taken `exactly`; an angle, in rad, without whole turns."""

    parameter: str
    of: str = ""
    axis: str = ""
    size: float = 1.0
    exactly: bool = False
    angle: bool = False


class Grab(Struct, frozen=True, kw_only=True):
    """A shape's answer to a hand: the values that it sets; `label` names it for a screen reader.

    Where it `begins` a motion, time stops, what is seen becomes the new `start`, and letting go plays it. The hand does
    not leave the frame of the plot `inside`.
    """

    label: str
    ways: tuple[AnyWay, ...]
    begins: bool = False
    start: tuple[Begin, ...] = ()
    inside: str = ""


class Look(Struct, frozen=True, kw_only=True, tag_field="kind"):
    """The fields that all shapes have: `tint`, the class of a colour, and `style`, more classes; drawn while the
    picture has all the scalars `show`, none of them 0; `inside` names the plot whose frame cuts it, `grab` what a hand
    does with it; what begins a motion in a hand, and what says `held`, is drawn of a picture held too."""

    tint: str = "ink"
    style: str = ""
    show: tuple[str, ...] = ()
    inside: str = ""
    grab: Grab | None = None
    held: bool = False


class Spring(Look, frozen=True, kw_only=True, tag="spring"):
    """A zigzag of nine teeth between two points: stretch is pitch, stiffness is the width of the wire."""

    x1: Number
    y1: Number
    x2: Number
    y2: Number
    wire: Number = 2.5
    height: Number = 13.0


class Box(Look, frozen=True, kw_only=True, tag="box"):
    """A square mass, given by the middle of its foot; `corner` puts its label over it, to the left."""

    x: Number
    y: Number
    side: Number
    label: Runs = ()
    corner: bool = False


class Line(Look, frozen=True, kw_only=True, tag="line"):
    """A straight line."""

    x1: Number
    y1: Number
    x2: Number
    y2: Number


class Arrow(Look, frozen=True, kw_only=True, tag="arrow"):
    """An arrow with a head of so many pixels, moved ahead along itself by `gap`."""

    x1: Number
    y1: Number
    x2: Number
    y2: Number
    head: Number = 11.0
    gap: Number = 0.0


class Circle(Look, frozen=True, kw_only=True, tag="circle"):
    """A disc or, by its style, a ring."""

    x: Number
    y: Number
    r: Number


class Path(Look, frozen=True, kw_only=True, tag="path"):
    """A fixed outline (SVG path data), moved to (x, y), scaled by (sx, sy) and turned by `turn` rad, clockwise on the
    screen, or so that its right end points along (dx, dy)."""

    d: str
    x: Number = 0.0
    y: Number = 0.0
    turn: Number = 0.0
    dx: Number = 0.0
    dy: Number = 0.0
    sx: Number = 1.0
    sy: Number = 1.0


class Arc(Look, frozen=True, kw_only=True, tag="arc"):
    """Part of a circle, between two angles in rad from straight down, counted to the right (anticlockwise)."""

    x: Number
    y: Number
    r: Number
    start: Number
    end: Number


class Wave(Look, frozen=True, kw_only=True, tag="wave"):
    """size sin(2 pi turns s + phase) upwards over a length from (x, y); with a `depth` filled down to there."""

    x: Number
    y: Number
    length: Number
    size: Number
    turns: Number
    phase: Number = 0.0
    depth: Number = 0.0


class Layers(Look, frozen=True, kw_only=True, tag="layers"):
    """`count` slices of a medium from (x, y) to the right, their edges displaced along it by size sin(2 pi turns s)."""

    x: Number
    y: Number
    length: Number
    height: Number
    count: int
    size: Number
    turns: Number


class Label(Look, frozen=True, kw_only=True, tag="text"):
    """Words at a place of the stage. Words `beside` a point of the plot over which they lie stand to its right or left,
    clear of the lines."""

    x: Number
    y: Number
    words: Runs
    anchor: Anchor = "middle"


class Wall(Look, frozen=True, kw_only=True, tag="wall"):
    """A hatched wall; (x, y) is its upper or left end, `side` where the solid is, `depth` the size of its hatching."""

    x: Number
    y: Number
    length: Number
    side: Side = "left"
    depth: Number = 10.0


AnyShape: TypeAlias = Spring | Box | Line | Arrow | Circle | Path | Arc | Wave | Layers | Label | Wall
