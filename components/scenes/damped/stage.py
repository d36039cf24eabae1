"""The stage of the damped mass, and what is drawn over its plots: the stairs from peak to peak, the fastest moment, the
roots in their plane."""

from __future__ import annotations

import math

from components.dashpot import apparatus
from components.language.numbers import Number, var
from components.language.shapes import Root
from components.layout.grabs import at_rest, begin, begins, grab, linear
from components.layout.stage import (
    AT_DESK,
    NARROW,
    ON_WIDE,
    WIDE,
    H,
    PlotFrame,
    Shape,
    T,
    W,
    arrow,
    circle,
    line,
    path,
    shown_by,
    text,
    wall,
)
from components.scenes.damped.curves import Axes
from components.scenes.damped.curves import Signals as S
from components.scenes.damped.numbers import Numbers as N
from components.scenes.damped.places import NAMED, PEAKS, STAIRS, TICKS, Arrows
from components.scenes.damped.places import Places as P

X, ENERGY, POWER, ROOTS = PlotFrame("x"), PlotFrame("energy"), PlotFrame("P"), PlotFrame("roots")
SQUARE = "M0 0H1V1H0Z"
MIDDLE = WIDE * 0.52 * W + NARROW * 0.3 * W
"""Where the block stands, across the stage."""
LEVEL = WIDE * X.y(0) + NARROW * 0.3 * H
STROKE = WIDE * 0.8 * (X.bottom - X.top) + NARROW * 0.24 * H
"""The way of the block from the lowest x of the frame to the highest, in pixels; shorter on a phone."""
SCALE = WIDE * -1 * X.per_y + NARROW * 0.12 * H * var(P.per_reach)
SIDE = (WIDE * 56 + NARROW * 42) * var(P.side)
LONGEST = 0.36
"""The longest arrow of a force, over the stroke."""


def height(x: Number) -> Number:
    return LEVEL - SCALE * x


MASS_GRAB = begin(
    "Mass, start",
    linear(height, "y", "x_0", S.x, Axes.x, rate="v_0"),
    start=(begins("x_0", S.x, Axes.x), *at_rest("v_0")),
)


def block() -> list[Shape]:
    """Block, spring and dashpot on their wall, on one level line with the curve."""
    y = height(var(S.x))
    lowest = LEVEL + 0.5 * STROKE + 0.5 * SIDE
    aside, foot = MIDDLE - 0.5 * SIDE - 15, lowest + STROKE + 35
    return [
        line(0.03 * W, LEVEL, WIDE * (X.left - 30) + NARROW * 0.55 * W, LEVEL, style="eq", tint="mute"),
        line(MIDDLE, y, X.x(T), y, style="level", tint="m1", show=ON_WIDE),
        *apparatus(MIDDLE, y, SIDE, lowest, STROKE, var(P.wire), MASS_GRAB),
        arrow(aside, LEVEL, aside, y, tint="m1"),
        *_forces(y),
        text(
            WIDE * 2 + NARROW * 0.58 * W, WIDE * 16 + NARROW * 0.28 * H, f"*x* = {S.x} {N.x_unit}", "start", tint="m1",
            style="t2 b halo",
        ),
        text(2, foot + 28, "smooth table,", "start", tint="mute", style="halo", show=(ON_WIDE, AT_DESK)),
        text(2, foot + 44, "seen from above", "start", tint="mute", style="halo", show=(ON_WIDE, AT_DESK)),
    ]  # fmt: skip


def _forces(y: Number) -> list[Shape]:
    """The forces of spring and dashpot on the block, from its middle: up is away from the wall."""
    left, right = MIDDLE - 0.5 * SIDE - 15, MIDDLE + 0.5 * SIDE + 15
    pull, brake = (
        LONGEST * STROKE * var(Arrows.per_x) * var(S.x),
        LONGEST * STROKE * var(Arrows.per_v) * var(S.v),
    )
    look = {"style": "thick", "head": 14}
    return [
        *shown_by(
            Arrows.pulls,
            arrow(left, y, left, y + pull, tint="k", **look),
            text(left - 9, y + pull + 5, "−*kx*", "end", tint="k", style="b halo"),
        ),
        *shown_by(
            Arrows.brakes,
            arrow(right, y, right, y + brake, tint="T", **look),
            text(right + 9, y + brake + 5, "−*cv*", "start", tint="T", style="b halo"),
        ),
    ]


def stairs() -> tuple[Shape, ...]:
    """Over x(t): from each peak a level line of one period, and the drop to the next; their share is the same."""
    shapes: list[Shape] = []
    for i in STAIRS:
        here, there = (X.x(var(P.peak_t[n])) for n in (i, i + 1))
        level, low = (X.y(var(P.peak_x[n])) for n in (i, i + 1))
        shapes += shown_by(
            P.stair[i],
            line(here, level, there, level, style="eq", tint="ink"),
            arrow(there, level, there, low, tint="ink", style="thin", head=8),
            text(there + 7, (level + low) * 0.5 + 4.5, f"{N.keep_x}", "start", style="b halo"),
        )
    for i in PEAKS:
        x, y = X.x(var(P.peak_t[i])), X.y(var(P.peak_x[i]))
        shapes.append(circle(x, y, 3.5, tint="m1", show=P.peak[i]))
    first, second = ((X.x(var(P.peak_t[n])), X.y(var(P.peak_x[n]))) for n in (0, 1))
    shapes += shown_by(
        P.stair[0],
        text(first[0] + 8, first[1] - 11.5 * var(P.over) + 4.5, "*x*_1", "start", tint="m1", style="t2 b halo"),
        text(second[0], second[1] + 16 * var(P.over) + 4.5, "*x*_2", tint="m1", style="t2 b halo"),
        text(first[0] + 28, first[1] - 11.5 * var(P.over) + 4.5, f"*τ*_d {N.tau_d} s", "start", style="b halo"),
    )
    return (*shapes, *_fastest(X, X.y(var(P.top_x))))


