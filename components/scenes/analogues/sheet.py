"""The sheet of the analogues: the stage, and next to it the roles, the motion, the delay or the formula."""

from __future__ import annotations

from functools import cache

from components.language.blocks import Block
from components.language.plots import Handle, Mark
from components.layout.plots import Room, curve, mark, plot
from components.layout.sheet import Paragraph, column, either, phrase, row, stage, table, term, when, words
from components.layout.views import in_views
from components.quantities.formatting import three
from components.scene.traces import traced
from components.scenes.analogues.controls import SWINGING
from components.scenes.analogues.curves import ANGLES, LIMITS, Axes, Hung
from components.scenes.analogues.curves import Lateness as L
from components.scenes.analogues.curves import Signals as S
from components.scenes.analogues.numbers import GAP
from components.scenes.analogues.numbers import Forms as F
from components.scenes.analogues.numbers import Numbers as N
from components.scenes.analogues.reach import IN_TRUTH, REMARKS
from components.scenes.analogues.stage import LATE, MOTION, WIDEST, over_lateness, over_motion, shapes
from physics.analogues import ANALOGUES

AIRCRAFT: list[Paragraph] = [
    "compare",
    r"$\omega_n = \sqrt{2} \, g / v_0$ of",
    "[scene:phugoid|an aircraft]",
]
"""The lecture's tenth system, which has its own scene."""
EXACT_V = {"pendulum": r"m g l (1 - \cos \theta)", "rocking": r"m g d (1 - \cos \theta)"}
EQUATIONS = {
    "pendulum": r"m l^2 \ddot{\theta} + m g l \sin \theta = 0",
    "rocking": r"I \ddot{\theta} + m g d \sin \theta = 0",
    "string": r"\tfrac{1}{2} \rho_L L \, \ddot{q}_n + T \tfrac{n^2 \pi^2}{2 L} q_n = 0",
    "wave": r"\tfrac{\rho}{2 \kappa} \ddot{\eta} + \tfrac{1}{2} \rho g \eta = 0",
    "circuit": r"L \ddot{q} + q / C = 0",
    "pipe": r"\tfrac{1}{2} \rho A L \, \ddot{q}_n + \rho c^2 A \tfrac{n^2 \pi^2}{2 L} q_n = 0",
}
"""Equations of motion that do not follow from the formulas of the table."""


_STARTS = {slug: rf"{system.coordinate.replace('_n', '')}_0" for slug, system in ANALOGUES.items()}


@cache
def analogue_sheet() -> Block:
    return row(
        stage(
            *shapes(),
            label="The chosen system, and the spring and mass of equal frequency, in motion",
            grow=400,
            height=140,
            widest=WIDEST,
        ),
        column(
            in_views(_roles(), "roles"),
            in_views(_motion(), "motion"),
            in_views(_lateness(), "large"),
            in_views(_linear(), "large"),
            in_views(_formula(), "formula"),
            grow=512,
        ),
        gap=16,
    )


def _motion() -> Block:
    (rule, rule_band), (swing, swing_band) = (
        traced(S.x, tint="m1", width="dash", read="spring"),
        traced(S.q, tint="m1", width="sum", read="exact", signal=S.level),
    )
    return plot(
        MOTION,
        x=Axes.t,
        y=Axes.q,
        title="The coordinate of the chosen system and of the spring of equal frequency, against time",
        curves=(rule, swing),
        bands=(rule_band, swing_band),
        heading=(
            term(S.q, "sum", "m1", form=F.system, **{slug: s.coordinate for slug, s in ANALOGUES.items()}),
            phrase(S.x, "dash", "m1", formula="spring"),
            term("", "none", "mute", formula=r"\val{speed}"),
        ),
        cursor="time",
        shapes=over_motion(),
        room=Room(58, 52, top=34),
        phone=10,
        height=210,
    )


def _roles() -> Block:
    """The roles x, m, k, T, V and omega_n in both systems, with formulas and numbers."""
    systems = ANALOGUES.items()
    T, V = ({slug: s.T_formula for slug, s in systems}, {slug: EXACT_V.get(slug, s.V_formula) for slug, s in systems})
    rows = [
        _role(
            "m1",
            "displacement *x*",
            "x",
            f"{S.x}${N.x_unit}",
            {slug: s.coordinate for slug, s in systems},
            f"{S.q}${N.q_unit}",
        ),
        _role(
            "m1",
            "mass *m*",
            "m",
            f"{N.m}${GAP}kg",
            {slug: s.inertia_formula for slug, s in systems},
            f"{N.m}${N.m_unit}",
        ),
        _role(
            "k",
            "stiffness *k*",
            "k",
            f"{N.k}${GAP}N/m",
            {slug: s.stiffness_formula for slug, s in systems},
            f"{N.k}${N.k_unit}",
        ),
        _role("T", "kinetic energy *T*", r"\tfrac{1}{2} m \dot{x}^2", f"{S.T_x}${N.J_unit}", T, f"{S.T_q}${N.E_unit}"),
        _role("V", "potential energy *V*", r"\tfrac{1}{2} k x^2", f"{S.V_x}${N.J_unit}", V, f"{S.V_q}${N.E_unit}"),
    ]
    omega = {slug: f"${s.omega_formula} = {N.omega}$ rad/s" for slug, s in systems}
    rows.append(["natural frequency", rf"$\sqrt{{k/m}} = {N.omega}$ rad/s", either(F.system, **omega)])
    rows.append(AIRCRAFT)
    return table(*rows, head=["", "Spring and mass", f"{N.system_name}"], phone=10, style="roles")


