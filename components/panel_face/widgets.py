"""Widgets of a scene's controls: a slider with a text field, or a choice. Each requests changes and shows the
result."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import panel as pn

from components.language.blocks import ChoiceBlock
from components.language.controls import ChoiceRow, Setting, SliderRow
from components.language.messages import Choose, SetValues, Typed
from components.quantities.scales import slider_place, slider_value
from components.state.commands import Command

Ask = Callable[[Command], None]
MOST_BESIDE = 4  # options; more are a list


class QuantityControl:
    """A slider and a field for one quantity: text typed may be 1/3 or 36 km/h."""

    def __init__(self, row: SliderRow, ask: Ask) -> None:
        self.row, self._ask, self.place = row, ask, 0.0
        self.slider = pn.widgets.FloatSlider(label=row.label, start=0, end=1, step=0.001, show_value=False, width=150)
        says = f"{row.symbol.replace('_', '')} {row.says}"
        self.field = pn.widgets.TextInput(label=row.unit, width=90, description=says)
        self.view = pn.Row(self.slider, self.field)
        self.slider.param.watch(self._slid, "value")
        self.field.param.watch(self._typed, "value")

    def tell(self, setting: Setting) -> None:
        """Show a setting; a slider whose position already means the value does not move."""
        self.setting, self.soft = setting, setting.soft or self.row.soft
        self.field.param.update(value=setting.text, label=self.row.unit if setting.unit is None else setting.unit)
        if isinstance(setting.value, float) and self._value() != setting.value:
            self.place = self.slider.value = slider_place(self.row.scale, setting.value, self.soft)

    def _value(self) -> float:
        return slider_value(self.row.scale, float(self.slider.value or 0), self.soft)

    def _slid(self, event: Any) -> None:
        if event.new != self.place:
            self._ask(SetValues(values={self.row.name: self._value()}))

    def _typed(self, event: Any) -> None:
        if event.new != self.setting.text:
            self._ask(Typed(name=self.row.name, text=event.new))


class ChoiceControl:
    """A choice among words: joined buttons, or a list where they are many."""

    def __init__(self, row: ChoiceRow | ChoiceBlock, ask: Ask) -> None:
        kind = pn.widgets.Select if len(row.options) > MOST_BESIDE else pn.widgets.RadioButtonGroup
        self.field = kind(label=row.label, options={option.label: option.value for option in row.options})
        self.view = pn.Column(row.label, self.field)
        self.row, self._ask = row, ask
        self.field.param.watch(self._chosen, "value")

    def tell(self, setting: Setting) -> None:
        self.word = setting.value
        self.field.value = self.word

    def _chosen(self, event: Any) -> None:
        if event.new != self.word:
            self._ask(Choose(name=self.row.name, value=event.new))
