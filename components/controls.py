"""The control panel as data for the browser, and what its messages do to a scene."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import param

from components.choices import chosen, options, word
from components.equations import rich
from components.numbers import MINUS, exact, excerpt, parse_number, tidy
from components.parameters import Quantity
from components.stage import Shape

if TYPE_CHECKING:
    from components.scene import Scene

Errors = dict[str, str]
Choice = (param.Selector, param.Boolean)
_POWER = re.compile(r"(?<=\d)e(?:\+|(-))0*(?=\d)")


@dataclass(frozen=True)
class Group:
    """Parameters that belong together, under a title; the hint names another way to set them.

    Without a title they go on with the group before.

    `actions` are buttons, (name, label): the scene's `action(name)` says what they set. A `folded` group opens when
    asked for, or when one of its values is not the default. `show` is the form by which a group stands. `pictures`
    makes a choice one of pictures: the shapes of a stage for each value. `facts` are rows of cells, texts for `rich`,
    under the controls. While a `dense` group stands the panel has less room between its groups.
    """

    title: str
    names: tuple[str, ...]
    hint: str = ""
    actions: tuple[tuple[str, str], ...] = ()
    folded: bool = False
    show: str = ""
    pictures: Mapping[str, list[Shape]] = field(default_factory=dict)
    facts: tuple[tuple[str, ...], ...] = ()
    dense: bool = False


def controls_spec(
    scene_class: type[Scene],
    groups: tuple[Group, ...],
    presets: Mapping[str, Mapping[str, Any]],
    drawings: Mapping[str, str] | None = None,
) -> dict[str, Any]:
    """All that the browser needs to build the panel of a scene; `drawings` are the outlines of presets by label."""
    return {
        "start": scene_class.start,
        "presets": list(presets),
        "drawings": dict(drawings or {}),
        "groups": [
            {
                "title": group.title,
                "hint": group.hint,
                "rows": [control(name, scene_class.param[name]) for name in group.names],
                "actions": [
                    {"name": name, "label": label, "place": name in scene_class.places} for name, label in group.actions
                ],
                "folded": group.folded,
                "show": group.show,
                "dense": group.dense,
                "pictures": dict(group.pictures),
                "facts": [[rich(cell) for cell in cells] for cells in group.facts],
            }
            for group in groups
        ],
    }


def control(name: str, parameter: param.Parameter) -> dict[str, Any]:
    """A slider with a field for a quantity, joined buttons for anything else."""
    return row(name, parameter) if isinstance(parameter, Quantity) else choice(name, parameter)


def row(name: str, quantity: Quantity) -> dict[str, Any]:
    """The description of one slider with its field."""
    parts = (quantity.symbol.replace("_", ""), quantity.label, quantity.unit)
    marks = {"marks": [{"value": value, "text": text} for value, text in quantity.marks]} if quantity.marks else {}
    return {
        "name": name,
        "symbol": quantity.symbol,
        "unit": quantity.unit,
        "tint": quantity.tint,
        "scale": quantity.scale,
        "soft": list(quantity.softbounds),
        "says": quantity.says,
        "label": ", ".join(part for part in parts if part),
        **marks,
    }


def choice(name: str, parameter: param.Parameter) -> dict[str, Any]:
    """The description of one choice, shown as joined buttons."""
    labels = parameter.names if isinstance(parameter, param.Selector) else None
    by_word = {word(value): label for label, value in labels.items()} if labels else {}
    return {
        "name": name,
        "label": parameter.label,
        "options": [{"value": value, "label": by_word.get(value, value)} for value in options(parameter)],
    }


def params_state(scene: Scene) -> dict[str, dict[str, Any]]:
    """What the controls show now; "soft" is there where the scene has moved a slider's range, "unit" where the
    quantity is shown in another unit than its own, of which one is "size"."""
    state: dict[str, dict[str, Any]] = {}
    units, general = scene.units(), type(scene).param.objects("existing")
    for name, parameter in scene.param.objects("existing").items():
        value = getattr(scene, name)
        if isinstance(parameter, Quantity):
            text = "" if value is None else exact(value) if parameter.scale == "count" else tidy(value)
            state[name] = {"value": value, "text": text}
            if name in units and value is not None:
                unit = units[name]
                state[name] = {"value": value, "text": unit.field(value), "unit": unit.text, "size": unit.size}
            if value != parameter.default:
                state[name]["changed"] = True
            if parameter.softbounds != general[name].softbounds:
                state[name]["soft"] = list(parameter.softbounds)
        elif isinstance(parameter, Choice) and not isinstance(parameter, param.ListSelector):
            state[name] = {"value": word(value), "text": word(value)}
    return state


def apply_message(scene: Scene, message: Mapping[str, Any]) -> Errors:
    """Do what a message of the page asks, in one batch; where that is refused, say why, by parameter.

    A refused message changes nothing. A preset is refused under the name "preset", a message that says
    nothing known under "message".
    """
    match message:
        case {"type": "set", "values": dict() as values} if _named(scene, values):
            return _set(scene, values)
        case {"type": "typed", "name": str() as name, "text": str() as text}:
            return _type(scene, name, text)
        case {"type": "preset", "label": str() as label}:
            return _take_preset(scene, label)
        case {"type": "act", "name": str() as name}:
            return _act(scene, name)
        case {"type": "choose", "name": str() as name, "value": value}:
            return _choose(scene, name, value)
    return {"message": f"“{excerpt(str(message))}” is not a message that this page sends."}


def _named(scene: Scene, values: dict[object, object]) -> bool:
    """Whether these may be values by name: no more than the scene has parameters."""
    return len(values) <= len(list(scene.param)) and all(isinstance(name, str) for name in values)


def _set(scene: Scene, values: dict[str, object]) -> Errors:
    errors = {excerpt(name): _problem(scene, name, value) for name, value in values.items()}
    found = {name: error for name, error in errors.items() if error}
    return found or _try(scene, values)


def _type(scene: Scene, name: str, text: str) -> Errors:
    quantity = _quantity(scene, name)
    if quantity is None:
        return {excerpt(name): _unknown(name)}
    try:
        value = None if quantity.allow_None and not text.strip() else parse_number(text)
    except ValueError as error:
        return {name: f"{error} {_still(scene, name)}"}
    unit = scene.units().get(name)
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
        return {name: str(error)}
    return {}


def _act(scene: Scene, name: str) -> Errors:
    known = [action for group in scene.groups for action, _ in group.actions]
    if name not in known:
        return {"action": f"“{excerpt(name)}” is not an action of this scene."}
    try:
        scene.set(scene.action(name))
    except ValueError as error:
        return {"action": f"{_sentence(error)} Still drawn as before."}
    return {}


def _take_preset(scene: Scene, label: str) -> Errors:
    if label not in scene.presets:
        return {"preset": f"“{excerpt(label)}” is not a preset: choose one of {', '.join(scene.presets)}."}
    try:
        scene.set({name: scene.preset_value(label, name) for name in scene.preset_names()})
    except ValueError as error:
        return {"preset": f"{_sentence(error)} Still drawn as before."}
    return {}


def _try(scene: Scene, values: dict[str, Any]) -> Errors:
    """Set quantities that are possible one by one; the physics may still refuse them together."""
    still = {name: _still(scene, name) for name in values}
    try:
        scene.set(values)
    except ValueError as error:
        return {name: f"{_sentence(error)} {still[name]}" for name in values}
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


def _parameter(scene: Scene, name: str) -> param.Parameter | None:
    return scene.param[name] if name in scene.param else None  # noqa: SIM401 (not a dict)


def _still(scene: Scene, name: str) -> str:
    value = getattr(scene, name)
    if value is None:
        return "Still drawn as before."
    unit = scene.units().get(name)
    return f"Still drawn with {(unit.field(value) if unit else tidy(value)).replace('-', MINUS)}."


def _sentence(error: ValueError) -> str:
    """What the physics says, its numbers as they are typed: 1e300."""
    text = _POWER.sub(r"e\1", str(error))
    return text[:1].upper() + text[1:] + ("" if text.endswith((".", "!", "?")) else ".")


def _unknown(name: str) -> str:
    return f"“{excerpt(name)}” is not a parameter of this scene."
