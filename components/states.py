"""The state of a page as a value: what a scene or a link stands for, and a scene put into it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from components.beside import HIDDEN, holdable, own_values
from components.choices import chosen, stated
from components.description import plots
from components.frames import checked
from components.numbers import excerpt
from components.page.state import State, Value
from components.parameters import AnyParameter, Quantity, Values
from components.scene import Scene
from components.url import Link


def state_of(scene: Scene) -> State:
    """What the scene stands for: the parameters that differ from their defaults, the frame where it is not the fitted
    one, what is held, and the curves switched off where they are not the usual ones."""
    own = scene.off_default()
    return State(
        scene=scene.slug,
        parameters={name: stated(value) for name, value in own.items() if name != HIDDEN},
        frame=scene.frame,
        held=None if scene.beside is None else stated_own(scene.beside.scene),
        hidden=tuple(scene.hidden) if HIDDEN in own else None,
    )


def state_in(link: Link, scene: type[Scene]) -> State:
    """The state that a link to the scene stands for: of an address as of a step of a walk."""
    values = {**link.values}
    hidden = values.pop(HIDDEN, None)
    held, before = (None if other is None else _stated(other) for other in (link.held, link.before))
    return State(
        scene=link.slug,
        parameters=_stated(values),
        frame=link.frame,
        held=held,
        covered=link.covered,
        before=before,
        hidden=None if hidden is None else tuple(hidden),  # type: ignore[arg-type]  # a list of names
    )


def put(scene: Scene, state: State) -> None:
    """Put a scene into a state, but for what is covered; ValueError, in words, where it cannot be."""
    kind = type(scene)
    scene.open(values_in(kind, state), state.frame and checked(state.frame), held_in(kind, state))


def strange_axes(scene: Scene, state: State) -> Iterator[str]:
    """A sentence for each axis that a state names and that the scene, put into it, does not have."""
    for name in state.frame.ranges if state.frame else ():
        if name not in scene.shown.axes:
            yield f"frame.{excerpt(name)}: “{excerpt(name)}” is not an axis of this picture."


def strange_curves(scene: Scene, state: State) -> Iterator[str]:
    """A sentence for each curve that a state switches off and that the scene does not have."""
    blocks = list(plots(type(scene)))
    drawn = {curve.group for plot in blocks for curve in plot.curves}
    drawn |= {band.group for plot in blocks for band in plot.regions}
    yield from (
        f"hidden: “{excerpt(name)}” is no curve of this scene." for name in state.hidden or () if name not in drawn
    )


def values_in(scene: type[Scene], state: State) -> Values:
    """The value that a state gives to every parameter: its own, or the default.

    ValueError, naming the parameter, for one that the scene does not have or that cannot have such a value.
    """
    known = scene.linked()
    given = {name: _value(known, name, value) for name, value in state.parameters.items()}
    defaults = {name: parameter.default for name, parameter in known.items()}
    hidden = {} if state.hidden is None else {HIDDEN: chosen(known[HIDDEN], list(state.hidden))}
    return {**defaults, **given, **hidden}


def held_in(scene: type[Scene], state: State) -> Values | None:
    """The values held beside the others, where they are not their defaults; how things were shown is not held.

    ValueError as in `values_in`.
    """
    return None if state.held is None else _own(scene, state.held)


def before_in(scene: type[Scene], state: State) -> Values | None:
    """The same of those from before the change that is to be predicted."""
    return None if state.before is None else _own(scene, state.before)


def stated_own(scene: Scene) -> dict[str, Value]:
    """What of a scene is not at its default, but for how it is shown, as a state carries it."""
    return _stated(own_values(scene))


def _stated(values: Values) -> dict[str, Value]:
    return {name: stated(value) for name, value in values.items()}


def _own(scene: type[Scene], values: Mapping[str, Value]) -> Values:
    known, linked = holdable(scene), scene.linked()
    given = {name: _value(linked, name, value) for name, value in values.items()}
    return {name: value for name, value in given.items() if name in known and value != known[name].default}


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
