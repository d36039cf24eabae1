"""Every free motion of two masses and two springs is a slow mode plus a fast mode (D34, points 1, 2 and 5)."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import param
from numpy.typing import NDArray

from components import chain
from components.about import About
from components.about_chain import coupled_about
from components.motion import derived, pace, scaled, total
from components.numbers import plus, signed, three
from components.parameters import displacement, mass, stiffness, velocity
from components.plots import Axis, Band, Curve, nice_axis, plot, time_axis, whole_axis, widest
from components.scene import Columns, Picture, Scene
from components.sheet import Block, choice, column, row, stage, term, words
from components.stage import H, Shape, W, arrow, line, on_x, on_y, text, var
from components.traces import samples, trace, traced
from physics.coupled import FreeModes, TwoMassChain, free_modes, free_motion
from physics.energy import chain_energy, mean_energy
from physics.sampling import drawable, time_window

MODES = ("slow", "fast")
SIGN = {"slow": "minus", "fast": "plus"}


class Coupled(Scene):
    slug = "coupled"
    title = "Coupled"
    lecture = "D34"
    headline = "Every free motion is a slow mode plus a fast mode"
    groups = (chain.CHAIN, chain.START)
    presets = {
        "Both": {},
        "Slow": {"x1_0": 0.4, "x2_0": 0.8},
        "Fast": {"x1_0": 0.7, "x2_0": -0.7},
        "Beats": {"m1": 1.0, "k1": 0.96, "m2": 0.04, "k2": 0.04, "x1_0": 0.2},
        "Equal (slide 8)": {"m1": 1.0, "m2": 1.0, "k1": 1.0, "k2": 1.0},
        "Drift": {"k1": 0.0, "x1_0": 0.3, "v1_0": 0.2, "v2_0": 0.2},
        "Heavy, light": {"m1": 10.0, "m2": 0.1, "k1": 10.0, "k2": 1.0, "x1_0": 0.5},
    }

    m1 = mass(2.0, symbol="m_1", tint="m1", says="is the mass next to the wall. Type any value above 0.")
    m2 = mass(1.0, symbol="m_2", tint="m2", says="is the mass at the end. Type any value above 0.")
    k1 = stiffness(
        4.0, symbol="k_1", says="ties mass 1 to the wall. 0 lets the pair go free; type any value from 0 up."
    )
    k2 = stiffness(2.0, symbol="k_2", says="couples the masses. 0 lets mass 2 go free; type any value from 0 up.")
    x1_0 = displacement(1.0, symbol="x_1", tint="m1", says="is where mass 1 starts. Type any value.")
    x2_0 = displacement(0.0, symbol="x_2", tint="m2", says="is where mass 2 starts. Type any value.")
    v1_0 = velocity(0.0, symbol="v_1", tint="m1", says="is the velocity of mass 1 at the start. Type any value.")
    v2_0 = velocity(0.0, symbol="v_2", tint="m2", says="is the velocity of mass 2 at the start. Type any value.")
    energy = param.Selector(default="parts", objects=["parts", "modes"], label="Energy of")

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return column(
            row(
                stage(*_shapes(), label="Two masses and two springs in motion; below, its two modes", height=215),
                words(*_facts(), style="sum", basis=212, phone=4),
                grow=230,
                gap=18,
            ),
            row(
                column(_displacements(1), _displacements(2), _part_energies(), _mode_energies()),
                column(
                    words("**Mass 2 against mass 1**", style="plain", phone=15),
                    _plane(),
                    words(
                        "[slow|Slow period] {slow_period}",
                        "[fast|Fast period] {fast_period}",
                        "Beat period {beat_period}",
                        style="numbers",
                        phone=17,
                    ),
                    choice("energy", {"parts": "Masses, springs", "modes": "Modes"}, "Energy of", phone=14),
                    basis=212,
                    grow=0,
                ),
                grow=346,
                gap=18,
            ),
        )

    def picture(self) -> Picture:
        system = TwoMassChain(m1=self.m1, m2=self.m2, k1=self.k1, k2=self.k2)
        free = free_modes(system, (self.x1_0, self.x2_0), (self.v1_0, self.v2_0))
        slow, fast = system.modes().omega
        end = self.window or time_window(slow, fast)
        t = np.linspace(0.0, end, samples(end, fast))
        curves, bands = _motion_columns(free, t)
        stack, flat = _energy_columns(self, system, free, t)
        extremes = chain.extremes(curves, bands)
        time = time_axis(end)
        size = nice_axis(*widest(extremes["x1"], extremes["x2"]), "m", 3)
        energy = whole_axis(float(free.energy.sum()), "J")
        drawn = chain.to_scale(extremes, (self.m1, self.m2), (self.k1, self.k2), size)
        return Picture(
            columns={
                "time": {"t": t, **curves, **stack},
                "band": bands and {"t": t, **bands},
                "flat": flat,
                "modes": _mode_lines(free, size),
            },
            axes={"t": time, "x": size, "E": energy},
            signals=_signals(self, free, size, time, energy),
            scalars={**drawn.scalars, **pace(slow or fast, fast)},
            values={**_values(free, energy), **drawn.values},
            live={
                **{name: size.digits(signed=True) for name in ("x1", "x2")},
                **{name: energy.digits() for name in ("T1", "V1", "V2", "T2")},
            },
            forms=_forms(self, free),
            notes=(*drawn.notes, *_notes(fast, t)),
        )

    def about(self) -> About:
        system = TwoMassChain(m1=self.m1, m2=self.m2, k1=self.k1, k2=self.k2)
        return coupled_about(self.shown, system, (self.x1_0, self.x2_0), (self.v1_0, self.v2_0))


def _shapes() -> list[Shape]:
    """The motion, and under it the same chain twice more: its slow part and its fast part alone."""
    foot, slow_foot, fast_foot = 0.56 * H, 0.815 * H, 1.0 * H
    shapes = [chain.standing_wall(0.17 * H, 0.83 * H), *chain.ground(foot)]
    for mass_ in (1, 2):
        shapes.append(line(chain.rest(mass_), foot, chain.rest(mass_), fast_foot, tint="mute", style="eq"))
        shapes += chain.displacement(mass_, foot)
    shapes += chain.masses(foot, chain.place(1, "x1"), chain.place(2, "x2"))
    for mode, base in (("slow", slow_foot), ("fast", fast_foot)):
        shapes.append(line(chain.WALL * W, base, W, base, tint="rule", style="hair"))
        places = [chain.place(i, f"x{i}_{mode}") for i in (1, 2)]
        shapes += chain.masses(base, *places, small=True)
        shapes += [arrow(chain.rest(i), base - 0.026 * W, places[i - 1], base - 0.026 * W, tint=mode) for i in (1, 2)]
    return shapes


def _facts() -> list[str | dict[str, str]]:
    facts: list[str | dict[str, str]] = ["**The motion**"]
    for mode, sign in (("slow", "="), ("fast", "+")):
        name, index = SIGN[mode], {"slow": "-", "fast": "+"}[mode]
        facts.append(
            {
                "form": f"{mode}_fact",
                "sine": f"[{mode}|{sign} {mode} mode]",
                "drift": f"[{mode}|{sign} drift: no spring to the wall]",
                "free": f"[{mode}|{sign} mass 2 drifts: it is not coupled]",
                "two": f"[{mode}|{sign} drift: no spring at all]",
            }
        )
        facts.append(
            {
                "form": f"{mode}_omega",
                "sine": rf"$\omega_{{{index}}} = \val{{omega_{name}}}$ rad/s, $X_2 / X_1 = \val{{ratio_{name}}}$",
                "drift": rf"$\omega_{{{index}}} = 0$: $x = a + b\,t$, $X_2 / X_1 = \val{{ratio_{name}}}$",
            }
        )
    return facts


def _displacements(i: int) -> Block:
    """x_i(t), its slow part and its fast part, under the formula that is their legend and switch."""
    traces = (
        traced(f"x{i}_slow", tint="slow", label="slow", signal=f"x{i}_slow"),
        traced(f"x{i}_fast", tint="fast", width="dash", label="fast", signal=f"x{i}_fast"),
        traced(f"x{i}", tint=f"m{i}", width="sum", label=f"*x*_{i}", signal=f"x{i}"),
    )
    return plot(
        f"x{i}",
        x="t",
        y="x",
        title=f"Displacement of mass {i} against time, with its slow and its fast part",
        curves=tuple(curve for curve, _ in traces),
        bands=tuple(band for _, band in traces),
        heading=(
            term(f"x{i}", "sum", f"m{i}", formula=f"x_{i} ="),
            term(
                f"x{i}_slow",
                "line",
                "slow",
                sine=rf"\val{{X{i}m}}\,\sin(\val{{omega_minus}}\,t\; \val{{phi_minus}})",
                drift=rf"\val{{a{i}}} \val{{b{i}}}\,t",
            ),
            term(
                f"x{i}_fast",
                "dash",
                "fast",
                sine=rf"\val{{X{i}p}}\,\sin(\val{{omega_plus}}\,t\; \val{{phi_plus}})",
            ),
        ),
        x_labels=False,
        cursor="time",
        phone=10 + i,
        height=118,
    )


STACK = (
    ("e0", "e1", "T1", "m1", "*T*_1"),
    ("e1", "e2", "V1", "k1fill", "*V*_1"),
    ("e2", "e3", "V2", "k2fill", "*V*_2"),
    ("e3", "e4", "T2", "m2", "*T*_2"),
)


def _part_energies() -> Block:
    """T and V of each mass and spring, stacked to a flat top: T1 from the floor, T2 from the ceiling."""
    return plot(
        "energy",
        x="t",
        y="E",
        title="Kinetic and potential energy of each mass and spring, stacked to their constant sum",
        bands=tuple(Band(low=low, high=high, tint=tint, label=label) for low, high, _, tint, label in STACK),
        heading=(
            term("", "none", "ink", formula=r"T + V = \val{E_total} ="),
            *(
                term("", "band", tint, formula=rf"{name[0]}_{name[1]} = \val{{{name}}}{' +' if name != 'T2' else ''}")
                for _, _, name, tint, _ in STACK
            ),
            term("", "none", "ink", formula=r"\val{E_unit}"),
        ),
        cursor="time",
        phone=13,
        height=130,
        show="parts",
    )


def _mode_energies() -> Block:
    """The energies of the two modes: two flat lines."""
    return plot(
        "mode_energy",
        x="t",
        y="E",
        title="Energy of the slow mode and of the fast mode: both constant",
        curves=(
            Curve(name="E_slow", source="flat", tint="slow", label="slow"),
            Curve(name="E_fast", source="flat", tint="fast", width="dash", label="fast"),
            Curve(name="E_total", source="flat", tint="ink", width="sum", label="*E*"),
        ),
        heading=(
            term("", "none", "ink", formula=r"T + V = \val{E_total} ="),
            term("E_slow", "line", "slow", formula=r"\val{E_minus}"),
            term("E_fast", "dash", "fast", formula=r"+\; \val{E_plus}"),
            term("", "none", "ink", formula=r"\val{E_unit}\text{: each mode keeps its own}"),
        ),
        source="flat",
        cursor="time",
        phone=13,
        height=130,
        show="modes",
    )


def _plane() -> Block:
    """The motion in the (x1, x2) plane: along the direction of the slow mode, then along that of the fast one."""
    zero = on_x("plane", 0), on_y("plane", 0)
    slow = on_x("plane", var("x1_slow")), on_y("plane", var("x2_slow"))
    here = on_x("plane", var("x1")), on_y("plane", var("x2"))
    return plot(
        "plane",
        x="x",
        y="x",
        title="Displacement of mass 2 against that of mass 1, with the directions of the two modes",
        source="time",
        x_column="x1",
        curves=(
            Curve(name="slow2", source="modes", x="slow1", tint="slow"),
            Curve(name="fast2", source="modes", x="fast1", tint="fast", width="dash"),
            Curve(name="x2", x="x1", tint="ink", signal="x1,x2"),
        ),
        shapes=(
            arrow(*zero, *slow, tint="slow"),
            arrow(*slow, *here, tint="fast"),
            text(var("plane.right") - 4, zero[1] - 8, "*x*_1", anchor="end", tint="m1", style="t2 b"),
            text(zero[0] + 8, var("plane.top") + 12, "*x*_2", anchor="start", tint="m2", style="t2 b"),
        ),
        margin=(8, 8),
        square=True,
        plain=True,
        grow=1,
        phone=16,
        height=300,
    )


def _motion_columns(free: FreeModes, t: NDArray[np.float64]) -> tuple[Columns, Columns]:
    """Columns of x1, x2, their parts, and the elongation of spring 2; curves, and bands where too fast."""
    parts, _ = free.parts(t)
    curves: Columns = {}
    bands: Columns = {}
    for i in (0, 1):
        drift = free.drift_a[i] + free.drift_b[i] * t
        motions: dict[str, tuple[tuple[int, ...], NDArray[np.float64]]] = {
            f"x{i + 1}": ((0, 1), parts[:, i].sum(axis=0))
        }
        motions |= {f"x{i + 1}_{mode}": ((j,), parts[j, i]) for j, mode in enumerate(MODES)}
        for name, (modes, exact) in motions.items():
            base = drift if any(free.omega[j] == 0 for j in modes) else None
            curve, band = trace(name, chain.components(free, i, modes), t, base, exact)
            curves |= curve
            bands |= band
    return curves, bands


def _energy_columns(
    scene: Coupled, system: TwoMassChain, free: FreeModes, t: NDArray[np.float64]
) -> tuple[Columns, Columns]:
    """Columns of the chosen energy view: the stack's edges over time, or the flat lines of the modes."""
    if scene.energy == "modes":
        slow, fast = free.energy
        flat = {"E_slow": slow, "E_fast": fast, "E_total": slow + fast}
        return {}, {"t": t[[0, -1]], **{name: np.full(2, level) for name, level in flat.items()}}
    layers = np.cumsum([np.zeros_like(t), *_energies(scene, free, t)], axis=0)
    return {f"e{i}": edge for i, edge in enumerate(layers)}, {}


