"""Leaks of a walk: quantities that one step shows, before or after its answer, and that a later step of the same scene
and system asks for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import combinations
from typing import NamedTuple

from components.language.blocks import Block, PlotBlock, StageBlock, TableBlock, WordsBlock
from components.language.plots import Curve
from components.language.shapes import AnyShape, Label
from components.language.text import Forms
from components.layout.controls import Group
from components.layout.sheet import LIVE, in_force
from components.layout.views import shown_blocks
from components.quantities.parameters import names_of
from components.quantities.refusals import in_words
from components.scene import Picture, Scene
from components.scene.scene import VIEW
from components.state.covers import PLOT, STAGE, TABLE, VALUE, without
from components.state.page_state import PageState
from components.walks.links import Scenes, page_state_at
from components.walks.texts import live_names
from components.walks.walk import Step, Walk

ByCover = dict[str, str]
"""Quantities by the cover that hides them."""


class Exhibit(NamedTuple):
    """A picture of a step: its scene and system, its visible and its hidden quantities."""

    chain: object
    shown: ByCover
    covered: ByCover


def leaks(walk: Walk, scenes: Scenes) -> Iterator[str]:
    """Return a sentence for each step that shows the answer of a later one."""
    with in_words():
        exhibits = [(before(step, scenes), after(step, scenes)) for step in walk.steps]
    for (i, early), (j, late) in combinations(enumerate(exhibits), 2):
        asked = {(one.chain, name): cover for one in late for name, cover in one.covered.items()}
        for when, one in zip(("before", "after"), early, strict=True):
            told = sorted({asked[one.chain, name] for name in one.shown if (one.chain, name) in asked})
            if told:
                here, there = (f"step {n + 1} ({walk.steps[n].id})" for n in (i, j))
                yield f"{walk.name}, {here}: {when} its answer it shows {', '.join(told)}, which {there} covers."


def before(step: Step, scenes: Scenes) -> Exhibit:
    """Return the picture of a step's question."""
    return _exhibit(page_state_at(step.state, scenes), step.cover, step.show)


def after(step: Step, scenes: Scenes) -> Exhibit:
    """Return the picture after the answer. Quantities that only this step hides do not count as hidden."""
    return _exhibit(page_state_at(step.shown, scenes), step.still, step.show)._replace(covered={})


def _exhibit(page: PageState, covers: tuple[str, ...], show: tuple[str, ...]) -> Exhibit:
    kind, picture = page.kind, page.shown
    whole = dict(_quantities(page.scene, picture, show))
    left, gone = without(kind, picture, covers)
    shown = dict(_quantities(page.scene, left, show, frozenset(covers), frozenset(gone)))
    asked = {name: cover for name, cover in whole.items() if name not in shown}
    by_name = {name: cover for name, cover in asked.items() if cover in covers or not cover.startswith(VALUE)}
    return Exhibit(chain_of(page.scene), shown, by_name)


def chain_of(scene: Scene) -> object:
    """Return the scene and its physical system: the values that scenes share, or all its quantities if it shares
    none."""
    values = scene.values
    shares = scene.shares and all(values[name] == value for name, value in scene.sharing.items())
    names = set(scene.shares.values()) if shares else scene.quantities() - {"window"}
    names = {*names, *scene.sharing, *names_of(scene.physical)}
    return scene.slug, tuple(sorted((name, values[name]) for name in names))


def texts_in_sight(page: PageState, covers: tuple[str, ...], show: tuple[str, ...]) -> dict[str, str]:
    """Return the visible live numbers of a picture with their texts, in the parts `show` or in its view, without
    covered ones."""
    picture, gone = without(page.kind, page.shown, covers)
    hidden, seen = frozenset(covers), _seen(page.scene, picture, show)
    names = {name for block in seen for name in _numbers(block, picture, hidden)}
    names.update(name for group in page.kind.groups if group.is_shown(picture.forms) for name in _facts(group))
    return {name: picture.values[name] for name in sorted(names.difference(gone)) if picture.values.get(name)}


def _seen(scene: Scene, picture: Picture, show: tuple[str, ...]) -> Iterator[Block]:
    """The parts of a sheet that a step shows."""
    sheet = scene.sheet()
    shown = set(map(id, shown_blocks(sheet, scene.values.get(VIEW, ""), show)))
    return (block for block in in_force(sheet, picture.forms) if id(block) in shown)


def _facts(group: Group) -> Iterator[str]:
    """The live numbers in the facts of a group of controls."""
    yield from (name for row in group.facts for cell in row for name in live_names(cell))


def _quantities(
    scene: Scene, picture: Picture, show: tuple[str, ...], covers: frozenset[str] = frozenset(),
    gone: frozenset[str] = frozenset(),
) -> Iterator[tuple[str, str]]:  # fmt: skip
    """The visible curves, numbers and sentences of a picture: neither covered nor removed with something covered."""
    alias = {other: one.name for one in scene.readouts() for other in one.also}
    for block in _seen(scene, picture, show):
        for name in _numbers(block, picture, covers):
            if name not in gone and (picture.values.get(name) or name in picture.live):
                yield f"number {alias.get(name, name)}", VALUE + name
        if isinstance(block, PlotBlock) and PLOT + block.name not in covers:
            yield from ((f"curve {_motion(one)}", f"curve:{block.name}.{one.y}") for one in _drawn(block, picture))
        if isinstance(block, WordsBlock):
            yield from (
                (text, f"form:{item.name}") for item in block.items if item.name and (text := _text(item, picture))
            )


def _drawn(plot: PlotBlock, picture: Picture) -> Iterator[Curve]:
    """Return the names of the curves that a plot draws."""
    yield from (one for one in plot.curves if len(picture.sources.get(one.source, {}).get(one.y, ())))


def _motion(curve: Curve) -> str:
    return curve.signal or curve.y


def _numbers(block: Block, picture: Picture, covers: frozenset[str]) -> Iterator[str]:
    """The live numbers in the texts of a block."""
    if isinstance(block, WordsBlock):
        yield from (name for item in block.items for name in LIVE.findall(_text(item, picture)))
    elif isinstance(block, TableBlock) and TABLE not in covers:
        yield from (name for row in block.rows for cell in row for name in LIVE.findall(_text(cell, picture)))
    elif isinstance(block, PlotBlock):
        for term in block.heading:  # a cover hides only the numbers that are in no other part of the scene
            yield from LIVE.findall(term.variants.get(picture.forms.get(term.form, "formula"), ""))
        if PLOT + block.name in covers:
            return
        yield from (one.text for one in block.handles if one.text)
        yield from (name for one in block.marks if one.at in picture.scalars for name in LIVE.findall(one.html))
        yield from _labelled(block.shapes, picture)
    elif isinstance(block, StageBlock) and STAGE not in covers:
        yield from _labelled(block.shapes, picture)


def _labelled(shapes: Iterable[AnyShape], picture: Picture) -> Iterator[str]:
    """Return the live numbers in the texts of visible shapes."""
    for one in shapes:
        if isinstance(one, Label) and all(picture.scalars.get(name, 1) for name in one.show):
            yield from (run.text for run in one.words if run.kind == "value")


def _text(item: Forms, picture: Picture) -> str:
    """Return the current variant of a text."""
    return item.variants.get(picture.forms.get(item.name, "") if item.name else "", "")
