"""The part of a picture that is sent: the curves and motions that the visible parts of the sheet need."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

from components.language.blocks import Column, StageBlock
from components.layout.sheet import axes_of_columns, names_in
from components.layout.views import shown_blocks
from components.scene import Picture, Scene
from components.scene.scene import VIEW
from components.state.covers import with_needs
from components.state.encoding import ColumnAxes
from components.state.page_state import PageState
from components.state.scene_sheet import column_axes, scene_sheet

MOST_LISTS = 300
"""Size of the cache for views and lists of parts."""


@dataclass(frozen=True)
class SentParts:
    """The needs of the shown parts of a sheet: the axis of each column, and the names of signals and scalars."""

    axes: ColumnAxes
    names: frozenset[str]
    has_stage: bool


def sent_parts(now: PageState) -> SentParts | None:
    """Return the needs of the visible parts of a page; None if the whole sheet is visible."""
    if not (now.kind.views or now.show):
        return None
    return _sent_parts(now.kind, now.scene.values.get(VIEW, ""), now.show)


@lru_cache(MOST_LISTS)
def _sent_parts(scene: type[Scene], view: str, show: tuple[str, ...]) -> SentParts:
    blocks, sheet = list(shown_blocks(scene.sheet(), view, show)), scene_sheet(scene)
    return SentParts(
        axes_of_columns(Column(blocks=tuple(blocks))),
        names_in([*blocks, sheet.panel, sheet.spoken]),
        any(isinstance(one, StageBlock) for one in blocks),
    )


def drawn_on(now: PageState) -> ColumnAxes:
    """Return the axis of each column that is sent, by source."""
    parts = sent_parts(now)
    return parts.axes if parts else column_axes(now.kind)


def sent_picture(now: PageState, picture: Picture) -> Picture:
    """Return the picture without the curves and motions that no visible part needs. It keeps all texts, except for the
    sentence on the scale of a stage that is not visible."""
    parts = sent_parts(now)
    if picture.to_scale and (parts is None or parts.has_stage):
        picture = replace(picture, notes=(picture.to_scale, *picture.notes))
    if parts is None:
        return picture
    axes = parts.axes
    drawn = {name: one for name, one in picture.traces.items() if name in axes}
    gone = {name: set(one.names) - axes[name].keys() for name, one in drawn.items()}
    traces = {name: one.less(gone[name]) if gone[name] else one for name, one in drawn.items()}
    names = parts.names.union(*(one.needed for one in traces.values()))
    if now.step:
        names = names.union(picture.live)  # the texts of a step may have any of them
    wanted = with_needs(names, picture.signals)
    return replace(
        picture,
        traces=traces,
        signals={name: one for name, one in picture.signals.items() if name in wanted},
        scalars={name: one for name, one in picture.scalars.items() if name in wanted},
        live={name: one for name, one in picture.live.items() if name in wanted},
    )
