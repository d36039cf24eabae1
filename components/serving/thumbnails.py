"""Thumbnails: a plot of each scene, small, as an SVG of the physics' own numbers, for the start page."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from components.language.blocks import PlotBlock
from components.language.numbers import called
from components.quantities.axes import Axis
from components.scene import Picture, Scene
from components.state.scene_sheet import plots

WIDE, HIGH, EDGE = 192, 116, 8
"""Units of the frame, and what stays free at each side of it."""
POINTS = 150
"""Of a curve, at most: as many as its width tells apart."""


@dataclass(frozen=True)
class Stroke:
    """A curve or a filled band: SVG path data, the tint and the kind of line; along one that `runs` a dot may move."""

    d: str
    tint: str
    width: str
    runs: bool = False


def thumbnail(scene: type[Scene]) -> list[Stroke]:
    """The curves of the plot that stands for a scene, as it opens, from back to front."""
    frame, values = scene.pictured
    picture = scene(**{**scene.opens, **values}).shown
    plot = _plot(scene, picture, called(frame))
    x, y = picture.axes[plot.x], picture.axes[plot.y]
    strokes = []
    for band in plot.regions:
        columns = picture.sources.get(band.source, {})
        if {band.x, band.low, band.high} <= columns.keys():
            across = np.concatenate([columns[band.x], columns[band.x][::-1]])
            edge = np.concatenate([columns[band.low], columns[band.high][::-1]])
            strokes.append(Stroke(_path(across, edge, x, y) + "Z", band.tint, "band"))
    for curve in plot.curves:
        columns = picture.sources.get(curve.source, {})
        if {curve.x, curve.y} <= columns.keys() and curve.width != "none":
            d = _path(columns[curve.x], columns[curve.y], x, y)
            strokes.append(Stroke(d, curve.tint, curve.width, runs=curve.width == "sum"))
    return [stroke for stroke in strokes if stroke.d]


def _plot(scene: type[Scene], picture: Picture, name: str) -> PlotBlock:
    """The plot of that name, or the first of the picture."""
    shown = [plot for plot in plots(scene) if {plot.x, plot.y} <= picture.axes.keys()]
    return next((plot for plot in shown if plot.name == name), shown[0])


def _path(across: NDArray[np.float64], up: NDArray[np.float64], x: Axis, y: Axis) -> str:
    """SVG path data of the points that have a place; "" without any."""
    every = max(1, -(-len(across) // POINTS))
    points = np.column_stack(
        [_places(x, across[::every], EDGE, WIDE - EDGE), _places(y, up[::every], HIGH - EDGE, EDGE)]
    )
    points = points[np.isfinite(points).all(axis=1)]
    return "M" + "L".join(f"{px:.1f} {py:.1f}" for px, py in points) if len(points) > 1 else ""


def _places(axis: Axis, values: NDArray[np.float64], start: float, end: float) -> NDArray[np.float64]:
    """Units of the frame; what is far outside it stays near."""
    ruler = axis.ruler
    share = (axis.places(values) - ruler.start) / (ruler.end - ruler.start)
    return start + np.clip(share, -2.0, 3.0) * (end - start)
