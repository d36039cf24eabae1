"""Shapes in a Bokeh figure: four glyphs for their marks, and one for the dots that a visitor can drag."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from typing import Any, NamedTuple

import numpy as np
from bokeh.models import ColumnDataSource, MultiLine, Patches, PointDrawTool, Scatter, Text
from bokeh.models import Plot as BokehPlot

from components.language.shapes import AnyShape, Grab
from components.panel_face.colours import colours
from components.panel_face.label_collisions import TextBox, without_collisions
from components.panel_face.shapes import GlyphRow, evaluated, marks, text_row, words
from components.panel_face.ways import dragged
from components.quantities.axes import Axis

LINES = {"line_color": "colour", "line_width": "width", "line_dash": "dash", "line_alpha": "alpha"}
AREAS = {
    "fill_color": "fill",
    "fill_alpha": "opacity",
    "line_color": "colour",
    "line_width": "width",
    "line_dash": "dash",
}
POINTS = {"size": "size", "marker": "marker", "angle": "angle", "fill_color": "fill", "fill_alpha": "opacity",
          "line_color": "colour", "line_width": "width"}  # fmt: skip
TEXTS = {"text": "text", "text_align": "align", "text_color": "colour", "text_font_size": "font",
         "text_font_style": "bold"}  # fmt: skip
GLYPHS: dict[str, tuple[Any, dict[str, str], str]] = {
    "areas": (Patches, AREAS, "xs"),
    "lines": (MultiLine, LINES, "xs"),
    "points": (Scatter, POINTS, "x"),
    "texts": (Text, TEXTS, "x"),
}
"""The glyph of each kind of mark, its properties that are columns, and the name of its first coordinate."""
BLANK = text_row(-1e4, -1e4, "", "ink", "t1", "start").row
"""Fills the rows of texts that are gone, because BokehJS reports a fault when a source of texts becomes shorter. It is
outside the figure, because BokehJS draws dots even for an empty text."""
GRIP = 26  # pixels


class Plane(NamedTuple):
    """Converts pixels of a drawing to coordinates of its figure: `left` + `right` x, and `top` + `down` y. Texts stay
    in `room`."""

    room: TextBox
    left: float = 0.0
    right: float = 1.0
    top: float = 0.0
    down: float = 1.0

    def x(self, pixels: Any) -> Any:
        """Return the x coordinates of pixels from the left edge."""
        return self.left + self.right * np.asarray(pixels)

    def y(self, pixels: Any) -> Any:
        """Return the y coordinates of pixels below the upper edge."""
        return self.top + self.down * np.asarray(pixels)

    def drawn(self, x: Any, y: Any) -> tuple[Any, Any]:
        """Return coordinates as lists of short numbers: rounded to a hundredth of a pixel."""
        digits = (2 - math.floor(math.log10(abs(unit))) for unit in (self.right, self.down))
        return tuple(np.round(one, n).tolist() for one, n in zip((self.x(x), self.y(y)), digits, strict=True))

    def pixels(self, x: float, y: float) -> tuple[float, float]:
        """Return the pixels of a point of the figure."""
        return (x - self.left) / self.right, (y - self.top) / self.down


def update(source: ColumnDataSource, data: dict[str, list[Any]]) -> None:
    """Set the columns of a source. If their length is unchanged, only rows that differ are sent."""
    old = source.data
    if any(len(old[name]) != len(column) for name, column in data.items()):
        source.data = data
        return
    pairs = {name: enumerate(zip(column, old[name], strict=True)) for name, column in data.items()}
    patches = {name: [(i, new) for i, (new, was) in rows if new != was] for name, rows in pairs.items()}
    if patches := {name: rows for name, rows in patches.items() if rows}:
        source.patch(patches)


def draggable(grab: Grab | None) -> bool:
    """Return whether a drag sets a value."""
    return grab is not None and any(way.parameter for way in grab.ways)


class ShapeGlyphs:
    """The shapes of a stage or of a plot, drawn in a figure.

    `moved` receives the values that a drag sets. `paper` is the opacity of the white background of texts.
    """

    def __init__(
        self, figure: BokehPlot, shapes: tuple[AnyShape, ...], moved: Callable[[Grab, dict[str, float]], None],
        paper: float = 0.0,
    ) -> None:  # fmt: skip
        self.shapes, self._moved = shapes, moved
        self.sources = {of: ColumnDataSource(_columns(of, ())) for of in GLYPHS}
        look = {"text_baseline": "alphabetic", "background_fill_color": "white", "background_fill_alpha": paper}
        for of, (glyph, columns, first) in GLYPHS.items():
            places = {first: "x", first.replace("x", "y"): "y"}
            figure.add_glyph(self.sources[of], glyph(**places, **columns, **(look if of == "texts" else {})))
        self.grips = ColumnDataSource({"x": [], "y": []})
        self._held: list[Grab] = []
        self._at: dict[str, list[float]] = {"x": [], "y": []}
        if any(draggable(shape.grab) for shape in shapes):
            self._add_grips(figure)

    def _add_grips(self, figure: BokehPlot) -> None:
        ring = Scatter(x="x", y="y", size=GRIP, line_color=colours()["mute"], line_dash=[2, 3], fill_alpha=0.0)
        renderer = figure.add_glyph(self.grips, ring)
        tool = PointDrawTool(renderers=[renderer], add=False)
        figure.add_tools(tool)
        figure.toolbar.active_tap = figure.toolbar.active_drag = tool
        self.grips.on_change("data", lambda attr, old, new: self._dragged())

    def show(
        self, named: Mapping[str, float], texts: Mapping[str, str], axes: Mapping[str, Axis], plane: Plane,
        flags: Iterable[GlyphRow] = (),
    ) -> None:  # fmt: skip
        """Draw the shapes at an instant, except those that need a missing quantity, and the names of marks, `flags`."""
        self._named, self._axes, self._plane = named, axes, plane
        found: dict[str, list[dict[str, Any]]] = {of: [] for of in GLYPHS}
        self._held, places = [], []
        for shape in self.shapes:
            if not all(named.get(name) for name in shape.show):
                continue
            try:
                drawn = list(marks(shape, named))
                for of, row in drawn:
                    found[of].append(row)
                if draggable(shape.grab):
                    places.append(_hold(shape, named))
                    self._held.append(shape.grab)  # type: ignore[arg-type]
            except KeyError:
                continue
        written = [row | {"text": words(row["text"], texts)} for row in found["texts"]]
        found["texts"] = list(without_collisions([*written, *(row for _, row in flags)], plane.room))
        found["texts"] += [BLANK] * (len(self.sources["texts"].data["x"]) - len(found["texts"]))
        for of, rows in found.items():
            update(self.sources[of], _columns(of, map(self._placed, rows)))
        self._at = {"x": [float(plane.x(x)) for x, _ in places], "y": [float(plane.y(y)) for _, y in places]}
        self._put_grips()

    def _put_grips(self) -> None:
        """Move the draggable dots to their shapes."""
        if self.grips.data != self._at:
            self.grips.data = {name: list(column) for name, column in self._at.items()}

    def _placed(self, row: dict[str, Any]) -> dict[str, Any]:
        x, y = self._plane.drawn(row["x"], row["y"])
        return row | {"x": x, "y": y}

    def _dragged(self) -> None:
        """Set the values of the dot that a visitor has moved."""
        xs, ys = self.grips.data["x"], self.grips.data["y"]
        if len(xs) != len(self._held):  # the visitor deleted a dot by a key
            self._put_grips()
            return
        for grab, x, y, old_x, old_y in zip(self._held, xs, ys, self._at["x"], self._at["y"], strict=True):
            if (x, y) != (old_x, old_y):
                self._moved(grab, dragged(grab, *self._plane.pixels(x, y), self._named, self._axes))
                return


def _hold(shape: AnyShape, named: Mapping[str, float]) -> tuple[float, float]:
    """Return the position in pixels of the dot by which a shape is dragged."""
    s = evaluated(shape, named)
    if hasattr(s, "side"):
        return s.x, s.y - s.side / 2
    return (s.x2, s.y2) if hasattr(s, "x2") else (s.x, s.y)


def _columns(of: str, rows: Iterable[dict[str, Any]]) -> dict[str, list[Any]]:
    drawn = list(rows)
    return {name: [row[name] for row in drawn] for name in ("x", "y", *GLYPHS[of][1].values())}
