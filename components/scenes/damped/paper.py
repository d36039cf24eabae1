"""The paper of the damped mass: the block next to x(t), energy and power, the plane of the roots, the words."""

from __future__ import annotations

import math
from itertools import pairwise

from components.dashpot import NARROW_BELOW, apparatus
from components.language.blocks import Block
from components.language.expressions import Number
from components.language.plots import Room
from components.layout.root_plane import root_plane
from components.layout.sheet import column, desk, measured, residuals, row, stage
from components.layout.stage import AT_DESK, ON_WIDE, H, Shape, T, W, arrow, circle, line, text, wide
from components.layout.views import in_views
from components.paper.deferred import deferred, number
from components.paper.plot_axes import TIME, axis
from components.paper.plots import (
    EitherText,
    Plot,
    PlotValue,
    along,
    curve,
    drag,
    either,
    hold_root,
    layer,
    note,
    shown_by,
    stack,
    when,
    words,
)
from components.quantities.axes import Axis
from components.scenes.damped.case import MOST_PEAKS, DampedShown
from physics.free_decay import Moment

c = deferred(DampedShown)
MODEL = ("motion", "roots", "energy", "forces", "formulas")
EXAMPLES = ("dashpot", "air drag")
"""The views that show the model alone."""
SIDES = Room(56, 30)
LEFT, RIGHT, UP = 1.55, 0.88, 1.28
"""The ends of the axes of the plane of roots, in natural frequencies."""
X = Plot("x", TIME, axis("m", lambda c: (-_reach(c), _reach(c)), room=1.25, count=2))
ENERGY = Plot("energy", TIME, axis("J", lambda c: (0.0, c.E_total or 1.0), "E", room=1.08, whole=True))
POWER = Plot("P", TIME, axis("W", lambda c: (0.0, c.P_max), room=1.15, count=2))
ROOTS = Plot(
    "roots",
    axis("1/s", lambda c: (-LEFT * c.circle, RIGHT * c.circle), "re", plain=True, seen=lambda c: (-c.circle, 0.0)),
    axis("1/s", lambda c: (-UP * c.circle, UP * c.circle), "im", plain=True, seen=lambda c: (-c.circle, c.circle)),
)
LEVEL, MIDDLE = wide(X.y(0), 0.3 * H), wide(0.52 * W, 0.3 * W)
STROKE = wide(0.8 * (X.bottom - X.top), 0.24 * H)
"""The range of motion of the block in pixels, from the lowest x of the frame to the highest; shorter on a phone."""
SIDE = wide(56, 42) * c.side
LONGEST = 0.36
"""Length of the longest arrow of a force, as a share of the stroke."""
LEAST_DROP = 0.04
"""A step between two peaks is drawn if it is at least this share of the frame's height."""
TICKS, NAMED = (0.2, 0.4, 0.6, 0.8), (0.4, 0.8)


def _reach(case: DampedShown) -> float:
    """Half the range of the axis of x in m."""
    return case.reach or abs(case.x_0) or 1.0


def paper() -> Block:
    label = "Mass on a spring and a dashpot, which stand on a wall"
    return row(
        in_views(stage(*block(), label=label, grow=160, height=172), *MODEL),
        column(
            displacement(),
            in_views(residuals("x", "Motion", grow=110, phone=11, height=150), "measured"),
            in_views(desk(power()), "energy"),
            in_views(energy(), "energy"),
            in_views(words(fate(), phone=15, name="fate"), *(view for view in MODEL if view != "energy")),
            grow=450,
        ),
        in_views(column(plane(), grow=262), "roots"),
        in_views(column(facts(), grow=250), "formulas"),
        in_views(column(measured("file", 6, EXAMPLES), measured("fit", 12), grow=250), "measured"),
        gap=6,
    )


def displacement() -> Block:
    x = either(
        c.x_form,
        words=r"\text{displacement } x",
        under=rf"x = {c.C}\, e^{{-{c.a}\,t}} \sin({c.omega_d}\,t\, {c.phi:+})",
        plain=rf"x = {c.C}\, \sin({c.omega}\,t\, {c.phi:+})",
        critical=rf"x = ({c.A}\, {c.B:+}\,t)\, e^{{-{c.a}\,t}}",
        parts="x =",
        over=rf"x = {c.A}\, e^{{{c.slow}\,t}}\, {c.B:+}\, e^{{{c.fast}\,t}}",
        rest="x = 0",
        glide=rf"x = {c.x_0}\, {c.v_0:+}\, \frac{{1 - e^{{-{c.rate}\,t}}}}{{{c.rate}}}",
        drift=rf"x = {c.x_0}\, {c.v_0:+}\,t",
    )
    envelope = either(c.envelope_form, words=r"\text{envelope}", numbers=rf"\pm {c.C}\, e^{{-{c.a}\,t}}")
    slow = either(c.parts_form, words=r"\text{slow part}", numbers=rf"{c.A}\, e^{{{c.slow}\,t}}")
    fast = either(c.parts_form, words=r"\text{fast part}", numbers=rf"{c.B:+}\, e^{{{c.fast}\,t}}")
    return X.block(
        curve(c.x, "sum", "m1", label="*x*", legend=x, fast="band", dot=True),
        curve(c.upper, "thin", "m1", read="envelope", legend=envelope),
        curve(c.lower, "thin", "m1", group="upper"),
        curve(c.slow_part, "thin", "m1", read="slow part", legend=slow),
        curve(c.fast_part, "dash", "m1", read="fast part", legend=fast),
        title="Displacement against time",
        over=stairs(), room=SIDES, grow=184, phone=10, height=212,
    )  # fmt: skip


