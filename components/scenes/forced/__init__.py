"""Forced: the scene of two masses, one of which is driven at a frequency that you choose (D34, points 6 to 8)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from components import chain
from components.chain.forces import Forces
from components.language.state import Frame
from components.layout.controls import Group
from components.layout.views import View, parts
from components.quantities.axes import Axis, nice_axis, time_axis, widest
from components.quantities.declared import by_name
from components.quantities.motion import pace, scaled
from components.quantities.parameters import Values, angular_frequency, force
from components.quantities.readouts import Readout, SceneNumber
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scene.traces import Columns, Floats, Traces, bands_over_time, samples
from components.scenes.forced.about import damped_about, forced_about
from components.scenes.forced.case import Axes, Signals, Work
from components.scenes.forced.damped_case import DampedForcedCase
from components.scenes.forced.driven import Undamped
from components.scenes.forced.numbers import AnyCase
from components.scenes.forced.numbers import Numbers as N
from components.scenes.forced.response import response
from components.scenes.forced.sheet import CURVE, ENERGY, SCALE, UNITS, forced_sheet
from components.scenes.forced.watch import WATCH
from components.scenes.forced.words import Forms, notes
from physics.forced import driven_modes, steady_start
from physics.particular import at_natural_frequency
from physics.sampling import time_window
from physics.transient import DampedModes

SLOW, FAST = (5**0.5 - 1) / 2, (5**0.5 + 1) / 2
"""The natural frequencies of the lecture's chain of equal masses and springs, in units of sqrt(k/m)."""

PARTS = 4.0
"""The parts of a displacement are drawn completely if they are less than this many times as large as their sum."""

STARTS = ("rest", "From rest"), ("steady", "On the particular solution")

EQUAL = {
    "F_0": 1.0,
    "omega": 0.8,
    **dict.fromkeys(("m1", "m2", "k1", "k2"), 1.0),
    **dict.fromkeys(("c1", "c2", "x1_0", "x2_0", "v1_0", "v2_0"), 0.0),
}


