"""The paper of the oscillator: mass and rotating arrow at the height of x(t); under it v(t) and a(t); two phase
planes."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from itertools import pairwise
from math import pi

from msgspec.structs import replace

from components.language.blocks import Block
from components.language.expressions import Expression, Number
from components.language.shapes import Grab
from components.layout.grabs import grab
from components.layout.plots import HEADING, NUMBERS, Room
from components.layout.sheet import column, row, stage
from components.layout.stage import (
    AT_DESK,
    ON_NARROW,
    ON_WIDE,
    H,
    Looks,
    Shape,
    T,
    W,
    arc,
    arrow,
    box,
    circle,
    line,
    spring,
    text,
    wall,
    wave,
    wide,
)
from components.layout.stage import shown_by as on_screens
from components.layout.views import in_views
from components.paper.deferred import deferred, number
from components.paper.plot_axes import TIME, axis
from components.paper.plots import (
    Plot,
    PlotValue,
    along,
    counted,
    curve,
    drag,
    either,
    note,
    on_axis,
    path,
    shown_by,
    words,
)
from components.quantities.axes import Axis, nice_axis
from components.quantities.formatting import MINUS, power_unit, three
from components.quantities.motion import scaled
from components.scenes.oscillator.case import OscillatorShown

c = deferred(OscillatorShown)
UNITS = ("m", "m/s", "m/s²")
ROOM = ((1.25, 1.25), (1.15, 1.6), (1.2, 1.75))
"""The lower and upper ends of the axes of x, v and a, in amplitudes. The marks of the quarter period need space above v
and a."""


def _amplitude_axis(case: OscillatorShown, i: int) -> Axis:
    """Return the axis of x, v or a, with ticks at the amplitudes. Its range includes the marks above it."""
    size, unit, (below, above) = case.free.amplitude(i), UNITS[i], ROOM[i]
    if not i and not case.omega and case.v_0:
        return _drift_axis(case)
    if not size:
        return Axis(-below, above, unit, ticks=(0.0,), labels=(f"0 {unit}",), drawn=(0.0, 0.0))
    power_unit(above * size)
    exponent, suffix = power_unit(size)
    seen = 0.95 * above if i and case.turns else 1.0
    bare = Axis(-below * size, above * size, unit, exponent, suffix, drawn=(-size, seen * size))
    top = bare.place(size)
    text = three(top)
    return replace(bare, ticks=(-top, 0.0, top), labels=(MINUS + text, "0", f"{text} {bare.full_unit}"))


def _drift_axis(case: OscillatorShown) -> Axis:
    """The axis of the path of a free mass, with round ticks."""
    ends = 0.0, case.x_0, case.x_0 + case.v_0 * case.end
    low, high = min(ends), max(ends)
    power_unit(2 * (high - low))
    return nice_axis(low, high, "m")


def _bare_axis(case: OscillatorShown) -> Axis:
    """The axis of a without numbers."""
    found = _amplitude_axis(case, 2)
    return replace(found, labels=("",) * len(found.ticks))


PLOTS = X, V, A = [
    Plot(name, TIME, axis(unit, partial(_amplitude_axis, i=i)))
    for i, (name, unit) in enumerate(zip("xva", UNITS, strict=True))
]
PLANE, LAW = Plot("plane", X.up, V.up), Plot("law", X.up, axis(UNITS[2], _bare_axis, "a_bare", like=A.up))
FORCE = axis("N", lambda c: nice_axis(0.0, c.greatest or 1.0, "N", exact=True), "F")
MOTIONS = (c.x, c.v, c.a)
TITLES = ("Displacement", "Velocity", "Acceleration")

MASS = wide(0.15 * W, 0.1 * W)
"""Horizontal positions of the mass and, below it, of the rotating arrow."""
SWING = 0.27 * H
"""The amplitude on a phone."""
PIVOT = wide(0.635 * W, 0.395 * W)
FRAME = wide(X.bottom - X.top, 0.8 * H)
"""The height of the plot of x, which sets the scale of the stage. On a phone, where the plot is elsewhere, a similar
height."""
LEVEL = wide(X.y(0), 0.5 * H)
PER_X = number(X.in_frame(c, "per_x", lambda c, t, x: ROOM[0][0] / x.place(max(abs(x.start), x.end))))
SCALE = wide(-1 * X.per_y, SWING * PER_X)
"""Pixels per unit of the axis of x; on a phone, the end of the frame."""
RADIUS = SCALE * on_axis(X.up, c.free.constants.C)
PER_V = number(
    PLANE.in_frame(c, "per_v", lambda c, x, v: scaled(x.exponent - v.exponent, 1 / c.omega if c.turns else 0.0))
)
"""The length of one unit of v on the axis of x: the value of x a quarter period later."""
STRIP, STRIP_LENGTH = 0.64 * W, 0.31 * W
"""On a phone the stage has a small x(t) inside."""
NOW = wide(X.x(T), STRIP + STRIP_LENGTH * TIME.share * T)
MARKED = ("speed", "formulas")
"""The views that show x, v and a, and mark that each leads the next by a quarter period."""
FIRST, GAP = 132, 16
"""Pixels for the words to the left of the initial arrow, which is below the rotating one, and the gap between both
arrows."""
SHARE = 0.75
"""The length of the force's arrow at the turning point, relative to the amplitude."""

