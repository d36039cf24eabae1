"""A scene as a Panel object: its controls, its figures and texts, which change each other, and a player that moves
time."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import panel as pn
from bokeh.events import RangesUpdate
from panel.viewable import Viewable, Viewer

from components.language.blocks import (
    Block,
    ChoiceBlock,
    Column,
    MeasuredBlock,
    ModesBlock,
    PlotBlock,
    Row,
    StageBlock,
    TableBlock,
    WordsBlock,
)
from components.language.controls import ActionButton, GroupSection, PresetButton, SliderRow
from components.language.messages import Act, Choose, Typed, ViewTab
from components.language.text import Html
from components.layout.controls import settings
from components.layout.sheet import blocks, in_force
from components.layout.views import shown_blocks
from components.panel_face.colours import colours
from components.panel_face.live_figure import WIDEST, LiveFigure, LiveStage, plot_under
from components.panel_face.widgets import ChoiceControl, ModeControl, QuantityControl
from components.quantities.axes import TIME_AXIS
from components.quantities.instant import instant
from components.quantities.parameters import Values
from components.quantities.refusals import SORRY, report
from components.scene import Picture
from components.scene.face import SceneFace
from components.scene.html import filled, heading, live_texts, notes, table, words
from components.scene.scene import VIEW
from components.state.commands import Command, RefusalError, asked_values, refusal
from components.state.scene_sheet import scene_sheet

NARROWEST = 280  # pixels of a text in a row; on narrower screens, texts are stacked
NO_FILES = "The page of the lecture reads files with measured points; this version shows only the model."
FRAMES = 20  # a second
MOST_FRAMES = 4000
TEXT = """
.v { font-style: italic } p { margin: 0 0 .3em } math { font-family: "Lecture Math", "STIX Two Math", math }
table { border-collapse: collapse } td { padding: 2px 10px 2px 0 }
"""
STYLE = TEXT + "".join(f".sample.{name}, .tint.{name} {{ color: {colour} }} " for name, colour in colours().items())


class FramePlayer(pn.widgets.Player):
    """A Player whose frames follow each other quickly: Panel waits 50 ms before it handles a change of a widget."""

    _debounce = 10  # ms; the browser sends two changes for each frame


class PanelFace(Viewer):
    """Panel widgets for the parameters of a scene, and Bokeh figures of its stages and plots.

    Parameters
    ----------
    scene : SceneFace
        The scene. Widgets change it, and follow every change of it.

    Attributes
    ----------
    widgets, sliders : dict of Panel widgets
        The fields and choices, and the sliders, by parameter.
    presets, actions : dict of Panel buttons
        The buttons by label, and by name.
    figures : dict of LiveFigure
        The figures of plots by name.
    stages : dict of LiveStage
        The animated drawings by name.
    seen : list of LiveStage and LiveFigure
        Those that the current view shows.
    player : FramePlayer
        The player that moves time.
    problems : dict of str
        The reason why a value was refused, by parameter; the scene is then unchanged.

    Examples
    --------
    >>> from components.scenes import SCENES
    >>> face = SCENES["damped"](m=1.0).panel()
    >>> list(face.figures)
    ['x', 'P', 'energy', 'roots']
    >>> face.widgets["m"].value = "-1"
    >>> face.problems
    {'m': '−1 kg is not possible: a mass is a finite number above 0. Still drawn with 1.00.'}
    >>> face.scene.m
    1.0
    """

    def __init__(self, scene: SceneFace) -> None:
        super().__init__()  # type: ignore[no-untyped-call]  # Panel's own has no types
        self.scene, self.sheet = scene, scene_sheet(scene.scene_kind)
        self.controls: list[QuantityControl | ChoiceControl] = []
        self.modes: list[ModeControl] = []
        self.figures: dict[str, LiveFigure] = {}
        self.stages: dict[str, LiveStage] = {}
        self.actions: dict[str, Any] = {}
        self.seen: list[LiveStage | LiveFigure] = []
        self.problems: dict[str, str] = {}
        self._texts: list[tuple[Any, Callable[[Picture], Html]]] = []
        self.parts: list[tuple[Viewable, str, tuple[str, ...]]] = []
        self.refused = pn.pane.Alert(alert_type="danger", visible=False)
        self.player = FramePlayer(  # type: ignore[no-untyped-call]  # Panel's own has no types
            label="Time", interval=1000 // FRAMES, loop_policy="loop", show_loop_controls=False,
            visible_buttons=["first", "previous", "play", "pause", "next"], sizing_mode="stretch_width", height=70,
            max_width=WIDEST,
        )  # fmt: skip
        self.player.param.watch(lambda _: self._tick(), "value")
        self._lay_out()
        self._show(scene.value.shown)
        scene.on_picture(self._show)

    def _lay_out(self) -> None:
        sheet = self.sheet
        self._stages = [block for block in blocks(sheet.paper) if isinstance(block, StageBlock)]
        self.presets = {
            one.label: self._button(one, self.scene.scene_kind.preset_all(one.label)) for one in sheet.panel.presets
        }
        groups = map(self._section, sheet.panel.groups)
        self.panel = pn.Column(self.refused, pn.FlexBox(*self.presets.values()), *groups, max_width=320)
        self.tabs = self._tabs(sheet.views)
        paper = self._block(sheet.paper)
        self.paper = pn.Column(
            f"## {sheet.headline}", self.tabs, self.player, paper, self._html(notes),
            min_width=NARROWEST, sizing_mode="stretch_width",
        )  # fmt: skip
        self._drawn: tuple[LiveStage | LiveFigure, ...] = (*self.stages.values(), *self.figures.values())
        for one in self._drawn:
            one.model.on_change("inner_width", partial(self._measured, one))
            one.model.on_event(RangesUpdate, lambda _: self._tick())
        self.widgets = {one.row.name: one.field for one in self.controls}
        self.sliders = {one.row.name: one.slider for one in self.controls if isinstance(one, QuantityControl)}

    def __panel__(self) -> Viewable:
        return pn.Row(self.panel, self.paper, sizing_mode="stretch_width")

    def _ask(self, command: Command, values: Values | None = None) -> None:
        """Set the value of a widget, or show why it is refused; then update all widgets."""
        errors, before = {}, self.scene.value
        try:
            self.scene.set(asked_values(self.scene.value, command) if values is None else values)
        except RefusalError as refused:
            errors = refused.errors
        except ValueError as error:
            errors = refusal(self.scene.value, command, error).errors
        except Exception as error:
            report(error)
            errors = {"": SORRY}
        typed = command if isinstance(command, Typed) and command.name in errors else None
        if self.scene.value is before:  # otherwise the change has updated the widgets
            self._tell(self.scene.value.shown, typed.name if typed else "")
        self._refuse(errors, typed.text if typed else "")

    def _refuse(self, errors: dict[str, str], text: str) -> None:
        """Show each sentence next to its field, or above the controls if it belongs to none."""
        self.problems = dict(errors)
        rest = dict(errors)
        for one in self.controls:
            if isinstance(one, QuantityControl) and one.row.name in rest:
                one.refuse(text or one.setting.text, rest.pop(one.row.name))
        self.refused.param.update(object=" ".join(rest.values()), visible=bool(rest))

    def _take(self, values: Values, plays: bool = False) -> None:
        """Set the values that a drag gives. If the drag starts a motion (`plays`), the time returns to 0."""
        command = Act(name="")
        self._ask(command, values)
        if plays:
            self.player.value = 0
        self._show(self.scene.value.shown)  # move the dragged shape back to its value

    def _show(self, picture: Picture) -> None:
        """Update everything after any change of the scene."""
        self._tell(picture)
        time = picture.axes.get(TIME_AXIS)
        count = min(max(round(FRAMES * time.end / picture.pace.auto), 1), MOST_FRAMES) if time else 1
        self.player.param.update(end=count, value=min(self.player.value, count), visible=bool(time and picture.signals))
        view = self.scene.value.values.get(VIEW)
        seen = {id(block) for block in shown_blocks(self.sheet.paper, view or "")}
        seen &= {id(block) for block in in_force(self.sheet.paper, picture.forms)}
        self.seen = [one for one in self._drawn if id(one.block) in seen]
        with pn.io.unlocked():  # Panel does not send these Bokeh models automatically
            for one in self.seen:
                one.show(self.scene.value, picture)
        for modes in self.modes:
            modes.show(picture)
        self._written = [(pane, write(picture)) for pane, write in self._texts]
        for part, form, views in self.parts:
            part.visible = (not form or bool(picture.forms.get(form))) and (not views or view in views)
        self._tick()

    def _measured(self, one: LiveStage | LiveFigure, attr: str, old: int, new: int) -> None:
        """Draw a figure again in the width that the browser has given it; a hidden one has none."""
        one.width = float(new or one.width)
        if new and one in self.seen:
            with pn.io.unlocked():
                one.show(self.scene.value, self.scene.value.shown)
            self._tick()

    def _tick(self) -> None:
        """Draw the player's current time: shapes, dots, and numbers that move."""
        picture = self.scene.value.shown
        time = picture.axes.get(TIME_AXIS)
        t = time.ruler.end * self.player.value / self.player.end if time else 0.0
        named = instant(picture.signals, picture.scalars, t)
        texts = live_texts(picture, named)
        with pn.io.unlocked():
            for one in self.seen:
                one.tick(picture, named, texts)
            pn.io.push_notebook(self.paper)
            for pane, html in self._written:
                pane.object = filled(html, texts)

    def _tell(self, picture: Picture, refused: str = "") -> None:
        """Show the values in all widgets, except where a value was refused: that field keeps its text."""
        scene = self.scene.value
        told = settings(scene.param.objects("existing"), scene.values, scene.units(), picture.spans)
        for one in self.controls:
            if one.row.name != refused:
                one.tell(told[one.row.name])
        if self._words:
            self.tabs.active = self._words.index(scene.values[VIEW])
        here = {scene.preset(), *scene.here()}
        for name, button in (self.presets | self.actions).items():
            button.button_type = "primary" if name in here else "default"

    def _tabs(self, views: tuple[ViewTab, ...]) -> Any:
        """Tabs that choose a view, each with its task."""
        tasks = ((one.name, pn.pane.HTML(one.task, stylesheets=[STYLE])) for one in views)
        tabs = pn.Tabs(*tasks, visible=bool(views), sizing_mode="stretch_width")

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
        pane = pn.pane.HTML(stylesheets=[STYLE])
        self._texts.append((pane, write))
        return pane

    def _standing(self, view: Viewable, form: str, views: tuple[str, ...] = ()) -> Viewable:
        self.parts += [(view, form, views)] if form or views else []
        return view

    def _block(self, block: Block) -> Viewable:
        return self._standing(self._part(block), block.form, block.views)

    def _part(self, block: Block) -> Viewable:
        """Return a part of the sheet. Figures are one below the other, as wide as the page; texts may be next to each
        other."""
        match block:
            case Row(blocks=inside) if not any(isinstance(one, StageBlock | PlotBlock) for one in blocks(block)):
                views = [self._block(part) for part in inside]
                for view in views:
                    view.styles = {"flex": f"1 1 {NARROWEST}px", "min-width": "0"}
                return pn.FlexBox(*views, sizing_mode="stretch_width")
            case Row(blocks=inside) | Column(blocks=inside):
                return pn.Column(*map(self._block, inside), sizing_mode="stretch_width")
            case StageBlock(part=name):
                self.stages[name] = LiveStage(block, self._take)
                return pn.Column(self.stages[name].model, sizing_mode="stretch_width")
            case PlotBlock(name=name, heading=terms, brief=brief):
                over = (shape for stage in self._stages for shape in stage.shapes if plot_under(shape) == name)
                figure = self.figures[name] = LiveFigure(block, (*block.shapes, *over), self._take)
                head = self._html(lambda picture: heading(terms, picture.forms) or brief)
                return pn.Column(head, figure.model, sizing_mode="stretch_width")
            case WordsBlock():
                return self._html(lambda picture: words(block, picture.forms))
            case TableBlock():
                return self._html(lambda picture: table(block, picture.forms))
            case ModesBlock():
                self.modes.append(ModeControl(block, self._take))
                return pn.Column(self.modes[-1].field)
            case ChoiceBlock():
                return self._control(block)
            case MeasuredBlock(shows="file"):
                return pn.pane.HTML(NO_FILES)
        return pn.Column(visible=False)
