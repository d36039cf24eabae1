"""The needs of the visible parts of a sheet: what has to be computed and sent."""

from __future__ import annotations

import re
from collections.abc import Hashable
from dataclasses import dataclass
from functools import lru_cache

from components.language.blocks import Column, PlotBlock, StageBlock
from components.language.state import Frame
from components.layout.sheet import axes_of_columns, blocks, needed_names
from components.layout.views import shown_blocks
from components.scene import Picture, Scene
from components.scene.scene import VIEW
from components.state.encoding import ColumnAxes
from components.state.scene_sheet import scene_sheet

SPOKEN = re.compile(r"{(\w+)}")
"""A live number in a text that is read aloud."""
MOST_LISTS = 300
"""Size of the cache for views and lists of parts."""


@dataclass(frozen=True)
class SentParts:
    """The needs of the shown parts of a sheet: the axis of each column, and the names of signals, numbers, texts and
    forms."""

    axes: ColumnAxes
    names: frozenset[str]
    has_stage: bool


@lru_cache(MOST_LISTS)
def sent_parts(scene: type[Scene], view: str, show: tuple[str, ...] = ()) -> SentParts:
    """Return the needs of the parts that a view shows, or that are listed in `show`."""
    shown, sheet = list(shown_blocks(scene.sheet(), view, show)), scene_sheet(scene)
    forms = [block.form for block in blocks(sheet.paper)]  # rows and columns have forms, too
    aloud = [sheet.spoken, *(one.says for one in shown if isinstance(one, PlotBlock))]
    spoken = {name for texts in aloud for text in texts.values() for name in SPOKEN.findall(text)}
    return SentParts(
        axes_of_columns(Column(blocks=tuple(shown))),
        needed_names([*shown, *forms, sheet.panel]) | spoken,
        any(isinstance(one, StageBlock) for one in shown),
    )


@dataclass(frozen=True)
class SceneInView:
    """A scene with views, to be drawn without the numbers that its current view doesn't show."""

    scene: Scene

    @property
    def key(self) -> Hashable:
        return SceneInView, self.scene.key

    def picture(self, frame: Frame) -> Picture:
        return self.scene.picture_of(sent_parts(type(self.scene), self.scene.values.get(VIEW, "")).names, frame)
