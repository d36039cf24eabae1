"""The plots: Bokeh figures without data, built once per process and used by every visitor's browser.

A session has only the numbers. A figure has the names of its columns; the browser fills them with the numbers of each
message, and draws the time cursor, the labels at the ends of curves and the handles over the figure.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Any, TypedDict, Unpack

import numpy as np
from bokeh.document import Document
from bokeh.models import ColumnDataSource, FixedTicker, Line, Range1d, Scatter, Span, VArea
from bokeh.models import Plot as BokehPlot
from bokeh.plotting import figure
from msgspec.structs import replace

from components.language.blocks import Block, PlotBlock, Row
from components.language.blocks import Column as ColumnBlock
from components.language.expressions import Name, called
from components.language.plots import Curve, Handle, Mark, Region, Term
from components.language.plots import Room as Room
from components.language.shapes import AnyShape
from components.layout.stage import PlotFrame
from components.layout.text import plain as plain_text
from components.layout.text import runs
from components.quantities.declared import Column, Named

TIME = "time"
"""The source of the curves over the time window."""
BAND = "band"
"""The source of the bands that replace curves too fast to be drawn."""
RINGING, LATE = "ringing", "late"
"""The sources of bands that end when the fast part of a motion has decayed, and of the lines that follow them."""
FLOOR = "zero"
"""The column of zeros at the bottom of a stack of layers; files leave it out."""
USUAL_ROOM = Room()
NUMBERS = 30
"""Height in pixels of the numbers under a plot, the same for all plots, so that neighbours have equal frames."""
HEADING = 24
"""Height in pixels of the heading over a plot, the same for all plots."""
DASHES = {"dash": [7, 5], "dots": [1, 3]}


def curve(y: Name, *, source: str = "", x: Name | None = None, label: str = "", read: str = "", **look: Any) -> Curve:
    """Return a line of a plot: a column, or a signal over time. `x` defaults to the abscissa of the plot.

    `label` is at its right end and in the tooltip, `read` only in the tooltip. `group` defaults to `y`. The other
    fields are described in components.language.plots.Curve.
    """
    named = {"group": y.name, "label": runs(label), "read": plain_text(read or label)}
    return Curve(y=y.name, source=source or _source(y), x=called(x), **(named | _named(look)))


def region(
    low: Name,
    high: Name,
    *,
    source: str = "",
    x: Name | None = None,
    label: str = "",
    read: str = "",
    **look: Any,
) -> Region:
    """Return a filled region between two columns or signals over time: a band, or a layer of a stack."""
    ends = {"low": low.name, "high": high.name, "source": source or _source(low), "x": called(x)}
    return Region(label=runs(label), read=plain_text(read or label), **(ends | _named(look)))


def _source(one: Name) -> str:
    """Return the source of a column; for a signal, the source of its curve over time."""
    return one.source if isinstance(one, Column) else "time"


def _named(look: dict[str, Any]) -> dict[str, Any]:
    """Replace declared objects by their names."""
    return {key: value.name if isinstance(value, Named) else value for key, value in look.items()}


def mark(at: Name, **look: Any) -> Mark:
    """Return a line with a flag at a scalar: components.language.plots.Mark."""
    return Mark(at=at.name, **_named(look))


class Details(TypedDict, total=False):
    """The fields of a plot that are passed on to components.language.blocks.PlotBlock, which explains them."""

    says: dict[str, str]
    handles: tuple[Handle, ...]
    marks: tuple[Mark, ...]
    shapes: tuple[AnyShape, ...]
    square: bool
    plain: bool
    x_labels: bool
    pick: str
    modal: str
    full: str
    form: Name
    style: str
    grow: float
    basis: int
    phone: int
    height: int


USUAL: Details = {
    "says": {},
    "handles": (),
    "marks": (),
    "shapes": (),
    "square": False,
    "plain": False,
    "x_labels": True,
    "pick": "",
    "modal": "",
    "full": "",
    "grow": 1,
    "basis": 0,
    "phone": 50,
    "height": 130,
}


def plot(
    frame: PlotFrame,
    *,
    x: Name,
    y: Name,
    title: str,
    curves: Iterable[Curve] = (),
    bands: Iterable[Region] = (),
    heading: Sequence[Term] = (),
    x_column: Name | None = None,
    room: Room = USUAL_ROOM,
    cursor: str = "",
    **details: Unpack[Details],
) -> PlotBlock:
    """Return a plot as a block of the sheet.

    `x` and `y` are axes of the picture, `title` is for screen readers. `x_column` has the abscissae, by default times.
    `cursor="time"` draws a draggable line at the current instant. `shapes` over the plot use its `PlotFrame`.
    """
    given: Details = {**USUAL, **details}
    given["x_labels"] = x_labels = given["x_labels"] and not given["plain"]
    room = replace(room, bottom=NUMBERS if x_labels else room.bottom)
    given["basis"] += (NUMBERS if room.bottom == NUMBERS else 0) + (HEADING if heading else 0)
    drawn = tuple(replace(one, x=one.x or called(x_column) or "t") for one in curves)
    filled = tuple(replace(one, x=one.x or called(x_column) or "t") for one in bands)
    return PlotBlock(
        part=frame.part,
        name=frame.name,
        title=title,
        brief=re.split("[,:]", title)[0],
        x=x.name,
        y=y.name,
        curves=drawn,
        regions=filled,
        heading=tuple(heading),
        room=room,
        cursor=bool(cursor),
        time=cursor == "time",
        **_named({**given, "figure": {}}),
    )


def with_figures(block: Block) -> Block:
    """Return a block whose plots have their figures, which only the browser needs."""
    if isinstance(block, (Row, ColumnBlock)):
        return replace(block, blocks=tuple(map(with_figures, block.blocks)))
    return replace(block, figure=_written(figure_of(block))) if isinstance(block, PlotBlock) else block


def figure_of(block: PlotBlock) -> BokehPlot:
    """Return a new figure of a plot for one visitor, without data."""
    figure_ = _figure(block.curves, block.regions, block.room, block.x_labels, block.plain)
    if block.modal:  # no grid lines, because they would cross the picture of a chain under the curves
        figure_.xgrid.visible = figure_.ygrid.visible = False
    return figure_


def _figure(
    curves: tuple[Curve, ...], regions: tuple[Region, ...], room: Room, x_labels: bool, plain: bool
) -> BokehPlot:
    figure_ = figure(
        tools="",
        toolbar_location=None,
        sizing_mode="stretch_both",
        x_range=Range1d(0, 1),
        y_range=Range1d(0, 1),
        min_border=0,
        min_border_left=room.left,
        min_border_right=room.right,
        min_border_top=room.top,
        min_border_bottom=room.bottom,
        outline_line_color=None,
        background_fill_color=None,
        border_fill_color=None,
        output_backend="canvas",
        lod_threshold=None,
    )
    _glyphs(figure_, curves, regions)
    _lines(figure_, x_labels, plain)
    return figure_


def _written(figure_: BokehPlot) -> dict[str, Any]:
    """Return a Bokeh document with only this figure, as JSON."""
    document = Document()
    document.add_root(figure_)
    return dict(document.to_json(deferred=False))


def _glyphs(figure_: BokehPlot, curves: tuple[Curve, ...], regions: tuple[Region, ...]) -> None:
    """Draw regions, and curves over them.

    A renderer is named by its index in the block, "regions.0", so that the browser finds its colour, width and group.
    """
    sources = _sources(curves, regions)
    for n, one in enumerate(regions):
        area = VArea(x=one.x, y1=one.low, y2=one.high, fill_alpha=one.alpha)
        figure_.add_glyph(sources[one.source], area, name=f"regions.{n}")
    for n, line in enumerate(curves):
        source, place, name = sources[line.source], {"x": line.x, "y": line.y}, f"curves.{n}"
        if line.width != "none":
            dash = DASHES.get(line.width, [])
            figure_.add_glyph(source, Line(**place, line_dash=dash, line_join="round"), name=name)
        if line.marker:
            figure_.add_glyph(source, Scatter(**place, size=9), name=name)


def _sources(curves: tuple[Curve, ...], regions: tuple[Region, ...]) -> dict[str, ColumnDataSource]:
    """Return the sources by name, with empty columns."""
    columns: dict[str, set[str]] = {}
    for curve_ in curves:
        columns.setdefault(curve_.source, set()).update((curve_.x, curve_.y))
    for one in regions:
        columns.setdefault(one.source, set()).update((one.x, one.low, one.high))
    empty = np.empty(0, np.float32)
    return {
        name: ColumnDataSource(name=name, data=dict.fromkeys(sorted(columns[name]), empty)) for name in sorted(columns)
    }


def _lines(figure_: BokehPlot, x_labels: bool, plain: bool) -> None:
    """Add axes without lines, grid lines at their numbers, and lines at zero."""
    for axis in (*figure_.xaxis, *figure_.yaxis):
        axis.ticker = FixedTicker(ticks=[])
        axis.axis_line_color = axis.minor_tick_line_color = axis.major_tick_line_color = None
        axis.major_label_text_font_size = "13px"
        axis.major_label_standoff = 5
    for grid in (*figure_.xgrid, *figure_.ygrid):
        grid.ticker = figure_.xaxis[0].ticker if grid.dimension == 0 else figure_.yaxis[0].ticker
    figure_.xaxis.visible, figure_.yaxis.visible = x_labels, False
    zeros = ["width"]
    if plain:
        figure_.xgrid.visible = figure_.ygrid.visible = False
        zeros.append("height")
    for dimension in zeros:
        figure_.add_layout(Span(location=0, dimension=dimension, line_width=1, level="underlay"))
