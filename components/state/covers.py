"""Covers: parts of a page that are hidden until the visitor has answered. They are not sent, so nobody can find them.

A cover consists of its kind and a name in the sheet or the picture:

    plot:x2, curve:energy.T, band:energy.T_lo, mark:det.w_slow    a plot, or one curve, band, flag in it
    value:tau, form:why                                           a live number, a sentence
    ticks:x                                                       the numbers of an axis; round numbers over a wider
                                                                  range replace them
    numbers:x                                                     the same, but the range stays
    stage, table                                                  the numbers of the stage, which stops at the initial
                                                                  positions; a table
    next                                                          everything that the next change affects
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache
from typing import Any, TypeVar

from msgspec.structs import replace as changed

from components.language.blocks import PlotBlock, StageBlock, TableBlock, WordsBlock
from components.language.expressions import Expression, names_in
from components.language.plots import Curve, Region
from components.language.shapes import AnyShape, Label
from components.language.signals import AnySignal, CosineOf, Derived, Modal, SineOf
from components.layout.sheet import LIVE, blocks, in_force
from components.quantities.axes import Axis, round_ticks
from components.quantities.formatting import excerpt
from components.quantities.instant import instant
from components.quantities.motion import derived
from components.scene import Picture, Scene
from components.scene.traces import Columns, Traces
from components.state.scene_sheet import heading_names, live_names, plots

Kept = TypeVar("Kept")
PLOT, VALUE = "plot:", "value:"
STAGE, TABLE, NEXT = "stage", "table", "next"
ROOM = 0.5
"""Share by which the range of an axis with covered numbers is widened, so that its ends give no hint."""


def coverable(scene: type[Scene], picture: Picture) -> set[str]:
    """Return the names of everything that can be covered: parts of the sheet, the numbers in it, and the parts of the
    picture."""
    found = {VALUE + name for name in (*live_names(scene), *picture.values, *picture.live)}
    found |= {f"form:{name}" for name in picture.forms} | {NEXT}
    found |= {f"{kind}:{name}" for name in picture.axes for kind in ("ticks", "numbers")}
    for block in blocks(scene.sheet()):
        if isinstance(block, PlotBlock):
            found |= {PLOT + block.name} | {name for drawn in _drawn(block, picture) for name in drawn.covers}
            found |= {f"mark:{block.name}.{mark.at}" for mark in block.marks}
        elif isinstance(block, WordsBlock):
            found |= {f"form:{item.name}" for item in block.items if item.name}
        elif isinstance(block, StageBlock):
            found.add(STAGE)
        elif isinstance(block, TableBlock):
            found.add(TABLE)
    return found


def checked_covers(scene: type[Scene], picture: Picture, covered: Iterable[str]) -> tuple[str, ...]:
    """Return the covers, each once. Raises ValueError, with a reason, for one that covers nothing in any picture."""
    covers = tuple(dict.fromkeys(covered))
    for refusal in refused_covers(scene, picture, covers).values():
        raise ValueError(refusal)
    return covers


def refused_covers(scene: type[Scene], picture: Picture, covered: Iterable[str]) -> dict[str, str]:
    """Return the covers that cover nothing, each with a sentence for the visitor."""
    known = coverable(scene, picture) if covered else set()
    return {name: f"“{excerpt(name)}” cannot be covered here." for name in covered if name not in known}


def without(scene: type[Scene], picture: Picture, covered: tuple[str, ...]) -> tuple[Picture, tuple[str, ...]]:
    """Return the picture without covered parts, and the names of the quantities that it lacks.

    If a curve is covered, its columns are left out, and its motions with everything that depends on them, unless
    another curve shows them. Shapes that the visitor can drag are drawn at their initial positions.
    """
    if not covered:
        return picture, ()
    covered = (
        *covered,
        *(PLOT + other for name in _named(covered, PLOT) for other in scene.covered_with.get(name, ())),
    )
    drawn = [one for plot in plots(scene) for one in _drawn(plot, picture)]
    hidden = [one for one in drawn if one.covers.intersection(covered) or PLOT + one.plot in covered]
    names = set(_named(covered, VALUE)) | _marks(covered)
    names |= _still(scene) | (_turning(scene) & picture.signals.keys()) if STAGE in covered else set()
    stand = {block.name for block in in_force(scene.sheet(), picture.forms) if isinstance(block, PlotBlock)}
    seen = {name for one in drawn if one not in hidden and one.plot in stand for name in one.signals}
    names |= {name for one in hidden for name in one.signals} - seen
    names = _made_of(picture.signals, names)
    gone = {column for one in hidden for column in one.columns}
    gone -= {column for one in drawn if one not in hidden for column in one.columns}
    texts = names | set(_texts(scene, covered))
    traces, columns = _traces_less(picture, names, gone)
    left = replace(
        picture,
        columns=_columns_less(columns, gone),
        traces=traces,
        axes={name: _covered(name, axis, covered) for name, axis in picture.axes.items()},
        signals=_at_rest(scene, picture, names, STAGE in covered),
        values=_less(picture.values, texts),
        live=_less(picture.live, texts),
        scalars=_less(picture.scalars, names),
        forms={**picture.forms, **{name: "" for name in _named(covered, "form:")}},
    )
    return left, tuple(sorted(texts))


def picture_before_change(
    scene: type[Scene], before: Picture, covered: tuple[str, ...], forms: Mapping[str, str]
) -> tuple[Picture, tuple[str, ...]]:
    """Return the picture from before a change, to be sent while the visitor predicts the next one.

    New covers do not affect its stage, except that their marks are removed. The `forms` of the next picture decide
    which controls are visible.
    """
    left, left_out = without(scene, before, covered)
    on_stage, _ = without(scene, before, covered[: covered.index(NEXT)])
    marks = _marks(covered)
    groups = {group.form.name for group in scene.groups if group.form}
    left = replace(
        left,
        signals=_less(on_stage.signals, _made_of(on_stage.signals, marks)),
        scalars=_less(on_stage.scalars, marks),
        forms={**left.forms, **{name: form for name, form in forms.items() if name in groups}},
    )
    return left, left_out


@dataclass(frozen=True)
class _Drawn:
    """A curve or a band of a plot: the names that cover it, its columns and its motions."""

    plot: str
    covers: frozenset[str]
    columns: frozenset[tuple[str, str]]
    signals: frozenset[str] = frozenset()


def _drawn(plot: PlotBlock, picture: Picture) -> list[_Drawn]:
    colours = {(source, name) for source, one in picture.traces.items() if one.axis for name in one.names}
    modal = [_Drawn(plot.name, frozenset(), frozenset(colours), frozenset({plot.modal}))] if plot.modal else []
    curves = [_curve(plot.name, curve) for curve in plot.curves]
    return [*modal, *curves, *(_band(plot.name, band) for band in plot.regions)]


def _curve(plot: str, curve: Curve) -> _Drawn:
    covers = frozenset(f"curve:{plot}.{name}" for name in (curve.y, curve.group) if name)
    signals = frozenset(name for name in (curve.signal, curve.signal_x) if name)
    return _Drawn(plot, covers, frozenset({(curve.source, curve.x), (curve.source, curve.y)}), signals)


def _band(plot: str, band: Region) -> _Drawn:
    """Return a band; a cover of its curve also covers the band."""
    covers = {f"band:{plot}.{band.low}", *(f"curve:{plot}.{name}" for name in (band.of, band.group) if name)}
    return _Drawn(plot, frozenset(covers), frozenset((band.source, name) for name in (band.x, band.low, band.high)))


def _marks(covered: Iterable[str]) -> set[str]:
    return {name.partition(".")[2] for name in _named(covered, "mark:")}


def _named(covered: Iterable[str], kind: str) -> list[str]:
    return [cover.removeprefix(kind) for cover in covered if cover.startswith(kind)]


def _texts(scene: type[Scene], covered: tuple[str, ...]) -> Iterator[str]:
    """Yield the live numbers in covered parts: the headings of plots, the stage, tables."""
    headings = heading_names(scene)
    open_ = {name for plot, names in headings.items() if PLOT + plot not in covered for name in names}
    yield from (name for plot in _named(covered, PLOT) for name in headings.get(plot, ()) if name not in open_)
    for block in blocks(scene.sheet()):
        if isinstance(block, StageBlock) and STAGE in covered:
            words = (shape.words for shape in block.shapes if isinstance(shape, Label))
            yield from (run.text for runs in words for run in runs if run.kind == "value")
        elif isinstance(block, TableBlock) and TABLE in covered:
            cells = (html for row in block.rows for cell in row for html in cell.variants.values())
            yield from (name for html in cells for name in LIVE.findall(html))


def _traces_less(
    picture: Picture, signals: set[str], gone: set[tuple[str, str]]
) -> tuple[dict[str, Traces], dict[str, Columns]]:
    """Return the remaining traces and columns. If a source also has a hidden signal, columns replace its traces."""
    left = {source: one.less(name for of, name in gone if of == source) for source, one in picture.traces.items()}
    lost = {source for source, one in left.items() if signals & one.needed}
    columns = dict(picture.columns)
    columns |= {source: {**picture.traces[source].drawn, **columns.get(source, {})} for source in lost}
    return {source: replace(one, names=()) if source in lost else one for source, one in left.items()}, columns


def _columns_less(columns: Mapping[str, Mapping[str, Kept]], gone: set[tuple[str, str]]) -> dict[str, dict[str, Kept]]:
    return {
        source: {name: column for name, column in given.items() if (source, name) not in gone}
        for source, given in columns.items()
    }


def _less(given: Mapping[str, Kept], names: set[str]) -> dict[str, Kept]:
    return {name: value for name, value in given.items() if name not in names}


def _at_rest(scene: type[Scene], picture: Picture, names: set[str], all_rest: bool) -> dict[str, AnySignal]:
    """Return the signals without the named ones.

    A named signal that the visitor can drag, or a chain, keeps its initial values. With `all_rest`, every other named
    signal that does not depend on another one is zero.
    """
    begun, held = instant(picture.signals, picture.scalars), _held(scene)
    rest = {
        name: _resting(signal, begun[name] if name in held else 0.0)
        for name, signal in picture.signals.items()
        if name in names and (name in held or isinstance(signal, Modal) or (all_rest and not spoken_of(signal)))
    }
    return {**(picture.signals if all_rest else _less(picture.signals, names)), **rest}


def _resting(signal: AnySignal, start: float) -> AnySignal:
    """Return a signal at rest: a chain in its initial shape, without its frequencies and velocities."""
    if not isinstance(signal, Modal):
        return derived(start)
    shape = tuple(size * math.sin(phase) for size, phase in zip(signal.sizes, signal.phases, strict=True))
    still = {"omega": (0.0,) * len(shape), "phases": (math.pi / 2,) * len(shape), "line": (signal.line[0], 0.0)}
    return changed(signal, sizes=shape, **still)


@cache
def _held(scene: type[Scene]) -> frozenset[str]:
    """Return the motions that a drag on the stage starts. Their initial values are known parameters."""
    stages = (block for block in blocks(scene.sheet()) if isinstance(block, StageBlock))
    grabs = (shape.grab for block in stages for shape in block.shapes if shape.grab)
    return frozenset(begin.of for grab in grabs for begin in grab.start if begin.axis)


@cache
def _still(scene: type[Scene]) -> frozenset[str]:
    """Return scalars that show or hide shapes only on stages of the style "still", so that covering the stage can hide
    them."""
    return _only_on(scene, "still", lambda shape: shape.show)


@cache
def _turning(scene: type[Scene]) -> frozenset[str]:
    """Return motions that are drawn only on stages of the style "turning". They start at their amplitudes, which are
    answers."""
    return _only_on(scene, "turning", _moved_by)


def _only_on(scene: type[Scene], style: str, of: Callable[[AnyShape], Iterable[str]]) -> frozenset[str]:
    """Return names in the shapes on stages of this style that no shape on another stage has."""
    stages = [block for block in blocks(scene.sheet()) if isinstance(block, StageBlock)]
    found, elsewhere = (
        {name for stage in stages if (style in stage.style) is has for shape in stage.shapes for name in of(shape)}
        for has in (True, False)
    )
    return frozenset(found - elsewhere)


def _moved_by(shape: AnyShape) -> Iterator[str]:
    numbers = (getattr(shape, name) for name in shape.__struct_fields__)
    yield from (name for number in numbers if isinstance(number, Expression) for name in names_in(number))


def _covered(name: str, axis: Axis, covered: tuple[str, ...]) -> Axis:
    if f"ticks:{name}" in covered:
        return _rounded(axis, ROOM)
    return _rounded(axis, 0.0) if f"numbers:{name}" in covered else axis


def _rounded(axis: Axis, wider: float) -> Axis:
    """Return the axis over a wider range, with round numbers."""
    room = wider * abs(axis.end - axis.start)
    way = 1 if axis.end > axis.start else -1
    start = axis.start if axis.start == 0 else axis.start - way * room / 2
    wide = changed(axis, start=start, end=axis.end + way * room / 2, ticks=(), labels=())
    return changed(wide, ticks=round_ticks(wide))


def _made_of(signals: Mapping[str, AnySignal], names: set[str]) -> set[str]:
    """Return the names with all signals that depend on one of them, in the order of their dependence."""
    found = set(names)
    for name, signal in signals.items():
        if found & spoken_of(signal):
            found.add(name)
    return found


def spoken_of(signal: AnySignal) -> frozenset[Any]:
    """Return the signals and scalars that a signal depends on."""
    if isinstance(signal, Derived):
        return names_in(signal.value)
    if isinstance(signal, Modal):
        return frozenset((signal.at, signal.of))
    return frozenset((signal.of,)) if isinstance(signal, (SineOf, CosineOf)) else frozenset()


def with_needs(names: Iterable[str], signals: Mapping[str, AnySignal]) -> set[str]:
    """Return the names with all signals and scalars that the signals of these names depend on."""
    wanted = set(names)
    for name, signal in reversed(list(signals.items())):
        if name in wanted:
            wanted |= spoken_of(signal)
    return wanted
