"""Builders of components.language.shapes.Grab, which describes how a shape responds to dragging."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

from components.language.expressions import Name, Number, as_expression, called
from components.language.shapes import Along, AnyWay, Begin, Grab
from components.layout.stage import PlotFrame


def grab(label: str, *ways: AnyWay, inside: PlotFrame | None = None) -> Grab:
    """Return a grab that sets values while the clock continues. The shape is on the stage, or `inside` a plot."""
    return Grab(label=label, ways=ways, inside=called(inside))


def begin(label: str, *ways: AnyWay, start: tuple[Begin, ...] = ()) -> Grab:
    """Return a grab that begins a motion: time stops, and the visible displacements become the initial ones."""
    return Grab(label=label, ways=ways, begins=True, start=start)


def linear(
    place: Callable[[Number], Number],
    across: Literal["x", "y"],
    parameter: str,
    moves: Name | None = None,
    axis: Name | None = None,
    **more: Any,
) -> Along:
    """Return a rule for a drag along a straight line, on which `place` gives the position of a value.

    The drag moves a signal or scalar of an axis.
    """
    zero = as_expression(place(0.0))
    unit, moved = place(1.0) - zero, called(moves)
    return Along(across=across, zero=zero, unit=unit, parameter=parameter, moves=moved, axis=called(axis), **more)


def on_plot(plot: PlotFrame, across: Literal["x", "y"], parameter: str, moves: Name, axis: Name, **more: Any) -> Along:
    """Return a rule for a drag along an axis of a plot, on the stage or in that plot. `across` is x or y."""
    zero, unit = plot.at(f"{across}0"), plot.at(f"{across}1")
    return Along(across=across, zero=zero, unit=unit, parameter=parameter, moves=moves.name, axis=axis.name, **more)


def begins(parameter: str, of: Name, axis: Name | None = None, *, size: float = 1.0) -> Begin:
    """Return the rule that gives `parameter` its initial value from the current motion:
    components.language.shapes.Begin."""
    return Begin(parameter, of.name, called(axis), size)


def at_rest(*velocities: str) -> tuple[Begin, ...]:
    """Return initial conditions in which these velocities are 0."""
    return tuple(Begin(name) for name in velocities)
