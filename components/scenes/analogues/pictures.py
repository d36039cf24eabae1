"""The nine systems as pictures, each written once: small in the picker, large on the stage.

Blue parts have inertia, grey parts provide the restoring force; wires, rods and walls have the colour of text.
Coordinates are in units
of an area of 84 by 54.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from msgspec.structs import replace

from components.language.expressions import Expression, Number, as_expression, var
from components.layout.stage import (
    H,
    Shape,
    W,
    arrow,
    box,
    circle,
    layers,
    line,
    path,
    shown_by,
    spring,
    text,
    wall,
    wave,
)
from components.scenes.analogues.curves import COSINE
from components.scenes.analogues.curves import Places as P
from components.scenes.analogues.curves import Swinging as S

WIDTH, HEIGHT = 84, 54
TWIST = 0.9
"""The twist of the rotor as drawn, in rad. It is to scale relative to the largest twist, but its size is not."""
MARK, MARKED = (25, 7.7), 0.5
"""The mark on the rotor: half of its width and height, and its rest position in rad from the right."""


@dataclass(frozen=True)
class Canvas:
    """The area of a picture, from its upper left corner; `large` pictures have names."""

    left: Number
    top: Number
    unit: Expression
    large: bool = False

    def x(self, units: Number) -> Expression:
        return self.left + self.unit * units

    def y(self, units: Number) -> Expression:
        return self.top + self.unit * units

    def line(self, x1: Number, y1: Number, x2: Number, y2: Number, style: str, tint: str = "ink") -> Shape:
        return line(self.x(x1), self.y(y1), self.x(x2), self.y(y2), style=style, tint=tint)

    def arrow(self, x1: Number, y1: Number, x2: Number, y2: Number, tint: str) -> Shape:
        ends = (self.x(x1), self.y(y1), self.x(x2), self.y(y2))
        return arrow(*ends, tint=tint, head=self.unit * 4.5, style="thin")

    def path(self, d: str, x: Number = 0, y: Number = 0, turn: Number = 0, **more: str) -> Shape:
        look = {"style": "scaled"} | more
        return path(d, self.x(x), self.y(y), turn, sx=self.unit, sy=self.unit, **look)

    def disc(self, x: Number, y: Number, r: float, style: str = "body", tint: str = "m1") -> Shape:
        return circle(self.x(x), self.y(y), self.unit * r, style=style, tint=tint)

    def wall(self, x: float, y: float, length: float, side: str) -> Shape:
        style, depth = ("", 10) if self.large else ("bar", 5)
        return wall(self.x(x), self.y(y), self.unit * length, side=side, depth=depth, style=style)

    def name(
        self, x: Number, y: Number, words: str, tint: str, anchor: str = "middle", style: str = "t3 halo"
    ) -> list[Shape]:
        if not self.large:
            return []
        return [text(self.x(x), self.y(y), words, tint=tint, anchor=anchor, style=style)]


def kept(shape: Shape) -> Shape:
    """Draw the shape also for the compared picture."""
    return replace(shape, held=True)


@dataclass(frozen=True)
class Pose:
    """The pose of a system's picture: expressions for the positions of its parts.

    `size` is the amplitude as a share of the largest one that is drawn, `q` the displacement in the same unit, and
    `behind` the displacement a quarter period later. `angle` is the angle of a rocking body, with its sine and cosine.
    `half_waves` is the number of half waves, `belly` the position of the first antinode as a share of the length, and
    `along` the displacement of air.
    """

    size: Number
    q: Expression
    behind: Expression
    angle: Expression
    sine: Expression
    cosine: Expression
    half_waves: Number
    belly: Number
    along: Number


def small_angle(angle: Expression) -> tuple[Expression, Expression]:
    """Approximate sine and cosine by polynomials, within 0.001 up to 0.9 rad."""
    square = angle * angle
    return angle - angle * square / 6 + angle * square * square / 120, 1 - square / 2 + square * square / 24


def _spring(c: Canvas, s: Pose) -> list[Shape]:
    x = 46 + 11 * s.q
    return [
        c.wall(10, 14, 28, "left"),
        c.line(10, 42, 80, 42, "floor"),
        c.line(46, 12, 46, 46, "eq", "mute"),
        spring(c.x(10), c.y(31), c.x(x - 10.5), c.y(31), 2.5 if c.large else 1.6, height=c.unit * 5),
        box(c.x(x), c.y(42), c.unit * 21, "*m*", tint="m1", held=True),
        *c.name(22, 22, "*k*", "k"),
    ]


def rotor_mark(q: Expression | float) -> tuple[Number, Number]:
    """The end of the mark on the rotor, in the picture's units."""
    sine, cosine = small_angle(as_expression(TWIST * q))
    rest = (math.cos(MARKED), math.sin(MARKED))
    ahead, up = rest[0] * cosine - rest[1] * sine, rest[1] * cosine + rest[0] * sine
    return 42 + MARK[0] * ahead, 38 + MARK[1] * up


