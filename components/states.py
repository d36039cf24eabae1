"""The state of a page as a value: what a scene stands for, and a scene put into it."""

from __future__ import annotations

from components.choices import chosen, stated
from components.numbers import excerpt
from components.page.state import State, Value
from components.parameters import AnyParameter, Quantity, Values
from components.scene import Scene


def state_of(scene: Scene) -> State:
    """What the scene stands for: the parameters that differ from their defaults, the frame where it is not the fitted
    one, and the curves switched off."""
    changed = {
        name: getattr(scene, name)
        for name, parameter in scene.linked().items()
        if name != "hidden" and getattr(scene, name) != parameter.default
    }
    return State(
        scene=scene.slug,
        parameters={name: stated(value) for name, value in changed.items()},
        frame=scene.frame,
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
