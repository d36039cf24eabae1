"""The paper of the hanging mass: its stage, with a bar of V and T; under it the potential well; x and the energies
against time."""

from __future__ import annotations

from typing import Any

import numpy as np
from msgspec.structs import replace

from components.language.blocks import Block
from components.language.expressions import Number
from components.layout.plots import Room
from components.layout.sheet import column, row, stage
from components.layout.stage import (
    ON_WIDE,
    H,
    Looks,
    Shape,
    T,
    W,
    arrow,
    box,
    circle,
    line,
    rectangle,
    spring,
    text,
    wall,
    wide,
)
from components.layout.views import in_views
from components.paper.deferred import deferred, number
from components.paper.plot_axes import TIME, axis
from components.paper.plots import (
    Plot,
    PlotValue,
    along,
    curve,
    drag,
    either,
    note,
    on_axis,
    shown_by,
    words,
)
from components.quantities.axes import Axis, nice_axis, nice_ticks
from components.quantities.formatting import at_tick, power_unit, three
from components.scene.traces import Columns
from components.scenes.energy.case import PLANETS, EnergyShown

c = deferred(EnergyShown)
FARTHEST = 6.0
"""Distance in amplitudes up to which the natural length is shown in the picture."""
POINTS = 121
"""Points of a curve of the well."""


def _x_axis(case: EnergyShown) -> Axis:
    """The axis of x, downwards: from above the natural length, unless that is far away, to below the lowest point."""
    C, delta = case.C, case.delta
    high = max(1.25 * C, 1.12 * delta if delta <= FARTHEST * C or not C else 0.0) or 1.0
    low = 1.25 * C or 0.5 * high
    exponent, suffix = power_unit(max(high, low))
    seen = (-delta if 1.12 * delta == high else -C, C)
    bare = Axis(low, -high, "m", exponent, suffix, drawn=seen)
    return replace(bare, ticks=nice_ticks(bare.place(-high), bare.place(0.95 * low), 2))


def _well_axis(case: EnergyShown) -> Axis:
    """The axis of the well, in the unit of x; the well is drawn a little beyond the turning points."""
    x = _x_axis(case)
    end = 1.18 * case.C or x.start
    ticks = nice_ticks(x.place(-end), x.place(end), 2)
    return replace(x, start=-end, end=end, ticks=ticks, drawn=(-case.C, case.C))


def _energy_axis(case: EnergyShown) -> Axis:
    """The axis from the lowest to the highest energy drawn; the sum T + V has its own tick."""
    top, bottom, constant = case.E_total, 0.0, case.system.datum_shift
    if case.apart:
        top, bottom = case.free.E + constant + case.weight, -case.weight
    if case.datum == "slide":
        bottom = -max(case.weight, constant)
    room = 0.11 * (top - bottom) or 1.0
    axis = nice_axis(bottom - (room / 2 if bottom else 0.0), top + room, "J", 2, exact=True)
    total, span = axis.place(case.E_total), axis.place(axis.end) - axis.place(axis.start)
    ticks = tuple(sorted({*(tick for tick in axis.ticks if abs(tick - total) > 0.16 * span), total}))
    labels = tuple(f"{three(tick)} {axis.full_unit}" if tick == total else at_tick(tick) for tick in ticks)
    return replace(axis, ticks=ticks, labels=labels, drawn=(bottom, top))


def _axis_beside(case: EnergyShown) -> Axis:
    """The axis of the energies against time. It omits the number of the sum if the bar next to it shows it."""
    axis = _energy_axis(case)
    if case.view != "energy":
        return axis
    total, labelled = axis.place(case.E_total), zip(axis.ticks, axis.labels, strict=True)
    return replace(axis, labels=tuple("" if tick == total else label for tick, label in labelled))


X = Plot("x", TIME, axis("m", _x_axis))
WELL = Plot("well", axis("m", _well_axis, "x_well", like=X.up), axis("J", _energy_axis, "E"))
ENERGY = Plot("energy", TIME, axis("J", _axis_beside, "E_time", like=WELL.up))

