"""Scales of sliders, as in static/controls/scales.js: from a position, 0 to 1, to a number and back."""

from __future__ import annotations

import math
from decimal import ROUND_HALF_UP, Context

from components.quantities.parameters import Scale

THREE = Context(prec=3, rounding=ROUND_HALF_UP)
Ends = tuple[float, float]


def slider_value(scale: Scale, place: float, soft: Ends) -> float:
    """Return the number at a position, in round steps; three digits on a logarithmic slider."""
    low, high = soft
    if scale == "log":
        return _digits(low * (high / low) ** place)
    finest = {"linear": (high - low) / 400, "near0": high / 10000, "count": 1.0}[scale]
    unit = 10.0 ** math.floor(math.log10(finest))
    raw = high * place**3 if scale == "near0" else low + (high - low) * place
    return _digits(math.floor(raw / unit + 0.5) * unit) + 0.0


def slider_place(scale: Scale, value: float, soft: Ends) -> float:
    """Return the position of a number; the nearer end for numbers beyond the range."""
    low, high = soft
    value = min(max(value, low), high)
    if scale == "log":
        place = math.log(value / low) / math.log(high / low)
    elif scale == "near0":
        place = math.cbrt(value / high)
    else:
        place = (value - low) / (high - low)
    return min(max(place, 0.0), 1.0)


def _digits(value: float) -> float:
    return float(THREE.create_decimal(value))
