"""The curves of the machine and its absorber: against drive frequency, and against time as the clock plays them."""

from __future__ import annotations

import cmath
import math
from typing import NamedTuple

import numpy as np
from msgspec.structs import replace

from components.language.expressions import var
from components.language.signals import AnySignal
from components.quantities.axes import Axis, nice_axis, nice_ticks, time_axis, widest
from components.quantities.declared import AxesInForce, Column, Declared, DrawnAxis, Signal, by_name
from components.quantities.motion import derived, responses, sampled, sines, total
from components.scene.traces import Columns, Floats, Traces, samples
from components.scenes.absorber.case import AbsorberCase
from physics.absorber_curves import machine_curves
from physics.coupled import Motion
from physics.forced import DrivenModes
from physics.precision.exact import exact, precise, rounded

TOP = (15.0, 20.0)
"""The upper ends of the axes of swing and stroke, in static deflections."""
NODES = 401
"""Number of points of a window, between which the browser interpolates by Hermite polynomials."""
DRAWN = 1e-11
"""Motions below this share of the largest one are too small to be drawn, and their tables are left out."""
TALLEST = 1e30
"""The largest motion that is drawn, in static deflections. Larger ones would overflow the browser's float32."""
ALONE, STARTED = "_alone", "1_rest"
"""Keys of the machine without its absorber, and of the machine's motion from its initial conditions, also if that is
not played."""
WHO: tuple[int | str, ...] = (ALONE, 1, 2)
"""The keys of the moving bodies as they are played; they include mass 1 (the machine) and mass 2 (the absorber)."""

signal, column = Signal[AbsorberCase], Column[AbsorberCase]
SignalsFound = dict[Signal[AbsorberCase], AnySignal]


class Axes(Declared[AbsorberCase]):
    """Axes of time, drive frequency, swing, stroke and the motion from initial conditions. F scales forces and is not
    drawn."""

    t, w, X1, X2, rest, F = DrawnAxis.some(6)


def axes_of(case: AbsorberCase, window: float) -> dict[str, Axis]:
    """Return all axes except the one of the motion from initial conditions."""
    own, omega = case.own, case.omega
    low, high = min(0.4 * own, 0.7 * omega), max(1.6 * own, 1.3 * omega)
    frequency = replace(nice_axis(low, high, "rad/s", 3, exact=True), drawn=(min(own, omega), max(own, omega)))
    swing, stroke = _size_axes(*map(case.deflections, TOP))
    return by_name({Axes.t: time_axis(window), Axes.w: frequency, Axes.X1: swing, Axes.X2: stroke})


def _size_axes(swing: float, stroke: float) -> tuple[Axis, Axis]:
    """Return axes of amplitudes from 0 to the given values in m, both in the same unit, millimetres where that is
    usual.
    """
    if 1e-4 <= swing < 1:
        one = Axis(0.0, swing, "mm", -3, ticks=nice_ticks(0.0, 1e3 * swing, 2))
    else:
        one = nice_axis(0.0, swing, "m", exact=True)
    two = replace(one, end=stroke, ticks=nice_ticks(0.0, one.place(stroke), 2))
    return replace(one, drawn=(0.0, swing / 2)), replace(two, drawn=(0.0, stroke / 2))


class Sweep(Declared[AbsorberCase]):
    """Curves against the drive frequency w: swing, stroke, swing without the absorber; the first two also without
    damping; the reduction of the swing.
    """

    w, swing, stroke, alone = column.some(4, "sweep")
    free, free2 = column.some(2, "compare")
    helped_lo, helped_hi = column.some(2, "helped")


def columns_of(case: AbsorberCase, axes: AxesInForce) -> dict[str, Columns]:
    """The curves, without frequencies at which the amplitude is infinite."""
    w = case.frequencies(Axes.w(axes).start, Axes.w(axes).end)
    curves = [*case.curves(w), *(machine_curves(case.chain, 0.0, case.F_0, w)[:2] if case.c else ())]
    known = np.isfinite(curves).all(axis=0)
    w, (swing, stroke, alone, *free) = w[known], np.asarray(curves)[:, known]
    low, high = case.band or (math.inf, 0.0)
    helps = (w >= low) & (w <= high)
    helped = {Sweep.w: w[helps], Sweep.helped_lo: swing[helps], Sweep.helped_hi: alone[helps]} if case.band else {}
    return {
        "sweep": by_name({Sweep.w: w, Sweep.swing: swing, Sweep.stroke: stroke, Sweep.alone: alone}),
        "helped": by_name(helped),
        "compare": by_name({Sweep.w: w, Sweep.free: free[0], Sweep.free2: free[1]} if free else {}),
    }


class FromStart(NamedTuple):
    """x1, x2 and x2 - x1 (3, n) from the start at times t (n,), and both parts. `in_doubles`: the terms of x1, summed
    in doubles, are right to all digits that are drawn.
    """

    t: Floats
    x: Floats
    particular: Floats | None = None
    complementary: Floats | None = None
    in_doubles: bool = True