def _energies(scene: Coupled, free: FreeModes, t: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """T1, V1, V2, T2; where a swing is too fast to draw, its mean."""
    if drawable(2 * free.omega[1], t):
        motion = free_motion(free.chain, (scene.x1_0, scene.x2_0), (scene.v1_0, scene.v2_0), t)
        energy = chain_energy(free.chain, motion)
        return [energy.T[0], energy.V[0], energy.V[1], energy.T[1]]
    means = mean_energy(free, t)
    return [means.T[0], means.V[0], means.V[1], means.T[1]]


def _notes(fast: float, t: NDArray[np.float64]) -> list[str]:
    if drawable(2 * fast, t):
        return []
    band = "" if drawable(fast, t) else "The fast motion fills the band that is drawn, too fast for a line. "
    return [f"{band}Energies are means over a fast swing."]


def _mode_lines(free: FreeModes, size: Axis) -> Columns:
    """Both mode directions of the (x1, x2) plane, as far as the frame and beyond."""
    far = 4 * max(abs(size.start), abs(size.end))
    lines: Columns = {}
    for mode, ratio in zip(MODES, free.chain.modes().ratio, strict=True):
        one, two = (0.0, 1.0) if math.isinf(ratio) else (1 / max(1, abs(ratio)), ratio / max(1, abs(ratio)))
        lines[f"{mode}1"], lines[f"{mode}2"] = far * one * np.array([-1.0, 1.0]), far * two * np.array([-1.0, 1.0])
    return lines


def _signals(scene: Coupled, free: FreeModes, size: Axis, time: Axis, energy: Axis) -> dict[str, Any]:
    """The parts of each displacement and velocity, their sums, and the four energies."""
    signals = chain.free_signals(free, size, time)
    for name in ("x1", "x2", "v1", "v2"):
        signals[name] = total(f"{name}_slow", f"{name}_fast")
    signals["stretch"] = derived(var("x2") - var("x1"))
    kinetic, potential = energy.exponent - 2 * size.exponent + 2 * time.exponent, energy.exponent - 2 * size.exponent
    for name, factor, rate in (("T1", scene.m1, "v1"), ("T2", scene.m2, "v2")):
        signals[name] = derived(scaled(kinetic, 0.5, factor) * var(rate) * var(rate))
    for name, factor, stretch in (("V1", scene.k1, "x1"), ("V2", scene.k2, "stretch")):
        signals[name] = derived(scaled(potential, 0.5, factor) * var(stretch) * var(stretch))
    return signals


def _values(free: FreeModes, energy: Axis) -> dict[str, str]:
    modes = free.chain.modes()
    values: dict[str, str] = {}
    for j, mode in enumerate(MODES):
        name, letter = SIGN[mode], "mp"[j]
        omega, ratio = modes.omega[j], modes.ratio[j]
        values[f"omega_{name}"] = three(omega)
        values[f"ratio_{name}"] = "∞" if math.isinf(ratio) else signed(ratio)
        values[f"phi_{name}"] = plus(free.phase[j])
        values[f"E_{name}"] = energy.number(free.energy[j])
        values[f"{mode}_period"] = f"{three(2 * math.pi / omega)} s" if omega else "none"
        for i in (1, 2):
            amplitude = free.amplitude[j, i - 1]
            values[f"X{i}{letter}"] = plus(amplitude) if letter == "p" else three(amplitude)
    for i in (1, 2):
        values[f"a{i}"], values[f"b{i}"] = three(free.drift_a[i - 1]), plus(free.drift_b[i - 1])
    beat = modes.beat if modes.omega[0] else 0.0
    values["beat_period"] = f"{three(2 * math.pi / beat)} s" if beat else "none: one frequency"
    values["E_total"], values["E_unit"] = energy.number(float(free.energy.sum())), energy.full_unit
    return values


def _forms(scene: Coupled, free: FreeModes) -> dict[str, str]:
    """Which sentence stands: a mode of frequency zero is a drift, and with no spring at all both are."""
    slow, fast = free.omega
    kind = "sine" if slow else ("two" if not fast else "drift" if scene.k2 else "free")
    forms = {"slow_fact": kind, "fast_fact": "sine" if fast else "", scene.energy: "shown"}
    forms |= {"slow_omega": "sine" if slow else "drift", "fast_omega": "sine" if fast else ""}
    for i in (1, 2):
        forms[f"x{i}_slow"] = "sine" if slow else "drift"
        forms[f"x{i}_fast"] = "sine" if fast else ""
    return forms
