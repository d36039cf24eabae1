"""The sheet of the driven mass: the block beside x(t) and the powers; under them response and phase, and the forces."""

from __future__ import annotations

from functools import cache

from components.language.blocks import Block
from components.language.plots import Curve, Region
from components.layout.plots import Room, curve, plot
from components.layout.sheet import choice, column, desk, phrase, row, stage, term, when, words
from components.quantities.parameters import one_of
from components.scene.traces import band as band_of
from components.scene.traces import traced
from components.scenes.driven.curves import LATE, POWER, RINGING, Axes, X
from components.scenes.driven.curves import Signals as S
from components.scenes.driven.numbers import Numbers as N
from components.scenes.driven.polygon import polygon
from components.scenes.driven.power import Power
from components.scenes.driven.response import phase_plot, response_plot
from components.scenes.driven.stage import block
from components.scenes.driven.words import FACTS, SENTENCE, TASK, WORK
from components.scenes.driven.words import Forms as F

KIND = one_of("force", {"force": "Force", "base": "Shaken base", "unbalance": "Unbalance"}, "The drive")
SIDES = Room(48, 26)


@cache
def driven_sheet() -> Block:
    label = "Mass on a spring and a dashpot, and what drives it"
    return column(
        desk(words(TASK, style="task", phone=0)),
        row(
            stage(*block(), label=label, grow=150, height=210),
            column(_displacement(), desk(when(F.power, _power())), grow=460),
            column(
                choice(KIND, basis=36, phone=2),
                words(*FACTS, style="facts", phone=13),
                desk(words(WORK, style="facts", phone=14)),
                words(SENTENCE, style="facts", phone=2),
                grow=290,
            ),
            grow=250,
            gap=6,
        ),
        row(column(response_plot(), phase_plot(), grow=620), polygon(), grow=290, gap=6),
    )


def _motions() -> tuple[tuple[Curve, ...], tuple[Region, ...]]:
    """The curves of x(t), and the bands of those that are too fast for a line, always or at first."""
    line, band = traced(S.x, tint="m1", width="sum", label="*x*", signal=S.x)
    dying, dying_band = traced(S.x_c, tint="xc", width="dash", read="complementary", signal=S.x_c)
    steady, steady_band = traced(S.x_p, tint="xp", read="steady", signal=S.x_p)
    base, base_band = traced(S.y, tint="xp", read="base", signal=S.y)
    early = (
        band_of(one, RINGING, tint=tint, group=one.name, of=one.name) for one, tint in ((S.x_c, "xc"), (S.x, "m1"))
    )
    curves = (
        dying,
        curve(S.x_c, source=LATE, tint="xc", width="dash", read="complementary"),
        steady,
        base,
        curve(S.upper, tint="m1", width="thin", read="envelope"),
        curve(S.lower, tint="m1", width="thin", group=S.upper),
        line,
        curve(S.x, source=LATE, tint="m1", width="sum", read="x"),
    )
    return curves, (base_band, steady_band, dying_band, band, *early)


def _displacement() -> Block:
    curves, bands = _motions()
    return plot(
        X,
        x=Axes.t,
        y=Axes.x,
        title="Displacement against time",
        curves=curves,
        bands=bands,
        heading=(
            term(S.x, "sum", "m1", formula="x(t)"),
            phrase(
                S.x_p, "line", "xp", form=F.x_p,
                dies=rf"steady $X \sin(\omega\,t\, {N.phi_minus})$",
                stays=rf"particular $X \sin(\omega\,t\, {N.phi_minus})$",
            ),
            term(S.y, "line", "xp", form=F.y, formula=rf"y = {N.Y} \sin({N.omega}\,t)"),
            phrase(
                S.x_c, "dash", "xc", form=F.x_c,
                dies=rf"dying $e^{{-{N.decay}\,t}}$", stays="other part, which stays",
            ),
            phrase(
                S.upper, "line", "m1", form=F.upper,
                always=rf"growth $\pm {N.rate}\, t$", first=rf"growth at first $\pm {N.rate}\, t$",
            ),
        ),
        room=SIDES,
        cursor="time",
        grow=150,
        phone=15,
        height=170,
    )  # fmt: skip


def _power() -> Block:
    return plot(
        POWER,
        x=Axes.t,
        y=Axes.P,
        title="Power put in by the drive and power lost in the dashpot, each the mean of the last swing of the drive",
        curves=(
            curve(Power.P_lost, tint="T", width="sum", read="lost"),
            curve(Power.P_in, tint="F", read="put in"),
        ),
        heading=(
            phrase(Power.P_in, "line", "F", formula=f"power in {N.P_in} W"),
            phrase(Power.P_lost, "sum", "T", formula=f"lost {N.P_lost} W"),
            phrase("", "none", "mute", formula="mean of a swing, at the end"),
        ),
        x_labels=False,
        room=SIDES,
        cursor="time",
        grow=56,
        phone=16,
        height=110,
    )
