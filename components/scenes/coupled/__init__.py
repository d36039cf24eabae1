"""Coupled: the scene in which every free motion of two masses is a slow plus a fast mode (D34, points 1, 2 and 5)."""

from __future__ import annotations

import math
from functools import cache
from itertools import accumulate
from typing import Self

import numpy as np
from numpy.typing import NDArray

from components import chain
from components.chain.forces import Forces, forces
from components.chain.grabs import shares
from components.language.blocks import Block
from components.language.numbers import var
from components.language.signals import AnySignal
from components.language.state import Frame
from components.layout.controls import Group
from components.quantities.axes import Axis, nice_axis, time_axis, whole_axis, widest
from components.quantities.motion import derived, pace, scaled, total
from components.quantities.parameters import Values, one_of
from components.quantities.readouts import Readout
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scene.traces import Columns, Floats, bands_over_time, over_time, samples, trace
from components.scenes.coupled import starting
from components.scenes.coupled.about import coupled_about
from components.scenes.coupled.numbers import Numbers as N
from components.scenes.coupled.sheet import coupled_sheet
from components.scenes.coupled.watch import WATCH
from components.scenes.coupled.words import forms
from physics.coupled import FreeModes
from physics.energy import ChainEnergy, chain_energy, mean_energy
from physics.sampling import drawable, time_window

LAYERS = ("e0", "e1", "e2", "e3", "e4")
"""The edges of the stack of energies."""
LEVELS = ("E_slow", "E_fast", "E_total")
"""The energies of the modes and their sum, which stay as they are."""
NAMED = 0.8
"""The names in the plane stand at this share of the way to its edge."""


class Coupled(Scene):
    slug = "coupled"
    title = "Coupled"
    lecture = "D34"
    points = "points 1, 2, 5"
    headline = "Every free motion is a slow mode plus a fast mode"
    spoken = {"slow mode": N.omega_minus, "fast mode": N.omega_plus, "energy": N.E_total}
    equations = chain.FREE
    groups = (
        chain.CHAIN,
        Group("Start", ("x1_0", "x2_0")),
        Group("", starting.BY_MODES, form="start_modes", apart=True),
        Group("", ("v1_0", "v2_0", "given_by"), "Start velocities, or modes", folded=True),
        Group("Shown", ("view",)),
    )
    onward = (chain.measured_by(),)
    shares = chain.SHARES
    watch = WATCH
    presets = {
        "Both": {"given_by": "values"},
        "Slow": {"x1_0": 0.4, "x2_0": 0.8},
        "Fast": {"x1_0": 0.7, "x2_0": -0.7},
        "Beats": {"m1": 1.0, "k1": 0.96, "m2": 0.04, "k2": 0.04, "x1_0": 0.2},
        "All equal": {"m1": 1.0, "m2": 1.0, "k1": 1.0, "k2": 1.0},
        "Drift": {"k1": 0.0, "x1_0": 0.3, "v1_0": 0.2, "v2_0": 0.2},
        "Heavy, light": {"m1": 10.0, "m2": 0.1, "k1": 10.0, "k2": 1.0, "x1_0": 0.5},
    }

    m1, m2, k1, k2 = chain.masses_and_springs(2.0, 1.0, 4.0, 2.0)
    x1_0, x2_0 = chain.start_positions(1.0)
    v1_0, v2_0 = chain.start_velocities()
    given_by = one_of(
        default="values", objects={"Starting values": "values", "Modes": "modes"}, label="The motion is given by"
    )
    X_slow = starting.amplitude("slow", "−", 1 / 3)
    phi_slow = starting.phase("slow", "−", math.pi / 2)
    X_fast = starting.amplitude("fast", "+", 2 / 3)
    phi_fast = starting.phase("fast", "+", math.pi / 2)
    energy = one_of(default="parts", objects=["parts", "modes"], label="Energy of")
    view = one_of(
        default="modes",
        objects={"Modes": "modes", "Constants": "constants", "Forces": "forces"},
        label="What is shown beside the motion",
    )

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return coupled_sheet()

    def picture(self, frame: Frame = FITTED) -> Picture:
        free = starting.motion(self)
        system = free.chain
        slow, fast = system.modes().omega.tolist()
        own_window = self.window or time_window(slow, fast)
        t = np.linspace(0.0, end := frame.window or own_window, samples(end, fast))
        resolved = drawable(fast, t)
        curves, bands = (chain.positions(free, t), Columns()) if resolved else _motion_columns(free, t)
        extremes = chain.extremes(curves, bands)
        own = nice_axis(*widest(extremes["x1"], extremes["x2"]), "m", 3)
        axes = framed(frame, {"t": time_axis(own_window), "x": own, "E": whole_axis(float(free.energy.sum()), "J")})
        size, energy = axes["x"], axes["E"]
        drawn = chain.to_scale(system, extremes, size, frame.scale)
        standing = (self.energy, f"view_{self.view}", f"start_{self.given_by}")
        pulled = forces(system, free.motion(t), size) if self.view == "forces" else Forces()
        averaged = self.energy == "parts" and not drawable(2 * fast, t)
        energies = () if averaged else LAYERS if self.energy == "parts" else LEVELS
        names = (*(_motions(free) if resolved else curves), *energies)
        return Picture(
            columns={
                "time": _edges(mean_energy(free, t)) if averaged else {},
                **bands_over_time(t, bands),
                "modes": _mode_lines(free, size),
            },
            axes=axes,
            signals=_signals(self, free, size, axes["t"], energy) | pulled.signals,
            traces=over_time(end, fast, names, lambda t: _exact(free, t)),
            scalars={**drawn.scalars, **_mode_places(free, size), f"by_{self.given_by}": 1.0, **pulled.scalars},
            pace=pace(slow or fast, fast),
            scale=drawn.scale,
            fits=drawn.fits,
            values={**N.texts(free, axes), **drawn.values, **pulled.values},
            live={
                **pulled.live,
                **{name: size.digits(signed=True) for name in ("x1", "x2")},
                **{name: energy.digits() for name in ("T1", "V1", "V2", "T2")},
            },
            forms={**forms(free), **dict.fromkeys(standing, "shown")},
            notes=(*drawn.notes, *_notes(fast, t)),
        )

    def readouts(self) -> tuple[Readout, ...]:
        return N.readouts(starting.motion(self))

    def following(self, changed: frozenset[str], before: Self | None, *, in_hand: bool) -> Values:
        if before is None:
            return starting.opened(self)
        return starting.followed(self, changed, before.given_by, in_hand=in_hand)

    def about(self, shown: Picture) -> About:
        by_modes = starting.by_modes(self) if self.given_by == "modes" else None
        return coupled_about(shown, starting.motion(self), *chain.start_of(self), by_modes)


