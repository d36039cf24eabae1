"""The true curves of sketch steps, as a hand would draw them."""

from __future__ import annotations

from components.description import plots
from components.scenes import SCENES
from components.walks.links import scene_at
from components.walks.types import SketchStep


def strokes(step: SketchStep) -> dict[str, list[tuple[float, float]]]:
    """Some hundred places on the axes, by curve."""
    scene = scene_at(step.state, SCENES)
    (plot,) = (plot for plot in plots(type(scene)) if plot.name == step.plot)
    axes, found = scene.shown.axes, {}
    for name in step.curves:
        points: list[tuple[float, float]] = []
        for curve in plot.curves:
            columns = scene.shown.columns.get(curve.source, {})
            if curve.y == name and name in columns:
                x, y = axes[plot.x].places(columns[curve.x]), axes[plot.y].places(columns[name])
                points += zip(x.tolist(), y.tolist(), strict=True)
        found[name] = points[:: len(points) // 200]
    return found
