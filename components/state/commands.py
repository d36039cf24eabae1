"""Commands: find the values that a message of the page sets in a scene, or raise a RefusalError with the reason."""

from __future__ import annotations

import re

import param

from components.language.messages import Act, Choose, SetValues, Typed
from components.layout.choices import chosen
from components.layout.controls import Choice
from components.quantities.formatting import MINUS, excerpt, shortest, tidy
from components.quantities.parameters import AnyParameter, Quantity, Values
from components.quantities.refusals import as_on_screen, in_words
from components.quantities.typed import typed_number
from components.scene import Scene

Errors = dict[str, str]
"""Sentences by parameter; under the name "action" for a button, "state" for a state, "run" for a measurement."""
Command = SetValues | Typed | Act | Choose
_MINUS = re.compile(r"(?<![\w)\]])-(?=\.?\d)")
_SYMBOL = re.compile(r"(?:[b-z]|omega|\w*[\d_]\w*)\b|\w+(?: =|:)")
"""Matches reasons whose first word keeps its small letter at the start of a sentence: k1 = 0, m g C, omega Xp, curve:
..."""
_POWER = re.compile(r"(?<=\d)e(?:\+|(-))0*(?=\d)")


class RefusalError(Exception):
    """A message is refused, with a sentence for each value that is not possible; the page does not change."""

    def __init__(self, errors: Errors) -> None:
        super().__init__(*errors.values())
        self.errors = errors


def asked_values(scene: Scene, command: Command) -> Values:
    """Return the values that a message asks for. Raises RefusalError if one of them is not possible."""
    match command:
        case SetValues(values=values):
            errors = {excerpt(name): _problem(scene, name, value) for name, value in values.items()}
            if found := {name: error for name, error in errors.items() if error}:
                raise RefusalError(found)
            return values
        case Typed(name=name, text=text):
            return {name: _typed(scene, name, text)}
        case Act(name=name):
            return _acted(scene, name)
        case Choose(name=name, value=value):
            parameter = _parameter(scene, name)
            if not isinstance(parameter, (*Choice, param.List)):
                raise RefusalError({excerpt(name): _unknown(name)})
            try:
                return {name: chosen(parameter, value)}
            except ValueError as error:
                raise RefusalError({name: sentence(error)}) from error


def refusal(scene: Scene, command: Command, error: ValueError) -> RefusalError:
    """Return the refusal of values that are possible one by one, but that the physics refuses together."""
    match command:
        case SetValues(values=values):
            return RefusalError({name: f"{sentence(error)} {_still(scene, name)}" for name in values})
        case Typed(name=name):
            return RefusalError({name: f"{sentence(error)} {_still(scene, name)}"})
        case Act():
            return RefusalError({"action": f"{sentence(error)} Still drawn as before."})
        case Choose(name=name):
            return RefusalError({name: sentence(error)})


def _typed(scene: Scene, name: str, text: str) -> float | None:
    quantity = _quantity(scene, name)
    if quantity is None:
        raise RefusalError({excerpt(name): _unknown(name)})
    unit = scene.units().get(name)
    try:
        shown = unit.text if unit else quantity.unit
        value = None if quantity.allow_None and not text.strip() else typed_number(text, shown)
    except ValueError as error:
        raise RefusalError({name: f"{error} {_still(scene, name)}"}) from error
    if unit and value is not None:
        value = unit.value(value)
    if problem := _problem(scene, name, value, excerpt(text.strip()).replace("-", MINUS)):
        raise RefusalError({name: problem})
    return value


def _acted(scene: Scene, name: str) -> Values:
    if name not in [action for group in scene.groups for action, _ in group.actions]:
        raise RefusalError({"action": f"“{excerpt(name)}” is not an action of this scene."})
    try:
        with in_words():
            return scene.action(name)
    except ValueError as error:
        raise RefusalError({"action": f"{sentence(error)} Still drawn as before."}) from error


def _problem(scene: Scene, name: str, value: object, given: str | None = None) -> str | None:
    quantity = _quantity(scene, name)
    if quantity is None:
        return _unknown(name)
    unit = scene.units().get(name)
    if unit is None:
        refusal = quantity.refusal(value, given)
    else:
        refusal = quantity.refusal(value, given or unit.shown(value), unit.text)
    return f"{refusal} {_still(scene, name)}" if refusal else None


def _quantity(scene: Scene, name: str) -> Quantity | None:
    parameter = _parameter(scene, name)
    return parameter if isinstance(parameter, Quantity) else None


def _parameter(scene: Scene, name: str) -> AnyParameter | None:
    """Return a parameter of the scene; None if there is none, or if it only records progress."""
    known = type(scene).param
    return None if name not in known or known[name] in scene.reached else known[name]


def _still(scene: Scene, name: str) -> str:
    value = getattr(scene, name)
    if value is None:
        return "Still drawn as before."
    quantity, unit = _quantity(scene, name), scene.units().get(name)
    write = unit.field if unit else shortest if quantity and quantity.scale == "count" else tidy
    return f"Still drawn with {write(value).replace('-', MINUS)}."


def sentence(error: ValueError) -> str:
    """Return the error message of the physics as a sentence for the screen, with numbers as the visitor typed them:
    1e300."""
    text = _MINUS.sub(MINUS, _POWER.sub(r"e\1", str(error)))
    start = text[:1] if _SYMBOL.match(text) else text[:1].upper()
    return as_on_screen(start + text[1:]) + ("" if text.endswith((".", "!", "?")) else ".")


def _unknown(name: str) -> str:
    return f"“{excerpt(name)}” is not a parameter of this scene."
