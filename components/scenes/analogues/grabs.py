"""Grabs of the nine systems and of the equivalent spring: the motion starts at rest where they are let go."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Literal

from components.language.expressions import Expression, Number, var
from components.language.shapes import Begin, Turn
from components.layout.grabs import begin, begins, linear
from components.layout.stage import Shape, circle
from components.scenes.analogues.case import DEGREE
from components.scenes.analogues.controls import SWINGING
from components.scenes.analogues.curves import Axes
from components.scenes.analogues.curves import Places as P
from components.scenes.analogues.curves import Swinging as S
from components.scenes.analogues.pictures import MARK, MARKED, ROCKS_ABOUT, TWIST, Canvas, rotor_mark
from components.scenes.analogues.reach import LARGEST
from physics.analogues import ANALOGUES

ANGLE = (begins("theta_0", S.angle, size=DEGREE),)
"""Return the grab of a system: the position to which it is dragged becomes its initial position."""

HELD: dict[str, tuple[str, Number, Number, Number, Number]] = {
    "spring": ("Mass", 46, 31.5, 11, 0),
    "floating": ("Floating body", 42, 30.5, 0, -7),
    "circuit": ("Charge", 66, 30, 0, 5),
    "string": ("String", 9 + 66 * var(P.belly), 27, 0, -17),
    "wave": ("Water", 42, 17, 0, -8),
    "pipe": ("Air", 10 + 64 * var(P.belly), 47, var(P.along), 0),
}
"""The grab of each system: its name, its position at rest, and its distance from there at the largest displacement."""


def held(slug: str, c: Canvas) -> Shape:
    """An invisible shape over the moving part, which can be dragged."""
    name, x, y, dx, dy = HELD[slug]
    across: Literal["x", "y"] = "y" if dy else "x"
    place = (lambda pose: c.y(y + dy * pose)) if dy else (lambda pose: c.x(x + dx * pose))
    pose, (parameter, size, start) = var(S.pose), _posed(slug)
    way = linear(place, across, parameter, S.pose, size=size)
    grab = begin(f"{name}, start", way, start=start)
    return circle(c.x(x + dx * pose), c.y(y + dy * pose), 0, show=P.of[slug], grab=grab)


def _posed(slug: str) -> tuple[str, float, tuple[Begin, ...]]:
    """The start of a system: its parameter, the drawn displacement per unit of it, and its visible coordinate."""
    name = f"{slug}_start"
    return name, 1 / (LARGEST * ANALOGUES[slug].swing), (begins(name, S.level, Axes.q),)


def turned(c: Canvas) -> Shape:
    """An invisible shape over the rotor. It is dragged by the end of its mark, which moves on a circle seen from the
    side.
    """
    parameter, size, start = _posed("shaft")
    centre, (ahead, up) = (c.x(42), c.y(38)), rotor_mark(var(S.pose))
    turn = Turn(
        parameter=parameter, moves=S.pose.name, size=size, x=centre[0], y=centre[1],
        zero=math.pi / 2 - MARKED, unit=-TWIST, tall=MARK[1] / MARK[0],
    )  # fmt: skip
    return circle(c.x(ahead), c.y(up), 0, show=P.of["shaft"], grab=begin("Rotor, start", turn, start=start))


def rocked(c: Canvas) -> Shape:
    """An invisible shape over the rocking body, which is dragged by its foot."""
    x, y = c.x(42), c.y(ROCKS_ABOUT)
    turn = Turn(parameter="theta_0", moves=S.angle.name, size=DEGREE, x=x, y=y)
    foot = 20 * c.unit
    at = x + foot * var(S.angle_sine), y + foot * var(S.angle_cosine)
    return circle(*at, 0, show=P.of["rocking"], grab=begin("Body, start", turn, start=ANGLE))


def held_spring(slug: str, x: Number, height: Callable[[Number], Expression]) -> Shape:
    """An invisible shape over the mass. Dragging it also sets the start of the chosen system."""
    name, size = ("theta_0", DEGREE) if slug in SWINGING else (f"{slug}_start", 1.0)
    way = linear(height, "y", name, S.rule, Axes.q, size=size)
    held = begin("Spring's mass, start", way, start=(begins(name, S.rule, Axes.q, size=size),))
    return circle(x, height(var(S.rule)), 0, show=P.of[slug], grab=held)
