"""Live Bokeh figures of one visitor: plots, updated with the numbers of each picture, and stages."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from html import unescape
from typing import Any

import numpy as np
from bokeh.models import (
    BasicTicker,
    ColumnDataSource,
    FixedTicker,
    HoverTool,
    Legend,
    LegendItem,
    LinearColorMapper,
    PanTool,
    Range1d,
    ResetTool,
    SaveTool,
    Scatter,
    Span,
    WheelZoomTool,
)
from bokeh.plotting import figure

from components.language.blocks import PlotBlock, StageBlock
from components.language.expressions import names_in
from components.language.plots import Curve, Handle, Mark, Region
from components.language.shapes import AnyShape
from components.language.signals import Modal
from components.layout.plots import figure_of
from components.panel_face.colours import colours, diverging
from components.panel_face.drawing import Plane, ShapeGlyphs, update
from components.panel_face.label_collisions import TextBox, text_width
from components.panel_face.shapes import GlyphRow, subscript, text_row
from components.quantities.axes import TIME_AXIS, Axis
from components.quantities.motion import displacements
from components.scene import Picture, Scene
from components.scene.html import filled

WIDTHS = {"sum": 3.0, "line": 1.75, "dash": 1.75, "dots": 1.0, "thin": 1.0, "none": 1.0}
LOWEST = 240  # pixels
FRAME = 560.0
"""The width of the frame of a plot in pixels until the browser has measured it."""
STAGE = 520.0
"""The width of a stage in pixels until the browser has measured it."""
WIDEST = 760
"""The largest width of a stage and of the player."""
EDGE = 4.0
"""Pixels between a text and the edges of a stage; the most by which it leaves its lower edge."""
HEAD = 12.0
"""Pixels above a stage, for texts."""
SQUARE = 720
"""The largest width of a plot with one scale."""
SMALL, WORDS = 12, 13
"""Sizes of the names of curves and marks, and of the words at an axis."""
SAMPLE = 44.0
"""Pixels of the sample of a line in a legend, with the room around it and its name."""
LAYOUT = {"wide": 0.0, "narrow": 1.0, "stacked": 1.0, "hall": 0.0, "desk": 1.0, "low": 0.0}
"""The layout that shapes see: a stage above its plots, as on a phone."""
INDEX = re.compile(r"<sub>(.*?)</sub>|(?<=<msub>)(<m\w[^>]*>[^<]*</m\w>)(.*?)(?=</msub>)")
"""An index in HTML, or a symbol with its index in MathML."""
ROWS = 240
"""Number of instants in the picture of a chain."""
SetByHand = Callable[[dict[str, float], bool], None]
"""A function that sets values, and plays from the start if a motion begins with them."""


class LiveStage:
    """One visitor's figure of a stage: its shapes, in pixels. `width` is as wide as the browser has made it."""

    def __init__(self, block: StageBlock, moved: SetByHand) -> None:
        self.block, self.height, self.width = block, float(block.height or 180), STAGE
        self.model = figure(
            x_range=Range1d(0, STAGE), y_range=Range1d(self.height + EDGE, -HEAD), toolbar_location=None, tools="",
            height=int(HEAD + self.height + EDGE), sizing_mode="stretch_width", min_border=0,
            max_width=min(WIDEST, int(block.widest * self.height)),
            outline_line_color=None, background_fill_color=None, border_fill_color=None,
        )  # fmt: skip
        self.model.axis.visible = self.model.grid.visible = False
        own = tuple(shape for shape in block.shapes if not plot_under(shape))
        self.nowhere = dict.fromkeys((name for shape in own for name in _names(shape) if "." in name), 0.0)
        self.drawing = ShapeGlyphs(self.model, own, lambda grab, values: moved(values, grab.begins))

    def show(self, scene: Scene, picture: Picture) -> None:
        """Fit the figure to its width; all shapes are drawn for each instant."""
        self.model.x_range.end = self.width

    def tick(self, picture: Picture, named: Mapping[str, float], texts: Mapping[str, str]) -> None:
        """Draw the instant of `named`."""
        size = {"W": self.width, "H": self.height}
        plane = Plane(TextBox(EDGE, self.width - EDGE, -HEAD, self.height + EDGE))
        self.drawing.show({**named, **self.nowhere, **LAYOUT, **size}, texts, picture.axes, plane)


