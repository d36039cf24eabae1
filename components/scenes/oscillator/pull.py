"""The force of the spring, F = -k x, as an arrow and a live number: what the scene shows when asked for it."""

from __future__ import annotations

from dataclasses import dataclass, field

from components.language.numbers import Number, var
from components.language.picture import Digits
from components.language.signals import AnySignal
from components.layout.stage import Shape, arrow, shown_by, text
from components.quantities.axes import Axis, nice_axis
from components.quantities.motion import derived, scaled

SHARE = 0.75
"""The arrow at the turning point is this long, over the amplitude."""


@dataclass(frozen=True, kw_only=True)
class Force:
    """The spring's force in a picture: its signal, its unit and its digits."""

    signals: dict[str, AnySignal] = field(default_factory=dict)
    scalars: dict[str, float] = field(default_factory=lambda: {"forced": 0.0})
    values: dict[str, str] = field(default_factory=lambda: {"F": "", "F_unit": ""})
    live: dict[str, Digits] = field(default_factory=dict)


def force(k: float, largest: float, size: Axis) -> Force:
    """F while the signal x, on the axis `size`, moves; it reaches `largest` (m)."""
    axis = nice_axis(0.0, scaled(0, k, largest) or 1.0, "N", exact=True)
    return Force(
        signals={"F": derived(-scaled(axis.exponent - size.exponent, k) * var("x"))},
        scalars={"forced": float(k > 0)},
        values={"F_unit": axis.full_unit},
        live={"F": axis.digits(signed=True)},
    )


def pulled(x: Number, y: Number, level: Number) -> list[Shape]:
    """Beside the mass, from its middle back towards equilibrium; its name right of the middle of the arrow."""
    tip = y + SHARE * (level - y)
    return shown_by(
        "forced",
        arrow(x, y, x, tip, tint="F", style="thick", head=16),
        text(x + 12, (y + tip) * 0.5 + 5, "*F*", "start", tint="F", style="t2 b halo"),
    )
