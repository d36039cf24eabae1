"""The part of a picture that is sent: the curves, motions and texts that the visible parts of the sheet need."""

from __future__ import annotations

from dataclasses import replace

from components.scene import Picture
from components.scene.scene import VIEW
from components.state.covers import with_needs
from components.state.encoding import ColumnAxes
from components.state.page_state import PageState
from components.state.scene_sheet import column_axes
from components.state.sent_parts import SentParts, sent_parts


def parts_of(now: PageState) -> SentParts | None:
    """Return the needs of the visible parts of a page; None if the whole sheet is visible."""
    if not (now.kind.views or now.show):
        return None
    return sent_parts(now.kind, now.scene.values.get(VIEW, ""), now.show)


def drawn_on(now: PageState) -> ColumnAxes:
    """Return the axis of each column that is sent, by source."""
    parts = parts_of(now)
    return parts.axes if parts else column_axes(now.kind)


def sent_picture(now: PageState, picture: Picture) -> Picture:
    """Return the picture without the curves, motions and texts that no visible part needs. A page that has to be
    whole keeps all texts."""
    parts = parts_of(now)
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
    texts = wanted.union(picture.values, picture.forms) if now.is_whole else wanted
    return replace(
        picture,
        traces=traces,
        signals={name: one for name, one in picture.signals.items() if name in wanted},
        scalars={name: one for name, one in picture.scalars.items() if name in wanted},
        live={name: one for name, one in picture.live.items() if name in wanted},
        values={name: one for name, one in picture.values.items() if name in texts},
        forms={name: one for name, one in picture.forms.items() if name in texts},
    )
