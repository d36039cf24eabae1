"""The sheet of the oscillator: the arrow, the rows x, v, a, and beside them the two planes."""

from __future__ import annotations

from functools import cache
from typing import Any

from components.language.blocks import Block
from components.layout.plots import HEADING, NUMBERS, Room, curve, plot
from components.layout.sheet import column, desk, either, phrase, row, stage, term, when, words
from components.layout.stage import PlotFrame, Shape
from components.quantities.declared import DrawnAxis, Signal
from components.scene.traces import traced
from components.scenes.oscillator.curves import OF_ROWS, ROWS, Axes, Pulled
from components.scenes.oscillator.curves import Signals as S
from components.scenes.oscillator.numbers import Forms as F
from components.scenes.oscillator.numbers import Numbers as N
from components.scenes.oscillator.turning import FIRST, FRAMES, LAW, LOOKS, PLANE, first, hero, lead, planes

GAP = 16
TASK = "Push the mass and let go: where is it fastest, and where is it pulled hardest?"

WATCH = {
    "Pulled": "Let go at rest, x starts at its peak; each peak of v is a quarter period before one of x.",
    "Kicked": "It starts from the middle: all of its amplitude comes from v₀.",
    "Pushed back": "It starts away from the middle and moves towards it: the arrow starts where x₀ and v₀ put it.",
    "Heavy": "Four times the mass of the others: it swings half as fast.",
    "Stiff": "About four times the stiffness of the others: it swings about twice as fast.",
    "Rest": "With x₀ = 0 and v₀ = 0 there is no arrow to turn.",
    "No spring": "Nothing pulls it back: it moves on at constant speed.",
}
"""A sentence for each preset on what to watch."""

CONSTANTS = (
    (f"[m1|$A = x_0 = {N.A}$ m]", either(F.C, turn=rf"[m1|$C = \sqrt{{A^2 + B^2}} = {N.C}$ m]")),
    (
        either(F.B, turn=rf"[T|$B = v_0 / \omega_n = {N.B}$ m]", drift=f"[T|$v_0 = {N.v_0}$ m/s]"),
        either(F.phi, turn=rf"$\phi = \mathrm{{atan2}}(A, B) = {N.phi}$ rad"),
    ),
)


IDEA = (
    either(
        F.why,
        **dict.fromkeys(
            ("right", "wrong", "zero"),
            "The tip of the turning arrow is as high as [m1|$x$]. An arrow a quarter turn ahead is as high as "
            r"[T|$v/\omega_n$], one half a turn ahead as [F|$a/\omega_n^2$].",
        ),
        rest="The mass rests: nothing moves, and there is no arrow.",
        drift="No spring, no swing: the mass keeps its velocity.",
        still="No spring, and a start at rest: nothing moves.",
    ),
)
"""In place of the formulas: the scene's idea in words."""


@cache
def oscillator_sheet() -> Block:
    over_plane, over_law = planes()
    label = "Mass on a spring, and the turning arrow whose height is its displacement"
    start = stage(*first(), label="The arrow at the start with its legs A and B", phone=30, height=190, style="still")
    paper = row(
        column(
            stage(*hero(), label=label, grow=300, height=206),
            when(F.idea, words(*IDEA, style="facts", grow=176, phone=30)),
            when(F.formulas, row(_why(), start, grow=176, gap=GAP)),
            when(
                F.formulas,
                row(
                    words(*CONSTANTS[0], style="constants", phone=32),
                    words(*CONSTANTS[1], style="constants", phone=32),
                    grow=0,
                    basis=54,
                    gap=10,
                ),
            ),
            grow=344,
        ),
        column(*map(_row, range(3)), grow=400),
        when(F.formulas, column(_law_words(), _plane(over_plane), _law(over_law), grow=168)),
        gap=0,
    )
    return column(desk(words(TASK, style="task", phone=0)), paper)


def _why() -> Block:
    """Why the phase is atan2: what the slide's atan would give for this start."""
    return words(
        either(
            F.why,
            right=r"**At** $t = 0$: $\mathrm{atan}(A / B)$ gives the right angle here: it is right for $v_0 > 0$, "
            r"$\mathrm{atan2}$ always.",
            wrong=rf"**At** $t = 0$: $\mathrm{{atan}}(A / B) = {N.atan}$ points the other way: "
            r"it is right only for $v_0 > 0.$",
            zero=r"**At** $t = 0$: $\mathrm{atan}(A / B)$ would divide by zero: it is right only for $v_0 > 0.$",
            rest="The mass rests: nothing moves, there is no arrow, and no phase.",
            drift="No spring, no swing: the mass keeps its velocity.",
            still="No spring, and a start at rest: nothing moves.",
        ),
        style="small",
        basis=FIRST - GAP,
        phone=31,
    )


