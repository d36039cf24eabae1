"""The curves of the oscillator, their axes, and the places on its stage: of mass, turning arrow and marked peaks."""

from __future__ import annotations

import math

import numpy as np
from msgspec.structs import replace

from components.language.numbers import var
from components.language.signals import AnySignal
from components.layout.stage import wire
from components.quantities.axes import ONE, Axis, nice_axis, time_axis
from components.quantities.declared import AxesInForce, Declared, DrawnAxis, Family, Scalar, Signal, by_name
from components.quantities.motion import QUARTER, derived, scaled, sines
from components.quantities.numbers import MINUS, power_unit, three
from components.scene.traces import Columns, Floats, bands_about_zero, samples
from components.scenes.oscillator.case import Oscillation

UNITS = ("m", "m/s", "m/s²")
ROOM = ((1.25, 1.25), (1.15, 1.6), (1.2, 1.75))
"""The reach of the axes of x, v and a below and above, in amplitudes; over v and a stand the marks of the quarter
period."""

signal, scalar = Signal[Oscillation], Scalar[Oscillation]


class Axes(Declared[Oscillation]):
    t, x, v, a, a_bare, F = DrawnAxis.some(6)


OF_ROWS = (Axes.x, Axes.v, Axes.a)


def axes_of(case: Oscillation) -> dict[str, Axis]:
    """Ticks stand at the amplitudes; the path of a free mass has round ones."""
    x, v, a = (_amplitude_axis(case, i) for i in range(3))
    if not case.omega and case.v_0:
        ends = 0.0, case.x_0, case.x_0 + case.v_0 * case.end
        low, high = min(ends), max(ends)
        power_unit(2 * (high - low))
        x = nice_axis(low, high, "m")
    bare = replace(a, labels=("",) * len(a.ticks))
    return by_name({Axes.t: time_axis(case.own_end), Axes.x: x, Axes.v: v, Axes.a: a, Axes.a_bare: bare})


def _amplitude_axis(case: Oscillation, i: int) -> Axis:
    """The axis of x, v or a; on those under marks these must be seen too."""
    size, unit, (below, above) = case.amplitudes[i], UNITS[i], ROOM[i]
    if not size:
        return Axis(-below, above, unit, ticks=(0.0,), labels=(f"0 {unit}",), drawn=(0.0, 0.0))
    power_unit(above * size)
    exponent, suffix = power_unit(size)
    seen = 0.95 * above if i and case.turns else 1.0
    bare = Axis(-below * size, above * size, unit, exponent, suffix, drawn=(-size, seen * size))
    top = bare.place(size)
    text = three(top)
    return replace(bare, ticks=(-top, 0.0, top), labels=(MINUS + text, "0", f"{text} {bare.full_unit}"))


def force_axis(case: Oscillation) -> dict[str, Axis]:
    """The axis on which the force is counted, up to its largest; no plot has it."""
    largest = scaled(0, case.oscillator.k, max(case.amplitudes[0], abs(case.x_0)))
    return by_name({Axes.F: nice_axis(0.0, largest or 1.0, "N", exact=True)})


def _row(case: Oscillation, axes: AxesInForce, i: int) -> AnySignal:
    """x, v or a."""
    size, time = OF_ROWS[i](axes), Axes.t(axes)
    if not case.omega:
        return sines(size, time, line=((case.x_0, case.v_0), (case.v_0, 0.0), (0.0, 0.0))[i])
    return sines(size, time, (case.amplitudes[i], case.omega, case.constants.phi + i * QUARTER))


class Signals(Declared[Oscillation]):
    """x, v and a, and the direction of the arrow."""

    x = signal(lambda c, a: _row(c, a, 0), Axes.x, signed=True)
    v = signal(lambda c, a: _row(c, a, 1))
    a = signal(lambda c, a: _row(c, a, 2))
    cosine = signal(lambda c, a: sines(ONE, Axes.t(a), (1.0, c.omega, c.constants.phi + QUARTER)) if c.omega else None)
    sine = signal(lambda c, a: sines(ONE, Axes.t(a), (1.0, c.omega, c.constants.phi)) if c.omega else None)


