"""The power of the drive and of the dashpot, each the mean over the last swing of the push."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from components.quantities.declared import Column, Declared
from components.scene.traces import Floats
from components.scenes.driven.case import DrivenCase
from physics.valid import in_range

FEWEST, MOST, PER_SWING = 60, 240, 16
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(4)


class Power(Declared[DrivenCase]):
    """The power put in and the power lost over t."""

    t, P_in, P_lost = Column[DrivenCase].some(3, "power")


@lru_cache(maxsize=1)
def powers_of(case: DrivenCase) -> dict[Column[DrivenCase], Floats]:
    """The columns of Power; none where nothing pushes, or too fast for a line."""
    if not case.pushed:
        return {}
    swing = 2 * math.pi / case.omega
    turns = case.end * max(case.fastest, case.omega) / (2 * math.pi)
    if PER_SWING * turns > 4 * MOST:
        return {}
    count = int(min(max(PER_SWING * turns, FEWEST), MOST))
    t = np.linspace(0.0, case.end, count + 1)
    step = case.end / count
    earlier = np.maximum(np.arange(count + 1) - count * (swing / case.end), 0.0)
    inner = (t[:-1, None] + step * (1 + _NODES) / 2).ravel()
    with np.errstate(over="ignore", invalid="ignore"):
        rates, ends = powers(case, inner), powers(case, t)
        columns = {Power.t: t}
        for one, inside, at in zip((Power.P_in, Power.P_lost), rates, ends, strict=True):
            pieces = inside.reshape(count, -1) @ _WEIGHTS * step / 2
            done = np.concatenate([[0.0], np.cumsum(pieces)])
            before = _between(step, in_range("the work", done), in_range("the power", at), earlier)
            columns[one] = (done - before) / swing
    return columns


def _between(step: float, heights: Floats, slopes: Floats, places: Floats) -> Floats:
    """Return the cubics through heights with slopes, `step` apart in time, at places counted in steps from the first.

    Places are not divided by `step`, which is 0 in the shortest windows.
    """
    i = np.minimum(places.astype(int), len(heights) - 2)
    s, rise = places - i, heights[i + 1] - heights[i]
    first, last = slopes[i] * step, slopes[i + 1] * step
    found: Floats = heights[i] + s * (first + s * (3 * rise - 2 * first - last + s * (first + last - 2 * rise)))
    return found


def powers(case: DrivenCase, t: Floats) -> tuple[Floats, Floats]:
    """The power that the drive puts in and the power that the dashpot takes, in W, at the times t."""
    one, (x, v) = case.oscillator, case.drawn(t)
    if case.kind == "base":
        y = case.size * np.sin(case.omega * t)
        rate = case.size * case.omega * np.cos(case.omega * t)
        return -(one.k * (x - y) + one.c * (v - rate)) * rate, one.c * (v - rate) ** 2
    force = case.size if case.kind == "force" else case.size * case.omega * case.omega
    return force * np.sin(case.omega * t) * v, one.c * v * v