StageVector = tuple[Number, Number]

COSINE, SINE = number(c.cosine), number(c.sine)
WAYS: tuple[StageVector, ...] = (COSINE, SINE), (-1 * SINE, COSINE), (-1 * COSINE, -1 * SINE)
"""The directions of the arrows of x, v and a, with y upwards. Each is a quarter turn ahead of the previous one."""
START_WAY: StageVector = (number(c.start_cosine), number(c.start_sine))
LOOKS = (
    ("*x*", "m1", "", (15, 13)),
    ("*v*/*ω*_n", "T", "thin", (26, 16)),
    ("*a*/*ω*_n²", "F", "thin", (30, 16)),
)
"""Their names, tints and styles, and the pixels from the tip to the middle of the name, across and up."""
IN_WORDS = ("*x*", "velocity", "acceleration")
"""Their names in the first view, which has no curves of v and a."""
BOLD: Looks = {"style": "t2 b halo"}


def paper() -> Block:
    label = "Mass on a spring, and the turning arrow whose height is its displacement"
    start = stage(
        *first(), label="The arrow at the start with its legs A and B", name="start", style="still second", phone=8,
        height=190,
    )  # fmt: skip
    return row(
        column(
            stage(*hero(), label=label, grow=300, height=190),
            in_views(idea(), "motion", "speed", "force"),
            in_views(column(row(reason(), start, grow=176, gap=GAP), constants(), grow=230), "formulas"),
            grow=344,
        ),
        column(
            over_time(0),
            in_views(over_time(1), "speed", "formulas"),
            in_views(over_time(2), "speed", "force", "formulas"),
            in_views(words(style="room", grow=176), "motion"),
            grow=400,
        ),
        in_views(
            column(
                law_words(),
                in_views(plane(), "formulas"),
                in_views(law(), "formulas"),
                grow=168,
            ),
            "force", "formulas",
        ),
        gap=0,
    )  # fmt: skip


def idea() -> Block:
    """In place of the formulas: the scene's idea in words."""
    turning = (
        "The tip of the turning arrow is as high as [m1|$x$]. An arrow a quarter turn ahead is as high as "
        r"[T|velocity $v/\omega_n$], one half a turn ahead as [F|acceleration $a/\omega_n^2$]."
    )
    return words(
        either(
            c.why, right=turning, wrong=turning, zero=turning,
            rest="The mass rests: nothing moves, and there is no arrow.",
            drift="No spring, no swing: the mass keeps its velocity.",
            still="No spring, and a start at rest: nothing moves.",
        ),
        style="facts", grow=120, phone=15, name="idea",
    )  # fmt: skip


def reason() -> Block:
    """The text on why the phase is atan2, with the value that the slide's atan would give for these initial
    conditions."""
    return words(
        either(
            c.why,
            right=r"**At** $t = 0$: $\mathrm{atan}(A / B)$ gives the right angle here: it is right for $v_0 > 0$, "
            r"$\mathrm{atan2}$ always.",
            wrong=rf"**At** $t = 0$: $\mathrm{{atan}}(A / B) = {c.atan}$ points the other way: "
            r"it is right only for $v_0 > 0.$",
            zero=r"**At** $t = 0$: $\mathrm{atan}(A / B)$ would divide by zero: it is right only for $v_0 > 0.$",
            rest="The mass rests: nothing moves, there is no arrow, and no phase.",
            drift="No spring, no swing: the mass keeps its velocity.",
            still="No spring, and a start at rest: nothing moves.",
        ),
        style="small", basis=FIRST - GAP, phone=16, name="reason",
    )  # fmt: skip


