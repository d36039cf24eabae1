"""One flight as numbers for the plots and the clock, exact and linear."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np

from components.language.numbers import var
from components.language.signals import AnySignal
from components.quantities.axes import Axis
from components.quantities.motion import derived, sampled, scaled, sines
from components.quantities.numbers import short, three
from components.scene.traces import Columns, Floats, Traces, band_columns, bands_over_time, samples, trace
from physics.phugoid import (
    CUSP_EXCESS,
    EXCESS_AT_LATENESS,
    Flight,
    LanchesterPeriod,
    LinearPhugoid,
    flight,
    lanchester,
    linear_flight,
    linear_phugoid,
    period_excess,
)
from physics.sampling import Sinusoid, drawable

FOOT = 0.3048
AIRCRAFT = {
    "model": ("Model", 35 * FOOT, 2.0),
    "glider": ("Glider", 90 * FOOT, 450.0),
    "light": ("Light aircraft", 150 * FOOT, 1100.0),
    "airliner": ("Airliner", 250.0, 70000.0),
}
NODES = 64
"""Points of a period that the browser joins by Hermite pieces, over sqrt(|C|): it is then within 1e-6 of the frame."""
CORNER = 1 / 64
"""Where |C| is less the path has a corner, or nearly: its curves are sent as they are."""
SWINGS = 28
"""As many swings of a path can be told apart."""
FAMILY = {"a": 0.2, "b": 0.4, "cusp": CUSP_EXCESS, "loop": 1.0}
"""Speed excesses of the flights shown for comparison."""
PATH = ("x", "y", "x_lin", "y_lin")
"""The curves of the path."""
SMALLEST, GREATEST = 1e-290, 1e290


@dataclass(frozen=True)
class Swing:
    """A flight that is level at t = 0 with the speed v_0 (1 + excess); ValueError beyond the doubles."""

    v_0: float
    g: float
    excess: float

    def __post_init__(self) -> None:
        sizes = (
            self.v_0,
            self.v_0 * self.v_0,
            self.v_0 * self.v_0 / self.g,
            self.v_0 / self.g,
            self.g / self.v_0,
        )
        if not all(SMALLEST < size < GREATEST for size in sizes):
            raise ValueError(
                f"a swing at v_0 = {short(self.v_0)} m/s and g = {short(self.g)} m/s² has a size v_0²/g "
                "or a period beyond what numbers can hold."
            )

    def check(self, window: float) -> None:
        """ValueError where a time window and a swing cannot be counted in one unit of time."""
        if not 1e-100 < window / self.period < 1e100:
            raise ValueError(
                f"a window of {short(window)} s and a swing of {short(self.period)} s are too far apart "
                "to be shown together."
            )

    @property
    def length(self) -> float:
        """The unit of lengths, v_0^2/g in m."""
        return self.v_0 * self.v_0 / self.g

    @cached_property
    def linear(self) -> LinearPhugoid:
        return linear_phugoid(self.v_0, self.g)

    @cached_property
    def lap(self) -> LanchesterPeriod:
        """One period of the exact flight, without its units, from its lowest point."""
        return lanchester(self.excess, 161)

    @property
    def period(self) -> float:
        """The period of the exact flight, in s."""
        return self.lap.period * self.v_0 / self.g

    @property
    def nodes(self) -> int:
        """Points of a period that the browser is told: one is at its middle, where the corner is."""
        return 2 * math.ceil(NODES / 2 / math.sqrt(min(max(abs(self.lap.C), CORNER), 1.0))) + 1

    @property
    def omega(self) -> float:
        return 2 * math.pi / self.period

    @property
    def fastest(self) -> float:
        return max(self.omega, self.linear.omega)

    @property
    def climb(self) -> float:
        """The amplitude of h' in the linear theory, in m."""
        return self.length * self.excess

    @property
    def gain(self) -> float:
        """The excess of speed at the start, in m/s."""
        return self.excess * self.v_0

    @property
    def late(self) -> float:
        """T/T_0 - 1: by how much the exact swing takes longer than the linear one."""
        return period_excess(self.excess)

    @property
    def top(self) -> tuple[float, float]:
        """Distance and height of the first top of the exact path after the start, in m."""
        laps = 0.5 if self.excess >= 0 else 1.0
        return self.length * self.lap.advance * laps, self.length * float(self.lap.h.max())

    @property
    def top_linear(self) -> tuple[float, float]:
        laps = 0.5 if self.excess >= 0 else 1.0
        return self.v_0 * self.linear.tau * laps, abs(self.climb)

    def distance(self, t: float) -> float:
        """The distance that the exact flight covers in the time t, in units of v_0^2/g."""
        return t / self.period * self.lap.advance


