"""What a plot shows of a motion: its curve, or the exact envelope where it is too fast to be drawn."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from components.plots import Band, Curve
from physics.sampling import Sinusoid, drawable, sampled

Floats = NDArray[np.float64]
FEWEST, MOST, PER_CYCLE = 300, 680, 32


def samples(end: float, fastest: float) -> int:
    """How many times a plot of [0, end] needs: 32 a cycle of the fastest motion (rad/s), within what a screen shows."""
    return int(min(max(PER_CYCLE * end * fastest / (2 * np.pi), FEWEST), MOST)) + 1


def trace(
    name: str, components: Sequence[Sinusoid], t: Floats, base: Floats | None = None, curve: Floats | None = None
) -> tuple[dict[str, Floats], dict[str, Floats]]:
    """Columns of the curve `name`, and of its band `name_lo`, `name_hi`: one of the two is empty.

    `curve` is the motion itself, where its owner has it to more digits than the sum of the components.
    """
    if curve is not None and all(drawable(component.omega, t) for component in components):
        return {name: curve}, {}
    sum_, low, high = sampled(components, t, base)
    if sum_ is not None:
        return {name: sum_}, {}
    return {}, {f"{name}_lo": low, f"{name}_hi": high}


def traced(name: str, **look: str) -> tuple[Curve, Band]:
    """The line of a trace and its band, for a plot."""
    curve = Curve(name=name, **look)  # type: ignore[arg-type]
    return curve, Band(
        low=f"{name}_lo", high=f"{name}_hi", source="band", tint=curve.tint, alpha=0.4, group=curve.group or name
    )
