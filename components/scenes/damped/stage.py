"""The stage of the damped mass, and what is drawn over its plots: the stairs from peak to peak, the fastest moment, the
roots in their plane."""

from __future__ import annotations

import math

from components.dashpot import apparatus
from components.language.numbers import Number, var
from components.language.shapes import Begin, Root
from components.layout.grabs import at_rest, begin, grab, linear
from components.layout.stage import (
    NARROW,
    WIDE,
    H,
    Shape,
    T,
    W,
    arrow,
    circle,
    line,
    on_x,
    on_y,
    path,
    shown_by,
    text,
    wall,
)
from components.scenes.damped.case import MOST_PEAKS
from components.scenes.damped.numbers import Numbers as N
from components.scenes.damped.places import NAMED, STAIRS, TICKS

SQUARE = "M0 0H1V1H0Z"
MIDDLE = WIDE * 0.52 * W + NARROW * 0.3 * W
"""Where the block stands, across the stage."""
LEVEL = WIDE * on_y("x", 0) + NARROW * 0.3 * H
STROKE = WIDE * 0.8 * (var("x.bottom") - var("x.top")) + NARROW * 0.24 * H
"""The way of the block from the lowest x of the frame to the highest, in pixels; shorter on a phone."""
SCALE = WIDE * -1 * var("x.y1") + NARROW * 0.12 * H * var("per_reach")
SIDE = (WIDE * 56 + NARROW * 42) * var("side")
LONGEST = 0.36
"""The longest arrow of a force, over the stroke."""


def height(x: Number) -> Number:
    return LEVEL - SCALE * x


MASS_GRAB = begin(
    "Mass, start",
    linear(height, "y", "x_0", moves="x", axis="x", rate="v_0"),
    start=(Begin("x_0", "x", "x"), *at_rest("v_0")),
)


def block() -> list[Shape]:
    """Block, spring and dashpot on their wall, on one level line with the curve."""
    y = height(var("x"))
    lowest = LEVEL + 0.5 * STROKE + 0.5 * SIDE
    aside, foot = MIDDLE - 0.5 * SIDE - 15, lowest + STROKE + 35
    return [
        line(0.03 * W, LEVEL, WIDE * (var("x.left") - 30) + NARROW * 0.55 * W, LEVEL, style="eq", tint="mute"),
        line(MIDDLE, y, on_x("x", T), y, style="level", tint="m1", show="wide"),
        *apparatus(MIDDLE, y, SIDE, lowest, STROKE, var("wire"), MASS_GRAB),
        arrow(aside, LEVEL, aside, y, tint="m1"),
        *_forces(y),
        text(
            WIDE * 2 + NARROW * 0.58 * W, WIDE * 16 + NARROW * 0.28 * H, f"*x* = {{x}} {N.x_unit}", "start", tint="m1",
            style="t2 b halo",
        ),
        text(2, foot + 28, "smooth table,", "start", tint="mute", style="halo", show="wide desk"),
        text(2, foot + 44, "seen from above", "start", tint="mute", style="halo", show="wide desk"),
    ]  # fmt: skip


def _forces(y: Number) -> list[Shape]:
    """The forces of spring and dashpot on the block, from its middle: up is away from the wall."""
    left, right = MIDDLE - 0.5 * SIDE - 15, MIDDLE + 0.5 * SIDE + 15
    pull, brake = LONGEST * STROKE * var("per_x") * var("x"), LONGEST * STROKE * var("per_v") * var("v")
    look = {"style": "thick", "head": 14}
    return shown_by(
        "forced",
        *shown_by(
            "pulls",
            arrow(left, y, left, y + pull, tint="k", **look),
            text(left - 9, y + pull + 5, "−*kx*", "end", tint="k", style="b halo"),
        ),
        *shown_by(
            "brakes",
            arrow(right, y, right, y + brake, tint="T", **look),
            text(right + 9, y + brake + 5, "−*cv*", "start", tint="T", style="b halo"),
        ),
    )


def stairs() -> tuple[Shape, ...]:
    """Over x(t): from each peak a level line of one period, and the drop to the next; their share is the same."""
    shapes: list[Shape] = []
    for i in STAIRS:
        here, there = (on_x("x", var(f"peak_{n}_t")) for n in (i, i + 1))
        level, low = (on_y("x", var(f"peak_{n}_x")) for n in (i, i + 1))
        shapes += shown_by(
            f"stair_{i}",
            line(here, level, there, level, style="eq", tint="ink"),
            arrow(there, level, there, low, tint="ink", style="thin", head=8),
            text(there + 7, (level + low) * 0.5 + 4.5, f"{N.keep_x}", "start", style="b halo"),
        )
    for i in range(MOST_PEAKS):
        x, y = on_x("x", var(f"peak_{i}_t")), on_y("x", var(f"peak_{i}_x"))
        shapes.append(circle(x, y, 3.5, tint="m1", show=f"peak_{i}"))
    first, second = ((on_x("x", var(f"peak_{n}_t")), on_y("x", var(f"peak_{n}_x"))) for n in (0, 1))
    shapes += shown_by(
        "stair_0",
        text(first[0] + 8, first[1] - 11.5 * var("over") + 4.5, "*x*_1", "start", tint="m1", style="t2 b halo"),
        text(second[0], second[1] + 16 * var("over") + 4.5, "*x*_2", tint="m1", style="t2 b halo"),
        text(first[0] + 28, first[1] - 11.5 * var("over") + 4.5, f"*τ*_d {N.tau_d} s", "start", style="b halo"),
    )
    return (*shapes, *_fastest("x"))


