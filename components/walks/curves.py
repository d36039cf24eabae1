"""What a step asks about, found in its scene: the plot, its axes, and the true curves of a sketch."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline

from components.axes import Axis
from components.covers import without
from components.description import plots
from components.page.blocks import PlotBlock
from components.page.messages import Stroke
from components.scene import Scene
from components.walks.sketch import Ranges, Sketch, sketch
from components.walks.types import SketchStep


@dataclass(frozen=True)
class PlotAxes:
    """The axes of a plot, whose places are read as the numbers that stand at them."""

    x: Axis
    y: Axis

    @property
    def frame(self) -> Ranges:
        return Ranges(_span(self.x), _span(self.y))

    def drawn(self, strokes: dict[str, Stroke], names: tuple[str, ...]) -> dict[str, Sketch]:
        """Sketched curves, of which two know each other."""
        points = {name: self._numbers(strokes.get(name, [])) for name in names}
        return {
            name: sketch(
                points[name], self.frame, *(sketch(points[other], self.frame) for other in names if other != name)
            )
            for name in names
        }

    def _numbers(self, stroke: Stroke) -> list[tuple[float, float]]:
        return [(number_at(self.x, x), number_at(self.y, y)) for x, y in stroke]


def number_at(axis: Axis, place: float) -> float:
    """The number of a place, in the unit written at the axis without its power of ten."""
    return float(10.0**place if axis.log else place * 10.0**axis.exponent)


def place_of(axis: Axis, number: float) -> float:
    """Where a number stands on its axis."""
    return float(np.log10(number) if axis.log else number * 10.0**-axis.exponent)


def _span(axis: Axis) -> tuple[float, float]:
    return number_at(axis, axis.place(axis.start)), number_at(axis, axis.place(axis.end))


def plot_of(scene: Scene, name: str) -> PlotBlock:
    """A plot of a scene that has its axes now; ValueError where there is none."""
    for plot in plots(type(scene)):
        if plot.name == name and {plot.x, plot.y} <= scene.shown.axes.keys():
            return plot
    raise ValueError(f"the scene shows no plot “{name}”")


def axes_of(scene: Scene, plot: str) -> PlotAxes:
    block = plot_of(scene, plot)
    return PlotAxes(scene.shown.axes[block.x], scene.shown.axes[block.y])


def pad_axes(step: SketchStep, scene: Scene) -> PlotAxes:
    """The empty axes that a sketch is drawn on, over the ranges that the step's covers leave them: the frame that a
    class shares, whatever a screen shows."""
    block = plot_of(scene, step.plot)
    axes = without(type(scene), scene.shown, step.cover)[0].axes
    return PlotAxes(axes[block.x], axes[block.y])


def true_curves(step: SketchStep, scene: Scene) -> dict[str, Sketch]:
    """The curves that a sketch is asked for; ValueError for one that the plot does not have."""
    return axes_of(scene, step.plot).drawn({name: _stroke(scene, step.plot, name) for name in step.curves}, step.curves)


def _stroke(scene: Scene, plot: str, name: str) -> Stroke:
    """A curve as it is drawn, all its pieces one after the other; over time with the points where it truly turns, which
    lie between those drawn."""
    block = plot_of(scene, plot)
    x, y = scene.shown.axes[block.x], scene.shown.axes[block.y]
    stroke: Stroke = []
    for curve in block.curves:
        columns = scene.shown.columns.get(curve.source, {})
        if curve.y == name and name in columns:
            across, up = x.places(columns[curve.x]), y.places(columns[name])
            stroke += zip(across.tolist(), up.tolist(), strict=True)
            if block.time:
                smooth = CubicSpline(across, up)  # within 1e-7 of a motion that is drawn in 32 points a cycle
                turns = smooth.derivative().roots(extrapolate=False)
                stroke += zip(turns.tolist(), smooth(turns).tolist(), strict=True)
    if not stroke:
        raise ValueError(f"the plot “{plot}” draws no curve “{name}”")
    return stroke
