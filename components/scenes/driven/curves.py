"""The curves of the driven mass: over time, with bands for what is too fast for a line, and its response over r."""

from __future__ import annotations

import math
from cmath import phase

import numpy as np
from msgspec.structs import replace

from components import dashpot
from components.language.signals import AnySignal
from components.layout.stage import PlotFrame, wire
from components.quantities.axes import ONE, Axis, nice_axis, time_axis
from components.quantities.declared import AxesInForce, Column, Declared, DrawnAxis, Family, Scalar, Signal, by_name
from components.quantities.motion import QUARTER, damped, driven, sines, total
from components.scene.traces import Columns, Floats, band_columns, bands_over_time
from components.scenes.driven.case import KINDS, DrivenCase
from components.scenes.driven.power import Power, powers_of
from physics.driven import highest, lag, magnification
from physics.sampling import drawable
from physics.transient import FILE

ROOM = 1.2
"""The reach of x(t), in its largest value."""
END = 2.5
"""The axis of r ends here, or a little beyond the drive."""
LEAST, USUAL, TALLEST = 1.4, 2.75, 8.8
"""The height of the response: at least; without a peak to show; at most."""
EVEN = np.linspace(0.0, 1.0, 91)
NEAR = np.geomspace(1e-4, 0.6, 24)
ENDS = range(2)
RINGING, LATE = "ringing", "late"
"""The sources of the bands and lines of what is too fast for a line at first alone."""
X, POWER, RESPONSE, PHASE = map(PlotFrame, ("x", "power", "response", "phase"))

signal, scalar = Signal[DrivenCase], Scalar[DrivenCase]


class Axes(Declared[DrivenCase]):
    t, x, P, drive, r, M, lag = DrawnAxis.some(7)


def axes_of(case: DrivenCase) -> dict[str, Axis]:
    reach = case.tallest
    powers = [column for one, column in powers_of(case).items() if one is not Power.t]
    least = min((float(column.min(initial=0.0)) for column in powers), default=0.0)
    most = max((float(column.max(initial=0.0)) for column in powers), default=0.0) or 1.0
    unit = {"force": "N", "base": "m", "unbalance": "kg m"}[case.kind]
    end = max(END, float(f"{1.1 * case.r:.2g}"))
    r = nice_axis(0.0, end * case.omega_n, "", 5, exact=True, factor=case.omega_n)
    peak = highest(case.zeta, case.kind)
    top = USUAL if peak and math.isinf(peak[1]) else min(max(1.1 * (peak[1] if peak else 1.0), LEAST), TALLEST)
    ticks = (0.0, math.pi / 2, math.pi)
    return by_name({
        Axes.t: time_axis(case.own_end),
        Axes.x: replace(nice_axis(-ROOM * reach, ROOM * reach, "m", 2, exact=True), drawn=(-reach, reach)),
        Axes.P: replace(nice_axis(1.1 * least, 1.15 * most, "W", 1, exact=True), drawn=(least, most)),
        Axes.drive: nice_axis(0.0, 1.25 * (case.size or 1.0), unit, exact=True),
        Axes.r: replace(r, drawn=(0.0, max(1.2, case.r) * case.omega_n), si="rad/s"),
        Axes.M: replace(nice_axis(0.0, top, "", 3, exact=True), drawn=(0.0, top / 1.1)),
        Axes.lag: Axis(0.0, 1.08 * math.pi, "rad", ticks=ticks, labels=("0", "π/2", "π"), drawn=(0.0, math.pi)),
    })  # fmt: skip


def _edge(axes: AxesInForce, rate: float) -> AnySignal:
    """One of the straight lines between which a swing grows."""
    return sines(Axes.x(axes), Axes.t(axes), line=(0.0, rate))


