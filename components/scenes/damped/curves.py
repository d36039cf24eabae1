"""The curves of the damped mass: their axes, their signals, and what is drawn where a swing is too fast for a line."""

from __future__ import annotations

import numpy as np
from msgspec.structs import replace

from components.language.numbers import var
from components.language.signals import AnySignal
from components.quantities.axes import Axis, nice_axis, time_axis, whole_axis
from components.quantities.declared import AxesInForce, Column, Declared, DrawnAxis, Signal, by_name
from components.quantities.motion import QUARTER, damped, derived, scaled, sines, total
from components.scene.traces import Columns, Floats, bands_about_zero, samples
from components.scenes.damped.case import DampedCase
from physics.energy import half_square
from physics.sampling import drawable

ROOM = 1.25
"""The reach of x(t), in its largest value."""
LEFT, RIGHT, UP = 1.55, 0.88, 1.28
"""The reach of the plane of the roots, in natural frequencies."""
FEW = 4.0
"""Parts more than this many times as large as their sum are not drawn."""

signal = Signal[DampedCase]


def instants(case: DampedCase) -> Floats:
    return np.linspace(0.0, case.end, samples(case.end, case.fastest))


class Axes(Declared[DampedCase]):
    t, x, v, E, P, re, im = DrawnAxis.some(7)


def axes_of(case: DampedCase) -> dict[str, Axis]:
    one, reach = case.oscillator, case.reach or abs(case.x_0) or 1.0
    x = replace(nice_axis(-ROOM * reach, ROOM * reach, "m", 2, exact=True), drawn=(-reach, reach))
    speed, power = abs(case.top.v), case.P_max
    E = whole_axis(case.E_0 or 1.0, "J")
    circle = one.omega_n or one.rates[1] or 1.0
    return by_name({
        Axes.t: time_axis(case.own_end),
        Axes.x: x,
        Axes.v: nice_axis(0.0, speed or 1.0, "m/s", exact=True),
        Axes.E: replace(E, end=1.08 * E.end, drawn=(0.0, E.end)),
        Axes.P: replace(nice_axis(0.0, 1.15 * (power or 1.0), "W", 2, exact=True), drawn=(0.0, power or 1.0)),
        Axes.re: Axis(-LEFT * circle, RIGHT * circle, "1/s", drawn=(-circle, 0.0)),
        Axes.im: Axis(-UP * circle, UP * circle, "1/s", drawn=(-circle, circle)),
    })  # fmt: skip


def _part(case: DampedCase, axes: AxesInForce, size: float, rate: int) -> AnySignal:
    """One of the exponentials, slow (0) or fast (1)."""
    return sines(Axes.x(axes), Axes.t(axes), (size, 0.0, QUARTER, case.oscillator.rates[rate]))


def _square(of: Signal[DampedCase], counted: Axis, on: Axis, *factors: float) -> AnySignal:
    """The square of a signal, with these factors, in the unit of the axis `on`."""
    return derived(scaled(on.exponent - 2 * counted.exponent, *factors) * var(of) * var(of))


class Signals(Declared[DampedCase]):
    """x and v, the envelope and the parts of x, the energies and their stack, and the power of the dashpot."""

    x = signal(lambda c, a: damped(Axes.x(a), Axes.t(a), c.fadings[0]), Axes.x, signed=True)
    v = signal(lambda c, a: damped(Axes.v(a), Axes.t(a), c.fadings[1]))
    upper = signal(lambda c, a: _part(c, a, c.envelope, 0))
    lower = signal(lambda c, a: _part(c, a, -c.envelope, 0))
    slow = signal(lambda c, a: _part(c, a, c.fading.late[0], 0))
    fast = signal(lambda c, a: _part(c, a, c.fading.late[1], 1))
    zero = signal(lambda c, a: derived(0.0))
    T = signal(lambda c, a: _square(Signals.v, Axes.v(a), Axes.E(a), 0.5, c.oscillator.m), Axes.E)
    V = signal(lambda c, a: _square(Signals.x, Axes.x(a), Axes.E(a), 0.5, c.oscillator.k), Axes.E)
    E = signal(lambda c, a: total(Signals.V, Signals.T))
    E_0 = signal(lambda c, a: derived(Axes.E(a).place(c.E_0)))
    heat = signal(lambda c, a: derived(var(Signals.E_0) - var(Signals.E)), Axes.E)
    P = signal(lambda c, a: _square(Signals.v, Axes.v(a), Axes.P(a), c.oscillator.c), Axes.P)