def constants() -> Block:
    A = rf"[m1|$A = x_0 = {c.A}$ m]"
    B = either(c.kind, turn=rf"[T|$B = v_0 / \omega_n = {c.B}$ m]", drift=f"[T|$v_0 = {c.v_start}$ m/s]")
    C = either(c.kind == "turn", shown=rf"[m1|$C = \sqrt{{A^2 + B^2}} = {c.C}$ m]")
    phi = either(c.turns, shown=rf"$\phi = \mathrm{{atan2}}(A, B) = {c.phi}$ rad")
    return row(
        words(A, C, style="constants", phone=9, name="constants"),
        words(B, phi, style="constants", phone=9, name="constants"),
        grow=0,
        basis=54,
        gap=10,
    )


def over_time(i: int) -> Block:
    """x, v or a against time, under its name or its formula."""
    name, motion, (_, tint, *_) = "xva"[i], MOTIONS[i], LOOKS[i]
    top, ahead = (c.top_x, c.top_v, c.top_a)[i], ("", r"+ \tfrac{\pi}{2}", r"+ \pi")[i]
    legend = either(
        c.heading,
        words=rf"\text{{{TITLES[i].lower()} }} {name}",
        turn=rf"{name} = {top}\, \sin({c.omega}\,t\, {c.phi_plus:+} {ahead})",
        drift=(rf"x = {c.A}\, {c.drift:+}\,t", rf"v = {c.v_start} \text{{: constant}}", r"a = 0 \text{: no force}")[i],
    )
    parts = rf"$= {c.A_plain}\, \cos({c.omega}\,t)\, {c.B_plus:+}\, \sin({c.omega}\,t)$"
    return PLOTS[i].block(
        curve(motion, "sum", tint, legend=legend, read=f"*{name}*", fast="band", dot=True),
        *([] if i else [note(either(c.parts, shown=parts))]),
        title=f"{TITLES[i]} against time", over=lead(i - 1) if i else (), room=Room(62, 30),
        grow=(212, 153, 102)[i], phone=10 + i, height=(212, 120, 120)[i],
    )  # fmt: skip


def law_words() -> Block:
    F = counted(c.F, FORCE)
    return words(
        either(c.view == "force", shown=rf"[F|$F = -k x =$ {F:+} {FORCE.unit_text}]"),
        either(c.kind, turn=r"$m \ddot{x} + k x = 0$ with $k > 0$", drift=r"$m \ddot{x} = 0$ as $k = 0$"),
        r"$\ddot{x} + \omega_n^2 x = 0$",
        either(
            c.kind,
            turn=r"[small|$x = C \sin(\omega t + \phi)$ put in: "
            r"$(\omega_n^2 - \omega^2) x = 0$, so $\omega = \omega_n$]",
        ),
        rf"$\omega_n = \sqrt{{\frac{{k}}{{m}}}} = {c.omega}$ rad/s",
        either(c.kind, turn=rf"$\tau = 2 \pi / \omega_n = {c.tau}$ s", drift="no period"),
        style="facts proof", grow=212, basis=HEADING + NUMBERS, phone=13, name="law",
    )  # fmt: skip


def plane() -> Block:
    x, v, a = PLANE.x(c.x), PLANE.y(c.v), LAW.y(c.a)
    ends = (V.x(T), V.y(c.v), x, v), (x, v, x, a), (A.x(T), A.y(c.a), x, a)
    hand = drag(
        "Point of the phase plane, start",
        along("x", PLANE.x, X.up, x_0=c.x),
        along("y", PLANE.y, V.up, v_0=c.v),
    )
    return PLANE.block(
        path(c.v, c.x, source="loop", group="plane"),
        note("**Phase plane**"),
        title="Phase plane: velocity against displacement",
        over=(
            *(line(*one, style="level", tint="mute", show=ON_WIDE) for one in ends),
            *axis_names(PLANE, "v", "T"),
            circle(x, v, 4.5, grab=hand),
        ),
        plain=True, room=Room(8, 8, bottom=NUMBERS), grow=153, phone=21, height=190,
    )  # fmt: skip


def law() -> Block:
    """Newton's law with Hooke's: a straight line of slope -omega_n^2."""
    return LAW.block(
        path(c.a, c.x, source="loop", group="law"),
        note(rf"**The law:** $a = -{c.ratio}\,x$"),
        title="The law: acceleration against displacement is a straight line",
        over=axis_names(LAW, "a", "F"), x_labels=False, room=Room(8, 8, bottom=NUMBERS), grow=102, phone=22, height=160,
    )  # fmt: skip


def axis_names(plot: Plot, upward: str, tint: str) -> list[Shape]:
    return [
        text(plot.right + 4, plot.y(0) - 6, "*x*", "end", tint="m1", **BOLD),
        text(plot.x(0) + 7, plot.top + 11, f"*{upward}*", "start", tint=tint, **BOLD),
    ]


