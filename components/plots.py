"""The plots: Bokeh figures without data, built once a process and mounted by every visitor's browser.

A session owns only its numbers. A figure knows the names of its columns; the browser fills them from the one message
that answers a change, and draws the time cursor, the labels at the curves' ends and the handles over the figure.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from bokeh.embed import json_item
from bokeh.models import ColumnDataSource, FixedTicker, Range1d, Span
from bokeh.models import Plot as BokehPlot
from bokeh.plotting import figure

from components.sheet import Block
from components.stage import Shape


@dataclass(frozen=True, kw_only=True)
class Curve:
    """A line of a plot: column `name` of `source`, coloured as the quantity `tint`.

    `signal` names the motion that moves a dot along it; `label` stands at its right end and in the read-out at the
    pointer, `read` there alone; `group` is the name by which it is switched off (its own where not given). `x` is its
    column of abscissae where not the plot's. With a `marker` ("disc" or "ring") its points are marked; with width
    "none" only they are drawn.
    """

    name: str
    source: str = "time"
    tint: str = "ink"
    width: str = "line"
    label: str = ""
    read: str = ""
    signal: str = ""
    group: str = ""
    x: str = ""
    marker: str = ""


@dataclass(frozen=True, kw_only=True)
class Band:
    """A filled region between the columns `low` and `high`: an envelope, or a layer of a stack."""

    low: str
    high: str
    source: str = "time"
    tint: str = "ink"
    alpha: float = 1.0
    group: str = ""
    label: str = ""


WIDTHS = {"sum": 3.0, "line": 1.75, "dash": 1.75, "dots": 1.0, "thin": 1.0}
DASHES = {"dash": [7, 5], "dots": [1, 3]}


def plot(
    name: str,
    *,
    x: str,
    y: str,
    title: str,
    curves: tuple[Curve, ...] = (),
    bands: tuple[Band, ...] = (),
    heading: tuple[dict[str, Any], ...] = (),
    source: str = "time",
    x_column: str = "t",
    x_labels: bool = True,
    margin: tuple[int, int] = (40, 56),
    top: int = 4,
    cursor: str = "",
    handles: tuple[dict[str, Any], ...] = (),
    marks: tuple[dict[str, Any], ...] = (),
    square: bool = False,
    grow: float = 1,
    basis: int = 0,
    phone: int = 50,
    height: int = 130,
    show: str = "",
    plain: bool = False,
    shapes: tuple[Shape, ...] = (),
    pick: str = "",
) -> Block:
    """A plot as a block of the sheet.

    `x` and `y` name axes of the picture, `title` is its text alternative, `x_column` the column of abscissae,
    `margin` the room for labels at the left and at the right. `cursor="time"` draws the instant shown and lets it be
    dragged; `handles` are pills on an axis that set a parameter: {"parameter": name, "symbol": text,
    "label": accessible name, "tint": class, "axis": "x" or "y", "least": its lowest value,
    "text": the live number shown in place of the parameter's, "unit": what follows it, "covering": the unit that is
    said where the pill stands over that of the axis, "show": the form by which it stands, "bare": moved by a
    press on the plot alone, without a pill}. `marks` are lines with a flag across the plot at a scalar (in the axis'
    unit): {"at": scalar, "tint": class, "html": rich text of the flag, "label": accessible name, "set" or "act":
    parameter or action it is the button for, "axis": "x" or "y", "lift": pixels of the flag over the frame,
    "style": "dashed"}; `top` makes
    room for flags. `square` draws both axes to one scale; `plain` leaves out numbers at the axes. `show` is the form by
    which the plot stands. `shapes` are drawn over it as on a stage, with `on_x`, `on_y` of this plot. A press near a
    point of a curve sets the list `pick` to its source and its place in the column.
    """
    x_labels = x_labels and not plain
    figure_ = _figure(title, x_column, source, curves, bands, x_labels, (*margin, top), plain)
    return {
        "kind": "plot",
        "name": name,
        "title": title,
        "x": x,
        "y": y,
        "source": source,
        "x_column": x_column,
        "curves": [{**vars(c), "group": c.group or c.name, "x": c.x or x_column} for c in curves],
        "bands": [{**vars(b), "group": b.group} for b in bands],
        "heading": list(heading),
        "x_labels": x_labels,
        "cursor": cursor,
        "handles": list(handles),
        "marks": list(marks),
        "square": square,
        "plain": plain,
        "grow": grow,
        "basis": basis + (30 if x_labels else 0) + (22 if heading else 0),
        "phone": phone,
        "height": height,
        "show": show,
        "shapes": list(shapes),
        "pick": pick,
        "item": json_item(figure_),
    }


def _figure(
    title: str,
    x_column: str,
    source: str,
    curves: tuple[Curve, ...],
    bands: tuple[Band, ...],
    x_labels: bool,
    margin: tuple[int, int, int],
    plain: bool,
) -> BokehPlot:
    figure_ = figure(
        tools="",
        toolbar_location=None,
        sizing_mode="stretch_both",
        x_range=Range1d(0, 1),
        y_range=Range1d(0, 1),
        min_border=0,
        min_border_left=margin[0],
        min_border_right=margin[1],
        min_border_top=margin[2],
        min_border_bottom=30 if x_labels else 2,
        outline_line_color=None,
        background_fill_color=None,
        border_fill_color=None,
        output_backend="canvas",
        html_attributes={"role": "img", "aria-label": title},
        lod_threshold=None,
    )
    names = {b.source for b in bands} | {c.source for c in curves} | {source}
    sources = {key: ColumnDataSource(name=key, data={}) for key in sorted(names)}
    for owner in sources:
        columns = {c.name for c in curves if c.source == owner} | {c.x or x_column for c in curves if c.source == owner}
        columns |= {column for b in bands if b.source == owner for column in (x_column, b.low, b.high)}
        sources[owner].data = {column: np.empty(0, np.float32) for column in sorted(columns)}
    for band in bands:
        glyph = figure_.varea(x=x_column, y1=band.low, y2=band.high, source=sources[band.source], fill_alpha=band.alpha)
        glyph.tags = [band.tint, band.group]
    for curve in curves:
        place = {"x": curve.x or x_column, "y": curve.name, "source": sources[curve.source]}
        tags = [curve.tint, curve.group or curve.name]
        if curve.width != "none":
            look = {"line_width": WIDTHS[curve.width], "line_dash": DASHES.get(curve.width, []), "line_join": "round"}
            figure_.line(**place, **look).tags = tags
        if curve.marker:
            figure_.scatter(**place, size=9, line_width=1.75).tags = [*tags, curve.marker]
    figure_.add_layout(Span(location=0, dimension="width", line_width=1, level="underlay", tags=["zero"]))
    for axis in (*figure_.xaxis, *figure_.yaxis):
        axis.ticker = FixedTicker(ticks=[])
        axis.axis_line_color = axis.minor_tick_line_color = axis.major_tick_line_color = None
        axis.major_label_text_font_size = "13px"
        axis.major_label_standoff = 5
    for grid in (*figure_.xgrid, *figure_.ygrid):
        grid.ticker = figure_.xaxis[0].ticker if grid.dimension == 0 else figure_.yaxis[0].ticker
    figure_.xaxis.visible, figure_.yaxis.visible = x_labels, False
    if plain:
        figure_.xgrid.visible = figure_.ygrid.visible = False
        figure_.add_layout(Span(location=0, dimension="height", line_width=1, level="underlay", tags=["zero"]))
    return figure_