def _exact(free: FreeModes, t: Floats) -> Columns:
    """All that may be drawn over time."""
    curves, _ = _motion_columns(free, t)
    energies = zip(LEVELS, (*free.energy, free.energy.sum()), strict=True)
    levels = {name: np.full_like(t, level) for name, level in energies}
    return {**curves, **_edges(chain_energy(free.chain, free.motion(t))), **levels}


def _motions(free: FreeModes) -> tuple[str, ...]:
    """The names of x1, x2 and their parts; of two drifts the slow part has both, as on the stage."""
    parts = ("", "_slow", "_fast") if free.omega[1] else ("", "_slow")
    return tuple(f"x{i}{part}" for i in (1, 2) for part in parts)


def _motion_columns(free: FreeModes, t: Floats) -> tuple[Columns, Columns]:
    """Columns of x1, x2 and their parts: curves, and bands where too fast."""
    parts = free.parts(t)
    whole = parts[0] + parts[1]
    exact = {"": whole, "_slow": parts[0] if free.omega[1] else whole, "_fast": parts[1]}
    modes = {"": (0, 1), "_slow": (0,) if free.omega[1] else (0, 1), "_fast": (1,)}
    curves: Columns = {}
    bands: Columns = {}
    for name in _motions(free):
        i, part = int(name[1]) - 1, name[2:]
        drifts = any(free.omega[j] == 0 for j in modes[part])
        base = free.drift_a[i] + free.drift_b[i] * t if drifts else None
        curve, band = trace(name, chain.components(free, i, modes[part]), t, base, exact[part].x[i])
        curves |= curve
        bands |= band
    return curves, bands


def _edges(energy: ChainEnergy) -> Columns:
    """The edges of the stack of T1, V1, V2, T2."""
    layers = [energy.T[0], energy.V[0], energy.V[1], energy.T[1]]
    return dict(zip(LAYERS, accumulate([np.zeros_like(layers[0]), *layers]), strict=True))


def _notes(fast: float, t: NDArray[np.float64]) -> list[str]:
    if drawable(2 * fast, t):
        return []
    band = "" if drawable(fast, t) else "The fast motion is too fast for a line and fills the band that is drawn. "
    return [f"{band}Energies are averages over a fast swing."]


def _mode_lines(free: FreeModes, size: Axis) -> Columns:
    """Both mode directions of the (x1, x2) plane, as far as the frame and beyond."""
    return chain.direction_lines(free.chain, 4 * max(abs(size.start), abs(size.end)))


def _mode_places(free: FreeModes, size: Axis) -> dict[str, float]:
    """Where the names of the directions stand, the slow one's at its upper end, the fast one's at its lower end; and
    how a mode is taken in hand, where there is a fast one."""
    end = NAMED * size.place(min(-size.start, size.end))
    scalars: dict[str, float] = {}
    for mode, (one, two) in zip(chain.MODES, chain.directions(free.chain), strict=True):
        scalars |= {f"{mode}_name1": end * one, f"{mode}_name2": end * two}
    return scalars | shares(free.chain) if free.omega[1] else scalars


def _signals(scene: Coupled, free: FreeModes, size: Axis, time: Axis, energy: Axis) -> dict[str, AnySignal]:
    """The parts of each displacement and velocity, their sums, and the energies: stacked, or those of the modes."""
    signals = chain.free_signals(free, size, time) | chain.free_rates(free, size, time)
    for name in ("x1", "x2", "v1", "v2"):
        signals[name] = total(f"{name}_slow", f"{name}_fast")
    signals |= starting.turns(scene, free.omega.tolist(), time)
    signals["stretch"] = derived(var("x2") - var("x1"))
    kinetic, potential = energy.exponent - 2 * size.exponent + 2 * time.exponent, energy.exponent - 2 * size.exponent
    for name, factor, rate in (("T1", scene.m1, "v1"), ("T2", scene.m2, "v2")):
        signals[name] = derived(scaled(kinetic, 0.5, factor) * var(rate) * var(rate))
    for name, factor, stretch in (("V1", scene.k1, "x1"), ("V2", scene.k2, "stretch")):
        signals[name] = derived(scaled(potential, 0.5, factor) * var(stretch) * var(stretch))
    layers = ("T1", "V1", "V2", "T2")
    if scene.energy == "parts":
        return signals | {edge: total(*layers[:i]) for i, edge in enumerate(LAYERS)}
    levels = (*free.energy.tolist(), float(free.energy.sum()))
    return signals | {name: derived(energy.place(level)) for name, level in zip(LEVELS, levels, strict=True)}