def exact_over_time(swing: Swing, t: Floats) -> Columns:
    """h' and v', exact and linear (_lin), lift over weight, and kinetic shares of the energy."""
    exact, linear = (fly(swing.v_0, swing.g, swing.excess, t) for fly in (flight, linear_flight))
    V = exact.V / swing.v_0
    return {
        "h_lin": linear.h,
        "v_lin": swing.gain * np.cos(swing.linear.omega * t),
        "h": exact.h,
        "v": exact.gain(swing.v_0, swing.g),
        "lift": V * V,
        "lift_linear": 2 * V - 1,
        **_shares(swing, exact),
    }


def _shares(swing: Swing, motion: Flight) -> Columns:
    """Kinetic shares: of the aircraft's energy, counted from its lowest point, and of the spring's."""
    t, fastest = motion.t, swing.lap.u[0] * swing.v_0
    share = (motion.V / fastest) ** 2
    twin = np.sin(swing.linear.omega * t) ** 2
    if not drawable(2 * swing.fastest, t):
        share, twin = np.full_like(t, share.mean()), np.full_like(t, 0.5)
    nothing = np.zeros_like(t)
    return {"nothing": nothing, "share": share, "all": nothing + 1, "twin": twin}


def curves(swing: Swing, t: Floats, ahead: Floats, show: str) -> tuple[dict[str, Traces], dict[str, Columns]]:
    """The motion over the times t and the path over the times `ahead`: as curves of signals, and as columns where they
    are too fast for a line, or have a corner."""
    names, bands = _over_time(swing, t, show)
    traces = {"time": Traces(float(t[-1]), t.size, names, lambda t: exact_over_time(swing, t))}
    columns = bands_over_time(t, bands) | {"path": {}}
    if drawable(swing.fastest, ahead):
        traces["path"] = Traces(float(ahead[-1]), ahead.size, PATH, lambda t: along_path(swing, t))
    else:
        columns["path_band"] = path_band(swing, ahead)
    if abs(swing.lap.C) < CORNER:
        return {}, columns | {source: one.columns for source, one in traces.items()}
    return traces, columns


def _over_time(swing: Swing, t: Floats, show: str) -> tuple[tuple[str, ...], Columns]:
    """The names of the curves over time, and the bands of those that are too fast to draw."""
    drawn = {"h_lin": (swing.climb, -math.pi / 2), "v_lin": (swing.gain, math.pi / 2)}
    names, bands = list[str](), Columns()
    if drawable(swing.linear.omega, t):
        names += drawn
    else:
        for name, (size, phase) in drawn.items():
            bands |= trace(name, [Sinusoid(size, swing.linear.omega, phase)], t)[1]
    others = ("h", "v", *(("lift", "lift_linear") if show == "lift" else ()))
    if drawable(swing.omega, t):
        names += others
    else:
        exact = exact_over_time(swing, t)
        for name in others:
            reach = exact[name].min(), exact[name].max()
            bands |= {end: np.full_like(t, level) for end, level in zip(band_columns(name), reach, strict=True)}
    if show == "exchange":
        names += ("nothing", "share", "all", *(("twin",) if swing.excess else ()))
    return tuple(names), bands


def path_times(swing: Swing, window: float, end: float) -> Floats:
    """The times of the path, to the end of the frame (in v_0^2/g) or of the window."""
    last = max(window, min(end / swing.distance(1.0) + swing.period / 2, SWINGS * swing.period))
    return np.linspace(0.0, last, samples(last, 3 * swing.fastest))


def along_path(swing: Swing, t: Floats) -> Columns:
    """The path over distance, exact and linear."""
    exact, linear = (fly(swing.v_0, swing.g, swing.excess, t) for fly in (flight, linear_flight))
    return {"x": exact.x, "y": exact.h, "x_lin": linear.x, "y_lin": linear.h}


def path_band(swing: Swing, t: Floats) -> Columns:
    """The band that the exact path fills where its swings are too close to be drawn."""
    height = np.full_like(t, swing.length)
    ends = {"y_lo": swing.lap.h.min() * height, "y_hi": swing.lap.h.max() * height}
    return {"x": flight(swing.v_0, swing.g, swing.excess, t).x, **ends}


def velocities(swing: Swing) -> Columns:
    """The tip of the velocity (u - v_0 forward, w up, in v_0), exact and linear."""
    lap = swing.lap
    turn = np.linspace(0.0, 2 * math.pi, lap.t.size)
    return {
        "u": lap.u - 1,
        "w": lap.w,
        "u_lin": swing.excess * np.cos(turn),
        "w_lin": math.sqrt(2) * swing.excess * np.sin(turn),
    }