MOTION = number(c.view == "motion")
CENTRE = wide(0.4 * W, 0.2 * W + MOTION * (88 - 0.08 * W))
"""The x of the middle of the mass. If levels have names, it leaves room for them on its left."""
HALF, ASIDE = wide(62, 30), wide(45, 26)
"""Half the width of the level lines, and the position of the arrows."""
CEILING, FIRST, LENGTH = wide(16, 12), wide(0.24 * H, 0.2 * H), wide(0.5 * H, 0.58 * H)
"""The y of the ceiling and of the upper end of the axis of x, and the length of that axis."""
BAR, BROAD = wide(0.66 * W, 0.4 * W), wide(46, 0.128 * W)
"""The left edge of the bar, and its width: on a phone with large text its names have room next to it."""
NAME = wide(2, 2 + (1 - MOTION) * (0.4 * W - 10)), wide(H - 6, 0.36 * H - 29 + MOTION * (0.64 * H + 23))
"""The position of the text for x: in the lower corner; on a phone above the bar, because the mass covers that
corner."""
X_TOP = X.in_frame(c, "x_top", lambda c, t, x: x.end)
PER_SPAN = number(X.in_frame(c, "per_span", lambda c, t, x: 1 / (x.place(x.start) - x.place(x.end))))


def height(x: PlotValue) -> Number:
    """The height of a displacement on the stage."""
    return FIRST + LENGTH * (on_axis(X.up, x) - on_axis(X.up, X_TOP)) * PER_SPAN


def paper() -> Block:
    label = "Mass on a spring, its natural length and its equilibrium, and its energy as a bar"
    shapes = (*levels(), *body(), *shown_by(c.view == "motion", *planets()), *shown_by(c.view == "energy", *bar()))
    return row(
        stage(*shapes, label=label, grow=385, height=184),
        column(
            in_views(energies(), "energy"),
            in_views(well(), "well"),
            in_views(displacement(), "motion"),
            in_views(claim(), "energy"),
            in_views(gravity(), "motion", "formulas"),
            in_views(law(), "formulas"),
            grow=527,
        ),
        gap=0,
    )  # fmt: skip


def displacement() -> Block:
    natural = X.y(NATURAL)
    return X.block(
        curve(c.x, "sum", "m1", label="*x*", fast="band", dot=True),
        title="Displacement from equilibrium, downwards, against time",
        over=shown_by(NATURAL_SEEN, line(X.x(0), natural, X.right, natural, style="eq", tint="mute")),
        room=Room(58, 56), grow=300, phone=10, height=220,
    )  # fmt: skip


def claim() -> Block:
    """The sentences on the largest T and V, by the choice of V = 0."""
    T_max, shift = f"{WELL.text(c.T_max)}", f"{WELL.text(c.shift)} {WELL.unit}"
    return words(
        either(
            c.claim,
            equilibrium=rf"$T_{{\mathrm{{max}}}} = V_{{\mathrm{{max}}}} = {T_max}$ {WELL.unit}: all $T$ "
            rf"at equilibrium, where $v = \omega_n x_{{\mathrm{{max}}}} = {c.v_max}$ m/s; all $V$ where it turns.",
            separate=r"$V_{\mathrm{max}} = T_{\mathrm{max}} + \tfrac{1}{2} k \delta_{\mathrm{st}}^2 "
            f"= {T_max} + $ {shift}: a constant more; the motion does not change.",
            weightless="Without weight both ways of counting $V$ are one: "
            rf"$V_{{\mathrm{{max}}}} = T_{{\mathrm{{max}}}} = {T_max}$ {WELL.unit}.",
            rest="Nothing moves: it rests in equilibrium, where $T$ and $V$ stay 0.",
            rest_apart=f"Nothing moves: it rests in equilibrium, $T$ stays 0 and $V$ stays {shift}.",
            slide=r"Three terms, and because $k \delta_{\mathrm{st}} = m g$ their sum is $\tfrac{1}{2} k x^2$: "
            "gravity drops out of the motion.",
        ),
        phone=15, name="claim",
    )  # fmt: skip