def _shaft(c: Canvas, s: Pose) -> list[Shape]:
    hoops = [c.line(39, y, 45, y - 5 * s.q * (y - 8) / 26, "fine", "k") for y in range(13, 34, 5)]
    return [
        c.wall(26, 8, 32, "top"),
        c.path("M-3 0h6v27h-6z", 42, 8, style="body", tint="k1fill"),
        *hoops,
        c.path("M-26 0a26 8 0 0 1 52 0v5a26 8 0 0 1 -52 0z", 42, 38, style="body", tint="m1"),
        c.path("M-26 0a26 8 0 1 0 52 0a26 8 0 1 0 -52 0z", 42, 38, style="ghost scaled", tint="m1"),
        c.line(42, 38, *rotor_mark(0.0), "eq", "mute"),
        kept(c.line(42, 38, *rotor_mark(s.q), "sum" if c.large else "", "m1")),
        *c.name(51, 22, "*k*_t", "k"),
        *c.name(74, 46, "*J*", "m1"),
    ]


def _pendulum(c: Canvas, s: Pose) -> list[Shape]:
    x, y = 42 + 29 * s.sine, 5 + 29 * s.cosine
    return [
        c.wall(26, 5, 32, "top"),
        c.line(42, 5, 42, 46, "eq", "mute"),
        c.line(42, 5, x, y, "rod"),
        c.arrow(x, y, x, y + 17, "k"),
        c.disc(x, y, 7.5),
    ]


ROCKS_ABOUT = 19
"""The point where the rocking body hangs in the large picture, down the area."""


def _rocking(c: Canvas, s: Pose) -> list[Shape]:
    top, arm = (ROCKS_ABOUT, 12) if c.large else (12, 13)
    x, y = 42 + arm * s.sine, top + arm * s.cosine
    return [
        c.line(42, top - 9, 42, 54, "eq", "mute"),
        kept(c.path("M-11 -6L11 -6L14 26L-14 26Z", 42, top, turn=-s.angle, style="body", tint="m1")),
        c.arrow(x, y, x, y + 24, "k"),
        c.disc(42, top, 2.2 if c.large else 3.2, "dot", "ink"),
        *([c.disc(x, y, 1.2, "dot", "k")] if c.large else []),
        *c.name(x + 3, y + 23, "*m g*", "k", "start"),
    ]


def _floating(c: Canvas, s: Pose) -> list[Shape]:
    top = 17 - 7 * s.q
    surface = (c.x(4), c.y(30), c.unit * 76, c.unit * 0.7, 5)
    return [
        c.path("M-14 0h28v27h-28z", 42, top, style="body", tint="m1"),
        wave(*surface, depth=c.unit * 22, style="water"),
        wave(*surface, style="fine", tint="k"),
        kept(c.path("M-14 0h28v27h-28z", 42, top, style="outline scaled", tint="m1")),
        c.line(29, top + 13, 55, top + 13, "inner"),
        *c.name(42, top + 9, "*m*", "m1", style="t3 on"),
        *c.name(70, 45, "*ρ g A*", "k"),
    ]


def _circuit(c: Canvas, s: Pose) -> list[Shape]:
    loops = [i / 160 for i in range(161)]
    coil = "L".join(
        f"{27 + 28 * a - 3.4 * math.sin(10 * math.pi * a):.2f} {9.5 + 5.5 * math.cos(10 * math.pi * a):.2f}"
        for a in loops
    )
    field = [c.arrow(x, 30 - 5 * s.q, x, 30 + 5 * s.q, "k") for x in (60, 66, 72)]
    return [
        c.path("M27 15H14V48H66V37M55 15H66V23", style="rod scaled"),
        c.path(f"M{coil}", style="scaled" if c.large else "fine scaled", tint="m1"),
        c.line(55, 23.5, 77, 23.5, "plate", "k"),
        c.line(55, 36.5, 77, 36.5, "plate", "k"),
        *field,
        kept(c.arrow(40 - 11 * s.behind, 48, 40 + 11 * s.behind, 48, "m1")),
        *c.name(41, 24, "*L*", "m1"),
        *c.name(81, 31.5, "*C*", "k"),
        *c.name(40, 44, "current", "m1"),
    ]


