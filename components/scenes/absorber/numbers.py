"""The live numbers of the machine and its absorber."""

from __future__ import annotations

import math

import numpy as np

from components.quantities.axes import Axis
from components.quantities.declared import AxisUnit, Declared, LiveNumber
from components.quantities.numbers import three
from components.scenes.absorber.duty import Duty
from components.scenes.absorber.played import pull
from physics.absorber import den_hartog, highest_peak
from physics.exact import exact, precise

number = LiveNumber[Duty]


def length(axis: Axis, value: float) -> str:
    """Three digits; what is below 5 µm, or is what rounding leaves of nothing, is zero."""
    if not np.isfinite(value):
        return three(value)
    least = 0.005 if axis.unit == "mm" else 1e-9 * axis.place(axis.end)
    with precise():
        place = exact(value).scaleb(-axis.exponent)
    return three(place) if abs(place) >= least else "0.00"


def bound(duty: Duty, i: int) -> float | None:
    """The bound that swing (0) or stroke (1) keeps from the start, where it is told."""
    return duty.bounds[i] if duty.from_rest or not duty.c else None


def part(duty: Duty, mode: int) -> float | None:
    """The amplitude of the complementary part at the machine, where nothing damps it."""
    return float(duty.driven.complementary_modes.amplitude[mode, 0]) if duty.solved and not duty.c else None


def dies(duty: Duty) -> str | None:
    """The time after which a hundredth of the complementary part is left at most."""
    if not (duty.c and duty.from_rest):
        return None
    slowest = min((-exponent.real for exponent, _ in duty.damped.transient), default=0.0)
    return f"{three(math.log(100) / slowest)} s" if slowest > 0 else "no time"


def over_height(duty: Duty) -> str:
    """The height of the peak at Den Hartog's optimum above the fixed points, in percent."""
    mu = min(duty.m2 / duty.m1, 1e6)
    if mu < 1e-3:
        return "less than 0.01 %"
    best = den_hartog(1.0, 1.0, mu)
    peak = highest_peak(mu, 1 / (1 + mu), best.c / (2 * mu))
    return f"{100 * (peak / best.height - 1):.2g} %"


class Numbers(Declared[Duty]):
    x_unit, F_unit = AxisUnit("X1", write=length), AxisUnit("F")
    m1 = number(lambda d: d.m1)
    k1 = number(lambda d: d.k1 / 1e3)
    F_0 = number(lambda d: d.F_0)
    omega = number(lambda d: d.omega)
    mu = number(lambda d: d.m2 / d.m1)
    swing = number(lambda d: d.swings[0], "X_1", "m", "m1", axis=x_unit)
    stroke = number(lambda d: d.swings[1], "X_2 − X_1", "m", "m2", axis=x_unit)
    alone = number(lambda d: d.swings[2], axis=x_unit)
    slow = number(lambda d: float(d.driven.free.omega[0]), "ω_{−}", "rad/s", "slow")
    fast = number(lambda d: float(d.driven.free.omega[1]), "ω_{+}", "rad/s", "fast")
    Xp1 = number(lambda d: float(d.X[0].real), axis=x_unit)
    Xp2 = number(lambda d: float(d.X[1].real), axis=x_unit)
    push = number(lambda d: d.F_0, axis=F_unit, whole=True)
    pull = number(lambda d: pull(d) if d.solved else None, axis=F_unit)
    link = number(lambda d: "pull" if d.c else "spring 2")
    height = number(lambda d: den_hartog(d.m1, d.k1, d.m2).height * d.deflections(1.0), axis=x_unit)
    over_height = number(lambda d: over_height(d) if d.c else None)
    help_low = number(lambda d: d.band[0] if d.band else 0.0)
    help_high = number(lambda d: d.band[1] if d.band else 0.0)
    part1 = number(lambda d: part(d, 0), axis=x_unit)
    part2 = number(lambda d: part(d, 1), axis=x_unit)
    rest1 = number(lambda d: bound(d, 0), axis=x_unit)
    rest2 = number(lambda d: bound(d, 1), axis=x_unit)
    rest_alone = number(lambda d: d.bound_alone if d.from_rest else None, axis=x_unit)
    dies = number(dies)
    judged = number(lambda d: "particular solution" if d.plays else d.whence)
    judged_alone = number(lambda d: "particular solution" if d.plays_alone else d.whence)
