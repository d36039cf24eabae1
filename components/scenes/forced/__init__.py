"""How far two masses swing depends on how fast one is pushed (D34, points 6 to 8)."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import param

from components import chain
from components.about import About
from components.about_chain import forced_about
from components.axes import Axis, nice_axis, time_axis, widest
from components.controls import Group
from components.motion import pace
from components.numbers import short, signed, three
from components.parameters import angular_frequency, displacement, force, mass, stiffness, velocity
from components.plots import Band, Curve, plot
from components.scene import Columns, Picture, Scene
from components.scenes.forced.driven import energy_columns, limit_columns, motion_columns, motion_signals, resonant
from components.scenes.forced.response import response, response_plot
from components.sheet import Block, choice, column, row, stage, term, when, words
from components.stage import H, Shape, W, arrow, circle, text, var
from components.traces import samples, traced
from physics.coupled import TwoMassChain
from physics.forced import DrivenModes, determinant, driven_modes, steady_start
from physics.sampling import drawable, time_window

SLOW, FAST = (5**0.5 - 1) / 2, (5**0.5 + 1) / 2
"""The natural frequencies of the lecture's chain of equal masses and springs, in units of sqrt(k/m)."""

PARTS = 4.0
"""The parts are drawn whole while they are less than this many times as large as their sum."""


class Forced(Scene):
    slug = "forced"
    title = "Forced"
    lecture = "D34"
    headline = "How far the masses swing depends on how fast you push"
    groups = (
        Group("Drive", ("F_0", "omega"), "or drag the handle on the curve"),
        chain.CHAIN,
        Group(
            "Start",
            ("x1_0", "x2_0", "v1_0", "v2_0"),
            actions=(("rest", "From rest"), ("steady", "On the particular solution")),
            folded=True,
        ),
    )
    presets = {
        "Equal (slide 8)": {},
        "At slow": {"omega": SLOW},
        "At fast": {"omega": FAST},
        "Near slow": {"omega": 0.6},
        "Still mass 1": {"omega": 1.0},
        "Light mass 2": {"m1": 2.0, "k1": 2.0, "m2": 0.1, "k2": 0.1, "omega": 0.9},
    }

    F_0 = force(1.0)
    omega = angular_frequency(
        0.8, softbounds=(0.0, 2.5 * FAST), says="is the drive frequency. Type any value from 0 up."
    )
    m1 = mass(1.0, symbol="m_1", tint="m1", says="is the mass that is pushed. Type any value above 0.")
    m2 = mass(1.0, symbol="m_2", tint="m2", says="is the mass at the end. Type any value above 0.")
    k1 = stiffness(
        1.0, symbol="k_1", says="ties mass 1 to the wall. 0 lets the pair go free; type any value from 0 up."
    )
    k2 = stiffness(1.0, symbol="k_2", says="couples the masses. 0 lets mass 2 go free; type any value from 0 up.")
    x1_0 = displacement(0.0, symbol="x_1", tint="m1", says="is where mass 1 starts. Type any value.")
    x2_0 = displacement(0.0, symbol="x_2", tint="m2", says="is where mass 2 starts. Type any value.")
    v1_0 = velocity(0.0, symbol="v_1", tint="m1", says="is the velocity of mass 1 at the start. Type any value.")
    v2_0 = velocity(0.0, symbol="v_2", tint="m2", says="is the velocity of mass 2 at the start. Type any value.")
    curve = param.Selector(default="size", objects=["size", "signed", "log"], label="Response shown as")
    axes = param.Selector(default="si", objects=["si", "lecture"], label="Units of the response")

    @classmethod
    @cache
    def sheet(cls) -> Block:
        options = row(
            words("**Steady swing**", phone=9),
            choice("curve", {"size": "Size", "signed": "Signed", "log": "Log"}, "Response shown as", basis=0, phone=9),
            when(
                "lecture", choice("axes", {"si": "SI", "lecture": "Slide 8"}, "Units of the response", basis=0, phone=9)
            ),
            grow=0,
            basis=34,
            gap=10,
        )
        return column(
            row(
                stage(*_shapes(), label="Two masses and two springs, the first one driven by a force", height=150),
                words(*_formulas(), style="facts", basis=300, phone=4),
                grow=165,
            ),
            row(
                column(options, response_plot(phone=10, height=300, margin=(40, 34)), basis=430, grow=430),
                column(_motion(1), _motion(2), _energy(), basis=456, grow=456),
                grow=420,
                gap=18,
            ),
        )

    def action(self, name: str) -> dict[str, Any]:
        names = ("x1_0", "x2_0", "v1_0", "v2_0")
        if name == "rest":
            return dict.fromkeys(names, 0.0)
        x_0, v_0 = steady_start(self._chain, self.F_0, self.omega)
        return dict(zip(names, (*x_0, *v_0), strict=True))

    @property
    def _chain(self) -> TwoMassChain:
        return TwoMassChain(m1=self.m1, m2=self.m2, k1=self.k1, k2=self.k2)

    def picture(self) -> Picture:
        system = self._chain
        driven = driven_modes(system, self.F_0, self.omega, (self.x1_0, self.x2_0), (self.v1_0, self.v2_0))
        slow, fast = system.modes().omega
        end = self.window or time_window(slow, fast)
        fastest = max(fast, self.omega)
        t = np.linspace(0.0, end, samples(end, fastest))
        motion = driven.motion(t)
        curves, bands = motion_columns(driven, motion)
        extremes = chain.extremes(curves, bands)
        time, size = time_axis(end), nice_axis(*_span(extremes, curves), "m", 3)
        work = energy_columns(driven, motion) if drawable(2 * fastest, t) else {}
        energy = (
            nice_axis(*widest(*((float(c.min()), float(c.max())) for c in work.values())), "J", 2)
            if work
            else Axis(0, 1, "J")
        )
        push = nice_axis(0.0, self.F_0 or 1.0, "N")
        lecture = self.axes == "lecture" and self.k1 > 0 and self.F_0 > 0
        swing = response(system, self.F_0, self.omega, self.curve, lecture)
        drawn = chain.to_scale(extremes, (self.m1, self.m2), (self.k1, self.k2), size)
        self.param.omega.softbounds = (0.0, 2.5 * float(fast) if fast else 5.0)
        return Picture(
            columns={
                "time": {"t": t, **curves},
                "band": bands and {"t": t, **bands},
                "limit": limit_columns(driven, t),
                "energy": work and {"t": t, **work},
                **swing.columns,
            },
            axes={"t": time, "x": size, "E": energy, **swing.axes},
            signals=motion_signals(driven, size, time, push),
            scalars={**drawn.scalars, **pace(slow or fast or self.omega, fastest), **swing.scalars},
            values={**_values(driven, work), **swing.values, **drawn.values, "F_unit": push.full_unit},
            live={**{name: size.digits(signed=True) for name in ("x1", "x2")}, "force_now": push.digits(signed=True)},
            forms=_forms(driven, bool(work)) | {"lecture": "offered" if self.k1 and self.F_0 else ""},
            notes=(*drawn.notes, *_notes(driven, self.axes, lecture, bool(work))),
        )

    def about(self) -> About:
        x_0, v_0 = (self.x1_0, self.x2_0), (self.v1_0, self.v2_0)
        return forced_about(self.shown, driven_modes(self._chain, self.F_0, self.omega, x_0, v_0), x_0, v_0)