def lead(late: int) -> list[Shape]:
    """The mark over the plot of v or a: from a peak of x (0) or v (1) to the peak of v or a a quarter period
    earlier."""
    peaks, tops, upper, lower = (
        (c.peak_x, c.peak_v, c.peak_a),
        (c.top_x, c.top_v, c.top_a),
        PLOTS[late],
        PLOTS[late + 1],
    )
    a, b, top, y = lower.x(peaks[late]), lower.x(peaks[late + 1]), upper.y(tops[late]), lower.y(tops[late + 1])
    shapes: list[Shape] = [
        line(a, top, a, y - 6, style="eq", tint="mute"),
        line(b, y - 16, b, y, style="floor"),
        arrow(a, y - 11, b, y - 11, style="thin", head=8),
        text((a + b) * 0.5, y - 17, "*τ*/4", style="b halo"),
    ]
    for i, plot in enumerate(PLOTS):
        shapes = shown_by(plot.in_frame(c, f"peak{i}_seen", partial(_is_peak_seen, i)), *shapes)
    return shapes


def _is_peak_seen(i: int, case: OscillatorShown, t: Axis, up: Axis) -> bool:
    """True if peaks are marked and that of x, v or a is in the frame."""
    return case.view in MARKED and case.last_peak > 0 and case.free.amplitude(i) <= up.end


def hero() -> list[Shape]:
    """The line from the mass to the tip of the arrow and the curve, which are at the same height."""
    y = height(c.x)
    return [
        line(0.04 * W, LEVEL, wide(X.left - 24, STRIP), LEVEL, style="eq", tint="mute"),
        line(MASS, y, NOW, y, style="level", tint="m1"),
        *strip(y),
        *table(y),
        *shown_by(c.turns, *turning((PIVOT, LEVEL))),
    ]


def height(x: PlotValue) -> Expression:
    return LEVEL - SCALE * on_axis(X.up, x)


def beside(centre: Number, scale: Number) -> Callable[[PlotValue], Number]:
    """Return the position of a velocity next to the middle of a circle."""
    return lambda v: centre + scale * PER_V * on_axis(V.up, v)


def strip(y: Number) -> list[Shape]:
    """The small x(t) on a phone, with its cursor."""
    top, bottom = LEVEL - 0.34 * H, LEVEL + 0.34 * H
    place = STRIP, LEVEL, STRIP_LENGTH, RADIUS, number(c.swings), number(c.phi)
    return on_screens(
        ON_NARROW,
        wave(*place, style="sum strip", tint="m1"),
        line(NOW, top, NOW, bottom, style="now strip"),
        circle(NOW, y, 5, tint="m1", style="strip"),
    )


def table(y: Number) -> list[Shape]:
    """The table seen from above: wall, spring and mass; x points up, as in the plot."""
    side = 0.2 * FRAME * c.side
    foot = wide(X.bottom + 16, LEVEL + 0.42 * H)
    aside = MASS - 0.5 * side - 13
    hand = drag("Mass, start", along("y", height, X.up, x_0=c.x, rate="v_0"))
    seen = text(MASS + 52, foot + 4, "smooth table, seen from above", "start", tint="mute", style="halo")
    return [
        wall(MASS - 42, foot, 84, side="bottom"),
        *shown_by(c.spring, spring(MASS, y + 0.5 * side, MASS, foot, c.wire, height=13)),
        box(MASS, y + 0.5 * side, side, "*m*", tint="m1", grab=hand),
        arrow(aside, LEVEL, aside, y, tint="m1"),
        *pulled(MASS + 0.5 * side + 13, y),
        text(MASS + 38, 16, f"*x* = {c.x:+} {X.unit}", "start", tint="m1", **BOLD),
        *on_screens((ON_WIDE, AT_DESK), seen),
    ]


def pulled(x: Number, y: Number) -> list[Shape]:
    """The force of the spring next to the mass, from its middle towards equilibrium; its name is to the right."""
    tip = y + SHARE * (LEVEL - y)
    return shown_by(
        c.forced,
        arrow(x, y, x, tip, tint="F", style="thick", head=16),
        text(x + 12, (y + tip) * 0.5 + 5, "*F*", "start", tint="F", **BOLD),
    )


def at(centre: StageVector, way: StageVector, length: Number) -> StageVector:
    return centre[0] + length * way[0], centre[1] - length * way[1]


