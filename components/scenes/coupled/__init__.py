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
from components.axes import Axis, nice_axis, time_axis, whole_axis, widest
from components.motion import derived, pace, scaled, total
from components.numbers import plus, signed, three
from components.parameters import displacement, mass, stiffness, velocity
from components.scene import Columns, Picture, Scene
from components.scenes.coupled.sheet import MODES, SIGN, coupled_sheet
from components.sheet import Block
from components.stage import var
from components.traces import samples, trace
from physics.coupled import FreeModes, Motion, TwoMassChain, free_modes
from physics.energy import chain_energy, mean_energy
from physics.sampling import drawable, time_window


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
        return coupled_sheet()

    def picture(self) -> Picture:
        system = TwoMassChain(m1=self.m1, m2=self.m2, k1=self.k1, k2=self.k2)
        free = free_modes(system, (self.x1_0, self.x2_0), (self.v1_0, self.v2_0))
        slow, fast = system.modes().omega
        end = self.window or time_window(slow, fast)
        t = np.linspace(0.0, end, samples(end, fast))
        parts = free.parts(t)
        curves, bands = _motion_columns(free, parts)
        stack, flat = _energy_columns(self.energy, free, parts)
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


def _motion_columns(free: FreeModes, parts: tuple[Motion, Motion]) -> tuple[Columns, Columns]:
    """Columns of x1, x2, their parts, and the elongation of spring 2; curves, and bands where too fast."""
    t, whole = parts[0].t, parts[0] + parts[1]
    curves: Columns = {}
    bands: Columns = {}
    for i in (0, 1):
        drift = free.drift_a[i] + free.drift_b[i] * t
        motions: dict[str, tuple[tuple[int, ...], NDArray[np.float64]]] = {f"x{i + 1}": ((0, 1), whole.x[i])}
        if free.omega[1]:
            motions |= {f"x{i + 1}_{mode}": ((j,), parts[j].x[i]) for j, mode in enumerate(MODES)}
        else:  # two drifts: the slow part has both, as on the stage
            motions[f"x{i + 1}_slow"] = motions[f"x{i + 1}"]
        for name, (modes, exact) in motions.items():
            base = drift if any(free.omega[j] == 0 for j in modes) else None
            curve, band = trace(name, chain.components(free, i, modes), t, base, exact)
            curves |= curve
            bands |= band
    return curves, bands


def _energy_columns(view: str, free: FreeModes, parts: tuple[Motion, Motion]) -> tuple[Columns, Columns]:
    """Columns of the chosen energy view: the stack's edges over time, or the flat lines of the modes."""
    t = parts[0].t
    if view == "modes":
        slow, fast = free.energy
        flat = {"E_slow": slow, "E_fast": fast, "E_total": slow + fast}
        return {}, {"t": t[[0, -1]], **{name: np.full(2, level) for name, level in flat.items()}}
    layers = np.cumsum([np.zeros_like(t), *_energies(free, parts)], axis=0)
    return {f"e{i}": edge for i, edge in enumerate(layers)}, {}


def _energies(free: FreeModes, parts: tuple[Motion, Motion]) -> list[NDArray[np.float64]]:
    """T1, V1, V2, T2; where a swing is too fast to draw, its mean."""
    t = parts[0].t
    energy = chain_energy(free.chain, parts[0] + parts[1]) if drawable(2 * free.omega[1], t) else mean_energy(free, t)
    return [energy.T[0], energy.V[0], energy.V[1], energy.T[1]]


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
    values["beat_period"] = f"{three(2 * math.pi / beat)} s" if beat else "none"
    values["E_total"], values["E_unit"] = energy.number(float(free.energy.sum())), energy.full_unit
    return values


def _forms(scene: Coupled, free: FreeModes) -> dict[str, str]:
    """Which sentence stands: a mode of frequency zero is a drift, and with no spring at all both are."""
    slow, fast = free.omega
    kind = "sine" if slow else ("two" if not fast else "drift" if scene.k2 else "free")
    forms = {"slow_fact": kind, "fast_fact": "sine" if fast else "", scene.energy: "shown"}
    forms |= {"slow_omega": kind if kind in ("sine", "two") else "drift", "fast_omega": "sine" if fast else ""}
    for i in (1, 2):
        forms[f"x{i}_slow"] = "sine" if slow else "drift"
        forms[f"x{i}_fast"] = "sine" if fast else ""
    return forms
