"""The paper of the driven mass: the block and its drive, x(t) and powers, the response and the lag, the forces."""

from __future__ import annotations

import math
from functools import partial

from components.dashpot import NARROW_BELOW, apparatus
from components.language.blocks import Block
from components.language.expressions import Number
from components.language.shapes import Quotient
from components.layout.bode_marks import peak, upright
from components.layout.grabs import grab
from components.layout.sheet import choice, column, desk, row, stage
from components.layout.stage import (
    HALL,
    ON_WIDE,
    STACKED,
    H,
    Looks,
    Shape,
    T,
    W,
    arc,
    arrow,
    circle,
    line,
    path,
    text,
    wide,
)  # fmt: skip
from components.layout.views import in_views
from components.paper.deferred import number
from components.paper.plots import (
    EitherText,
    Plot,
    PlotItem,
    PlotValue,
    along,
    curve,
    drag,
    either,
    form_of,
    note,
    number_name,
    share,
    shown_by,
    when,
    words,
)  # fmt: skip
from components.quantities.parameters import one_of
from components.scenes.driven.case import KINDS, outline
from components.scenes.driven.convolution import in_convolution
from components.scenes.driven.forces import polygon
from components.scenes.driven.harmonics import ONCE, OTHERS, in_harmonics
from components.scenes.driven.plots import DRIVE, LEFT, OMEGA, PHASE, POWER, RESPONSE, ROOM, SIDES, R, X, c

BESIDE = 1 - STACKED
FAINT = (0.0, 0.5, 1.0)
"""The damping ratios of the background curves."""
BEHIND = "faint: *ζ* = 0, 0.5, 1"
AXES = one_of("linear", {"linear": "Linear", "log": "Log"}, "Axes of the response")
KIND_FORMS = {kind: form_of(c.kind == kind) for kind in KINDS}
KIND_FORMS["force"] = form_of(c.has_force)
PUSHES, PULSES, JOLTS = map(form_of, (c.offers_pushes, c.has_width, c.is_impulsive))
MIDDLE, LEVEL = wide(0.34 * W, W * (0.22 * STACKED + 0.3 * BESIDE)), wide(X.y(0), H * (0.44 * STACKED + 0.28 * BESIDE))
IS_BASE = number(c.kind == "base")
STROKE = (0.7 - 0.15 * HALL + (0.4 - 0.25 * HALL) * IS_BASE) * wide(X.bottom - X.top, 0.34 * H)
SIDE: Number = 42 * c.side
ASIDE = MIDDLE + 0.5 * SIDE + 48
"""The x of the drive, next to the block."""
PUSH = wide(0.34 * (X.bottom - X.top), 0.16 * H)
"""The length of the drive's axis, in pixels."""
WHEEL = 9
BELOW, ABOVE = (
    RESPONSE.in_frame(c, side, partial(lambda side, c, r, M: c.response(r, side), side)) for side in ("below", "above")
)
"""The tables of the response, below an undamped resonance and above it."""
RESPONSE_HEIGHT = RESPONSE.bottom - RESPONSE.top


def paper() -> Block:
    label = "Mass on a spring and a dashpot, and what drives it"
    return row(
        column(stage(*block(), *dial(), label=label, height=176), basis=240, grow=40),
        column(
            in_views(response(), "response", "forces"),
            in_views(phase(), "response"),
            in_views(desk(choice(AXES)), "response"),
            *in_harmonics(sweeps("M", "harmonics", c.sine_at)),
            *in_convolution(),
            in_views(displacement(), "motion", "power", "formulas"),
            in_views(when(c.has_power, powers()), "power"),
            in_views(words(sentence(), phone=16, name="balance"), "response", "forces", "formulas"),
            grow=560,
        ),
        in_views(polygon(), "forces"),
        in_views(column(words(*facts(), work(), phone=12, name="formulas"), grow=330), "formulas"),
        gap=6,
    )


