"""The polygon of the forces at steady swing: tail to tip they close on the push, on the response's own scale."""

from __future__ import annotations

import math

from components.language.blocks import Block
from components.language.numbers import Number, var
from components.layout.sheet import stage
from components.layout.stage import NARROW, ON_WIDE, WIDE, H, Looks, Shape, W, arc, arrow, circle, line, shown_by, text
from components.quantities.axes import Axis
from components.quantities.declared import Declared, Scalar, by_name
from components.scenes.driven.case import KINDS, DrivenCase
from components.scenes.driven.curves import RESPONSE, Axes
from components.scenes.driven.curves import Resonance as R

ASIDE = 0.09
"""Arrows that would lie on one another are drawn this far apart, in pushes."""
LEFT, RIGHT = 0.7, 0.6
"""A polygon that reaches further to a side, in heights of the response, is drawn smaller."""
NARROWEST, ASIDE_OF_X = 0.6, 0.5
"""A lag that has no room for its name, in rad, has it on the other side of the arrow from which it is counted."""
GROWN = 0.8
"""The height, in heights of the response, of forces that grow."""
FILLED = 0.9
"""So much of a stage of its own it fills, in height; the rest is for names."""


class Polygon(Declared[DrivenCase]):
    """The parts of it that are drawn, its corners, and where the names stand."""

    closed, growing, idle, level, braked, y_braked, lags = Scalar[DrivenCase].some(7)
    up, across, aside, end, scale, y_side, y_up, phi_side, phi_up, from_X, to_F = Scalar[DrivenCase].some(11)
    push, below = Scalar[DrivenCase].some(2)


P = Polygon


def corners_of(case: DrivenCase, axes: dict[str, Axis]) -> dict[str, float]:
    """The corners: from the tail the first arrow up, the dashpot's across, the third down, where the push ends too."""
    top = Axes.M(axes).place(Axes.M(axes).end)
    if case.swells:
        return by_name({P.growing: 1.0, P.up: GROWN * top, P.scale: 1.0} | _heights(top, 1.0))
    if not (case.pushed and case.steady):
        return by_name({P.idle: 1.0} | _heights(top, 1.0))
    r, M, across = case.r, case.M, 2 * case.zeta * case.r
    spring, inertia = M, r * r * M
    if case.kind == "unbalance":
        spring, inertia, across = M / (r * r), M, across / (r * r)
    first, third = (inertia, spring) if case.kind == "unbalance" else (spring, inertia)
    side = across * M * (1.0 if case.kind == "unbalance" else -1.0)
    reach = max(first, third - first, side / RIGHT, -side / LEFT, 1.0)
    scale = min(1.0, 0.92 * top / reach)
    apart = math.copysign(max(abs(side), ASIDE / scale), side)
    found = {P.closed: 1.0, P.up: first, P.across: side, P.aside: apart, P.end: first - third, P.scale: scale}
    found |= _heights(top, scale * max(1.0, third - first))
    found |= {P.level: float(scale == 1.0), P.braked: float(abs(side) > ASIDE)}
    if case.kind == "base":
        turned = math.sin(case.lag), math.cos(case.lag)
        found |= {P.y_side: -turned[0], P.y_up: turned[1], P.y_braked: float(across > ASIDE)}
    middle, way = case.lag / 2 if case.lag > NARROWEST else -ASIDE_OF_X, 1.0 if case.kind == "unbalance" else -1.0
    found |= {P.phi_side: way * math.sin(middle), P.phi_up: -way * math.cos(middle), P.lags: float(case.lag > 0.15)}
    start = 0.0 if case.kind == "unbalance" else math.pi
    return by_name(found | {P.from_X: start, P.to_F: start + case.lag})


def _heights(top: float, below: float) -> dict[Scalar[DrivenCase], float]:
    """Where the response is not beside it: a push and what lies below the tail, in heights of the stage."""
    push = FILLED / (top + below)
    return {P.push: push, P.below: below * push}


FORCE, BASED, UNBALANCE = ((P.closed, R.driven[kind]) for kind in KINDS)
PX = WIDE * -1 * RESPONSE.per_y + NARROW * H * var(P.push)
"""Pixels of one push."""
BASE = WIDE * RESPONSE.y(0) + NARROW * H * (0.98 - var(P.below))
MIDDLE = 0.56 * W