class Forced(Scene):
    slug = "forced"
    title = "Forced"
    lecture = "D34"
    points = "points 6 to 8"
    headline = "How far the masses swing depends on how fast you push"
    spoken = {"particular amplitude of mass 1": N.Xp[1], "of mass 2": N.Xp[2]}
    equations = chain.BRAKED_DRIVEN
    onward = (chain.measured_by("F_0", "omega"),)
    shares = chain.BRAKED
    watch = WATCH
    presets = {
        "All equal": EQUAL,
        "At slow": {**EQUAL, "omega": SLOW},
        "At fast": {**EQUAL, "omega": FAST},
        "Still mass 1": {**EQUAL, "omega": 1.0, "v2_0": -1.0},
        "Light mass 2": {**EQUAL, "m1": 2.0, "k1": 2.0, "m2": 0.1, "k2": 0.1, "omega": 0.9},
        "Damped": {**EQUAL, "omega": SLOW, "c1": 0.5, "c2": 0.5},
    }

    F_0 = force(1.0)
    omega = angular_frequency(
        0.8, softbounds=(0.0, 2.5 * FAST), says="is the drive frequency. Type any value from 0 up."
    )
    m1, m2, k1, k2 = chain.masses_and_springs(1.0, 1.0, 1.0, 1.0, first="that is pushed")
    c1, c2 = chain.dashpots()
    x1_0, x2_0 = chain.start_positions()
    v1_0, v2_0 = chain.start_velocities()
    curve, axes, scale = CURVE, UNITS, SCALE
    views = (
        View(
            "Response",
            "Drag the drive *ω*: where is the swing *x*_1 of mass 1 largest, where zero, when against the push *F*?",
            keys=(omega,), names=("stage", "plot:response"),
        ),
        View(
            "Motion", "Change *ω*: without friction, does the motion ever become one pure swing?",
            keys=(omega,), names=("stage", "plot:x1", "plot:x2"),
        ),
        View(
            "Forces", "Watch the arrows: when do push and spring 2 cancel on mass 1?",
            keys=(omega,), names=("stage", "plot:x1", "plot:x2"),
        ),
        View(
            "Work", "Change *ω*: what does the drive give the masses, and does it ever take it back?",
            keys=(omega,), names=("stage", "plot:energy"),
        ),
        View(
            "Bode", "Drag *ω*: where does each mass lag by a quarter turn, and which lag falls again?",
            keys=(omega,), names=("plot:response", "plot:lag"),
        ),
        View(
            "Nyquist", "Drag *ω* round the loops: where does the push do most work?",
            keys=(omega,), names=("plot:nyquist",),
        ),
        View(
            "Formulas", "Change *ω*, and watch the numbers in each formula.",
            keys=(omega,), names=("stage", "words:solution"),
        ),
    )  # fmt: skip
    old_views = {"view": {"amplitudes": "response"}}
    groups = (
        Group("Drive", (F_0, omega)),
        chain.chain_group(m1, m2, k1, k2),
        chain.dashpots_group(c1, c2),
        Group("", (x1_0, x2_0, v1_0, v2_0), "Start", STARTS, folded=True),
    )

    sheet = staticmethod(forced_sheet)

    def action(self, name: str) -> Values:
        if name == "rest":
            return dict.fromkeys(chain.START, 0.0)
        case = self._case()
        if isinstance(case, DampedForcedCase):
            one, two = case.X
            start = (one.imag, two.imag, *(scaled(0, self.omega, X.real) for X in (one, two)))
            return dict(zip(chain.START, start, strict=True))
        if case.modes.at_resonance:
            raise at_natural_frequency(self.omega)
        x_0, v_0 = steady_start(case.chain, self.F_0, self.omega)
        return dict(zip(chain.START, (*x_0, *v_0), strict=True))

    def picture(self, frame: Frame = FITTED) -> Picture:
        return self.picture_of(frozenset(parts(self.sheet())), frame)

    def picture_of(self, names: frozenset[str], frame: Frame) -> Picture:
        case = self._case(frame)
        slow, fast = case.natural
        t = np.linspace(0.0, case.end, samples(case.end, case.fastest))
        curves, bands = case.columns(t)
        limit = {"limit": Traces(case.end, t.size, tuple(by_name(case.limits)), case.limiting)} if case.limits else {}
        extremes = chain.extremes(curves, bands)
        work = case.energies(t, ENERGY.part in names)
        shown = self.scale if case.view == "bode" else self.curve
        swing = response(case, shown, self.axes == "lecture" and case.comparable, frame, names)
        window = time_axis(self.window or time_window(slow, fast))
        x = nice_axis(*_span(extremes, curves), "m", 2)
        own = by_name({Axes.t: window, Axes.x: x, Axes.E: _energy_axis(case, work)})
        axes, push = framed(frame, own) | swing.axes, nice_axis(0.0, self.F_0 or 1.0, "N")
        size, time, counted = Axes.x(axes), Axes.t(axes), axes | by_name({Axes.F: push})
        drawn = chain.to_scale(case.chain, extremes, size, frame.scale)
        pushed = case.forces(t, size, time) if case.view == "forces" else Forces()
        dashpots = chain.Has.scalars(chain.damping_of(self), axes)
        return Picture(
            columns={**bands_over_time(t, bands), "energy": {"t": t, **by_name(work)} if work else {}, **swing.columns},
            axes=axes,
            signals=case.signals(size, time, push) | pushed.signals,
            traces={"time": _traces(case, t.size, tuple(curves)), **limit},
            tables=swing.tables,
            scalars={**drawn.scalars, **swing.scalars, **pushed.scalars, **dashpots},
            pace=pace(slow or fast or self.omega, case.fastest),
            scale=drawn.scale,
            fits=drawn.fits,
            values=N.texts(case, counted) | drawn.values | pushed.values,
            live=Signals.live(counted) | pushed.live,
            forms=Forms.forms(case),
            notes=tuple(notes(case, self.axes, shown, case.view == "work" and not work)),
            to_scale=drawn.to_scale,
            spans={"omega": (0.0, 2.5 * fast if fast else 5.0)},
        )

    @property
    def numbers(self) -> dict[str, SceneNumber]:
        return N.numbers(replace(self._case(), view="nyquist"))  # the view with the work of a cycle

    def readouts(self) -> tuple[Readout, ...]:
        return N.readouts(self._case())

    def about(self, shown: Picture) -> About:
        case = self._case()
        if isinstance(case, DampedForcedCase):
            return damped_about(shown, case.modes)
        return forced_about(shown, case.modes, *chain.start_of(self))

    def _case(self, frame: Frame = FITTED) -> AnyCase:
        system, (c1, c2), (x_0, v_0) = chain.of_scene(self), chain.damping_of(self), chain.start_of(self)
        end = frame.window or self.window or time_window(*system.modes().omega.tolist())
        if c1 or c2:
            drive = {"F_0": self.F_0, "omega": self.omega}
            return DampedForcedCase(DampedModes(chain=system, c=c2, c1=c1, x_0=x_0, v_0=v_0, **drive), end, self.view)
        return Undamped(driven_modes(system, self.F_0, self.omega, x_0, v_0), end, self.view)


def _traces(case: AnyCase, count: int, drawn: tuple[str, ...]) -> Traces:
    return Traces(case.end, count, drawn, case.exact, fastest=case.fastest, moving=case.moving)


def _span(extremes: chain.Extremes, curves: Columns) -> tuple[float, float]:
    """The range of x(t): the motion, and its parts unless the motion vanishes next to them."""
    motion = widest(extremes["x1"], extremes["x2"])
    parts = [(float(c.min()), float(c.max())) for name, c in curves.items() if name not in extremes]
    whole = widest(motion, *parts)
    return whole if whole[1] - whole[0] < PARTS * (motion[1] - motion[0]) or motion[0] == motion[1] else motion


def _energy_axis(case: AnyCase, work: Mapping[Any, Floats]) -> Axis:
    """The axis of the energies. Without dashpots the work is the gain, so that it is not needed."""
    spanned = [c for column, c in work.items() if column is not Work.work or isinstance(case, DampedForcedCase)]
    if not spanned:
        return Axis(0, 1, "J")
    return nice_axis(*widest(*((float(c.min()), float(c.max())) for c in spanned)), "J", 2)