@cache
def family_velocities() -> Columns:
    """The tips of the exact velocities of FAMILY, in v_0."""
    columns: Columns = {}
    for name, excess in FAMILY.items():
        other = lanchester(excess, 121)
        columns |= {f"u_{name}": other.u - 1, f"w_{name}": other.w}
    return columns


def share_signals(swing: Swing, axes: Mapping[str, Axis], t: Floats) -> dict[str, AnySignal]:
    """Kinetic shares over the times t, their means where these do not resolve them; the floor and the ceiling."""
    nothing, whole = (axes["share"].place(end) for end in (0.0, 1.0))
    levels: dict[str, AnySignal] = {"nothing": derived(nothing), "all": derived(whole)}
    if not drawable(2 * swing.fastest, t):
        exact = _shares(swing, flight(swing.v_0, swing.g, swing.excess, t))
        return levels | {name: derived(axes["share"].place(float(exact[name][0]))) for name in ("share", "twin")}
    V = (1 + var("v") * (1 / axes["v"].place(swing.v_0))) * (1 / float(swing.lap.u[0]))
    twin = sines(Axis(0.0, 1.0), axes["t"], (whole / 2, 2 * swing.linear.omega, -math.pi / 2), line=(whole / 2, 0.0))
    return levels | {"share": derived(whole * V * V), "twin": twin}


def lift_signals(swing: Swing, speed: Axis) -> dict[str, AnySignal]:
    """Lift over weight from the signal v, to first order, and as a vector: upright to the velocity, |L| = V^2."""
    V = 1 + var("v") * (1 / speed.place(swing.v_0))
    return {
        "V": derived(V),
        "lift": derived(var("V") * var("V")),
        "lift_linear": derived(2 * var("V") - 1),
        "lift_forward": derived(-var("V") * var("w")),
        "lift_up": derived(var("V") * var("u")),
    }


def motion_signals(
    swing: Swing, lap: Flight, time: Axis, along: Axis, height: Axis, speed: Axis
) -> dict[str, AnySignal]:
    """The signals of the clock: places on the path, h', v', and velocities in v_0; `lap` is a period from the start."""
    v_0, g, omega = swing.v_0, swing.g, swing.linear.omega
    u_dot, w_dot, v_dot = lap.rates(v_0, g)
    gain = lap.gain(v_0, g)
    advance = along.place(swing.length * swing.lap.advance)
    tables = {
        "x": (along.places(lap.x), along.places(lap.u), advance),
        "h": (height.places(lap.h), height.places(lap.w), 0.0),
        "v": (speed.places(gain), speed.places(v_dot), 0.0),
        "u": (lap.u / v_0, u_dot / v_0, 0.0),
        "w": (lap.w / v_0, w_dot / v_0, 0.0),
    }
    unit = Axis(0.0, 1.0)
    quarter, climb = math.pi / 2, swing.length * swing.excess / math.sqrt(2)
    to_path = scaled(along.exponent - height.exponent, 1.0)
    return {
        **{name: sampled(time, swing.period, *parts) for name, parts in tables.items()},
        "h_lin": sines(height, time, (swing.climb, omega, -quarter)),
        "v_lin": sines(speed, time, (swing.gain, omega, quarter)),
        "x_lin": sines(along, time, (climb, omega, 0.0), line=(0.0, v_0)),
        "y": derived(to_path * var("h")),
        "y_lin": derived(to_path * var("h_lin")),
        "u_lin": sines(unit, time, (swing.excess, omega, quarter), line=(1.0, 0.0)),
        "w_lin": sines(unit, time, (math.sqrt(2) * swing.excess, omega, 0.0)),
    }


def verdict(swing: Swing) -> str:
    """Where the linear theory stands with a swing of this size."""
    bottom, late = swing.lap.u[0] - 1, three(100 * abs(swing.late))
    right, near = sorted(EXCESS_AT_LATENESS.values())
    if not swing.excess:
        return "Steady level flight: nothing swings."
    if swing.lap.loops:
        return "The aircraft loops: linear theory does not apply."
    if bottom >= CUSP_EXCESS - 1e-9:
        return f"The cusp: a standstill at the top, and linear theory {late} % off in the period."
    if bottom <= right:
        return "Linear theory: its period is right to 0.1 %, its heights to 8 % of the swing."
    if bottom <= near:
        return f"Linear theory is {late} % off in the period, more in the shape."
    return f"Linear theory fails in the shape, though it is only {late} % off in the period."
