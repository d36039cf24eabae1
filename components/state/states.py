"""States of a page: conversion from links, and to scenes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from components.language.state import State, Value
from components.layout.choices import chosen, stated
from components.quantities.formatting import excerpt
from components.quantities.parameters import AnyParameter, Quantity, Values
from components.scene import Picture, Scene
from components.state.compared import HIDDEN, holdable, own_values
from components.state.link import Link
from components.state.scene_sheet import plots


def state_in(link: Link) -> State:
    """Return the state of a link, in an address or in a step of a walk."""
    values = {**link.values}
    hidden = values.pop(HIDDEN, None)
    held, before = (None if other is None else stated_all(other) for other in (link.held, link.before))
    return State(
        scene=link.slug,
        parameters=stated_all(values),
        frame=link.frame,
        held=held,
        covered=link.covered,
        before=before,
        hidden=None if hidden is None else tuple(hidden),  # type: ignore[arg-type]  # a list of names
        show=link.show,
    )


def strange_axes(picture: Picture, state: State) -> Iterator[str]:
    """Yield a sentence for each axis in a state that its picture does not have."""
    for name in state.frame.ranges if state.frame else ():
        if name not in picture.axes:
            yield f"frame.{excerpt(name)}: “{excerpt(name)}” is not an axis of this picture."


def strange_curves(kind: type[Scene], state: State) -> Iterator[str]:
    """Yield a sentence for each switched-off curve in a state that the scene does not have."""
    blocks = list(plots(kind))
    drawn = {curve.group for plot in blocks for curve in plot.curves}
    drawn |= {band.group for plot in blocks for band in plot.regions}
    yield from (
        f"hidden: “{excerpt(name)}” is no curve of this scene." for name in state.hidden or () if name not in drawn
    )


def scene_in(kind: type[Scene], state: State) -> Scene:
    """Return the scene of a state.

    Raises ValueError, with the name of the parameter, for an unknown parameter or an impossible value.
    """
    known = kind.linked()
    hidden = {} if state.hidden is None else {HIDDEN: chosen(known[HIDDEN], list(state.hidden))}
    return kind.at({name: _value(known, name, value) for name, value in state.parameters.items()} | hidden)


def other_in(kind: type[Scene], values: Mapping[str, Value] | None) -> Scene | None:
    """Return the scene with these values: the compared scene of a state, or the one from before a predicted change.

    The values have no display parameters. Raises ValueError as `scene_in` does.
    """
    if values is None:
        return None
    known, linked = holdable(kind), kind.linked()
    given = {name: _value(linked, name, value) for name, value in values.items()}
    return kind.at({name: value for name, value in given.items() if name in known and value != known[name].default})


def stated_own(scene: Scene) -> dict[str, Value]:
    """Return the parameters that are not at their defaults, in the form of a state, without display parameters."""
    return stated_all(own_values(scene))


def stated_all(values: Values) -> dict[str, Value]:
    """Return values of parameters in the form of a state: choices and lists as words."""
    return {name: stated(value) for name, value in values.items()}


def _value(known: dict[str, AnyParameter], name: str, value: Value) -> object:
    if name not in known or name == HIDDEN:
        raise ValueError(f"“{excerpt(name)}” is not a parameter of this scene.")
    parameter = known[name]
    if not isinstance(parameter, Quantity):
        try:
            return chosen(parameter, value)
        except ValueError as reason:
            raise ValueError(f"{name}: {reason}") from reason
    refusal = parameter.refusal(value)
    if refusal:
        raise ValueError(f"{name}: {refusal}")
    return value