def moved(case: AbsorberCase, t: Floats) -> FromStart:
    """Return the motion at times t, and its parts if they are drawn. Raise ValueError as `from_rest_at` does."""
    if not case.solved:
        return FromStart(t, _displacements(case.from_rest_at(t)))
    if case.c:
        particular, complementary = case.damped.particular_motion(t), case.damped.complementary(t)
    else:
        particular, complementary = _parts(case.driven, t)
    x = particular + complementary
    x[:, 0] = case.x_0[0], case.x_0[1], case.x_0[1] - case.x_0[0]
    one, stretch = case.bounds
    doubt = 2.0**-52 * (1 + case.fastest * t[-1]) * np.array([one, one + stretch, stretch])
    doubtful = doubt > DRAWN * np.abs(x).max(axis=1)
    if case.alike or np.any(doubtful):
        x = _displacements(case.from_rest_at(t))
    return FromStart(t, x, particular, complementary, not (case.alike or doubtful[0]))


def reach_alone(case: AbsorberCase, end: float) -> float:
    """The largest displacement of the machine without the absorber over [0, end], from the same start."""
    t, bare = times(case, end), case.bare
    x = np.add(*_parts(bare, t))[0] if bare.split_is_meaningful else bare.motion(t).x[0]
    return float(np.abs(x).max())


def times(case: AbsorberCase, end: float) -> Floats:
    """Return as many times as the fastest motion needs to be drawn."""
    return np.linspace(0.0, end, samples(end, case.fastest))


def _parts(driven: DrivenModes, t: Floats) -> tuple[Floats, Floats]:
    """Return x_p and x_c, (3, n) each, from amplitudes and phases."""
    free = driven.complementary_modes
    X, a, b = (_rows(masses) for masses in (driven.particular, free.drift_a, free.drift_b))
    modes = zip(free.amplitude, free.omega.tolist(), free.phase.tolist(), strict=True)
    swings = [_rows(amplitude) * np.sin(omega * t + phase) for amplitude, omega, phase in modes]
    return X * np.sin(driven.omega * t), a + b * t + sum(swings)


def _rows(masses: Floats) -> Floats:
    """Return x1, x2 and x2 - x1 as a column (3, 1), from x1 and x2 (2,)."""
    one, two = masses.tolist()
    return np.array([[one], [two], [two - one]])


def _displacements(motion: Motion) -> Floats:
    return np.array([*motion.x, motion.e[1]])


class Signals(Declared[AbsorberCase]):
    """The drive; the displacements, with their response to the drive and their free motion, and the parts of x1; the
    force of spring and damper, which is drawn over the drive.
    """

    drive = signal()
    drive_now = signal(on=Axes.F, signed=True)
    driven = signal.each(WHO, "x{}_driven")
    free = signal.each(WHO, "x{}_free")
    x = signal.each((*WHO, STARTED), "x{}", on=Axes.X1, signed=True)
    pull_now = signal(on=Axes.F, signed=True)
    x1_p, x1_c, pull = signal.some(3)


S = Signals


def rest_of(
    case: AbsorberCase, motion: FromStart | None, end: float, unit: Axis
) -> tuple[Axis, dict[str, Columns], dict[str, Traces]]:
    """x1 from its start and its parts, on an axis in the unit of `unit`, as columns or as traces of signals. Near a
    natural frequency, where the parts are huge and opposite, only x1.
    """
    if motion is None:
        return replace(unit, start=-unit.end), {"rest": {}}, {}
    columns = _exact(motion)
    low, high = widest(*((float(c.min()), float(c.max())) for c in columns.values()))
    if case.over_deflection(max(-low, high)) > TALLEST:
        raise ValueError(
            f"the motion is too large to be drawn: at most {TALLEST:g} static deflections F_0/k1 are allowed"
        )
    room = 0.08 * (high - low)
    ticks = nice_ticks(unit.place(low), unit.place(high), 3) if high > low else (0.0,)
    axis = replace(unit, start=low - (room or abs(low)), end=high + (room or abs(high) or unit.end), ticks=ticks)
    names = tuple(columns)
    drawn, sent = (names, {}) if motion.in_doubles else ((), {"t": motion.t, **columns})
    traces = Traces(
        end,
        motion.t.size,
        drawn,
        lambda t: _exact(moved(case, t)),
        signals=by_name({S.x[1]: S.x[STARTED].name}),
        fastest=case.fastest,
        moving=names,
    )
    return axis, {"rest": sent}, {"rest": traces}


def _exact(motion: FromStart) -> Columns:
    """x1, and its parts if they are drawn."""
    if motion.particular is None or motion.complementary is None:
        return by_name({S.x[1]: motion.x[0]})
    return by_name({S.x[1]: motion.x[0], S.x1_p: motion.particular[0], S.x1_c: motion.complementary[0]})