def displacement() -> Block:
    sine, rate = rf"$X \sin(\omega\,t\, {c.phi_minus:+})$", rf"$\pm {c.rate}\, t$"
    steady = either(
        c.steady_part,
        dies="steady part",
        stays="particular part",
        dies_formula=f"steady {sine}",
        stays_formula=f"particular {sine}",
    )
    transient = either(
        c.part,
        dies="transient",
        stays="other part, which stays",
        dies_formula=rf"transient $e^{{-{c.decay}\,t}}$",
        stays_formula="other part, which stays",
    )
    growth = either(
        c.growing,
        always="growth",
        first="growth at first",
        always_formula=f"growth {rate}",
        first_formula=f"growth at first {rate}",
    )
    name = either(c.view == "formulas", yes="*x*", no="displacement *x*")  # the view of formulas needs the space
    base = either(c.base_form, name="base *y*", name_formula=rf"$y = {c.Y} \sin({c.omega}\,t)$")
    return X.block(
        curve(c.x, "sum", "m1", label="*x*", words=name, fast="ringing", dot=True),
        curve(c.x_p, "line", "xp", words=steady, read="steady part", fast="band", dot=True),
        curve(c.y, "line", "xp", words=base, read="base", fast="band", dot=True),
        curve(c.x_c, "dash", "xc", words=transient, read="complementary part", fast="ringing", dot=True),
        curve(c.upper, "thin", "m1", words=growth, read="envelope"),
        curve(c.lower, "thin", "m1", group="upper"),
        title="Displacement against time", room=SIDES, grow=300, phone=10, height=190,
    )  # fmt: skip


def powers() -> Block:
    return POWER.block(
        curve(c.power, "line", "F", columns=("t", "P_in"), words=f"mean power in {c.P_in} W", read="put in"),
        curve(c.power, "sum", "T", columns=("t", "P_lost"), words=f"lost {c.P_lost} W", read="lost"),
        title="Power put in by the drive and power lost in the dashpot, each the mean of the last period of the drive",
        room=SIDES, grow=220, phone=11, height=190,
    )  # fmt: skip


def facts() -> tuple[EitherText, ...]:
    root = r"(1 - r^2)^2 + (2 \zeta r)^2"
    return (
        either(
            c.law,
            force=r"$m \ddot{x} + c \dot{x} + k x = F_0 \sin \omega t$",
            push=r"$m \ddot{x} + c \dot{x} + k x = F(t)$",
            base=r"$m \ddot{x} + c (\dot{x} - \dot{y}) + k (x - y) = 0$",
            unbalance=r"$m \ddot{x} + c \dot{x} + k x = m_0 e\, \omega^2 \sin \omega t$",
        ),
        either(
            c.size,
            force=rf"$\tint{{m1}}{{\dfrac{{k X}}{{F_0}} = \dfrac{{1}}{{\sqrt{{{root}}}}} = {c.M}}}$",
            base=rf"$\tint{{m1}}{{\dfrac{{X}}{{Y}} = \sqrt{{\dfrac{{1 + (2 \zeta r)^2}}{{{root}}}}} = {c.M}}}$",
            unbalance=rf"$\tint{{m1}}{{\dfrac{{m X}}{{m_0 e}} = \dfrac{{r^2}}{{\sqrt{{{root}}}}} = {c.M}}}$",
            grows=rf"$c = 0,\ \omega = \omega_n$: no steady size, $\tint{{m1}}{{X = {c.rate}\, t}}$ grows",
            nearly=rf"$c = 0,\ \omega \approx \omega_n$: steady [m1|$X = {c.X}$ m], "
            rf"at first $\tint{{m1}}{{{c.rate}\, t}}$",
        ),
        either(c.steady, shown=rf"[m1|$X = {c.X}$ m, $\phi = {c.phi}$ rad]"),
        either(
            c.quality,
            force=rf"$Q = 1 / (2 \zeta) = {c.Q},\ \Delta \omega = {c.bandwidth}$ rad/s",
            unbalance=rf"$Q = 1 / (2 \zeta) = {c.Q}$",
        ),
    )


def work() -> EitherText:
    return either(
        c.work,
        push=rf"Steady: $\pi c\, \omega X^2 = {c.W}$ J a cycle",
        base=rf"Steady: $\pi c\, \omega |X - Y|^2 = {c.W}$ J a cycle",
    )


