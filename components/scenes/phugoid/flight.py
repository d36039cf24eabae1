"""The picture of a flight: its path with the aircraft on it, beside the spring it mimics."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
from msgspec.structs import replace

from components.language.numbers import Number, var
from components.language.shapes import Grab, Trade
from components.layout.grabs import begin, grab, on_plot
from components.layout.stage import (
    NARROW,
    WIDE,
    Looks,
    Shape,
    W,
    arrow,
    box,
    circle,
    line,
    on_x,
    on_y,
    path,
    spring,
    text,
    wall,
)
from components.quantities.axes import Axis, nice_axis, nice_ticks
from components.quantities.numbers import short
from components.scenes.phugoid.swing import Swing
from physics.phugoid import flight

HULL = (
    "M27 0C26-3.6 18-4.8 10-5.2C7-9.4-1-9.8-5-5.8L-18-3.6L-24-12.5L-29-12.5"
    "L-26.5-1C-16 4.4 6 6 18 5C23 4.4 27 2.8 27 0Z"
)
WING = "M11 1.6C7-.6-5-.4-10 1.9C-5 3.6 7 3.6 11 1.6Z"
PROPELLER = "M28-9V9"

ASPECT = 4.4
"""Width over height of the frame of the path on a desk."""
BEFORE = 0.3
"""Room before the start, in v_0^2/g: the length of the aircraft's tail."""
SIZE = 0.45 + W * 0.0006
"""The size of the aircraft beside that of its drawing."""
BOX = (128, 46)
SIDE, APART = 32, 104
"""The mass of the spring, and how far the spring stands before the frame, in pixels."""


def ground_axes(swing: Swing, window: float, unit: str, factor: float) -> tuple[Axis, Axis]:
    """Axes along and up, of one scale: as far as the flight comes in the window, or as wide as the swing asks for.

    Labels are in `unit`, which is `factor` metres.
    """
    length, size = swing.length, abs(swing.excess)
    low, high = min(float(swing.lap.h.min()), -size), max(float(swing.lap.h.max()), size)
    room = 0.16 * (high - low)
    end = max(swing.distance(window), ASPECT * (high - low + 2 * room), 0.5)
    along = _along(-BEFORE * length, end * length, unit, factor)
    half, middle = (end + BEFORE) / ASPECT / 2, (low + high) / 2
    up = _up(along, (middle - half) * length, (middle + half) * length)
    far = min(swing.distance(window), end)
    return (
        replace(along, drawn=(-BEFORE * length, far * length)),
        replace(up, drawn=(low * length, high * length)),
    )


def _along(low: float, high: float, unit: str, factor: float) -> Axis:
    """The horizontal axis; distances of five digits do without a power of ten."""
    axis = nice_axis(low, high, unit, 3, exact=True, factor=factor)
    if not 1e4 <= high / factor < 1e5:
        return axis
    return replace(axis, exponent=0, suffix="", ticks=nice_ticks(low / factor, high / factor, 3))


def _up(along: Axis, low: float, high: float) -> Axis:
    """The vertical axis in the unit of the horizontal one; its zero is named by the stage."""
    axis = replace(along, start=low, end=high, ticks=())
    ticks = nice_ticks(0.9 * axis.place(low), 0.9 * axis.place(high), 3)
    return replace(axis, ticks=tuple(tick for tick in ticks if tick))


def velocity_axes(swing: Swing) -> dict[str, Axis]:
    """Axes forward (of u - v_0, so that standstill is at -1) and up, in v_0; one frame for all but wide loops."""
    far = max(1.0, float(swing.lap.w.max()) / 1.05, (1 + swing.excess) / 3.05)
    low = min(-0.85, 1.15 * float(swing.lap.u.min()))
    ticks = tuple(float(i - 1) for i in range(-math.ceil(far), math.ceil(3.1 * far) + 1, math.ceil(far / 1.5)))
    labels = tuple(_times_v_0(tick + 1) for tick in ticks)
    return {
        "forward": Axis(low - 1, low + 3.9 * far - 1, ticks=ticks, labels=labels),
        "upward": Axis(-1.155 * far, 1.155 * far),
    }


def _times_v_0(number: float) -> str:
    return {0.0: "0", 1.0: "v₀", -1.0: "−v₀"}.get(number, f"{short(number)} v₀")


def flight_shapes(plot: str) -> list[Shape]:
    """Spring, level line, both aircraft and the arrows of h' and v over the plot of the path.

    Signals: x, y of the exact flight and x_lin, y_lin of the linear one in the unit of the axes; u, w and
    u_lin, w_lin forward and up in v_0.
    """
    level, foot, left, right = on_y(plot, 0), var(f"{plot}.bottom"), var(f"{plot}.left"), var(f"{plot}.right")
    x, y = on_x(plot, var("x")), on_y(plot, var("y"))
    x_lin, y_lin = on_x(plot, var("x_lin")), on_y(plot, var("y_lin"))
    own: Looks = {"inside": plot}
    return [
        *_labels(plot, left, level),
        line(left, level, right, level, tint="mute", style="eq"),
        line(left, foot, right, foot, style="floor"),
        *_spring(left - APART, y_lin, level, foot),
        line(left - APART + SIDE / 2, y_lin, x_lin, y_lin, tint="V", style="dots", **own),
        line(left - APART + SIDE / 2, y_lin, left, y_lin, tint="V", style="dots"),
        _aircraft(HULL, "fine", (x_lin, y_lin), (var("u_lin"), -var("w_lin")), SIZE, own),
        arrow(x, level, x, y, tint="V", **own),
        arrow(x, y, x + 50 * SIZE * var("u"), y - 50 * SIZE * var("w"), gap=34 * SIZE, head=12, tint="T", **own),
        *(
            _aircraft(part, style, (x, y), (var("u"), -var("w")), 1.15 * SIZE, {**own, "held": part == HULL})
            for part, style in ((HULL, "fill"), (WING, "ghost fine"), (PROPELLER, "fine"))
        ),
        circle(x, y, 0, grab=_held(plot), **own),
    ]