def energy() -> Block:
    return ENERGY.block(
        curve(c.E_0, "sum", "total", group="total", legend=rf"E_0 = {ENERGY.text(c.E_total)}"),
        note(f"{ENERGY.unit} =", "total"),
        *stack(
            layer(c.V, "V", legend=rf"V\, {c.V}", read="*V*"),
            layer(c.T, "T", top=c.E, legend=rf"+\; T\, {c.T}", read="*T*"),
            layer(c.heat, "k2fill", top=c.E_0, words=f"+ heat {c.heat}", read="heat"),
        ),
        title="Energy against time: potential, kinetic, and what has become heat in the dashpot; the sum is constant",
        over=at_fastest(ENERGY), room=SIDES, grow=160, phone=8, height=190,
    )  # fmt: skip


def power() -> Block:
    where = either(
        c.fastest,
        before="greatest before *x* = 0",
        fastest="greatest where the mass is fastest",
        at_start="greatest at the start",
    )
    block = POWER.block(
        curve(c.P, "line", "T", fill=0.25, legend=rf"P = c v^2 = {c.P}", fast="mean", dot=True),
        note(POWER.unit, "T"),
        note(where, "mute"),
        title="Power that the dashpot takes, against time",
        over=at_fastest(POWER, POWER.y(c.P_max)), x_labels=False, room=SIDES, grow=130, phone=11,
        height=110,
    )  # fmt: skip
    return when(c.power, block)


def plane() -> Block:
    formula = either(
        c.roots,
        pair=rf"$s = \tint{{T}}{{-{c.a}}} \pm \tint{{m1}}{{{c.omega_d}\, i}} \text{{ 1/s}}$",
        wall=rf"$s = \pm {c.omega}\, i \text{{ 1/s}}$",
        critical=rf"$s = -{c.omega} \text{{ 1/s, twice}}$",
        real=rf"$s = {c.slow},\; {c.fast} \text{{ 1/s}}$",
        bare=rf"$s = 0,\; {c.fast} \text{{ 1/s}}$",
    )
    return ROOTS.block(
        curve(c.locus, "thin", "ink", read="other *ζ*", columns=("re", "im"), group="locus"),
        note(formula),
        title="Plane of the roots: to the left a motion decays faster, upwards it swings faster",
        over=roots(), room=Room(2, 2), square=True, plain=True, grow=250, phone=9, height=290,
    )  # fmt: skip


def facts() -> Block:
    natural = either(
        c.spring,
        yes=rf"$\omega_n = \sqrt{{\dfrac{{k}}{{m}}}} = {c.omega}$ rad/s",
        no=r"$\omega_n = 0$ without a spring",
    )
    numbers = (
        either(
            c.spring,
            yes=rf"$\tint{{T}}{{\zeta = \dfrac{{c}}{{2 m \omega_n}} = {c.zeta}}}$",
            no=rf"[T|$c / m = {c.rate}$ 1/s], and no $\zeta$ without a spring",
        ),
        either(
            c.kind,
            under=rf"$\tint{{m1}}{{\omega_d = \omega_n \sqrt{{1 - \zeta^2}} = {c.omega_d}}}$ [m1|rad/s]",
            over=r"$s_{1,2} = -\omega_n (\zeta \mp \sqrt{\zeta^2 - 1})$",
            critical=rf"$s = -\omega_n = -{c.omega}$ 1/s, twice",
            **dict.fromkeys(("rest", "plain", "glide", "drift"), ""),  # an empty line
        ),
        either(
            c.kind,
            under=rf"$\delta = \ln \dfrac{{x_1}}{{x_2}} = \zeta \omega_n \tau_d = {c.delta}$",
            over=rf"$s_1 s_2 = \omega_n^2 = {c.square}$ 1/s²",
        ),
    )
    return words(r"$m \ddot{x} + c \dot{x} + k x = 0$", natural, *numbers, phone=12, name="formulas")


