"""Shapes: the parts of a stage. Every number of a shape may be an expression; sizes are pixels of the stage."""

from __future__ import annotations

from typing import Literal, TypeAlias

from msgspec import Struct

from components.language.expressions import Number
from components.language.text import Runs

Anchor: TypeAlias = Literal["start", "middle", "end", "beside"]
Side: TypeAlias = Literal["left", "right", "top", "bottom"]


class Way(Struct, frozen=True, kw_only=True, tag_field="kind"):
    """A rule for dragging: computes the value of `parameter` ("" for none) from the position of the pointer ("the
    hand"). `size` is the unit of the parameter in SI.

    `moves` is the signal or scalar, on `axis` ("" for none), that follows the hand at once, before the server answers.
    A throw adds its velocity to the initial value of the parameter `rate`.
    """

    parameter: str = ""
    moves: str = ""
    axis: str = ""
    size: float = 1.0
    rate: str = ""


class Stretch(Way, frozen=True, kw_only=True):
    """A rule for a drag along a line: 0 is at the pixel `zero`, and one unit of the axis is `unit` pixels, to the right
    or down. The drag is limited to `least` to `most`, both in SI."""

    across: Literal["x", "y"]
    zero: Number
    unit: Number
    least: float | None = None
    most: float | None = None


class Along(Stretch, frozen=True, kw_only=True, tag="along"):
    """Sets the parameter to the value at the position of the hand."""


class Share(Stretch, frozen=True, kw_only=True, tag="share"):
    """Sets the parameter to `share` times the position of the hand, plus the signal `rest`."""

    share: Number
    rest: str


class Quotient(Stretch, frozen=True, kw_only=True, tag="quotient"):
    """Sets the parameter to the value of `over`, divided by the position of the hand."""

    over: str


class Root(Stretch, frozen=True, kw_only=True, tag="root"):
    """Sets z by dragging a root of s^2 + 2 z s + 1. With p, its distance to the left of the imaginary axis, z
    is p on the circle, and (p + 1/p)/2 on the real axis: for p > 1, or if `real`."""

    real: bool = False


class Swung(Stretch, frozen=True, kw_only=True, tag="swung"):
    """A rule for a shape that oscillates: the position of the hand, times `counted`, becomes a turning point of a sine.
    The value is
    its amplitude or, by `of`, its phase in rad. The dragged shape moves by `share` of the sine. A throw gives it a
    velocity; `turn` is the signal with the argument of the sine."""

    of: Literal["amplitude", "phase"]
    counted: Number
    share: Number
    turn: str


class Turn(Way, frozen=True, kw_only=True, tag="turn"):
    """A rule for a drag around a point (x, y): the angle in rad, from straight down, counted anticlockwise. 0 is at
    `zero`, and one
    unit is `unit` rad. `tall` is height over width, for a circle seen from the side."""

    x: Number
    y: Number
    zero: float = 0.0
    unit: float = 1.0
    tall: float = 1.0


class Trade(Way, frozen=True, kw_only=True, tag="trade"):
    """A rule that exchanges height for speed without loss. It sets the excess of speed over level flight from a height;
    `head` is the height v_0^2/g. The height is limited by the speed."""

    zero: Number
    unit: Number
    head: str


class ChainRoot(Way, frozen=True, kw_only=True, tag="chain_root"):
    """A rule for dragging a root s of P(s) = A(s) + u B(s) + u^2 C(s). It sets `base` + `slope` u, with the u >= 0 for
    which
    |P| is least at the hand.

    `terms` are the coefficients of A, B and C, constants first. The point s = 0 is at (`x`, `y`). One unit of the plane
    is `right` pixels to the right, or `down` pixels downwards, a negative number. The search for u starts at `now`.
    """

    x: Number
    y: Number
    right: Number
    down: Number
    terms: tuple[tuple[Number, ...], tuple[Number, ...], tuple[Number, ...]]
    base: Number
    slope: Number
    now: Number


class Locus(Way, frozen=True, kw_only=True, tag="locus"):
    """A rule for a drag along the curve of a response in the complex plane, A(s) over the product of all s - p, at s =
    i w, w >= 0.
    It sets `unit` times w; the rules after it use the nearest point on the curve.

    `above` are the coefficients of A, constants first, and `poles` the real and imaginary parts of each p. The point 0
    is at (`x`, `y`). One unit of the plane is `right` pixels to the right, or `down` pixels downwards, a negative
    number. The current w is `now`.
    """

    x: Number
    y: Number
    right: Number
    down: Number
    above: tuple[Number, ...]
    poles: tuple[tuple[Number, Number], ...]
    unit: Number
    now: Number


