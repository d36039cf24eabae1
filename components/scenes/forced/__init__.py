"""Forced: the scene of two masses, one of which is pushed at a frequency of choice (D34, points 6 to 8)."""

from __future__ import annotations

from functools import cache

import numpy as np

from components import chain
from components.chain.forces import Forces, forces
from components.language.blocks import Block
from components.language.picture import Digits
from components.language.state import Frame
from components.layout.controls import Group
from components.quantities.axes import Axis, nice_axis, time_axis, widest
from components.quantities.motion import pace, scaled
from components.quantities.parameters import Values, angular_frequency, force, one_of
from components.quantities.readouts import Readout
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scene.traces import Columns, Floats, Traces, bands_over_time, samples
from components.scenes.forced.about import dying_about, forced_about
from components.scenes.forced.driven import energy_columns, limits, motion_columns, motion_signals, motions
from components.scenes.forced.dying import Dying
from components.scenes.forced.response import dying_response, response_curves
from components.scenes.forced.sheet import forced_sheet
from components.scenes.forced.watch import WATCH
from components.scenes.forced.words import dying_forms, dying_notes, dying_values, forms, notes, sizes, values
from physics.forced import DrivenModes, driven_modes, steady_start
from physics.particular import at_natural_frequency
from physics.sampling import drawable, time_window
from physics.transient import DampedModes

SLOW, FAST = (5**0.5 - 1) / 2, (5**0.5 + 1) / 2
"""The natural frequencies of the lecture's chain of equal masses and springs, in units of sqrt(k/m)."""

PARTS = 4.0
"""The parts are drawn whole while they are less than this many times as large as their sum."""


