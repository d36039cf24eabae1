"""The forces of the driven mass in steady vibration: the polygon of arrows next to the response."""

from __future__ import annotations

from components.language.blocks import Block
from components.language.expressions import Number
from components.layout.sheet import stage
from components.layout.stage import ON_WIDE, H, Looks, Shape, W, arc, arrow, circle, line, text, wide
from components.paper.deferred import number
from components.paper.plots import shown_by
from components.scenes.driven.plots import RESPONSE, c

POLYGON = RESPONSE.in_frame(c, "polygon", lambda c, r, M: c.polygon(M.place(M.end)))
PX = wide(-1 * RESPONSE.per_y, H * POLYGON.push)
"""Length of the push's arrow in pixels."""
BASE, CENTER = wide(RESPONSE.y(0), H * (0.98 - POLYGON.below * POLYGON.push)), 0.56 * W
"""The tail of the polygon of the forces."""


def polygon() -> Block:
    """Return the stage with the forces drawn tail to tip. Together they equal the push. The scale is that of the
    response plot."""
    unit, p = PX * POLYGON.scale, POLYGON
    kX, inertia = ("k", "*kX*"), ("m1", "*mω*²*X*")
    up, end = BASE - unit * p.up, BASE - unit * p.end
    across, aside = CENTER + unit * p.across, CENTER + unit * p.aside
    shapes = [
        *shown_by(
            p.closed,
            *shown_by(p.level, line(RESPONSE.x(c.omega), up, CENTER, up, style="level", tint="m1", show=ON_WIDE)),
            *shown_by(c.kind != "unbalance", *arrows(up, across, aside, end, kX, inertia, -1)),
            *shown_by(c.kind == "unbalance", *arrows(up, across, aside, end, inertia, kX, 1)),
            *pushes(unit, across, end),
        ),
        *shown_by(p.growing, *growing_forces(up)),
        *shown_by(p.idle, text(CENTER, BASE - 40, "no push", tint="mute", style="t2")),
    ]
    label = "The forces of spring, dashpot and inertia, tail to tip: they close on the push"
    return stage(*shapes, label=label, grow=230, phone=11, height=184, style="still second", name="forces")


def arrows(
    up: Number, across: Number, aside: Number, end: Number, first: tuple[str, str], third: tuple[str, str], way: int
) -> list[Shape]:
    """The first arrow (up), the arrow of the dashpot (across), and the third arrow (down).

    `first` and `third` are spring and inertia, or the reverse for an unbalance."""
    near, far = ("start", "end") if way < 0 else ("end", "start")
    return [
        arrow(CENTER, BASE, CENTER, up, tint=first[0], head=13),
        *shown_by(POLYGON.braked, arrow(CENTER, up, across, up, tint="T", head=11)),
        arrow(aside, up, aside, end, tint=third[0], head=13),
        text(CENTER - 10 * way, (BASE + up) * 0.5, first[1], near, tint=first[0], style="t2 b halo"),
        text(aside + 10 * way, (up + end) * 0.5, third[1], far, tint=third[0], style="t2 b halo"),
        *shown_by(POLYGON.braked, text((CENTER + across) * 0.5, up - 9, "*cωX*", tint="T", style="t2 b halo")),
    ]


def pushes(unit: Number, across: Number, end: Number) -> list[Shape]:
    """The arrow of the push, from the first tail to the last tip, and the angle by which x lags it."""
    x, y, p, look = CENTER, BASE, POLYGON, Looks(tint="F", style="t2 b halo")
    shaken = x + unit * p.y_side, y - unit * p.y_up
    middle = (x + across) * 0.5, (y + end) * 0.5
    away = middle[0] - 16 * p.end, middle[1] - 16 * p.across + 5  # shifted from the others, perpendicular to it
    return [
        *shown_by(c.kind != "base", arrow(x, y, across, end, tint="F", style="thick", head=15)),
        *shown_by(c.kind == "force", text(*away, "*F*_0", **look)),
        *shown_by(c.kind == "unbalance", text(middle[0] + 12, middle[1] + 16, "*F*_0", "start", **look)),
        *shown_by(
            c.kind == "base",
            arrow(x, y, *shaken, tint="F", style="thick", head=15),
            text((x + shaken[0]) * 0.5 - 8, (y + shaken[1]) * 0.5 + 16, "*kY*", "end", **look),
            *shown_by(
                p.y_braked,
                arrow(*shaken, across, end, tint="F", head=12),
                text((across + shaken[0]) * 0.5 - 8, (end + shaken[1]) * 0.5 + 18, "*cωY*", "end", **look),
            ),
        ),
        *shown_by(
            p.lags,
            arc(x, y, 24, number(p.from_X), number(p.to_F), style="floor", tint="ink"),
            text(x + 38 * p.phi_side, y - 38 * p.phi_up + 5, "*φ*", style="t2 b halo"),
        ),
        circle(x, y, 4, tint="ink"),
    ]


def growing_forces(up: Number) -> list[Shape]:
    """At resonance without damping, spring and inertia cancel, so nothing balances the push and the swing grows."""
    x, y, left = CENTER, BASE, CENTER - PX
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
