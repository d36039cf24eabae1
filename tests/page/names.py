"""The names that a scene's sheet speaks of, against what its picture has.

A name that a shape, a visible text, a handle or a signal needs must be in the picture. What may come and go with the
parameters (marks, dots, curves, forms) must be in some picture of the scene: `spoken` and `given` are for the sums.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from components.language.blocks import Block, ChoiceBlock, PlotBlock, StageBlock, TableBlock, WordsBlock
from components.language.shapes import AnyShape, Box, Label
from components.language.text import Forms
from components.layout.sheet import blocks
from components.scene import Scene
from components.state.scene_sheet import scene_sheet
from tests.page.hand import draw, visible

LIVE = re.compile(r'data-value="(\w+)"')
OF_THE_STAGE = {"W", "H", "wide", "narrow", "hall", "desk", "low", "t"}
OF_THE_CLOCK = {"speed"}


@dataclass
class Names:
    """The names that a sheet speaks of and a picture may lack: (kind, name) pairs."""

    spoken: set[tuple[str, str]] = field(default_factory=set)
    given: set[tuple[str, str]] = field(default_factory=set)


def missing(scene: Scene) -> list[str]:
    """Every name that is needed for the picture in force and is not in it; of one in a number the scripts complain."""
    picture, sheet = scene.shown, scene_sheet(type(scene))
    texts = {*picture.values, *picture.live, *OF_THE_CLOCK}
    rows = [row for group in sheet.panel.groups for row in group.rows]
    shapes = [shape for row in rows for part in getattr(row, "pictures", {}).values() for shape in part]
    found = []
    for block in visible(sheet.paper, picture.forms):
        if isinstance(block, (StageBlock, PlotBlock)):
            shapes += block.shapes
        if isinstance(block, PlotBlock):
            found += _plot(block, scene, texts)
        found += [f"value {name}" for name in _texts(block, picture.forms) if name not in texts]
        if isinstance(block, ChoiceBlock) and block.name not in scene.param:
            found.append(f"parameter {block.name}")
    draw(type(scene), picture, shapes)
    found += _words(shapes, scene, texts)
    found += [f"live {name} without a signal" for name in picture.live if name not in picture.signals]
    return found


def names(scene: Scene) -> Names:
    """The names that the sheet speaks of and the picture gives, of parts that may come and go."""
    picture, sheet = scene.shown, scene_sheet(type(scene))
    found = Names()
    found.given |= {("form", name) for name in picture.forms} | {("scalar", name) for name in picture.scalars}
    found.given |= {("axis", name) for name in picture.axes} | {("signal", name) for name in picture.signals}
    found.given |= {("signal", name) for name in picture.scalars}  # a dot may stand at one
    found.given |= {("show", name) for name in (*picture.scalars, *picture.signals, *OF_THE_STAGE)}
    found.given |= {("column", f"{s}.{name}") for s, columns in picture.sources.items() for name in columns}
    found.given |= {("form", f"{name}={variant}") for name, variant in picture.forms.items()}
    for block in blocks(sheet.paper):
        if block.form:
            found.spoken.add(("form", block.form))
        if isinstance(block, PlotBlock):
            found.spoken |= _spoken_of(block)
        if isinstance(block, (StageBlock, PlotBlock)):
            found.spoken |= {("show", name) for shape in block.shapes for name in shape.show}
        for forms in _forms(block):
            if forms.name:
                found.spoken.add(("form", forms.name))
    found.spoken |= {("form", group.form) for group in sheet.panel.groups if group.form}
    return found


def _spoken_of(plot: PlotBlock) -> set[tuple[str, str]]:
    spoken = {("axis", plot.x), ("axis", plot.y)}
    for curve in plot.curves:
        spoken |= {("column", f"{curve.source}.{curve.x}"), ("column", f"{curve.source}.{curve.y}")}
        spoken |= {("signal", name) for name in (curve.signal, curve.signal_x) if name}
    for region in plot.regions:
        spoken |= {("column", f"{region.source}.{name}") for name in (region.x, region.low, region.high)}
    for mark in plot.marks:
        spoken |= {("scalar", name) for name in (mark.at, mark.exactly) if name}
    spoken |= {("form", handle.form) for handle in plot.handles if handle.form}
    return spoken | {("form", term.form) for term in plot.heading if len(term.variants) > 1}


def _words(shapes: Iterable[AnyShape], scene: Scene, texts: set[str]) -> Iterator[str]:
    """Live numbers that the words of those shapes need that stand."""
    for shape in shapes:
        if all(scene.shown.scalars.get(name, name in OF_THE_STAGE) for name in shape.show):
            words = shape.words if isinstance(shape, Label) else shape.label if isinstance(shape, Box) else ()
            yield from (f"value {run.text}" for run in words if run.kind == "value" and run.text not in texts)


def _plot(plot: PlotBlock, scene: Scene, texts: set[str]) -> Iterator[str]:
    for handle in plot.handles:
        if handle.parameter not in scene.param:
            yield f"parameter {handle.parameter}"
        if handle.text and handle.text not in texts:
            yield f"value {handle.text}"
    for mark in plot.marks:
        if mark.at in scene.shown.scalars:
            yield from (f"value {name} of a mark" for name in LIVE.findall(mark.html) if name not in texts)
            if mark.exactly and mark.exactly not in scene.shown.scalars:
                yield f"scalar {mark.exactly}"
            if mark.set and mark.set not in scene.param:
                yield f"parameter {mark.set}"
            if mark.act and mark.act not in {name for group in scene.groups for name, _ in group.actions}:
                yield f"action {mark.act}"
    for term in plot.heading:
        variant = scene.shown.forms.get(term.form, "formula" if "formula" in term.variants else None)
        if variant is None and len(term.variants) == 1:
            variant = next(iter(term.variants))
        if variant is None or (variant and variant not in term.variants):
            yield f"form {term.form} = {variant} of the heading of {plot.name}"
        elif variant:
            yield from (f"value {name}" for name in LIVE.findall(term.variants[variant]) if name not in texts)


def _forms(block: Block) -> Iterator[Forms]:
    if isinstance(block, WordsBlock):
        yield from block.items
    if isinstance(block, TableBlock):
        for row in block.rows:
            yield from row


def _texts(block: Block, forms: dict[str, str]) -> Iterator[str]:
    """The live numbers of what is seen of a block; a form that has no such variant is named too."""
    if isinstance(block, TableBlock):
        for head in block.head:
            yield from LIVE.findall(head)
    for item in _forms(block):
        variant = forms.get(item.name, "") if item.name else ""
        if item.name and variant and variant not in item.variants:
            yield f"{item.name} = {variant}, a form without words"
        elif variant or not item.name:
            yield from LIVE.findall(item.variants[variant])
