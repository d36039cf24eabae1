"""The sheet of the analogues: stage, motion, table of roles, lateness or formula."""

from __future__ import annotations

import math

from components.language.blocks import Block
from components.language.plots import Handle, Mark
from components.layout.plots import Room, curve, plot
from components.layout.sheet import Paragraph, column, desk, either, row, stage, table, term, when, words
from components.quantities.declared import Named
from components.quantities.numbers import three
from components.scene.traces import traced
from components.scenes.analogues.case import LIMITS
from components.scenes.analogues.controls import SWINGING
from components.scenes.analogues.numbers import GAP
from components.scenes.analogues.numbers import Numbers as N
from components.scenes.analogues.reach import IN_TRUTH, REMARKS
from components.scenes.analogues.stage import over_lateness, over_motion, shapes
from physics.analogues import ANALOGUES
from physics.pendulum import amplitude_at_excess

TASK = "Choose a system: what has the role of the mass, and what that of the spring?"
AIRCRAFT: list[Paragraph] = [
    "compare",
    r"$\omega_n = \sqrt{2} \, g / v_0$ of",
    "[scene:phugoid|an aircraft]",
]
"""The lecture's tenth system: it has a scene of its own."""
EXACT_V = {"pendulum": r"m g l (1 - \cos \theta)", "rocking": r"m g d (1 - \cos \theta)"}
EQUATIONS = {
    "pendulum": r"m l^2 \ddot{\theta} + m g l \sin \theta = 0",
    "rocking": r"I \ddot{\theta} + m g d \sin \theta = 0",
    "string": r"\tfrac{1}{2} \rho_L L \, \ddot{q}_n + T \tfrac{n^2 \pi^2}{2 L} q_n = 0",
    "wave": r"\tfrac{\rho}{2 \kappa} \ddot{\eta} + \tfrac{1}{2} \rho g \eta = 0",
    "circuit": r"L \ddot{q} + q / C = 0",
    "pipe": r"\tfrac{1}{2} \rho A L \, \ddot{q}_n + \rho c^2 A \tfrac{n^2 \pi^2}{2 L} q_n = 0",
}
"""Equations of motion where they are not the formulas of the table put together."""


_STARTS = {slug: rf"{system.coordinate.replace('_n', '')}_0" for slug, system in ANALOGUES.items()}


def analogue_sheet() -> Block:
    return column(
        desk(words(TASK, style="task", phone=0)),
        row(
            stage(
                *shapes(),
                label="The chosen system, and the spring and mass of equal frequency, in motion",
                grow=430,
                height=190,
                widest=1.75,
            ),
            _motion(),
            grow=288,
            gap=0,
        ),
        row(column(_roles(), desk(_equation()), grow=436), column(_lateness(), _formula(), grow=452), grow=285),
    )


def _motion() -> Block:
    (rule, rule_band), (swing, swing_band) = (
        traced("x", tint="m1", width="dash", read="spring"),
        traced("q", tint="m1", width="sum", read="exact", signal="level"),
    )
    exact = {slug: rf"{ANALOGUES[slug].coordinate} \text{{ exact}}" for slug in SWINGING}
    cosine = {
        slug: rf"{system.coordinate} = {_STARTS[slug]} \cos({N.omega} t)"
        for slug, system in ANALOGUES.items()
        if slug not in SWINGING
    }
    rules = {slug: rf"{_STARTS[slug]} \cos({N.omega} t) \text{{ spring}}" for slug in SWINGING}
    return plot(
        "motion",
        x="t",
        y="q",
        title="The coordinate of the chosen system and of the spring of equal frequency, against time",
        curves=(rule, swing),
        bands=(rule_band, swing_band),
        heading=(
            term("q", "sum", "m1", **exact, **cosine),
            term("x", "dash", "m1", **rules, linear=r"\text{spring}"),
            term("", "none", "mute", formula=r"\val{speed}"),
        ),
        cursor="time",
        shapes=over_motion(),
        room=Room(58, 52, top=34),
        grow=470,
        phone=10,
        height=210,
    )


