"""Geometry of a sketch: a drawn curve in the frame of its plot."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from components.scene.traces import Floats

SLACK = 0.03  # share of the frame's width that may be missing at both edges of a drawing
FEWEST = 2  # points of a curve
BESIDE = 3  # points on each side that are used to interpolate between two points


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


@dataclass(frozen=True)
class Sketch:
    """A curve y(x) in a frame; `other` is a second one."""

    x: Floats
    y: Floats
    frame: Ranges
    other: Sketch | None = None

    def at(self, x: float) -> float | None:
        """Return the height at a position, or None if it was not drawn. At the edges of the frame, drawn curves may end
        early."""
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
        """Return True if most of that part was drawn."""
        x, _ = self.between(start, end)
        return len(x) >= FEWEST and float(x[-1] - x[0]) >= 0.6 * (end - start)


def sketch(points: ArrayLike, frame: Ranges, other: Sketch | None = None) -> Sketch:
    """Return the curve through drawn points (n, 2), ordered by x, with one height for each x."""
    drawn = np.asarray(points, dtype=float).reshape(-1, 2)
    drawn = drawn[np.isfinite(drawn).all(axis=1)]
    x, first = np.unique(drawn[:, 0], return_index=True)
    return Sketch(x, drawn[first, 1], frame, other)


def upward(x: Floats, y: Floats) -> Floats:
    """Return the positions at which a curve crosses zero upwards."""
    i = np.flatnonzero((y[:-1] < 0) & (y[1:] >= 0))
    return np.asarray(x[i] - y[i] * (x[i + 1] - x[i]) / (y[i + 1] - y[i]))


def crossings(x: Floats, y: Floats) -> Floats:
    """Return the positions at which a curve crosses zero, upwards or downwards."""
    return np.concatenate((upward(x, y), upward(x, -y)))


def turns(x: Floats, y: Floats) -> list[tuple[float, float]]:
    """Return the exact turning points of a curve, between its drawn points: within 1e-7 of its height for a motion with
    32 points per cycle, 1e-4 at its ends."""
    found = []
    slopes = np.sign(np.gradient(y, x, edge_order=2))
    for i in np.flatnonzero((slopes[:-1] != 0) & (slopes[:-1] * slopes[1:] <= 0)):
        near = slice(max(i - BESIDE, 0), i + BESIDE + 2)
        curve = np.polynomial.Polynomial.fit(x[near], y[near], len(x[near]) - 1)
        level = curve.deriv().roots()
        at = float(level[np.argmin(np.abs(level - (x[i] + x[i + 1]) / 2))].real)
        if x[0] <= at <= x[-1]:
            found.append((at, float(curve(at))))
    return found
