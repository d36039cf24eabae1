"""Widgets of a scene's controls: a slider with a field for any value, or a choice. Each requests changes and shows the
result."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import panel as pn

from components.language.blocks import ChoiceBlock, ModesBlock
from components.language.controls import ChoiceRow, Setting, SliderRow
from components.language.messages import Choose, SetValues, Typed
from components.language.signals import Modal
from components.quantities.parameters import Values
from components.quantities.scales import slider_place, slider_value
from components.scene import Picture
from components.state.commands import Command

Ask = Callable[[Command], None]
MOST_BESIDE = 4  # options; more are a list


class QuantityControl:
    """A field for one quantity and a slider.

    You can type 1/3 or 36 km/h. A refused text stays in the field, with the reason below.
    """

    def __init__(self, row: SliderRow, ask: Ask) -> None:
        self.row, self._ask, self.place, self.label = row, ask, 0.0, row.label
        says = f"{row.symbol.replace('_', '')} {row.says}"
        self.field = pn.widgets.TextInput(label=row.label, description=says, sizing_mode="stretch_width")
        self.slider = pn.widgets.FloatSlider(
            label=row.label, start=0, end=1, step=0.001, show_value=False, sizing_mode="stretch_width",
            stylesheets=[".bk-slider-title { display: none }"],
        )  # fmt: skip
        self.problem = pn.pane.Alert(alert_type="danger", visible=False, margin=(0, 10))
        self.view = pn.Column(self.field, self.slider, self.problem, sizing_mode="stretch_width")
        self.slider.param.watch(self._slid, "value")
        self.field.param.watch(self._typed, "value")

    def tell(self, setting: Setting) -> None:
        """Show a setting; a slider whose position already means the value does not move."""
        self.setting, self.soft = setting, setting.soft or self.row.soft
        unit = self.row.unit if setting.unit is None else setting.unit
        label = f"{self.row.label} [{unit}]" if unit else self.row.label
        self.field.param.update(value=setting.text, label=label)
        self.problem.visible = False
        if isinstance(setting.value, float) and self._value() != setting.value:
            self.place = self.slider.value = slider_place(self.row.scale, setting.value, self.soft)

    def refuse(self, text: str, sentence: str) -> None:
        """Leave a refused text in its field, and say why."""
        self.setting = Setting(value=self.setting.value, text=text, unit=self.setting.unit, soft=self.setting.soft)
        self.field.value = text
        self.problem.param.update(object=f"{self.row.label}: {sentence}", visible=True)

    def _value(self) -> float:
        return slider_value(self.row.scale, float(self.slider.value or 0), self.soft)

    def _slid(self, event: Any) -> None:
        if event.new != self.place:
            self._ask(SetValues(values={self.row.name: self._value()}))

    def _typed(self, event: Any) -> None:
        if event.new != self.setting.text:
            self._ask(Typed(name=self.row.name, text=event.new))


class ChoiceControl:
    """A choice between words: joined buttons, or a list if there are many."""

    def __init__(self, row: ChoiceRow | ChoiceBlock, ask: Ask) -> None:
        kind = pn.widgets.Select if len(row.options) > MOST_BESIDE else pn.widgets.RadioButtonGroup
        self.field = kind(label=row.label, options={option.label: option.value for option in row.options})
        self.view = pn.Column(row.label, self.field) if kind is pn.widgets.RadioButtonGroup else self.field
        self.row, self._ask = row, ask
        self.field.param.watch(self._chosen, "value")

    def tell(self, setting: Setting) -> None:
        """Show a setting."""
        self.word = setting.value
        self.field.value = self.word

    def _chosen(self, event: Any) -> None:
        if event.new != self.word:
            self._ask(Choose(name=self.row.name, value=event.new))


class ModeControl:
    """A list of the modes of a chain; the chosen one starts alone."""

    def __init__(self, block: ModesBlock, take: Callable[[Values], None]) -> None:
        self.block, self._take = block, take
        self.field = pn.widgets.Select(label=block.label, width=200)
        self.field.param.watch(self._chosen, "value")

    def show(self, picture: Picture) -> None:
        """List the modes of the chain in a picture, and choose the one that is started alone."""
        signal, alone = picture.signals.get(self.block.of), picture.values.get(self.block.chosen, "")
        count = len(signal.omega) if isinstance(signal, Modal) else 0
        self.mode = int(alone) if alone.isdigit() else 0
        options = {"more than one": 0} | {f"mode {j}": j for j in range(1, count + 1)}
        self.field.param.update(options=options, value=self.mode)

    def _chosen(self, event: Any) -> None:
        if event.new and event.new != self.mode:
            self._take({**self.block.sets, self.block.name: event.new})