def _role(tint: str, name: str, formula: str, value: str, formulas: dict[str, str], own: str) -> list[Paragraph]:
    """A row: its name, the column of the spring, the column of the chosen system. The values end their formulas."""
    ours = {slug: f"[{tint}|${text} = {own}]" for slug, text in formulas.items()}
    return [name, f"[{tint}|${formula} = {value}]", either(F.system, **ours)]


def _motions() -> dict[str, str]:
    """The motion of each system from rest."""
    return {
        slug: rf"**{'Small swings' if slug in SWINGING else 'Let go at rest'}:** "
        rf"${s.coordinate} = {_STARTS[slug]} \cos({N.omega} t)$"
        for slug, s in ANALOGUES.items()
    }


def _equations() -> dict[str, str]:
    """The equation of motion of each system, in its own symbols."""
    equations = {
        slug: EQUATIONS.get(
            slug,
            rf"{s.inertia_formula} \, \ddot{{{s.coordinate}}} + {s.stiffness_formula} \, {s.coordinate} = 0",
        )
        for slug, s in ANALOGUES.items()
    }
    return {
        slug: rf"**Exactly** ${equation}$; **for small angles** $\sin \theta \approx \theta$"
        if slug in SWINGING
        else f"**Equation:** ${equation}$"
        for slug, equation in equations.items()
    }


def _lateness() -> Block:
    """The plot of T/T_0 - 1 against the amplitude, which is a handle. Flags mark 0.1, 1 and 5 percent."""
    late = (
        r"\text{Longer by } \tau / \tau_0 - 1,",
        rf"\tau = {N.period} \text{{ s}},",
        rf"\tau_0 = {N.small_period} \text{{ s}}",
    )
    handle = Handle(parameter="theta_0", symbol="θ₀", label="Angle at the start, °", tint="m1", unit="°")
    return plot(
        LATE,
        x=Axes.angle,
        y=Axes.late,
        title="How much longer the period is than that of small swings, against the angle at the start",
        curves=(
            curve(L.excess, x=L.angle, tint="ink", width="sum", read="longer by"),
            curve(L.limit, x=L.limit_angle, tint="ink", width="none", marker="disc", group="limits"),
            curve(L.here, x=L.here_angle, tint="m1", width="none", marker="disc", group="here"),
        ),
        heading=tuple(term("", "none", "ink", formula=part) for part in late),
        x_column=L.angle,
        handles=(handle,),
        marks=tuple(map(_flag, LIMITS)),
        shapes=over_lateness(),
        room=Room(48, 30, top=46),
        phone=10,
        height=240,
        form=F.swinging,
    )


def _flag(key: str) -> Mark:
    """The button that starts the pendulum with this relative delay."""
    start, excess = f"{three(ANGLES[key])}°", LIMITS[key]
    return mark(
        Hung.late[key],
        tint="mute",
        style="dashed",
        html=f"<b>{100 * excess:g} %</b><span>{start}</span>",
        label=f"Start from {start}, where the period is {100 * excess:g} % longer",
        set="theta_0",
    )


def _linear() -> Block:
    """The sentence on large amplitudes of a linear system, which has no plot."""
    block = words(
        either(
            F.reach,
            rest="**Nothing moves:** it is let go where it rests.",
            **{
                slug: "**This model is linear at any size:** the spring's dashed line stays under the curve, however "
                f"large the start. That is true {reason}"
                for slug, reason in IN_TRUTH.items()
            },
        ),
        "Choose the pendulum or the rocking body: their large swings take longer.",
        name="linear",
        style="omega",
        grow=1,
        phone=10,
    )
    return when(F.linear, block)


def _formula() -> Block:
    """The formula of the frequency, large, the equation of motion, and notes on a system."""
    return words(
        either(F.system, **{slug: rf"$\omega_n = {s.omega_formula}$" for slug, s in ANALOGUES.items()}),
        f"$= {N.omega}$ rad/s",
        f"{N.frequency} Hz, one swing takes {N.period} s",
        either(F.system, **_equations()),
        either(F.system, **_motions()),
        either(F.note, **REMARKS),
        name="formula",
        style="omega",
        grow=1,
        phone=10,
    )
