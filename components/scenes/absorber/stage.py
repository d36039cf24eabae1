"""The absorber's stage, which draws each instant with and without the absorber; dots and limits over the plots; the
goals with their marks.
"""

from __future__ import annotations

from components.chain.grabs import VELOCITIES
from components.language.blocks import Block
from components.language.expressions import Number, var
from components.language.shapes import Grab
from components.layout.grabs import begin, begins, grab, linear, on_plot
from components.layout.sheet import stage
from components.layout.stage import (
    AT_DESK,
    HALL,
    NARROW,
    ON_NARROW,
    ON_WIDE,
    WIDE,
    H,
    PlotFrame,
    Shape,
    W,
    arrow,
    box,
    circle,
    line,
    path,
    spring,
    text,
    wall,
    wide,
)
from components.quantities.declared import Scalar
from components.scenes.absorber.case import AbsorberCase
from components.scenes.absorber.curves import ALONE, Axes
from components.scenes.absorber.curves import Signals as S
from components.scenes.absorber.numbers import Numbers as N
from components.scenes.absorber.places import Places as P
from components.scenes.absorber.words import VERDICTS

SWING, STROKE = PlotFrame("swing"), PlotFrame("stroke")
WALL, REST = 0.024, (0.36, 0.687)
"""Positions of the wall and the masses at rest, as fractions of the stage's width."""
FLOORS = (0.39 * H, 0.86 * H)
TEETH = 0.8 * H * var(P.hook)
"""The height of a spring's teeth, small enough to stay above the floor."""
TICK, CROSS = "M-3.5 .5l2.6 2.6 5-5.600", "M-2.800 -2.800l5.600 5.600M2.800 -2.800l-5.600 5.600"
FREQUENCIES = (
    (P.slow, P.slow_seen, "slow", f"slow {N.slow}"),
    (P.omega, P.omega_seen, "F", f"drive {N.omega}"),
    (P.fast, P.fast_seen, "fast", f"fast {N.fast}"),
)
"""The lines that cross both plots: their positions, visibility, colours, flags."""


def side(mass: int) -> Number:
    return var(P.side[mass]) * H


def picture() -> Block:
    """The stage, which draws each instant twice: above, in outline, the machine without the absorber; below, with
    it."""
    ground = wall(WALL * W, 0.02 * H, FLOORS[1] - 0.02 * H + 1)
    label = "The machine alone and with the absorber at the same instant, with the forces on it"
    return stage(ground, *_rests(), *_alone(), *_both(), *_forces(), *_verdicts(), label=label, grow=200, height=168)


def _rests() -> list[Shape]:
    """Floors, equilibrium lines, and a ruler from each mass's own zero."""
    foot = FLOORS[1]
    shapes = [
        line(WALL * W, FLOORS[0], 0.56 * W, FLOORS[0], tint="rule", style="hair"),
        line(WALL * W, foot, W, foot, style="floor"),
    ]
    for i, top in ((1, FLOORS[0] - side(1) - 20), (2, foot - side(1) - 20)):
        zero, tint = REST[i - 1] * W, f"m{i}"
        shapes.append(line(zero, top, zero, foot, tint="mute", style="eq"))
        # Start the number of a tick close to 0 at the tick, because it is long.
        tick = zero + var(P.tick) * W
        shapes += [line(x, foot, x, foot + 5, style="floor") for x in (zero, tick)]
        shapes += [
            text(zero, foot + 18, "0", tint=tint, style="t0"),
            text(tick - 4, foot + 18, f"{N.tick}", "start", tint=tint, style="t0"),
        ]
    return shapes


def _place(i: int, x: Number) -> Number:
    return REST[i - 1] * W + var(P.metre) * W * x


def _hook(floor: Number) -> Number:
    """The height at which the springs are attached: at most half the smaller mass."""
    return floor - var(P.hook) * H


def _alone() -> list[Shape]:
    x, floor = _place(1, var(S.x[ALONE])), FLOORS[0]
    top, middle = floor - side(1), floor - 0.5 * side(1)
    return [
        spring(WALL * W, _hook(floor), x - 0.5 * side(1), _hook(floor), 1.75, height=TEETH, style="faint"),
        box(x, floor, side(1), tint="m1", style="ghost"),
        arrow(x, middle, x + var(P.push) * W * var(S.drive), middle, tint="F", style="thick", head=16),
        circle(x, middle, 5, tint="F"),
        *_displacement(1, ALONE, top - 13, top),
    ]