def _roles() -> Block:
    """The roles x, m, k, T, V and omega_n in both systems, in formulas and numbers that agree or part."""
    systems = ANALOGUES.items()
    T, V = ({slug: s.T_formula for slug, s in systems}, {slug: EXACT_V.get(slug, s.V_formula) for slug, s in systems})
    rows = [
        _role("m1", "x", "x", N.x_unit, {slug: s.coordinate for slug, s in systems}, "q", N.q_unit),
        _role("m1", "m", "m", f"{GAP}kg", {slug: s.inertia_formula for slug, s in systems}, "m", N.m_unit),
        _role("k", "k", "k", f"{GAP}N/m", {slug: s.stiffness_formula for slug, s in systems}, "k", N.k_unit),
        _role("T", "T", r"\tfrac{1}{2} m \dot{x}^2", N.J_unit, T, "T_q", N.E_unit),
        _role("V", "V", r"\tfrac{1}{2} k x^2", N.J_unit, V, "V_q", N.E_unit),
    ]
    omega = {slug: f"${s.omega_formula} = {N.omega}$ rad/s" for slug, s in systems}
    rows.append(["natural frequency", rf"$\sqrt{{k/m}} = {N.omega}$ rad/s", either("system", **omega)])
    rows.append(AIRCRAFT)
    return table(*rows, head=["", "Spring and mass", f"{N.system_name}"], phone=30, style="roles")


def _role(
    tint: str, symbol: str, formula: str, unit: Named | str, formulas: dict[str, str], own: str, own_unit: Named
) -> list[Paragraph]:
    """A row: its name, the spring's side, the chosen system's side."""
    value = {"T": "T_x", "V": "V_x"}.get(symbol, symbol)
    return [
        f"role of ${symbol}$",
        f"[{tint}|${formula} = \\val{{{value}}}${unit}]",
        either(
            "system",
            **{slug: f"[{tint}|${text} = \\val{{{own}}}${own_unit}]" for slug, text in formulas.items()},
        ),
    ]


def _equation() -> Block:
    """The equation of motion in the names of the chosen system."""
    equations = {
        slug: EQUATIONS.get(
            slug,
            rf"{s.inertia_formula} \, \ddot{{{s.coordinate}}} + {s.stiffness_formula} \, {s.coordinate} = 0",
        )
        for slug, s in ANALOGUES.items()
    }
    return words(
        either(
            "system",
            **{
                slug: rf"**Exactly** ${equation}$; **for small angles** $\sin \theta \approx \theta$"
                if slug in SWINGING
                else f"**Equation:** ${equation}$"
                for slug, equation in equations.items()
            },
        ),
        style="equation",
        phone=31,
    )


def _lateness() -> Block:
    """T/T_0 - 1 against the amplitude, which is a handle; flags go where it passes 0.1, 1 and 5 percent."""
    late = (
        r"\text{Longer by } \tau / \tau_0 - 1,",
        rf"\tau = {N.period} \text{{ s}},",
        rf"\tau_0 = {N.small_period} \text{{ s}}",
    )
    handle = Handle(parameter="theta_0", symbol="θ₀", label="Angle at the start, °", tint="m1", unit="°")
    return plot(
        "late",
        x="angle",
        y="late",
        title="How much longer the period is than that of small swings, in percent, against the angle at the start",
        curves=(
            curve("excess", source="late", x="angle", tint="ink", width="sum", read="longer by"),
            *(
                curve("excess", source=name, x="angle", tint=tint, width="none", marker="disc", group=name)
                for name, tint in (("limits", "ink"), ("here", "m1"))
            ),
        ),
        heading=tuple(term("", "none", "ink", formula=part) for part in late),
        x_column="angle",
        handles=(handle,),
        marks=tuple(_flag(name, excess) for name, excess in LIMITS.items()),
        shapes=over_lateness(),
        room=Room(48, 30, top=46),
        phone=20,
        height=240,
        form="swinging",
    )


def _flag(name: str, excess: float) -> Mark:
    """The button that starts the pendulum where its swing is late by `excess`."""
    start = f"{three(math.degrees(amplitude_at_excess(excess)))}°"
    return Mark(
        at=name,
        tint="mute",
        style="dashed",
        html=f"<b>{100 * excess:g} %</b><span>{start}</span>",
        label=f"Start from {start}, where the period is {100 * excess:g} % longer",
        set="theta_0",
    )


def _formula() -> Block:
    """The formula of a system that is linear at any size: its frequency, large, and what there is to say of it."""
    omega = {slug: rf"$\omega_n = {s.omega_formula}$" for slug, s in ANALOGUES.items() if slug not in SWINGING}
    block = words(
        either("system", **omega),
        f"$= {N.omega}$ rad/s",
        f"{N.frequency} Hz, one swing takes {N.period} s",
        either(
            "reach",
            rest="**Nothing moves:** it is let go where it rests.",
            **{
                slug: "**This model is linear at any size:** the spring's dashed line stays under the curve, however "
                f"large the start. That is true {reason}"
                for slug, reason in IN_TRUTH.items()
            },
        ),
        either("note", **REMARKS),
        style="omega",
        grow=1,
        phone=20,
    )
    return when("linear", block)
