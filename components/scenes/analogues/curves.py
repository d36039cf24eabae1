"""The curves of the analogues, their axes, the columns of the delay, and the positions on their stage."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
from msgspec.structs import replace

from components.language.expressions import Expression, var
from components.quantities.axes import ONE, Axis, nice_axis, time_axis
from components.quantities.declared import AxesInForce, Column, Declared, DrawnAxis, Family, Scalar, Signal, by_name
from components.quantities.formatting import MINUS, short
from components.quantities.motion import QUARTER, cosine_of, derived, sampled, sine_of, sines
from components.scene.traces import BAND, Columns, Floats, Traces, bands_about_zero, samples
from components.scenes.analogues.case import DEGREE, AnalogueCase
from components.scenes.analogues.reach import LARGEST
from physics.analogues import ANALOGUES
from physics.pendulum import amplitude_at_excess, excess

LIMITS = {"01": 0.001, "1": 0.01, "5": 0.05}
"""Values of T/T_0 - 1 that have a flag."""
ANGLES = {key: math.degrees(amplitude_at_excess(value)) for key, value in LIMITS.items()}
"""Initial angles in degrees at which the relative delay has these values."""

signal, scalar, of_late = Signal[AnalogueCase], Scalar[AnalogueCase], Column[AnalogueCase]


class Axes(Declared[AnalogueCase]):
    """Axes of the plots, and axes for x, q and energies in the table."""

    t, q, angle, late, table, energy = DrawnAxis.some(6)


def axes_of(case: AnalogueCase) -> dict[str, Axis]:
    """The axes of the plots. The axes of angle and delay end at 90 degrees and 19 %, or later if the initial angle is
    larger."""
    wide = case.pendulum is not None and abs(case.q_0) > 88 * DEGREE
    end, step = (180, 60) if wide else (90, 30)
    ticks, here = tuple(float(tick) for tick in range(0, end + 1, step)), math.degrees(abs(case.q_0))
    late = nice_axis(0.0, max(1.25 * case.excess, 0.19), "%", 2, exact=True, factor=0.01)
    return by_name({
        Axes.t: time_axis(case.own_end),
        Axes.q: _coordinate_axis(case),
        Axes.angle: Axis(0.0, end, "°", ticks=ticks, drawn=(0.0, here if case.pendulum else 0.0)),
        Axes.late: replace(late, drawn=(0.0, case.excess)),
    })  # fmt: skip


def _coordinate_axis(case: AnalogueCase) -> Axis:
    """The axis of the coordinate, with ticks at the amplitude; angles of pendulums in degrees."""
    unit, factor = ("°", DEGREE) if case.pendulum else (case.system.unit, 1.0)
    size = abs(case.q_0)
    axis = nice_axis(-size, size, unit, factor=factor)
    top = axis.place(size) or 1.0
    text = f"{top:.4g}" if 1 <= top < 1000 else short(top)
    labels = (MINUS + text, "0", text + axis.gap + axis.full_unit)
    start, end = 1.3 * -size or axis.start, 1.3 * size or axis.end
    return replace(axis, start=start, end=end, ticks=(-top, 0.0, top), labels=labels, drawn=(-size, size))


def table_axes(case: AnalogueCase) -> dict[str, Axis]:
    table = nice_axis(-abs(case.q_0), abs(case.q_0), case.system.unit)
    return by_name({Axes.table: table, Axes.energy: nice_axis(0.0, case.energy, "J")})


class Places(Declared[AnalogueCase]):
    """The chosen system, its sizes on the stage, and its number of half waves if it is a string or a column of air."""

    of = Family(ANALOGUES, lambda slug: scalar(), "{}")
    amplitude = scalar(lambda c, a: Axes.q(a).place(abs(c.q_0)))
    per_q = scalar(lambda c, a: 1.3 / Axes.q(a).place(Axes.q(a).end))
    size = scalar(lambda c, a: math.copysign(min(abs(c.q_0) / (LARGEST * c.system.swing), 1.0), c.q_0))
    half_waves = scalar(lambda c, a: c.half_waves)
    along = scalar(lambda c, a: 10 / c.half_waves)
    belly = scalar(lambda c, a: 0.5 / c.half_waves)


class Signals(Declared[AnalogueCase]):
    """cos and sin of omega t; q as a share of the amplitude; numbers computed from these."""

    cosine = signal(lambda c, a: sines(ONE, Axes.t(a), (1.0, c.omega, QUARTER)))
    sine = signal(lambda c, a: sines(ONE, Axes.t(a), (1.0, c.omega, 0.0)))
    share = signal(lambda c, a: sampled(Axes.t(a), c.period, *c.swings.share) if c.pendulum else derived(COSINE))
    root = signal(lambda c, a: sampled(Axes.t(a), c.period, *c.swings.root) if c.pendulum else derived(COSINE))
    level = signal(lambda c, a: derived(Axes.q(a).place(c.q_0) * SHARE), Axes.q, signed=True)
    pose = signal(lambda c, a: derived(var(Places.size) * SHARE))
    rule = signal(lambda c, a: derived(Axes.q(a).place(c.q_0) * COSINE))
    x = signal(lambda c, a: derived(Axes.table(a).place(c.q_0) * COSINE), Axes.table, signed=True)
    q = signal(lambda c, a: derived(Axes.table(a).place(c.q_0) * SHARE), Axes.table, signed=True)
    T_x = signal(lambda c, a: derived(Axes.energy(a).place(c.energy) * SINE_SQUARED), Axes.energy)
    V_x = signal(lambda c, a: derived(Axes.energy(a).place(c.energy) * COSINE_SQUARED), Axes.energy)
    T_q = signal(lambda c, a: derived(Axes.energy(a).place(c.exact_energy) * REST), Axes.energy)
    V_q = signal(lambda c, a: derived(Axes.energy(a).place(c.exact_energy) * ROOT_SQUARED), Axes.energy)


class Swinging(Signals):
    """The signals of the moving part, with its angle and that of the small-angle approximation."""

    angle = signal(lambda c, a: derived(c.q_0 * SHARE))
    rule_angle = signal(lambda c, a: derived(c.q_0 * COSINE))
    angle_sine = signal(lambda c, a: sine_of(Swinging.angle))
    angle_cosine = signal(lambda c, a: cosine_of(Swinging.angle))
    rule_sine = signal(lambda c, a: sine_of(Swinging.rule_angle))
    rule_cosine = signal(lambda c, a: cosine_of(Swinging.rule_angle))


COSINE: Expression = var(Signals.cosine)
SHARE: Expression = var(Signals.share)
COSINE_SQUARED: Expression = COSINE * COSINE
SINE_SQUARED: Expression = var(Signals.sine) * var(Signals.sine)
ROOT_SQUARED: Expression = var(Signals.root) * var(Signals.root)
REST: Expression = 1 - ROOT_SQUARED


def exact(case: AnalogueCase, t: Floats) -> Columns:
    """The coordinate q, and the displacement x of the spring."""
    q = x = case.spring.motion(case.q_0, 0.0, t).x
    if case.pendulum:
        motion, size = case.swing(t)
        q = motion.theta * (case.q_0 / size)
    return by_name({Signals.x: x, Signals.q: q})


def traces_of(case: AnalogueCase) -> Traces:
    """Curves of x and q from signals, on the axis of q; none if they are too fast to draw."""
    of = {Signals.x.name: Signals.rule.name, Signals.q.name: Signals.level.name}
    names = tuple(of) if case.drawable else ()
    count = samples(case.end, case.omega)
    return Traces(case.end, count, names, lambda t: exact(case, t), of, fastest=case.omega, moving=tuple(of))


class Lateness(Declared[AnalogueCase]):
    """T/T_0 - 1 against the angle in degrees: as a curve, at the flags, and at the current start."""

    angle, excess = of_late.some(2, "late")
    limit_angle = of_late("limits", lambda c: np.array(list(ANGLES.values())), "angle")
    limit = of_late("limits", lambda c: np.array(list(LIMITS.values())), "excess")
    here_angle = of_late("here", lambda c: np.array([math.degrees(abs(c.q_0))]), "angle")
    here = of_late("here", lambda c: np.array([c.excess]), "excess")


@cache
def _lateness(end: float) -> Columns:
    """The curve of the delay up to `end` degrees."""
    angles = np.linspace(0.0, min(end, 179.9), 121)
    return by_name({Lateness.angle: angles, Lateness.excess: np.array([excess(math.radians(a)) for a in angles])})


def columns_of(case: AnalogueCase, axes: AxesInForce) -> dict[str, Columns]:
    """A pendulum's delay, and the bands of q and x if they are too fast to draw."""
    late = {"late": _lateness(Axes.angle(axes).end), **Lateness.columns(case)} if case.pendulum else {}
    columns: dict[str, Columns] = {"late": {}, "limits": {}, "here": {}, **late, BAND: {}}
    if not case.drawable:
        t = np.linspace(0.0, case.end, samples(case.end, case.omega))
        columns |= bands_about_zero(t, dict.fromkeys((Signals.x, Signals.q), abs(case.q_0)))
    return columns