class Signals(Declared[DrivenCase]):
    """x from rest and from the start, its parts, the drive, and where the unbalance is."""

    x_driven = signal(lambda c, a: driven(Axes.x(a), Axes.t(a), c.push))
    x_free = signal(lambda c, a: damped(Axes.x(a), Axes.t(a), c.free[0]))
    x = signal(lambda c, a: total(Signals.x_driven, Signals.x_free), Axes.x, signed=True)
    F = signal(lambda c, a: sines(Axes.drive(a), Axes.t(a), (c.size, c.omega, 0.0)))
    sine = signal(lambda c, a: sines(ONE, Axes.t(a), (1.0, c.omega, 0.0)))
    cosine = signal(lambda c, a: sines(ONE, Axes.t(a), (1.0, c.omega, QUARTER)))
    y = signal(lambda c, a: sines(Axes.x(a), Axes.t(a), (c.size if c.kind == "base" else 0.0, c.omega, 0.0)))
    x_p = signal(lambda c, a: sines(Axes.x(a), Axes.t(a), (abs(c.X), c.omega, phase(c.X))) if c.split else None)
    x_c = signal(lambda c, a: damped(Axes.x(a), Axes.t(a), c.complementary) if c.split else None)
    upper = signal(lambda c, a: _edge(a, c.rate) if c.swells else None)
    lower = signal(lambda c, a: _edge(a, -c.rate) if c.swells else None)


def exact(case: DrivenCase, t: Floats) -> dict[Signal[DrivenCase], Floats]:
    """Return all that is drawn over time, in SI units; ValueError where that takes more work than a file has."""
    one, turned, S = case.oscillator, np.exp(1j * case.omega * t), Signals
    x = one.motion(case.omega, case.size, case.x_0, case.v_0, t, case.kind, FILE).x
    found = {S.x: x, S.y: case.size * turned.imag}
    if case.split:
        found |= {S.x_p: (case.X * turned).imag, S.x_c: one.free.motion(*case.start, t).x}
    return found | ({S.upper: case.rate * t, S.lower: -case.rate * t} if case.swells else {})


def drawn(case: DrivenCase) -> list[Signal[DrivenCase]]:
    """The signals that are drawn as curves over the whole window."""
    return [one for one in moving(case) if one not in fast_in(case)]


def fast_in(case: DrivenCase) -> dict[Signal[DrivenCase], tuple[Floats, Floats]]:
    """The motions of which something too fast for a line is seen: its middle and the reach of the band about it.

    Where a part has died so far that nothing is seen of it, the band is as narrow as the line that goes on.
    """
    if not case.split:
        nothing = np.zeros_like(case.t)
        return {} if drawable(case.fastest, case.t) else {one: (nothing, nothing + case.reach) for one in moving(case)}
    found = {}
    if case.trembles or case.settled:
        found[Signals.x] = case.slow_part, case.fast_size
    if case.trembles:
        found[Signals.x_p] = np.zeros_like(case.t), np.full_like(case.t, abs(case.X))
    if case.settled:
        found[Signals.x_c] = np.zeros_like(case.t), case.ringing
    if case.shaken and case.steady_is_fast:
        found[Signals.y] = np.zeros_like(case.t), np.full_like(case.t, case.size)
    return {one: found[one] for one in moving(case) if one in found}


def ringing(case: DrivenCase) -> bool:
    """Whether x and the part that dies are too fast for a line at first alone."""
    return Signals.x_c in fast_in(case) and not case.trembles and case.settled < case.t.size


def late(case: DrivenCase) -> Columns:
    """x, and the part that dies, from when nothing is seen any more of the ringing that is too fast for a line.

    They are drawn, so doubles will do: more digits would take longer than a picture may.
    """
    t = case.t[case.settled :]
    return by_name({Late.t: t, Signals.x: case.drawn(t)[0], Signals.x_c: case.complementary.at(t)})


class Late(Declared[DrivenCase]):
    """The instants of the curves that begin when a fast part has died."""

    t = Column[DrivenCase](LATE)


def moving(case: DrivenCase) -> list[Signal[DrivenCase]]:
    """x, its parts where they are told apart, the base, and the lines between which a swing grows."""
    base = [Signals.y] if case.shaken else []
    if case.split:
        return [Signals.x, Signals.x_c, *(base or [Signals.x_p])]
    return [Signals.x, *base, *([Signals.upper, Signals.lower] if case.swells else [])]


