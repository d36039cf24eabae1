"""The stage of the driven mass: the block on spring and dashpot, and beside it what drives it, to be set by a hand."""

from __future__ import annotations

from collections.abc import Callable

from components.dashpot import NARROW_BELOW, apparatus
from components.language.numbers import Number, var
from components.language.shapes import Grab
from components.layout.grabs import at_rest, begin, begins, grab, linear
from components.layout.stage import HALL, NARROW, ON_WIDE, WIDE, H, Shape, T, W, arrow, circle, line, shown_by, text
from components.quantities.declared import DrawnAxis
from components.scenes.driven.curves import Axes, Places, Resonance, X
from components.scenes.driven.curves import Signals as S
from components.scenes.driven.numbers import Numbers as N

MIDDLE = WIDE * 0.34 * W + NARROW * 0.28 * W
LEVEL = WIDE * X.y(0) + NARROW * 0.3 * H
SCALE = WIDE * -1 * X.per_y + NARROW * 0.12 * H * var(Places.per_reach)
STROKE = (0.7 - 0.15 * HALL + (0.4 - 0.25 * HALL) * var(Resonance.driven["base"])) * (
    WIDE * (X.bottom - X.top) + NARROW * 0.34 * H
)
SIDE = (WIDE * 42 + NARROW * 42) * var(Places.side)
ASIDE = MIDDLE + 0.5 * SIDE + 48
"""Where the drive stands, beside the block."""
PUSH = WIDE * 0.34 * (X.bottom - X.top) + NARROW * 0.16 * H
"""The length of the drive's axis, in pixels."""
WHEEL = 9


def height(x: Number) -> Number:
    return LEVEL - SCALE * x


def strength(value: Number) -> Number:
    """The height of a force, or of an unbalance, on its own axis beside the block."""
    return LEVEL - PUSH * var(Places.per_drive) * value


MASS_GRAB = begin(
    "Mass, start",
    linear(height, "y", "x_0", S.x, Axes.x, rate="v_0"),
    start=(begins("x_0", S.x, Axes.x), *at_rest("v_0")),
)


def _sets(label: str, parameter: str, place: Callable[[Number], Number], axis: DrawnAxis) -> Grab:
    return grab(label, linear(place, "y", parameter, Places.size, axis, least=0.0))


def block() -> list[Shape]:
    y, lift = height(var(S.x)), SCALE * var(S.y)
    lowest = LEVEL + 0.5 * STROKE + 0.5 * SIDE
    arrow_at = MIDDLE - 0.5 * SIDE - 14
    return [
        line(0.03 * W, LEVEL, WIDE * (X.left - 30) + NARROW * 0.55 * W, LEVEL, style="eq", tint="mute"),
        line(MIDDLE, y, X.x(T), y, style="level", tint="m1", show=ON_WIDE),
        *apparatus(MIDDLE, y, SIDE, lowest, STROKE, var(Places.wire), MASS_GRAB, lift, beside=True),
        arrow(arrow_at, LEVEL, arrow_at, y, tint="m1"),
        *_drives(y, lowest, lift),
        text(WIDE * 2 + NARROW * 0.58 * W, 16, f"*x* = {S.x} {N.x_unit}", "start", tint="m1", style="t2 b halo"),
    ]


def _drives(y: Number, floor: Number, lift: Number) -> list[Shape]:
    """The force beside the block, the motion of the base beside its wall, the mass that turns in the block."""
    push, base, foot = strength(var(Places.size)), _raised(var(Places.size)), floor + NARROW_BELOW
    ring = {"style": "ghost", "tint": "F"}
    turning = MIDDLE + WHEEL * var(S.cosine), y - WHEEL * var(S.sine)
    return [
        *shown_by(
            Resonance.driven["force"],
            line(ASIDE, LEVEL, ASIDE, push, style="dotted", tint="F"),
            arrow(ASIDE, LEVEL, ASIDE, strength(var(S.F)), tint="F", style="thick", head=14),
            circle(ASIDE, push, 5, **ring, grab=_sets("Force, amplitude", "F_0", strength, Axes.drive)),
            text(ASIDE + 10, push + 5, "*F*_0", "start", tint="F", style="t2 b halo"),
        ),
        *shown_by(
            Resonance.driven["base"],
            line(ASIDE, foot, ASIDE, base, style="dotted", tint="F"),
            arrow(ASIDE, foot, ASIDE, foot - lift, tint="F", style="thick", head=14),
            circle(ASIDE, base, 5, **ring, grab=_sets("Base, amplitude", "Y", _raised, Axes.x)),
            text(ASIDE + 10, base + 5, "*Y*", "start", tint="F", style="t2 b halo"),
        ),
        *shown_by(
            Resonance.driven["unbalance"],
            circle(MIDDLE, y, WHEEL, style="wheel", tint="ink"),
            circle(*turning, 5, tint="F"),
            line(ASIDE, LEVEL, ASIDE, push, style="dotted", tint="F"),
            circle(ASIDE, push, 5, **ring, grab=_sets("Unbalance", "moment", strength, Axes.drive)),
            text(ASIDE + 10, push + 5, "*m*_0*e*", "start", tint="F", style="t2 b halo"),
        ),
    ]


def _raised(value: Number) -> Number:
    return LEVEL + 0.5 * STROKE + 0.5 * SIDE + NARROW_BELOW - SCALE * value