def signals_of(case: AbsorberCase, motion: FromStart | None, end: float, axes: AxesInForce) -> dict[str, AnySignal]:
    """The machine with and without absorber: the particular solution, or the motion from its start and its parts."""
    size, time, push = Axes.X1(axes), Axes.t(axes), Axes.F(axes)
    found: SignalsFound = {
        S.drive: sines(Axis(0.0, 1.0), time, (1.0, case.omega, 0.0)),
        S.drive_now: sines(push, time, (case.F_0, case.omega, 0.0)),
    }
    if case.plays_alone:
        found[S.x[ALONE]] = sines(size, time, (float(case.bare.particular[0]), case.omega, 0.0))
    else:
        found |= _from_start(case.bare, 0, ALONE, size, time)
    if case.plays:
        for i, X in enumerate(case.X):
            found[S.x[i + 1]] = sines(size, time, (abs(X), case.omega, float(np.angle(X))))
        found[S.pull_now] = sines(push, time, (case.pull, case.omega, float(np.angle(complex(case.X[1])))))
    elif case.c:
        found |= _damped(case, end, size, time, push)
    else:
        found |= _from_start(case.driven, 0, 1, size, time) | _from_start(case.driven, 1, 2, size, time)
        with precise():
            k2 = rounded("the pull of spring 2", exact(case.k2).scaleb(size.exponent - push.exponent))
        found[S.pull_now] = derived(k2 * (var(S.x[2]) - var(S.x[1])))
    if motion and motion.in_doubles:
        found |= _machine_from_start(case, size, time) if case.plays else {S.x[STARTED]: derived(var(S.x[1]))}
    if motion and motion.in_doubles and motion.particular is not None:
        X = complex(case.damped.particular[0]) if case.c else complex(case.driven.particular[0])
        found[S.x1_p] = sines(size, time, (abs(X), case.omega, cmath.phase(X)))
        found[S.x1_c] = derived(var(S.x[STARTED]) - var(S.x1_p))
    found[S.pull] = derived(var(S.pull_now) / push.place(case.F_0))
    return by_name(found)


def _from_start(driven: DrivenModes, i: int, who: int | str, size: Axis, time: Axis) -> SignalsFound:
    """The motion of mass i (0, 1): the response to the drive, plus the free motion of a start."""
    terms = zip(driven.coupling[:, i].tolist(), driven.free.omega.tolist(), strict=True)
    response = responses(size, time, *((driven.F_0, c, driven.omega, omega_n) for c, omega_n in terms if c))
    if not any((*driven.x_0, *driven.v_0)):
        return {S.x[who]: response}
    free = driven.free
    swings = [(free.amplitude[j, i], free.omega[j], free.phase[j]) for j in (0, 1) if free.amplitude[j, i]]
    moving = sines(size, time, *swings, line=(float(free.drift_a[i]), float(free.drift_b[i])))
    return {S.driven[who]: response, S.free[who]: moving, S.x[who]: total(S.driven[who], S.free[who])}


def _damped(case: AbsorberCase, end: float, size: Axis, time: Axis, push: Axis) -> SignalsFound:
    """x1, x2 and the force of spring and damper from rest, as decaying sines; if two exponents are almost equal, from a
    table.
    """
    if case.alike:
        return _tables(case, end, size, time, push)
    transient = case.damped.transient
    found = _decaying(case, 0, 1, size, time) | _decaying(case, 1, 2, size, time)
    # m2 x2'' is the force of spring and damper on mass 2; the force on mass 1 is opposite.
    X2 = case.m2 * case.omega**2 * complex(case.damped.particular[1])
    pulls = [_wave(-case.m2 * exponent**2 * amplitudes[0, 1], exponent) for exponent, amplitudes in transient]
    return found | {S.pull_now: sines(push, time, (abs(X2), case.omega, cmath.phase(X2)), *pulls)}


def _decaying(case: AbsorberCase, i: int, who: int | str, size: Axis, time: Axis) -> SignalsFound:
    """The motion of mass i (0, 1) from its start, with damping."""
    X = complex(case.damped.particular[i])
    terms = [_wave(amplitudes[0, i], exponent) for exponent, amplitudes in case.damped.transient]
    return {S.x[who]: sines(size, time, (abs(X), case.omega, cmath.phase(X)), *terms)}


def _machine_from_start(case: AbsorberCase, size: Axis, time: Axis) -> SignalsFound:
    """The motion of the machine from its start, drawn next to the motion that is played."""
    return _decaying(case, 0, STARTED, size, time) if case.c else _from_start(case.driven, 0, STARTED, size, time)


def _wave(amplitude: complex, exponent: complex) -> tuple[float, float, float, float]:
    """Return Re(A exp(s t)) as a decaying sine."""
    return abs(amplitude), exponent.imag, cmath.phase(amplitude) + math.pi / 2, -exponent.real


def _tables(case: AbsorberCase, end: float, size: Axis, time: Axis, push: Axis) -> SignalsFound:
    last = 1.02 * end  # longer than the window, because the browser repeats a table after its period
    t = np.linspace(0.0, last, NODES)
    motion = case.from_rest_at(t)
    link = push.places(case.k2 * motion.e[1] + case.c * (motion.v[1] - motion.v[0]))
    columns = {S.x[i + 1]: (size.places(motion.x[i]), size.places(motion.v[i])) for i in (0, 1)}
    columns[S.pull_now] = link, np.gradient(link, t)
    return {one: sampled(time, last, *pair) for one, pair in columns.items()}
