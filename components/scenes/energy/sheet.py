"""The sheet of the hanging mass: rows share x and energy, the right column of plots the time."""

from __future__ import annotations

from functools import cache

from components.language.blocks import Block
from components.language.plots import Term
from components.layout.plots import Room, curve, plot
from components.layout.sheet import column, desk, either, phrase, row, stage, term, words
from components.scene.traces import traced
from components.scenes.energy.case import Axes
from components.scenes.energy.curves import ENERGY, WELL, Well, X
from components.scenes.energy.curves import Signals as S
from components.scenes.energy.hanging import natural_length, shapes, well
from components.scenes.energy.numbers import Forms as F
from components.scenes.energy.numbers import Numbers as N

UPPER, LOWER, BETWEEN, ABOVE = 300, 190, 44, 78
"""Shares of the height, pixels between the rows, and the share over x(t) where the spring hangs."""
TASK = "Pull the mass down and let go: where is all the energy kinetic, and where none of it?"


@cache
def hanging_sheet() -> Block:
    label = "Mass on a spring, its natural length and its equilibrium, and its energy as a bar"
    between = _between()
    paper = row(
        column(stage(*shapes(), label=label, grow=UPPER, basis=BETWEEN, height=230), _well(), grow=330),
        column(words(style="room", grow=ABOVE), _displacement(), between, _energies(), grow=390),
        column(_gravity(), _law(), grow=190),
        gap=0,
    )
    return column(desk(words(TASK, style="task", phone=0)), paper)


def _displacement() -> Block:
    curve, band = traced(S.x, tint="m1", width="sum", label="*x*", signal=S.x)
    return plot(
        X,
        x=Axes.t,
        y=Axes.x,
        title="Displacement from equilibrium, downwards, against time",
        curves=(curve,),
        bands=(band,),
        x_labels=False,
        room=Room(58, 56),
        cursor="time",
        shapes=natural_length(),
        grow=UPPER - ABOVE,
        phone=10,
        height=150,
    )


def _between() -> Block:
    """The words between the plots, on the datum of V."""
    return words(
        either(
            F.claim,
            equilibrium=rf"$T_{{\mathrm{{max}}}} = V_{{\mathrm{{max}}}} = {N.T_max}$ {N.E_unit}: all $T$ "
            rf"at equilibrium, where $v = \omega_n x_{{\mathrm{{max}}}} = {N.v_max}$ m/s; all $V$ where it turns.",
            separate=r"$V_{\mathrm{max}} = T_{\mathrm{max}} + \tfrac{1}{2} k \delta_{\mathrm{st}}^2 "
            f"= {N.T_max} + $ {N.shift}: a constant more; the motion does not change.",
            weightless="Without weight both ways of counting $V$ are one: "
            rf"$V_{{\mathrm{{max}}}} = T_{{\mathrm{{max}}}} = {N.T_max}$ {N.E_unit}.",
            rest="Nothing moves: it rests in equilibrium, where $T$ and $V$ stay 0.",
            rest_apart=f"Nothing moves: it rests in equilibrium, $T$ stays 0 and $V$ stays {N.shift}.",
            slide=r"Three terms, and because $k \delta_{\mathrm{st}} = m g$ their sum is $\tfrac{1}{2} k x^2$: "
            "gravity drops out of the motion.",
        ),
        style="small",
        basis=BETWEEN,
        phone=12,
    )


def _energies() -> Block:
    parts = [
        traced(S.spring, tint="k", width="line", label="spring"),
        traced(S.gravity, tint="k", width="dash", label="gravity"),
        traced(S.V, tint="V", read="*V*", signal=S.V),
        traced(S.T, tint="T", width="dash", read="*T*", signal=S.T),
    ]
    curves, bands = zip(*parts, strict=True)
    constant = curve(S.constant, tint="k", width="dots", label="const.", signal=S.constant)
    total = curve(S.total, tint="total", width="sum", read="*T*+*V*", signal=S.total)
    return plot(
        ENERGY,
        x=Axes.t,
        y=Axes.E_time,
        title="Kinetic energy, potential energy and their constant sum against time",
        curves=(total, constant, *curves),
        bands=bands,
        heading=_energy_terms(),
        room=Room(58, 56),
        cursor="time",
        grow=LOWER,
        phone=13,
        height=230,
    )