def fate() -> EitherText:
    """The sentence on how the motion ends."""
    return either(
        c.said,
        swing=f"Each swing keeps {c.keep} of its size and {c.keep_energy} of its energy, and takes {c.longer} longer "
        "than undamped.",
        hardly=f"It hardly swings: each turn reaches {c.half} of the one before.",
        plain="Nothing is lost: every swing is as large as the last.",
        thrice=f"It has fallen to 1 % of its start after {c.home} s and never passes 0; "
        f"with three times the damping after {c.home_3} s.",
        home=f"It has fallen to 1 % of its start after {c.home} s and never passes 0.",
        out=f"It goes out to {c.farthest} m, turns once, and comes back without passing 0.",
        crosses=f"It passes 0 once, at {c.zero} s, because it was thrown faster than {c.crossing} m/s; let go, "
        "it never would.",
        never="It never passes 0 again.",
        rest="It rests: there is nothing to lose.",
        glide=f"No spring: it glides to rest {c.glide} m further on.",
        drift="No spring and no dashpot: it keeps its velocity.",
        still="No spring, and a start at rest: nothing moves.",
    )


def height(x: PlotValue) -> Number:
    return wide(X.y(x), 0.3 * H - 0.15 * H * X.share(x))


def block() -> list[Shape]:
    """Block, spring and dashpot on their wall, with a line from the block to the curve at the same height."""
    y, lowest = height(c.x), LEVEL + 0.5 * STROKE + 0.5 * SIDE
    aside, foot = MIDDLE - 0.5 * SIDE - 15, lowest + NARROW_BELOW
    hand = drag("Mass, start", along("y", height, X.up, x_0=c.x, rate="v_0"))
    return [
        line(0.03 * W, LEVEL, wide(X.left - 30, 0.55 * W), LEVEL, style="eq", tint="mute"),
        line(MIDDLE, y, X.x(T), y, style="level", tint="m1", show=ON_WIDE),
        *apparatus(MIDDLE, y, SIDE, lowest, STROKE, c.wire, hand, beside=True),
        arrow(aside, LEVEL, aside, y, tint="m1"),
        *force(number(c.pull), aside, -9, y, "k", "−*kx*", "end"),
        *force(number(c.brake), MIDDLE + 0.5 * SIDE + 15, 9, y, "T", "−*cv*", "start"),
        text(
            wide(2, 0.58 * W), wide(16, 0.28 * H), f"*x* = {c.x:+} {X.unit}", "start", tint="m1", style="t2 b halo",
        ),
        text(
            2, foot + 26, "table, seen from above", "start", tint="mute", style="halo", show=(ON_WIDE, AT_DESK),
        ),
    ]  # fmt: skip


def force(size: Number, x: Number, beside: int, y: Number, tint: str, name: str, anchor: str) -> list[Shape]:
    """Return the arrow of a force on the block, relative to the largest force; up is away from the wall."""
    tip = y - LONGEST * STROKE * size
    return [
        arrow(x, y, x, tip, tint=tint, style="thick", head=14),
        text(x + beside, tip + 5, name, anchor, tint=tint, style="b halo"),
    ]


def stairs() -> list[Shape]:
    """Return steps from each peak of x(t) to the next: a horizontal line of one period, and the drop, which is always
    the same share."""
    peaks, drops = X.in_frame(c, "peak", _peaks), X.in_frame(c, "stair", _drops)
    points = [(X.x(peaks[i].t), X.y(peaks[i].x)) for i in range(MOST_PEAKS)]
    shapes: list[Shape] = []
    for i, ((here, level), (there, low)) in enumerate(pairwise(points)):
        shapes += shown_by(
            drops[i],
            line(here, level, there, level, style="eq", tint="ink"),
            arrow(there, level, there, low, tint="ink", style="thin", head=8),
            text(there, (level + low) * 0.5, f"{c.keep_x}", "beside", style="b halo"),
        )
    shapes += [circle(*point, 3.5, tint="m1") for point in points]
    (x1, y1), (x2, y2) = points[:2]
    shapes += shown_by(
        drops[0],
        text(x1, y1, "peak *x*_1", "beside", tint="m1", style="t2 b halo"),
        text(x2, y2, "*x*_2", "beside", tint="m1", style="t2 b halo"),
        text((x1 + x2) * 0.5, y1, f"period *τ*_d {c.tau_d} s", "beside", style="b halo"),
    )
    return shapes + at_fastest(X, X.y(c.quickest.x))


def _peaks(case: DampedShown, t: Axis, x: Axis) -> list[Moment]:
    """The peaks in the frame."""
    return [peak for peak in case.peaks if x.start <= peak.x <= x.end]


