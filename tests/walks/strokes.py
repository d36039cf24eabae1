"""The true curves of sketch steps, as a hand would draw them and as they are sent."""

from __future__ import annotations

import numpy as np

from components.language.messages import HEIGHTS, Sketched
from components.scenes import SCENES
from components.walks.questions.sketch import SketchStep
from components.walks.subject import Subject, Traced, number_at, place_of


def strokes(step: SketchStep) -> dict[str, Traced]:
    """Some hundred places on the axes, by curve."""
    subject = Subject("", step, SCENES)
    axes, found = subject.axes(step.plot), {}
    for name, curve in subject.true(step.plot, step.curves).items():
        places = [
            (place_of(axes.x, float(x)), place_of(axes.y, float(y))) for x, y in zip(curve.x, curve.y, strict=True)
        ]
        found[name] = places[:: len(places) // 200]
    return found


def heights(step: SketchStep, curves: dict[str, Traced] | None = None) -> dict[str, Sketched]:
    """Curves in places on the axes, the true ones where none are given, as they are sent."""
    subject = Subject("", step, SCENES)
    axes, pad = subject.axes(step.plot), subject.pad(step.plot)
    (left, right), (low, high) = ((axis.place(axis.start), axis.place(axis.end)) for axis in (pad.x, pad.y))
    found: dict[str, Sketched] = {}
    for name, places in (curves or strokes(step)).items():
        x = [place_of(pad.x, number_at(axes.x, place)) for place, _ in places]
        y = [1000 * (place_of(pad.y, number_at(axes.y, place)) - low) / (high - low) for _, place in places]
        drawn = np.interp(np.linspace(left, right, HEIGHTS), x, np.clip(y, -100, 1100), left=np.nan, right=np.nan)
        found[name] = [None if np.isnan(height) else round(height) for height in drawn.tolist()]
    return found