def _fastest(plot: str) -> list[Shape]:
    """Over each plot a ring where the mass is fastest, or the line through it."""
    x, top, bottom = on_x(plot, var("top_t")), var(f"{plot}.top"), var(f"{plot}.bottom")
    rings = {"x": on_y("x", var("top_x")), "P": on_y("P", var("top_P"))}
    start, end = (rings["x"], bottom) if plot == "x" else (top, rings.get(plot, bottom))
    found = [line(x, start, x, end, style="eq", tint="mute", inside=plot)]
    if plot in rings:
        found.append(circle(x, rings[plot], 4.5, style="ghost", tint="ink", inside=plot))
    return shown_by("top", *found)


def over_energy() -> tuple[Shape, ...]:
    return tuple(_fastest("energy"))


def over_power() -> tuple[Shape, ...]:
    return tuple(_fastest("P"))


ROOT_GRAB = grab(
    "Root",
    Root(
        across="x", zero=on_x("roots", 0), unit=-1 * var("roots.x1") * var("unit"), parameter="zeta", moves="root",
        least=0.0,
    ),
    inside="roots",
)  # fmt: skip
SLOW_GRAB = grab(
    "Slow root",
    Root(
        across="x", zero=on_x("roots", 0), unit=-1 * var("roots.x1") * var("unit"), parameter="zeta",
        moves="slow_root", least=0.01, most=1.0, real=True,
    ),
    inside="roots",
)  # fmt: skip


def roots() -> tuple[Shape, ...]:
    """The plane of the roots: the wall of c < 0, the circle of the natural frequency with the scale of zeta."""
    x0, y0, radius = on_x("roots", 0), on_y("roots", 0), var("roots.x1") * var("unit")
    top, bottom, right = var("roots.top"), var("roots.bottom"), var("roots.right")
    return (
        path(SQUARE, x0, top, sx=right - x0, sy=bottom - top, style="body", tint="k2fill"),
        line(var("roots.left"), y0, x0, y0, style="floor", tint="ink"),
        wall(x0, top, bottom - top, side="right"),
        text(x0 + 16, y0 - 4, "*c* < 0:", "start", tint="mute"),
        text(x0 + 16, y0 + 13, "not allowed", "start", tint="mute"),
        *shown_by("circle", *_circle(x0, y0, radius)),
        *shown_by("legs", *_legs(x0, y0)),
        *_held(x0, y0),
        text(var("roots.left") + 4, bottom - 24, "left: dies faster", "start", tint="mute"),
        text(var("roots.left") + 4, bottom - 8, "up: swings faster", "start", tint="mute"),
    )


def _circle(x0: Number, y0: Number, radius: Number) -> list[Shape]:
    """The scale of zeta along the left half of |s| = omega_n."""
    found: list[Shape] = []
    for zeta in TICKS:
        x, y = -zeta, math.sqrt(1 - zeta * zeta)
        inner, outer, name = ((x0 + far * x * radius, y0 - far * y * radius) for far in (0.97, 1.03, 1.12))
        found += [
            line(*inner, *outer, style="floor", tint="T", inside="roots"),
            text(name[0], name[1] + 4, f"{zeta}", tint="T", inside="roots", show="" if zeta in NAMED else "desk"),
        ]
    return [*found, text(x0 - 0.94 * radius, y0 - 7, "critical 1", "start", tint="T", style="halo", inside="roots")]


def _legs(x0: Number, y0: Number) -> list[Shape]:
    """The triangle of the upper root: its rate, its frequency, and the natural frequency as the radius."""
    x, y = on_x("roots", -1 * var("root") * var("unit")), on_y("roots", var("root_y"))
    return [
        line(x0, y0, x, y, style="thin", tint="ink"),
        line(x0, y0, x, y0, style="sum", tint="T"),
        line(x, y0, x, y, style="sum", tint="m1"),
        text(x - 8, (y + y0) * 0.5 + 4, f"*ω*_n {N.omega}", "end", style="b halo"),
        text((x + x0) * 0.5 - 4, y0 + 19, f"*ζω*_n {N.a}", "end", tint="T", style="b halo"),
        text(x0 + 16, y + 5, f"*ω*_d {N.omega_d}", "start", tint="m1", style="b"),
    ]


def _held(x0: Number, y0: Number) -> list[Shape]:
    """The roots: the one in hand is filled."""
    x, y = on_x("roots", -1 * var("root") * var("unit")), on_y("roots", var("root_y"))
    slow, edge = on_x("roots", -1 * var("slow_root") * var("unit")), var("roots.left") + 4
    bare = on_x("roots", var("fast_at"))
    return [
        *shown_by("pair", circle(x, 2 * y0 - y, 6, style="ghost", tint="ink")),
        *shown_by(
            "held_root",
            circle(x, y, 8, tint="ink", grab=ROOT_GRAB),
        ),
        *shown_by("pair", text(x - 14, y - 12, f"*ζ* {N.zeta}", "end", tint="T", style="t2 b halo")),
        *shown_by(
            "real",
            circle(slow, y0, 8, tint="ink", grab=SLOW_GRAB),
            text(slow, y0 - 17, f"*ζ* {N.zeta}", tint="T", style="t2 b halo"),
        ),
        *shown_by("apart", text(slow, y0 + 25, f"{N.slow}", style="b halo")),
        *shown_by(
            "out",
            arrow(edge + 34, y0, edge, y0, tint="ink", style="thin"),
            text(edge, y0 + 21, f"{N.fast}", "start", style="b halo"),
        ),
        *shown_by(
            "bare",
            circle(x0, y0, 6, style="ghost", tint="ink"),
            circle(bare, y0, 6, style="ghost", tint="ink", inside="roots"),
        ),
    ]
