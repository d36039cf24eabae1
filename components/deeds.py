"""What a message of the page does to a scene: in one batch, or refused in words."""

from __future__ import annotations

import re

import param

from components.choices import chosen
from components.controls import Choice
from components.numbers import MINUS, excerpt, tidy
from components.page.messages import Act, Choose, RunOrder, SetValues, Typed
from components.parameters import AnyParameter, Quantity, Values
from components.refusals import as_on_screen, in_words
from components.scene import Scene
from components.typed import typed_number

Errors = dict[str, str]
Deed = SetValues | Typed | Act | Choose | RunOrder
_MINUS = re.compile(r"(?<![\w)\]])-(?=\.?\d)")
_SYMBOL = re.compile(r"(?:[b-z]|omega|\w*[\d_]\w*)\b|\w+ =")
"""What a reason begins with that keeps its own letters: k1 = 0, m g C, omega Xp."""
_POWER = re.compile(r"(?<=\d)e(?:\+|(-))0*(?=\d)")


def apply(scene: Scene, deed: Deed) -> Errors:
    """Do what a message asks, in one batch; where that is refused, say why, by parameter.

    A refused message changes nothing. An action is refused under the name "action".
    """
    match deed:
        case SetValues(values=values):
            return _set(scene, values)
        case Typed(name=name, text=text):
            return _type(scene, name, text)
        case Act(name=name):
            return _act(scene, name)
        case Choose(name=name, value=value):
            return _choose(scene, name, value)
        case RunOrder(order=order):
            return _run(scene, order)


def _run(scene: Scene, order: str) -> Errors:
    if scene.running is None:
        return {"run": f"“{excerpt(order)}” is not possible: there is nothing to run here."}
    try:
        scene.running.obey(order)
    except ValueError as error:
        return {"run": str(error)}
    return {}


def _set(scene: Scene, values: dict[str, float | None]) -> Errors:
    errors = {excerpt(name): _problem(scene, name, value) for name, value in values.items()}
    found = {name: error for name, error in errors.items() if error}
    return found or _try(scene, values)


def _type(scene: Scene, name: str, text: str) -> Errors:
    quantity = _quantity(scene, name)
    if quantity is None:
        return {excerpt(name): _unknown(name)}
    unit = scene.units().get(name)
    shown = unit.text if unit else quantity.unit
    try:
        value = None if quantity.allow_None and not text.strip() else typed_number(text, shown)
    except ValueError as error:
        return {name: f"{error} {_still(scene, name)}"}
    if unit and value is not None:
        value = unit.value(value)
    problem = _problem(scene, name, value, excerpt(text.strip()).replace("-", MINUS))
    return {name: problem} if problem else _try(scene, {name: value})


def _choose(scene: Scene, name: str, value: object) -> Errors:
    parameter = _parameter(scene, name)
    if not isinstance(parameter, (*Choice, param.List)):
        return {excerpt(name): _unknown(name)}
    try:
        scene.set({name: chosen(parameter, value)})
    except ValueError as error:
        return {name: sentence(error)}
    return {}


def _act(scene: Scene, name: str) -> Errors:
    known = [action for group in scene.groups for action, _ in group.actions]
    if name not in known:
        return {"action": f"“{excerpt(name)}” is not an action of this scene."}
    try:
        with in_words():
            values = scene.action(name)
        scene.set(values)
    except ValueError as error:
        return {"action": f"{sentence(error)} Still drawn as before."}
    return {}


def _try(scene: Scene, values: Values) -> Errors:
    """Set quantities that are possible one by one; the physics may still refuse them together."""
    still = {name: _still(scene, name) for name in values}
    try:
        scene.set(values)
    except ValueError as error:
        return {name: f"{sentence(error)} {still[name]}" for name in values}
    return {}


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
    return scene.param[name] if name in scene.param else None  # noqa: SIM401 (not a dict)


def _still(scene: Scene, name: str) -> str:
    value = getattr(scene, name)
    if value is None:
        return "Still drawn as before."
    unit = scene.units().get(name)
    return f"Still drawn with {(unit.field(value) if unit else tidy(value)).replace('-', MINUS)}."


def sentence(error: ValueError) -> str:
    """What the physics says, its numbers as they are typed: 1e300."""
    text = _MINUS.sub(MINUS, _POWER.sub(r"e\1", str(error)))
    start = text[:1] if _SYMBOL.match(text) else text[:1].upper()
    return as_on_screen(start + text[1:]) + ("" if text.endswith((".", "!", "?")) else ".")


def _unknown(name: str) -> str:
    return f"“{excerpt(name)}” is not a parameter of this scene."
