"""One flight in the scene, exact and linear, with the unit and the view in which it is shown."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from components.quantities.formatting import short, three
from components.scene.frames import Windowed
from components.scene.traces import Floats
from physics.phugoid import (
    CUSP_EXCESS,
    EXCESS_AT_LATENESS,
    Flight,
    LanchesterPeriod,
    LinearPhugoid,
    flight,
    lanchester,
    linear_phugoid,
    period_excess,
)

FOOT, KNOT = 0.3048, 1852 / 3600
SPEEDS = {"ft/s": FOOT, "m/s": 1.0, "knots": KNOT, "km/h": 1 / 3.6}
LENGTHS = {"ft/s": ("ft", FOOT), "knots": ("ft", FOOT), "m/s": ("m", 1.0), "km/h": ("m", 1.0)}
"""The unit of length that belongs to a unit of speed, and its size in m."""
AIRCRAFT = {
    "model": ("Model", 35 * FOOT, 2.0),
    "glider": ("Glider", 90 * FOOT, 450.0),
    "light": ("Light aircraft", 150 * FOOT, 1100.0),
    "airliner": ("Airliner", 250.0, 70000.0),
}
NODES = 64
"""Points per period, divided by sqrt(|C|), for Hermite interpolation in the browser with an error below 1e-6 of the
frame.
"""
CORNER = 1 / 64
"""If |C| is smaller, the path has a corner or nearly one, and its curves are sent as columns."""
POINTS = 161
"""Points of a period that is drawn in the plane of the velocities."""
SMALLEST, GREATEST = 1e-290, 1e290


@dataclass(frozen=True, kw_only=True)
class Swing(Windowed):
    """A flight that is level at t = 0 with the speed v_0 (1 + excess). Raise ValueError if it leaves the range of
    doubles.
    """

    v_0: float
    g: float
    excess: float
    unit: str
    view: str

    def __post_init__(self) -> None:
        sizes = (self.v_0, self.v_0 * self.v_0, self.length, self.v_0 / self.g, self.g / self.v_0)
        if not all(SMALLEST < size < GREATEST for size in sizes):
            raise ValueError(
                f"a swing at v_0 = {short(self.v_0)} m/s and g = {short(self.g)} m/s² has a size v_0²/g "
                "or a period beyond what numbers can hold."
            )
        # A window and a period must be counted in one unit of time.
        if not 1e-100 < self.end / self.period < 1e100:
            raise ValueError(
                f"a window of {short(self.end)} s and a swing of {short(self.period)} s are too far apart "
                "to be shown together."
            )

    @cached_property
    def lasting(self) -> float:
        return float(f"{2.2 * self.linear.tau:.2g}")

    @cached_property
    def length(self) -> float:
        """The unit of lengths, v_0^2/g in m."""
        return self.v_0 * self.v_0 / self.g

    @cached_property
    def linear(self) -> LinearPhugoid:
        return linear_phugoid(self.v_0, self.g)

    @cached_property
    def lap(self) -> LanchesterPeriod:
        """One period of the exact flight, dimensionless, from its lowest point."""
        return lanchester(self.excess, POINTS)

    @cached_property
    def period(self) -> float:
        """The period of the exact flight, in s."""
        return self.lap.period * self.v_0 / self.g

    @property
    def nodes(self) -> int:
        """Points of a period that are sent to the browser. One is in the middle, at the corner."""
        return 2 * math.ceil(NODES / 2 / math.sqrt(min(max(abs(self.lap.C), CORNER), 1.0))) + 1

    @cached_property
    def told(self) -> Flight:
        """One period of the exact flight from its start, as it is sent to the browser."""
        return flight(self.v_0, self.g, self.excess, np.linspace(0.0, self.period, self.nodes))

    @cached_property
    def rates(self) -> tuple[Floats, ...]:
        """du/dt, dw/dt and dV/dt of this period."""
        return self.told.rates(self.v_0, self.g)

    @property
    def omega(self) -> float:
        return 2 * math.pi / self.period

    @cached_property
    def fastest(self) -> float:
        return max(self.omega, self.linear.omega)

    @property
    def climb(self) -> float:
        """The amplitude of h' in the linear theory, in m."""
        return self.length * self.excess

    @property
    def gain(self) -> float:
        """The extra speed at the start, in m/s."""
        return self.excess * self.v_0

    @property
    def heights_off(self) -> float:
        """The largest difference between the heights of both theories in the first period, relative to the amplitude:
        within 1 % of excess/2 while the period is right to 0.1 %.
        """
        return abs(self.excess) / 2

    @property
    def late(self) -> float:
        """T/T_0 - 1: the relative difference between the exact period and the linear one."""
        return period_excess(self.excess)

    @cached_property
    def top(self) -> tuple[float, float]:
        """Distance and height of the first maximum of the exact path after the start, in m."""
        laps = 0.5 if self.excess >= 0 else 1.0
        return self.length * self.lap.advance * laps, self.length * float(self.lap.h.max())

    @cached_property
    def top_linear(self) -> tuple[float, float]:
        laps = 0.5 if self.excess >= 0 else 1.0
        return self.v_0 * self.linear.tau * laps, abs(self.climb)

    def distance(self, t: float) -> float:
        """The distance that the exact flight covers in the time t, in units of v_0^2/g."""
        return t / self.period * self.lap.advance


def verdict(swing: Swing) -> str:
    """The validity of the linear theory at this amplitude."""
    bottom, late = swing.lap.u[0] - 1, three(100 * abs(swing.late))
    right, near = sorted(EXCESS_AT_LATENESS.values())
    if not swing.excess:
        return "Steady level flight: nothing swings."
    if swing.lap.loops:
        return "The aircraft loops: linear theory does not apply."
    if bottom >= CUSP_EXCESS - 1e-9:
        return f"The cusp: a standstill at the top, and linear theory {late} % off in the period."
    if bottom <= right:
        off = short(float(f"{100 * swing.heights_off:.2g}"))
        verdict = f"Linear theory: its period is right to 0.1 %, its heights at first to about {off} % of the swing."
        return verdict.replace(" %", "\N{NO-BREAK SPACE}%")
    if bottom <= near:
        return f"Linear theory is {late} % off in the period, more in the shape."
    return f"Linear theory fails in the shape, though it is only {late} % off in the period."
