"""Geometry of a sketch: what a drawn curve has of the features that the true one has.

A hand is judged by places and heights within tolerances, never by style. A part that was not drawn has no feature.
Adapted to the hand: slopes over 4 % of the frame's width, turning points that stand out by 2 % of its height.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import singledispatch
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from components.traces import Floats
from components.walks.types import (
    Extreme,
    Farthest,
    Feature,
    Least,
    Peak,
    Period,
    Pole,
    Slope,
    Sum,
    Trough,
    ValueAt,
    Zero,
)

STRIDE = 0.04  # of the frame's width, over which a slope is seen
STEEP = 0.06  # of its height, which a slope rises over that
STANDS_OUT = 0.02  # of its height, by which a turning point differs from its surroundings
SURROUNDINGS = 2.5  # tolerances around a turning point
NEAR_TOP = 0.95  # of the frame's height: what goes higher leaves it
SLACK = 0.03  # of the frame's width, by which a drawing may fall short of its edges
FEWEST = 2  # points of a curve


@dataclass(frozen=True)
class Ranges:
    """The ranges of the axes of a plot."""

    x: tuple[float, float]
    y: tuple[float, float]

    @property
    def width(self) -> float:
        return self.x[1] - self.x[0]

    @property
    def height(self) -> float:
        return self.y[1] - self.y[0]


class Seen(NamedTuple):
    """Whether a curve has a feature, the number that it has in its place, and where in the plot that is.

    The number is None where nothing was drawn, or where what was drawn has none.
    """

    has: bool
    number: float | None = None
    x: float | None = None
    y: float | None = None


NOTHING = Seen(False)


@dataclass(frozen=True)
class Sketch:
    """A curve y(x) in a frame; `other` is a second one."""

    x: Floats
    y: Floats
    frame: Ranges
    other: Sketch | None = None

    def at(self, x: float) -> float | None:
        """Its height there; None where it was not drawn. At the edges of the frame a hand falls short."""
        slack = SLACK * self.frame.width
        if not len(self.x) or not self.x[0] - slack <= x <= self.x[-1] + slack:
            return None
        i = int(np.searchsorted(self.x, x))
        if 0 < i < len(self.x) and self.x[i] - self.x[i - 1] > 2 * slack:
            return None
        return float(np.interp(x, self.x, self.y))

    def between(self, start: float, end: float) -> tuple[Floats, Floats]:
        inside = (self.x >= start) & (self.x <= end)
        return self.x[inside], self.y[inside]

    def covers(self, start: float, end: float) -> bool:
        """Whether most of that part was drawn."""
        x, _ = self.between(start, end)
        return len(x) >= FEWEST and float(x[-1] - x[0]) >= 0.6 * (end - start)


def sketch(points: ArrayLike, frame: Ranges, other: Sketch | None = None) -> Sketch:
    """The curve through drawn points (n, 2): ordered by abscissa, one height for each."""
    drawn = np.asarray(points, dtype=float).reshape(-1, 2)
    drawn = drawn[np.isfinite(drawn).all(axis=1)]
    x, first = np.unique(drawn[:, 0], return_index=True)
    return Sketch(x, drawn[first, 1], frame, other)


@singledispatch
def seen(feature: Feature, drawn: Sketch) -> Seen:
    """What of a feature a curve has."""
    raise TypeError(type(feature))


@seen.register
def _(feature: ValueAt, drawn: Sketch) -> Seen:
    y = drawn.at(feature.at)
    return NOTHING if y is None else Seen(abs(y - feature.value) <= feature.tol, y, feature.at, y)


@seen.register
def _(feature: Slope, drawn: Sketch) -> Seen:
    here, there = drawn.at(feature.at), drawn.at(feature.at + STRIDE * drawn.frame.width)
    if here is None or there is None:
        return NOTHING
    rise = (there - here) / drawn.frame.height
    return Seen(rise > STEEP if feature.way == "up" else rise < -STEEP, None, feature.at, here)


@seen.register
def _(feature: Zero, drawn: Sketch) -> Seen:
    """The crossing nearest to the place; a curve that only touches zero has none."""
    crossings = _crossings(drawn.x, drawn.y)
    if not len(crossings):
        return NOTHING
    nearest = float(crossings[np.argmin(np.abs(crossings - feature.at))])
    return Seen(abs(nearest - feature.at) <= feature.tol, nearest, nearest, 0.0)


@seen.register(Peak)
@seen.register(Trough)
def _(feature: Extreme, drawn: Sketch) -> Seen:
    """The highest (lowest) point of the surroundings lies near enough, is as high as said, and is no edge."""
    sign = 1.0 if isinstance(feature, Peak) else -1.0
    around = SURROUNDINGS * feature.tol
    x, y = drawn.between(feature.at - around, feature.at + around)
    if len(x) < FEWEST:
        return NOTHING
    i = int(np.argmax(sign * y))
    stands_out = sign * y[i] - max(sign * y[0], sign * y[-1]) > STANDS_OUT * drawn.frame.height
    near = abs(x[i] - feature.at) <= feature.tol and abs(y[i] - feature.value) <= feature.tol_y
    return Seen(bool(near and stands_out), float(y[i]), float(x[i]), float(y[i]))


@seen.register
def _(feature: Pole, drawn: Sketch) -> Seen:
    """Out through the top near the place, and within the frame on both sides of it."""
    top = drawn.frame.y[0] + NEAR_TOP * drawn.frame.height
    out = drawn.x[drawn.y >= top]
    if not len(out):
        return NOTHING
    nearest = float(out[np.argmin(np.abs(out - feature.at))])
    wide = 4 * feature.tol
    _, around = drawn.between(feature.at - wide, feature.at + wide)
    returns = bool(len(around)) and float(around.min()) < top
    return Seen(returns and abs(nearest - feature.at) <= feature.tol, nearest, nearest, top)


@seen.register
def _(feature: Period, drawn: Sketch) -> Seen:
    """By the ways between crossings of the middle in one direction."""
    x, y = drawn.between(*_ends(feature.start, feature.end))
    if len(x) < FEWEST or np.ptp(y) <= STANDS_OUT * drawn.frame.height:
        return NOTHING
    middle = y - (y.max() + y.min()) / 2
    gaps = [*np.diff(_upward(x, middle)), *np.diff(_upward(x, -middle))]
    if not gaps:
        return NOTHING
    mean = float(np.mean(gaps))
    return Seen(abs(mean - feature.value) <= feature.tol, mean)


@seen.register
def _(feature: Farthest, drawn: Sketch) -> Seen:
    start, end = _ends(feature.start, feature.end)
    low, high = max(start, drawn.frame.x[0]), min(end, drawn.frame.x[1])
    if not drawn.covers(low, high):
        return NOTHING
    x, y = drawn.between(low, high)
    i = int(np.argmax(np.abs(y)))
    return Seen(bool(abs(abs(y[i]) - feature.value) <= feature.tol), float(abs(y[i])), float(x[i]), float(y[i]))


@seen.register
def _(feature: Least, drawn: Sketch) -> Seen:
    if not drawn.covers(*drawn.frame.x):
        return NOTHING
    i = int(np.argmin(drawn.y))
    x, y = float(drawn.x[i]), float(drawn.y[i])
    return Seen(abs(y - feature.value) <= feature.tol, y, x, y)


@seen.register
def _(feature: Sum, drawn: Sketch) -> Seen:
    """The place where the sum is farthest from what it should be."""
    if drawn.other is None or not (drawn.covers(*drawn.frame.x) and drawn.other.covers(*drawn.frame.x)):
        return NOTHING
    inside = (drawn.x >= drawn.other.x[0]) & (drawn.x <= drawn.other.x[-1])
    x = drawn.x[inside]
    total = drawn.y[inside] + np.interp(x, drawn.other.x, drawn.other.y)
    i = int(np.argmax(np.abs(total - feature.value)))
    return Seen(bool(abs(total[i] - feature.value) <= feature.tol), float(total[i]), float(x[i]), float(total[i]))


def _ends(start: float | None, end: float | None) -> tuple[float, float]:
    return -math.inf if start is None else start, math.inf if end is None else end


def _upward(x: Floats, y: Floats) -> Floats:
    """Where a curve crosses zero upwards."""
    i = np.flatnonzero((y[:-1] < 0) & (y[1:] >= 0))
    return np.asarray(x[i] - y[i] * (x[i + 1] - x[i]) / (y[i + 1] - y[i]))


def _crossings(x: Floats, y: Floats) -> Floats:
    return np.concatenate((_upward(x, y), _upward(x, -y)))