def _string(c: Canvas, s: Pose) -> list[Shape]:
    place = (c.x(9), c.y(27), c.unit * 66)
    return [
        c.line(9, 14, 9, 40, "wall bar"),
        c.line(75, 14, 75, 40, "wall bar"),
        wave(*place, c.unit * 17 * s.size, s.half_waves / 2, style="eq", tint="mute"),
        wave(*place, c.unit * -17 * s.size, s.half_waves / 2, style="eq", tint="mute"),
        c.line(9, 27, 75, 27, "eq", "mute"),
        wave(*place, c.unit * 17 * s.q, s.half_waves / 2, style="sum", tint="m1", held=True),
        *([c.arrow(9 + 66 * s.belly, 27, 9 + 66 * s.belly, 27 - 17 * s.q, "m1")] if c.large else []),
        *c.name(5, 29, "*T*", "k"),
        *c.name(79, 29, "*T*", "k"),
    ]


def _wave(c: Canvas, s: Pose) -> list[Shape]:
    """A standing wave, highest in the middle."""
    surface = (c.x(4), c.y(17), c.unit * 76, c.unit * 8 * s.q, 1.0, -math.pi / 2)
    return [
        wave(*surface, depth=c.unit * 35, style="water"),
        c.line(4, 17, 80, 17, "eq", "mute"),
        wave(*surface, style="sum", tint="m1", held=True),
        *(one for x in (23, 42, 61) for one in _under(c, s, x)),
        c.disc(42, 17 - 8 * s.q, 2.4, "dot", "m1"),
    ]


def _under(c: Canvas, s: Pose, x: float) -> list[Shape]:
    """The water below x. It moves to and fro by an amount that decreases as exp(-kappa depth)."""
    ahead, shapes = 2 * math.pi * (x - 42) / 76, []
    for y in (27, 36, 45):
        reach = 8 * math.exp(-2 * math.pi * (y - 17) / 76)
        along, up = -reach * math.sin(ahead), reach * math.cos(ahead)
        shapes += [
            c.line(x - along, y + up, x + along, y - up, "fine", "k"),
            c.disc(x + along * s.q, y - up * s.q, 1.1, "body", "m1"),
        ]
    return shapes


def _pipe(c: Canvas, s: Pose) -> list[Shape]:
    return [
        layers(
            c.x(10),
            c.y(17),
            c.unit * 64,
            c.unit * 20,
            40 if c.large else 14,
            c.unit * s.q * s.along,
            s.half_waves / 2,
            tint="m1",
            style="fine",
        ),
        c.path("M10 15h64v24h-64z", style="rod scaled"),
        c.line(10, 12, 10, 42, "wall bar"),
        c.line(74, 12, 74, 42, "wall bar"),
        kept(c.arrow(10 + 64 * s.belly, 47, 10 + 64 * s.belly + s.along * s.q, 47, "m1")),
        c.line(10 + 64 * s.belly, 41, 10 + 64 * s.belly, 50, "eq", "mute"),
    ]


PICTURES: dict[str, Callable[[Canvas, Pose], list[Shape]]] = {
    "spring": _spring,
    "shaft": _shaft,
    "pendulum": _pendulum,
    "rocking": _rocking,
    "floating": _floating,
    "circuit": _circuit,
    "string": _string,
    "wave": _wave,
    "pipe": _pipe,
}


def tiles() -> dict[str, list[Shape]]:
    """The pictures of the picker by system, all at the same phase."""
    unit = H / HEIGHT
    canvas = Canvas(W / 2 - unit * (WIDTH / 2), 0, unit)
    angle = 0.5 * COSINE
    swing = Pose(1, COSINE, var(S.sine), angle, *small_angle(angle), 1, 0.5, 10)
    return {slug: draw(canvas, swing) for slug, draw in PICTURES.items()}


def large(slug: str, canvas: Canvas) -> list[Shape]:
    """One picture on the stage, visible while its system is chosen."""
    size, angle = var(P.size), (var(one) for one in (S.angle, S.angle_sine, S.angle_cosine))
    waves = (var(one) for one in (P.half_waves, P.belly, P.along))
    swing = Pose(size, var(S.pose), size * var(S.sine), *angle, *waves)
    return shown_by(P.of[slug], *PICTURES[slug](canvas, swing))