def energies() -> Block:
    twice = f"at {c.omega_2} rad/s, twice the natural *ω*_n"
    return ENERGY.block(
        curve(c.total, "sum", "total", words="sum $T + V$", read="*T*+*V*", dot=True),
        curve(c.V, "line", "V", words="position $V$", read="*V*", fast="band", dot=True),
        curve(c.T, "dash", "T", words="motion $T$", read="*T*", fast="band", dot=True),
        curve(c.spring, "line", "k", words="spring", label="spring", fast="band"),
        curve(c.gravity, "dash", "k", words="gravity", label="gravity", fast="band"),
        curve(c.constant, "dots", "k", label="const.", dot=True),
        note(either(c.datum, equilibrium=twice), "mute"),
        title="Kinetic energy, potential energy and their constant sum against time",
        room=Room(58, 56), grow=300, phone=10, height=224,
    )  # fmt: skip


def _well_columns(case: EnergyShown, across: Axis, up: Axis) -> Columns:
    """The plot of V against x. "Term by term" also shows its terms, and the slide's V if that differs by a constant."""
    x = np.linspace(across.start, across.end, POINTS)
    slide = case.system.well(x)
    if not case.apart:
        return {"x": x, "V": slide}
    columns = {"x": x, "spring": case.system.spring(x), "gravity": case.system.gravity(x)}
    if case.separate:
        return columns | {"V": case.system.well(x, "separate"), "other": slide}
    return columns | {"V": slide, "constant": np.full_like(x, -case.system.datum_shift)}


def well() -> Block:
    table = WELL.in_frame(c, "well", _well_columns)
    V = either(
        c.datum,
        equilibrium=r"V = \tfrac{1}{2} k x^2",
        separate=r"V = \tfrac{1}{2} k (x + \delta_{\mathrm{st}})^2 - m g x",
        slide=r"V = \tfrac{1}{2} k (x + \delta_{\mathrm{st}})^2 - \tfrac{1}{2} k \delta_{\mathrm{st}}^2 - m g x",
    )
    other = either(c.datum, separate="the slide's")
    return WELL.block(
        curve(table, "sum", "V", columns=("x", "V"), legend=V, read="*V*", group="well"),
        curve(table, "dash", "V", columns=("x", "other"), words=other),
        curve(table, "dots", "k", columns=("x", "constant"), read="constant"),
        curve(table, "dash", "k", columns=("x", "gravity"), read="gravity"),
        curve(table, "line", "k", columns=("x", "spring"), read="spring"),
        title="The potential well: V against displacement, with the level of the energy and the turning points",
        over=ball(), room=Room(58, 40), grow=300, phone=10, height=240,
    )  # fmt: skip


def gravity() -> Block:
    return words(
        rf"$\delta_{{\mathrm{{st}}}} = \frac{{m g}}{{k}} = {c.delta}$ m",
        rf"$\omega_n = \sqrt{{\frac{{k}}{{m}}}} = {c.omega}$ rad/s",
        either(c.place, said="[small|Gravity sets where it hangs, not how fast it swings.]"),
        rf"$\tau = 2 \pi / \omega_n = {c.tau}$ s",
        style="proof", phone=16, name="gravity",
    )  # fmt: skip


def law() -> Block:
    """d/dt (T + V) = 0, written out to the equation of motion."""
    by_terms = r"$\dot{x} (m \ddot{x} + k (x + \delta_{\mathrm{st}}) - m g) = 0$"
    return words(
        rf"[T|$T = \tfrac{{1}}{{2}} m \dot{{x}}^2 = {c.T}$ {WELL.unit}]",
        either(
            c.datum,
            equilibrium=rf"[V|$V = \tfrac{{1}}{{2}} k x^2 = {c.V}$ {WELL.unit}]",
            separate=rf"[V|$V = {c.spring}\; {c.gravity:+} = {c.V}$ {WELL.unit}]",
            slide=rf"[V|$V = {c.spring}\; {c.constant:+}\; {c.gravity:+} = {c.V}$]",
        ),
        f"$T + V = {WELL.text(c.E_total)}$ {WELL.unit}",
        r"$\dfrac{\mathrm{d}}{\mathrm{d} t} (T + V) =$",
        either(c.datum, equilibrium=r"$\dot{x} (m \ddot{x} + k x) = 0$", separate=by_terms, slide=by_terms),
        r"[boxed|$m \ddot{x} + k x = 0$]",
        "[small|Energy gives the equation for one degree of freedom.]",
        style="derivation", phone=8, name="law",
    )  # fmt: skip