def _energy_terms() -> tuple[Term, ...]:
    twice = rf"at $2 \omega_n = {N.omega_2}$ rad/s"
    return (
        term(S.total, "sum", "total", formula="T + V"),
        term(S.V, "line", "V", formula="V"),
        term(S.T, "dash", "T", formula="T"),
        phrase(S.spring, "line", "k", form=F.datum, equilibrium="", separate="spring", slide="spring"),
        phrase(S.gravity, "dash", "k", form=F.datum, equilibrium="", separate="gravity", slide="gravity"),
        phrase("", "none", "mute", form=F.datum, equilibrium=twice, separate="", slide=""),
    )


def _well() -> Block:
    return plot(
        WELL,
        x=Axes.x_well,
        y=Axes.E,
        title="The potential well: V against displacement, with the level of the energy and the turning points",
        curves=(
            curve(Well.spring, tint="k", read="spring"),
            curve(Well.gravity, tint="k", width="dash", read="gravity"),
            curve(Well.constant, tint="k", width="dots", read="constant"),
            curve(Well.other, tint="V", width="dash"),
            curve(Well.V, tint="V", width="sum", group="well", read="*V*"),
        ),
        heading=(
            term(
                "well", "sum", "V", form=F.datum, equilibrium=r"V = \tfrac{1}{2} k x^2",
                separate=r"V = \tfrac{1}{2} k (x + \delta_{\mathrm{st}})^2 - m g x",
                slide=r"V = \tfrac{1}{2} k (x + \delta_{\mathrm{st}})^2 "
                r"- \tfrac{1}{2} k \delta_{\mathrm{st}}^2 - m g x",
            ),
            phrase(Well.other, "dash", "V", form=F.datum, equilibrium="", separate="the slide's", slide=""),
        ),
        x_column=Well.x,
        room=Room(58, 40),
        shapes=well(),
        grow=LOWER,
        phone=20,
        height=250,
    )  # fmt: skip


def _gravity() -> Block:
    return words(
        rf"$\delta_{{\mathrm{{st}}}} = \frac{{m g}}{{k}} = {N.delta}$ m",
        rf"$\omega_n = \sqrt{{\frac{{k}}{{m}}}} = {N.omega}$ rad/s",
        either(F.place, said="[small|Gravity sets where it hangs, not how fast it swings.]"),
        rf"$\tau = 2 \pi / \omega_n = {N.tau}$ s",
        style="proof",
        grow=UPPER,
        basis=BETWEEN,
        phone=40,
    )


def _law() -> Block:
    """d/dt (T + V) = 0, written out to the equation of motion."""
    return words(
        rf"[T|$T = \tfrac{{1}}{{2}} m \dot{{x}}^2 = {S.T}$ {N.E_unit}]",
        either(
            F.datum,
            equilibrium=rf"[V|$V = \tfrac{{1}}{{2}} k x^2 = {S.V}$ {N.E_unit}]",
            separate=rf"[V|$V = {S.spring}\; {S.gravity} = {S.V}$ {N.E_unit}]",
            slide=rf"[V|$V = {S.spring}\; {S.constant}\; {S.gravity} = {S.V}$]",
        ),
        f"$T + V = {N.E_total}$ {N.E_unit}",
        r"$\dfrac{\mathrm{d}}{\mathrm{d} t} (T + V) =$",
        either(
            F.datum,
            equilibrium=r"$\dot{x} (m \ddot{x} + k x) = 0$",
            separate=r"$\dot{x} (m \ddot{x} + k (x + \delta_{\mathrm{st}}) - m g) = 0$",
            slide=r"$\dot{x} (m \ddot{x} + k (x + \delta_{\mathrm{st}}) - m g) = 0$",
        ),
        r"[boxed|$m \ddot{x} + k x = 0$]",
        "[small|Energy gives the equation for one degree of freedom.]",
        style="derivation",
        grow=LOWER,
        basis=52,
        phone=41,
    )
