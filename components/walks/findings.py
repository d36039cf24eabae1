"""A feature of a sketch in words: what it is called, what was drawn, and what is true."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from components.axes import Axis
from components.numbers import short
from components.page.walk import Finding
from components.text import rich
from components.walks.curves import PlotAxes, place_of
from components.walks.sketch import Seen, Sketch, seen
from components.walks.types import (
    Extreme,
    Farthest,
    Feature,
    Least,
    Peak,
    Period,
    Pole,
    SketchStep,
    Slope,
    ValueAt,
    Zero,
)

COARSE = 2  # digits of what a hand has drawn
NOTHING = 1e-4  # of an axis: what is nearer to zero is zero


def has_all(step: SketchStep, features: Iterable[Feature], drawn: Mapping[str, Sketch]) -> bool:
    """Whether what was drawn has all of the features."""
    return all(seen(feature, drawn[feature.on or step.curve]).has for feature in features)


def findings(
    step: SketchStep, drawn: Mapping[str, Sketch], true: Mapping[str, Sketch], axes: PlotAxes
) -> tuple[Finding, ...]:
    """What is said of each feature that the step asks for."""
    found = []
    for feature in step.must:
        curve = feature.on or step.curve
        exact = seen(feature, true[curve])
        if isinstance(feature, Period):  # of a motion that grows or beats, its crossings tell another one
            exact = exact._replace(number=feature.value)
        found.append(_finding(feature, seen(feature, drawn[curve]), exact, axes))
    return tuple(found)


def _finding(feature: Feature, yours: Seen, true: Seen, axes: PlotAxes) -> Finding:
    """Its mark stands where it was drawn, or where it should have been."""
    mark = yours if yours.has and yours.x is not None else true
    at = None if mark.x is None or mark.y is None else (place_of(axes.x, mark.x), place_of(axes.y, mark.y))
    name = feature.says or called(feature, axes)
    return Finding(has=yours.has, name=rich(name), words=rich(_words(feature, yours, true, axes)), at=at)


def _words(feature: Feature, yours: Seen, true: Seen, axes: PlotAxes) -> str:
    if isinstance(feature, Slope):
        way = {"up": "upwards", "down": "downwards"}[feature.way]
        return f"yours goes {way}" if yours.has else f"missed: it goes {way}"
    lead = "" if yours.has else "missed: " if yours.number is not None else "missed: not drawn, "
    drawn = f"yours {_measured(feature, yours, axes, COARSE)}, " if yours.number is not None else ""
    return f"{lead}{drawn}true {_measured(feature, true, axes, 3)}"


def _measured(feature: Feature, found: Seen, axes: PlotAxes, digits: int) -> str:
    number = found.number or 0.0
    if isinstance(feature, (Zero, Pole)):
        return f"at {_written(number, axes.x, digits)}"
    if isinstance(feature, Extreme):
        return f"{_written(number, axes.y, digits)} at {_written(found.x or 0.0, axes.x, digits)}"
    return _written(number, axes.x if isinstance(feature, Period) else axes.y, digits)


def _written(number: float, axis: Axis, digits: int) -> str:
    if abs(number * axis.factor) < NOTHING * abs(axis.end - axis.start):
        number = 0.0
    gap = axis.gap if axis.unit else ""
    return f"{short(float(f'{number:.{digits}g}'))}{gap}{axis.unit}"


def called(feature: Feature, axes: PlotAxes) -> str:
    """What a feature is called where the step has no name for it."""
    match feature:
        case ValueAt(at=at):
            return f"The height at {_written(at, axes.x, 3)}"
        case Slope(at=at):
            return f"The direction after {_written(at, axes.x, 3)}"
        case Zero(at=at):
            return f"The zero at {_written(at, axes.x, 3)}"
        case Pole(at=at):
            return f"Leaves the frame at {_written(at, axes.x, 3)}"
        case Peak(at=at):
            return f"The peak at {_written(at, axes.x, 3)}"
        case Extreme(at=at):
            return f"The trough at {_written(at, axes.x, 3)}"
        case Period():
            return "The period"
        case Farthest(start=start, end=end) if start is not None and end is not None:
            return f"How far it goes from {_written(start, axes.x, 3)} to {_written(end, axes.x, 3)}"
        case Farthest():
            return "How far it goes"
        case Least():
            return "The lowest point"
    return "The sum of both"