def turning(centre: StageVector) -> list[Shape]:
    """The arrow of x and the arrows of v and a, all drawn with the length C, on their circle."""
    found = [*cross(centre, RADIUS), *right_angles(centre)]
    for i in (2, 1, 0):
        (_, tint, style, _), tip = LOOKS[i], at(centre, WAYS[i], RADIUS)
        found.append(arrow(*centre, *tip, tint=tint, style=style, head=11 if i else 13, held=not i))
    speed = beside(centre[0], SCALE)
    hand = drag("Turning arrow, start", along("y", height, X.up, x_0=c.x), along("x", speed, V.up, v_0=c.v))
    found += [
        circle(*centre, 4, tint="ink"),
        circle(*at(centre, START_WAY, RADIUS), 4, style="ghost", tint="mute"),
        circle(speed(c.v), height(c.x), 5, tint="m1", grab=hand),
    ]
    is_first = c.view == "motion"
    for (x, y), (symbol, tint, _, (across, up)), name in zip(WAYS, LOOKS, IN_WORDS, strict=True):
        place = centre[0] + (RADIUS + across) * x, centre[1] - (RADIUS + up) * y + 5
        look: Looks = {"tint": tint, "style": "t2 b halo revealing"}
        found += shown_by(is_first, text(*place, name, **look))
        found += shown_by(c.view != "motion", text(*place, symbol, **look))
    return found


def cross(centre: StageVector, radius: Number) -> list[Shape]:
    x, y = centre
    reach = radius + 8
    return [
        circle(x, y, radius, style="orbit", tint="mute", held=True),
        line(x - reach, y, x + reach, y, style="hair revealing"),
        line(x, y - reach, x, y + reach, style="hair revealing"),
    ]


def right_angles(centre: StageVector) -> list[Shape]:
    """The marks of a quarter turn between two arrows."""
    found = []
    for a, b in pairwise(WAYS):
        corner = at(centre, (a[0] + b[0], a[1] + b[1]), 13)
        found += [
            line(*at(centre, a, 13), *corner, style="floor revealing"),
            line(*corner, *at(centre, b, 13), style="floor revealing"),
        ]
    return found


def first() -> list[Shape]:
    """The arrow at t = 0 with its components A and B. For v_0 < 0, atan would give the opposite direction."""
    x, y = centre = wide(0.635 * (W + FIRST) - FIRST, 0.5 * W), 0.5 * H
    scale = wide(SCALE, 0.42 * H * PER_X)
    speed, radius, way = beside(x, scale), scale * on_axis(X.up, c.free.constants.C), START_WAY
    foot, tip = (speed(c.v_0), y), (speed(c.v_0), y - scale * on_axis(X.up, c.x_0))
    wrong = at(centre, (-1 * way[0], -1 * way[1]), radius)
    middle = at(centre, (number(c.middle_cosine), number(c.middle_sine)), 40)
    aside = at(centre, (way[0] - 0.22 * way[1], way[1] + 0.22 * way[0]), 0.58 * radius)
    outside = (foot[0] + 13 * c.outside, y - 0.5 * radius * way[1] + 5)
    return shown_by(
        c.turns,
        *cross(centre, radius),
        *shown_by(
            c.is_wrong,
            line(*centre, *wrong, style="dotted", tint="mute"),
            circle(*wrong, 4, style="ghost", tint="mute"),
            text(wrong[0] + 10, wrong[1] + 5, "atan", "start", tint="mute", style="halo"),
        ),
        arc(x, y, 28, pi / 2, number(c.phi) + pi / 2, style="floor", tint="ink"),
        line(x, y, *foot, style="sum", tint="T"),
        line(*foot, *tip, style="sum", tint="m1"),
        arrow(x, y, *tip, tint="m1", head=13, grab=start_grab(x, y, scale), held=True),
        circle(x, y, 4, tint="ink"),
        *shown_by(c.names_phi, text(middle[0], middle[1] + 5, "*φ*", **BOLD)),
        *shown_by(c.names_B, text(x + 0.5 * radius * way[0], y + 13 * c.under + 5, "*B*", tint="T", **BOLD)),
        *shown_by(c.names_A, text(*outside, "*A*", tint="m1", **BOLD)),
        *shown_by(c.names_A, *shown_by(c.names_B, text(aside[0], aside[1] + 5, "*C*", tint="m1", **BOLD))),
    )


def start_grab(x: Number, y: Number, scale: Number) -> Grab:
    """Return the tip of the initial arrow from (x, y): x_0 upwards, v_0 across."""
    return grab(
        "Arrow at the start",
        along("y", lambda value: y - scale * on_axis(X.up, value), X.up, x_0=c.x_0),
        along("x", beside(x, scale), V.up, v_0=c.v_0),
    )