def _drops(case: DampedShown, t: Axis, x: Axis) -> list[bool]:
    """True if the drop from each peak in the frame to the next is large enough to draw."""
    least = LEAST_DROP * (x.end - x.start)
    return [abs(one.x - two.x) >= least for one, two in pairwise(_peaks(case, t, x))]


def at_fastest(plot: Plot, level: Number | None = None) -> list[Shape]:
    """Return a vertical line over a plot at the time when the mass is fastest, and a ring on the curve."""
    x = plot.x(c.quickest.t)
    start, end = (level or 0.0, plot.bottom) if plot is X else (plot.top, plot.bottom if level is None else level)
    ring = [] if level is None else [circle(x, level, 4.5, style="ghost", tint="ink", inside=plot)]
    return [line(x, start, x, end, style="eq", tint="mute", inside=plot), *ring]


def roots() -> list[Shape]:
    """The plane of the roots: the wall of c < 0, the circle of the natural frequency with the scale of zeta."""
    x0, y0, radius = ROOTS.x(0), ROOTS.y(0), ROOTS.across_pixels(c.one.omega_n)
    return [
        *root_plane((ROOTS.left, ROOTS.right, ROOTS.top, ROOTS.bottom), x0, y0, "*c* < 0"),
        *shown_by(c.root_kind != "bare", *scale(x0, y0, radius)),
        *held(x0, y0, radius),
    ]


def held(x0: Number, y0: Number, radius: Number) -> list[Shape]:
    """Return the roots. The one that can be dragged is filled; it follows the pointer before the server answers."""
    root, seen = ROOTS.in_frame(c, "root", _root), ROOTS.in_frame(c, "held_root", _held)
    left = ROOTS.in_frame(c, "out", lambda c, re, im: c.root_kind == "real" and not _held(c, re, im))
    x, y, slow, edge = x0 - radius * root, ROOTS.y(c.one.omega_d), x0 - radius * c.slow_root, ROOTS.left + 4
    pair, real = c.root_kind == "pair", c.root_kind == "real"
    hand = hold_root("Root", ROOTS, x0, -1 * radius, moves=root, parameter="zeta", least=0.0)
    slow_hand = hold_root(
        "Slow root", ROOTS, x0, -1 * radius, moves=c.slow_root, parameter="zeta", least=0.01, most=1.0, real=True
    )
    return [
        *shown_by(
            c.legs,
            line(x0, y0, x, y, style="thin", tint="ink"),
            line(x0, y0, x, y0, style="sum", tint="T"),
            line(x, y0, x, y, style="sum", tint="m1"),
            text(x - 8, (y + y0) * 0.5 + 4, f"*ω*_n {c.omega}", "end", style="b halo"),
            text((x + x0) * 0.5 - 4, y0 + 19, f"*ζω*_n {c.a}", "end", tint="T", style="b halo"),
            text(x0 + 16, y + 5, f"*ω*_d {c.omega_d}", "start", tint="m1", style="b"),
        ),
        *shown_by(pair, circle(x, 2 * y0 - y, 6, style="ghost", tint="ink")),
        *shown_by(seen, circle(x, y, 8, tint="ink", grab=hand)),
        *shown_by(pair, text(x - 14, y - 12, f"*ζ* {c.zeta}", "end", tint="T", style="t2 b halo")),
        *shown_by(
            real,
            circle(slow, y0, 8, tint="ink", grab=slow_hand),
            text(slow, y0 - 17, f"*ζ* {c.zeta}", tint="T", style="t2 b halo"),
        ),
        *shown_by(c.apart, text(slow, y0 + 25, f"{c.slow}", style="b halo")),
        *shown_by(
            left,
            arrow(edge + 34, y0, edge, y0, tint="ink", style="thin"),
            text(edge, y0 + 21, f"{c.fast}", "start", style="b halo"),
        ),
        *shown_by(
            c.root_kind == "bare",
            circle(x0, y0, 6, style="ghost", tint="ink"),
            circle(ROOTS.x(c.bare_root), y0, 6, style="ghost", tint="ink", inside=ROOTS),
        ),
    ]


def _held(case: DampedShown, re: Axis, im: Axis) -> bool:
    """True if the frame contains the root that can be dragged: the faster one, or the upper one of a pair."""
    return case.root_kind == "pair" or (case.root_kind == "real" and -case.one.rates[1] >= re.start)


def _root(case: DampedShown, re: Axis, im: Axis) -> float:
    """The distance of that root from the imaginary axis in natural frequencies; for a pair of roots, this is the
    damping ratio."""
    if case.root_kind == "real" and _held(case, re, im):
        return case.one.rates[1] / case.one.omega_n
    return case.one.zeta if case.k else 1.0


def scale(x0: Number, y0: Number, radius: Number) -> list[Shape]:
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
