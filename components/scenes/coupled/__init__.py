"""Coupled: the scene in which every free motion of two masses is a slow plus a fast mode (D34, points 1, 2 and 5)."""

from __future__ import annotations

import math
from typing import Self

import numpy as np

from components import chain
from components.chain.forces import Forces, forces
from components.language.state import Frame
from components.layout.controls import Group
from components.quantities.axes import nice_axis, time_axis, whole_axis, widest
from components.quantities.declared import by_name
from components.quantities.motion import pace
from components.quantities.parameters import Values, one_of
from components.quantities.readouts import Readout
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scene.traces import Columns, Floats, bands_over_time, over_time, samples
from components.scenes.coupled import curves, starting
from components.scenes.coupled.about import coupled_about
from components.scenes.coupled.curves import Axes, CoupledCase, Places, Signals
from components.scenes.coupled.numbers import Numbers as N
from components.scenes.coupled.sheet import ENERGY, coupled_sheet
from components.scenes.coupled.watch import WATCH
from components.scenes.coupled.words import VIEWS, Forms
from physics.energy import mean_energy
from physics.sampling import drawable, time_window

BOTH = {
    "m1": 2.0,
    "m2": 1.0,
    "k1": 4.0,
    "k2": 2.0,
    "x1_0": 1.0,
    "x2_0": 0.0,
    "v1_0": 0.0,
    "v2_0": 0.0,
    "given_by": "values",
}


class Coupled(Scene):
    slug = "coupled"
    title = "Coupled"
    lecture = "D34"
    points = "points 1, 2, 5"
    headline = "Every free motion is a slow mode plus a fast mode"
    spoken = {"slow mode": N.omega_minus, "fast mode": N.omega_plus, "energy": N.E_total}
    equations = chain.FREE
    onward = (chain.measured_by(),)
    shares = chain.SHARES
    watch = WATCH
    presets = {
        "Both": BOTH,
        "Slow": {**BOTH, "x1_0": 0.4, "x2_0": 0.8},
        "Fast": {**BOTH, "x1_0": 0.7, "x2_0": -0.7},
        "Beats": {**BOTH, "m1": 1.0, "k1": 0.96, "m2": 0.04, "k2": 0.04, "x1_0": 0.2},
        "All equal": {**BOTH, "m1": 1.0, "m2": 1.0, "k1": 1.0, "k2": 1.0},
        "Drift": {**BOTH, "k1": 0.0, "x1_0": 0.3, "v1_0": 0.2, "v2_0": 0.2},
        "Heavy, light": {**BOTH, "m1": 10.0, "m2": 0.1, "k1": 10.0, "k2": 1.0, "x1_0": 0.5},
    }

    m1, m2, k1, k2 = chain.masses_and_springs(2.0, 1.0, 4.0, 2.0)
    x1_0, x2_0 = chain.start_positions(1.0)
    v1_0, v2_0 = chain.start_velocities()
    given_by = one_of("values", starting.GIVEN, "The motion is given by")
    X_slow = starting.amplitude("slow", "−", 1 / 3)
    phi_slow = starting.phase("slow", "−", math.pi / 2)
    X_fast = starting.amplitude("fast", "+", 2 / 3)
    phi_fast = starting.phase("fast", "+", math.pi / 2)
    energy = ENERGY
    view = one_of("modes", VIEWS, "What is shown beside the motion")
    groups = (
        chain.chain_group(m1, m2, k1, k2),
        Group("Start", (x1_0, x2_0)),
        Group("", (X_slow, phi_slow, X_fast, phi_fast), form=Forms.start["modes"], apart=True),
        Group("", (v1_0, v2_0, given_by), "Start velocities, or modes", folded=True),
        Group("Shown", (view,)),
    )

    sheet = staticmethod(coupled_sheet)

    def picture(self, frame: Frame = FITTED) -> Picture:
        case = CoupledCase(starting.motion(self), self.given_by, self.energy, self.view)
        free = case.free
        slow, fast = free.chain.modes().omega.tolist()
        own_window = self.window or time_window(slow, fast)
        t = np.linspace(0.0, end := frame.window or own_window, samples(end, fast))
        resolved = drawable(fast, t)
        lines, bands = (chain.positions(free, t), Columns()) if resolved else curves.traced_motion(free, t)
        extremes = chain.extremes(lines, bands)
        own = nice_axis(*widest(extremes["x1"], extremes["x2"]), "m", 3)
        energy = whole_axis(case.levels["total"], "J")
        axes = framed(frame, by_name({Axes.t: time_axis(own_window), Axes.x: own, Axes.E: energy}))
        size, time = Axes.x(axes), Axes.t(axes)
        drawn = chain.to_scale(free.chain, extremes, size, frame.scale)
        pulled = forces(free.chain, free.motion(t), size) if self.view == "forces" else Forces()
        parts = chain.free_signals(free, size, time) | chain.free_rates(free, size, time)
        parts |= starting.turns(self, free.omega.tolist(), time)
        return Picture(
            columns={
                "time": by_name(curves.edges(mean_energy(free, t))) if case.averaged(t) else {},
                **bands_over_time(t, bands),
                "modes": chain.direction_lines(Places.line, free.chain, 4 * max(abs(size.start), abs(size.end))),
            },
            axes=axes,
            signals=parts | Signals.signals(case, axes) | pulled.signals,
            traces=curves.traces_of(case, t, bands),
            scalars={**drawn.scalars, **curves.places(case, axes), **pulled.scalars},
            pace=pace(slow or fast, fast),
            scale=drawn.scale,
            fits=drawn.fits,
            values={**N.texts(free, axes), **drawn.values, **pulled.values},
            live=pulled.live | Signals.live(axes),
            forms=Forms.forms(case),
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


def _notes(fast: float, t: Floats) -> list[str]:
    if drawable(2 * fast, t):
        return []
    band = "" if drawable(fast, t) else "The fast motion is too fast for a line and fills the band that is drawn. "
    return [f"{band}Energies are averages over a fast swing."]
