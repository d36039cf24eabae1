"""Readouts: the numbers of a picture that are compared with another picture's."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass
from decimal import Decimal

from components.quantities.formatting import short, signed

SAME = 1e-12
"""Relative difference of equal numbers computed in different ways; smaller differences are rounding errors."""
PARTS = {0.5: "½", 0.25: "¼", 0.75: "¾"}


@dataclass(frozen=True)
class SceneNumber:
    """A number of a scene.

    Attributes
    ----------
    value : float
        The number in SI units; infinite only if the physics is infinite.
    unit : str
        Its unit, "" for a pure number.
    description : str
        Its meaning in words.
    """

    value: float
    unit: str
    description: str


def scene_number(value: object, unit: str, description: str) -> SceneNumber | None:
    """Return a number of a scene; None for a text, for None, and for a decimal beyond the range of doubles."""
    if isinstance(value, Decimal) and value.is_finite() and math.isinf(float(value)):
        return None
    if isinstance(value, bool) or not isinstance(value, (int, float, Decimal)):
        return None
    return SceneNumber(float(value), unit, description)


@dataclass(frozen=True)
class Readout:
    """A number of a picture: `name` is the name of its live number, by which it can be hidden, and `also` has other
    names that show the same value. An angle is compared by difference."""

    name: str
    symbol: str
    value: float
    unit: str
    tint: str = "ink"
    angle: bool = False
    also: tuple[str, ...] = ()

    def is_in(self, covered: Collection[str]) -> bool:
        """Return True if one of these names shows its value."""
        return any(name in covered for name in (self.name, *self.also))


def is_same(held: float, now: float) -> bool:
    """Return True if two numbers differ at most by rounding."""
    return held == now or (math.isfinite(held) and math.isfinite(now) and math.isclose(held, now, rel_tol=SAME))


def became(held: float, now: float, angle: bool = False) -> str:
    """Return the change of a number in words: "× 4", or the difference if a factor makes no sense."""
    if not (math.isfinite(held) and math.isfinite(now)):
        return ""
    if not angle and held and now:
        ratio = Decimal(now) / Decimal(held)
        text = PARTS.get(float(ratio), short(ratio))
        if text != "1":
            return f"× {text}"
    return signed(Decimal(now) - Decimal(held))