class Forced(Scene):
    slug = "forced"
    title = "Forced"
    lecture = "D34"
    points = "points 6 to 8"
    headline = "How far the masses swing depends on how fast you push"
    spoken = {"particular amplitude of mass 1": "{Xp1} m", "of mass 2": "{Xp2} m"}
    equations = chain.BRAKED_DRIVEN
    groups = (
        Group("Drive", ("F_0", "omega")),
        chain.CHAIN,
        chain.DASHPOTS,
        Group(
            "",
            chain.START.names,
            "Start",
            actions=(("rest", "From rest"), ("steady", "On the particular solution")),
            folded=True,
        ),
        Group("Shown", ("view",)),
    )
    onward = (chain.measured_by("F_0", "omega"),)
    shares = chain.BRAKED
    watch = WATCH
    presets = {
        "All equal": {},
        "At slow": {"omega": SLOW},
        "At fast": {"omega": FAST},
        "Still mass 1": {"omega": 1.0, "v2_0": -1.0},
        "Light mass 2": {"m1": 2.0, "k1": 2.0, "m2": 0.1, "k2": 0.1, "omega": 0.9},
        "Damped": {"omega": SLOW, "c1": 0.5, "c2": 0.5},
    }

    F_0 = force(1.0)
    omega = angular_frequency(
        0.8, softbounds=(0.0, 2.5 * FAST), says="is the drive frequency. Type any value from 0 up."
    )
    m1, m2, k1, k2 = chain.masses_and_springs(1.0, 1.0, 1.0, 1.0, first="that is pushed")
    c1, c2 = chain.dashpots()
    x1_0, x2_0 = chain.start_positions()
    v1_0, v2_0 = chain.start_velocities()
    curve = one_of(default="size", objects=["size", "signed", "log"], label="Response shown as")
    axes = one_of(default="si", objects=["si", "lecture"], label="Units of the response")
    view = one_of(
        default="amplitudes",
        objects={"Amplitudes": "amplitudes", "Forces": "forces", "Work": "work"},
        label="What is shown beside the motion",
    )

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return forced_sheet()

    def action(self, name: str) -> Values:
        if name == "rest":
            return dict.fromkeys(chain.START.names, 0.0)
        if any(chain.damping_of(self)):
            one, two, _ = self._braked().particular.tolist()
            start = (one.imag, two.imag, *(scaled(0, self.omega, X.real) for X in (one, two)))
            return dict(zip(chain.START.names, start, strict=True))
        system = chain.of_scene(self)
        if driven_modes(system, self.F_0, self.omega).at_resonance:
            raise at_natural_frequency(self.omega)
        x_0, v_0 = steady_start(system, self.F_0, self.omega)
        return dict(zip(chain.START.names, (*x_0, *v_0), strict=True))

    def picture(self, frame: Frame = FITTED) -> Picture:
        if any(chain.damping_of(self)):
            return self._dying_picture(frame)
        driven = self._driven()
        slow, fast = driven.free.omega.tolist()
        own_window = self.window or time_window(slow, fast)
        end = frame.window or own_window
        fastest = max(fast, self.omega)
        t = np.linspace(0.0, end, samples(end, fastest))
        resolved = drawable(fastest, t)
        curves, bands = (motions(driven, t), Columns()) if resolved else motion_columns(driven, t)
        extremes, limit = chain.extremes(curves, bands), limits(driven, end)
        work = energy_columns(driven, t) if self.view == "work" and drawable(2 * fastest, t) else {}
        lecture = self.axes == "lecture" and self.k1 > 0 and self.F_0 > 0
        swing = response_curves(driven, self.curve, lecture, frame)
        own = {"t": time_axis(own_window), "x": nice_axis(*_span(extremes, curves), "m", 2), "E": _energy_axis(work)}
        axes, push = framed(frame, own) | swing.axes, nice_axis(0.0, self.F_0 or 1.0, "N")
        size = axes["x"]
        drawn = chain.to_scale(driven.free.chain, extremes, size, frame.scale)
        pushed = self._forces(driven, t, size)
        return Picture(
            columns={**bands_over_time(t, bands), "energy": work and {"t": t, **work}, **swing.columns},
            axes=axes,
            signals=motion_signals(driven, size, axes["t"], push)
            | {name: limit[name].signal(size, axes["t"]) for name in limit}
            | pushed.signals,
            traces={
                "time": Traces(end, t.size, tuple(curves), lambda t: motion_columns(driven, t)[0]),
                "limit": Traces(end, t.size, tuple(limit), lambda t: {name: limit[name].at(t) for name in limit}),
            },
            scalars={**drawn.scalars, **swing.scalars, **pushed.scalars},
            pace=pace(slow or fast or self.omega, fastest),
            scale=drawn.scale,
            fits=drawn.fits,
            values={**values(driven), **swing.values, **drawn.values, **pushed.values, "F_unit": push.full_unit},
            live={**_digits(size, push), **pushed.live},
            forms=forms(driven, limit.keys(), self.view),
            notes=(*drawn.notes, *notes(driven, self.axes, lecture, self.view == "work" and not work)),
            spans={"omega": (0.0, 2.5 * fast if fast else 5.0)},
        )

    def _dying_picture(self, frame: Frame) -> Picture:
        system, modes = chain.of_scene(self), self._braked()
        slow, fast = system.modes().omega.tolist()
        own_window = self.window or time_window(slow, fast)
        dying = Dying(modes, frame.window or own_window)
        t = np.linspace(0.0, dying.end, samples(dying.end, dying.fastest))
        curves, bands = dying.columns(t)
        extremes = chain.extremes(curves, bands)
        work = dying.energy(t) if self.view == "work" and drawable(2 * dying.fastest, t) else {}
        lecture = self.axes == "lecture" and self.k1 > 0 and self.F_0 > 0
        swing = dying_response(dying, self.curve, lecture, frame)
        own = {"t": time_axis(own_window), "x": nice_axis(*_span(extremes, curves), "m", 2), "E": _energy_axis(work)}
        axes, push = framed(frame, own) | swing.axes, nice_axis(0.0, self.F_0 or 1.0, "N")
        size = axes["x"]
        drawn = chain.to_scale(system, extremes, size, frame.scale)
        pushed = dying.forces(t, size, axes["t"]) if self.view == "forces" else Forces()
        dashpots = {f"dashpot{i}": 1.0 for i, c in enumerate(chain.damping_of(self), start=1) if c}
        signed = self.curve == "signed"
        return Picture(
            columns={**bands_over_time(t, bands), "energy": work and {"t": t, **work}, **swing.columns},
            axes=axes,
            signals=dying.signals(size, axes["t"], push) | pushed.signals,
            traces={"time": Traces(dying.end, t.size, tuple(curves), dying.exact)},
            scalars={**drawn.scalars, **swing.scalars, **pushed.scalars, **dashpots},
            pace=pace(slow or fast or self.omega, dying.fastest),
            scale=drawn.scale,
            fits=drawn.fits,
            values={**dying_values(dying), **swing.values, **drawn.values, **pushed.values, "F_unit": push.full_unit},
            live={**_digits(size, push), **pushed.live},
            forms=dying_forms(dying, self.view),
            notes=(*drawn.notes, *dying_notes(dying, self.axes, lecture, signed, self.view == "work" and not work)),
            spans={"omega": (0.0, 2.5 * fast if fast else 5.0)},
        )

    def readouts(self) -> tuple[Readout, ...]:
        driven = self._driven()
        swings = np.abs(self._braked().particular[:2]) if any(chain.damping_of(self)) else sizes(driven)
        amplitudes = [Readout(f"Xp{i}", f"X_{{p{i}}}", float(X), "m", f"m{i}") for i, X in enumerate(swings, start=1)]
        return (*amplitudes, *chain.mode_readouts(driven.chain, "omega_{sign} mark_{sign}", "ratio_{sign}"))

    def about(self, shown: Picture) -> About:
        if any(chain.damping_of(self)):
            return dying_about(shown, self._braked())
        return forced_about(shown, self._driven(), *chain.start_of(self))

    def _driven(self) -> DrivenModes:
        return driven_modes(chain.of_scene(self), self.F_0, self.omega, *chain.start_of(self))

    def _braked(self) -> DampedModes:
        (c1, c2), (x_0, v_0) = chain.damping_of(self), chain.start_of(self)
        return DampedModes(
            chain=chain.of_scene(self), c=c2, c1=c1, F_0=self.F_0, omega=self.omega, x_0=x_0, v_0=v_0
        )  # fmt: skip

    def _forces(self, driven: DrivenModes, t: Floats, size: Axis) -> Forces:
        if self.view != "forces":
            return Forces()
        return forces(driven.chain, driven.motion(t), size, self.F_0, self.omega)


def _digits(size: Axis, push: Axis) -> dict[str, Digits]:
    """The digits of the numbers that change with the clock: both displacements and the force."""
    return {"x1": size.digits(signed=True), "x2": size.digits(signed=True), "force_now": push.digits(signed=True)}


def _span(extremes: chain.Extremes, curves: Columns) -> tuple[float, float]:
    """The range of x(t): the motion, and its parts as long as it does not vanish beside them."""
    motion = widest(extremes["x1"], extremes["x2"])
    parts = [(float(c.min()), float(c.max())) for name, c in curves.items() if "_" in name]
    whole = widest(motion, *parts)
    return whole if whole[1] - whole[0] < PARTS * (motion[1] - motion[0]) or motion[0] == motion[1] else motion


def _energy_axis(work: Columns) -> Axis:
    if not work:
        return Axis(0, 1, "J")
    return nice_axis(*widest(*((float(c.min()), float(c.max())) for c in work.values())), "J", 2)