def sentence() -> EitherText:
    """The sentence on which force balances the push."""
    return either(
        c.holds,
        spring="**Below resonance the spring balances most of the push.**",
        inertia="**Above resonance inertia balances most of the push.**",
        dashpot="**Here the dashpot balances most of the push.**",
        alone="**At resonance the dashpot alone balances the push.**",
        grows=f"**Nothing balances the push: each swing grows by the same {c.growth} m.**",
        grows_on=f"**Nothing balances the push: in the end each swing grows by {c.growth} m.**",
        nearly=f"**Nothing balances the push at first: each swing grows by {c.growth} m, until a long beat turns it.**",
        nearly_on=f"**At first the push adds {c.growth} m to its response in each swing; a long beat takes it away.**",
        near="**Next to resonance and without a dashpot the swing grows for very long.**",
        more="**Below √2 the mass swings more than its base; a stronger dashpot helps.**",
        alike="**At √2 every dashpot is alike: the mass swings as far as its base.**",
        less="**Beyond √2 a weaker dashpot would let the mass swing less.**",
        isolated="**Beyond √2 the mass swings less than its base, and least without a dashpot.**",
        others=f"**{OTHERS}**",
        once=f"**{ONCE}**",
        still="**At ω = 0 nothing pushes: the curve there is the limit of a very slow push.**",
        idle="**No push: the motion is that of the start alone.**",
    )


# The stage.


def raised(value: PlotValue) -> Number:
    """The pixels of a displacement."""
    return wide(X.up_pixels(value), 0.12 * ROOM * H * X.share(value))


def height(value: PlotValue) -> Number:
    return LEVEL - raised(value)


def strength(value: PlotValue) -> Number:
    """Return the y of a force, or of an unbalance, on a separate axis next to the block."""
    return LEVEL - PUSH * share(DRIVE, value)


FLOOR = LEVEL + 0.5 * STROKE + 0.5 * SIDE
"""The lowest y of the block's lower edge."""


def foot(value: PlotValue) -> Number:
    """Return the y of the base for this displacement."""
    return FLOOR + NARROW_BELOW - raised(value)


def block() -> list[Shape]:
    """The block between its wall and its drive, with a line from the block to the curve at the same height."""
    y, arrow_at = height(c.x), MIDDLE - 0.5 * SIDE - 14
    hand = drag("Mass, start", along("y", height, X.up, x_0=c.x, rate="v_0"))
    return [
        line(0.03 * W, LEVEL, wide(X.left - 30, 0.55 * W), LEVEL, style="eq", tint="mute"),
        line(MIDDLE, y, X.x(T), y, style="level", tint="m1", show=ON_WIDE),
        *apparatus(MIDDLE, y, SIDE, FLOOR, STROKE, number(c.wire), hand, raised(c.base), beside=True),
        arrow(arrow_at, LEVEL, arrow_at, y, tint="m1"),
        *drives(y),
        text(2, 16, f"mass at *x* = {c.x:+} {X.unit}", "start", tint="m1", style="t2 b halo"),
    ]


def dial() -> list[Shape]:
    """The dial: the drive and the steady part as rotating hands with one turn per period. The height of each tip is the
    value."""
    x, y = W * (0.8 * STACKED + 0.5 * BESIDE), H * (0.48 * STACKED + 0.76 * BESIDE)
    radius, quarter, turn = H * (0.28 * STACKED + 0.13 * BESIDE), math.pi / 2, number(c.turn)
    hands = (
        (c.cosine, c.sine, "F", f"{c.drive_name}"),
        (c.mass_cosine, c.mass_sine, "m1", "mass"),
    )
    found = [
        circle(x, y, radius, style="hair", tint="mute"),
        arc(x, y, 0.45 * radius, turn + quarter - number(c.phi), turn + quarter, style="sum revealing", tint="ink"),
    ]
    for side, up, tint, name in hands:
        across, high = radius * number(side), radius * number(up)
        found += [
            arrow(x, y, x + across, y - high, tint=tint, style="thick", head=14),
            text(x + 1.25 * across, y - 1.2 * high + 5, name, tint=tint, style="b halo revealing"),
        ]
    return shown_by(c.has_dial, *found, text(x, H - 6, f"the mass lags by {c.lag_degrees}", style="b halo"))


