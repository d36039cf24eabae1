"""The paper of the forced masses: the chain, the response at every drive frequency, the motion, and its energy."""

from __future__ import annotations

from functools import cache
from typing import Any

from components import chain
from components.chain import BOTH
from components.chain.forces import Arrows, arrows
from components.chain.grabs import mass_grab
from components.language.blocks import Block
from components.language.expressions import var
from components.language.plots import Term
from components.layout.plots import Room, curve, plot, region
from components.layout.sheet import choice, column, desk, phrase, row, stage, term, when, words
from components.layout.stage import NARROW, WIDE, H, PlotFrame, Shape, W, arrow, circle, text
from components.layout.views import in_views
from components.quantities.parameters import one_of
from components.scene.traces import traced
from components.scenes.forced.bode import lag_plot, plane_plot
from components.scenes.forced.case import Axes, Work
from components.scenes.forced.case import Signals as S
from components.scenes.forced.numbers import Numbers as N
from components.scenes.forced.response import response_plot
from components.scenes.forced.words import FATE, LAGS, MOTION, SOLUTION, WORK
from components.scenes.forced.words import Forms as F

CURVE = one_of("size", {"size": "Size", "signed": "Signed", "log": "Log"}, "Response shown as")
SCALE = one_of("log", {"log": "Log", "size": "Linear"}, "Axes of the Bode plot")
ENERGY = PlotFrame("energy")
UNITS = one_of("si", {"si": "SI", "lecture": "Relative"}, "Units of the response")


@cache
def forced_sheet() -> Block:
    label = "Two masses and two springs, the first one driven by a force"
    return column(
        row(
            stage(*_shapes(), label=label, height=150),
            in_views(words(*SOLUTION, style="facts solution", basis=318, phone=13, name="solution"), "formulas"),
            in_views(desk(words(*LAGS, style="facts", basis=340, phone=15, name="lags")), "bode"),
            in_views(words(*WORK, style="facts", basis=340, phone=15, name="work"), "nyquist"),
            in_views(words(*MOTION, style="facts", basis=318, phone=15, name="forces"), "forces"),
            grow=200,
        ),
        column(
            in_views(response_plot(), "response", "bode"),
            in_views(lag_plot(), "bode"),
            in_views(plane_plot(), "nyquist"),
            *(in_views(_motion(i), "motion", "forces", "formulas") for i in BOTH),
            in_views(_energy(), "work"),
            in_views(words(FATE, style="numbers", phone=15, name="fate"), "motion"),
            in_views(desk(choice(SCALE)), "bode"),
            in_views(desk(_options()), "response"),
            grow=440,
        ),
    )


def _options() -> Block:
    return row(
        words("**Particular solution**"),
        choice(CURVE, basis=0),
        when(F.lecture, choice(UNITS, basis=0)),
        grow=0,
        basis=34,
        gap=10,
    )


def _shapes() -> list[Shape]:
    foot = 0.8 * H
    push, middle = chain.place(1), foot - (0.5 * WIDE + 0.86 * NARROW) * chain.side(1)  # over the name of a small block
    tip = push + var(Arrows.push) * W * var(S.drive)
    return [
        chain.standing_wall(0.2 * H, 0.62 * H),
        *chain.ground(foot),
        *(s for i in BOTH for s in chain.displacement_arrow(i, foot)),
        *chain.cups(foot, push, chain.place(2)),
        *chain.masses(foot, push, chain.place(2), corner=True, grabs=(mass_grab(1), mass_grab(2))),
        arrow(push, middle, tip, middle, tint="F", style="thick", head=18),
        circle(push, middle, 5, tint="F"),
        text(tip, foot - chain.side(1) - 8, "*F*", tint="F", style="t3 b halo"),
        *arrows(foot, above=20 + 14 * NARROW),  # over the name of F
    ]


def _motion(i: int) -> Block:
    """The plot of x_i(t) with its particular and complementary parts; near resonance with the growth of the resonant
    part instead.
    """
    x, x_p, x_c = S.x[i], S.x_p[i], S.x_c[i]
    traces = (
        traced(x_c, tint="xc", width="dash", read="complementary", signal=x_c),
        traced(x_p, tint="xp", read="particular", signal=x_p),
        traced(x, tint=f"m{i}", width="sum", label=f"*x*_{i}", signal=x),
    )
    limit: dict[str, Any] = {"source": "limit", "group": F.limit[i]}
    envelope = (
        curve(S.beat[i], tint="xp", label="resonant", **limit),
        curve(S.fall[i], tint="xp", **limit),
        curve(S.growth[i], tint="mute", width="dots", label="line", **limit),
    )
    return plot(
        PlotFrame(f"x{i}"),
        x=Axes.t,
        y=Axes.x,
        title=f"Displacement of mass {i} against time",
        curves=(*(curve for curve, _ in traces), *envelope),
        bands=tuple(band for _, band in traces),
        heading=_heading(i),
        x_labels=i == 2,
        cursor="time",
        room=Room(40, 58),
        phone=10 + i,
        height=112 if i == 1 else 142,
    )


def _heading(i: int) -> tuple[Term, ...]:
    """x_i as the sum of its parts; near resonance the growth of its amplitude."""
    particular = rf"{N.X[i]}\,\sin({N.omega}\,t"
    rest = r"+\; \text{complementary}"
    wave = {"words": r"\text{particular}", "formula": f"{particular})", "dies": rf"{particular}\,{N.lag[i]})"}
    grows = f"growing by {N.growth[i]} m/s"
    first = f"first {grows}"
    return (
        term(S.x[i], "sum", f"m{i}", formula=f"x_{i} ="),
        term(S.x_p[i], "line", "xp", form=F.x_p[i], **wave),
        term(S.x_c[i], "dash", "xc", form=F.x_c[i], words=rest, formula=rest, dies=r"+\; \text{transient}"),
        phrase(F.limit[i], "line", "xp", grows=f"resonant part, {grows}", beats=f"resonant part, a long beat, {first}"),
    )


def _energy() -> Block:
    return plot(
        ENERGY,
        x=Axes.t,
        y=Axes.E,
        title="Gain of kinetic and potential energy since the start, with the heat of dashpots where there are any, "
        "and the work of the drive: they are equal",
        bands=(
            region(Work.zero, Work.gain, tint="k2fill"),
            region(Work.gain, Work.work, tint="T", alpha=0.25, group="heat", read="heat"),
        ),
        curves=(curve(Work.work, tint="F", width="dash", label="work"),),
        heading=(
            term("", "band", "k2fill", formula=r"\text{gain of } T + V"),
            phrase("", "band", "T", form=F.rows, sign="", braked="+ heat"),
            term("", "dash", "F", formula=r"=\; \text{work of the drive}"),
        ),
        cursor="time",
        room=Room(40, 58),
        phone=13,
        height=240,
    )
