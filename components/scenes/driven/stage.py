"""The stage of the driven mass: the block on spring and dashpot, and beside it what drives it, to be set by a hand."""

from __future__ import annotations

from collections.abc import Callable

from components.dashpot import NARROW_BELOW, apparatus
from components.language.numbers import Number, var
from components.language.shapes import Begin, Grab
from components.layout.grabs import at_rest, begin, grab, linear
from components.layout.stage import HALL, NARROW, WIDE, H, Shape, T, W, arrow, circle, line, on_x, on_y, shown_by, text
from components.scenes.driven.numbers import Numbers as N

MIDDLE = WIDE * 0.34 * W + NARROW * 0.28 * W
LEVEL = WIDE * on_y("x", 0) + NARROW * 0.3 * H
SCALE = WIDE * -1 * var("x.y1") + NARROW * 0.12 * H * var("per_reach")
STROKE = (0.7 - 0.15 * HALL + (0.4 - 0.25 * HALL) * var("shaken")) * (
    WIDE * (var("x.bottom") - var("x.top")) + NARROW * 0.34 * H
)
SIDE = (WIDE * 42 + NARROW * 42) * var("side")
ASIDE = MIDDLE + 0.5 * SIDE + 48
"""Where the drive stands, beside the block."""
PUSH = WIDE * 0.34 * (var("x.bottom") - var("x.top")) + NARROW * 0.16 * H
"""The length of the drive's axis, in pixels."""
WHEEL = 9


def height(x: Number) -> Number:
    return LEVEL - SCALE * x


def strength(value: Number) -> Number:
    """The height of a force, or of an unbalance, on its own axis beside the block."""
    return LEVEL - PUSH * var("per_drive") * value


MASS_GRAB = begin(
    "Mass, start",
    linear(height, "y", "x_0", moves="x", axis="x", rate="v_0"),
    start=(Begin("x_0", "x", "x"), *at_rest("v_0")),
)


def _sets(label: str, parameter: str, place: Callable[[Number], Number], axis: str) -> Grab:
    return grab(label, linear(place, "y", parameter, moves=f"{parameter}_at", axis=axis, least=0.0))


def block() -> list[Shape]:
    y, lift = height(var("x")), SCALE * var("y")
    lowest = LEVEL + 0.5 * STROKE + 0.5 * SIDE
    arrow_at = MIDDLE - 0.5 * SIDE - 14
    return [
        line(0.03 * W, LEVEL, WIDE * (var("x.left") - 30) + NARROW * 0.55 * W, LEVEL, style="eq", tint="mute"),
        line(MIDDLE, y, on_x("x", T), y, style="level", tint="m1", show="wide"),
        *apparatus(MIDDLE, y, SIDE, lowest, STROKE, var("wire"), MASS_GRAB, lift, beside=True),
        arrow(arrow_at, LEVEL, arrow_at, y, tint="m1"),
        *_drives(y, lowest, lift),
        text(
            WIDE * 2 + NARROW * 0.58 * W, 16, f"*x* = {{x}} {N.x_unit}", "start", tint="m1",
            style="t2 b halo",
        ),
    ]  # fmt: skip


def _drives(y: Number, floor: Number, lift: Number) -> list[Shape]:
    """The force beside the block, the motion of the base beside its wall, the mass that turns in the block."""
    force, base, wheel = strength(var("F_0_at")), _raised(var("Y_at")), strength(var("moment_at"))
    foot, ring = floor + NARROW_BELOW, {"style": "ghost", "tint": "F"}
    turning = MIDDLE + WHEEL * var("cosine"), y - WHEEL * var("sine")
    return [
        *shown_by(
            "force",
            line(ASIDE, LEVEL, ASIDE, force, style="dotted", tint="F"),
            arrow(ASIDE, LEVEL, ASIDE, LEVEL - PUSH * var("per_drive") * var("F"), tint="F", style="thick", head=14),
            circle(ASIDE, force, 5, **ring, grab=_sets("Force, amplitude", "F_0", strength, "drive")),
            text(ASIDE + 10, force + 5, "*F*_0", "start", tint="F", style="t2 b halo"),
        ),
        *shown_by(
            "base",
            line(ASIDE, foot, ASIDE, base, style="dotted", tint="F"),
            arrow(ASIDE, foot, ASIDE, foot - lift, tint="F", style="thick", head=14),
            circle(ASIDE, base, 5, **ring, grab=_sets("Base, amplitude", "Y", _raised, "x")),
            text(ASIDE + 10, base + 5, "*Y*", "start", tint="F", style="t2 b halo"),
        ),
        *shown_by(
            "unbalance",
            circle(MIDDLE, y, WHEEL, style="wheel", tint="ink"),
            circle(*turning, 5, tint="F"),
            line(ASIDE, LEVEL, ASIDE, wheel, style="dotted", tint="F"),
            circle(ASIDE, wheel, 5, **ring, grab=_sets("Unbalance", "moment", strength, "drive")),
            text(ASIDE + 10, wheel + 5, "*m*_0*e*", "start", tint="F", style="t2 b halo"),
        ),
    ]


def _raised(value: Number) -> Number:
    return LEVEL + 0.5 * STROKE + 0.5 * SIDE + NARROW_BELOW - SCALE * value
