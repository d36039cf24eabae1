"""The state of a page as a value: what a scene stands for, and a scene put into it."""

from __future__ import annotations

from collections.abc import Mapping

from components.beside import holdable, own_values
from components.choices import chosen, stated
from components.numbers import excerpt
from components.page.state import State, Value
from components.parameters import AnyParameter, Quantity, Values
from components.scene import Scene


def state_of(scene: Scene) -> State:
    """What the scene stands for: the parameters that differ from their defaults, the frame where it is not the fitted
    one, what is held, and the curves switched off."""
    return State(
        scene=scene.slug,
        parameters={name: stated(value) for name, value in scene.off_default().items() if name != "hidden"},
        frame=scene.frame,
        held=None if scene.beside is None else stated_own(scene.beside.scene),
        hidden=tuple(scene.hidden),
    )


def values_in(scene: type[Scene], state: State) -> Values:
    """The value that a state gives to every parameter: its own, or the default.

    ValueError, naming the parameter, for one that the scene does not have or that cannot have such a value.
    """
    known = scene.linked()
    given = {name: _value(known, name, value) for name, value in state.parameters.items()}
    defaults = {name: parameter.default for name, parameter in known.items()}
    hidden = chosen(known["hidden"], list(state.hidden))
    return {**defaults, **given, "hidden": hidden}


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
    return {name: stated(value) for name, value in own_values(scene).items()}


def _own(scene: type[Scene], values: Mapping[str, Value]) -> Values:
    known, linked = holdable(scene), scene.linked()
    given = {name: _value(linked, name, value) for name, value in values.items()}
    return {name: value for name, value in given.items() if name in known and value != known[name].default}


def _value(known: dict[str, AnyParameter], name: str, value: Value) -> object:
    if name not in known or name == "hidden":
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