def _held(plot: str) -> Grab:
    """The aircraft in the hand: its height sets the excess of speed, as far as the energy allows."""
    height = Trade(parameter="excess", moves="y", axis="up", zero=on_y(plot, 0), unit=var(f"{plot}.y1"), head="head")
    return begin("Aircraft, height at the start", height, on_plot(plot, "x", "", "x", "along"))


def _aircraft(
    part: str, style: str, at: tuple[Number, Number], velocity: tuple[Number, Number], size: Number, look: Looks
) -> Shape:
    """A part of an aircraft, turned the way it flies."""
    dx, dy = velocity
    return path(part, *at, dx=dx, dy=dy, sx=size, sy=size, tint="m1", style=style, **look)


def lift_shapes(plot: str, show: str) -> list[Shape]:
    """Lift, upright to the velocity, and weight, which is as long as the velocity of level flight."""
    x, y = on_x(plot, var("x")), on_y(plot, var("y"))
    unit: Number = 50 * SIZE
    tip = x + unit * var("lift_forward"), y - unit * var("lift_up")
    aside = NARROW * 18 - WIDE * 8  # on a phone it starts at the left edge
    own: Looks = {"inside": plot, "show": show}
    return [
        arrow(x, y, x, y + unit, tint="k", style="thick", head=13, **own),
        arrow(x, y, *tip, tint="F", style="thick", head=13, **own),
        text(x + 8, y + unit - 4, "*m g*", anchor="start", tint="k", style="t2 b halo told", **own),
        text(tip[0] + aside, tip[1] + 12, "*L*", anchor="end", tint="F", style="t2 b halo told", **own),
    ]


def _labels(plot: str, left: Number, level: Number) -> list[Shape]:
    above = 6 + 15 * SIZE  # the aircraft comes by under them
    top, top_lin = ((on_x(plot, var(f"{name}_x")), on_y(plot, var(f"{name}_y")) - above) for name in ("top", "top_lin"))
    return [
        text(left - 8, level + 5, "*h*_0", anchor="end", style="t2 b halo"),
        text(top[0] - 4, top[1], "exact", anchor="end", tint="m1", style="halo which", show="named"),
        text(top_lin[0] + 4, top_lin[1], "linear", anchor="start", tint="m1", style="halo which", show="named"),
    ]


def _spring(x: Number, y: Number, level: Number, foot: Number) -> list[Shape]:
    half = SIDE / 2
    return [
        line(x - 32, level, x + 32, level, tint="mute", style="eq"),
        wall(x - 32, foot, 64, side="bottom"),
        spring(x, foot, x, y + half, 2.2, height=10),
        box(x, y + half, SIDE, "*m*", tint="m1"),
    ]


def velocity_shapes(plot: str, show: str) -> list[Shape]:
    """The velocity from standstill to its tip, over a plot of u - v_0 and w in v_0; the start is `excess`."""
    still = on_x(plot, -1)
    tip, level = (on_x(plot, var("u") - 1), on_y(plot, var("w"))), on_y(plot, 0)
    start = on_x(plot, var("excess"))
    own: Looks = {"inside": plot, "show": show}
    named = {**own, "show": f"{show} family_named"}
    return [
        line(still, var(f"{plot}.top"), still, var(f"{plot}.bottom"), tint="rule", style="hair", **own),
        line(start, level, start, var(f"{plot}.bottom"), tint="T", **own),
        arrow(still, level, *tip, head=13, tint="T", **own),
        circle(still, level, 5, **own),
        circle(on_x(plot, 0), level, 4, **own),
        circle(
            start,
            level,
            5,
            tint="T",
            grab=grab("Speed at the start", on_plot(plot, "x", "excess", "excess", "forward")),
            **own,
        ),
        circle(*tip, 6, tint="m1", **own),
        text(on_x(plot, 0), level - 10, "*C* = 2/3", style="halo", **named),
        text(on_x(plot, 0.68), on_y(plot, 0.68), "cusp, *C* = 0", anchor="start", style="b halo", **named),
        text(
            on_x(plot, 1.06),
            on_y(plot, 0.3),
            "loop, *C* = −0.667",
            anchor="start",
            tint="mute",
            style="halo",
            **named,
        ),
        text(still - 6, var(f"{plot}.top") + 12, "up", anchor="end", tint="mute", style="halo", **own),
        text(var(f"{plot}.right"), level - 7, "forward", anchor="end", tint="mute", style="halo", **own),
    ]


@cache
def outline(excess: float) -> str:
    """The path of a little more than two swings, as SVG path data in a box of 128 by 46."""
    motion = flight(1.0, 1.0, excess, np.linspace(0.0, 9.6, 120))
    width, height = float(np.ptp(motion.x)), float(np.ptp(motion.h))
    scale = min((BOX[0] - 8) / width, (BOX[1] - 10) / max(height, 0.2))
    x = BOX[0] / 2 + scale * (motion.x - motion.x.min() - width / 2)
    y = BOX[1] / 2 - scale * (motion.h - motion.h.min() - height / 2)
    return "M" + "L".join(f"{a:.1f} {b:.1f}" for a, b in zip(x, y, strict=True))
