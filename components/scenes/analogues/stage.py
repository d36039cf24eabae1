"""The stage of the analogues: the chosen system, the equivalent spring, and the lines between them and the plot."""

from __future__ import annotations

from components.language.expressions import Expression, Number, var
from components.language.shapes import Turn
from components.layout.grabs import begin
from components.layout.stage import (
    NARROW,
    ON_NARROW,
    ON_WIDE,
    WIDE,
    H,
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
)
from components.scenes.analogues.case import DEGREE
from components.scenes.analogues.curves import Ends, Hung
from components.scenes.analogues.curves import Places as P
from components.scenes.analogues.curves import Swinging as S
from components.scenes.analogues.grabs import ANGLE, HELD, held, held_spring, rocked, turned
from components.scenes.analogues.numbers import Numbers as N
from components.scenes.analogues.pictures import HEIGHT, PICTURES, WIDTH, Canvas, large
from physics.analogues import ANALOGUES

MOTION, LATE = PlotFrame("motion"), PlotFrame("late")
TWIN = W - 46
"""The position of the spring and mass."""
WIDEST = 1.75
"""The largest ratio of width to height."""
HIGH = W / WIDEST
"""The height of the drawing, which is in the middle of a higher stage."""
TOP = 0.5 * (H - HIGH)
SIDE = 0.16 * HIGH
UNIT = W / 112
CENTRE = 0.5 * (W - 92)
"""The middle of the area of the chosen system."""

COORDINATES = {
    "spring": "*x*",
    "shaft": "angle *θ*",
    "pendulum": "angle *θ*",
    "rocking": "angle *θ*",
    "floating": "depth *z*",
    "circuit": "charge *q*",
    "string": "*q_n*",
    "wave": "rise *η*",
    "pipe": "*q_n*",
}


def shapes() -> list[Shape]:
    """The shapes of the stage: the nine systems, of which one is visible, and the spring."""
    canvas = Canvas(CENTRE - UNIT * (WIDTH / 2), 0.55 * H - UNIT * (HEIGHT / 2), UNIT, large=True)
    found = [one for slug in PICTURES if slug != "pendulum" for one in large(slug, canvas)]
    found += [held(slug, canvas) for slug in HELD]
    return [*found, turned(canvas), rocked(canvas), *pendulum(), *coordinates(), *twin()]


def coordinates() -> list[Shape]:
    """The coordinate as a number, at a place where nothing moves."""
    look = {"tint": "m1", "style": "t2 b halo"}
    over = {"pendulum": TOP + 14, "rocking": TOP + 14}
    return [
        text(
            CENTRE,
            over.get(slug, 0.55 * H - UNIT * (HEIGHT / 2) - 6),
            f"{symbol.replace('_n*', '*_n')} = {S.level}{N.level_unit}",
            show=P.of[slug],
            **look,
        )
        for slug, symbol in COORDINATES.items()
    ]


