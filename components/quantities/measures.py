"""Units that people type: their size in SI units, and their dimension."""

from __future__ import annotations

import re
import unicodedata
from decimal import Decimal
from typing import NamedTuple

from components.quantities.formatting import MINUS, raised
from physics.precision.exact import PI, precise

Dimension = tuple[int, int, int, int, int]
"""Powers of kg, m, s, A and rad."""

NONE: Dimension = (0, 0, 0, 0, 0)


class Measure(NamedTuple):
    """A unit of measurement: `size` times the SI unit of its dimension."""

    size: Decimal
    dimension: Dimension

    def times(self, other: Measure, power: int) -> Measure:
        size = self.size * other.size**power
        return Measure(size, _add(self.dimension, other.dimension, power))

    def is_kind_of(self, own: Measure) -> bool:
        """Return True if a number in this unit can be converted to `own`; radians are optional."""
        *kind, angle = self.dimension
        *wanted, wanted_angle = own.dimension
        return kind == wanted and angle in (0, wanted_angle)


def _add(one: Dimension, other: Dimension, power: int) -> Dimension:
    kg, m, s, A, rad = (a + power * b for a, b in zip(one, other, strict=True))
    return kg, m, s, A, rad


_KINDS: dict[Dimension, dict[str, str]] = {
    (1, 0, 0, 0, 0): {"g": "1e-3", "t": "1e3", "lb": "0.45359237"},
    (0, 1, 0, 0, 0): {"m": "1", "in": "0.0254", "ft": "0.3048", "mi": "1609.344"},
    (0, 0, 1, 0, 0): {"s": "1", "min": "60", "h": "3600"},
    (0, 0, 0, 1, 0): {"A": "1"},
    (0, 1, -1, 0, 0): {"mph": "0.44704"},
    (1, 1, -2, 0, 0): {"N": "1", "lbf": "4.4482216152605"},
    (1, 1, -1, 0, 0): {"Ns": "1"},
    (1, 2, -2, 0, 0): {"J": "1", "Nm": "1"},
    (1, 2, -3, 0, 0): {"W": "1"},
    (1, -1, -2, 0, 0): {"Pa": "1"},
    (0, 0, 1, 1, 0): {"C": "1"},
    (1, 2, -3, -1, 0): {"V": "1"},
    (1, 2, -3, -2, 0): {"Ω": "1"},
    (-1, -2, 4, 2, 0): {"F": "1"},
    (1, 2, -2, -2, 0): {"H": "1"},
    (0, 0, 0, 0, 1): {"rad": "1"},
}
_PREFIXES = {"n": -9, "μ": -6, "u": -6, "m": -3, "c": -2, "k": 3, "M": 6, "G": 9}
_PREFIXED = frozenset(["g", "m", "s", "A", "N", "J", "W", "Pa", "C", "V", "Ω", "F", "H", "rad", "Hz", "Ns", "Nm"])
_FACTOR = re.compile(r"(?P<name>[^\W\d_]+|°)(?:\^?(?P<power>[+-]?[0-9]))?|(?P<one>1)(?=/)")


def _measures() -> dict[str, Measure]:
    """A frequency counts cycles: 1 Hz = 2 pi rad/s."""
    with precise():
        turns, angles = (0, 0, -1, 0, 1), (0, 0, 0, 0, 1)
        known = {
            "°": Measure(PI / 180, angles),
            "deg": Measure(PI / 180, angles),
            "Hz": Measure(2 * PI, turns),
            "rpm": Measure(PI / 30, turns),
            "kn": Measure(Decimal(1852) / 3600, (0, 1, -1, 0, 0)),
        }
        for dimension, units in _KINDS.items():
            known |= {name: Measure(Decimal(size), dimension) for name, size in units.items()}
        return known


_KNOWN = _measures()


def measure(text: str) -> Measure:
    """Return the measure of a unit such as N/m, km/h, N s/m, kg·m² or s⁻¹. Each / divides only by the next unit.

    Raises ValueError with the unknown part.
    """
    plain = unicodedata.normalize("NFKC", raised(text)).replace(MINUS, "-")
    plain = re.sub(r"\s*([/*·×⋅])\s*|\s+", lambda match: match[1] or " ", plain.strip())
    found, place, divides = Measure(Decimal(1), NONE), 0, False
    with precise():
        while place < len(plain) or divides:
            match = _FACTOR.match(plain, place)
            if match is None:
                raise ValueError(plain[place:])
            if not match["one"]:
                power = int(match["power"] or 1)
                found = found.times(_one(match["name"]), -power if divides else power)
            place = match.end()
            divides = plain[place : place + 1] == "/"
            place += plain[place : place + 1] in tuple("/*·×⋅ ")
        return found


def _one(name: str) -> Measure:
    if name in _KNOWN:
        return _KNOWN[name]
    prefix, rest = name[0], name[1:]
    if prefix not in _PREFIXES or rest not in _PREFIXED:
        raise ValueError(name)
    whole = _KNOWN[rest]
    return whole._replace(size=whole.size.scaleb(_PREFIXES[prefix]))