AnyWay: TypeAlias = Along | Share | Quotient | Root | Swung | Turn | Trade | ChainRoot | Locus


class Begin(Struct, frozen=True):
    """An initial condition taken from the motion when a drag begins: `parameter` takes the current value of the signal
    `of` on `axis`, or 0.
    `exactly`: with all digits, so that the motion continues. `angle`: in rad, without whole turns."""

    parameter: str
    of: str = ""
    axis: str = ""
    size: float = 1.0
    exactly: bool = False
    angle: bool = False


class Grab(Struct, frozen=True, kw_only=True):
    """The response of a shape to dragging: the values that it sets; `label` names it for a screen reader.

    If it `begins` a motion, time stops, the current positions become the initial conditions (`start`), and the release
    plays the motion. The hand
    cannot leave the frame of the plot `inside`.
    """

    label: str
    ways: tuple[AnyWay, ...]
    begins: bool = False
    start: tuple[Begin, ...] = ()
    inside: str = ""


class Look(Struct, frozen=True, kw_only=True, tag_field="kind"):
    """The fields that all shapes have.

    `tint` is the class of a colour, `style` are more classes. A shape is drawn if the picture has all the scalars
    `show`, none of them 0. The frame of the plot `inside` cuts it off. `grab` is its response to dragging. Of a
    compared picture, only shapes that begin a motion, or with `held`, are drawn.
    """

    tint: str = "ink"
    style: str = ""
    show: tuple[str, ...] = ()
    inside: str = ""
    grab: Grab | None = None
    held: bool = False


class Spring(Look, frozen=True, kw_only=True, tag="spring"):
    """A zigzag of nine teeth between two points. Its pitch shows the stretch, the width of the wire the stiffness."""

    x1: Number
    y1: Number
    x2: Number
    y2: Number
    wire: Number = 2.5
    height: Number = 13.0


class Box(Look, frozen=True, kw_only=True, tag="box"):
    """A square mass, given by the middle of its lower edge; `corner` puts its label above it, to the left."""

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
    """An arrow with a head of `head` pixels, shifted by `gap` along its direction."""

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
    """A sine wave, size sin(2 pi turns s + phase) upwards, over a length from (x, y); with `depth`, filled down to
    there."""

    x: Number
    y: Number
    length: Number
    size: Number
    turns: Number
    phase: Number = 0.0
    depth: Number = 0.0


class Layers(Look, frozen=True, kw_only=True, tag="layers"):
    """`count` slices of a medium from (x, y) to the right; their edges are displaced along it by size sin(2 pi turns
    s)."""

    x: Number
    y: Number
    length: Number
    height: Number
    count: int
    size: Number
    turns: Number


class Label(Look, frozen=True, kw_only=True, tag="text"):
    """Text on the stage. With the anchor `beside`, a text over a plot is to the right or left of its point, where it
    covers no lines."""

    x: Number
    y: Number
    words: Runs
    anchor: Anchor = "middle"


class Wall(Look, frozen=True, kw_only=True, tag="wall"):
    """A hatched wall; (x, y) is its upper or left end, `side` the solid side, `depth` the size of its hatching."""

    x: Number
    y: Number
    length: Number
    side: Side = "left"
    depth: Number = 10.0


class Beads(Look, frozen=True, kw_only=True, tag="beads"):
    """The masses of the modal signal `of` on their springs.

    The line from (x, y) to the right has `parts` equal parts; at rest, mass p is `first` + p - 1 parts from its start.
    One unit
    of its displacement, less the `drift` of all masses, is `across` pixels up or `along` pixels to the right. Springs
    lead to the walls `left` and `right` unless these are 0. Masses displaced by more than `least` have the colour of
    their side. While `picks` is not 0, the signal `at` becomes the mass at the pointer.
    """

    of: str
    count: Number
    x: Number
    y: Number
    length: Number
    first: Number
    parts: Number
    across: Number
    along: Number
    left: Number
    right: Number
    least: Number
    drift: Number
    at: str
    picks: Number


AnyShape: TypeAlias = Spring | Box | Line | Arrow | Circle | Path | Arc | Wave | Layers | Label | Wall | Beads