NATURAL = X.in_frame(c, "natural", lambda c, t, x: max(-c.delta, x.end))
"""The natural length, or the end of the frame if it is beyond."""
NATURAL_SEEN = X.in_frame(c, "natural_seen", lambda c, t, x: -c.delta >= x.end)
NATURAL_FAR = X.in_frame(c, "natural_far", lambda c, t, x: -c.delta < x.end)


def _naming(case: EnergyShown, t: Axis, x: Axis) -> str:
    """Return the name of the labels of natural length and equilibrium: separate, too close for two names, or equal."""
    return "together" if not case.delta else "apart" if case.delta > 0.1 * (x.start - x.end) else "close"


def levels() -> list[Shape]:
    """Natural length and equilibrium, and delta_st between them."""
    natural, level, left = height(NATURAL), height(0), CENTRE - HALF - 6
    naming, deflection = X.in_frame(c, "naming", _naming), f"*δ*_{{st}} {c.delta_st}"
    look: Looks = {"anchor": "end", "tint": "mute", "style": "halo given"}

    def beside(*lines: str) -> list[Shape]:
        return [text(left, level - 10 + 15 * n, one, **look) for n, one in enumerate(lines)]

    return [
        line(left + 6, level, CENTRE + HALF, level, style="eq", tint="mute"),
        *shown_by(
            c.view == "motion",
            *shown_by(NATURAL_SEEN, line(left + 6, natural, CENTRE + HALF, natural, style="eq", tint="mute")),
            *shown_by(
                naming == "apart",
                *shown_by(
                    NATURAL_SEEN,
                    text(left, natural - 4, "natural", **look),
                    text(left, natural + 11, "length", **look),
                ),
                text(left, level + 5, "equilibrium", **look),
                arrow(CENTRE - ASIDE, natural, CENTRE - ASIDE, level, tint="k", head=9),
                text(CENTRE - ASIDE - 6, (natural + level) * 0.5 + 6, deflection, "end", style="b halo"),
            ),
            *shown_by(
                NATURAL_FAR, text(left, FIRST + 2, "natural", **look), text(left, FIRST + 17, "length ↑", **look)
            ),
            *shown_by(naming == "together", *beside("equilibrium", "= natural", "length")),
            *shown_by(naming == "close", *beside("equilibrium,", f"{c.delta_st} below", "natural length")),
        ),
    ]  # fmt: skip


def body() -> list[Shape]:
    """Ceiling, spring and mass; its end is the level line."""
    hook, side = height(c.x), wide(58, 40) * c.side
    hand = drag("Mass, start", along("y", lambda x: height(x) + 0.5 * side, X.up, x_0=c.x, rate="v_0"))
    return [
        wall(CENTRE - HALF, CEILING, 2 * HALF, side="top"),
        spring(CENTRE, CEILING, CENTRE, hook, c.wire, height=15),
        box(CENTRE, hook + side, side, "*m*", tint="m1", grab=hand),
        arrow(CENTRE + ASIDE, height(0), CENTRE + ASIDE, hook, tint="m1"),
        text(*NAME, f"*x* = {c.x:+} {X.unit}", "start", tint="m1", style="t2 b halo"),
    ]


def _planets(case: EnergyShown, t: Axis, x: Axis) -> list[Any]:
    """The positions of the mass on each planet in m; None if outside the frame or too close to another name."""
    taken, found = [0.0, -case.delta], list[Any]()
    for _, g in PLANETS.values():
        place = case.delta * (g / case.g - 1) if case.g else g * case.m / case.k
        is_free = min(abs(place - other) for other in taken) > 0.065 * (x.start - x.end)
        found.append(place if is_free and x.end <= place <= x.start else None)
        taken += (one for one in found[-1:] if one is not None)
    return found