class Pulled(Signals):
    """The motion with the force of the spring, F = -k x."""

    F = signal(
        lambda c, a: derived(-scaled(Axes.F(a).exponent - Axes.x(a).exponent, c.oscillator.k) * var(Signals.x)),
        Axes.F, signed=True,
    )  # fmt: skip


ROWS = (Signals.x, Signals.v, Signals.a)


def exact(case: Oscillation, t: Floats) -> dict[Signal[Oscillation], Floats]:
    """x, v and a in SI units."""
    motion = case.oscillator.motion(case.x_0, case.v_0, t)
    return dict(zip(ROWS, (motion.x, motion.v, motion.a), strict=True))


def bands_of(case: Oscillation) -> dict[str, Columns]:
    """The bands that x, v and a fill where they are too fast to draw."""
    t = np.linspace(0.0, case.end, samples(case.end, case.omega))
    return bands_about_zero(t, dict(zip(ROWS, case.amplitudes, strict=True)))


class Places(Declared[Oscillation]):
    side = scalar(lambda c, a: min(max(math.sqrt(c.oscillator.m), 0.5), 1.5))
    wire = scalar(lambda c, a: wire(c.oscillator.k))
    forced = scalar(lambda c, a: c.view == "force" and c.oscillator.k > 0)
    per_window = scalar(lambda c, a: 1 / Axes.t(a).place(c.end))
    per_x = scalar(lambda c, a: 1 / (Axes.x(a).place(max(abs(Axes.x(a).start), Axes.x(a).end)) / ROOM[0][0]))


class Turning(Declared[Oscillation]):
    """The arrow that turns, its start with the legs A and B, and where atan would send it."""

    turns = scalar(lambda c, a: 1.0)
    swings = scalar(lambda c, a: c.end / c.oscillator.period if c.drawable else None)
    per_v = scalar(lambda c, a: scaled(Axes.x(a).exponent - Axes.v(a).exponent, 1 / c.omega))
    x_start = scalar(lambda c, a: Axes.x(a).place(c.x_0))
    v_start = scalar(lambda c, a: Axes.v(a).place(c.v_0))
    C = scalar(lambda c, a: Axes.x(a).place(c.constants.C))
    phi = scalar(lambda c, a: c.constants.phi)
    start_cosine = scalar(lambda c, a: math.cos(c.constants.phi))
    start_sine = scalar(lambda c, a: math.sin(c.constants.phi))
    middle_cosine = scalar(lambda c, a: math.cos(c.constants.phi / 2.6))
    middle_sine = scalar(lambda c, a: math.sin(c.constants.phi / 2.6))
    under = scalar(lambda c, a: math.copysign(1, c.constants.phi))
    outside = scalar(lambda c, a: math.copysign(1, math.cos(c.constants.phi)))
    has_A = scalar(lambda c, a: abs(math.sin(c.constants.phi)) > 0.15)
    has_B = scalar(lambda c, a: abs(math.cos(c.constants.phi)) > 0.15)
    has_phi = scalar(lambda c, a: abs(c.constants.phi) > 0.4)
    atan = scalar(lambda c, a: c.v_0 < 0)


class Marks(Declared[Oscillation]):
    """The last peak of x in the window, and those of v and a before it."""

    leads = scalar(lambda c, a: 1.0)
    peak = Family(range(3), lambda i: scalar(lambda c, a: Axes.t(a).place((c.last_peak - i / 4) * c.oscillator.period)))
    top = Family(range(3), lambda i: scalar(lambda c, a: OF_ROWS[i](a).place(c.amplitudes[i])))


def scalars_of(case: Oscillation, axes: AxesInForce) -> dict[str, float]:
    """Places of what turns or is marked are given where it does; no peak is marked that has left its frame."""
    found = Places.scalars(case, axes)
    if case.turns:
        found |= Turning.scalars(case, axes)
    if case.last_peak and all(case.amplitudes[i] <= axis(axes).end for i, axis in enumerate(OF_ROWS)):
        found |= Marks.scalars(case, axes)
    return found
