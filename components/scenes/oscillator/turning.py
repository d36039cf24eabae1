"""The stage of the oscillator: the mass, the turning arrow whose height is x, and the arrow at the start."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

from components.language.numbers import Expression, Number, var
from components.language.shapes import Begin, Grab
from components.layout.grabs import at_rest, begin, grab, linear, on_plot
from components.layout.stage import (
    NARROW,
    WIDE,
    H,
    Shape,
    T,
    W,
    arc,
    arrow,
    box,
    circle,
    line,
    on_x,
    on_y,
    shown_by,
    spring,
    text,
    wall,
    wave,
)
from components.scenes.oscillator.numbers import Numbers as N
from components.scenes.oscillator.pull import pulled

MASS = WIDE * 0.15 * W + NARROW * 0.1 * W
"""Where the mass stands, and below where the arrow turns: across the stage."""
SWING = 0.27 * H
"""The amplitude on a phone."""
PIVOT = WIDE * 0.635 * W + NARROW * 0.395 * W
FRAME = WIDE * (var("x.bottom") - var("x.top")) + NARROW * 0.8 * H
"""The height of the plot of x, on whose scale all is drawn; on a phone, where it stands elsewhere, one like it."""
LEVEL = WIDE * on_y("x", 0) + NARROW * 0.5 * H
SCALE = WIDE * -1 * var("x.y1") + NARROW * SWING * var("per_x")
"""Pixels that one of the axis of x takes; on a phone, where the frame ends."""
RADIUS = SCALE * var("C") * var("turns")
STRIP, STRIP_LENGTH = 0.64 * W, 0.31 * W
"""On a phone the stage has a small x(t) of its own."""
FIRST = 132
"""Pixels of the words left of the start arrow; it stands under the turning one."""

WAYS = (("x", "m1", ""), ("v", "T", "thin"), ("a", "F", "thin"))
NAMES = {"x": "*x*", "v": "*v*/*ω*_n", "a": "*a*/*ω*_n²"}
REACH = {"x": (15, 13), "v": (26, 16), "a": (30, 16)}
"""Pixels from the tip of an arrow to the middle of its name, across and up."""

StageVector = tuple[Number, Number]


def unit(name: str) -> StageVector:
    """The direction of the arrow of x, v or a, up positive: each a quarter turn ahead of the one before."""
    cosine, sine = var("cosine"), var("sine")
    return {"x": (cosine, sine), "v": (-1 * sine, cosine), "a": (-1 * cosine, -1 * sine)}[name]


def at(centre: StageVector, way: StageVector, length: Number) -> StageVector:
    return centre[0] + length * way[0], centre[1] - length * way[1]


def hero() -> list[Shape]:
    """Mass, tip of the arrow and curve on one level line."""
    now = WIDE * on_x("x", T) + NARROW * (STRIP + STRIP_LENGTH * T * var("per_window"))
    y = mass_height()
    return [
        line(0.04 * W, LEVEL, WIDE * (var("x.left") - 24) + NARROW * STRIP, LEVEL, style="eq", tint="mute"),
        line(MASS, y, now, y, style="level", tint="m1"),
        *strip(now, y),
        *table(y),
        *shown_by("turns", *turning((PIVOT, LEVEL))),
    ]


def height(x: Number) -> Expression:
    return LEVEL - SCALE * x


def mass_height() -> Expression:
    return height(var("x"))


START = (Begin("x_0", "x", "x"), Begin("v_0", "v", "v"))
"""Where the tip of the arrow is held: it says x and v."""


def beside(centre: Number, scale: Number) -> Callable[[Number], Number]:
    """The place of a velocity beside the middle of a circle: as far as x would be a quarter period later."""
    return lambda v: centre + scale * var("per_v") * v


MASS_GRAB = begin(
    "Mass, start",
    linear(height, "y", "x_0", moves="x", axis="x", rate="v_0"),
    start=(START[0], *at_rest("v_0")),
)
TIP_GRAB = begin(
    "Turning arrow, start",
    linear(height, "y", "x_0", moves="x", axis="x"),
    linear(beside(PIVOT, SCALE), "x", "v_0", moves="v", axis="v"),
    start=START,
)


def table(y: Number) -> list[Shape]:
    """The table seen from above: wall, spring and mass; x points up, as in the plot."""
    side = 0.2 * FRAME * var("side")
    foot = WIDE * (var("x.top") + 1.2 * FRAME) + NARROW * (LEVEL + 0.42 * H)
    aside = MASS - 0.5 * side - 13
    return [
        wall(MASS - 42, foot, 84, side="bottom"),
        spring(MASS, y + 0.5 * side, MASS, foot, var("wire"), height=13, show="wire"),
        box(MASS, y + 0.5 * side, side, "*m*", tint="m1", grab=MASS_GRAB),
        arrow(aside, LEVEL, aside, y, tint="m1"),
        *pulled(MASS + 0.5 * side + 13, y, LEVEL),
        text(MASS + 38, 16, f"*x* = {{x}} {N.x_unit}", "start", tint="m1", style="t2 b halo"),
        text(
            MASS + 52, foot + 4, "smooth table, seen from above", "start", tint="mute", style="halo", show="wide desk"
        ),
    ]


def turning(centre: StageVector) -> list[Shape]:
    """The arrow of x and its two companions, all drawn at the length C, on their circle."""
    found = [*cross(centre, RADIUS), *right_angles(centre)]
    for name, tint, style in reversed(WAYS):
        tip = at(centre, unit(name), RADIUS)
        found.append(arrow(*centre, *tip, tint=tint, style=style, head=13 if name == "x" else 11, held=name == "x"))
    found.append(circle(*centre, 4, tint="ink"))
    start = (var("start_cosine"), var("start_sine"))
    found += [
        circle(*at(centre, start, RADIUS), 4, style="ghost", tint="mute"),
        circle(beside(centre[0], SCALE)(var("v")), height(var("x")), 5, tint="m1", grab=TIP_GRAB),
    ]
    for name, tint, _ in WAYS:
        (x, y), (across, up) = unit(name), REACH[name]
        place = centre[0] + (RADIUS + across) * x, centre[1] - (RADIUS + up) * y + 5
        found.append(text(*place, NAMES[name], tint=tint, style="t2 b halo told"))
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
    for one, other in (("x", "v"), ("v", "a")):
        a, b = unit(one), unit(other)
        corner = at(centre, (a[0] + b[0], a[1] + b[1]), 13)
        found += [
            line(*at(centre, a, 13), *corner, style="floor told"),
            line(*corner, *at(centre, b, 13), style="floor told"),
        ]
    return found


def strip(now: Number, y: Number) -> list[Shape]:
    """The small x(t) on a phone, with its cursor."""
    top, bottom = LEVEL - 0.34 * H, LEVEL + 0.34 * H
    curve = wave(
        STRIP, LEVEL, STRIP_LENGTH, RADIUS, var("swings"), var("phi"), style="sum", tint="m1", show="narrow swings"
    )
    marks = [line(now, top, now, bottom, style="now"), circle(now, y, 5, tint="m1")]
    return [curve, *shown_by("narrow", *marks)]


def _start_grab(x: Number, y: Number, scale: Number) -> Grab:
    """The tip of the arrow at the start, about (x, y): up is x_0, across v_0."""
    return grab(
        "Arrow at the start",
        linear(lambda value: y - scale * value, "y", "x_0", moves="x_start", axis="x"),
        linear(beside(x, scale), "x", "v_0", moves="v_start", axis="v"),
    )


def first() -> list[Shape]:
    """The arrow at t = 0: its legs are A and B; atan would send it the other way where v_0 < 0."""
    centre = (WIDE * (0.635 * (W + FIRST) - FIRST) + NARROW * 0.5 * W, 0.5 * H)
    scale = WIDE * SCALE + NARROW * 0.42 * H * var("per_x")
    radius = scale * var("C")
    way = (var("start_cosine"), var("start_sine"))
    x, y = centre
    foot = (beside(x, scale)(var("v_start")), y)
    tip = (foot[0], y - scale * var("x_start"))
    wrong = at(centre, (-1 * way[0], -1 * way[1]), radius)
    middle = at(centre, (var("middle_cosine"), var("middle_sine")), 40)
    aside = at(centre, (way[0] - 0.22 * way[1], way[1] + 0.22 * way[0]), 0.58 * radius)
    quarter = pi / 2
    shapes = [
        *cross(centre, radius),
        line(*centre, *wrong, style="dotted", tint="mute", show="atan"),
        circle(*wrong, 4, style="ghost", tint="mute", show="atan"),
        text(wrong[0] + 10, wrong[1] + 5, "atan", "start", tint="mute", style="halo", show="atan"),
        arc(x, y, 28, quarter, var("phi") + quarter, style="floor", tint="ink"),
        line(x, y, *foot, style="sum", tint="T"),
        line(*foot, *tip, style="sum", tint="m1"),
        arrow(x, y, *tip, tint="m1", head=13, grab=_start_grab(x, y, scale), held=True),
        circle(x, y, 4, tint="ink"),
        text(middle[0], middle[1] + 5, "*φ*", style="t2 b halo", show="has_phi"),
        text(x + 0.5 * radius * way[0], y + 13 * var("under") + 5, "*B*", tint="T", style="t2 b halo", show="has_B"),
        text(
            foot[0] + 13 * var("outside"),
            y - 0.5 * radius * way[1] + 5,
            "*A*",
            tint="m1",
            style="t2 b halo",
            show="has_A",
        ),
        text(aside[0], aside[1] + 5, "*C*", tint="m1", style="t2 b halo", show="has_A has_B"),
    ]
    return shown_by("turns", *shapes)


def lead(late: str, early: str) -> tuple[Shape, ...]:
    """Over the plot of v or a: from a peak of what is late to the peak of what leads it by a quarter period."""
    a, b = on_x(early, var(f"peak_{late}")), on_x(early, var(f"peak_{early}"))
    y = on_y(early, var(f"top_{early}")) - 11
    shapes = (
        line(a, on_y(late, var(f"top_{late}")), a, y + 5, style="eq", tint="mute"),
        line(b, y - 5, b, y + 11, style="floor"),
        arrow(a, y, b, y, style="thin", head=8),
        text((a + b) * 0.5, y - 6, "*τ*/4", style="b halo"),
    )
    return tuple(shown_by("leads", *shapes))


def planes() -> tuple[tuple[Shape, ...], tuple[Shape, ...]]:
    """Over the phase plane and over the law: names of the axes, and the lines shared with v(t), with a(t), in x."""
    x = on_x("plane", var("x"))
    links = (
        line(on_x("v", T), on_y("v", var("v")), x, on_y("plane", var("v")), style="level", tint="mute", show="wide"),
        line(x, on_y("plane", var("v")), x, on_y("law", var("a")), style="level", tint="mute", show="wide"),
        line(on_x("a", T), on_y("a", var("a")), x, on_y("law", var("a")), style="level", tint="mute", show="wide"),
    )
    held = begin(
        "Point of the phase plane, start",
        on_plot("plane", "x", "x_0", "x", "x"),
        on_plot("plane", "y", "v_0", "v", "v"),
        start=START,
    )
    point = circle(x, on_y("plane", var("v")), 4.5, grab=held)
    return (*links, *axis_names("plane", "v", "T"), point), tuple(axis_names("law", "a", "F"))


def axis_names(plot: str, upward: str, tint: str) -> list[Shape]:
    return [
        text(var(f"{plot}.right") + 4, on_y(plot, 0) - 6, "*x*", "end", tint="m1", style="t2 b halo"),
        text(on_x(plot, 0) + 7, var(f"{plot}.top") + 11, f"*{upward}*", "start", tint=tint, style="t2 b halo"),
    ]