def planets() -> list[Shape]:
    """The levels at which the mass would hang elsewhere."""
    x, places, found = CENTRE + HALF, X.in_frame(c, "planet", _planets), list[Shape]()
    for i, (slug, (name, _)) in enumerate(PLANETS.items()):
        y = height(places[i])
        found += [
            line(x, y, x + 8, y, style="floor"),
            text(x + 12, y + 4.5, name, "start", tint="mute", style="halo given"),
            *shown_by(
                c.here == slug,
                line(x, height(0), x + 8, height(0), style="floor"),
                text(x + 12, height(0) + wide(4.5, -7), name, "start", style="b halo given"),
            ),
        ]
    return found


def bar() -> list[Shape]:
    """The bar of V and T on top of it, under their constant sum. Next to a plot it has the scale of the energies
    against time."""
    top, bottom = wide(ENERGY.y(c.total), 0.36 * H), wide(ENERGY.y(0), H - 4)
    whole = bottom - top
    edge, right = bottom - whole * number(c.V_share), BAR + BROAD
    beside = right + wide(9, 5)
    total = f"*T* + *V* = {WELL.text(c.E_total)} {WELL.unit}"
    return [
        *shown_by(
            c.has_energy,
            rectangle(BAR, edge, BROAD, bottom - edge, style="body revealing", tint="V"),
            rectangle(BAR, top, BROAD, edge - top, style="body revealing", tint="T"),
            text(beside, top + 20, f"*T* = {c.T} {WELL.unit}", "start", tint="T", style="b halo"),
            text(beside, top + 36, "motion", "start", tint="T", style="halo"),
            text(beside, bottom - 20, f"*V* = {c.V} {WELL.unit}", "start", tint="V", style="b halo"),
            text(beside, bottom - 4, "position", "start", tint="V", style="halo"),
            line(BAR, ENERGY.y(c.V), ENERGY.x(T), ENERGY.y(c.V), style="level revealing", tint="V", show=ON_WIDE),
        ),
        rectangle(BAR, top, BROAD, whole, style="scaled outline", tint="ink"),
        line(BAR - 8, top, right + 8, top, style="sum", tint="ink"),
        text(BAR - 8, top - 9, total, "start", style="b halo"),
    ]


def ball() -> list[Shape]:
    """Shapes over the well: the level of T + V, continued to the plot against time, V and T at the mass, and the
    ball."""
    x, floor, V, level = WELL.x(c.x), WELL.y(0), WELL.y(c.V), WELL.y(c.total)
    middle, C, shift = WELL.x(0), WELL.across_pixels(c.C), WELL.y(c.shift)
    hand = drag("Ball, start", along("x", WELL.x, WELL.across, x_0=c.x, rate="v_0"))
    shifted = WELL.in_frame(c, "shifted", lambda c, x, E: c.shift > 0.1 * (E.end - E.start))
    return [
        *shown_by(c.has_energy, line(middle - C, level, middle + C, level, style="sum")),
        *shown_by(c.swinging, text(middle - C + 12, level - 8, "turns here", "start", tint="mute", style="halo")),
        rectangle(x - 4, V, 8, floor - V, style="body", tint="V"),
        rectangle(x - 4, level, 8, V - level, style="body", tint="T"),
        *shown_by(c.swinging, *(circle(middle + side * C, level, 4, tint="ink") for side in (-1, 1))),
        *shown_by(
            shifted,
            arrow(middle, floor, middle, shift, tint="ink", style="thin", head=9),
            text(
                middle, (floor + shift) * 0.5, f"½ *k δ*_{{st}}² = {WELL.text(c.shift)} {WELL.unit}", "beside",
                style="b halo",
            ),
        ),
        circle(x, V, 8, tint="m1", grab=hand),
    ]  # fmt: skip