class LiveFigure:
    """One visitor's figure of a plot. Its columns are in the units of its axes, as on the page; `width` is the width
    of its frame in pixels, as the browser reports it."""

    def __init__(self, block: PlotBlock, shapes: tuple[AnyShape, ...], moved: SetByHand) -> None:
        self.block, self.model = block, figure_of(block)
        height = block.height or LOWEST
        self.height, self.width = float(height if block.square else max(height, LOWEST)), FRAME
        self._size()
        self.parts = {one: self._painted(one) for one in self.model.renderers}
        self.field = self._field() if block.modal else None
        self._tools()
        self._legend()
        self.drawing = ShapeGlyphs(self.model, shapes, lambda grab, values: moved(values, grab.begins), 0.7)
        self.dots = ColumnDataSource({"x": [], "y": [], "colour": []})
        dot = Scatter(x="x", y="y", size=9, fill_color="colour", line_color="white")
        self.model.add_glyph(self.dots, dot, level="overlay")
        side = "width" if block.y == TIME_AXIS else "height"
        self.cursor = Span(dimension=side, line_color=colours()["ink"], level="overlay")
        if block.time:
            self.model.add_layout(self.cursor)
        lines: tuple[Mark | Handle, ...] = (*block.marks, *block.handles)
        self.lines = {one: self._line(one, moved) for one in lines}

    def _size(self) -> None:
        """Give the figure the width of the page, and room for numbers at both axes."""
        self.model.update(min_border_left=62, min_border_right=16, min_border_bottom=46, min_border_top=8)
        self.model.axis.visible = True
        # "13px" is Bokeh's default, which would count as not set: templates of Panel have a larger default.
        for axis in self.model.axis:
            axis.update(axis_label_text_font_size=f"{WORDS}.0px", axis_label_text_font_style="normal")
        for grid in self.model.grid:
            grid.ticker = None  # then the grid has the ticks of its axis
        self.model.update(frame_height=int(self.height), sizing_mode="stretch_width")
        if self.block.square:
            self.model.max_width = SQUARE

    def _tools(self) -> None:
        """Bokeh's own tools: the wheel zooms only after a click on its tool, so that the page scrolls."""
        hover = HoverTool(tooltips=[("", "$name"), ("x", "$x"), ("y", "$y")], renderers=list(self.parts))
        self.model.add_tools(PanTool(), WheelZoomTool(), ResetTool(), SaveTool(), hover)
        self.model.toolbar.autohide = True
        self.model.update(toolbar_location="above", toolbar_inner=True)
        self.model.toolbar.active_drag = None

    def _legend(self) -> None:
        """The names of the curves, the uppermost first; a click on one hides it."""
        self.items: dict[LegendItem, list[Any]] = {}
        self.legend = Legend(
            border_line_color=None, orientation="horizontal", click_policy="hide", label_text_font_size=f"{SMALL}px",
            padding=2, margin=0,
        )  # fmt: skip
        named: dict[str, list[Any]] = {}
        for renderer, part in self.parts.items():
            if part.read:
                named.setdefault(renderer.name, []).append(renderer)
        if len(named) > 1:
            self.items = {LegendItem(label=name): renderers for name, renderers in reversed(named.items())}
            self.legend.items = list(self.items)
            self.model.add_layout(self.legend, "above")

    def _line(self, one: Mark | Handle, moved: SetByHand) -> Span:
        """The line of a mark, or of a handle, which can be dragged."""
        line = Span(
            line_color=colours()[one.tint], line_dash=[4, 3], dimension="height" if one.axis == "x" else "width"
        )
        self.model.add_layout(line)
        if isinstance(one, Handle):
            line.update(editable=True, line_width=2, hover_line_width=4)
            line.on_change("location", lambda attr, old, new: self._dragged(one, new, moved))
        return line

    def _dragged(self, handle: Handle, place: float, moved: SetByHand) -> None:
        """Set the value of a handle that a visitor has moved."""
        if place != self._at.get(handle):
            value = self._axes[handle.axis].value(place)
            least = -np.inf if handle.least is None else handle.least
            moved({handle.parameter: float(f"{max(value, least):.4g}")}, False)

    def _field(self) -> ColumnDataSource:
        """The source of the picture of a chain under the curves."""
        source = ColumnDataSource({"image": [], "x": [], "y": [], "dw": [], "dh": []})
        mapper = LinearColorMapper(palette=diverging(), low=-1.0, high=1.0)
        places = {"image": "image", "x": "x", "y": "y", "dw": "dw", "dh": "dh"}
        self.model.image(**places, source=source, color_mapper=mapper, level="underlay")
        return source

    def _show_field(self, picture: Picture, end: float) -> None:
        """Draw the displacement of each mass as a colour, from the same signal as the browser."""
        signal = picture.signals.get(self.block.modal)
        if not (self.field and isinstance(signal, Modal)):
            return
        count, t = len(signal.omega), np.linspace(0.0, end, ROWS)
        image = displacements(signal, t) / picture.scalars[self.block.full]
        self.field.data = {"image": [image], "x": [0.5], "y": [0.0], "dw": [count], "dh": [end]}
        self.model.y_range.update(start=end, end=0.0)

    def _painted(self, renderer: Any) -> Curve | Region:
        """Return the curve or region that a renderer draws, and give the renderer its colour."""
        kind, place = renderer.name.split(".")
        part: Curve | Region = getattr(self.block, kind)[int(place)]
        glyph, renderer.name = renderer.glyph, symbol(part.read or part.group)
        if isinstance(part, Curve):
            glyph.update(line_color=colours()[part.tint], line_width=WIDTHS[part.width])
        if "fill_color" in glyph.properties():
            glyph.fill_color = "white" if isinstance(part, Curve) and part.marker == "ring" else colours()[part.tint]
        return part

    def show(self, scene: Scene, picture: Picture) -> None:
        """Draw a picture of the scene; if it lacks an axis of the plot, the figure does not change."""
        if not self.has(picture):
            return
        x, y = picture.axes[self.block.x], picture.axes[self.block.y]
        self._axes, self._ends = {"x": x, "y": y}, self._ranges(x, y)
        against, says = axis_words(self.block)
        for span, scale, axis, ends, text, length in (
            (self.model.x_range, self.model.xaxis, x, self._ends[0], against, self.width),
            (self.model.y_range, self.model.yaxis, y, self._ends[1], says, self.height),
        ):
            span.update(start=ends[0], end=ends[1], reset_start=ends[0], reset_end=ends[1])
            _label(scale, axis, text, length)
        self._fill(picture, x, y, scene.values["hidden"])
        self._show_field(picture, y.ruler.end)
        self._at = {one: _place(one, scene, picture, self._axes[one.axis]) for one in self.lines}
        for one, line in self.lines.items():
            place = self._at[one]
            line.update(location=place or 0.0, visible=place is not None)

    def has(self, picture: Picture) -> bool:
        """Return whether a picture has the axes of this plot."""
        return {self.block.x, self.block.y} <= picture.axes.keys()

    def _ranges(self, x: Axis, y: Axis) -> tuple[tuple[float, float], tuple[float, float]]:
        """The ends of both axes. In a square plot both have the same scale, so one of them shows a wider range."""
        ends = ((x.ruler.start, x.ruler.end), (y.ruler.start, y.ruler.end))
        if not self.block.square:
            return ends
        unit = 10.0 ** (x.exponent - y.exponent)
        scale = max(unit * (ends[0][1] - ends[0][0]) / self.width, (ends[1][1] - ends[1][0]) / self.height)
        half, half_y = scale * self.width / unit / 2, scale * self.height / 2
        middle, middle_y = sum(ends[0]) / 2, sum(ends[1]) / 2
        return (middle - half, middle + half), (middle_y - half_y, middle_y + half_y)

    def tick(self, picture: Picture, named: Mapping[str, float], texts: Mapping[str, str]) -> None:
        """Draw the instant of `named`: shapes, dots on the curves, and the time cursor."""
        if not self.has(picture):
            return
        (left, right), (low, high) = self._ends
        per_x, per_y, name = self.width / (right - left), -self.height / (high - low), self.block.name
        frame = {"left": 0.0, "right": self.width, "top": 0.0, "bottom": self.height, "x0": -left * per_x, "x1": per_x,
                 "y0": -high * per_y, "y1": per_y}  # fmt: skip
        here = {f"{name}.{what}": value for what, value in frame.items()} | LAYOUT
        here |= {"W": self.width, "H": self.height}
        plane = Plane(TextBox(0.0, self.width, 0.0, self.height), left, 1 / per_x, high, 1 / per_y)
        self.drawing.show({**named, **here}, texts, picture.axes, plane, self._flags(picture, plane))
        self.cursor.location = named["t"]
        seen = [one for renderer, one in self.parts.items() if renderer.visible and isinstance(one, Curve)]
        moving = [(one, named.get(one.signal_x or "t"), named.get(one.signal)) for one in seen if one.signal]
        dots = [(one, x, y) for one, x, y in moving if x is not None and y is not None and self._is_inside(x, y)]
        columns = {"x": [x for _, x, _ in dots], "y": [y for _, _, y in dots]}
        update(self.dots, {**columns, "colour": [colours()[one.tint] for one, _, _ in dots]})

    def _is_inside(self, x: float, y: float) -> bool:
        """Return whether the visitor sees a point, also after a zoom. Bokeh does not clip what is over a plot."""
        across, up = self.model.x_range, self.model.y_range
        upright = sorted((up.start, up.end))
        return bool(across.start <= x <= across.end and upright[0] <= y <= upright[1])

    def _flags(self, picture: Picture, plane: Plane) -> Iterator[GlyphRow]:
        """The names of the marks: of an upright line at its upper end, of a level one at its right end."""
        for one, place in self._at.items():
            if not isinstance(one, Mark) or place is None:
                continue
            x, y = plane.pixels(place, place)
            upright, text = one.axis == "x", plain_html(one.html, picture)
            if text and 0 <= (x if upright else y) <= (self.width if upright else self.height):
                at, anchor = ((x, SMALL / 2), "beside") if upright else ((self.width, y - 4), "end")
                yield text_row(*at, text, one.tint, "t0", anchor)

    def _fill(self, picture: Picture, x: Axis, y: Axis, hidden: list[str]) -> None:
        """Set the columns of all sources. Curves that lack a column, or are switched off, are not drawn."""
        abscissae = {part.x for part in self.parts.values()}
        for source in {renderer.data_source for renderer in self.parts}:
            given = {name: column for name, column in picture.sources.get(source.name, {}).items() if len(column)}
            data = {name: (x if name in abscissae else y).places(given[name]) for name in source.data if name in given}
            source.data = dict.fromkeys(source.data, np.zeros(max(map(len, data.values()), default=0))) | data
            for renderer, part in self.parts.items():
                if renderer.data_source is source:
                    needed = {part.x, part.y} if isinstance(part, Curve) else {part.x, part.low, part.high}
                    renderer.visible = needed <= data.keys() and part.group not in hidden
        for item, renderers in self.items.items():  # an item is grey if one of its renderers is invisible
            drawn = [renderer for renderer in renderers if renderer.visible]
            item.update(renderers=drawn, visible=bool(drawn))
        widths = [SAMPLE + text_width(item.label.value, SMALL) for item in self.items if item.visible]
        self.legend.visible = len(widths) > 1
        fits = (n for n in range(len(widths), 1, -1) if sum(max(widths[i::n]) for i in range(n)) <= self.width)
        self.legend.ncols = next(fits, 1)


