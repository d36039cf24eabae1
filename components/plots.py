"""The plots: Bokeh figures without data, built once a process and mounted by every visitor's browser.

A session owns only its numbers. A figure knows the names of its columns; the browser fills them from the one message
that answers a change, and draws the time cursor, the labels at the curves' ends and the handles over the figure.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from decimal import Decimal
from typing import Any

import numpy as np
from bokeh.embed import json_item
from bokeh.models import ColumnDataSource, FixedTicker, Range1d, Span
from bokeh.models import Plot as BokehPlot
from bokeh.plotting import figure
from numpy.typing import NDArray

from components.numbers import MINUS, power_unit, ten, three
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


@dataclass(frozen=True)
class Axis:
    """The range of an axis in SI units, and how it is labelled: in units of `factor` (in SI) times 10**exponent.

    Ticks are labelled by their numbers, or by `labels` where these are given.
    With a `power` the axis shows that power of the number: columns and handles hold omega, the axis shows omega^2.
    """

    start: float
    end: float
    unit: str = ""
    exponent: int = 0
    suffix: str = ""
    ticks: tuple[float, ...] = field(default=(), repr=False)
    log: bool = False
    factor: float = 1.0
    power: int = 1
    labels: tuple[str, ...] = field(default=(), repr=False)

    def places(self, values: NDArray[np.float64] | float) -> NDArray[np.float64]:
        """Where values stand on this axis, in its unit; logarithms to base ten on a log axis."""
        measured = np.asarray(values, dtype=float) / self.factor
        if self.log:
            return np.log10(np.maximum(measured, 5e-324))
        return scale_by_ten(measured, -(self.exponent // self.power)) ** self.power

    def place(self, value: float) -> float:
        """The same of one value: for scalars and marks."""
        return float(self.places(value))

    def scaled(self, values: NDArray[np.float64]) -> NDArray[np.float32]:
        """Places ready for the wire: cut far outside the frame, where no line is seen."""
        with np.errstate(over="ignore"):
            return np.clip(self.places(values), -1e30, 1e30).astype(np.float32)

    @property
    def full_unit(self) -> str:
        """The unit with the power of ten before it."""
        return f"{self.suffix}{self.unit}"

    def digits(self, signed: bool = False) -> tuple[int, bool]:
        """How a number that moves is shown on this axis: decimals, and whether its sign always stands."""
        return max(0, 2 - math.floor(math.log10(max(abs(self.place(self.start)), abs(self.place(self.end)))))), signed

    def number(self, value: float) -> str:
        """A value in this axis' unit, to three digits."""
        return three(self.place(value))

    def wire(self) -> dict[str, Any]:
        labels = [ten(round(tick)) if self.log else f"{tick:.6g}".replace("-", MINUS) for tick in self.ticks]
        if self.labels:
            labels = list(self.labels)
        elif self.ticks and self.unit:
            labels[-1] = f"{labels[-1]}{'' if self.full_unit == '°' else ' '}{self.full_unit}"
        start, end = self.place(self.start), self.place(self.end)
        ticks = [float(tick) for tick in self.ticks]
        return {
            "start": start,
            "end": end,
            "ticks": ticks,
            "labels": labels,
            "unit": self.full_unit,
            "exponent": self.exponent,
            "factor": self.factor,
            "power": self.power,
            "log": self.log,
        }


def scale_by_ten(values: NDArray[np.float64], exponent: int) -> NDArray[np.float64]:
    """values * 10**exponent, in two steps so that no power of ten leaves the range of doubles."""
    half = exponent // 2
    return values * 10.0**half * 10.0 ** (exponent - half)


def nice_axis(
    low: float, high: float, unit: str = "", count: int = 4, exact: bool = False, factor: float = 1.0
) -> Axis:
    """An axis over [low, high] with at most `count` + 1 round ticks; unless `exact`, it grows to show the curve whole.

    `factor` is the unit of its labels in SI: 0.3048 for feet.
    """
    if not high > low:
        middle = abs(low) or factor
        low, high = low - middle, high + middle
    exponent, suffix = power_unit(max(abs(low), abs(high)) / factor)
    bare = Axis(low, high, unit, exponent, suffix, factor=factor)
    a, b = bare.place(low), bare.place(high)
    ticks = nice_ticks(a, b, count)
    margin = 0.0 if exact else 0.08 * (high - low)
    return replace(bare, start=low - margin, end=high + margin, ticks=ticks)


def squared_axis(end: float, unit: str, count: int = 5) -> Axis:
    """An axis of the squares of numbers from 0 to `end`, whose own range is then twice that of doubles."""
    exponent = 6 * (Decimal(end).adjusted() // 3) if not 1e-3 <= end < 1e2 else 0
    bare = Axis(0.0, end, unit, exponent, f"{ten(exponent)} " if exponent else "", power=2)
    return replace(bare, ticks=nice_ticks(0.0, bare.place(end), count))


def nice_ticks(low: float, high: float, count: int) -> tuple[float, ...]:
    """At most `count` + 1 multiples of a round step within [low, high]; two at the least where the range allows."""
    power = 10.0 ** math.floor(math.log10((high - low) / count))
    for step in (f * power for f in (1, 2, 2.5, 4, 5, 10)):
        first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
        if last - first <= count:
            break
    return tuple(step * i for i in range(first, last + 1))


def log_axis(low: float, high: float, unit: str = "", count: int = 5) -> Axis:
    """A logarithmic axis with ticks at powers of ten."""
    first, last = math.ceil(math.log10(low) - 1e-9), math.floor(math.log10(high) + 1e-9)
    step = max(1, math.ceil((last - first) / count))
    return Axis(low, high, unit, ticks=tuple(float(p) for p in range(first, last + 1, step)), log=True)


def whole_axis(end: float, unit: str) -> Axis:
    """An axis from 0 to `end`, both marked: for what is a share of a total."""
    axis = nice_axis(0.0, end, unit, exact=True)
    top = axis.place(axis.end)
    return replace(axis, ticks=(0.0, float(f"{top:.3g}")))


def time_axis(end: float) -> Axis:
    """The axis of a time window from 0 to `end` seconds."""
    return nice_axis(0.0, end, "s", 5, exact=True)


def widest(*ranges: tuple[float, float]) -> tuple[float, float]:
    """The range that holds all of these."""
    return min(low for low, _ in ranges), max(high for _, high in ranges)
