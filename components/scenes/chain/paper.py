"""The paper of a chain: the masses over their picture against time, the modes, their spectrum, the formulas."""

from __future__ import annotations

from typing import Any, Literal

from components.language.blocks import Block
from components.language.expressions import Expression, Number, as_expression
from components.language.plots import Handle, Room
from components.language.shapes import Along, AnyShape, Begin, Grab
from components.layout.grabs import begin
from components.layout.sheet import column, modes, row, stage
from components.layout.stage import ON_WIDE, H, W, beads, circle, line, text, wall
from components.layout.views import in_views
from components.paper.deferred import Axes, computed, deferred, number
from components.paper.plot_axes import TIME, axis
from components.paper.plots import (
    Plot,
    PlotValue,
    along,
    curve,
    either,
    form_of,
    number_name,
    on_axis,
    shown_by,
    text_name,
    words,
)
from components.quantities.axes import Axis, nice_axis
from components.scenes.chain.case import MassesShown

c = deferred(MassesShown)
ROOM = Room(56, 34)
"""The margins of the frames. The stage has the same, so that each mass is above its column in the plot."""
REACH = 0.36
"""The drawn height of the largest displacement, as a share of the stage's height."""
Y = axis("m", lambda c: (-c.reach, c.reach), "y", room=1.0, count=2)
PLACE = axis("", lambda c: whole_numbers(c.left, c.left + c.parts), "place")
MODE = axis("", lambda c: whole_numbers(0.0, c.N + 0.5), "mode")
FIELD = Plot("field", PLACE, TIME)
SPECTRUM = Plot("spectrum", MODE, axis("rad/s", lambda c: (0.0, 1.6 * c.ceiling), "omega", count=4))
ENERGY = Plot("energy", MODE, axis("J", lambda c: (0.0, float(c.drawn.energy.max())), "E", room=1.08, count=3))
BY_MODE, BY_MASS, BY_PULSE = form_of(c.starts == "mode"), form_of(c.by_mass), form_of(c.starts == "pulse")
LEFT, LENGTH = float(ROOM.left), W - float(ROOM.left + ROOM.right)
HEIGHT = REACH * H * Y.share
ACROSS = HEIGHT * number(c.is_across)


def whole_numbers(first: float, last: float) -> Axis:
    """An axis with whole numbers only."""
    return nice_axis(first, last, "", min(6, max(int(last - first), 1)), exact=True)


def paper() -> Block:
    label = "A chain of equal masses on springs, which moves"
    return column(
        row(stage(*shapes(), label=label, height=118, widest=20), grow=150),
        in_views(field(), "wave"),
        in_views(shapes_of_modes(), "modes"),
        in_views(energies(), "modes"),
        in_views(spectrum(), "spectrum"),
        in_views(formulas(), "formulas"),
    )  # fmt: skip


def shapes_of_modes() -> Block:
    return modes("j", "Modes, each a start", of="x", chosen=text_name(c.chosen), sets={"starts": "mode"}, phone=9)


def rest(place: Expression) -> Expression:
    """Return the pixel of a place along the chain, counted in spacings from its left end."""
    return LEFT + LENGTH * place * number(c.per_part)


def along_unit() -> Expression:
    return number(computed(c, "along_unit", _along))


def _along(case: MassesShown, axes: Axes) -> float:
    """The length of one unit of displacement, as a share of the chain's length; 0 for a transverse motion."""
    y = axes[Y.name]
    return (case.scale or 0.0) * y.factor * 10.0**y.exponent / case.length if case.way == "along" else 0.0


def shapes() -> list[AnyShape]:
    middle, half = 0.5 * H, REACH * H
    at = rest(number(c.first) - 1 + number(c.mass))
    moved = as_expression(on_axis(Y, c.x)) - on_axis(Y, c.drift)
    up, beside = ACROSS * moved, LENGTH * along_unit() * moved
    chain = beads(
        of="x", count=c.N, x=LEFT, y=middle, length=LENGTH, first=c.first, parts=c.parts, across=ACROSS,
        along=LENGTH * along_unit(), left=c.left_wall, right=c.right_wall, least=on_axis(Y, c.least), at="mass",
        picks=c.picks, drift=on_axis(Y, c.drift), held=True,
    )  # fmt: skip
    ends = LEFT, LEFT + LENGTH
    return [
        line(ends[0], middle, ends[1], middle, tint="mute", style="eq"),
        *shown_by(c.left_wall, wall(ends[0], middle - half, 2 * half)),
        *shown_by(c.right_wall, wall(ends[1], middle - half, 2 * half, "right")),
        chain,
        *shown_by(c.graspable, *shown_by(c.is_across, circle(at, middle - up, 0, grab=hand("y", middle)))),
        *shown_by(c.graspable, *shown_by(c.way == "along", circle(at + beside, middle, 0, grab=hand("x", at)))),
        *shown_by(c.starts == "pulse", *pulse(middle)),
        *shown_by(c.picks, text(ends[1], 14, f"mass {c.name}: {c.x:+} {Y.unit_text}", "end", style="t1 halo")),
    ]


