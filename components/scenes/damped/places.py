"""The places of the damped scene: of the stairs from peak to peak, of the fastest moment, and of the roots."""

from __future__ import annotations

import math
from itertools import pairwise

from components.layout.stage import wire
from components.quantities.axes import Axis
from components.quantities.motion import scaled
from components.scenes.damped.case import MOST_PEAKS, DampedCase

LEAST_DROP = 0.04
"""A stair is drawn where its drop is this share of the frame."""
TICKS, NAMED = (0.2, 0.4, 0.6, 0.8), (0.4, 0.8)


def scalars_of(case: DampedCase, axes: dict[str, Axis], forces: bool) -> dict[str, float]:
    one = case.oscillator
    scalars = {
        "side": min(max(one.m**0.15, 0.75), 1.25),
        "wire": wire(one.k),
        "has_spring": float(one.k > 0),
        "has_dashpot": float(one.c > 0),
    }
    scalars["per_reach"] = 1.25 / axes["x"].place(axes["x"].end)
    scalars |= _stairs(case, axes) | _top(case, axes) | _roots(case, axes)
    return scalars | _forces(case, axes) if forces else scalars


def _stairs(case: DampedCase, axes: dict[str, Axis]) -> dict[str, float]:
    """Each peak in the window, and where the drop to the next one is seen."""
    if case.kind != "under":
        return {}
    t, x = axes["t"], axes["x"]
    peaks = [peak for peak in case.peaks if peak.t <= case.end and x.start <= peak.x <= x.end]
    scalars = {f"peak_{i}_{name}": axis.place(value) for i, peak in enumerate(peaks) for name, axis, value in (
        ("t", t, peak.t), ("x", x, peak.x),
    )}  # fmt: skip
    scalars |= {f"peak_{i}": 1.0 for i in range(len(peaks))}
    for i, (one, two) in enumerate(pairwise(peaks)):
        if abs(one.x - two.x) >= LEAST_DROP * (x.end - x.start):
            scalars[f"stair_{i}"] = 1.0
    if "stair_0" in scalars:
        scalars["over"] = math.copysign(1.0, peaks[0].x)
    return scalars


def _top(case: DampedCase, axes: dict[str, Axis]) -> dict[str, float]:
    """Where the dashpot takes most, unless that is at once."""
    top = case.top
    if not case.P_max or not 0 < top.t < case.end:
        return {}
    places = {"top_t": axes["t"].place(top.t), "top_x": axes["x"].place(top.x), "top_P": axes["P"].place(case.P_max)}
    return {**places, "top": 1.0}


def _roots(case: DampedCase, axes: dict[str, Axis]) -> dict[str, float]:
    """Both roots in the plane, the circle of the natural frequency, and which of the roots can be held."""
    one, re, im = case.oscillator, axes["re"], axes["im"]
    slow, fast = one.rates
    scalars = {"fast_at": -re.place(fast), "unit": re.place(one.omega_n), "root": one.zeta if one.k else 1.0}
    scalars["slow_root"] = 1.0
    if not one.k:
        return scalars | {"bare": 1.0}
    scalars["circle"] = 1.0
    swing = im.place(one.omega_d)
    if one.zeta < 1:
        found = {"root_y": swing, "pair": 1.0, "held_root": 1.0}
        return scalars | found | {"legs": float(0.04 < one.zeta < 0.98)}
    inside = -fast >= re.start
    found = {"slow_root": scaled(0, slow, 1 / one.omega_n), "real": 1.0}
    if inside:
        found |= {"root": fast / one.omega_n, "root_y": 0.0, "held_root": 1.0}
    return scalars | found | {"apart": float(one.zeta > 1.02), "out": float(not inside)}


def _forces(case: DampedCase, axes: dict[str, Axis]) -> dict[str, float]:
    """The forces of spring and dashpot for one of x and of v, over the greater of their largest values."""
    one, x, v = case.oscillator, axes["x"], axes["v"]
    most = max(scaled(0, one.k, case.reach), scaled(0, one.c, abs(case.top.v)))
    if not most:
        return {}
    return {
        "forced": 1.0,
        "per_x": scaled(-x.exponent, one.k, 1 / most),
        "per_v": scaled(-v.exponent, one.c, 1 / most),
        "pulls": float(one.k > 0),
        "brakes": float(one.c > 0),
    }


STAIRS = range(MOST_PEAKS - 1)
