"""The subject of a step's question: the scene with its plots, their axes, and the true curves."""

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
from components.walks.links import Scenes, elsewhere, name_in_state, opening_state, page_state_at
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
        """Return the points of a sketched curve, without its gaps."""
        heights = ((i / (HEIGHTS - 1), height / 1000) for i, height in enumerate(drawn) if height is not None)
        return [(_within(self.x, across), _within(self.y, up)) for across, up in heights]


def _within(axis: Axis, share: float) -> float:
    """Return the number at a position on an axis, given as a share of its length."""
    start, end = axis.place(axis.start), axis.place(axis.end)
    return number_at(axis, start + share * (end - start))


def number_at(axis: Axis, place: float) -> float:
    """Return the number at a coordinate, in the unit of the axis without its power of ten."""
    return float(10.0**place if axis.log else place * 10.0**axis.exponent)


def place_of(axis: Axis, number: float) -> float:
    """Return the coordinate of a number on its axis."""
    return float(np.log10(number) if axis.log else number * 10.0**-axis.exponent)


class Subject:
    """The scene of a step's question, created when it is first needed, and what questions look up in it."""

    def __init__(self, walk: str, step: BaseStep, scenes: Scenes, seed: int = 0) -> None:
        self._name, self._step, self.scenes = name_in_state(walk, step, seed), step, scenes
        self.pad, self.true = cache(self._pad), cache(self._true)

    @cached_property
    def page_state(self) -> PageState:
        """The page with the question. Raises ValueError, with a reason, for a link that opens none."""
        return page_state_at(self._step.state, self.scenes)

    @cached_property
    def answered(self) -> PageState:
        """The page with the answer."""
        return page_state_at(self._step.shown, self.scenes)

    @cached_property
    def numbers_asked(self) -> Mapping[str, float]:
        """The numbers of the scene in the question, by name."""
        return numbers_of(self.page_state.scene)

    @cached_property
    def numbers(self) -> Mapping[str, float]:
        """The numbers of the scene with the answer, by name."""
        return numbers_of(self.answered.scene)

    @property
    def opening(self) -> State:
        """The state with the question."""
        return opening_state(self._name, self._step, self.scenes)

    @property
    def answer(self) -> State:
        """The state with the answer."""
        return self.elsewhere(self._step.shown)

    def elsewhere(self, link: str) -> State:
        """Return the state of another link of the step."""
        return elsewhere(self._name, self._step, link, self.scenes)

    def axes(self, plot: str) -> PlotAxes:
        """Return a plot of the scene. Raises ValueError if there is none of this name."""
        block, axes = self._block(plot), self.page_state.shown.axes
        return PlotAxes(axes[block.x], axes[block.y])

    def drawn(self, plot: str, curves: Mapping[str, Sketched], names: tuple[str, ...]) -> dict[str, Sketch]:
        """Return the sketched curves. If there are two, each refers to the other."""
        return self._known(plot, {name: self.pad(plot).numbers(curves.get(name, [])) for name in names})

    def _pad(self, plot: str) -> PlotAxes:
        """Return the empty axes on which a sketch is drawn, over the ranges that the covers of the step leave. They are
        the same for a whole class, even if screens show other ranges."""
        block = self._block(plot)
        axes = without(self.page_state.kind, self.page_state.shown, self._step.cover)[0].axes
        return PlotAxes(axes[block.x], axes[block.y])

    def _true(self, plot: str, names: tuple[str, ...]) -> dict[str, Sketch]:
        """Return the true curves. Raises ValueError for a curve that the plot does not have."""
        return self._known(plot, {name: self._points(plot, name) for name in names})

    def _known(self, plot: str, points: Mapping[str, Traced]) -> dict[str, Sketch]:
        frame = self.axes(plot).frame
        alone = {name: sketch(curve, frame) for name, curve in points.items()}
        return {
            name: sketch(points[name], frame, *(alone[other] for other in alone if other != name)) for name in alone
        }

    def _block(self, plot: str) -> PlotBlock:
        """A plot whose axes the current picture has."""
        for block in plots(self.page_state.kind):
            if block.name == plot and {block.x, block.y} <= self.page_state.shown.axes.keys():
                return block
        raise ValueError(f"the scene shows no plot “{plot}”")

    def _points(self, plot: str, name: str) -> Traced:
        """Return a drawn curve with all its pieces joined. A curve over time includes its exact turning points, which
        are between drawn points."""
        block, shown, axes = self._block(plot), self.page_state.shown, self.axes(plot)
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