def _shapes() -> list[Shape]:
    foot = 0.8 * H
    push, middle = chain.place(1, "x1"), foot - 0.5 * var("side1") * W
    return [
        chain.standing_wall(0.2 * H, 0.62 * H),
        *chain.ground(foot),
        *(s for i in (1, 2) for s in chain.displacement(i, foot)),
        *chain.masses(foot, push, chain.place(2, "x2"), corner=True),
        arrow(push, middle, push + 0.13 * W * var("drive"), middle, tint="F", style="thick", head=18),
        circle(push, middle, 5, tint="F"),
        text(push + 0.13 * W * var("drive"), middle - 14, "*F*", tint="F", style="t3 b halo"),
    ]


def _formulas() -> list[str | dict[str, str]]:
    return [
        {
            "form": "steady",
            "finite": r"$\tint{m1}{X_{\mathrm{p}1} = \dfrac{(k_2 - m_2 \omega^2) F_0}{D} = \val{Xp1}}$ [m1|m]",
            "none": "**No drive:** at $\\omega = 0$ the force is 0 at all times.",
            "resonance": "**Drive at a natural frequency:** no steady swing exists. From rest the motion grows "
            "like $t$.",
        },
        {
            "form": "steady",
            "finite": r"$\tint{m2}{X_{\mathrm{p}2} = \dfrac{k_2 F_0}{D} = \val{Xp2}}$ [m2|m]",
            "resonance": r"$D = m_1 m_2 (\omega^2 - \omega_-^2)(\omega^2 - \omega_+^2) = 0$",
            "none": "",
        },
        r"$\tint{F}{F = F_0 \sin \omega t =}$ [F|{force_now} {F_unit}]",
        {
            "form": "steady",
            "finite": r"[small|$D = m_1 m_2 (\omega^2 - \omega_-^2)(\omega^2 - \omega_+^2) = \val{D}$]",
            "resonance": "",
            "none": "",
        },
    ]


