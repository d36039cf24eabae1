"""Builders of components.language.shapes.Grab, which describes how a shape responds to dragging."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

from components.language.numbers import Name, Number, as_expression, called
from components.language.shapes import Along, AnyWay, Begin, Grab
from components.layout.stage import PlotFrame


def grab(label: str, *ways: AnyWay, inside: PlotFrame | None = None) -> Grab:
    """A grab that sets values and leaves the clock alone, in the frame of the plot `inside` if there is one."""
    return Grab(label=label, ways=ways, inside=called(inside))


def begin(label: str, *ways: AnyWay, start: tuple[Begin, ...] = ()) -> Grab:
    """A grab that begins a motion: time stops, and the displacements seen become the new start."""
    return Grab(label=label, ways=ways, begins=True, start=start)


def linear(
    place: Callable[[Number], Number],
    across: Literal["x", "y"],
    parameter: str,
    moves: Name | None = None,
    axis: Name | None = None,
    **more: Any,
) -> Along:
    """Return a way along which `place` gives the position of a value, in proportion. It moves a signal or scalar of an
    axis."""
    zero = as_expression(place(0.0))
    unit, moved = place(1.0) - zero, called(moves)
    return Along(across=across, zero=zero, unit=unit, parameter=parameter, moves=moved, axis=called(axis), **more)


def on_plot(plot: PlotFrame, across: Literal["x", "y"], parameter: str, moves: Name, axis: Name, **more: Any) -> Along:
    """A way along an axis of a plot, on the stage or over that plot: `across` is x or y."""
    zero, unit = plot.at(f"{across}0"), plot.at(f"{across}1")
    return Along(across=across, zero=zero, unit=unit, parameter=parameter, moves=moves.name, axis=axis.name, **more)


def begins(parameter: str, of: Name, axis: Name | None = None, *, size: float = 1.0) -> Begin:
    """The start of `parameter` from what is seen: components.language.shapes.Begin."""
    return Begin(parameter, of.name, called(axis), size)


def at_rest(*velocities: str) -> tuple[Begin, ...]:
    """A start without velocity."""
    return tuple(Begin(name) for name in velocities)