class Hung(Declared[AnalogueCase]):
    """The positions of the moving part, of its ends, and of the mark of its delay. A pendulum above its pivot is drawn
    shorter."""

    pivot = scalar(lambda c, a: 0.2 if abs(c.q_0) <= 91 * DEGREE else 0.48)
    rod = scalar(lambda c, a: 0.45 if abs(c.q_0) <= 91 * DEGREE else 0.24)
    theta_0 = scalar(lambda c, a: abs(c.q_0))
    ends_seen = scalar(lambda c, a: abs(c.q_0) < 150 * DEGREE)
    end_sine = scalar(lambda c, a: math.sin(abs(c.q_0)))
    end_cosine = scalar(lambda c, a: math.cos(abs(c.q_0)))
    size_angle = scalar(lambda c, a: math.degrees(abs(c.q_0)))
    late_now = scalar(lambda c, a: Axes.late(a).place(c.excess))
    rule_seen = scalar(lambda c, a: 1.0)
    late = Family(LIMITS, lambda key: scalar(lambda c, a: round(ANGLES[key], 4)))


class Ends(Declared[AnalogueCase]):
    """The ends of three cycles of the approximation and of the exact motion; for a linear system, its first peaks."""

    late_seen = scalar(lambda c, a: c.pendulum is not None)
    period_seen = scalar(lambda c, a: c.pendulum is None)
    first = scalar(lambda c, a: Axes.t(a).place(3 * c.spring.period if c.pendulum else c.period))
    second = scalar(lambda c, a: Axes.t(a).place((3 if c.pendulum else 2) * c.period))


def scalars_of(case: AnalogueCase, axes: AxesInForce) -> dict[str, float]:
    """The positions of the chosen system. Peaks that are not drawn or outside the frame have no mark."""
    found = Places.scalars(case, axes) | by_name({Places.of[case.system.slug]: 1.0})
    if case.pendulum:
        found |= Hung.scalars(case, axes)
    if case.drawable and abs(case.q_0) <= Axes.q(axes).end and case.end >= (3.1 if case.pendulum else 2) * case.period:
        found |= Ends.scalars(case, axes)
    return found
