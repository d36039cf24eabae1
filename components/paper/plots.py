"""Plots with their axes, and their items: curves with legend, band and dot; layers; texts in the heading."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from typing import Any, Literal, TypeAlias, TypeVar, Unpack, cast

from msgspec.structs import replace as changed

from components.language.blocks import Block, Column, PlotBlock, Row, StageBlock, WordsBlock
from components.language.expressions import Expression, Number, names_in
from components.language.plots import Curve, Handle, Region, Room, Term
from components.language.shapes import Along, AnyShape, Begin, Grab, Label, Root
from components.language.text import Forms
from components.layout import sheet
from components.layout.grabs import begin, grab
from components.layout.plots import BAND, FLOOR, LATE, RINGING, TIME, USUAL_ROOM, Details, plot
from components.layout.stage import PlotFrame, T
from components.layout.text import plain, rich, runs
from components.paper.deferred import (
    FORMATS,
    Axes,
    Book,
    Deferred,
    ExpressionRecord,
    added,
    computed,
    deferred,
    recorded,
)
from components.paper.plot_axes import PlotAxis
from components.quantities.axes import Axis
from physics.motion import ExactMotion

C = TypeVar("C")
V = TypeVar("V")
PlotValue: TypeAlias = Number | ExactMotion
"""A place or length: an attribute of a case, a motion, 0, or T for the current time."""


class _Unit(float):
    """One unit of an axis."""


UNIT = _Unit(1.0)


@dataclass(frozen=True)
class Plot(PlotFrame):
    """A plot with its axes. Places in it are given in SI units."""

    name: str
    across: PlotAxis = field(compare=False)
    up: PlotAxis = field(compare=False)

    def __post_init__(self) -> None:
        self.up.name = self.up.name or self.name
        self.across.name = self.across.name or f"{self.name}_x"

    def x(self, value: PlotValue) -> Expression:
        """Return the pixel of a value on the horizontal axis."""
        return self.at("x0") + self.across_pixels(value)

    def y(self, value: PlotValue) -> Expression:
        """Return the pixel of a value on the vertical axis."""
        return self.at("y0") + self.per_y * on_axis(self.up, value)

    def across_pixels(self, value: PlotValue) -> Expression:
        """Return a length along the horizontal axis in pixels."""
        return self.per_x * on_axis(self.across, value)

    def up_pixels(self, value: PlotValue) -> Expression:
        """Return a height along the vertical axis in pixels."""
        return -1 * self.per_y * on_axis(self.up, value)

    def share(self, value: PlotValue) -> Expression:
        """Return a value divided by the upper end of the vertical axis."""
        return share(self.up, value)

    def text(self, value: float) -> str:
        """Return a live number in the unit of the vertical axis."""
        own = recorded(value)
        return own.book.text(own, self._write)

    def _write(self, value: float, axes: Axes) -> str:
        return axes[self.up.name].number(value)

    @property
    def unit(self) -> str:
        """The unit of the vertical axis, in a text."""
        return self.up.unit_text

    def in_frame(self, case: C, name: str, of: Callable[[C, Axis, Axis], V | None], optional: bool = False) -> V:
        """Return a deferred value that depends on the case and on both axes as drawn, which may be wider than the
        fitted ones.

        If it is `optional` it may be None.
        """

        def compute(known: C, axes: Axes) -> V | None:
            found, key = vars(known), f"{name} in frame"
            if key not in found or found[key][0] is not axes:
                found[key] = axes, of(known, axes[self.across.name], axes[self.up.name])
            value: V | None = found[key][1]
            return value

        return cast(V, computed(case, name, compute, optional))

    def block(
        self, *items: PlotItem, title: str, over: Iterable[AnyShape] = (), room: Room = USUAL_ROOM,
        **details: Unpack[Details],
    ) -> Block:  # fmt: skip
        """Return the plot as a block of the sheet, with shapes drawn `over` it.

        The first item is drawn on top and comes first in the heading.
        """
        drawn = next(one.recorded for one in items if isinstance(one, DrawnItem))
        drawn.book.plots[self.name] = BuiltPlot(self, items)
        details["shapes"] = tuple(over)
        return plot(
            self,
            x=self.across,
            y=self.up,
            title=title,
            curves=[line for one in reversed(items) for line in one.lines(self)],
            bands=[band for one in _from_below(items) for band in one.bands(self)],
            heading=[term for one in items for term in one.terms()],
            x_column=None if self.across.is_time else self.across,
            cursor="time" if self.across.is_time or self.up.is_time else "",
            room=room,
            **details,
        )


def counted(value: V, axis: PlotAxis) -> V:
    """Return an attribute, to be given in the unit of an axis in texts too. For attributes that no plot shows."""
    recorded(value).expression(axis)
    return value


def on_axis(axis: PlotAxis, value: object) -> Expression | float:
    """Return a value in the unit of an axis. Raises TypeError for a constant, because its SI unit is unknown."""
    if isinstance(value, Deferred):
        return recorded(value).expression(axis)
    if value is T:
        return T
    if value is UNIT or (isinstance(value, (int, float)) and not value):
        return float(value)
    raise TypeError(f"{value!r} has no place before there is an axis: make it an attribute of the case")


def share(axis: PlotAxis, value: PlotValue) -> Expression:
    """Return a value divided by the upper end of an axis."""
    return axis.share * on_axis(axis, value)


@dataclass(frozen=True, eq=False)
class EitherText:
    """A text in several variants; an expression of the case chooses one."""

    recorded: ExpressionRecord
    variants: dict[str, str]

    def forms(self) -> Forms:
        name = self.recorded.book.form(self.recorded, self.variants)
        return Forms({word: rich(text) for word, text in self.variants.items()}, name)


def either(of: object, /, **variants: str) -> EitherText:
    """Return a text with variants: one for each word of an attribute, or `yes` and `no` for a condition."""
    return EitherText(recorded(of), variants)


Legend: TypeAlias = str | EitherText


class PlotItem:
    """Anything that a plot or its heading shows."""

    def lines(self, plot: Plot) -> list[Curve]:
        return []

    def bands(self, plot: Plot) -> list[Region]:
        return []

    def terms(self) -> list[Term]:
        return []


@dataclass(frozen=True, eq=False)
class DrawnItem(PlotItem):
    """A deferred motion, or a pair of columns, that a plot shows."""

    of: object

    @property
    def recorded(self) -> ExpressionRecord:
        return recorded(self.of)


@dataclass(frozen=True, eq=False)
class PlottedCurve(DrawnItem):
    """A curve of a motion over time, or of two `columns` of a table, which an expression gives by their names.

    `legend` is LaTeX in the heading, or plain `words`; `label` names it at its right end and `read` at the pointer.
    `fast` says how a motion too fast for a line is drawn: as its band, as its mean, or as a band that ends in a line
    when the motion has decayed. `fill` is the opacity of the area between the curve and 0; the column "zero" is its
    lower edge. `dot` moves a dot along the curve; for two columns it is the position of the dot. Curves of one `group`
    are switched off together.
    """

    width: Literal["sum", "line", "dash", "dots", "thin", "none"] = "line"
    tint: str = "ink"
    marker: Literal["", "disc", "ring"] = ""
    legend: Legend = ""
    words: Legend = ""
    label: str = ""
    read: str = ""
    group: str = ""
    columns: tuple[str, str] | None = None
    fast: Literal["band", "ringing", "mean", ""] = ""
    fill: float = 0.0
    dot: bool | tuple[object, object] = False

    @property
    def switch(self) -> str:
        return self.group or (self.columns[1] if self.columns else self.recorded.name)

    def lines(self, plot: Plot) -> list[Curve]:
        name = self.recorded.name
        look: dict[str, Any] = {"group": self.switch, "tint": self.tint, "width": self.width, "marker": self.marker}
        look |= {"label": runs(self.label), "read": plain(self.read or self.label)}
        if self.columns:
            x, y = self.columns
            return [Curve(source=name, x=x, y=y, **self._dot(plot), **look)]
        self.recorded.expression(plot.up)
        late = [Curve(source=LATE, x="t", y=name, **{**look, "label": ()})] if self.fast == RINGING else []
        return [Curve(source=TIME, x="t", y=name, signal=name if self.dot else "", **look), *late]

    def _dot(self, plot: Plot) -> dict[str, Any]:
        """The names of the numbers with the position of the dot, for a curve of two columns."""
        if not isinstance(self.dot, tuple):
            return {}
        x, y = self.dot
        return {"signal_x": number_name(x, plot.across), "signal": number_name(y, plot.up)}

    def bands(self, plot: Plot) -> list[Region]:
        name, look = self.recorded.name, {"tint": self.tint, "group": self.switch}
        sources = {"band": [BAND], "ringing": [BAND, RINGING]}.get(self.fast, [])
        found = [_region(f"{name}_lo", f"{name}_hi", source, alpha=0.4, of=name, **look) for source in sources]
        x, y, source = (*self.columns, name) if self.columns else ("t", name, TIME)
        return [*found, *([_region(FLOOR, y, source, x=x, alpha=self.fill, **look)] if self.fill else [])]

    def terms(self) -> list[Term]:
        key = "line" if self.width == "thin" else self.width
        of = None if self.columns else self.recorded
        if self.words:
            return [_term(self.words, key, self.tint, self.switch, of, is_formula=False)]
        return [_term(self.legend, key, self.tint, self.switch, of)] if self.legend else []


@dataclass(frozen=True, eq=False)
class PlottedPath(DrawnItem):
    """The path of two motions in a plane, with a dot: this one over the other one, `against`.

    It covers the time window, or the interval of the case that has the name `source`.
    """

    against: object
    tint: str = "ink"
    source: str = TIME
    group: str = ""

    def lines(self, plot: Plot) -> list[Curve]:
        x, y = number_name(self.against, plot.across), number_name(self.of, plot.up)
        group = self.group or y
        return [Curve(source=self.source, x=x, y=y, signal_x=x, signal=y, tint=self.tint, group=group)]


@dataclass(frozen=True, eq=False)
class PlottedLayer(DrawnItem):
    """A layer of a stack. Its upper edge is `top`, the sum of itself and the layers under it; the lowest layer has no
    `top`.

    Its legend is LaTeX, or plain `words`; it can be hidden if it has a `switch`.
    """

    tint: str
    top: object = None
    legend: str = ""
    words: str = ""
    read: str = ""
    switch: bool = True
    below: str = FLOOR

    @property
    def group(self) -> str:
        return self.recorded.name if self.switch else ""

    @property
    def edge(self) -> ExpressionRecord:
        return self.recorded if self.top is None else recorded(self.top)

    def bands(self, plot: Plot) -> list[Region]:
        for one in (self.recorded, self.edge):
            one.expression(plot.up)
        return [
            _region(self.below, self.edge.name, tint=self.tint, group=self.group, read=plain(self.read))
        ]  # fmt: skip

    def terms(self) -> list[Term]:
        text, is_formula = self.words or self.legend, not self.words
        return [_term(text, "band", self.tint, self.group, self.recorded, is_formula)]


@dataclass(frozen=True, eq=False)
class PlottedNote(PlotItem):
    """A text in a heading."""

    text: Legend
    tint: str = "ink"

    def terms(self) -> list[Term]:
        return [_term(self.text, "none", self.tint, is_formula=False)]


curve, layer, note, path = PlottedCurve, PlottedLayer, PlottedNote, PlottedPath


def stack(*layers: PlottedLayer) -> list[PlottedLayer]:
    """Return layers on top of each other, the lowest first. Layers too fast to draw are drawn as their means.

    The `top` of a layer defaults to the sum of itself and the layers under it. Files have no column of that sum.
    """
    found: list[PlottedLayer] = []
    under: list[ExpressionRecord] = []
    for one in layers:
        under = [*under, one.recorded] if one.top is None else [one.edge]
        if found and one.top is None:
            one = replace(one, top=added(under))
        found.append(replace(one, below=found[-1].edge.name if found else FLOOR))
    return found


def _region(low: str, high: str, source: str = TIME, **look: Any) -> Region:
    return Region(**{"source": source, "x": "t", "low": low, "high": high, **look})


def _term(
    legend: Legend, key: str, tint: str, group: str = "", of: ExpressionRecord | None = None, is_formula: bool = True
) -> Term:  # fmt: skip
    """A term of a heading. If its curve is not drawn, the term is hidden too."""
    form, texts = group, {"formula": legend} if isinstance(legend, str) else legend.variants
    if isinstance(legend, EitherText):
        form = legend.recorded.book.form(legend.recorded, legend.variants, group)
    elif of and of.optional:
        form = of.book.form(of, ["formula"], group)
    variants = {word: rich(f"${text}$" if is_formula and text else text) for word, text in texts.items()}
    return Term(curve=group, form=form, key=key, tint=tint, variants=variants)  # type: ignore[arg-type]


def _from_below(items: Iterable[PlotItem]) -> list[PlotItem]:
    """The items in the order in which their areas are drawn: layers as they are stacked, curves from the lowest."""
    curves = [one for one in items if isinstance(one, PlottedCurve)]
    return [*reversed(curves), *(one for one in items if not isinstance(one, PlottedCurve))]


def words(*paragraphs: str | EitherText, **look: Any) -> Block:
    """Return sentences and formulas as a block: see `components.layout.sheet.words`."""
    return sheet.words(*(one.forms() if isinstance(one, EitherText) else one for one in paragraphs), **look)


def number_name(of: object, on: PlotAxis | None = None) -> str:
    """Return the name of an attribute as a number of the picture, counted on an axis or in SI units."""
    own = recorded(of)
    return own.book.number(own, on)


def text_name(of: object) -> str:
    """Return the name of an attribute as a text of the picture."""
    own = recorded(of)
    own.book.text(own, FORMATS[""])
    return own.name


def along(
    across: Literal["x", "y"], place: Callable[[PlotValue], Number], on: PlotAxis, *, rate: str = "",
    least: float | None = None, **sets: object,
) -> Along:  # fmt: skip
    """Return a rule for dragging a shape along x or y, which sets a parameter.

    `sets` maps the parameter to the motion or attribute that follows the pointer at once, in the unit of the axis `on`.
    `place` returns the pixel of a value. `rate` is the parameter for the velocity of a throw. The parameter is not set
    below `least`.
    """
    ((parameter, of),) = sets.items()
    zero, axis = place(0.0), on.counting
    return Along(
        across=across, zero=zero, unit=place(UNIT) - zero, parameter=parameter, moves=number_name(of, axis),
        axis=axis.name, rate=rate, least=least,
    )  # fmt: skip


def drag(label: str, *ways: Along) -> Grab:
    """Return a grab that starts a motion where the shape is released. It starts at rest, or with the velocity of a
    throw."""
    starts = [Begin(one.parameter, one.moves, one.axis) for one in ways]
    return begin(label, *ways, start=(*starts, *(Begin(one.rate) for one in ways if one.rate)))


def handle(of: float, **look: Any) -> Handle:
    """Return a handle on an axis that shows a number of the case: see `components.language.plots.Handle`."""
    return Handle(text=text_name(of), **look)


@dataclass(frozen=True)
class PictureName:
    """The name of a form or of a number of a picture."""

    name: str


def form_of(condition: object) -> PictureName:
    """Return the form that shows a block or a group of controls while a condition of the case holds."""
    own = recorded(condition)
    return PictureName(own.book.form(own, ["shown"]))


def when(condition: object, block: Block) -> Block:
    """Return the block, shown only while a condition of the case holds."""
    return sheet.when(form_of(condition), block)


def hold_root(label: str, on: Plot, zero: Number, unit: Number, *, moves: object, **more: Any) -> Grab:
    """Return a grab for dragging a root of s^2 + 2 z s + 1: see `components.language.shapes.Root`."""
    return grab(label, Root(across="x", zero=zero, unit=unit, moves=number_name(moves), **more), inside=on)


def shown_by(condition: object, *shapes: AnyShape) -> list[AnyShape]:
    """Return the shapes, drawn only while a condition of the case holds."""
    name = number_name(condition)
    return [changed(one, show=(name, *one.show)) for one in shapes]


@dataclass(frozen=True, eq=False)
class BuiltPlot:
    """A plot of a paper with its items."""

    plot: Plot
    items: tuple[PlotItem, ...]


def settled(block: Block, book: Book) -> Block:
    """Return the finished block: shapes are hidden while their numbers are missing, and texts have all variants of
    their form."""
    if isinstance(block, (Row, Column)):
        return changed(block, blocks=tuple(settled(one, book) for one in block.blocks))
    if isinstance(block, WordsBlock):
        return changed(block, items=tuple(_padded(one, one.name, book) for one in block.items))
    if isinstance(block, PlotBlock):
        block = changed(block, heading=tuple(_padded(one, one.form, book) for one in block.heading))
    if isinstance(block, (StageBlock, PlotBlock)):
        return changed(block, shapes=tuple(_needing(one, book) for one in block.shapes))
    return block


Worded = TypeVar("Worded", Forms, Term)


def _padded(one: Worded, form: str, book: Book) -> Worded:
    """A text with variants, with an empty one for each word of the form that it lacks."""
    known = book.forms[form].words if form in book.forms else ()
    return changed(one, variants={**dict.fromkeys(known, ""), **one.variants})


def _needing(shape: AnyShape, book: Book) -> AnyShape:
    """A shape with expressions in place of attributes, hidden while one of its numbers or texts is missing."""
    given = {name: getattr(shape, name) for name in shape.__struct_fields__}
    numbers = {name: recorded(one).expression() for name, one in given.items() if isinstance(one, Deferred)}
    for name in given["show"]:
        if name not in book.numbers and hasattr(book.kind, name):  # for shapes of other packages
            recorded(getattr(deferred(book.kind), name)).expression()
    expressions = [one for one in (given | numbers).values() if isinstance(one, Expression)]
    names = [name for one in expressions for name in sorted(names_in(one))]
    texts = [run.text for run in shape.words if run.kind == "value"] if isinstance(shape, Label) else []
    return changed(shape, **numbers, show=tuple(dict.fromkeys((*given["show"], *book.flagged(names, texts)))))