def hand(axis: Literal["x", "y"], zero: Number) -> Grab:
    """Return the grab of the mass at the pointer: along the chain (x) or across it (y)."""

    def place(h: PlotValue) -> Number:
        moved = number(c.grip) * on_axis(Y, h)
        if axis == "y":
            return as_expression(zero) - ACROSS * moved
        return as_expression(zero) + LENGTH * along_unit() * moved

    way = along(axis, place, Y, rate="v_0", h=c.h)
    mass, seen = Begin("p", number_name(c.mass), exactly=True), Begin("h", number_name(c.h_now, Y), Y.name)
    label = "Mass, start" if axis == "y" else "Mass, start, along the chain"
    return begin(label, way, start=(mass, seen, Begin("v_0")))


def pulse(middle: Number) -> tuple[AnyShape, ...]:
    """The crest of the initial pulse. Dragging it along the chain sets its position; dragging it up and down sets its
    height."""
    per_metre = LENGTH * number(c.per_length)
    aside = Along(
        across="x", zero=LEFT, unit=per_metre, parameter="centre", moves=number_name(c.centre), least=0.0,
    )  # fmt: skip
    up = along("y", lambda h: as_expression(middle) - HEIGHT * on_axis(Y, h), Y, h=c.h)
    x, y = LEFT + per_metre * number(c.centre), as_expression(middle) - HEIGHT * on_axis(Y, c.h)
    ring = circle(x, y, 7, style="ring", grab=begin("Pulse, start", aside, up))
    return ring, text(x + 12, y + 5, "start", "start", tint="mute", style="t1 halo")


def field() -> Block:
    look: dict[str, Any] = {"read": "crest of the string", "group": "crest"}
    string = f"crest on a string, speed *c* = {c.wave_speed} m/s, length *L*"
    return FIELD.block(
        curve(c.crest, "dash", "ink", words=string, columns=("crest_x", "crest_t"), **look),
        curve(c.other, "dash", "ink", columns=("other_x", "other_t"), **look),
        over=[
            text(FIELD.right + 5, FIELD.y(lap) + 5, f"{n}*L*/*c*", "start", tint="mute", show=ON_WIDE)
            for n, lap in (("", c.lap_1), ("2", c.lap_2), ("3", c.lap_3))
        ],
        title="Displacement of each mass against time, which runs downwards: blue one way, orange the other",
        room=ROOM, grow=330, phone=10, height=330, modal="x", full=number_name(c.full, Y),
    )  # fmt: skip


def pressed() -> tuple[Handle, ...]:
    """The handles of the plots against the mode number: a press starts a mode, and a handle changes its number."""
    look: dict[str, Any] = {
        "parameter": "j",
        "label": "Mode that moves alone",
        "symbol": "mode",
        "tint": "slow",
        "whole": True,
    }
    return Handle(**look, form=BY_MODE.name), Handle(**look, bare=True)


def energies() -> Block:
    legend = f"energy of each mode, in all {c.E} J"
    return ENERGY.block(
        curve(c.bars, "none", "slow", words=legend, fill=1.0, columns=("bar_j", "bar")),
        title="Energy of each mode: it never changes",
        handles=pressed(), room=ROOM, grow=220, phone=10, height=200,
    )  # fmt: skip


def spectrum() -> Block:
    chain, taking, silent = ("law_j", "law"), ("taking_j", "taking_omega"), ("silent_j", "silent_omega")
    return SPECTRUM.block(
        curve(c.taking, "none", "slow", "disc", read="modes that take part", group="taking", columns=taking),
        curve(c.silent, "none", "slow", "ring", read="silent modes", group="silent", columns=silent),
        curve(c.law, "thin", words=f"chain: up to {c.fastest} rad/s", read="chain", group="law", columns=chain),
        curve(c.law, "dash", "mute", words="ideal string", label="string", group="string", columns=("law_j", "string")),
        title="Frequency of each mode against its number, with that of an ideal string",
        handles=pressed(), room=Room(56, 56), grow=330, phone=10, height=300,
    )  # fmt: skip


def formulas() -> Block:
    theta = either(
        c.ends,
        **{
            "fixed-fixed": rf"$\theta_j = \dfrac{{j \pi}}{{N + 1}} = {c.per_mode}\, j$",
            "fixed-free": rf"$\theta_j = \dfrac{{(2 j - 1) \pi}}{{2 N + 1}} = {c.per_mode}\, (j - 1/2)$",
            "free-free": rf"$\theta_j = \dfrac{{(j - 1) \pi}}{{N}} = {c.per_mode}\, (j - 1)$",
        },
    )
    return words(
        "**Each mass is pulled by its two springs**",
        r"$m\, \ddot{x}_p = k\, (x_{p-1} - 2 x_p + x_{p+1})$",
        "**Each mode is one sine**",
        theta,
        rf"$\omega_j = 2 \sqrt{{k/m}}\, \sin(\theta_j / 2) = {c.ceiling}\, \sin(\theta_j / 2)$",
        f"From {c.slowest} to {c.fastest} rad/s: no mode reaches $2 \\sqrt{{k/m}}$.",
        "**An ideal string has a straight line**",
        rf"$\omega_j = \sqrt{{k/m}}\, \theta_j$: from {c.string_slowest} to {c.string_fastest} rad/s",
        f"Mode {c.N_text} of the chain is {c.lag} % slower.",
        rf"$c = a \sqrt{{k/m}} = {c.wave_speed}$ m/s, $L = {c.L}$ m: from end to end in {c.traverse} s",
        style="facts", grow=330, phone=10, name="formulas",
    )  # fmt: skip
