"""The picture of a case: everything that its paper needs, computed for one case in one frame."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Any

from components.language.blocks import Block
from components.language.picture import Digits
from components.language.signals import AnySignal
from components.language.state import Frame
from components.layout.sheet import needed_names
from components.paper.deferred import FORMATS, Book, CountedNumber, ExpressionRecord, attributes, recorded
from components.paper.plot_axes import PlotAxis
from components.paper.plots import PlottedCurve, PlottedLayer, PlottedPath
from components.quantities.axes import ONE, Axis
from components.quantities.motion import derived
from components.scene.case_curves import CaseCurves, exact_values
from components.scene.case_signals import signals_of
from components.scene.frames import framed
from components.scene.picture import Picture
from components.scene.traces import FLOOR, TIME, Columns, Traces
from physics.motion import ExactMotion, constant


@dataclass(frozen=True, eq=False)
class CasePaper:
    """The paper of a scene: its sheet, and everything that it needs from a case.

    `names`       the names in the sheet, or in its visible part
    `axes`        the axes of the plots, and the axes that give the stage its scale, by name
    `other_axes`  axes that belong to no plot and are used only to format numbers, by name; their ranges are always
                  fitted
    """

    block: Block
    book: Book
    names: frozenset[str]
    axes: dict[str, PlotAxis]
    other_axes: dict[str, PlotAxis]

    @classmethod
    def of(cls, block: Block, book: Book) -> CasePaper:
        names = needed_names([block])
        plots = [built.plot for built in book.plots.values()]
        used = {use.axis.name: use.axis for use in book.numbers.values() if use.axis}
        axes = {axis.name: axis for plot in plots for axis in (plot.across, plot.up)}
        axes |= {name: axis for name, axis in used.items() if f"{name}_share" in names}
        return cls(block, book, names, axes, {name: axis for name, axis in used.items() if name not in axes})

    def part(self, names: frozenset[str]) -> CasePaper:
        """Return the paper of a picture that has only these names, on the same axes."""
        return replace(self, book=self.book.part(names), names=names)

    @cached_property
    def named(self) -> list[str]:
        """The names of all attributes, in the order of their class; a file has its columns in this order too."""
        return list(dict.fromkeys(one.called for one in attributes(self.book.kind)))

    @cached_property
    def numbers(self) -> dict[str, CountedNumber]:
        """All numbers by name, attributes first."""
        known = self.book.numbers
        return {name: known[name] for name in (*(name for name in self.named if name in known), *known)}

    @cached_property
    def curves(self) -> list[PlottedCurve]:
        """The curves of motions over time."""
        items = [item for built in self.book.plots.values() for item in built.items]
        return [item for item in items if isinstance(item, PlottedCurve) and not item.columns]

    @cached_property
    def tables(self) -> dict[str, ExpressionRecord]:
        """The expressions of curves that have a column for x and one for y, by name, in the order of their plots."""
        items = [item for built in self.book.plots.values() for item in built.items]
        return {item.recorded.name: item.recorded for item in items if isinstance(item, PlottedCurve) and item.columns}

    @cached_property
    def paths(self) -> dict[str, list[str]]:
        """The names of motions that paths show over the time window or other intervals, by source, ordered as
        `numbers`."""
        items = [one for built in self.book.plots.values() for one in built.items if isinstance(one, PlottedPath)]
        found: dict[str, set[str]] = {}
        for one in items:
            found.setdefault(one.source, set()).update((recorded(one.against).name, one.recorded.name))
        return {source: sorted(names, key=list(self.numbers).index) for source, names in found.items()}

    @cached_property
    def layers(self) -> dict[str, tuple[str, str]]:
        """The names of the lower and the upper edge of each layer. The lowest layer is left out: it begins at 0, so
        its values are its upper edge."""
        items = [one for built in self.book.plots.values() for one in built.items if isinstance(one, PlottedLayer)]
        return {one.recorded.name: (one.below, one.edge.name) for one in items if one.top is not None}

    @cached_property
    def stacks(self) -> list[list[str]]:
        """The edges of each stack, from the lowest up."""
        stacks = [[one for one in built.items if isinstance(one, PlottedLayer)] for built in self.book.plots.values()]
        return [[FLOOR, *(one.edge.name for one in layers)] for layers in stacks if layers]

    @cached_property
    def fast(self) -> dict[str, str]:
        """The drawing of each motion if it is too fast for a line, by name: "band", "mean", ..."""
        edges = {edge: "mean" for stack in self.stacks for edge in stack}
        return edges | {one.recorded.name: one.fast for one in self.curves}

    @cached_property
    def drawn(self) -> list[str]:
        """The names of the curves and paths over time and of the edges of stacks, in the order of their columns."""
        edges = {edge for stack in self.stacks for edge in stack}
        lines = {*self.paths.get(TIME, ()), *(one.recorded.name for one in self.curves)}
        names = sorted({*edges, *lines} - {FLOOR}, key=list(self.numbers).index)
        first = next((place for place, name in enumerate(names) if name in edges), 0)
        return [*names[:first], *([FLOOR] if edges else []), *names[first:]]

    @cached_property
    def units(self) -> dict[str, str]:
        """The axes whose unit is shown in a text, by the name of the text."""
        known = self.axes | self.other_axes
        return {text: name for name in known if (text := f"{name}_unit") in self.names}

    @cached_property
    def shares(self) -> dict[str, str]:
        """The axes whose upper end shapes use, by the name of the number."""
        return {share: name for name in self.axes if (share := f"{name}_share") in self.names}

    @cached_property
    def has_floor(self) -> bool:
        return bool(self.stacks) or any(one.fill for one in self.curves)


@dataclass(frozen=True, eq=False)
class CasePicture:
    """The picture of a case: the values of everything that its paper uses."""

    paper: CasePaper
    case: Any
    frame: Frame

    @cached_property
    def framed(self) -> dict[str, Axis]:
        return framed(self.frame, {name: one.axis(self.case) for name, one in self.paper.axes.items()})

    @cached_property
    def axes(self) -> dict[str, Axis]:
        """All axes, by name."""
        return self.framed | {name: one.axis(self.case) for name, one in self.paper.other_axes.items()}

    @cached_property
    def numbers(self) -> dict[str, tuple[Any, Axis]]:
        """All numbers that have a value, with their axes."""
        found: dict[str, tuple[Any, Axis]] = {}
        case, axes = self.case, self.axes
        for name, (of, on) in self.paper.numbers.items():
            value = of.compute(case, axes)
            if value is not None:
                found[name] = (value, axes[on.name] if on else ONE)
            elif of.optional is None:
                raise TypeError(f"{of.text} is None: make it an optional attribute")
        return found

    @cached_property
    def moving(self) -> dict[str, tuple[ExactMotion, Axis]]:
        return {name: (value, axis) for name, (value, axis) in self.numbers.items() if isinstance(value, ExactMotion)}

    @property
    def signals(self) -> dict[str, AnySignal]:
        base: dict[str, AnySignal] = {FLOOR: derived(0.0)} if self.paper.has_floor else {}
        return base | signals_of(self.moving, self.axes["t"])

    @cached_property
    def curves(self) -> CaseCurves:
        motions = {FLOOR: constant(0.0)} | {name: one for name, (one, _) in self.moving.items()}
        drawn = {name: motions[name] for name in self.paper.drawn if name in motions}
        stacks = list(map(frozenset, self.paper.stacks))
        named, layers = frozenset(self.paper.named), self.paper.layers
        return CaseCurves(self.case, drawn, self.paper.fast, stacks, motions, layers, named)

    @property
    def traces(self) -> dict[str, Traces]:
        """The curves over the time window, and the paths over other intervals."""
        found = {TIME: self.curves.traces} if self.paper.drawn else {}
        for source, names in self.paper.paths.items():
            if source == TIME:
                continue
            motions = {name: self.moving[name][0] for name in names if name in self.moving}
            end, count = self.case.intervals[source]
            found[source] = Traces(end, count, tuple(motions), partial(exact_values, motions))
        return found

    @property
    def columns(self) -> dict[str, Columns]:
        tables = self.paper.tables.items()
        return {name: of.compute(self.case, self.axes) or {} for name, of in tables} | self.curves.columns

    @property
    def scalars(self) -> dict[str, float]:
        found = {
            name: axis.place(value) if axis is not ONE else float(value)
            for name, (value, axis) in self.numbers.items() if name not in self.moving
        }  # fmt: skip
        ends = {share: self.axes[name] for share, name in self.paper.shares.items()}
        found |= {share: 1 / axis.place(axis.end) for share, axis in ends.items()}
        flags = self.paper.book.flags.items()
        return found | {flag: float(of.compute(self.case, self.axes) is not None) for flag, of in flags}

    @cached_property
    def texts(self) -> tuple[dict[str, str], dict[str, Digits]]:
        """The texts of the live numbers, and the formats of those that move."""
        case, axes, live = self.case, self.axes, dict[str, Digits]()
        values = {text: axes[name].full_unit for text, name in self.paper.units.items()}
        for name, (of, write) in self.paper.book.texts.items():
            value = of.compute(case, axes)
            if value is None or isinstance(value, str):
                values[name] = value or ""
            elif isinstance(value, ExactMotion):
                live[name] = self.moving[name][1].digits(write is FORMATS["+"])
            else:
                values[name] = write(value, axes)
        return values, live

    @property
    def forms(self) -> dict[str, str]:
        forms = self.paper.book.forms.items()
        return {name: form.word(form.of.compute(self.case, self.axes)) for name, form in forms}

    @property
    def picture(self) -> Picture:
        return Picture(
            columns=self.columns,
            axes=self.framed,
            signals=self.signals,
            traces=self.traces,
            scalars=self.scalars,
            pace=self.case.pace,
            scale=self.case.scale,
            fits=self.case.fits,
            values=self.texts[0],
            live=self.texts[1],
            forms=self.forms,
            notes=self.case.notes(),
            to_scale=self.case.to_scale(),
            onward=self.case.onward(),
            spans=self.case.spans,
        )