def _displacement(i: int, who: int | str, lift: Number, top: Number) -> list[Shape]:
    """The arrow from equilibrium to the mass, with its number at a place where nothing moves."""
    zero, x, tint = REST[i - 1] * W, _place(i, var(S.x[who])), f"m{i}"
    number = f"*x*_{i} = {S.x[who]} {N.x_unit}"
    look = {"tint": tint, "style": "t2 b halo"}
    if i == 1:  # on a phone there is no room for more than the number
        aside, said = zero - WIDE * var(P.lead[who]) * W - 8, "alone: " if who == ALONE else ""
        names = [
            text(aside, lift + 5, f"{said}{number}", "end", show=ON_WIDE, **look),
            text(aside, lift + 5, number, "end", show=ON_NARROW, **look),
        ]
    else:  # the verdict is to the right of it, if there is room
        names = [
            text(zero - 8, lift - 10, number, "end", show=ON_WIDE, **look),
            text(W, lift - 10, number, "end", show=ON_NARROW, **look),
        ]
    return [line(x, top, x, lift, tint="mute", style="eq revealing"), arrow(zero, lift, x, lift, tint=tint), *names]


def _both() -> list[Shape]:
    foot, x1, x2 = FLOORS[1], _place(1, var(S.x[1])), _place(2, var(S.x[2]))
    hook, right, left, lift = _hook(foot), x1 + 0.5 * side(1), x2 - 0.5 * side(2), foot - side(1) - 13
    return [
        spring(WALL * W, hook, x1 - 0.5 * side(1), hook, var(P.wire1), height=TEETH),
        spring(right, hook, left, hook, var(P.wire2), height=TEETH, show=P.wire2),
        box(x1, foot, side(1), "*m*_1", tint="m1", corner=True),
        box(x2, foot, side(2), "*m*_2", tint="m2"),
        circle(x1, foot - 0.5 * side(1), 0, show=P.from_rest, grab=_held(1, "Machine")),
        circle(x2, foot - 0.5 * side(2), 0, show=P.from_rest, grab=_held(2, "Absorber")),
        *_displacement(1, 1, lift, foot - side(1)),
        *_displacement(2, 2, lift, foot - side(2)),
    ]


def _held(i: int, name: str) -> Grab:
    """A mass that can be dragged. The motion starts from where it is let go, with its complementary part."""
    return begin(
        f"{name}, start",
        linear(lambda x: _place(i, x), "x", f"x{i}_0", S.x[i], Axes.X1, rate=f"v{i}_0"),
        start=(*(begins(f"x{j}_0", S.x[j], Axes.X1) for j in (1, 2)), *VELOCITIES),
    )


def _forces() -> list[Shape]:
    """The arrows of the drive and of the force of spring 2. They start at the same point. If they are equally long,
    they show why the machine is at rest."""
    x, y = _place(1, var(S.x[1])), FLOORS[1] - 0.5 * side(1) - 4
    pulls, look = f"{N.link}: {S.pull_now} {N.F_unit}", "t1 b halo"
    drives = f"push *F* = {S.drive_now} {N.F_unit}"
    return [
        arrow(x, y, x + var(P.push) * W * var(S.drive), y, tint="F", style="thick", head=16),
        arrow(x, y, x + var(P.push) * W * var(S.pull), y, tint="k", style="thick", head=16),
        circle(x, y, 5),
        text(var(P.tag_left) * W, y + 5, pulls, "end", tint="k", style=look, show=ON_WIDE),
        text(var(P.tag_right) * W, y + 5, drives, "start", tint="F", style=look, show=ON_WIDE),
    ]