def drives(y: Number) -> list[Shape]:
    """The force next to the block, the motion of the base next to its wall, the mass that turns in the block."""
    push, base = strength(c.amount), foot(c.stroke)
    turning = MIDDLE + WHEEL * number(c.cosine), y - WHEEL * number(c.sine)
    set_force = along("y", strength, DRIVE, F_0=c.amount, least=0.0)
    set_impulse = along("y", strength, DRIVE, J=c.amount, least=0.0)
    set_base = along("y", foot, X.up, Y=c.stroke, least=0.0)
    set_moment = along("y", strength, DRIVE, moment=c.amount, least=0.0)
    moving: Looks = {"tint": "F", "style": "thick", "head": 14}
    ring: Looks = {"style": "ghost", "tint": "F"}
    name: Looks = {"anchor": "start", "tint": "F", "style": "t2 b halo"}
    return [
        *shown_by(
            c.kind == "force",
            line(ASIDE, LEVEL, ASIDE, push, style="dotted", tint="F"),
            arrow(ASIDE, LEVEL, ASIDE, strength(c.F), **moving),
            *shown_by(c.has_force, circle(ASIDE, push, 5, **ring, grab=grab("Force, amplitude", set_force))),
            *shown_by(c.is_impulsive, circle(ASIDE, push, 5, **ring, grab=grab("Impulse", set_impulse))),
            *shown_by(c.has_force, text(ASIDE + 10, push + 5, "push *F*_0", **name)),
            *shown_by(c.is_impulsive, text(ASIDE + 10, push + 5, "*J*", **name)),
        ),
        *shown_by(
            c.kind == "base",
            line(ASIDE, foot(0), ASIDE, base, style="dotted", tint="F"),
            arrow(ASIDE, foot(0), ASIDE, foot(c.base), **moving),
            circle(ASIDE, base, 5, **ring, grab=grab("Base, amplitude", set_base)),
            text(ASIDE + 10, base + 5, "*Y*", **name),
        ),
        *shown_by(
            c.kind == "unbalance",
            circle(MIDDLE, y, WHEEL, style="wheel", tint="ink"),
            circle(*turning, 5, tint="F"),
            line(ASIDE, LEVEL, ASIDE, push, style="dotted", tint="F"),
            circle(ASIDE, push, 5, **ring, grab=grab("Unbalance", set_moment)),
            text(ASIDE + 10, push + 5, "*m*_0*e*", **name),
        ),
    ]


# The response and the lag over one axis of r.


def behind(plot: Plot) -> list[Shape]:
    """Return outlines for other damping ratios. They are the same for all visitors and are scaled to the axes."""
    place: Looks = {"x": plot.x(0), "y": plot.y(0), "sx": plot.per_x, "sy": -1 * plot.per_y}
    look: Looks = {"style": "scaled behind", "tint": "m1", "inside": plot}
    outlines = ((kind, outline(kind, zeta, plot is PHASE)) for kind in KINDS for zeta in FAINT)
    return [shape for kind, d in outlines for shape in shown_by(c.outlined == kind, path(d, **place, **look))]


def sweeps(column: str, group: str, dot: float, words_: EitherText | str = "") -> list[PlotItem]:
    """Return the curve below an undamped resonance, with its dot, and the one above."""
    columns = ("omega", column)
    return [
        curve(BELOW, "sum", "m1", columns=columns, group=group, words=words_, dot=(c.omega_at, dot)),
        curve(ABOVE, "sum", "m1", columns=columns, group=group),
    ]


