"""The pictures of the hanging mass: natural length, equilibrium and mass as three lines; and the ball in its well."""

from __future__ import annotations

from components.language.numbers import Expression, Number, var
from components.layout.grabs import at_rest, begin, begins, linear, on_plot
from components.layout.stage import (
    HALL,
    NARROW,
    ON_NARROW,
    ON_WIDE,
    WIDE,
    H,
    Looks,
    Shape,
    T,
    W,
    arrow,
    box,
    circle,
    line,
    path,
    spring,
    text,
    wall,
    wave,
)
from components.scenes.energy.case import Axes
from components.scenes.energy.curves import ENERGY, PLANETS, WELL, X
from components.scenes.energy.curves import Places as P
from components.scenes.energy.curves import Signals as S
from components.scenes.energy.numbers import Numbers as N

CENTRE = WIDE * (0.5 * W + 16 * HALL) + NARROW * (0.12 * W + 100)
"""Where it hangs: on a phone names have room left of it, and planets right of it."""
HALF, ASIDE = WIDE * (62 - 8 * HALL) + NARROW * 40, WIDE * 45 + NARROW * 33
"""The reach of the levels to either side of it, and where arrows stand."""
STRIP, STRIP_LENGTH = 0.83 * W, 0.16 * W
"""On a phone the stage has a small x(t) of its own."""
SQUARE = "M0 0H1V1H0Z"
DEFLECTION, SHIFT = f"*δ*_{{st}} {N.delta_st}", f"½ *k δ*_{{st}}² = {N.shift}"
BAR = WIDE * 22 + NARROW * 8
BESIDE = {
    P.together: ("equilibrium", "= natural", "length"),
    P.close: ("equilibrium,", f"{N.delta_st} below", "natural length"),
}
"""Names of the equilibrium where it is the natural length, and where it is too close below for a name of its own."""


def height(x: Number) -> Expression:
    """The height of a displacement: on the axis of the plot beside it; on a phone, on one like it."""
    return WIDE * X.y(x) + NARROW * (0.2 * H + 0.58 * H * (x - var(P.x_top)) * var(P.per_span))


START = (begins("x_0", S.x, Axes.x), *at_rest("v_0"))
"""Where the mass is held is the start."""
TOP, BOTTOM = height(var(P.x_top)), height(var(P.x_bottom))


def shapes() -> list[Shape]:
    return [*bar(), *levels(), *body(), *planets(), *strip()]


def levels() -> list[Shape]:
    """Natural length and equilibrium, and delta_st between them."""
    natural, level = height(var(P.natural)), height(0)
    left = CENTRE - HALF - 6
    name = {"anchor": "end", "tint": "mute", "style": "halo given"}
    return [
        line(left + 6, natural, CENTRE + HALF, natural, style="eq", tint="mute", show=P.natural_seen),
        line(left + 6, level, CENTRE + HALF, level, style="eq", tint="mute"),
        text(left, natural - 4, "natural", show=(P.natural_seen, P.apart), **name),
        text(left, natural + 11, "length", show=(P.natural_seen, P.apart), **name),
        text(left, TOP + 2, "natural", show=P.natural_far, **name),
        text(left, TOP + 17, "length ↑", show=P.natural_far, **name),
        text(left, level + 5, "equilibrium", show=P.apart, **name),
        *[
            text(left, level - 10 + 15 * n, line_, show=show, **name)
            for show, lines in BESIDE.items()
            for n, line_ in enumerate(lines)
        ],
        arrow(CENTRE - ASIDE, natural, CENTRE - ASIDE, level, tint="k", head=9, show=P.apart),
        text(CENTRE - ASIDE - 10, (natural + level) * 0.5 + 6, DEFLECTION, "end", style="b halo", show=P.apart),
    ]


def natural_length() -> tuple[Shape, ...]:
    """Over the plot of x: the same line again."""
    y = X.y(var(P.natural))
    return (line(X.x(0), y, X.right, y, style="eq", tint="mute", show=P.natural_seen),)


