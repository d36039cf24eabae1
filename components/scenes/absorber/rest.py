"""The machine's motion from its start: particular solution and complementary part, which only damping lets die."""

from __future__ import annotations

from msgspec.structs import replace

from components.language.blocks import Block
from components.layout.plots import Room, curve, plot
from components.layout.sheet import Paragraph, column, either, term, words
from components.quantities.axes import Axis, nice_ticks, widest
from components.scene.traces import Columns
from components.scenes.absorber.duty import Duty
from components.scenes.absorber.moved import FromStart
from components.scenes.absorber.numbers import Numbers as N

TALLEST = 1e30
"""The largest motion drawn from a start, over the static deflection: a number in its unit is a float32."""
_NEVER = "does not die out: nothing damps it."
SENTENCES: list[Paragraph] = [
    either(
        "why_rest",
        parts=f"The particular solution is {N.swing} {N.x_unit}. The complementary part, {N.part1} {N.x_unit} at "
        f"$\\omega_-$ and {N.part2} {N.x_unit} at $\\omega_+$, {_NEVER}",
        alone=f"The particular solution is {N.swing} {N.x_unit}. The complementary part, {N.part2} {N.x_unit} at its "
        f"own frequency, {_NEVER}",
        grow="The drive meets a natural frequency: no particular solution exists, the swing grows in "
        "proportion to time.",
        beat="Next to a natural frequency the machine's swing grows for long in proportion to time, then it beats.",
        aside="Next to a natural frequency at which almost mass 2 alone swings its swing grows for long, the machine's "
        f"stays within {N.rest1} {N.x_unit}.",
        damped=f"The particular solution, {N.swing} {N.x_unit}, is what remains. The complementary part dies out: "
        f"after {N.dies} at most 1 % of it is left.",
    ),
]


def rest_block() -> Block:
    """x1 from its start and its two parts, on the clock that moves the stage."""
    curves = (
        curve("x1_c", source="rest", tint="xc", width="dash", label="*x*_c"),
        curve("x1_p", source="rest", tint="xp", label="*x*_p"),
        curve("x1", source="rest", tint="m1", width="sum", label="*x*_1", signal="x1"),
    )
    heading = (
        term("x1", "sum", "m1", formula=r"x_1 ="),
        term("x1_p", "line", "xp", formula=r"x_{\mathrm{p}}"),
        term("x1_c", "dash", "xc", formula=r"+\; x_{\mathrm{c}}"),
    )
    return column(
        plot(
            "rest",
            x="t",
            y="rest",
            title="Displacement of the machine against time, from its start, with its two parts",
            curves=curves,
            heading=heading,
            cursor="time",
            room=Room(44, 26),
            phone=5,
            height=150,
        ),
        words(*SENTENCES, style="facts", phone=6),
    )


def rest_columns(moved: FromStart | None, duty: Duty, unit: Axis) -> tuple[Columns, Axis]:
    """x1 and its parts, where they are shown, on an axis in the unit of `unit`.

    Next to a natural frequency, where the parts are huge and opposite, x1 alone.
    """
    if moved is None:
        return {}, replace(unit, start=-unit.end)
    columns = {"t": moved.t, **rest_exact(moved)}
    low, high = widest(*((float(c.min()), float(c.max())) for name, c in columns.items() if name != "t"))
    if duty.over_deflection(max(-low, high)) > TALLEST:
        raise ValueError(
            f"the motion is too large to be drawn: at most {TALLEST:g} static deflections F_0/k1 are allowed"
        )
    room = 0.08 * (high - low)
    ticks = nice_ticks(unit.place(low), unit.place(high), 3) if high > low else (0.0,)
    return columns, replace(unit, start=low - room, end=high + room or unit.end, ticks=ticks)


def rest_exact(moved: FromStart) -> Columns:
    """x1, and its parts where they are drawn."""
    if moved.particular is None or moved.complementary is None:
        return {"x1": moved.x[0]}
    return {"x1": moved.x[0], "x1_p": moved.particular[0], "x1_c": moved.complementary[0]}
