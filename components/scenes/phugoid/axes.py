"""The axes of a flight, in the chosen unit."""

from __future__ import annotations

import math

from msgspec.structs import replace

from components.quantities.axes import Axis, nice_axis, nice_ticks, round_ticks, time_axis
from components.quantities.declared import Declared, DrawnAxis, by_name
from components.quantities.formatting import short
from components.scenes.phugoid.swing import AIRCRAFT, LENGTHS, SPEEDS, Swing
from physics.phugoid import linear_phugoid

FASTEST = 275.0  # end of the speed axis in the plot of periods, in m/s
ASPECT = 4.4
"""Width over height of the frame of the path on a desk."""
BEFORE = 0.3
"""Room before the start, in v_0^2/g: the length of the aircraft's tail."""


class Axes(Declared[Swing]):
    t, along, up, h, v, v_0, tau, share, lift, forward, upward = DrawnAxis.some(11)


def axes_of(swing: Swing) -> dict[str, Axis]:
    size, (length, metres) = SPEEDS[swing.unit], LENGTHS[swing.unit]
    along, up = _ground(swing, length, metres)
    forward, upward = _velocity(swing)
    # One frame for both: h' in v_0^2/g and v' in v_0 are mirror images in the linear theory.
    reach = max(abs(float(swing.lap.h.min())), abs(float(swing.lap.h.max())), abs(swing.excess))
    fastest = FASTEST if swing.v_0 <= FASTEST else 1.25 * swing.v_0
    tau = nice_axis(0.0, linear_phugoid(fastest, swing.g).tau, "s", 2, exact=True)
    return by_name({
        Axes.t: time_axis(swing.own_end),
        Axes.along: along,
        Axes.up: up,
        Axes.h: nice_axis(-reach * swing.length, reach * swing.length, length, 3, factor=metres),
        Axes.v: nice_axis(-reach * swing.v_0, reach * swing.v_0, swing.unit, 3, factor=size),
        Axes.v_0: nice_axis(0.0, fastest, swing.unit, 2, exact=True, factor=size),
        Axes.tau: replace(tau, drawn=(0.0, tau.end * max(AIRCRAFT["airliner"][1], swing.v_0) / fastest)),
        Axes.share: Axis(0.0, 1.0, "%", ticks=(0.0, 50.0, 100.0), factor=0.01),
        Axes.lift: nice_axis(0.0, float(max(swing.lap.u[0], 1.0)) ** 2, count=4),
        Axes.forward: forward,
        Axes.upward: upward,
    })  # fmt: skip


def _ground(swing: Swing, unit: str, factor: float) -> tuple[Axis, Axis]:
    """Axes along and up with the same scale, labelled in `unit`, which is `factor` metres. They contain the flight
    within the window, or are as wide as the oscillation requires.
    """
    length, size = swing.length, abs(swing.excess)
    low, high = min(float(swing.lap.h.min()), -size), max(float(swing.lap.h.max()), size)
    room = 0.16 * (high - low)
    end = max(swing.distance(swing.end), ASPECT * (high - low + 2 * room), 0.5)
    along = _along(-BEFORE * length, end * length, unit, factor)
    half, middle = (end + BEFORE) / ASPECT / 2, (low + high) / 2
    up = _up(along, (middle - half) * length, (middle + half) * length)
    far = min(swing.distance(swing.end), end)
    return replace(along, drawn=(-BEFORE * length, far * length)), replace(up, drawn=(low * length, high * length))


def _along(low: float, high: float, unit: str, factor: float) -> Axis:
    """The horizontal axis. Distances below 100,000 are written in full, without a power of ten."""
    axis = nice_axis(low, high, unit, 3, exact=True, factor=factor)
    if not 1e4 <= high / factor < 1e5:
        return axis
    return replace(axis, exponent=0, suffix="", ticks=nice_ticks(low / factor, high / factor, 3))


def _up(along: Axis, low: float, high: float) -> Axis:
    """The vertical axis in the unit of the horizontal one. The stage labels its zero."""
    axis = replace(along, start=low, end=high, zero=False)
    return replace(axis, ticks=round_ticks(replace(axis, start=0.9 * low, end=0.9 * high)))


def _velocity(swing: Swing) -> tuple[Axis, Axis]:
    """Axes forward (of u - v_0, so that standstill is at -1) and up, in v_0, with one frame for all flights except wide
    loops.
    """
    far = max(1.0, float(swing.lap.w.max()) / 1.05, (1 + swing.excess) / 3.05)
    low = min(-0.85, 1.15 * float(swing.lap.u.min()))
    ticks = tuple(float(i - 1) for i in range(-math.ceil(far), math.ceil(3.1 * far) + 1, math.ceil(far / 1.5)))
    labels = tuple(_times_v_0(tick + 1) for tick in ticks)
    return Axis(low - 1, low + 3.9 * far - 1, ticks=ticks, labels=labels), Axis(-1.155 * far, 1.155 * far)


def _times_v_0(number: float) -> str:
    return {0.0: "0", 1.0: "v₀", -1.0: "−v₀"}.get(number, f"{short(number)} v₀")
