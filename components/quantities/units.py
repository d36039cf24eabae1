"""Units in which a visitor reads and types a quantity, other than its own unit."""

from __future__ import annotations

from dataclasses import dataclass

from components.quantities.formatting import MINUS, tidy

ROUND = 6
"""The most digits of a round number in another unit; other numbers are shown with four."""


@dataclass(frozen=True)
class Unit:
    """A unit: `text` is its symbol, `size` its size in the quantity's own unit: Unit("ft/s", 0.3048)."""

    text: str
    size: float

    def field(self, value: float) -> str:
        """Return the text of an input field for a value in the quantity's own unit."""
        number = value / self.size
        few = float(f"{number:.{ROUND}g}")
        return tidy(few if abs(few - number) <= 1e-12 * abs(number) else float(f"{number:.4g}"))

    def shown(self, value: object) -> str | None:
        """Return the value of a message as its field would show it; None if it is no usable number."""
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not abs(value) < 1e300:
            return None
        return self.field(value).replace("-", MINUS)

    def value(self, number: float) -> float:
        """Return a number in this unit in the quantity's own unit: 150 ft/s are 45.72 m/s, not 45.720000000000006."""
        return float(f"{number * self.size:.15g}")
