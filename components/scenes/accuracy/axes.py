"""The axes of run times and errors, and of the other views."""

from __future__ import annotations

from functools import cache

from components.quantities.axes import Axis, log_axis, nice_axis
from components.quantities.declared import Declared, DrawnAxis, by_name
from physics.integrators.accuracy import MARKS, Run
from physics.integrators.drift import PERIODS
from physics.integrators.price import LEAST

REACH, LOW, TOP = 3.2, 0.4, 3.0
"""The reach of the plot of the amplification in h omega, and its ends downward and upward."""
SWEPT = {"ratio": (1.0, 1e16), "detuning": (1e-15, 0.1), "periods": (1.0, 1e12)}
"""The range of each sweep in which doubles are compared with 80 digits: of mass ratio, detuning and time in periods."""
SEEN = 1.6
"""The end of the axis of a drifting motion, over the largest exact displacement: beyond it a method has gone wrong."""
ERROR = log_axis(LEAST, 10.0, "", 3)
"""The axis of errors, whatever of."""


class Axes(Declared[object]):
    """A column of what an axis counts has the name of the axis."""

    drift_t, drift_x, time, error, percent, error_growth, energy_growth, period = DrawnAxis.some(8)
    span, span_time, span_error = DrawnAxis.some(3)
    h_omega, growth, ratio, steps = DrawnAxis.some(4)
    place = DrawnAxis.each(SWEPT)


def axes_of(longest: float, picked: Run | None, unit: str, size: float) -> dict[str, Axis]:
    """The axes, with the longest run in s, the run that is picked, the unit that periods are counted in, and the
    largest displacement of the exact motion in m."""
    levels = picked.error_growth if picked else ()
    worst = 100 * max(levels) if levels else 1.0
    return _standing(unit) | by_name({
        Axes.drift_x: nice_axis(-SEEN * size, SEEN * size, "m", 3),
        Axes.time: log_axis(3e-5, max(2 * longest, 3.0), "s", 3),
        Axes.percent: nice_axis(0.0, max(worst, 1e-14), "%", 2),
    })  # fmt: skip


@cache
def _standing(unit: str) -> dict[str, Axis]:
    """The axes that nothing but the unit of the periods changes."""
    return by_name({
        **dict.fromkeys((Axes.error, Axes.error_growth, Axes.energy_growth), ERROR),
        Axes.drift_t: nice_axis(0.0, float(PERIODS), unit, 2, exact=True),
        Axes.period: nice_axis(0.0, float(MARKS[-1]), unit, 5, exact=True),
        Axes.span: log_axis(5.0, 500.0, "slow periods"),
        Axes.span_time: log_axis(3e-5, 30.0, "s"),
        Axes.span_error: log_axis(1e-17, 10.0, ""),
        **{Axes.place[sweep]: log_axis(*span) for sweep, span in SWEPT.items()},
        Axes.h_omega: nice_axis(0.0, REACH, "", 6, exact=True),
        Axes.growth: nice_axis(LOW, TOP, "", 4, exact=True),
        Axes.ratio: log_axis(1.0, 1e12, ""),
        Axes.steps: log_axis(1.0, 1e8, ""),
    })  # fmt: skip