def _verdicts() -> list[Shape]:
    # Above the whole range of mass 2. On a phone, which has no room there, over the upper machine, next to its floor.
    above = FLOORS[0] - 0.5 * side(1) + 6 - NARROW * (0.5 * side(1) + 13) - HALL * 12
    below = wide(FLOORS[1] - side(1) - 23, FLOORS[0] - 14)
    look = "verdict b halo revealing"
    return [
        text(W, above, "Alone, it shakes", "end", style=look, show=P.alone_shakes),
        text(W, above, "Alone, it grows without limit", "end", style=look, show=P.alone_grows),
        text(W, above, "Alone, it beats, slowly", "end", style=look, show=P.alone_beats),
        text(W, above, f"Alone, within {N.rest_alone} {N.x_unit}", "end", style=look, show=P.alone_within),
        text(W, above - 19, f"{N.judged_alone}", "end", tint="mute", style="t0 halo", show=(ON_WIDE, AT_DESK)),
        text(W, below - 19, f"{N.judged}", "end", tint="mute", style="t0 halo", show=(ON_WIDE, P.differ)),
        *(text(W, below, words, "end", style=look, show=P.verdict[name]) for name, words in VERDICTS.items()),
    ]


def swing_shapes() -> tuple[Shape, ...]:
    """The shapes over the plot of the swing: its goal, the range without resonances, dots at the running speed, and
    fixed points."""
    return (
        *_limit(SWING, P.limit1),
        *_bracket(),
        *_reading(SWING, P.alone, P.alone_seen, f"{N.alone}", "alone", tint="m1", style="hollow"),
        *_reading(SWING, P.swing, P.swing_seen, f"{N.swing}", "with the absorber", tint="m1"),
        *_fixed(),
    )


def stroke_shapes() -> tuple[Shape, ...]:
    """The shapes over the plot of the stroke: its goal and the dot at the running speed."""
    return (
        *_limit(STROKE, P.limit2),
        *_reading(STROKE, P.stroke, P.stroke_seen, f"{N.stroke}", "by the stroke", tint="m2"),
    )


def _limit(plot: PlotFrame, at: Scalar[AbsorberCase]) -> list[Shape]:
    """The goal of a plot, as a dotted line."""
    y = plot.y(var(at))
    return [line(plot.left, y, plot.right, y, style="dotted", inside=plot)]


def _bracket() -> list[Shape]:
    """The range around the machine's speed in which no resonance should be."""
    y, low, high = SWING.top - 6, SWING.x(var(P.away_low)), SWING.x(var(P.away_high))
    name = text(high + 8, y + 4, "goal: no peak", "start", style="t0 halo")
    return [line(low, y, high, y), *(line(x, y - 5, x, y + 5) for x in (low, high)), name]


def _reading(
    plot: PlotFrame,
    at: Scalar[AbsorberCase],
    seen: Scalar[AbsorberCase],
    number: str,
    of: str,
    **look: str,
) -> list[Shape]:
    """The dot of a curve at the machine's speed (hollow without the absorber), with its number. Dragging it sets the
    speed.
    """
    x, y = plot.x(var(P.omega)), plot.y(var(at))
    held = grab(f"Running speed, {of}", on_plot(plot, "x", "omega", P.omega, Axes.w), inside=plot)
    return [
        circle(x, y, 7, show=seen, **look),
        text(x, y, number, "beside", tint=look["tint"], style="t1 b halo", show=seen),
        circle(x, y, 0, show=P.omega_seen, grab=held),
    ]


def _fixed() -> list[Shape]:
    """The fixed points and their names."""
    shapes = []
    for name in "PQ":
        x, y = SWING.x(var(P.fixed_x[name])), SWING.y(var(P.fixed_y[name]))
        shapes.append(circle(x, y, 4, show=P.fixed_seen))
        shapes.append(text(x, y - 11, f"*{name}*", style="t1 b halo", show=P.fixed_seen))
    return shapes


def goals() -> Block:
    """The three goals, each with a mark that says whether it is met."""
    shapes: list[Shape] = []
    for i in range(3):
        y, met, missed = 14 + (37 + 17 * WIDE) * i, P.met[i], P.missed[i]
        shapes += [circle(9, y, 8, style="revealing", show=met), path(TICK, 9, y, style="counter revealing", show=met)]
        shapes += [
            circle(9, y, 8, style="hollow revealing", show=missed),
            path(CROSS, 9, y, style="revealing", show=missed),
        ]
        shapes.append(text(26, y + 4, f"{N.goal[i]}", "start", style="t2 b"))
        shapes.append(text(26, y + 20, f"{N.found[i]}", "start", tint="mute", style="t0"))
    return stage(
        *shapes,
        label="The goals, met or not",
        grow=0,
        basis=286,
        phone=8,
        height=112,
        style="still second",
        name="goals",
    )
