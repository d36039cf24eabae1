"""The sheet of the machine and its absorber: the stage, two response curves, and the motion from its start."""

from __future__ import annotations

from functools import cache

from components.language.blocks import Block
from components.language.plots import Handle
from components.layout.plots import Room, curve, mark, plot, region
from components.layout.sheet import column, desk, phrase, row, term, words
from components.layout.stage import PlotFrame
from components.layout.text import rich
from components.layout.views import in_views
from components.scenes.absorber.curves import STARTED, Axes, Sweep
from components.scenes.absorber.curves import Signals as S
from components.scenes.absorber.stage import (
    FREQUENCIES,
    STROKE,
    SWING,
    goals,
    picture,
    stroke_shapes,
    swing_shapes,
)
from components.scenes.absorber.words import FORMULAS, FROM_REST, HELPED
from components.scenes.absorber.words import Forms as F


@cache
def absorber_sheet() -> Block:
    return column(
        picture(),
        row(
            in_views(_swing_plot(), "goals", "stroke"),
            in_views(_stroke_plot(), "stroke"),
            in_views(goals(), "goals"),
            grow=300,
            gap=26,
        ),
        in_views(column(_rest_plot(), desk(words(FROM_REST, name="rest", phone=16)), grow=300), "rest"),
        in_views(words(*FORMULAS, name="formulas", grow=300, phone=10), "formulas"),
    )


def _rest_plot() -> Block:
    """The plot of x1 from its start and its two parts, with the same clock as the stage."""
    return plot(
        PlotFrame("rest"),
        x=Axes.t,
        y=Axes.rest,
        title="Displacement of the machine against time, from its start",
        curves=(
            curve(S.x1_c, source="rest", tint="xc", width="dash", label="*x*_c", read="complementary"),
            curve(S.x1_p, source="rest", tint="xp", label="*x*_p", read="particular"),
            curve(S.x[1], source="rest", tint="m1", width="sum", label="*x*_1", signal=S.x[STARTED]),
        ),
        heading=(
            term(S.x[1], "sum", "m1", formula=r"x_1 ="),
            term(S.x1_p, "line", "xp", formula=r"x_{\mathrm{p}}"),
            term(S.x1_c, "dash", "xc", formula=r"+\; x_{\mathrm{c}}"),
        ),
        cursor="time",
        room=Room(44, 26),
        phone=10,
        height=222,
    )


def _knob(beside: str = "") -> Handle:
    """The handle at the frequency to which the absorber is tuned; a second one is named after its plot."""
    label = "Frequency to which the absorber is tuned" + beside
    return Handle(parameter="_valley", symbol="tuned to", label=label, tint="m2", covering="rad/s")


def _swing_plot() -> Block:
    """The plot of the machine's swing with and without the absorber. Grey is the reduction of the swing."""
    return plot(
        SWING,
        x=Axes.w,
        y=Axes.X1,
        title="Swing of the machine against drive frequency, with the absorber and alone",
        x_column=Sweep.w,
        bands=(region(Sweep.helped_lo, Sweep.helped_hi, tint="k2fill", group=F.helped),),
        curves=(
            curve(Sweep.alone, tint="m1", width="dash", read="alone"),
            curve(Sweep.free, tint="m1", width="dots"),
            curve(Sweep.swing, tint="m1", width="sum", read="with absorber"),
        ),
        heading=(
            phrase(Sweep.swing, "sum", "m1", words=r"swing $|X_{\mathrm{p}1}|$ with absorber"),
            phrase(Sweep.alone, "dash", "m1", words="alone"),
            phrase(Sweep.free, "dots", "m1", undamped="undamped"),
            phrase(F.helped, "band", "k2fill", form=F.helped, **HELPED),
        ),
        room=Room(52, 8, top=42),
        handles=(_knob(),),
        marks=tuple(mark(at, tint=tint, html=rich(flag), lift=35, flag="one") for at, _, tint, flag in FREQUENCIES),
        shapes=swing_shapes(),
        phone=10,
        height=212,
    )


def _stroke_plot() -> Block:
    """The plot of the absorber's stroke |X2 - X1|, and the knob with which the visitor drags the minimum of the swing
    to the machine's speed."""
    return plot(
        STROKE,
        x=Axes.w,
        y=Axes.X2,
        title="Stroke of the absorber against drive frequency",
        x_column=Sweep.w,
        curves=(
            curve(Sweep.stroke, tint="m2", width="sum", read="stroke"),
            curve(Sweep.free2, tint="m2", width="dots", group=Sweep.free),
        ),
        heading=(phrase(Sweep.stroke, "sum", "m2", words=r"stroke $|X_{\mathrm{p}2} - X_{\mathrm{p}1}|$"),),
        room=Room(52, 8, top=42),
        marks=tuple(mark(at, tint=tint) for at, _, tint, _ in FREQUENCIES),
        handles=(_knob(", at its stroke"),),
        shapes=stroke_shapes(),
        phone=11,
        height=190,
    )