def polygon() -> Block:
    unit = PX * var(P.scale)
    tail = MIDDLE, BASE
    up = BASE - unit * var(P.up)
    across, aside = MIDDLE + unit * var(P.across), MIDDLE + unit * var(P.aside)
    end = BASE - unit * var(P.end)
    shapes = [
        circle(MIDDLE, BASE, unit, style="hair dotted", tint="mute", show=P.closed),
        line(RESPONSE.x(var(R.r_at)), up, MIDDLE, up, style="level", tint="m1", show=(P.closed, P.level, ON_WIDE)),
        *shown_by(FORCE, *_arrows(tail, up, across, aside, end, ("k", "*kX*"), ("m1", "*mω*²*X*"), -1)),
        *shown_by(BASED, *_arrows(tail, up, across, aside, end, ("k", "*kX*"), ("m1", "*mω*²*X*"), -1)),
        *shown_by(UNBALANCE, *_arrows(tail, up, across, aside, end, ("m1", "*mω*²*X*"), ("k", "*kX*"), 1)),
        *_pushes(tail, unit, across, end),
        *shown_by(P.growing, *_growing(tail, PX, up)),
        text(MIDDLE, BASE - 40, "no push", tint="mute", style="t2", show=P.idle),
    ]
    label = "The forces of spring, dashpot and inertia, tail to tip: they close on the push"
    return stage(*shapes, label=label, grow=236, phone=12, height=260, style="still")


def _arrows(
    tail: tuple[Number, Number],
    up: Number,
    across: Number,
    aside: Number,
    end: Number,
    first: tuple[str, str],
    third: tuple[str, str],
    way: int,
) -> list[Shape]:
    """The first arrow up, the dashpot's across, the third down."""
    x, y = tail
    near, far = ("start", "end") if way < 0 else ("end", "start")
    return [
        arrow(x, y, x, up, tint=first[0], head=13),
        arrow(x, up, across, up, tint="T", head=11, show=P.braked),
        arrow(aside, up, aside, end, tint=third[0], head=13),
        text(x - 10 * way, (y + up) * 0.5, first[1], near, tint=first[0], style="t2 b halo"),
        text(aside + 10 * way, (up + end) * 0.5, third[1], far, tint=third[0], style="t2 b halo"),
        text((x + across) * 0.5, up - 9, "*cωX*", tint="T", style="t2 b halo", show=P.braked),
    ]


def _pushes(tail: tuple[Number, Number], unit: Number, across: Number, end: Number) -> list[Shape]:
    """The push, from the tail to where the others end, and the angle by which x lags it."""
    x, y = tail
    spring = x + unit * var(P.y_side), y - unit * var(P.y_up)
    look: Looks = {"tint": "F", "style": "thick", "head": 15}
    name = (x + across) * 0.5, (y + end) * 0.5
    away = name[0] - 16 * var(P.end), name[1] - 16 * var(P.across) + 5  # from the others, at right angles to it
    return [
        *shown_by(FORCE, arrow(x, y, across, end, **look)),
        *shown_by(UNBALANCE, arrow(x, y, across, end, **look)),
        *shown_by(FORCE, text(*away, "*F*_0", tint="F", style="t2 b halo")),
        *shown_by(UNBALANCE, text(name[0] + 12, name[1] + 16, "*F*_0", "start", tint="F", style="t2 b halo")),
        *shown_by(
            BASED,
            arrow(x, y, *spring, **look),
            text((x + spring[0]) * 0.5 - 8, (y + spring[1]) * 0.5 + 16, "*kY*", "end", tint="F", style="t2 b halo"),
            *shown_by(
                P.y_braked,
                arrow(*spring, across, end, tint="F", head=12),
                text((across + spring[0]) * 0.5 - 8, (end + spring[1]) * 0.5 + 18, "*cωY*", "end", tint="F",
                     style="t2 b halo"),
            ),
        ),
        *shown_by(
            (P.closed, P.lags),
            arc(x, y, 24, var(P.from_X), var(P.to_F), style="floor", tint="ink"),
            text(x + 38 * var(P.phi_side), y - 38 * var(P.phi_up) + 5, "*φ*", style="t2 b halo"),
        ),
        circle(x, y, 4, tint="ink", show=P.closed),
    ]  # fmt: skip


def _growing(tail: tuple[Number, Number], unit: Number, up: Number) -> list[Shape]:
    """Undamped at resonance: spring and inertia cancel, and what is left of the push makes the swing grow."""
    x, y = tail
    left = x - unit
    return [
        arrow(x, y, x, up, tint="k", head=13),
        arrow(x, up, left, up, tint="m1", head=11),
        arrow(left, up, left, y, tint="m1", head=13),
        arrow(x, y, left, y, tint="F", style="thick", head=15),
        text(x + 10, (y + up) * 0.5, "*kX* grows", "start", tint="k", style="b halo"),
        text(left - 8, (y + up) * 0.5, "*mω*²*X*", "end", tint="m1", style="b halo"),
        text((x + left) * 0.5, up - 9, "growth", tint="m1", style="b halo"),
        text((x + left) * 0.5, y + 20, "*F*_0", tint="F", style="t2 b halo"),
        circle(x, y, 4, tint="ink"),
    ]
