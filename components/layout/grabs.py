"""Grabs: builders of components.language.shapes.Grab, which tells what a hand does with a shape."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

from components.language.numbers import Number, as_expression, var
from components.language.shapes import Along, AnyWay, Begin, Grab


def grab(label: str, *ways: AnyWay, inside: str = "") -> Grab:
    """A grab that sets values and leaves the clock alone, in the frame of the plot `inside` if there is one."""
    return Grab(label=label, ways=ways, inside=inside)


def begin(label: str, *ways: AnyWay, start: tuple[Begin, ...] = ()) -> Grab:
    """A grab that begins a motion: time stops, and the displacements seen become the new start."""
    return Grab(label=label, ways=ways, begins=True, start=start)


def linear(place: Callable[[Number], Number], across: Literal["x", "y"], parameter: str, **more: Any) -> Along:
    """A way along which `place` says where a value stands, in proportion."""
    zero = as_expression(place(0.0))
    return Along(across=across, zero=zero, unit=place(1.0) - zero, parameter=parameter, **more)


def on_plot(plot: str, across: Literal["x", "y"], parameter: str, moves: str, axis: str, **more: Any) -> Along:
    """A way along an axis of a plot, on the stage or over that plot: `across` is x or y."""
    zero, unit = var(f"{plot}.{across}0"), var(f"{plot}.{across}1")
    return Along(across=across, zero=zero, unit=unit, parameter=parameter, moves=moves, axis=axis, **more)


def at_rest(*velocities: str) -> tuple[Begin, ...]:
    """A start without velocity."""
    return tuple(Begin(name) for name in velocities)
