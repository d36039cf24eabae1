"""The value that a drag sets, from the position of the pointer, as static/controls/hand.js computes it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from components.language.shapes import AnyWay, ChainRoot, Grab, Locus, Quotient, Root, Share, Swung, Trade, Turn
from components.panel_face.shapes import NamedNumbers
from components.quantities.axes import Axis
from components.quantities.instant import number

QUARTER = math.pi / 2
STEPS = 30
PLACES = 6001
"""Number of points of a curve among which the nearest one is chosen."""
DIGITS = 4
"""Number of digits of a value that a drag sets."""
FREE = Axis(0.0, 1.0)
"""The axis for quantities that are on no plot."""


def dragged(grab: Grab, x: float, y: float, named: NamedNumbers, axes: Mapping[str, Axis]) -> dict[str, float]:
    """Return the values that a drag to (x, y), in pixels, sets: the visible instant as the start of a motion that it
    begins, then the values at the position of the hand."""
    starts = {
        one.parameter: axes.get(one.axis, FREE).value(named[one.of]) / one.size if one.of else 0.0 for one in grab.start
    }
    return starts | {
        way.parameter: float(f"{_value(way, x, y, named, axes.get(way.axis, FREE)) / way.size:.{DIGITS}g}")
        for way in grab.ways
        if way.parameter
    }


def _value(way: AnyWay, x: float, y: float, named: NamedNumbers, axis: Axis) -> float:
    match way:
        case Turn():
            across, down = x - number(way.x, named), (y - number(way.y, named)) / way.tall
            return (math.atan2(across, down) - way.zero) / way.unit
        case ChainRoot():
            s = complex(
                (x - number(way.x, named)) / number(way.right, named),
                (y - number(way.y, named)) / number(way.down, named),
            )
            return number(way.base, named) + number(way.slope, named) * _growth(way, s, named)
        case Trade():
            head = axis.value(named[way.head])
            high = min(axis.value((y - number(way.zero, named)) / number(way.unit, named)), head / 2)
            return math.sqrt(1 - 2 * high / head) - 1
        case Locus():
            return number(way.unit, named) * _nearest(way, x, y, named)
    hand = x if way.across == "x" else y
    least, most = (None if end is None else axis.place(end) for end in (way.least, way.most))
    place = float(np.clip((hand - number(way.zero, named)) / number(way.unit, named), least, most))
    match way:
        case Share():
            return number(way.share, named) * axis.value(place) + axis.value(named[way.rest])
        case Quotient():
            return named[way.over] / place
        case Root():
            return (place + 1 / place) / 2 if way.real or place > 1 else place
        case Swung():
            turning = number(way.counted, named) * axis.value(place)
            return abs(turning) if way.of == "amplitude" else math.copysign(QUARTER, turning)
    return axis.value(place)


def _nearest(way: Locus, x: float, y: float, named: NamedNumbers) -> float:
    """Return the w at which the curve of a response is nearest to a point in pixels."""
    poles = [complex(number(re, named), number(im, named)) for re, im in way.poles]
    w = np.linspace(0.0, 3.0 * max(map(abs, poles)), PLACES)
    curve: Any = sum(number(one, named) * (1j * w) ** i for i, one in enumerate(way.above))
    with np.errstate(all="ignore"):  # at a pole without damping
        for pole in poles:
            curve = curve / (1j * w - pole)
        across = number(way.x, named) + number(way.right, named) * curve.real - x
        down = number(way.y, named) + number(way.down, named) * curve.imag - y
        return float(w[np.nanargmin(np.hypot(across, down))])


def _growth(way: ChainRoot, s: complex, named: NamedNumbers) -> float:
    """Return the u >= 0 for which |A(s) + u B(s) + u^2 C(s)| is least, by steps of Gauss and Newton."""
    a, b, c = (sum(number(one, named) * s**i for i, one in enumerate(term)) for term in way.terms)
    u = number(way.now, named)
    for _ in range(STEPS):
        value, slope = a + u * (b + u * c), b + 2 * u * c
        if not slope:
            break
        u = max(0.0, u - (value * complex(slope).conjugate()).real / abs(slope) ** 2)
    return u