class Resonance(Declared[DrivenCase]):
    """The response and the lag over r, what drives, the steady swing in force, and the width at half the power.

    The power lost in the dashpot is drawn with its peak at Q, the height of the response at r = 1.
    """

    omega, M, lag, power = Column[DrivenCase].some(4, "below")
    driven = Family(KINDS, lambda kind: scalar(lambda c, a: c.kind == kind), "{}")
    r_at = scalar(lambda c, a: Axes.r(a).place(c.omega))
    root2 = scalar(lambda c, a: Axes.r(a).place(math.sqrt(2.0) * c.omega_n))
    steady = scalar(lambda c, a: c.steady)
    M_at = scalar(lambda c, a: Axes.M(a).place(c.M) if c.steady else None)
    M_held = scalar(lambda c, a: Axes.M(a).place(min(c.M, Axes.M(a).end)) if c.steady else None)
    lag_at = scalar(lambda c, a: Axes.lag(a).place(c.lag) if c.steady else None)
    half = scalar(lambda c, a: 0.5)
    width = scalar(lambda c, a: bool(c.half_power))
    Q = scalar(lambda c, a: Axes.M(a).place(0.5 / c.zeta) if c.half_power else 0.0)
    one_at = scalar(lambda c, a: Axes.r(a).place(c.omega_n))
    half_r = Family(ENDS, lambda i: scalar(lambda c, a: c.half_power and Axes.r(a).place(c.half_power[i])))
    half_Q = scalar(lambda c, a: Axes.M(a).place(0.25 / c.zeta) if c.half_power else 0.0)
    past_half = scalar(lambda c, a: Axes.r(a).place(c.past_half * c.omega_n) if c.half_power else 0.0)


class Places(dashpot.Has):
    side = scalar(lambda c, a: min(max(c.oscillator.m**0.15, 0.75), 1.25))
    wire = scalar(lambda c, a: wire(c.oscillator.k))
    per_reach = scalar(lambda c, a: ROOM / Axes.x(a).place(Axes.x(a).end))
    per_drive = scalar(lambda c, a: 1 / Axes.drive(a).place(Axes.drive(a).end))
    size = scalar(lambda c, a: (Axes.x if c.kind == "base" else Axes.drive)(a).place(c.size))


def _grid(case: DrivenCase, end: float) -> Floats:
    """Values of r, closer together about 1, where a light damping has its peak."""
    sharp = [1 - case.zeta * NEAR * 10, 1 + case.zeta * NEAR * 10] if 0 < case.zeta < 0.1 else []
    r = np.unique(np.concatenate([end * EVEN, 1 - NEAR, 1 + NEAR, *sharp, [1.0]]))
    return r[(r >= 0) & (r <= end)]


def columns_of(case: DrivenCase, axes: dict[str, Axis]) -> dict[str, Columns]:
    """The response and the lag below and above an undamped resonance, the powers, and the band."""
    r = _grid(case, Axes.r(axes).end / case.omega_n)
    X = magnification(r, case.zeta, case.kind)
    lags = np.array([lag(complex(one)) if np.isfinite(one) else math.pi / 2 for one in X])
    found = by_name({Resonance.omega: r * case.omega_n, Resonance.M: np.abs(X), Resonance.lag: lags})
    if case.half_power:
        found |= by_name({Resonance.power: 2 * case.zeta * (r * np.abs(X)) ** 2})
    below, above = ({name: column[at] for name, column in found.items()} for at in (r < 1, r > 1))
    sides = {"below": found, "above": {}} if case.zeta else {"below": below, "above": above}
    return {**sides, "power": by_name(powers_of(case)), **_bands(case)}


def _bands(case: DrivenCase) -> dict[str, Columns]:
    """The bands of what is too fast for a line, over the window or while it rings, and the lines that follow then."""
    whole, early, rings = Columns(), Columns(), ringing(case)
    for one, (middle, size) in fast_in(case).items():
        ends = dict(zip(band_columns(one.name), (middle - size, middle + size), strict=True))
        if rings and one in (Signals.x, Signals.x_c):
            early |= {name: column[: case.settled + 1] for name, column in ends.items()}
        else:
            whole |= ends
    found = {**bands_over_time(case.t, whole), RINGING: early and {"t": case.t[: case.settled + 1], **early}}
    return {**found, LATE: late(case) if rings else {}}
