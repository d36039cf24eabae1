"""A scene as a Panel object: its controls and its paper, which follow each other."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import panel as pn
from panel.viewable import Viewable, Viewer

from components.language.blocks import (
    Block,
    ChoiceBlock,
    Column,
    MeasuredBlock,
    PlotBlock,
    Row,
    StageBlock,
    TableBlock,
    WordsBlock,
)
from components.language.controls import ActionButton, GroupSection, PresetButton, SliderRow
from components.language.messages import Act, Choose, ViewTab
from components.language.text import Html
from components.layout.controls import settings
from components.panel_face.live_figure import LiveFigure, colours
from components.panel_face.widgets import ChoiceControl, QuantityControl
from components.quantities.parameters import Values
from components.quantities.refusals import SORRY, report
from components.scene import Picture
from components.scene.face import SceneFace
from components.scene.html import filled, heading, notes, table, words
from components.scene.scene import VIEW
from components.state.commands import Command, RefusalError, asked_values, refusal
from components.state.scene_sheet import scene_sheet

NARROWEST = 280  # pixels of a part of a row; on narrower screens, parts are stacked
NO_FILES = "The page of the lecture reads files with measured points; this version shows only the model."
STYLE = "".join(f".sample.{name}, .tint.{name} {{ color: {colour} }} " for name, colour in colours().items())


class PanelFace(Viewer):
    """Panel widgets for the parameters of a scene, and Bokeh figures of its plots.

    `widgets` has the fields and choices and `sliders` the sliders by parameter, `presets` and `actions` the buttons by
    name, `figures` the figures by plot; `refused` says why a value was rejected; the scene is then unchanged.
    """

    def __init__(self, scene: SceneFace) -> None:
        super().__init__()  # type: ignore[no-untyped-call]  # Panel's own has no types
        self.scene, sheet = scene, scene_sheet(scene.scene_kind)
        self.controls: list[QuantityControl | ChoiceControl] = []
        self.figures: dict[str, LiveFigure] = {}
        self.actions: dict[str, Any] = {}
        self._texts: list[tuple[Any, Callable[[Picture], Html]]] = []
        self.parts: list[tuple[Viewable, str, tuple[str, ...]]] = []
        self.refused = pn.pane.Alert(alert_type="danger", visible=False)
        self.presets = {
            one.label: self._button(one, scene.scene_kind.preset_all(one.label)) for one in sheet.panel.presets
        }
        groups = map(self._section, sheet.panel.groups)
        self.panel = pn.Column(self.refused, pn.FlexBox(*self.presets.values()), *groups, max_width=320)
        self.tabs = self._tabs(sheet.views)
        paper = self._block(sheet.paper)
        self.paper = pn.Column(f"## {sheet.headline}", self.tabs, paper, self._html(notes), min_width=NARROWEST)
        self.widgets = {one.row.name: one.field for one in self.controls}
        self.sliders = {one.row.name: one.slider for one in self.controls if isinstance(one, QuantityControl)}
        self._show(scene.value.shown)
        scene.on_picture(self._show)

    def __panel__(self) -> Viewable:
        return pn.Row(self.panel, self.paper)

    def _ask(self, command: Command, values: Values | None = None) -> None:
        """Set the value of a widget, or show why it is rejected; then update all widgets."""
        errors = {}
        try:
            self.scene.set(asked_values(self.scene.value, command) if values is None else values)
        except RefusalError as refused:
            errors = refused.errors
        except ValueError as error:
            errors = refusal(self.scene.value, command, error).errors
        except Exception as error:
            report(error)
            errors = {"": SORRY}
        self.refused.param.update(object=" ".join(errors.values()), visible=bool(errors))
        self._tell(self.scene.value.shown)

    def _show(self, picture: Picture) -> None:
        """Update everything after any change of the scene."""
        self._tell(picture)
        with pn.io.unlocked():  # Panel does not send these Bokeh models automatically
            for figure in self.figures.values():
                figure.show(self.scene.value, picture)
        pn.io.push_notebook(self.paper)
        for pane, write in self._texts:
            pane.object = filled(write(picture), picture)
        view = self.scene.value.values.get(VIEW)
        for part, form, views in self.parts:
            part.visible = (not form or bool(picture.forms.get(form))) and (not views or view in views)

    def _tell(self, picture: Picture) -> None:
        scene = self.scene.value
        told = settings(scene.param.objects("existing"), scene.values, scene.units(), picture.spans)
        for one in self.controls:
            one.tell(told[one.row.name])
        if self._words:
            self.tabs.active = self._words.index(scene.values[VIEW])
        here = {scene.preset(), *scene.here()}
        for name, button in (self.presets | self.actions).items():
            button.button_type = "primary" if name in here else "default"

    def _tabs(self, views: tuple[ViewTab, ...]) -> Any:
        """Tabs that choose a view, each with its task."""
        tabs = pn.Tabs(*((one.name, pn.pane.HTML(one.task)) for one in views), visible=bool(views))

        def choose(event: Any) -> None:
            self._ask(Choose(name=VIEW, value=views[event.new].word))

        tabs.param.watch(choose, "active")
        self._words = [one.word for one in views]
        return tabs

    def _button(self, does: PresetButton | ActionButton, values: Values | None = None) -> Any:
        button = pn.widgets.Button(label=does.label)
        button.on_click(lambda _: self._ask(Act(name=does.name), values))
        return button

    def _section(self, group: GroupSection) -> Viewable:
        facts = self._html(lambda _: "".join(f"<p>{' '.join(cells)}</p>" for cells in group.facts))
        self.actions |= (buttons := {one.name: self._button(one) for one in group.actions})
        inside = [*map(self._control, group.rows), facts, pn.FlexBox(*buttons.values())]
        if group.folded:
            return self._standing(pn.Card(*inside, title=group.hint or group.title, collapsed=True), group.form)
        return self._standing(pn.Column(f"**{group.title}**" if group.title else None, *inside), group.form)

    def _control(self, row: Any) -> Viewable:
        kind = QuantityControl if isinstance(row, SliderRow) else ChoiceControl
        self.controls.append(kind(row, self._ask))
        return self.controls[-1].view

    def _html(self, write: Callable[[Picture], Html]) -> Viewable:
        pane = pn.pane.HTML(stylesheets=[STYLE, ".v { font-style: italic } p { margin: 0 }"])
        self._texts.append((pane, write))
        return pane

    def _standing(self, view: Viewable, form: str, views: tuple[str, ...] = ()) -> Viewable:
        self.parts += [(view, form, views)] if form or views else []
        return view

    def _block(self, block: Block) -> Viewable:
        return self._standing(self._part(block), block.form, block.views)

    def _part(self, block: Block) -> Viewable:
        """A part of the paper; nothing for the stage, which only the lecture moves."""
        match block:
            case Row(blocks=blocks):
                parts = [(self._block(part), part) for part in blocks if not isinstance(part, StageBlock)]
                for view, part in parts:
                    view.styles = {"flex": f"{max(part.grow, 1):g} 1 {part.basis or NARROWEST}px", "min-width": "0"}
                return pn.FlexBox(*(view for view, _ in parts), sizing_mode="stretch_width")
            case Column(blocks=blocks):
                return pn.Column(*map(self._block, blocks), sizing_mode="stretch_width")
            case PlotBlock(name=name, heading=terms, brief=brief):
                figure = self.figures[name] = LiveFigure(block)
                head = self._html(lambda picture: heading(terms, picture.forms) or brief)
                return pn.Column(head, figure.model, sizing_mode="stretch_width")
            case WordsBlock():
                return self._html(lambda picture: words(block, picture.forms))
            case TableBlock():
                return self._html(lambda picture: table(block, picture.forms))
            case ChoiceBlock():
                return self._control(block)
            case MeasuredBlock(shows="file"):
                return pn.pane.HTML(NO_FILES)
        return pn.Column(visible=False)
