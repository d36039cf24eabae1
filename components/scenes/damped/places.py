"""The places of the damped scene: of the stairs from peak to peak, of the fastest moment, and of the roots."""

from __future__ import annotations

import math
from itertools import pairwise

from components import dashpot
from components.layout.stage import wire
from components.quantities.axes import Axis
from components.quantities.declared import AxesInForce, Declared, Scalar, by_name
from components.quantities.motion import scaled
from components.scenes.damped.case import MOST_PEAKS, DampedCase
from components.scenes.damped.curves import Axes as A

LEAST_DROP = 0.04
"""A stair is drawn where its drop is this share of the frame."""
TICKS, NAMED = (0.2, 0.4, 0.6, 0.8), (0.4, 0.8)
PEAKS, STAIRS = range(MOST_PEAKS), range(MOST_PEAKS - 1)

scalar = Scalar[DampedCase]


def _top(case: DampedCase) -> bool:
    """Whether the dashpot takes most, and not at once."""
    return bool(case.P_max) and 0 < case.top.t < case.end


def _held(case: DampedCase, axes: AxesInForce) -> bool:
    """Whether the faster root, or the upper one of a pair, is seen."""
    return case.roots == "pair" or (case.roots == "real" and -case.oscillator.rates[1] >= A.re(axes).start)


class Places(dashpot.Has):
    side = scalar(lambda c, a: min(max(c.oscillator.m**0.15, 0.75), 1.25))
    wire = scalar(lambda c, a: wire(c.oscillator.k))
    per_reach = scalar(lambda c, a: 1.25 / A.x(a).place(A.x(a).end))
    # The stairs: each peak in the window, and where the drop to the next one is seen.
    peak, peak_t, peak_x, stair = scalar.each(PEAKS), scalar.each(PEAKS), scalar.each(PEAKS), scalar.each(STAIRS)
    over = scalar(lambda c, a: math.copysign(1.0, c.peaks[0].x) if c.peaks else None)
    # Where the dashpot takes most.
    top = scalar(lambda c, a: _top(c))
    top_t = scalar(lambda c, a: A.t(a).place(c.top.t) if _top(c) else None)
    top_x = scalar(lambda c, a: A.x(a).place(c.top.x) if _top(c) else None)
    top_P = scalar(lambda c, a: A.P(a).place(c.P_max) if _top(c) else None)
    # The roots in their plane, of which a hand takes the one in `root` or in `slow_root`, in natural frequencies.
    unit = scalar(lambda c, a: A.re(a).place(c.oscillator.omega_n))
    circle = scalar(lambda c, a: c.roots != "bare")
    pair = scalar(lambda c, a: c.roots == "pair")
    real = scalar(lambda c, a: c.roots == "real")
    bare = scalar(lambda c, a: c.roots == "bare")
    legs = scalar(lambda c, a: c.roots == "pair" and 0.04 < c.oscillator.zeta < 0.98)
    apart = scalar(lambda c, a: c.roots == "real" and c.oscillator.zeta > 1.02)
    out = scalar(lambda c, a: c.roots == "real" and not _held(c, a))
    held_root = scalar(_held)
    fast_at = scalar(lambda c, a: -A.re(a).place(c.oscillator.rates[1]))
    root = scalar(
        lambda c, a: (
            c.oscillator.rates[1] / c.oscillator.omega_n if c.roots == "real" and _held(c, a)
            else c.oscillator.zeta if c.oscillator.k else 1.0
        )
    )  # fmt: skip
    root_y = scalar(lambda c, a: A.im(a).place(c.oscillator.omega_d) if _held(c, a) else None)
    slow_root = scalar(
        lambda c, a: scaled(0, c.oscillator.rates[0], 1 / c.oscillator.omega_n) if c.roots == "real" else 1.0
    )


def stairs_of(case: DampedCase, axes: AxesInForce) -> dict[str, float]:
    """The peaks in the window, and from which of them the drop to the next one is seen."""
    P, t, x = Places, A.t(axes), A.x(axes)
    peaks = case.peaks if case.kind == "under" else ()
    seen = [peak for peak in peaks if peak.t <= case.end and x.start <= peak.x <= x.end]
    found = dict.fromkeys((*P.peak.values(), *P.stair.values()), 0.0)
    for i, one in enumerate(seen):
        found |= {P.peak[i]: 1.0, P.peak_t[i]: t.place(one.t), P.peak_x[i]: x.place(one.x)}
    for i, (one, two) in enumerate(pairwise(seen)):
        found[P.stair[i]] = float(abs(one.x - two.x) >= LEAST_DROP * (x.end - x.start))
    return by_name(found)


def _per(case: DampedCase, of: Axis, factor: float) -> float | None:
    """The force of one of an axis, over the greatest force of spring or dashpot."""
    return scaled(-of.exponent, factor, 1 / case.greatest) if case.greatest else None


class Arrows(Declared[DampedCase]):
    """The forces of spring and dashpot for one of x and of v."""

    per_x = scalar(lambda c, a: _per(c, A.x(a), c.oscillator.k))
    per_v = scalar(lambda c, a: _per(c, A.v(a), c.oscillator.c))
    pulls = scalar(lambda c, a: c.oscillator.k > 0 and c.greatest > 0)
    brakes = scalar(lambda c, a: c.oscillator.c > 0 and c.greatest > 0)
