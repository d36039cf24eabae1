"""The stage of the oscillator: the mass, the turning arrow whose height is x, and the arrow at the start."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import pi

from components.language.numbers import Expression, Number, var
from components.language.shapes import Grab
from components.layout.grabs import at_rest, begin, begins, grab, linear, on_plot
from components.layout.stage import (
    AT_DESK,
    NARROW,
    ON_NARROW,
    ON_WIDE,
    WIDE,
    H,
    Looks,
    PlotFrame,
    Shape,
    T,
    W,
    arc,
    arrow,
    box,
    circle,
    line,
    shown_by,
    spring,
    text,
    wall,
    wave,
)
from components.scenes.oscillator.curves import Axes, Marks, Turning
from components.scenes.oscillator.curves import Places as P
from components.scenes.oscillator.curves import Signals as S
from components.scenes.oscillator.numbers import Numbers as N

FRAMES = X, V, A = PlotFrame("x"), PlotFrame("v"), PlotFrame("a")
PLANE, LAW = PlotFrame("plane"), PlotFrame("law")
MASS = WIDE * 0.15 * W + NARROW * 0.1 * W
"""Where the mass stands, and below where the arrow turns: across the stage."""
SWING = 0.27 * H
"""The amplitude on a phone."""
PIVOT = WIDE * 0.635 * W + NARROW * 0.395 * W
FRAME = WIDE * (X.bottom - X.top) + NARROW * 0.8 * H
"""The height of the plot of x, on whose scale all is drawn; on a phone, where it stands elsewhere, one like it."""
LEVEL = WIDE * X.y(0) + NARROW * 0.5 * H
SCALE = WIDE * -1 * X.per_y + NARROW * SWING * var(P.per_x)
"""Pixels that one of the axis of x takes; on a phone, where the frame ends."""
RADIUS = SCALE * var(Turning.C) * var(Turning.turns)
STRIP, STRIP_LENGTH = 0.64 * W, 0.31 * W
"""On a phone the stage has a small x(t) of its own."""
FIRST = 132
"""Pixels of the words left of the start arrow; it stands under the turning one."""
SEEN = "smooth table, seen from above"
SHARE = 0.75
"""The arrow of the force at the turning point is this long, over the amplitude."""

StageVector = tuple[Number, Number]

COSINE, SINE = var(S.cosine), var(S.sine)
WAYS: tuple[StageVector, ...] = (COSINE, SINE), (-1 * SINE, COSINE), (-1 * COSINE, -1 * SINE)
"""The directions of the arrows of x, v and a, up positive: each a quarter turn ahead of the one before."""
START_WAY: StageVector = (var(Turning.start_cosine), var(Turning.start_sine))
LOOKS = (
    ("*x*", "m1", "", (15, 13)),
    ("*v*/*ω*_n", "T", "thin", (26, 16)),
    ("*a*/*ω*_n²", "F", "thin", (30, 16)),
)
"""Their names, tints and styles, and the pixels from the tip to the middle of the name, across and up."""


def at(centre: StageVector, way: StageVector, length: Number) -> StageVector:
    return centre[0] + length * way[0], centre[1] - length * way[1]


def hero() -> list[Shape]:
    """Mass, tip of the arrow and curve on one level line."""
    now = WIDE * X.x(T) + NARROW * (STRIP + STRIP_LENGTH * T * var(P.per_window))
    y = height(var(S.x))
    return [
        line(0.04 * W, LEVEL, WIDE * (X.left - 24) + NARROW * STRIP, LEVEL, style="eq", tint="mute"),
        line(MASS, y, now, y, style="level", tint="m1"),
        *strip(now, y),
        *table(y),
        *shown_by(Turning.turns, *turning((PIVOT, LEVEL))),
    ]


def height(x: Number) -> Expression:
    return LEVEL - SCALE * x


START = (begins("x_0", S.x, Axes.x), begins("v_0", S.v, Axes.v))
"""Where the tip of the arrow is held: it says x and v."""


def beside(centre: Number, scale: Number) -> Callable[[Number], Number]:
    """The place of a velocity beside the middle of a circle: as far as x would be a quarter period later."""
    return lambda v: centre + scale * var(Turning.per_v) * v


MASS_GRAB = begin(
    "Mass, start",
    linear(height, "y", "x_0", S.x, Axes.x, rate="v_0"),
    start=(START[0], *at_rest("v_0")),
)
TIP_GRAB = begin(
    "Turning arrow, start",
    linear(height, "y", "x_0", S.x, Axes.x),
    linear(beside(PIVOT, SCALE), "x", "v_0", S.v, Axes.v),
    start=START,
)


def table(y: Number) -> list[Shape]:
    """The table seen from above: wall, spring and mass; x points up, as in the plot."""
    side = 0.2 * FRAME * var(P.side)
    foot = WIDE * (X.top + 1.2 * FRAME) + NARROW * (LEVEL + 0.42 * H)
    aside = MASS - 0.5 * side - 13
    return [
        wall(MASS - 42, foot, 84, side="bottom"),
        spring(MASS, y + 0.5 * side, MASS, foot, var(P.wire), height=13, show=P.wire),
        box(MASS, y + 0.5 * side, side, "*m*", tint="m1", grab=MASS_GRAB),
        arrow(aside, LEVEL, aside, y, tint="m1"),
        *pulled(MASS + 0.5 * side + 13, y, LEVEL),
        text(MASS + 38, 16, f"*x* = {S.x} {N.x_unit}", "start", tint="m1", style="t2 b halo"),
        *shown_by((ON_WIDE, AT_DESK), text(MASS + 52, foot + 4, SEEN, "start", tint="mute", style="halo")),
    ]


def pulled(x: Number, y: Number, level: Number) -> list[Shape]:
    """The force of the spring beside the mass, from its middle back towards equilibrium; its name right of it."""
    tip = y + SHARE * (level - y)
    return shown_by(
        P.forced,
        arrow(x, y, x, tip, tint="F", style="thick", head=16),
        text(x + 12, (y + tip) * 0.5 + 5, "*F*", "start", tint="F", style="t2 b halo"),
    )


def turning(centre: StageVector) -> list[Shape]:
    """The arrow of x and its two companions, all drawn at the length C, on their circle."""
    found = [*cross(centre, RADIUS), *right_angles(centre)]
    for i in (2, 1, 0):
        (_, tint, style, _), tip = LOOKS[i], at(centre, WAYS[i], RADIUS)
        found.append(arrow(*centre, *tip, tint=tint, style=style, head=11 if i else 13, held=not i))
    found += [
        circle(*centre, 4, tint="ink"),
        circle(*at(centre, START_WAY, RADIUS), 4, style="ghost", tint="mute"),
        circle(beside(centre[0], SCALE)(var(S.v)), height(var(S.x)), 5, tint="m1", grab=TIP_GRAB),
    ]
    for (x, y), (name, tint, _, (across, up)) in zip(WAYS, LOOKS, strict=True):
        place = centre[0] + (RADIUS + across) * x, centre[1] - (RADIUS + up) * y + 5
        found.append(text(*place, name, tint=tint, style="t2 b halo told"))
    return found


def cross(centre: StageVector, radius: Number) -> list[Shape]:
    x, y = centre
    reach = radius + 8
    return [
        circle(x, y, radius, style="orbit", tint="mute", held=True),
        line(x - reach, y, x + reach, y, style="hair told"),
        line(x, y - reach, x, y + reach, style="hair told"),
    ]


def right_angles(centre: StageVector) -> list[Shape]:
    """The marks that say: a quarter turn."""
    found = []
    for a, b in pairwise(WAYS):
        corner = at(centre, (a[0] + b[0], a[1] + b[1]), 13)
        found += [
            line(*at(centre, a, 13), *corner, style="floor told"),
            line(*corner, *at(centre, b, 13), style="floor told"),
        ]
    return found


def strip(now: Number, y: Number) -> list[Shape]:
    """The small x(t) on a phone, with its cursor."""
    top, bottom = LEVEL - 0.34 * H, LEVEL + 0.34 * H
    place = STRIP, LEVEL, STRIP_LENGTH, RADIUS, var(Turning.swings), var(Turning.phi)
    curve = wave(*place, style="sum", tint="m1", show=Turning.swings)
    return shown_by(ON_NARROW, curve, line(now, top, now, bottom, style="now"), circle(now, y, 5, tint="m1"))


def _start_grab(x: Number, y: Number, scale: Number) -> Grab:
    """The tip of the arrow at the start, about (x, y): up is x_0, across v_0."""
    return grab(
        "Arrow at the start",
        linear(lambda value: y - scale * value, "y", "x_0", Turning.x_start, Axes.x),
        linear(beside(x, scale), "x", "v_0", Turning.v_start, Axes.v),
    )


def first() -> list[Shape]:
    """The arrow at t = 0: its legs are A and B; atan would send it the other way where v_0 < 0."""
    centre = (WIDE * (0.635 * (W + FIRST) - FIRST) + NARROW * 0.5 * W, 0.5 * H)
    scale = WIDE * SCALE + NARROW * 0.42 * H * var(P.per_x)
    radius, way = scale * var(Turning.C), START_WAY
    x, y = centre
    foot = (beside(x, scale)(var(Turning.v_start)), y)
    tip = (foot[0], y - scale * var(Turning.x_start))
    wrong = at(centre, (-1 * way[0], -1 * way[1]), radius)
    middle = at(centre, (var(Turning.middle_cosine), var(Turning.middle_sine)), 40)
    aside = at(centre, (way[0] - 0.22 * way[1], way[1] + 0.22 * way[0]), 0.58 * radius)
    outside = (foot[0] + 13 * var(Turning.outside), y - 0.5 * radius * way[1] + 5)
    quarter = pi / 2
    bold: Looks = {"style": "t2 b halo"}
    shapes = [
        *cross(centre, radius),
        line(*centre, *wrong, style="dotted", tint="mute", show=Turning.atan),
        circle(*wrong, 4, style="ghost", tint="mute", show=Turning.atan),
        text(wrong[0] + 10, wrong[1] + 5, "atan", "start", tint="mute", style="halo", show=Turning.atan),
        arc(x, y, 28, quarter, var(Turning.phi) + quarter, style="floor", tint="ink"),
        line(x, y, *foot, style="sum", tint="T"),
        line(*foot, *tip, style="sum", tint="m1"),
        arrow(x, y, *tip, tint="m1", head=13, grab=_start_grab(x, y, scale), held=True),
        circle(x, y, 4, tint="ink"),
        text(middle[0], middle[1] + 5, "*φ*", show=Turning.has_phi, **bold),
        text(x + 0.5 * radius * way[0], y + 13 * var(Turning.under) + 5, "*B*", tint="T", show=Turning.has_B, **bold),
        text(*outside, "*A*", tint="m1", show=Turning.has_A, **bold),
        text(aside[0], aside[1] + 5, "*C*", tint="m1", show=(Turning.has_A, Turning.has_B), **bold),
    ]
    return shown_by(Turning.turns, *shapes)


def lead(late: int) -> tuple[Shape, ...]:
    """Over the plot of v or a: from a peak of x (0) or v (1) to the peak of what leads it by a quarter period."""
    both = late, late + 1
    a, b = (FRAMES[late + 1].x(var(Marks.peak[i])) for i in both)
    top, y = (FRAMES[i].y(var(Marks.top[i])) for i in both)
    shapes = (
        line(a, top, a, y - 6, style="eq", tint="mute"),
        line(b, y - 16, b, y, style="floor"),
        arrow(a, y - 11, b, y - 11, style="thin", head=8),
        text((a + b) * 0.5, y - 17, "*τ*/4", style="b halo"),
    )
    return tuple(shown_by(Marks.leads, *shapes))


def planes() -> tuple[tuple[Shape, ...], tuple[Shape, ...]]:
    """Over the phase plane and over the law: names of the axes, and the lines shared with v(t), with a(t), in x."""
    x, v, a = PLANE.x(var(S.x)), PLANE.y(var(S.v)), LAW.y(var(S.a))
    ends = (V.x(T), V.y(var(S.v)), x, v), (x, v, x, a), (A.x(T), A.y(var(S.a)), x, a)
    links = (line(*one, style="level", tint="mute", show=ON_WIDE) for one in ends)
    held = begin(
        "Point of the phase plane, start",
        on_plot(PLANE, "x", "x_0", S.x, Axes.x),
        on_plot(PLANE, "y", "v_0", S.v, Axes.v),
        start=START,
    )
    return (*links, *axis_names(PLANE, "v", "T"), circle(x, v, 4.5, grab=held)), tuple(axis_names(LAW, "a", "F"))


def axis_names(plot: PlotFrame, upward: str, tint: str) -> list[Shape]:
    return [
        text(plot.right + 4, plot.y(0) - 6, "*x*", "end", tint="m1", style="t2 b halo"),
        text(plot.x(0) + 7, plot.top + 11, f"*{upward}*", "start", tint=tint, style="t2 b halo"),
    ]
