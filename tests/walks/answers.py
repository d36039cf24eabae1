"""Sketches as a hand draws and a page sends them."""

from typing import Any

import numpy as np

from components.language.messages import HEIGHTS, Sketched
from components.scenes import SCENES
from components.walks.questions.sketch import SketchStep
from components.walks.subject import Subject, place_of


def heights(step: SketchStep, curves: dict[str, tuple[Any, Any]] | None = None) -> dict[str, Sketched]:
    """Curves, each as its x and y, as they are sent; the true ones where none are given."""
    subject = Subject("", step, SCENES)
    pad = subject.pad(step.plot)
    (left, right), (low, high) = ((axis.place(axis.start), axis.place(axis.end)) for axis in (pad.x, pad.y))
    true = {name: (curve.x, curve.y) for name, curve in subject.true(step.plot, step.curves).items()}
    found: dict[str, Sketched] = {}
    for name, (numbers, values) in (curves or true).items():
        x = [place_of(pad.x, float(number)) for number in numbers]
        y = [1000 * (place_of(pad.y, float(value)) - low) / (high - low) for value in values]
        drawn = np.interp(np.linspace(left, right, HEIGHTS), x, np.clip(y, -100, 1100), left=np.nan, right=np.nan)
        found[name] = [None if np.isnan(height) else round(height) for height in drawn.tolist()]
    return found
