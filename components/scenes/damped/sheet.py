"""The sheet of the damped mass: the block beside x(t), energy and power under it, and the plane of the roots."""

from __future__ import annotations

from functools import cache

from components.language.blocks import Block
from components.layout.plots import Room, curve, plot, region
from components.layout.sheet import column, desk, phrase, row, stage, term, when, words
from components.layout.stage import Looks
from components.scene.traces import traced
from components.scenes.damped.curves import Axes, Locus
from components.scenes.damped.curves import Signals as S
from components.scenes.damped.numbers import Numbers as N
from components.scenes.damped.stage import ENERGY, POWER, ROOTS, X, block, over_energy, over_power, roots, stairs
from components.scenes.damped.words import FACTS, FORMULAS, NATURAL, SENTENCE, TASK
from components.scenes.damped.words import Forms as F

SIDES = Room(56, 30)


@cache
def damped_sheet() -> Block:
    label = "Mass on a spring and a dashpot, which stand on a wall"
    paper = row(
        stage(*block(), label=label, grow=150, height=232),
        column(_displacement(), desk(when(F.power, _power())), _energy(), grow=470),
        column(
            _plane(),
            words(FACTS[0], style="facts", phone=31),
            desk(words(NATURAL, style="facts", phone=32)),
            words(*FACTS[1:], style="facts", phone=33),
            desk(words(SENTENCE, style="small", phone=34)),
            grow=272,
        ),
        gap=6,
    )
    return column(desk(words(TASK, style="task", phone=0)), paper)


def _displacement() -> Block:
    line, band = traced(S.x, tint="m1", width="sum", label="*x*", signal=S.x)
    envelope: Looks = {"tint": "m1", "width": "thin", "group": "upper"}
    return plot(
        X,
        x=Axes.t,
        y=Axes.x,
        title="Displacement against time",
        curves=(
            curve(S.upper, read="envelope", **envelope),
            curve(S.lower, **envelope),
            curve(S.slow, tint="m1", width="thin", read="slow part"),
            curve(S.fast, tint="m1", width="dash", read="fast part"),
            line,
        ),
        bands=(band,),
        heading=(
            term(
                S.x, "sum", "m1", form=F.x,
                under=rf"x = {N.C}\, e^{{-{N.a}\,t}} \sin({N.omega_d}\,t\, {N.phi})",
                plain=rf"x = {N.C}\, \sin({N.omega}\,t\, {N.phi})",
                critical=rf"x = ({N.A}\, {N.B}\,t)\, e^{{-{N.a}\,t}}",
                parts="x =",
                sum=rf"x = {N.A}\, e^{{{N.slow}\,t}}\, {N.B}\, e^{{{N.fast}\,t}}",
                rest="x = 0",
                glide=rf"x = {N.x_0}\, {N.v_0}\, \frac{{1 - e^{{-{N.rate}\,t}}}}{{{N.rate}}}",
                drift=rf"x = {N.x_0}\, {N.v_0}\,t",
            ),
            term(S.upper, "line", "m1", form=F.upper, formula=rf"\pm {N.C}\, e^{{-{N.a}\,t}}"),
            term(S.slow, "line", "m1", form=F.slow, formula=rf"{N.A}\, e^{{{N.slow}\,t}}"),
            term(S.fast, "dash", "m1", form=F.fast, formula=rf"{N.B}\, e^{{{N.fast}\,t}}"),
        ),
        x_labels=False,
        room=SIDES,
        cursor="time",
        shapes=stairs(),
        grow=184,
        phone=10,
        height=190,
    )  # fmt: skip


def _energy() -> Block:
    return plot(
        ENERGY,
        x=Axes.t,
        y=Axes.E,
        title="Energy against time: potential, kinetic, and what has become heat in the dashpot; the sum is constant",
        curves=(curve(S.E_0, tint="total", width="sum", group="total"),),
        bands=(
            region(S.zero, S.V, tint="V", group=S.V, read="*V*"),
            region(S.V, S.E, tint="T", group=S.T, read="*T*"),
            region(S.E, S.E_0, tint="k2fill", group=S.heat, read="heat"),
        ),
        heading=(
            term("total", "sum", "total", formula=rf"E_0 = {N.E_total}"),
            phrase("", "none", "total", formula=f"{N.E_unit} ="),
            term(S.V, "band", "V", formula=rf"V\, {S.V}"),
            term(S.T, "band", "T", formula=rf"+\; T\, {S.T}"),
            phrase(S.heat, "band", "k2fill", form=F.heat, formula=f"+ heat {S.heat}"),
        ),
        room=SIDES,
        cursor="time",
        shapes=over_energy(),
        grow=160,
        phone=12,
        height=170,
    )


def _power() -> Block:
    return plot(
        POWER,
        x=Axes.t,
        y=Axes.P,
        title="Power that the dashpot takes, against time",
        curves=(curve(S.P, tint="T", width="line", signal=S.P),),
        bands=(region(S.zero, S.P, tint="T", alpha=0.25, group=S.P),),
        heading=(
            term(S.P, "line", "T", formula=rf"P = c v^2 = {S.P}"),
            phrase("", "none", "T", formula=f"{N.P_unit}"),
            phrase(
                "", "none", "mute", form=F.fastest,
                before="greatest before *x* = 0", fastest="greatest where the mass is fastest",
                at_start="greatest at the start",
            ),
        ),
        x_labels=False,
        room=SIDES,
        cursor="time",
        shapes=over_power(),
        grow=82,
        phone=11,
        height=130,
    )  # fmt: skip


def _plane() -> Block:
    return plot(
        ROOTS,
        x=Axes.re,
        y=Axes.im,
        title="Plane of the roots: to the left a motion dies faster, upwards it swings faster",
        curves=(curve(Locus.im, x=Locus.re, tint="ink", width="thin", group="locus", read="other *ζ*"),),
        heading=(term("", "none", "ink", form=F.roots, **FORMULAS),),
        x_column=Locus.re,
        room=Room(2, 2),
        square=True,
        plain=True,
        shapes=roots(),
        grow=250,
        phone=30,
        height=300,
    )
