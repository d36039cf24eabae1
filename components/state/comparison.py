"""The comparison with another picture: its curves, its moving shapes on the stage, and a table of numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np

from components.language.blocks import PlotBlock, StageBlock
from components.language.expressions import Expression, names_in
from components.language.picture import Drawn, Held, LedgerRow, Trace
from components.language.shapes import AnyShape, Label
from components.language.signals import AnySignal
from components.layout.sheet import blocks
from components.layout.text import rich
from components.quantities.formatting import three
from components.quantities.parameters import Quantity
from components.quantities.readouts import Readout, became, is_same
from components.scene import Picture, Scene
from components.scene.traces import Columns
from components.state.compared import moved
from components.state.covers import VALUE, with_needs, without
from components.state.encoding import columns_of, signals_of, traces_of
from components.state.page_state import PageState
from components.state.sent_picture import drawn_on, sent_picture
from components.state.wire import Steps

MOST_ROWS = 10
COVERED = "?"


def compared_message(now: PageState, shown: Picture) -> tuple[Held | None, list[Steps]]:
    """Return the message's part about the compared picture, without hidden items, and that picture's packed numbers.

    `shown` is the current picture as it is sent.
    """
    if now.held is None:
        return None, []
    kind, scene, other, covered = now.kind, now.scene, now.held, now.covered
    differ = moved(scene, other)
    columns: dict[str, dict[str, Drawn]] = {}
    numbers: list[Steps] = []
    signals: dict[str, AnySignal] = {}
    traces: dict[str, Trace] = {}
    scalars: dict[str, float] = {}
    drawn = now.asked.drawn.beside
    if drawn and differ:
        held, _ = without(kind, drawn, covered)
        alike = _units(held) == _units(shown)
        given = held.columns if alike else held.sources
        columns, numbers = columns_of(_differing(given, shown.columns), drawn_on(now), shown.axes)
        if alike:
            held = sent_picture(now, held)
            traces = traces_of(held)
            traced = frozenset[str]().union(*(one.needed for one in held.traces.values()))
            needed, scalars = _needed(held, on_stage(kind) | traced)
            signals, runs = signals_of(needed)
            numbers += runs
    told = Held(
        columns=columns,
        signals=signals,
        traces=traces,
        scalars=scalars,
        values={name: getattr(other, name) for name in differ if name in scene.quantities()},
        ledger=ledger(now),
    )
    return told, numbers


def _differing(held: Mapping[str, Columns], shown: Mapping[str, Columns]) -> dict[str, Columns]:
    """Return the sources of the compared picture that differ from the current one.

    If the units differ, they include numbers of curves that are otherwise sent as signals. To find them, the exact
    numbers of the current picture are not computed, because for a driven motion that takes longer than the whole
    picture.
    """
    return {
        source: columns
        for source, columns in held.items()
        if any(not np.array_equal(column, shown.get(source, {}).get(name, ())) for name, column in columns.items())
    }


def _units(picture: Picture) -> dict[str, tuple[int, float, int, bool]]:
    """Return the unit of each axis: scalars and signals are sent in these units."""
    return {name: (axis.exponent, axis.factor, axis.power, axis.log) for name, axis in picture.axes.items()}


@cache
def on_stage(scene: type[Scene]) -> frozenset[str]:
    """Return the names of quantities for the stage of a compared picture: in draggable shapes and in labels."""
    placed = (name for shape in _kept(scene) for name in (*_quantities(shape), *shape.show))
    stages = (block for block in blocks(scene.sheet()) if isinstance(block, StageBlock))
    labels = (shape.words for stage in stages for shape in stage.shapes if isinstance(shape, Label))
    return frozenset((*placed, *(run.text for words in labels for run in words if run.kind == "value")))


def _kept(scene: type[Scene]) -> Iterator[AnyShape]:
    """Yield the shapes that the compared picture also draws: draggable shapes that begin a motion, and `held` ones."""
    for block in blocks(scene.sheet()):
        if isinstance(block, (StageBlock, PlotBlock)):
            yield from (shape for shape in block.shapes if shape.held or (shape.grab and shape.grab.begins))


def _quantities(shape: AnyShape) -> Iterator[str]:
    for field in shape.__struct_fields__:
        value = getattr(shape, field)
        if isinstance(value, Expression):
            yield from names_in(value)


def _needed(picture: Picture, names: frozenset[str]) -> tuple[dict[str, AnySignal], dict[str, float]]:
    """Return the named signals and scalars, with all that they depend on."""
    wanted = with_needs(names, picture.signals)
    signals = {name: signal for name, signal in picture.signals.items() if name in wanted}
    return signals, {name: value for name, value in picture.scalars.items() if name in wanted}


@dataclass(frozen=True)
class _Pair:
    """A row of the table: a readout of the compared picture and of the current one, in a unit of the given size."""

    held: Readout
    now: Readout
    size: float
    hidden: bool

    @property
    def same(self) -> bool:
        return not self.hidden and is_same(self.held.value, self.now.value)

    def row(self) -> LedgerRow:
        now = self.now
        became_ = became(self.held.value / self.size, now.value / self.size, now.angle)
        return LedgerRow(
            symbol=rich(" − ".join(_italic(symbol) for symbol in now.symbol.split(" − "))),
            tint=now.tint,
            held=three(self.held.value / self.size),
            now=COVERED if self.hidden else three(now.value / self.size),
            unit=now.unit,
            ratio=COVERED if self.hidden else "same" if self.same else became_,
            same=self.same,
        )


def _italic(symbol: str) -> str:
    letter, index, name = symbol.partition("_")
    return f"*{letter}*{index}{name}"


def ledger(now: PageState) -> tuple[LedgerRow, ...]:
    """Return at most ten rows: first changed parameters, then numbers that depend on them, then equal numbers."""
    if now.held is None:
        return ()
    scene, other = now.scene, now.held
    _, left_out = without(now.kind, now.shown, now.covered)
    hidden = {*left_out, *(name.removeprefix(VALUE) for name in now.covered), *_followed(scene, now.before)}
    followed = dict(zip((one.name for one in other.readouts()), other.readouts(), strict=True))
    pairs = [
        *_moved(now, other),
        *(_Pair(followed[one.name], one, 1.0, one.is_in(hidden)) for one in scene.readouts() if one.name in followed),
    ]
    return tuple(pair.row() for pair in sorted(pairs, key=lambda pair: pair.same)[:MOST_ROWS])


def _followed(scene: Scene, asked: PageState | None) -> set[str]:
    """Return the readouts that a change has affected, even if their texts are equal."""
    if asked is None:
        return set()
    before = {one.name: one.value for one in asked.scene.readouts()}
    return {one.name for one in scene.readouts() if before.get(one.name) != one.value}


def _moved(now: PageState, other: Scene) -> Iterator[_Pair]:
    """Return the quantities that the panel currently shows."""
    scene = now.scene
    shown = [group for group in scene.groups if group.is_shown(now.shown.forms)]
    for name in dict.fromkeys(name for group in shown for name in group.names):
        quantity, held, stands = now.kind.param[name], getattr(other, name), getattr(scene, name)
        if not isinstance(quantity, Quantity) or held is None or stands is None:
            continue
        unit = scene.units().get(name)
        text, size = (unit.text, unit.size) if unit else (quantity.unit, 1.0)
        before, after = (Readout(name, quantity.symbol, value, text, quantity.tint) for value in (held, stands))
        yield _Pair(before, after, size, hidden=False)
