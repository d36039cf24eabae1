"""The curves of a flight: its signals, its path, its velocities, and bands if it is too fast for a line."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from components.language.expressions import var
from components.language.signals import AnySignal
from components.quantities.axes import ONE, Axis
from components.quantities.declared import AxesInForce, Column, Declared, Family, Signal, by_name
from components.quantities.motion import QUARTER, derived, sampled, scaled, sines
from components.scene.traces import (
    TIME,
    Columns,
    Floats,
    Traces,
    band_columns,
    bands_over_time,
    over_time,
    samples,
    trace,
)
from components.scenes.phugoid.axes import Axes
from components.scenes.phugoid.swing import CORNER, POINTS, Swing
from physics.phugoid import CUSP_EXCESS, flight, lanchester, linear_flight, linear_phugoid
from physics.sampling import Sinusoid, drawable

SWINGS = 28
"""Largest number of periods of a path that can be distinguished."""
FAMILY = {
    name: lanchester(excess, 121) for name, excess in (("a", 0.2), ("b", 0.4), ("cusp", CUSP_EXCESS), ("loop", 1.0))
}
"""Flights that are shown for comparison."""
TURN = np.linspace(0.0, 2 * math.pi, POINTS)

signal = Signal[Swing]


def _told(swing: Swing, axes: AxesInForce, on: Axis, values: Floats, rates: Floats, gain: float = 0.0) -> AnySignal:
    """A signal of the exact flight, from one period and the gain per period."""
    return sampled(Axes.t(axes), swing.period, on.places(values), on.places(rates), on.place(gain))


def _sine(
    swing: Swing, axes: AxesInForce, on: Axis, size: float, phase: float, line: tuple[float, float] = (0, 0)
) -> AnySignal:
    """A signal of the linear theory."""
    return sines(on, Axes.t(axes), (size, swing.linear.omega, phase), line=line)


def _up(of: Signal[Swing], axes: AxesInForce) -> AnySignal:
    """A height in the unit of the path."""
    return derived(scaled(Axes.along(axes).exponent - Axes.h(axes).exponent, 1.0) * var(of))


def _share(swing: Swing, axes: AxesInForce) -> AnySignal:
    axis = Axes.share(axes)
    if means := _mean_shares(swing):
        return derived(axis.place(means[Signals.share.name][0]))
    V = (1 / float(swing.lap.u[0])) * var(Signals.V)
    return derived(axis.place(1.0) * V * V)


def _twin(swing: Swing, axes: AxesInForce) -> AnySignal:
    half = Axes.share(axes).place(0.5)
    if not drawable(2 * swing.fastest, instants(swing)):
        return derived(half)
    return sines(ONE, Axes.t(axes), (half, 2 * swing.linear.omega, -QUARTER), line=(half, 0.0))


class Signals(Declared[Swing]):
    """Signals of the path, h' and v', and the velocity in v_0: exact, and in the linear theory (_lin).

    Lift over weight from the speed V, to first order, and as a vector perpendicular to the velocity, |L| = V^2. Kinetic
    shares of the energies, or their means if the window does not resolve them: of the aircraft (from its lowest point)
    and of the spring; their lower and upper ends.
    """

    x = signal(lambda s, a: _told(s, a, Axes.along(a), s.told.x, s.told.u, s.length * s.lap.advance))
    h = signal(lambda s, a: _told(s, a, Axes.h(a), s.told.h, s.told.w), Axes.h, signed=True)
    v = signal(lambda s, a: _told(s, a, Axes.v(a), s.told.gain(s.v_0, s.g), s.rates[2]), Axes.v, signed=True)
    u = signal(lambda s, a: _told(s, a, ONE, s.told.u / s.v_0, s.rates[0] / s.v_0))
    w = signal(lambda s, a: _told(s, a, ONE, s.told.w / s.v_0, s.rates[1] / s.v_0))
    h_lin = signal(lambda s, a: _sine(s, a, Axes.h(a), s.climb, -QUARTER))
    v_lin = signal(lambda s, a: _sine(s, a, Axes.v(a), s.gain, QUARTER))
    x_lin = signal(lambda s, a: _sine(s, a, Axes.along(a), s.climb / math.sqrt(2), 0.0, (0.0, s.v_0)))
    y = signal(lambda s, a: _up(Signals.h, a))
    y_lin = signal(lambda s, a: _up(Signals.h_lin, a))
    u_lin = signal(lambda s, a: _sine(s, a, ONE, s.excess, QUARTER, (1.0, 0.0)))
    w_lin = signal(lambda s, a: _sine(s, a, ONE, math.sqrt(2) * s.excess, 0.0))
    V = signal(lambda s, a: _told(s, a, ONE, s.told.V / s.v_0, s.rates[2] / s.v_0))
    lift = signal(lambda s, a: derived(var(Signals.V) * var(Signals.V)), Axes.lift)
    lift_linear = signal(lambda s, a: derived(2 * var(Signals.V) - 1), Axes.lift)
    lift_forward = signal(lambda s, a: derived(-var(Signals.V) * var(Signals.w)))
    lift_up = signal(lambda s, a: derived(var(Signals.V) * var(Signals.u)))
    zero = signal(lambda s, a: derived(Axes.share(a).place(0.0)))
    all = signal(lambda s, a: derived(Axes.share(a).place(1.0)))
    share = signal(_share)
    twin = signal(_twin)


PATH = (Signals.x, Signals.y, Signals.x_lin, Signals.y_lin)


def instants(swing: Swing) -> Floats:
    return np.linspace(0.0, swing.end, samples(swing.end, swing.fastest))


def exact(swing: Swing, t: Floats) -> dict[Signal[Swing], Floats]:
    """The numbers of everything that is drawn over time, and of the path, in SI units."""
    flown, linear = (fly(swing.v_0, swing.g, swing.excess, t) for fly in (flight, linear_flight))
    V, nothing, S = flown.V / swing.v_0, np.zeros_like(t), Signals
    share, twin = (flown.V / (swing.lap.u[0] * swing.v_0)) ** 2, np.sin(swing.linear.omega * t) ** 2
    return {
        S.x: flown.x, S.y: flown.h, S.x_lin: linear.x, S.y_lin: linear.h,
        S.h: flown.h, S.h_lin: linear.h, Signals.lift: V * V, Signals.lift_linear: 2 * V - 1,
        S.v: flown.gain(swing.v_0, swing.g), S.v_lin: swing.gain * np.cos(swing.linear.omega * t),
        Signals.zero: nothing, Signals.share: share, Signals.all: nothing + 1, Signals.twin: twin,
    }  # fmt: skip


def curves(swing: Swing, end: float) -> tuple[dict[str, Traces], dict[str, Columns]]:
    """The motion over time, and the path to the `end` of its frame (in m): as curves from signals, or as columns if
    they are too fast for a line or have a corner.
    """
    t = instants(swing)
    drawn, bands = _over_time(swing, t)
    means = [Signals.zero, Signals.share, Signals.all, Signals.twin]
    traces = over_time(
        swing.end, swing.fastest, drawn, lambda t: exact(swing, t), moving=_moving(swing), averaged=means
    )
    columns = bands_over_time(t, bands) | {TIME: _mean_shares(swing)}
    last = max(swing.end, min(end / swing.length / swing.distance(1.0) + swing.period / 2, SWINGS * swing.period))
    ahead = np.linspace(0.0, last, samples(last, 3 * swing.fastest))
    path = over_time(
        last, 3 * swing.fastest, PATH if drawable(swing.fastest, ahead) else (), lambda t: exact(swing, t), "path", PATH
    )
    traces |= {source: replace(one, fastest=swing.fastest) for source, one in path.items()}
    if not drawable(swing.fastest, ahead):
        low, high = swing.length * swing.lap.h.min(), swing.length * swing.lap.h.max()
        x = {Signals.x.name: exact(swing, ahead)[Signals.x]}
        columns["path_band"] = x | _band(Signals.y, ahead, low, high)
    if abs(swing.lap.C) < CORNER:
        bare = {source: replace(one, names=()) for source, one in traces.items()}
        return bare, columns | {source: one.drawn | columns.get(source, {}) for source, one in traces.items()}
    return traces, columns


def _over_time(swing: Swing, t: Floats) -> tuple[list[Signal[Swing]], Columns]:
    """The curves over time, and the bands of those that are too fast to draw."""
    drawn, bands = list[Signal[Swing]](), Columns()
    if drawable(swing.linear.omega, t):
        drawn += [Signals.h_lin, Signals.v_lin]
    else:
        for one, size, phase in ((Signals.h_lin, swing.climb, -QUARTER), (Signals.v_lin, swing.gain, QUARTER)):
            bands |= trace(one, [Sinusoid(size, swing.linear.omega, phase)], t)[1]
    others = [Signals.h, Signals.v, Signals.lift, Signals.lift_linear]
    if drawable(swing.omega, t):
        drawn += others
    else:
        numbers = exact(swing, t)
        for one in others:
            bands |= _band(one, t, numbers[one].min(), numbers[one].max())
    if not _mean_shares(swing):
        drawn += [Signals.zero, Signals.share, Signals.all, *([Signals.twin] if swing.excess else [])]
    return drawn, bands


def _moving(swing: Swing) -> list[Signal[Swing]]:
    """The motions over time in a file."""
    S = Signals
    shares = [S.share, *([S.twin] if swing.excess else [])]
    return [S.h_lin, S.v_lin, S.h, S.v, S.lift, S.lift_linear, *shares]


def _mean_shares(swing: Swing) -> Columns:
    """The edges of the stacks of shares, as means over the window if the window does not resolve them."""
    t = instants(swing)
    if drawable(2 * swing.fastest, t):
        return {}
    levels = {Signals.zero: 0.0, Signals.share: exact(swing, t)[Signals.share].mean(), Signals.all: 1.0}
    twin = {Signals.twin: 0.5} if swing.excess else {}
    return by_name({one: np.full_like(t, level) for one, level in (levels | twin).items()})


def _band(one: Signal[Swing], t: Floats, *levels: float) -> Columns:
    return {end: np.full_like(t, level) for end, level in zip(band_columns(one.name), levels, strict=True)}


class Limits(Declared[Swing]):
    """The tip of the velocity (u - v_0 forward, w up, in v_0), exact and linear, and the tips for FAMILY."""

    u = Column[Swing]("velocity", lambda s: s.lap.u - 1)
    w = Column[Swing]("velocity", lambda s: s.lap.w)
    u_lin = Column[Swing]("velocity", lambda s: s.excess * np.cos(TURN))
    w_lin = Column[Swing]("velocity", lambda s: math.sqrt(2) * s.excess * np.sin(TURN))
    forward = Family(FAMILY, lambda name: Column[Swing]("family", lambda s: FAMILY[name].u - 1), "u_{}")
    upward = Family(FAMILY, lambda name: Column[Swing]("family", lambda s: FAMILY[name].w), "w_{}")


class Periods(Declared[Swing]):
    v_0, tau = Column[Swing]("periods"), Column[Swing]("periods")


def columns_of(swing: Swing, axes: AxesInForce) -> dict[str, Columns]:
    """The line of the periods, and the velocities."""
    reach = np.array([0.0, Axes.v_0(axes).end])
    periods = by_name({Periods.v_0: reach, Periods.tau: linear_phugoid(1.0, swing.g).tau * reach})
    return {"periods": periods, **Limits.columns(swing)}