STACK = (Signals.zero, Signals.V, Signals.E, Signals.E_0)
LAYERS = {Signals.T: (Signals.V, Signals.E), Signals.heat: (Signals.E, Signals.E_0)}
"""What the stack shows between two of its edges."""


def exact(case: DampedCase, t: Floats) -> dict[Signal[DampedCase], Floats]:
    """The numbers of all that is drawn over time, in SI units."""
    one, motion, S = case.oscillator, case.oscillator.motion(case.x_0, case.v_0, t), Signals
    V, T = half_square("V", one.k, motion.x), half_square("T", one.m, motion.v)
    slow, fast = (size * np.exp(-rate * t) for size, rate in zip(case.fading.late, one.rates, strict=True))
    upper = case.envelope * np.exp(-one.rates[0] * t)
    return {
        S.x: motion.x, S.upper: upper, S.lower: -upper, S.slow: slow, S.fast: fast, S.zero: np.zeros_like(t),
        S.V: V, S.T: T, S.E: V + T, S.E_0: np.full_like(t, case.E_0), S.heat: case.E_0 - (V + T),
        S.P: 2 * half_square("P", one.c, motion.v),
    }  # fmt: skip


def drawn(case: DampedCase, t: Floats) -> list[Signal[DampedCase]]:
    """The signals that are drawn as curves over time."""
    found = [Signals.x] if drawable(case.oscillator.omega_d, t) else []
    energies = [*STACK, *_power(case)] if drawable(2 * case.oscillator.omega_d, t) else []
    return [*found, *_shape(case), *energies]


def moving(case: DampedCase) -> list[Signal[DampedCase]]:
    """All of them, and the energies that are drawn as layers."""
    S = Signals
    heat = [S.heat] if case.oscillator.c else []
    return [S.x, *_shape(case), S.V, S.T, S.E, S.E_0, *heat, *_power(case)]


def _shape(case: DampedCase) -> list[Signal[DampedCase]]:
    """The envelope of a swing, or the two exponentials."""
    envelope = [Signals.upper, Signals.lower] if case.kind == "under" else []
    return [*envelope, *([Signals.slow, Signals.fast] if parts_shown(case) else [])]


def _power(case: DampedCase) -> list[Signal[DampedCase]]:
    return [Signals.P] if case.oscillator.c else []


def parts_shown(case: DampedCase) -> bool:
    """Whether the two exponentials are drawn: near critical damping they are huge and opposite."""
    return case.kind == "over" and max(map(abs, case.fading.late)) < FEW * case.reach


TURN = np.linspace(np.pi / 2, 3 * np.pi / 2, 49)


class Locus(Declared[DampedCase]):
    """The roots for other dampings of the same mass and spring: half a circle."""

    re = Column[DampedCase]("locus", lambda c: c.omega * np.cos(TURN if c.omega else []))
    im = Column[DampedCase]("locus", lambda c: c.omega * np.sin(TURN if c.omega else []))


def columns_of(case: DampedCase, t: Floats) -> dict[str, Columns]:
    """Where a swing is too fast for a line: the band of x, and energies and power averaged over it."""
    one = case.oscillator
    decay = np.exp(-one.rates[0] * t)
    reach = {} if drawable(one.omega_d, t) else {Signals.x: case.envelope * decay}
    columns = {**Locus.columns(case), **bands_about_zero(t, reach)}
    if drawable(2 * one.omega_d, t):
        return columns
    E = case.E_0 * decay * decay
    levels = dict(zip(STACK, (np.zeros_like(t), E / 2, E, np.full_like(t, case.E_0)), strict=True))
    power = {Signals.P: E * 2 * one.rates[0]} if one.c else {}
    return {**columns, "time": by_name({**levels, **power})}
