"""The subject of a step's question, found in its scene: plots, their axes, and the curves that are true of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np

from components.language.blocks import PlotBlock
from components.language.messages import HEIGHTS, Sketched
from components.language.state import State
from components.quantities.axes import Axis
from components.state.covers import without
from components.state.page_state import PageState
from components.state.scene_sheet import plots
from components.walks.expressions import numbers_of
from components.walks.links import Scenes, elsewhere, name_in_state, opening_state, standing_at
from components.walks.sketch import Ranges, Sketch, sketch, turns
from components.walks.types import BaseStep

Traced = list[tuple[float, float]]


@dataclass(frozen=True)
class PlotAxes:
    """The axes of a plot, to convert coordinates to the numbers at them."""

    x: Axis
    y: Axis

    @property
    def frame(self) -> Ranges:
        return Ranges((_within(self.x, 0), _within(self.x, 1)), (_within(self.y, 0), _within(self.y, 1)))

    def numbers(self, drawn: Sketched) -> Traced:
        """The points of a curve that is drawn in this frame, its gaps left out."""
        heights = ((i / (HEIGHTS - 1), height / 1000) for i, height in enumerate(drawn) if height is not None)
        return [(_within(self.x, across), _within(self.y, up)) for across, up in heights]


def _within(axis: Axis, share: float) -> float:
    """The number at a share of the length of an axis."""
    start, end = axis.place(axis.start), axis.place(axis.end)
    return number_at(axis, start + share * (end - start))


def number_at(axis: Axis, place: float) -> float:
    """The number of a place, in the unit written at the axis without its power of ten."""
    return float(10.0**place if axis.log else place * 10.0**axis.exponent)


def place_of(axis: Axis, number: float) -> float:
    """The place of a number on its axis."""
    return float(np.log10(number) if axis.log else number * 10.0**-axis.exponent)


class Subject:
    """The scene that a step's question is about, made when it is first asked for, with what questions find in it."""

    def __init__(self, walk: str, step: BaseStep, scenes: Scenes, seed: int = 0) -> None:
        self._name, self._step, self.scenes = name_in_state(walk, step, seed), step, scenes
        self.pad, self.true = cache(self._pad), cache(self._true)

    @cached_property
    def standing(self) -> PageState:
        """The page that the question is asked on; ValueError, in words, for a link that opens none."""
        return standing_at(self._step.state, self.scenes)

    @cached_property
    def answered(self) -> PageState:
        """The page that is shown with the answer."""
        return standing_at(self._step.shown, self.scenes)

    @cached_property
    def numbers_asked(self) -> Mapping[str, float]:
        """The numbers of the scene that the question is asked of, by name."""
        return numbers_of(self.standing.scene)

    @cached_property
    def numbers(self) -> Mapping[str, float]:
        """The numbers of the scene that is shown with the answer, by name."""
        return numbers_of(self.answered.scene)

    @property
    def opening(self) -> State:
        """The state that the question is asked of."""
        return opening_state(self._name, self._step, self.scenes)

    @property
    def answer(self) -> State:
        """The state that is shown with the answer."""
        return self.elsewhere(self._step.shown)

    def elsewhere(self, link: str) -> State:
        """The state of another link, at which the page stays in the step."""
        return elsewhere(self._name, self._step, link, self.scenes)

    def axes(self, plot: str) -> PlotAxes:
        """ValueError where the scene shows no such plot."""
        block, axes = self._block(plot), self.standing.shown.axes
        return PlotAxes(axes[block.x], axes[block.y])

    def drawn(self, plot: str, curves: Mapping[str, Sketched], names: tuple[str, ...]) -> dict[str, Sketch]:
        """Sketched curves, of which two know each other."""
        return self._known(plot, {name: self.pad(plot).numbers(curves.get(name, [])) for name in names})

    def _pad(self, plot: str) -> PlotAxes:
        """The empty axes that a sketch is drawn on, over the ranges that the step's covers leave them: the frame that
        a class shares, whatever a screen shows."""
        block = self._block(plot)
        axes = without(self.standing.kind, self.standing.shown, self._step.cover)[0].axes
        return PlotAxes(axes[block.x], axes[block.y])

    def _true(self, plot: str, names: tuple[str, ...]) -> dict[str, Sketch]:
        """The scene's own curves; ValueError for one that the plot does not have."""
        return self._known(plot, {name: self._points(plot, name) for name in names})

    def _known(self, plot: str, points: Mapping[str, Traced]) -> dict[str, Sketch]:
        frame = self.axes(plot).frame
        alone = {name: sketch(curve, frame) for name, curve in points.items()}
        return {
            name: sketch(points[name], frame, *(alone[other] for other in alone if other != name)) for name in alone
        }

    def _block(self, plot: str) -> PlotBlock:
        """A plot of the scene that has its axes now."""
        for block in plots(self.standing.kind):
            if block.name == plot and {block.x, block.y} <= self.standing.shown.axes.keys():
                return block
        raise ValueError(f"the scene shows no plot “{plot}”")

    def _points(self, plot: str, name: str) -> Traced:
        """Return a drawn curve, all its pieces joined; over time with its exact turning points, which are between the
        drawn points."""
        block, shown, axes = self._block(plot), self.standing.shown, self.axes(plot)
        places: Traced = []
        for curve in block.curves:
            columns = shown.sources.get(curve.source, {})
            if curve.y == name and name in columns:
                across, up = axes.x.places(columns[curve.x]), axes.y.places(columns[name])
                places += zip(across.tolist(), up.tolist(), strict=True)
                if block.time:
                    places += turns(across, up)
        if not places:
            raise ValueError(f"the plot “{plot}” draws no curve “{name}”")
        return [(number_at(axes.x, x), number_at(axes.y, y)) for x, y in places]