def pendulum() -> list[Shape]:
    """Pivot, arc, bob, and a ring at the bob's position in the small-angle approximation."""
    x, y, rod, radius = CENTRE, TOP + var(Hung.pivot) * HIGH, var(Hung.rod) * HIGH, 0.066 * HIGH
    bob, weight = (x + rod * var(S.angle_sine), y + rod * var(S.angle_cosine)), "weight *m g*"
    rule = (x + rod * var(S.rule_sine), y + rod * var(S.rule_cosine))
    end, near, ends = var(Hung.theta_0), rod - 7, []
    turn = Turn(parameter="theta_0", moves=S.angle.name, size=DEGREE, x=x, y=y)
    swing = begin("Bob, start", turn, start=ANGLE)
    found = [wall(x - 42, y, 84, side="top"), line(x, y, x, y + rod + 34, style="eq", tint="mute")]
    found.append(arc(x, y, rod, -1 * end, end, style="eq", tint="mute"))
    for side in (-1, 1):
        along, down = side * var(Hung.end_sine), var(Hung.end_cosine)
        ends.append(line(x + along * near, y + down * near, x + along * (rod + 7), y + down * (rod + 7), style="floor"))
        label = f"{N.end_right}" if side > 0 else f"{N.end_left}"
        anchor = "start" if side > 0 else "end"
        place = (x + along * rod + side * (radius + 9), y + down * rod - 4)
        ends.append(text(*place, label, anchor, tint="mute", show=ON_WIDE))
    found += [
        *shown_by(Hung.ends_seen, *ends),
        line(x, y, *rule, style="faint"),
        circle(*rule, radius + 4, style="ghost", tint="m1"),
        text(rule[0], rule[1] - radius - 10, "spring", tint="m1", style="t0 halo", show=ON_WIDE),
        line(x, y, *bob, style="rod"),
        arc(x, y, 0.42 * rod, 0, var(S.angle), style="sum", tint="m1"),
        arrow(*bob, bob[0], bob[1] + 0.17 * HIGH, tint="k", style="thick", head=17),
        circle(*bob, radius, style="body", tint="m1", grab=swing),
        text(bob[0], bob[1] + 5, "*m*", tint="m1", style="t3 on"),
        text(bob[0] + 12, bob[1] + 0.16 * HIGH, weight, "start", tint="k", style="t2 b halo", show=ON_WIDE),
        text(bob[0], bob[1] + 0.17 * HIGH + 15, weight, tint="k", style="t2 b halo", show=ON_NARROW),
        circle(x, y, 5, style="dot", tint="ink"),
    ]
    return shown_by(P.of["pendulum"], *found)


def height(q: Number) -> Expression:
    """The height of a coordinate: on the axis of the plot next to it; on a phone, on a similar one."""
    return WIDE * MOTION.y(q) + NARROW * (TOP + 0.45 * HIGH - 0.24 * HIGH * var(P.per_q) * q)


def twin() -> list[Shape]:
    """The equivalent spring and mass, which moves along the plot's axis."""
    level = height(0)
    foot = WIDE * (MOTION.bottom + 16) + NARROW * (TOP + HIGH - 10)
    y = height(var(S.rule))
    return [
        wall(TWIN - 36, foot, 72, side="bottom"),
        line(TWIN - 36, level, WIDE * MOTION.left + NARROW * W, level, style="eq", tint="mute"),
        spring(TWIN, y + SIDE / 2, TWIN, foot, 2.4, height=0.036 * HIGH),
        line(TWIN + SIDE / 2, y, MOTION.x(T), y, style="level", tint="m1", show=ON_WIDE),
        box(TWIN, y + SIDE / 2, SIDE, "*m*", tint="m1", held=True),
        *(held_spring(slug, TWIN, height) for slug in ANALOGUES),
    ]


def over_motion() -> tuple[Shape, ...]:
    """The spring's dot on its curve; the delay of the third cycle, or the length of a cycle of a linear system."""
    y = MOTION.y(var(P.amplitude)) - 9
    found = [circle(MOTION.x(T), MOTION.y(var(S.rule)), 5, style="ghost", tint="m1", show=Hung.rule_seen)]
    a, b = MOTION.x(var(Ends.first)), MOTION.x(var(Ends.second))
    found += shown_by(
        Ends.second,
        *(line(at, y - 5, at, y + 9, style="floor") for at in (a, b)),
        arrow(a, y, b, y, head=8, style="thin"),
        arrow(b, y, a, y, head=8, style="thin", show=Ends.period_seen),
        text((a + b) / 2, y - 8, f"after 3 swings {N.late} s behind", style="b halo", show=Ends.late_seen),
        text((a + b) / 2, y - 8, f"one swing {N.period} s", style="b halo", show=Ends.period_seen),
    )
    return tuple(found)


def over_lateness() -> tuple[Shape, ...]:
    """The shapes over T/T_0 - 1: the dotted line to the axis and the number at the point."""
    x, y = LATE.x(var(Hung.size_angle)), LATE.y(var(Hung.late_now))
    lines = (
        line(LATE.x(0), y, x, y, style="level"),
        line(x, y, x, LATE.y(0), style="", tint="m1"),
        text(x, y, f"+{N.late_percent} %", "beside", style="t2 b halo"),
    )
    return tuple(shown_by(Hung.rule_seen, *lines))