def _row(i: int) -> Block:
    """x, v or a against time, under its formula."""
    one, (_, tint, *_) = ROWS[i], LOOKS[i]
    curve, band = traced(one, tint=tint, width="sum", read=f"*{one.name}*", signal=one)
    drift = (rf"{N.A}\, {N.drift}\,t", rf"{N.v_0} \text{{: constant}}", r"0 \text{: no force}")[i]
    top, ahead = (N.top_x, N.top_v, N.top_a)[i], ("", r"+ \tfrac{\pi}{2}", r"+ \pi")[i]
    sine = rf"{top}\, \sin({N.omega}\,t\, {N.phi_plus} {ahead})"
    heading = [
        term(one, "sum", tint, formula=f"{one.name} ="),
        term("", "none", tint, form=F.kind, turn=sine, drift=drift),
    ]
    if one is S.x:
        parts = rf"= {N.A_plain}\, \cos({N.omega}\,t)\, {N.B_plus}\, \sin({N.omega}\,t)"
        heading.append(term("", "none", "ink", form=F.parts, shown=parts, left_out=""))
    return plot(
        FRAMES[i],
        x=Axes.t,
        y=OF_ROWS[i],
        title=("Displacement", "Velocity", "Acceleration")[i] + " against time",
        curves=(curve,),
        bands=(band,),
        heading=tuple(heading),
        x_labels=one is S.a,
        room=Room(62, 30),
        cursor="time",
        shapes=lead(i - 1) if i else (),
        grow=(212, 153, 102)[i],
        phone=10 + i,
        height=(150, 156, 166)[i],
    )


def _law_words() -> Block:
    return words(
        either(F.force, shown=rf"[F|$F = -k x =$ {Pulled.F} {N.F_unit}]"),
        either(F.kind, turn=r"$m \ddot{x} + k x = 0$ with $k > 0$", drift=r"$m \ddot{x} = 0$ as $k = 0$"),
        r"$\ddot{x} + \omega_n^2 x = 0$",
        either(
            F.kind,
            turn=r"[small|$x = C \sin(\omega t + \phi)$ put in: "
            r"$(\omega_n^2 - \omega^2) x = 0$, so $\omega = \omega_n$]",
            drift="",
        ),
        rf"$\omega_n = \sqrt{{\frac{{k}}{{m}}}} = {N.omega}$ rad/s",
        either(F.kind, turn=rf"$\tau = 2 \pi / \omega_n = {N.tau}$ s", drift="no period"),
        style="facts proof",
        grow=212,
        basis=HEADING,
        phone=42,
    )


def _plane(over: tuple[Shape, ...]) -> Block:
    title, look = "Phase plane: velocity against displacement", {"plain": True, "grow": 153, "phone": 40, "height": 190}
    return _over_x(PLANE, Axes.v, S.v, title, "**Phase plane**", shapes=over, room=Room(8, 8), **look)


def _law(over: tuple[Shape, ...]) -> Block:
    """Newton's law with Hooke's: a straight line of slope -omega_n^2."""
    title = "The law: acceleration against displacement is a straight line"
    look = {"x_labels": False, "room": Room(8, 8, bottom=NUMBERS), "grow": 102, "phone": 41, "height": 160}
    return _over_x(LAW, Axes.a_bare, S.a, title, rf"**The law:** $a = -{N.ratio}\,x$", shapes=over, **look)


def _over_x(frame: PlotFrame, axis: DrawnAxis, row: Signal[Any], title: str, heading: str, **details: Any) -> Block:
    """A plot of v or a against x, for one turn."""
    line = curve(row, source="loop", x=S.x, tint="ink", signal_x=S.x, signal=row, group=frame.name)
    head = phrase("", "none", "ink", formula=heading)
    return plot(frame, x=Axes.x, y=axis, title=title, curves=(line,), heading=(head,), x_column=S.x, **details)
