"""The control panel: the controls of a scene and their values."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import param
from msgspec.structs import replace

from components.language.controls import (
    ActionButton,
    ChoiceRow,
    ControlRow,
    GroupSection,
    NamedValue,
    Panel,
    PresetButton,
    Setting,
    SliderRow,
)
from components.language.expressions import Name, called
from components.language.shapes import AnyShape
from components.layout.choices import labelled, stated, word
from components.layout.text import rich
from components.quantities.formatting import MINUS, shortest, tidy
from components.quantities.parameters import AnyParameter, Quantity, Values, names_of
from components.quantities.units import Unit

Choice = (param.Selector, param.Boolean)
Pictures = Mapping[str, list[AnyShape]]


@dataclass(frozen=True)
class Group:
    """Parameters under a title in the control panel.

    `title`     the title; a group with an empty title continues the one before
    `hint`      a text that names another way to set them; in a folded group without title, the button that opens it
    `actions`   buttons, (name, label); the scene's `action(name)` returns the values that they set
    `folded`    True if the group is closed until the visitor opens it or one of its values is not the default
    `form`      the group is visible while the picture has this form
    `pictures`  small pictures for the values of a choice: the shapes of a stage for each value
    `facts`     rows of cells under the controls, texts for `rich`
    `dense`     True if the panel has smaller gaps while the group is visible
    `idle_when_hidden`  True if its values have an effect only while its form is visible
    """

    title: str
    parameters: tuple[AnyParameter, ...]
    hint: str = ""
    actions: tuple[tuple[str, str], ...] = ()
    folded: bool = False
    form: Name | None = None
    pictures: Pictures = field(default_factory=dict)
    facts: tuple[tuple[str, ...], ...] = ()
    dense: bool = False
    idle_when_hidden: bool = False

    @property
    def names(self) -> list[str]:
        return names_of(self.parameters)

    def is_shown(self, forms: Mapping[str, str]) -> bool:
        return self.form is None or bool(forms.get(self.form.name))


def panel(
    parameters: Mapping[str, AnyParameter],
    groups: tuple[Group, ...],
    *,
    start: str = "Start from",
    folded: bool = False,
    presets: Mapping[str, Values] | None = None,
    drawings: Mapping[str, str] | None = None,
    watch: Mapping[str, str] | None = None,
    places: Iterable[str] = (),
) -> Panel:
    """Return the panel of a scene.

    `drawings` are outlines of presets by label, `watch` the sentences of presets on what to watch, `places` the actions
    whose buttons are marked while the scene has their values.
    """
    return Panel(
        start=start,
        folded=folded,
        presets=tuple(_preset_buttons(parameters, presets or {}, drawings or {}, watch or {})),
        groups=tuple(_section(group, frozenset(places)) for group in groups),
    )


def _preset_buttons(
    parameters: Mapping[str, AnyParameter],
    presets: Mapping[str, Values],
    outlines: Mapping[str, str],
    watch: Mapping[str, str],
) -> Iterator[PresetButton]:
    defaults = {name: parameters[name].default for values in presets.values() for name in values}
    for label, values in presets.items():
        sets = {name: stated(value) for name, value in {**defaults, **values}.items()}
        yield PresetButton(preset_name(label), label, sets, outlines.get(label, ""), watch.get(label, ""))


def preset_name(label: str) -> str:
    """Return the name of a preset in messages, which does not depend on its label on the page."""
    return "-".join(re.findall(r"\w+", label.lower()))


def _section(group: Group, places: frozenset[str]) -> GroupSection:
    return GroupSection(
        title=group.title,
        hint=group.hint,
        rows=tuple(control(one, group.pictures) for one in group.parameters),
        actions=tuple(ActionButton(name, label, name in places) for name, label in group.actions),
        folded=group.folded,
        form=called(group.form),
        dense=group.dense,
        facts=tuple(tuple(map(rich, cells)) for cells in group.facts),
    )


def control(parameter: AnyParameter, pictures: Pictures | None = None) -> ControlRow:
    """Return the control of a parameter: a slider with a field for a quantity, else buttons or small pictures."""
    return _slider(parameter) if isinstance(parameter, Quantity) else _choice(parameter, pictures or {})


def _slider(quantity: Quantity) -> SliderRow:
    parts = (quantity.symbol.replace("_", ""), quantity.label)
    return SliderRow(
        name=quantity.name or "",
        symbol=quantity.symbol,
        unit=quantity.unit,
        tint=quantity.tint,
        scale=quantity.scale,
        soft=quantity.softbounds,
        says=quantity.says,
        label=", ".join(part for part in parts if part),
        marks=tuple(NamedValue(value, text) for value, text in quantity.marks),
    )


def _choice(parameter: AnyParameter, pictures: Pictures) -> ChoiceRow:
    options = labelled(parameter)
    return ChoiceRow(
        name=parameter.name or "",
        label=parameter.label or "",
        options=options,
        pictures={one.value: tuple(pictures[one.value]) for one in options if one.value in pictures},
    )


def settings(
    parameters: Mapping[str, AnyParameter],
    values: Mapping[str, Any],
    units: Mapping[str, Unit],
    spans: Mapping[str, tuple[float, float]],
) -> dict[str, Setting]:
    """Return the settings of all controls for these values.

    `units` replace the units of some quantities, `spans` the ends of some sliders.
    """
    found: dict[str, Setting] = {}
    for name, parameter in parameters.items():
        value = values.get(name)
        if isinstance(parameter, Quantity):
            found[name] = _setting(parameter, value, units.get(name), spans.get(name))
        elif isinstance(parameter, Choice) and not isinstance(parameter, param.ListSelector):
            found[name] = Setting(value=word(value), text=word(value), changed=value != parameter.default)
    return found


@lru_cache(2000)
def _setting(quantity: Quantity, value: float | None, unit: Unit | None, span: tuple[float, float] | None) -> Setting:
    """Return the setting of one control. Cached, because most controls are the same after a change."""
    text = "" if value is None else shortest(value) if quantity.scale == "count" else tidy(value)
    own = Setting(value=value, text=text.replace("-", MINUS), soft=span, changed=value != quantity.default)
    if unit is None or value is None:
        return own
    return replace(own, text=unit.field(value).replace("-", MINUS), unit=unit.text, size=unit.size)