def _fastest(plot: PlotFrame, level: Number | None = None) -> list[Shape]:
    """Over a plot a line where the mass is fastest, and a ring where the curve is at that level."""
    x, ring = plot.x(var(P.top_t)), [] if level is None else [level]
    start, end = (level or 0.0, plot.bottom) if plot is X else (plot.top, level or plot.bottom)
    return shown_by(
        P.top,
        line(x, start, x, end, style="eq", tint="mute", inside=plot),
        *(circle(x, y, 4.5, style="ghost", tint="ink", inside=plot) for y in ring),
    )


def over_energy() -> tuple[Shape, ...]:
    return tuple(_fastest(ENERGY))


def over_power() -> tuple[Shape, ...]:
    return tuple(_fastest(POWER, POWER.y(var(P.top_P))))


ROOT_GRAB = grab(
    "Root",
    Root(
        across="x", zero=ROOTS.x(0), unit=-1 * ROOTS.per_x * var(P.unit), parameter="zeta", moves=P.root.name,
        least=0.0,
    ),
    inside=ROOTS,
)  # fmt: skip
SLOW_GRAB = grab(
    "Slow root",
    Root(
        across="x", zero=ROOTS.x(0), unit=-1 * ROOTS.per_x * var(P.unit), parameter="zeta",
        moves=P.slow_root.name, least=0.01, most=1.0, real=True,
    ),
    inside=ROOTS,
)  # fmt: skip


def roots() -> tuple[Shape, ...]:
    """The plane of the roots: the wall of c < 0, the circle of the natural frequency with the scale of zeta."""
    x0, y0, radius = ROOTS.x(0), ROOTS.y(0), ROOTS.per_x * var(P.unit)
    top, bottom, right = ROOTS.top, ROOTS.bottom, ROOTS.right
    return (
        path(SQUARE, x0, top, sx=right - x0, sy=bottom - top, style="body", tint="k2fill"),
        line(ROOTS.left, y0, x0, y0, style="floor", tint="ink"),
        wall(x0, top, bottom - top, side="right"),
        text(x0 + 16, y0 - 4, "*c* < 0:", "start", tint="mute"),
        text(x0 + 16, y0 + 13, "not allowed", "start", tint="mute"),
        *shown_by(P.circle, *_circle(x0, y0, radius)),
        *shown_by(P.legs, *_legs(x0, y0)),
        *_held(x0, y0),
        text(ROOTS.left + 4, bottom - 24, "left: dies faster", "start", tint="mute"),
        text(ROOTS.left + 4, bottom - 8, "up: swings faster", "start", tint="mute"),
    )


def _circle(x0: Number, y0: Number, radius: Number) -> list[Shape]:
    """The scale of zeta along the left half of |s| = omega_n."""
    found: list[Shape] = []
    for zeta in TICKS:
        x, y = -zeta, math.sqrt(1 - zeta * zeta)
        inner, outer, name = ((x0 + far * x * radius, y0 - far * y * radius) for far in (0.97, 1.03, 1.12))
        found += [
            line(*inner, *outer, style="floor", tint="T", inside=ROOTS),
            text(name[0], name[1] + 4, f"{zeta}", tint="T", inside=ROOTS, show=() if zeta in NAMED else AT_DESK),
        ]
    return [*found, text(x0 - 0.94 * radius, y0 - 7, "critical 1", "start", tint="T", style="halo", inside=ROOTS)]


def _legs(x0: Number, y0: Number) -> list[Shape]:
    """The triangle of the upper root: its rate, its frequency, and the natural frequency as the radius."""
    x, y = ROOTS.x(-1 * var(P.root) * var(P.unit)), ROOTS.y(var(P.root_y))
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
    x, y = ROOTS.x(-1 * var(P.root) * var(P.unit)), ROOTS.y(var(P.root_y))
    slow, edge = ROOTS.x(-1 * var(P.slow_root) * var(P.unit)), ROOTS.left + 4
    bare = ROOTS.x(var(P.fast_at))
    return [
        *shown_by(P.pair, circle(x, 2 * y0 - y, 6, style="ghost", tint="ink")),
        *shown_by(
            P.held_root,
            circle(x, y, 8, tint="ink", grab=ROOT_GRAB),
        ),
        *shown_by(P.pair, text(x - 14, y - 12, f"*ζ* {N.zeta}", "end", tint="T", style="t2 b halo")),
        *shown_by(
            P.real,
            circle(slow, y0, 8, tint="ink", grab=SLOW_GRAB),
            text(slow, y0 - 17, f"*ζ* {N.zeta}", tint="T", style="t2 b halo"),
        ),
        *shown_by(P.apart, text(slow, y0 + 25, f"{N.slow}", style="b halo")),
        *shown_by(
            P.out,
            arrow(edge + 34, y0, edge, y0, tint="ink", style="thin"),
            text(edge, y0 + 21, f"{N.fast}", "start", style="b halo"),
        ),
        *shown_by(
            P.bare,
            circle(x0, y0, 6, style="ghost", tint="ink"),
            circle(bare, y0, 6, style="ghost", tint="ink", inside=ROOTS),
        ),
    ]
