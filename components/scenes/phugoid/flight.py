"""The picture of a flight: its path with the aircraft, the equivalent spring, and the shapes over the plots of periods
and of velocities.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from components.language.expressions import Number, var
from components.language.shapes import Trade
from components.layout.grabs import begin, grab, on_plot
from components.layout.stage import (
    HALL,
    NARROW,
    ON_NARROW,
    ON_WIDE,
    WIDE,
    Looks,
    PlotFrame,
    Shape,
    W,
    arrow,
    box,
    circle,
    line,
    path,
    shown_by,
    spring,
    text,
    wall,
)
from components.quantities.declared import Declared, Family, Scalar
from components.scenes.phugoid.axes import Axes as A
from components.scenes.phugoid.curves import Signals as S
from components.scenes.phugoid.numbers import Numbers as N
from components.scenes.phugoid.swing import AIRCRAFT, Swing
from physics.phugoid import flight, linear_phugoid

PATH, PERIOD, VELOCITY = PlotFrame("path"), PlotFrame("period"), PlotFrame("velocity")
HULL = (
    "M27 0C26-3.6 18-4.8 10-5.2C7-9.4-1-9.8-5-5.8L-18-3.6L-24-12.5L-29-12.5"
    "L-26.5-1C-16 4.4 6 6 18 5C23 4.4 27 2.8 27 0Z"
)
WING = "M11 1.6C7-.6-5-.4-10 1.9C-5 3.6 7 3.6 11 1.6Z"
PROPELLER = "M28-9V9"

SIZE = 0.45 + W * 0.0006
"""The size of the aircraft relative to its drawing."""
SIDE, APART = 32, 104
"""The mass of the spring, and the distance of the spring from the frame in pixels."""
BESIDE = WIDE * 225 + NARROW * 165
"""The position of v', next to h', with room for its value in the compared picture."""
X, Y = PATH.x(var(S.x)), PATH.y(var(S.y))
"""The aircraft of the exact flight."""
FLOWN: Looks = {"inside": PATH}

scalar = Scalar[Swing]


class Places(Declared[Swing]):
    is_lift = scalar(lambda s, a: s.view == "lift")
    excess = scalar(lambda s, a: s.excess)
    head = scalar(lambda s, a: A.up(a).place(s.length))
    # The first maxima of both paths. If many periods share the frame, there is no room for their names.
    top_x = scalar(lambda s, a: A.along(a).place(s.top[0]))
    top_y = scalar(lambda s, a: A.up(a).place(s.top[1]))
    top_lin_x = scalar(lambda s, a: A.along(a).place(s.top_linear[0]))
    top_lin_y = scalar(lambda s, a: A.up(a).place(s.top_linear[1]))
    named = scalar(lambda s, a: s.top[0] > 0.07 * A.along(a).end)
    # Next to a wide loop the others are too small for names.
    family_named = scalar(lambda s, a: A.upward(a).end < 2)
    # The speed and the period of this aircraft, and of the examples.
    v_here = scalar(lambda s, a: A.v_0(a).place(s.v_0))
    tau_here = scalar(lambda s, a: A.tau(a).place(s.linear.tau))
    at = Family(AIRCRAFT, lambda name: scalar(lambda s, a: A.v_0(a).place(AIRCRAFT[name][1])))
    tau_at = Family(
        AIRCRAFT, lambda name: scalar(lambda s, a: A.tau(a).place(linear_phugoid(AIRCRAFT[name][1], s.g).tau))
    )


QUIET: Looks = {"tint": "mute", "style": "t0 halo given names-dashed"}


def flight_shapes() -> list[Shape]:
    """Spring, level line, both aircraft and the arrows of h' and v over the plot of the path."""
    level, left = PATH.y(0), PATH.left
    x_lin, y_lin = PATH.x(var(S.x_lin)), PATH.y(var(S.y_lin))
    u, w = var(S.u), var(S.w)
    return [
        *_labels(left, level),
        line(left, level, PATH.right, level, tint="mute", style="eq"),
        line(left, PATH.bottom, PATH.right, PATH.bottom, style="floor"),
        *_spring(left - APART, y_lin, level, PATH.bottom),
        line(left - APART + SIDE / 2, y_lin, x_lin, y_lin, tint="V", style="dots", **FLOWN),
        line(left - APART + SIDE / 2, y_lin, left, y_lin, tint="V", style="dots"),
        _aircraft(HULL, "fine", x_lin, y_lin, var(S.u_lin), var(S.w_lin), SIZE),
        arrow(X, level, X, Y, tint="V", **FLOWN),
        arrow(X, Y, X + 50 * SIZE * u, Y - 50 * SIZE * w, gap=34 * SIZE, head=12, tint="T", **FLOWN),
        *(
            _aircraft(part, style, X, Y, u, w, 1.15 * SIZE, held=part == HULL)
            for part, style in ((HULL, "fill"), (WING, "ghost fine"), (PROPELLER, "fine"))
        ),
        circle(X, Y, 0, grab=HELD, **FLOWN),
        # Large letters reach over the mass.
        text(PATH.right - 4, PATH.bottom - 6, "dashed: small swings", "end", show=ON_NARROW, **QUIET),
    ]


HELD = begin(
    "Aircraft, height at the start",
    Trade(
        parameter="excess", moves=S.y.name, axis=A.up.name, zero=PATH.y(0), unit=PATH.per_y, head=Places.head.name
    ),
    on_plot(PATH, "x", "", S.x, A.along),
)  # fmt: skip
"""The aircraft can be dragged: its height sets the extra speed, as far as the energy allows."""


def _aircraft(part: str, style: str, x: Number, y: Number, u: Number, w: Number, size: Number, **look: bool) -> Shape:
    """A part of an aircraft, turned in the direction of flight."""
    return path(part, x, y, dx=u, dy=-w, sx=size, sy=size, tint="m1", style=style, inside=PATH, **look)