def _motion(i: int) -> Block:
    """x_i(t) with its particular and complementary parts; near resonance the envelope and line of growth instead."""
    traces = (
        traced(f"x{i}_c", tint="xc", width="dash", label="*x*_c", signal=f"x{i}_c"),
        traced(f"x{i}_p", tint="xp", label="*x*_p", signal=f"x{i}_p"),
        traced(f"x{i}", tint=f"m{i}", width="sum", label=f"*x*_{i}", signal=f"x{i}"),
    )
    envelope = (
        Curve(name=f"x{i}_beat", source="limit", tint="xp", label="beat", group=f"x{i}_limit"),
        Curve(name=f"x{i}_growth", source="limit", tint="mute", width="dots", label="growth", group=f"x{i}_limit"),
    )
    return plot(
        f"x{i}",
        x="t",
        y="x",
        title=f"Displacement of mass {i} against time, with its particular and its complementary part",
        curves=(*(curve for curve, _ in traces), *envelope),
        bands=tuple(band for _, band in traces),
        heading=(
            term(f"x{i}", "sum", f"m{i}", formula=f"x_{i} ="),
            term(f"x{i}_p", "line", "xp", formula=rf"\text{{particular }}\val{{X{i}}}\,\sin(\val{{omega}}\,t)"),
            term(f"x{i}_c", "dash", "xc", formula=r"+\; \text{complementary}"),
            term(f"x{i}_limit", "line", "xp", formula=r"|\sin(d\,t)/d| \text{ and its limit } t"),
        ),
        x_labels=False,
        cursor="time",
        margin=(40, 50),
        phone=10 + i,
        height=125,
    )


def _energy() -> Block:
    return plot(
        "energy",
        x="t",
        y="E",
        title="Gain of kinetic and potential energy since the start, and the work of the drive: they are equal",
        bands=(Band(low="none", high="gain", source="energy", tint="k2fill"),),
        curves=(Curve(name="work", source="energy", tint="F", width="dash", label="work"),),
        heading=(
            term("", "band", "k2fill", formula=r"\text{gain of } T + V"),
            term("", "dash", "F", formula=r"=\; \text{work of the drive}"),
            term("gap", "none", "mute", formula=r"\text{off by } \val{gap} \text{ of it}"),
        ),
        source="energy",
        cursor="time",
        margin=(40, 50),
        phone=13,
        height=120,
    )


def _span(extremes: chain.Extremes, curves: Columns) -> tuple[float, float]:
    """The range of x(t): the motion, and its parts as long as it does not vanish beside them."""
    motion = widest(extremes["x1"], extremes["x2"])
    parts = [(float(c.min()), float(c.max())) for name, c in curves.items() if "_" in name]
    whole = widest(motion, *parts)
    return whole if whole[1] - whole[0] < PARTS * (motion[1] - motion[0]) or motion[0] == motion[1] else motion


def _values(driven: DrivenModes, columns: Columns) -> dict[str, str]:
    X = driven.particular
    values = {"omega": three(driven.omega)}
    for i in (0, 1):
        values[f"X{i + 1}"] = values[f"Xp{i + 1}"] = signed(X[i])
    values["D"] = three(determinant(driven.chain, driven.omega))
    if columns:
        largest = max(float(np.abs(columns["gain"]).max()), 5e-324)
        gap = float(np.abs(columns["gain"] - columns["work"]).max()) / largest
        values["gap"] = short(gap)
    return values


def _is_steady(driven: DrivenModes) -> bool:
    """Whether a particular solution exists."""
    return bool(np.all(np.isfinite(driven.particular)))


def _forms(driven: DrivenModes, energies: bool) -> dict[str, str]:
    """Close to a natural frequency the two parts are huge and opposite: there the envelope stands in their place."""
    split = driven.split_is_meaningful
    steady = "finite" if _is_steady(driven) else "resonance" if driven.omega else "none"
    forms = {"steady": steady}
    for i in (1, 2):
        forms |= dict.fromkeys((f"x{i}_p", f"x{i}_c"), "formula" if split else "")
        forms[f"x{i}_limit"] = "formula" if resonant(driven) else ""
    return forms | {"gap": "formula" if energies else ""}


def _notes(driven: DrivenModes, units: str, lecture: bool, energies: bool) -> list[str]:
    notes = ["At ω = 0 the force F₀ sin ωt is 0 at all times."] if not driven.omega and _is_steady(driven) else []
    if resonant(driven):
        notes.append("Complementary and particular part are huge and opposite here, so they are not drawn.")
    if units == "lecture" and not lecture:
        notes.append("The lecture's units F₀/k₁ and √(k₁/m₁) need k₁ and F₀ above 0: shown in SI.")
    if not energies:
        notes.append("The energies change too fast to be drawn in this window.")
    return notes
