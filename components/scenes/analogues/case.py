"""One system as the scene of the analogues shows it: released at rest, beside the spring of equal numbers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache, cached_property
from typing import NamedTuple

import numpy as np
from msgspec.structs import replace

from components.quantities.axes import Axis, nice_axis
from components.quantities.numbers import MINUS, short
from components.scene.frames import Windowed
from components.scene.traces import Columns, Floats, samples, trace
from physics.analogue import Analogue, Tuned
from physics.oscillator import Oscillator
from physics.pendulum import Pendulum, PendulumMotion, amplitude_at_excess, excess
from physics.sampling import Sinusoid, drawable, periods
from physics.valid import DOUBLES

CURVES = ("x", "q")
"""The curves over time: of the spring, and of the system."""
DEGREE = math.pi / 180
SWINGS = 3.5
NODES, MOST_NODES = 96, 512
"""Points of a small swing that the browser joins, and of the largest."""
TINY = 1e-9
"""rad; smaller swings have this one's shape to the last digit."""
LIMITS = {"late_01": 0.001, "late_1": 0.01, "late_5": 0.05}
"""Excesses T/T_0 - 1 that have a flag, by the scalar that places it."""


class Swings(NamedTuple):
    """A pendulum's angle and rate over one period, and the size of its swing."""

    theta: Floats
    theta_dot: Floats
    size: float


@dataclass(frozen=True, kw_only=True)
class AnalogueCase(Windowed):
    """The chosen system, released at rest from q_0 (SI, rad), and the spring and mass of equal numbers."""

    system: Analogue
    p: dict[str, float]
    q_0: float

    @cached_property
    def tuned(self) -> Tuned:
        return self.system.at(self.p)

    @cached_property
    def spring(self) -> Oscillator:
        return Oscillator(m=self.tuned.inertia, k=self.tuned.stiffness)

    @cached_property
    def omega(self) -> float:
        return self.tuned.omega_n

    @cached_property
    def pendulum(self) -> Pendulum | None:
        return self.tuned.pendulum

    @cached_property
    def excess(self) -> float:
        """T/T_0 - 1; 0 for what is linear."""
        return excess(self.q_0) if self.pendulum else 0.0

    @cached_property
    def period(self) -> float:
        """ValueError where it leaves the range of doubles."""
        period = self.pendulum.period(self.q_0) if self.pendulum else self.spring.period
        if math.isinf(period):
            raise ValueError(f"the period leaves {DOUBLES}")
        return period

    @cached_property
    def lasting(self) -> float:
        return periods(2 * math.pi / self.period, SWINGS)

    @cached_property
    def t(self) -> Floats:
        """The times of the window."""
        return np.linspace(0.0, self.end, samples(self.end, self.omega))

    @cached_property
    def energy(self) -> float:
        """T + V in J of the linear system."""
        return self.tuned.energy(self.q_0)

    @property
    def exact_energy(self) -> float:
        """T + V in J at any angle."""
        return self.tuned.exact_energy(self.q_0)

    @cached_property
    def swings(self) -> Swings:
        """One swing of a pendulum, which the clock repeats."""
        count = min(math.ceil(NODES * (1 + self.excess)), MOST_NODES)
        motion, size = self.swing(np.linspace(0.0, self.period, count + 1))
        return Swings(motion.theta, motion.theta_dot, size)

    def exact(self, t: Floats) -> Columns:
        """The coordinate q, and that of the spring, x."""
        x = self.spring.motion(self.q_0, 0.0, t).x
        if not self.pendulum:
            return {"x": x, "q": x}
        motion, size = self.swing(t)
        return {"x": x, "q": motion.theta * (self.q_0 / size)}

    def swing(self, t: Floats) -> tuple[PendulumMotion, float]:
        """The exact motion, and its size: that of q_0, or a small one of the same shape."""
        size = math.copysign(max(abs(self.q_0), TINY), self.q_0)
        if self.pendulum is None:
            raise TypeError(f"{self.system.name} is linear: its motion is that of the spring")
        return self.pendulum.motion(size, t), size

    def axis(self) -> Axis:
        """The axis of the coordinate, with ticks at the amplitude; angles of pendulums in degrees."""
        unit, factor = ("°", DEGREE) if self.pendulum else (self.system.unit, 1.0)
        size = abs(self.q_0)
        axis = nice_axis(-size, size, unit, factor=factor)
        top = axis.place(size) or 1.0
        text = f"{top:.4g}" if 1 <= top < 1000 else short(top)
        labels = (MINUS + text, "0", text + axis.gap + axis.full_unit)
        start, end = 1.3 * -size or axis.start, 1.3 * size or axis.end
        return replace(axis, start=start, end=end, ticks=(-top, 0.0, top), labels=labels, drawn=(-size, size))

    @cached_property
    def table_axis(self) -> Axis:
        """The unit in which the table counts x and q."""
        return nice_axis(-abs(self.q_0), abs(self.q_0), self.system.unit)

    def energy_axis(self) -> Axis:
        return nice_axis(0.0, self.energy, "J")


def motion_bands(case: AnalogueCase) -> Columns:
    """The bands that the coordinates q and x fill where they are too fast to draw."""
    if drawable(case.omega, case.t):
        return {}
    rule = [Sinusoid(case.q_0, case.omega, math.pi / 2)]
    return {end: column for name in CURVES for end, column in trace(name, rule, case.t)[1].items()}


def late_axes(case: AnalogueCase) -> dict[str, Axis]:
    """Angle and lateness; they reach to 90 degrees and 19 %, or as far as the start is beyond."""
    wide = case.pendulum is not None and abs(case.q_0) > 88 * DEGREE
    end, step = (180, 60) if wide else (90, 30)
    ticks = tuple(float(tick) for tick in range(0, end + 1, step))
    late = nice_axis(0.0, max(1.25 * case.excess, 0.19), "%", 2, exact=True, factor=0.01)
    return {
        "angle": Axis(0.0, end, "°", ticks=ticks, drawn=(0.0, math.degrees(abs(case.q_0)) if case.pendulum else 0.0)),
        "late": replace(late, drawn=(0.0, case.excess)),
    }


@cache
def _lateness(end: float) -> tuple[Floats, Floats]:
    """Angles in degrees and T/T_0 - 1 there."""
    angles = np.linspace(0.0, min(end, 179.9), 121)
    return angles, np.array([excess(math.radians(angle)) for angle in angles])


def late_columns(case: AnalogueCase, end: float) -> dict[str, Columns]:
    """T/T_0 - 1 against the angle, up to `end` degrees."""
    if not case.pendulum:
        return {"late": {}, "limits": {}, "here": {}}
    angles, late = _lateness(end)
    limits = np.array(list(LIMITS.values()))
    return {
        "late": {"angle": angles, "excess": late},
        "limits": {"angle": np.degrees([amplitude_at_excess(value) for value in limits]), "excess": limits},
        "here": {"angle": np.array([math.degrees(abs(case.q_0))]), "excess": np.array([case.excess])},
    }