def lift_shapes() -> list[Shape]:
    """Lift, perpendicular to the velocity, and weight, which is as long as the velocity of level flight."""
    unit: Number = 50 * SIZE
    tip = X + unit * var(S.lift_forward), Y - unit * var(S.lift_up)
    aside = NARROW * 18 - WIDE * 8  # on a phone it starts at the left edge
    named: Looks = {"style": "t2 b halo revealing", **FLOWN}
    return shown_by(
        Places.is_lift,
        arrow(X, Y, X, Y + unit, tint="k", style="thick", head=13, **FLOWN),
        arrow(X, Y, *tip, tint="F", style="thick", head=13, **FLOWN),
        text(X + 8, Y + unit - 4, "*m g*", anchor="start", tint="k", **named),
        text(tip[0] + aside, tip[1] + 12, "*L*", anchor="end", tint="F", **named),
    )


def _labels(left: Number, level: Number) -> list[Shape]:
    above = 6 + 15 * SIZE  # the aircraft passes below them
    top, top_lin = (
        (PATH.x(var(x)), PATH.y(var(y)) - above)
        for x, y in ((Places.top_x, Places.top_y), (Places.top_lin_x, Places.top_lin_y))
    )
    named: Looks = {"tint": "m1", "style": "halo which", "show": Places.named}
    return [
        text(0, 17, f"height *h*′ = {S.h} {N.h_unit}", anchor="start", tint="V", style="t2 b"),
        text(BESIDE, 17, f"extra speed *v*′ = {S.v} {N.v_unit}", anchor="start", tint="T", style="t2 b"),
        text(left - 8, level + 5, "level *h*_0", anchor="end", style="t2 b halo"),
        text(top[0] - 4, top[1], "exact", anchor="end", **named),
        text(top_lin[0] + 4, top_lin[1], "linear", anchor="start", **named),
    ]


def _spring(x: Number, y: Number, level: Number, foot: Number) -> list[Shape]:
    half = SIDE / 2
    return [
        line(x - 32, level, x + 32, level, tint="mute", style="eq"),
        wall(x - 32, foot, 64, side="bottom"),
        spring(x, foot, x, y + half, 2.2, height=10),
        box(x, y + half, SIDE, "*m*", tint="m1"),
    ]


def period_shapes() -> list[Shape]:
    """Positions of the examples, and the lines from the point of this aircraft to both axes."""
    x, y = PERIOD.x(var(Places.v_here)), PERIOD.y(var(Places.tau_here))
    shapes = [
        line(PERIOD.left, y, x, y, tint="mute", style="eq"),
        line(x, y, x, PERIOD.bottom, tint="T"),
    ]
    for name in AIRCRAFT:
        at, tau = PERIOD.x(var(Places.at[name])), PERIOD.y(var(Places.tau_at[name]))
        shapes += [line(at, tau, at, PERIOD.top, tint="rule", style="hair"), circle(at, tau, 5)]
    return [
        *shapes,
        circle(x, y, 6, tint="T"),
        text(PERIOD.left + 8, PERIOD.top + 14 + 16 * HALL, "period *τ*", anchor="start", tint="mute", style="halo"),
        text(PERIOD.right - 4, PERIOD.bottom - 10, "speed *v*_0", anchor="end", tint="mute", style="halo"),
    ]


def velocity_shapes() -> list[Shape]:
    """The velocity from standstill to its tip, over a plot of u - v_0 and w in v_0."""
    plot = VELOCITY
    still, level, start = plot.x(-1), plot.y(0), plot.x(var(Places.excess))
    tip = plot.x(var(S.u) - 1), plot.y(var(S.w))
    held = grab("Speed at the start", on_plot(plot, "x", "excess", Places.excess, A.forward))
    own: Looks = {"inside": plot}
    loop, places = (
        {"tint": "mute", "style": "halo", **own},
        (
            (plot.x(1.06), "start", ON_WIDE),
            (plot.right - 4, "end", ON_NARROW),
        ),
    )
    return [
        line(still, plot.top, still, plot.bottom, tint="rule", style="hair", **own),
        line(start, level, start, plot.bottom, tint="T", **own),
        arrow(still, level, *tip, head=13, tint="T", **own),
        circle(still, level, 5, **own),
        circle(plot.x(0), level, 4, **own),
        circle(start, level, 5, tint="T", grab=held, **own),
        circle(*tip, 6, tint="m1", **own),
        *shown_by(
            Places.family_named,
            text(plot.x(0), level - 10, "*C* = 2/3", style="halo", **own),
            text(plot.x(0.68), plot.y(0.68), "cusp, *C* = 0", anchor="start", style="b halo", **own),
            *(text(x, plot.y(0.3), "loop, *C* = −0.667", anchor, show=screen, **loop) for x, anchor, screen in places),
        ),
        text(still - 6, plot.top + 12, "up", anchor="end", tint="mute", style="halo", **own),
        text(plot.right, level - 7, "forward", anchor="end", tint="mute", style="halo", **own),
    ]


@cache
def outline(excess: float) -> str:
    """The path of slightly more than two periods, as SVG path data in a box of 128 by 46."""
    motion = flight(1.0, 1.0, excess, np.linspace(0.0, 9.6, 120))
    width, height = float(np.ptp(motion.x)), float(np.ptp(motion.h))
    scale = min(120 / width, 36 / max(height, 0.2))
    x = 64 + scale * (motion.x - motion.x.min() - width / 2)
    y = 23 - scale * (motion.h - motion.h.min() - height / 2)
    return "M" + "L".join(f"{a:.1f} {b:.1f}" for a, b in zip(x, y, strict=True))