def plot_under(shape: AnyShape) -> str:
    """Return the plot over which a shape of a stage is drawn; "" for none, also for shapes that continue the lines of a
    plot next to the stage."""
    names = _names(shape)
    return "" if "wide" in names else next((name.partition(".")[0] for name in names if "." in name), "")


def symbol(name: str) -> str:
    """Return the name of a curve with the index of a symbol as a subscript: x₁ for x1."""
    return re.sub(r"(?<=^\w)(p?\d|[+−])$", lambda index: subscript(index[0]), name)


def _names(shape: AnyShape) -> set[str]:
    """The names that the numbers of a shape use."""
    return {name for field in shape.__struct_fields__ for name in names_in(getattr(shape, field))}


def _label(scale: Any, axis: Axis, says: str, length: float) -> None:
    """Set the ticks and the text of an axis: round numbers that follow a zoom, or the scene's own ticks. A text longer
    than the axis is left out, except its unit."""
    own = axis.log or axis.labels
    kind = FixedTicker if own else BasicTicker
    if not isinstance(scale[0].ticker, kind):
        scale.ticker = kind()
    if own:
        scale.ticker.ticks = list(axis.ruler.ticks)
    scale.major_label_overrides = dict(zip(axis.ruler.ticks, axis.ruler.labels, strict=True)) if own else {}
    unit = f"[{axis.full_unit}]" if axis.full_unit else ""
    label = f"{says} {unit}".strip()
    scale.axis_label = (label if text_width(label, WORDS) <= length else unit) or None


