"""Predictions: a visitor changes a parameter and predicts the result; everything that depends on it is covered.

Until the visitor reveals the result, the server sends the picture from before the change. So the result is not in the
browser, and nothing moves or changes its size.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from components.language.blocks import PlotBlock, StageBlock, TableBlock, WordsBlock
from components.language.text import Forms
from components.layout.sheet import blocks
from components.scene import Picture, Scene
from components.state.covers import NEXT, PLOT, STAGE, VALUE, picture_before_change, without
from components.state.scene_sheet import plots


def picture_to_send(
    scene: type[Scene], shown: Picture, before: Picture | None, covered: tuple[str, ...]
) -> tuple[Picture, tuple[str, ...]]:
    """Return the picture to send, without covered parts, and the names of the quantities that it lacks."""
    if before is None:
        return without(scene, shown, covered)
    return picture_before_change(scene, before, covered, shown.forms)


def covers_after(scene: Scene, after: Picture, before: Picture, covered: tuple[str, ...]) -> tuple[str, ...]:
    """Return the covers, with covers for everything that the change has affected."""
    return tuple(dict.fromkeys((*covered, *_followed(type(scene), before, after))))


def put_last(covered: tuple[str, ...]) -> tuple[str, ...]:
    """Return the covers with NEXT as the last one. Covers for the results of a change will be after NEXT."""
    return (*(name for name in covered if name != NEXT), NEXT)


def _followed(scene: type[Scene], before: Picture, after: Picture) -> Iterator[str]:
    yield from (VALUE + name for name in _differing(before.values, after.values))
    moved = set(_differing(before.signals, after.signals))
    yield from (VALUE + name for name in after.live if name in moved)
    marks = {mark.at for plot in plots(scene) for mark in plot.marks}
    moved_marks = marks.intersection(_differing(before.scalars, after.scalars))
    for block in blocks(scene.sheet()):
        if isinstance(block, PlotBlock):
            if any(_is_other(before, after, *column) for column in _columns(block)):
                yield PLOT + block.name
            yield from (f"mark:{block.name}.{mark.at}" for mark in block.marks if mark.at in moved_marks)
        elif isinstance(block, StageBlock) and moved:
            yield STAGE
        elif isinstance(block, (WordsBlock, TableBlock)):
            chosen = {item.name for item in _items(block) if item.name}
            yield from (f"form:{name}" for name in chosen.intersection(_differing(before.forms, after.forms)))
    for name, axis in after.axes.items():
        old = before.axes.get(name)
        if old and (old.ticks, old.labels) != (axis.ticks, axis.labels):
            yield f"numbers:{name}"


def _items(block: WordsBlock | TableBlock) -> Iterator[Forms]:
    if isinstance(block, WordsBlock):
        yield from block.items
    else:
        yield from (cell for row in block.rows for cell in row)


def _differing(before: Mapping[str, Any], after: Mapping[str, Any]) -> list[str]:
    return [name for name, value in after.items() if name not in before or before[name] != value]


def _columns(plot: PlotBlock) -> Iterator[tuple[str, str]]:
    yield from ((curve.source, name) for curve in plot.curves for name in (curve.x, curve.y))
    yield from ((region.source, name) for region in plot.regions for name in (region.low, region.high))


def _is_other(before: Picture, after: Picture, source: str, name: str) -> bool:
    """Return True if the new picture has a column that the old one did not have, or had with other numbers."""
    now, old = (picture.sources.get(source, {}).get(name) for picture in (after, before))
    return now is not None and (old is None or not np.array_equal(old, now))
