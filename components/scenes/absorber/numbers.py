"""The live numbers of the machine and its absorber, and the goals in words."""

from __future__ import annotations

import math

import numpy as np

from components.quantities.axes import Axis
from components.quantities.declared import AxesInForce, AxisUnit, Declared, LiveNumber, Text, by_name
from components.quantities.formatting import short, three
from components.scenes.absorber.case import AWAY, AbsorberCase
from components.scenes.absorber.curves import Axes as A
from physics.absorber import den_hartog, highest_peak
from physics.precision.exact import exact, precise

number = LiveNumber[AbsorberCase]


def length(axis: Axis, value: float) -> str:
    """Format with three digits. Values below 5 µm, or as small as a rounding error, are written as zero."""
    if not np.isfinite(value):
        return three(value)
    least = 0.005 if axis.unit == "mm" else 1e-9 * axis.place(axis.end)
    with precise():
        place = exact(value).scaleb(-axis.exponent)
    return three(place) if abs(place) >= least else "0.00"


def bound(case: AbsorberCase, i: int) -> float | None:
    """Return the bound of swing (0) or stroke (1) from the initial conditions, if it is shown."""
    return case.bounds[i] if case.from_rest or not case.c else None


def part(case: AbsorberCase, mode: int) -> float | None:
    """The amplitude of the complementary part at the machine, if nothing damps it."""
    return float(case.driven.complementary_modes.amplitude[mode, 0]) if case.solved and not case.c else None


def dies(case: AbsorberCase) -> float | None:
    """The time in s after which at most a hundredth of the complementary part is left; inf if a part of it stays."""
    if not (case.c and case.from_rest):
        return None
    slowest = min((-exponent.real for exponent, _ in case.damped.transient), default=math.inf)
    return math.log(100) / slowest if slowest > 0 else math.inf


def time_of(seconds: float) -> str:
    return f"{three(seconds)} s" if 0 < seconds < math.inf else "no time"


def over_height(case: AbsorberCase) -> str:
    """The height of the peak at Den Hartog's optimum above the fixed points, in percent."""
    mu = min(case.m2 / case.m1, 1e6)
    if mu < 1e-3:
        return "less than 0.01 %"
    best = den_hartog(1.0, 1.0, mu)
    peak = highest_peak(mu, 1 / (1 + mu), best.c / (2 * mu))
    return f"{100 * (peak / best.height - 1):.2g} %"


class Numbers(Declared[AbsorberCase]):
    x_unit, F_unit = AxisUnit(A.X1, write=length), AxisUnit(A.F)
    m1 = number(lambda d: d.m1)
    k1 = number(lambda d: d.k1 / 1e3)
    F_0 = number(lambda d: d.F_0)
    omega = number(lambda d: d.omega)
    mu = number(lambda d: d.m2 / d.m1, meaning="mass ratio m2/m1")
    swing = number(lambda d: d.swings[0], "X_1", "m", "m1", axis=x_unit, meaning="amplitude of the machine")
    stroke = number(
        lambda d: d.swings[1],
        "X_2 − X_1",
        "m",
        "m2",
        axis=x_unit,
        meaning="amplitude of mass 2 relative to the machine",
    )
    alone = number(
        lambda d: d.swings[2], unit="m", axis=x_unit, meaning="amplitude of the machine without the absorber"
    )
    slow = number(lambda d: d.natural[0], "ω_{−}", "rad/s", "slow", meaning="slow natural frequency")
    fast = number(lambda d: d.natural[1], "ω_{+}", "rad/s", "fast", meaning="fast natural frequency")
    Xp1 = number(lambda d: float(d.X[0].real), axis=x_unit)
    Xp2 = number(lambda d: float(d.X[1].real), axis=x_unit)
    push = number(lambda d: d.F_0, axis=F_unit, whole=True)
    pull = number(
        lambda d: d.pull if d.solved else None, unit="N", axis=F_unit,
        meaning="amplitude of the force between mass 2 and the machine",
    )  # fmt: skip
    link = number(lambda d: "pull" if d.c else "spring 2")
    height = number(
        lambda d: den_hartog(d.m1, d.k1, d.m2).height * d.deflections(1.0), unit="m", axis=x_unit,
        meaning="amplitude of the machine at both fixed points with Den Hartog's spring",
    )  # fmt: skip
    over_height = number(lambda d: over_height(d) if d.c else None)
    help_low = number(
        lambda d: d.band[0] if d.band else None,
        unit="rad/s",
        meaning="lower end of the band in which the absorber helps",
    )
    help_high = number(
        lambda d: d.band[1] if d.band else None,
        unit="rad/s",
        meaning="upper end of the band in which the absorber helps",
    )
    part1 = number(lambda d: part(d, 0), axis=x_unit)
    part2 = number(lambda d: part(d, 1), axis=x_unit)
    rest1 = number(lambda d: bound(d, 0), axis=x_unit)
    rest_alone = number(lambda d: d.bound_alone if d.from_rest else None, axis=x_unit)
    dies = number(dies, unit="s", form=time_of, meaning="time until 1 % of the transient is left")
    judged = number(lambda d: "particular solution" if d.plays else d.whence)
    judged_alone = number(lambda d: "particular solution" if d.plays_alone else d.whence)
    tick, lightest = Text[AbsorberCase].some(2)
    goal, found = Text[AbsorberCase].each(range(3)), Text[AbsorberCase].each(range(3))


def goal_texts(case: AbsorberCase, axes: AxesInForce, lightest: float | None) -> dict[str, str]:
    """The goals, the values that are compared with them (of the particular solution, and from initial conditions), and
    the best result."""
    j, share = case.nearest
    near = f"{('ω₋', 'ω₊')[j]} {(Numbers.slow, Numbers.fast)[j].text(case, axes)} rad/s"
    texts = {
        Numbers.lightest: f"{_score(lightest)} kg" if lightest else "none yet",
        Numbers.goal[0]: f"Resonances {short(100 * AWAY)} % away",
        Numbers.found[0]: f"nearest is {_percent(share)} % away: {near}",
    }
    for i, (on, what) in enumerate(((A.X1, "Machine's"), (A.X2, "Stroke in"))):
        axis, way, within = on(axes), case.swings[i], bound(case, i)
        told = "" if within is None else f"; {case.whence} within {length(axis, within)} {axis.full_unit}"
        found = f"xₚ: {length(axis, way)} {axis.full_unit}{told}"
        texts[Numbers.goal[i + 1]] = f"{what} xₚ within {short(axis.place(case.limits[i]))} {axis.full_unit}"
        texts[Numbers.found[i + 1]] = found if math.isfinite(way) else "no Xₚ here: it grows without limit"
    return by_name(texts)


def _score(mass: float) -> str:
    """Format with one digit more than usual, because visitors compete for the lightest absorber."""
    return f"{mass:.4g}" if 0.1 <= mass < 1e4 else three(mass)


def _percent(share: float) -> str:
    """Format a share in percent. It is never rounded up to a limit that it does not reach."""
    if share >= 10:
        return short(100 * share)
    short_of_it = share < AWAY <= round(share, 3)
    return f"{math.floor(1000 * share) / 10 if short_of_it else 100 * share:.1f}"
