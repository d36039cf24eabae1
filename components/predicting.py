"""What a change would show: the covers of all that follows from it, for those who want to predict it.

Until it is revealed the scene from before the change, `asked`, is told in its place: so nothing that follows from the
change is sent, sizes stay, and the stage stands as it was.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from components.beside import changed, show_as
from components.covers import NEXT, PLOT, STAGE, VALUE, as_it_stood, without
from components.description import blocks, plots
from components.page.blocks import PlotBlock, StageBlock, TableBlock, WordsBlock
from components.page.state import Frame
from components.page.text import Forms
from components.parameters import Values
from components.scene import Picture, Scene, frame_of


def waiting(scene: Scene, covered: tuple[str, ...]) -> Scene | None:
    """The scene as it stands before what may be the change that is to be predicted."""
    return scene.twin() if NEXT in covered else None


def asked_in(scene: Scene, values: Values, frame: Frame | None) -> Scene:
    """The scene with the values from before the change, in the frame that stands; ValueError where it cannot be."""
    before = type(scene)()
    before.keep_frame()
    before.open(values, frame)
    before.beside = scene.beside
    return before


def standing(asked: Scene | None, frame: Frame | None) -> Frame | None:
    """The frame of a state, whole where it is the one that stands while a change is to be predicted: what is then
    revealed is seen in it."""
    return frame_of(asked.shown) if asked and asked.frame == frame else frame


def asked_of(scene: Scene, before: Scene | None, begins: bool = False) -> Scene | None:
    """The scene from before the change, shown as the one that stands. What `begins` with the change is there as soon as
    these are two; a view is no change."""
    if before is None or (begins and not changed(scene, before)):
        return None
    show_as(before, scene)
    if before.hidden != scene.hidden:
        before.set({"hidden": scene.hidden})
    return before


def told_of(scene: Scene, asked: Scene | None, covered: tuple[str, ...]) -> tuple[Picture, tuple[str, ...]]:
    """The picture that is told, and the names of the quantities that are left out of it."""
    if asked is None:
        return without(type(scene), scene.shown, covered)
    return as_it_stood(type(scene), asked.shown, covered, scene.shown.forms)


def covers_after(scene: Scene, asked: Scene, covered: tuple[str, ...]) -> tuple[str, ...]:
    """The covers, and those of all that the change has changed."""
    return tuple(dict.fromkeys((*covered, *_followed(type(scene), asked.shown, scene.shown))))


def put_last(covered: tuple[str, ...]) -> tuple[str, ...]:
    """The covers before a change: those of what it changes will follow NEXT, so that the others are known."""
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
    """Where the picture has no such column another one may have taken its place."""
    now, old = (picture.columns.get(source, {}).get(name) for picture in (after, before))
    return now is not None and (old is None or not np.array_equal(old, now))
