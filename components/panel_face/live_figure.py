"""A live figure: the Bokeh figure of a plot, updated with the numbers of each picture."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from bokeh.models import ColumnDataSource, HoverTool, LinearColorMapper, Span

from components.language.blocks import PlotBlock
from components.language.plots import Curve, Handle, Mark, Region
from components.language.signals import Modal
from components.layout.plots import figure_of
from components.quantities.axes import Axis
from components.quantities.motion import displacements
from components.scene import Picture, Scene

TOKENS = Path(__file__).parents[2] / "static" / "styles" / "tokens.css"
WIDTHS = {"sum": 3.0, "line": 1.75, "dash": 1.75, "dots": 1.0, "thin": 1.0, "none": 1.0}
LOWEST = 160  # pixels
ROWS, SHADES = 240, 101
"""Numbers of instants and of colours in the picture of a chain."""


@cache
def colours() -> dict[str, str]:
    """The colours of the page by name, on white."""
    light = TOKENS.read_text(encoding="utf-8").partition("/* Type and lines")[0]
    return dict(re.findall(r"--(\w+): (#[0-9a-f]{6});", light))


def diverging() -> list[str]:
    """Return colours from the tint m2 over white to the tint m1."""
    hues = [np.array([int(colours()[tint][i : i + 2], 16) for i in (1, 3, 5)]) for tint in ("m2", "m1")]
    shares = np.linspace(-1.0, 1.0, SHADES)
    mixed = [255 + abs(share) ** 0.7 * (hues[int(share > 0)] - 255) for share in shares]
    return ["#" + "".join(f"{round(part):02x}" for part in colour) for colour in mixed]


class LiveFigure:
    """One visitor's figure of a plot; its columns count in the units of its axes, as on the page."""

    def __init__(self, block: PlotBlock) -> None:
        self.block, self.model = block, figure_of(block)
        self.model.update(height=max(block.height or 0, LOWEST), sizing_mode="stretch_width")
        self.model.yaxis.visible = not block.plain
        self.parts = {one: self._painted(one) for one in self.model.renderers}
        self.field = self._field() if block.modal else None
        self.model.add_tools(HoverTool(tooltips="$name: ($x, $y)"))
        lines: tuple[Mark | Handle, ...] = (*block.marks, *block.handles)
        self.lines = {one: Span(line_color=colours()[one.tint], line_dash=[4, 3]) for one in lines}
        for one, line in self.lines.items():
            line.dimension = "height" if one.axis == "x" else "width"
            self.model.add_layout(line)

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
        """The part of the plot that a renderer draws, which then has its colour."""
        kind, place = renderer.name.split(".")
        part: Curve | Region = getattr(self.block, kind)[int(place)]
        glyph, renderer.name = renderer.glyph, part.read or part.group
        if isinstance(part, Curve):
            glyph.update(line_color=colours()[part.tint], line_width=WIDTHS[part.width])
        if "fill_color" in glyph.properties():
            glyph.fill_color = colours()[part.tint]
        return part

    def show(self, scene: Scene, picture: Picture) -> None:
        """Draw a picture of the scene; if it lacks an axis of the plot, the figure does not change."""
        if not {self.block.x, self.block.y} <= picture.axes.keys():
            return
        x, y = picture.axes[self.block.x], picture.axes[self.block.y]
        for span, scale, axis in ((self.model.x_range, self.model.xaxis, x), (self.model.y_range, self.model.yaxis, y)):
            span.update(start=axis.ruler.start, end=axis.ruler.end)
            scale.ticker.ticks = list(axis.ruler.ticks)
            scale.major_label_overrides = dict(zip(axis.ruler.ticks, axis.ruler.labels, strict=True))
        self._fill(picture, x, y, scene.values["hidden"])
        self._show_field(picture, y.ruler.end)
        for one, line in self.lines.items():
            place = _place(one, scene, picture, x if one.axis == "x" else y)
            line.update(location=place or 0.0, visible=place is not None)

    def _fill(self, picture: Picture, x: Axis, y: Axis, hidden: list[str]) -> None:
        """Give all sources their columns; what lacks one, or is switched off, is not drawn."""
        abscissae = {part.x for part in self.parts.values()}
        for source in {renderer.data_source for renderer in self.parts}:
            given = {name: column for name, column in picture.sources.get(source.name, {}).items() if len(column)}
            data = {name: (x if name in abscissae else y).places(given[name]) for name in source.data if name in given}
            source.data = dict.fromkeys(source.data, np.zeros(max(map(len, data.values()), default=0))) | data
            for renderer, part in self.parts.items():
                if renderer.data_source is source:
                    needed = {part.x, part.y} if isinstance(part, Curve) else {part.x, part.low, part.high}
                    renderer.visible = needed <= data.keys() and part.group not in hidden


def _place(one: Mark | Handle, scene: Scene, picture: Picture, axis: Axis) -> float | None:
    """Return the position of a mark, or of the value that a handle sets; None if it is hidden."""
    if isinstance(one, Mark):
        return picture.scalars.get(one.at)
    value = scene.values[one.parameter] if not one.form or picture.forms.get(one.form) else None
    return None if value is None else axis.place(value)