def response() -> Block:
    M = RESPONSE.in_frame(
        c, "M_held", lambda c, r, M: min(max(c.M, M.start), M.end) if c.settles else None, optional=True
    )
    x, y, root2, one = RESPONSE.x(c.omega_at), RESPONSE.y(M), RESPONSE.x(c.root2), RESPONSE.y(c.unity)
    top, low, high, own = map(RESPONSE.x, (c.peak_at, c.peak_low, c.peak_high, c.natural))
    hand = grab("Drive frequency, on the curve", along("x", RESPONSE.x, R, omega=c.omega, least=0.0), inside=RESPONSE)
    legend = either(c.kind, force="swing $k |X| / F_0$", base="swing $|X| / Y$", unbalance="swing $m |X| / m_0 e$")
    return RESPONSE.block(
        *sweeps("M", "response", c.M_at, legend),
        curve(
            BELOW, "line", "T", columns=("omega", "power"), words=either(c.is_peaked, shown="power lost")
        ),
        note("against frequency ratio *r* = *ω*/*ω*_n", "mute"),
        note(either(c.is_flat, shown=BEHIND), "mute"),
        note(either(c.peak_form, shown=f"peak at {c.peak_at} rad/s, width {c.peak_width}"), "m1"),
        title="Amplitude of the steady part against r, the drive frequency over the natural one",
        handles=(OMEGA,),
        over=[
            *behind(RESPONSE),
            *half_width(),
            *shown_by(
                c.kind == "base",
                line(root2, RESPONSE.top, root2, RESPONSE.bottom, style="eq", tint="mute"),
                line(RESPONSE.left, one, RESPONSE.right, one, style="eq", tint="mute"),
                text(root2 + 8, RESPONSE.top + 16, "every *ζ* passes 1 at √2", "start", style="halo", tint="mute"),
            ),
            *peak(top, RESPONSE.y(c.peak_up), low, high, RESPONSE.y(c.peak_half), tint="m1"),
            upright(RESPONSE, own, "mute"),
            text(own + 6, RESPONSE.top + 16, "*ω*_n", "start", tint="mute", style="halo"),
            upright(RESPONSE, x, "F"),
            circle(x, y, 0, grab=hand),
            text(x, y, f"{c.M}", "beside", tint="m1", style="t2 b halo"),
        ],
        room=LEFT, grow=330, phone=10, height=212,
    )  # fmt: skip


def half_width() -> list[Shape]:
    """The width of the power curve at half its peak, and the line at Q, the response at r = 1. Dragging this line sets
    the damping."""
    low, high, one, past = map(RESPONSE.x, (c.half_low, c.half_high, c.one.omega_n, c.beyond))
    y, height, aside = RESPONSE.y(c.half_peak), RESPONSE.y(c.peak), RESPONSE.top + 0.19 * RESPONSE_HEIGHT
    hand = Quotient(
        across="y", zero=RESPONSE.y(0), unit=RESPONSE.per_y, parameter="zeta", moves=number_name(c.peak, RESPONSE.up),
        over=number_name(c.half), least=0.2,
    )  # fmt: skip
    return shown_by(
        c.is_peaked,
        line(low, y, high, y, style="thin", tint="ink"),
        circle(low, y, 3.5, tint="T"),
        circle(high, y, 3.5, tint="T"),
        *shown_by(
            c.view != "forces",  # the view of forces needs the space for the polygon
            text(past + 10, y + 5, f"width Δ*ω* = {c.bandwidth} rad/s", "start", style="halo"),
            text(past + 26, y + 20 + 4 * HALL, "at half the power", "start", style="halo"),
        ),
        line(one, height, one + 60, height, style="level", tint="ink", inside=RESPONSE),
        circle(one + 60, height, 5, style="ghost", tint="T", grab=grab("Height at r = 1, Q", hand)),
        text(one + 70, height + 5, f"quality *Q* = {c.Q}", "start", style="b halo"),
        text(RESPONSE.right - 4, aside, BEHIND, "end", tint="mute", style="halo", show=ON_WIDE),
    )


def phase() -> Block:
    x = PHASE.x(c.omega_at)
    return PHASE.block(
        *sweeps("lag", "phase", c.lag_at),
        title="Lag of the mass behind the drive against r: from 0 to half a turn",
        over=[
            *behind(PHASE),
            upright(PHASE, PHASE.x(c.natural), "mute"),
            upright(PHASE, x, "F"),
            text(PHASE.left + 8, PHASE.top + 18, "lag *φ* of *x* behind the push", "start", tint="mute", style="halo"),
        ],
        room=LEFT, grow=110, phone=15, height=130,
    )  # fmt: skip