def axis_words(block: PlotBlock) -> tuple[str, str]:
    """Return the words for the x and the y axis of a plot, from its title; "" where it has none."""
    found = re.search(r"(?:^|: )([^:,]*)(?:,[^:]*)? against (?:the )?(.*?)(?:,|:| is |$)", block.title)
    is_timed = block.x == TIME_AXIS
    says, against = found.groups() if found else (re.split("[,:]", block.title)[0] * is_timed, "time" * is_timed)
    if against.startswith("that of "):
        against = says.partition(" of ")[0] + against.removeprefix("that")
    return ("", "time") if block.y == TIME_AXIS else (against, says)


def plain_html(html: str, picture: Picture) -> str:
    """Return a text that is given as HTML as plain words, with the values of its live numbers."""
    text = filled(html, picture.values)
    text = INDEX.sub(lambda of: (of[2] or "") + subscript(unescape(re.sub("<.*?>", "", of[1] or of[3]))), text)
    joined = re.sub(r"</?m(?!ath)\w+[^>]*>", "", text)  # the parts of a formula
    return unescape(" ".join(re.sub("<[^>]*>", " ", joined).split()))


def _place(one: Mark | Handle, scene: Scene, picture: Picture, axis: Axis) -> float | None:
    """Return the position of a mark, or of the value that a handle sets; None if it is hidden."""
    if isinstance(one, Mark):
        return picture.scalars.get(one.at)
    value = scene.values[one.parameter] if not one.form or picture.forms.get(one.form) else None
    return None if value is None else axis.place(value)