def body() -> list[Shape]:
    """Ceiling, spring and mass; its end is the level line."""
    hook, side = height(var(S.x)), (WIDE * 58 + NARROW * 40) * var(P.side)
    now = WIDE * X.x(T) + NARROW * (STRIP + STRIP_LENGTH * T * var(P.per_window))
    way = linear(lambda x: height(x) + 0.5 * side, "y", "x_0", S.x, Axes.x, rate="v_0")
    return [
        wall(CENTRE - 62, WIDE * 16 + NARROW * 12, 124, side="top"),
        line(CENTRE, hook, now, hook, style="level", tint="m1"),
        spring(CENTRE, WIDE * 16 + NARROW * 12, CENTRE, hook, var(P.wire), height=15),
        box(CENTRE, hook + side, side, "*m*", tint="m1", grab=begin("Mass, start", way, start=START)),
        arrow(CENTRE + ASIDE, height(0), CENTRE + ASIDE, hook, tint="m1"),
        text(CENTRE + ASIDE - 6 * HALL, BOTTOM + 22, f"*x* = {S.x} {N.x_unit}", "start", tint="m1", style="t2 b halo"),
    ]


def planets() -> list[Shape]:
    """The levels at which the mass would hang elsewhere."""
    x = CENTRE + HALF
    found = []
    for slug, (name, _) in PLANETS.items():
        y = height(var(P.planet[slug]))
        found += [
            line(x, y, x + 8, y, style="floor", show=P.seen[slug]),
            text(x + 12, y + 4.5, name, "start", tint="mute", style="halo given", show=P.seen[slug]),
            line(x, y, x + 8, y, style="floor", show=P.here[slug]),
            text(x + 12, y + 4.5, name, "start", style="b halo given", show=P.here[slug]),
        ]
    return found


def bar() -> list[Shape]:
    """T on V, stacked to their constant sum, beside the mass."""
    whole = BOTTOM - TOP
    V = whole * var(S.V_share)
    letters: Looks = {"style": "t2 b halo", "show": (P.has_energy, ON_WIDE)}
    return [
        path(SQUARE, 2, BOTTOM - V, sx=BAR, sy=V, style="body", tint="V", show=P.has_energy),
        path(SQUARE, 2, TOP, sx=BAR, sy=whole - V, style="body", tint="T", show=P.has_energy),
        path(SQUARE, 2, TOP, sx=BAR, sy=whole, style="scaled outline", tint="ink"),
        text(BAR + 9, TOP + 13, "*T*", "start", tint="T", **letters),
        text(BAR + 9, BOTTOM - 3, "*V*", "start", tint="V", **letters),
    ]


def strip() -> list[Shape]:
    """The small x(t) on a phone, with its cursor."""
    now, size = STRIP + STRIP_LENGTH * T * var(P.per_window), -0.58 * H * var(P.C) * var(P.per_span)
    return [
        wave(
            STRIP, height(0), STRIP_LENGTH, size, var(P.swings), var(P.phi), style="sum strip", tint="m1",
            show=(ON_NARROW, P.swings),
        ),
        line(now, TOP, now, BOTTOM, style="now strip", show=ON_NARROW),
        circle(now, height(var(S.x)), 5, tint="m1", style="strip", show=ON_NARROW),
    ]  # fmt: skip


def well() -> tuple[Shape, ...]:
    """Over the well: the level of T + V to its plot over time, the stack V, T at the mass, and the ball."""
    x, floor, V, level = WELL.x(var(S.x)), WELL.y(0), WELL.y(var(S.V)), WELL.y(var(S.total))
    left, middle, shift = WELL.x(-1 * var(P.C)), WELL.x(0), WELL.y(var(P.shift))
    way = on_plot(WELL, "x", "x_0", S.x, Axes.x, rate="v_0")
    end = WIDE * ENERGY.left + NARROW * WELL.x(var(P.C))
    return (
        line(left, level, end, level, style="sum", show=P.has_energy),
        text(left + 12, level - 8, "turns here", "start", tint="mute", style="halo", show=P.swinging),
        path(SQUARE, x - 4, V, sx=8, sy=floor - V, style="body", tint="V"),
        path(SQUARE, x - 4, level, sx=8, sy=V - level, style="body", tint="T"),
        line(x, V, WIDE * ENERGY.x(T) + NARROW * x, V, style="level", tint="V", show=ON_WIDE),
        *[circle(WELL.x(side * var(P.C)), level, 4, tint="ink", show=P.swinging) for side in (-1, 1)],
        arrow(middle, floor, middle, shift, tint="ink", style="thin", head=9, show=P.shifted),
        text(middle, (floor + shift) * 0.5, SHIFT, "beside", style="b halo", show=P.shifted),
        circle(x, V, 8, tint="m1", grab=begin("Ball, start", way, start=START)),
    )
