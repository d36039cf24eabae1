"""What a plot shows of a motion: its curve, or the exact envelope where it is too fast to be drawn."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from components.page.plots import Curve, Region
from components.plots import curve, region
from physics.sampling import Sinusoid, curve_or_band, drawable

Floats = NDArray[np.float64]
Columns = dict[str, Floats]
BAND = "band"
"""The source of the bands that stand for curves too fast to be drawn."""
FEWEST, MOST, PER_CYCLE = 300, 680, 32


def samples(end: float, fastest: float) -> int:
    """How many times a plot of [0, end] needs: 32 a cycle of the fastest motion (rad/s), within what a screen shows."""
    return int(min(max(PER_CYCLE * end * float(fastest) / (2 * np.pi), FEWEST), MOST)) + 1


def trace(
    name: str, components: Sequence[Sinusoid], t: Floats, base: Floats | None = None, curve: Floats | None = None
) -> tuple[Columns, Columns]:
    """Columns of the curve `name`, and of its band `name_lo`, `name_hi`: one of the two is empty.

    `curve` is the motion itself, where its owner has it to more digits than the sum of the components.
    """
    if curve is not None and drawable(max((component.omega for component in components), default=0.0), t):
        return {name: curve}, {}
    sum_, low, high = curve_or_band(components, t, base)
    if sum_ is not None:
        return {name: sum_}, {}
    return {}, dict(zip(band_columns(name), (low, high), strict=True))


def sources_over_time(t: Floats, curves: Columns, bands: Columns) -> dict[str, Columns]:
    """The sources of what runs over time: the curves, and the bands where there are any."""
    return {"time": {"t": t, **curves}, BAND: bands and {"t": t, **bands}}


def band_columns(name: str) -> tuple[str, str]:
    """The columns of the band that stands for the curve `name`."""
    return f"{name}_lo", f"{name}_hi"


def traced(name: str, **look: Any) -> tuple[Curve, Region]:
    """The line of a trace and its band, for a plot."""
    line = curve(name, **look)
    low, high = band_columns(name)
    return line, region(low, high, source=BAND, tint=line.tint, alpha=0.4, group=line.group, of=name)
