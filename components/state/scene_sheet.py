"""The sheet of a scene: the arrangement of its parts, the same for every visitor, built once per process."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache
from hashlib import sha256
from typing import Any

import msgspec
from msgspec.structs import replace

from components.language.blocks import PlotBlock
from components.language.messages import SceneSheet, Shown
from components.language.state import State
from components.layout.controls import panel, settings
from components.layout.plots import with_figures
from components.layout.sheet import LIVE, axes_of_columns, blocks
from components.scene import Scene
from components.state.encoding import view_of
from components.state.wire import WINDOW, as_json


@cache
def scene_sheet(scene: type[Scene]) -> SceneSheet:
    return SceneSheet(
        slug=scene.slug,
        title=scene.title,
        headline=scene.headline,
        hidden=tuple(scene.param["hidden"].default),
        runs=scene.work is not None,
        about=scene.is_checked(),
        onward=scene.onward,
        spoken={what: text if isinstance(text, str) else text.aloud for what, text in scene.spoken.items()},
        preset_dictionary=preset_dictionary(scene).decode(),
        views=tuple(view.sent for view in scene.views),
        paper=scene.sheet(),
        panel=panel(
            scene.param.objects("existing"),
            scene.groups,
            start=scene.start,
            folded=scene.start_folded,
            presets=scene.presets,
            drawings=scene.drawings(),
            watch=scene.watch,
            places=scene.places,
        ),
    )


@cache
def preset_dictionary(scene: type[Scene]) -> bytes:
    """Return the preset dictionary for the compression of messages about the scene.

    It is the text of the scene's first picture, with six digits, so that it is the same on every machine.
    """
    first = scene.at()
    view, _ = view_of(first.shown, column_axes(scene))
    told = Shown(
        scene=scene.slug,
        sheet="",
        view=view,
        settings=settings(first.param.objects("existing"), first.values, first.units(), first.shown.spans),
        state=State(scene=scene.slug),
        preset=None,
        here=(),
        errors={},
        problems=(),
        query=f"scene={scene.slug}",
        progress=None,
    )
    rounded = json.loads(as_json(told), parse_float=lambda number: float(f"{float(number):.6g}"))
    return as_json(rounded)[-WINDOW:]


@cache
def sheet_json(scene: type[Scene]) -> bytes:
    """Return the sheet as the browser reads it."""
    sheet = scene_sheet(scene)
    return msgspec.json.encode(replace(sheet, paper=with_figures(sheet.paper)))


@cache
def sheet_address(scene: type[Scene]) -> str:
    """Return the address of the sheet, which contains the hash of its content, so that caches can keep it."""
    return f"sheets/{scene.slug}.{sha256(sheet_json(scene)).hexdigest()[:16]}.json"


def plots(scene: type[Scene]) -> Iterator[PlotBlock]:
    """Return the plots of a scene's sheet."""
    return (block for block in blocks(scene.sheet()) if isinstance(block, PlotBlock))


@cache
def live_names(scene: type[Scene]) -> frozenset[str]:
    """Return the names of the live numbers in all texts of the sheet."""
    return frozenset(_named(msgspec.to_builtins(scene_sheet(scene))))


@cache
def heading_names(scene: type[Scene]) -> dict[str, frozenset[str]]:
    """Return the live numbers that occur only in headings, by plot."""
    sheet = msgspec.to_builtins(scene_sheet(scene))
    headings = {plot.name: frozenset(_named(msgspec.to_builtins(plot.heading))) for plot in plots(scene)}
    elsewhere = frozenset(_named(_without_headings(sheet)))
    return {name: names - elsewhere for name, names in headings.items()}


def _without_headings(part: Any) -> Any:
    if isinstance(part, (list, tuple)):
        return [_without_headings(one) for one in part]
    if isinstance(part, dict):
        return {key: _without_headings(value) for key, value in part.items() if key != "heading"}
    return part


def _named(part: Any) -> Iterator[str]:
    """Yield the names of live numbers in HTML, and in the words of a stage."""
    if isinstance(part, str):
        yield from LIVE.findall(part)
    elif isinstance(part, (list, tuple)):
        for one in part:
            yield from _named(one)
    elif isinstance(part, dict):
        if part.get("kind") == "value":
            yield part["text"]
        yield from _named(list(part.values()))


@cache
def column_axes(scene: type[Scene]) -> dict[str, dict[str, str]]:
    """Return the axis on which each column of each source is drawn: {source: {column: axis}}."""
    return axes_of_columns(scene.sheet())
