"""The shapes of a stage as marks: lines, areas, points and texts, in the pixels of the stage.

`KINDS` maps each kind of shape to the function that draws it, as static/scene/stage.js does for the page.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

from components.language.expressions import Expression
from components.language.shapes import AnyShape
from components.language.text import Runs
from components.panel_face.colours import colours
from components.quantities.instant import number

NamedNumbers = Mapping[str, float]
TEETH = 9
BIG = 8.0
"""Radius in pixels from which a circle is an area, under the lines; smaller ones are dots over them, whose size a zoom
does not change."""
STYLES: dict[str, dict[str, Any]] = {
    "sum": {"width": 3.0},
    "wall": {"width": 3.0},
    "thick": {"width": 6.0},
    "plate": {"width": 3.0},
    "bar": {"width": 2.0},
    "thin": {"width": 2.0},
    "fine": {"width": 1.25},
    "behind": {"width": 1.0, "alpha": 0.55},
    "dash": {"dash": [7, 5]},
    "counter": {"tint": "paper"},
    "dots": {"dash": [2, 3], "width": 1.5},
    "level": {"dash": [2, 3], "width": 1.5},
    "dotted": {"dash": [2, 3], "width": 1.0},
    "hair": {"tint": "rule", "width": 1.0, "fill": None},
    "orbit": {"tint": "rule", "width": 1.0, "fill": None},
    "faint": {"tint": "rule"},
    "grid": {"tint": "grid", "width": 1.0},
    "eq": {"tint": "mute", "width": 1.0, "dash": [4, 4], "fill": None},
    "floor": {"tint": "ink", "width": 1.0},
    "now": {"tint": "ink", "width": 1.0},
    "rod": {"tint": "ink", "width": 1.5},
    "inner": {"tint": "paper", "width": 1.0, "dash": [4, 4]},
    "outline": {"fill": None},
    "ring": {"fill": "paper"},
    "ghost": {"fill": "paper"},
    "hollow": {"fill": "paper"},
    "body": {"fill": "", "width": 0.0},
    "fill": {"fill": "", "width": 0.0},
    "liquid": {"fill": "", "width": 0.0, "opacity": 0.16},
    "water": {"tint": "k2fill", "fill": "", "width": 0.0, "opacity": 0.75},
    "on": {"tint": "paper"},
    "pick": {"fill": None, "width": 2.0},
}
"""Changes of the look by each style. A `fill` is a colour; "" is the colour of the shape, None is no fill."""
SIZES = {"t0": 12, "t1": 13, "t2": 14, "t3": 16}
SUBSCRIPTS = str.maketrans("0123456789+-−aehijklmnoprstuvx", "₀₁₂₃₄₅₆₇₈₉₊₋₋ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ")


class GlyphRow(NamedTuple):
    """A row of one of the sources of a drawing: `of` is lines, areas, points or texts."""

    of: str
    row: dict[str, Any]


@dataclass(frozen=True)
class Pen:
    """The look of a shape. Its methods make marks."""

    tint: str
    width: float = 1.75
    dash: Sequence[int] = ()
    fill: str | None = None
    alpha: float = 1.0
    opacity: float = 1.0

    @property
    def colour(self) -> str:
        """The colour of lines and texts."""
        return colours()[self.tint]

    def line(self, xs: Any, ys: Any, width: float | None = None) -> GlyphRow:
        """Return a line through points, with another width if one is given."""
        look = {"width": self.width if width is None else width, "dash": list(self.dash), "alpha": self.alpha}
        return GlyphRow("lines", {"x": list(xs), "y": list(ys), "colour": self.colour, **look})

    def area(self, xs: Any, ys: Any) -> GlyphRow:
        """Return a filled polygon with its outline."""
        fill = colours()[self.fill or self.tint] if self.fill is not None else None
        look = {"fill": fill, "opacity": self.opacity if fill else 0.0, "width": self.width, "dash": list(self.dash)}
        return GlyphRow("areas", {"x": list(xs), "y": list(ys), "colour": self.colour, **look})

    def point(self, x: float, y: float, size: float, marker: str = "circle", angle: float = 0.0) -> GlyphRow:
        """Return a marker of Bokeh, `size` pixels wide and turned by `angle` in radians."""
        fill = colours()[self.fill or self.tint] if self.fill is not None else None
        look = {"fill": fill, "opacity": self.opacity if fill else 0.0, "width": self.width, "angle": angle}
        return GlyphRow("points", {"x": x, "y": y, "size": size, "marker": marker, "colour": self.colour, **look})


def pen(shape: AnyShape, fill: str | None = None) -> Pen:
    """Return the look of a shape: that of its kind, changed by its styles in the order of the table."""
    changes: dict[str, Any] = {"tint": shape.tint, "fill": fill}
    words = shape.style.split()
    for style, change in STYLES.items():
        changes |= change if style in words else {}
    return Pen(**changes)


def evaluated(shape: AnyShape, named: NamedNumbers) -> SimpleNamespace:
    """Return the fields of a shape with its numbers at an instant. Raises KeyError if one needs an absent name."""
    fields = ((name, getattr(shape, name)) for name in shape.__struct_fields__)
    return SimpleNamespace(
        **{name: number(value, named) if isinstance(value, Expression) else value for name, value in fields}
    )


def subscript(text: str) -> str:
    """Return an index as Unicode subscripts; as it is if Unicode lacks one of its letters."""
    return text.translate(SUBSCRIPTS) if all(ord(letter) in SUBSCRIPTS for letter in text) else text


def words(runs: Runs, texts: Mapping[str, str]) -> str:
    """Return a short text with the live numbers in `texts`."""
    read: dict[str, Callable[[str], str]] = {
        "index": subscript,
        "value": lambda text: texts.get(text, ""),
    }
    return "".join(read[run.kind](run.text) if run.kind in read else run.text for run in runs)


def _spring(s: Any, look: Pen, _: NamedNumbers) -> Iterator[GlyphRow]:
    length = math.hypot(s.x2 - s.x1, s.y2 - s.y1) or 1.0
    end = min(12.0, 0.15 * length)
    step = (length - 2 * end) / (2 * TEETH)
    along = [0.0, end, *(end + step * (i + 0.5) for i in range(2 * TEETH)), length - end, length]
    across = [0.0, 0.0, *(s.height * (-1) ** (i + 1) for i in range(2 * TEETH)), 0.0, 0.0]
    ux, uy = (s.x2 - s.x1) / length, (s.y2 - s.y1) / length
    ends = list(zip(along, across, strict=True))
    yield look.line([s.x1 + ux * a - uy * b for a, b in ends], [s.y1 + uy * a + ux * b for a, b in ends], s.wire)


def _box(s: Any, look: Pen, _: NamedNumbers) -> Iterator[GlyphRow]:
    a, b, top = s.x - s.side / 2, s.x + s.side / 2, s.y - s.side
    yield look.area([a, b, b, a], [s.y, s.y, top, top])
    if s.label and s.side >= 24:
        place = (a + 14, s.y - 9) if s.corner else (s.x, s.y - s.side / 2 + 6)
        tint, align = "paper" if look.fill == "" else look.tint, "left" if s.corner else "center"
        yield text_row(*place, s.label, tint, "t3", "inside", align=align)


def _line(s: Any, look: Pen, _: NamedNumbers) -> Iterator[GlyphRow]:
    yield look.line([s.x1, s.x2], [s.y1, s.y2])


def _arrow(s: Any, look: Pen, _: NamedNumbers) -> Iterator[GlyphRow]:
    length = math.hypot(s.x2 - s.x1, s.y2 - s.y1)
    if length > 1:
        ux, uy = (s.x2 - s.x1) / length, (s.y2 - s.y1) / length
        size = min(s.head, length)
        x1, y1, x2, y2 = s.x1 + s.gap * ux, s.y1 + s.gap * uy, s.x2 + s.gap * ux, s.y2 + s.gap * uy
        width = look.width if "thick" in s.style or "thin" in s.style else 3.0
        yield look.line([x1, x2 - 0.8 * size * ux], [y1, y2 - 0.8 * size * uy], width)
        turn = math.atan2(-uy, ux) - math.pi / 2
        yield look.point(x2 - 0.6 * size * ux, y2 - 0.6 * size * uy, 1.1 * size, "triangle", turn)


def _circle(s: Any, look: Pen, _: NamedNumbers) -> Iterator[GlyphRow]:
    if s.r >= BIG:
        turns = np.linspace(0, 2 * math.pi, 49)
        yield look.area(s.x + s.r * np.cos(turns), s.y + s.r * np.sin(turns))
    elif s.r > 0:
        yield look.point(s.x, s.y, 2 * s.r)


def _path(s: Any, look: Pen, _: NamedNumbers) -> Iterator[GlyphRow]:
    turn = math.atan2(s.dy, s.dx) if s.dx or s.dy else s.turn
    cosine, sine = math.cos(turn), math.sin(turn)
    for outline in outlines(s.d):
        x, y = outline.T * [[s.sx], [s.sy]]
        xs, ys = s.x + cosine * x - sine * y, s.y + sine * x + cosine * y
        yield look.line(xs, ys) if look.fill is None else look.area(xs, ys)


def _arc(s: Any, look: Pen, _: NamedNumbers) -> Iterator[GlyphRow]:
    turns = np.linspace(s.start, s.end, 33)
    yield look.line(s.x + s.r * np.sin(turns), s.y + s.r * np.cos(turns))


def _wave(s: Any, look: Pen, _: NamedNumbers) -> Iterator[GlyphRow]:
    shares = np.linspace(0.0, 1.0, 24 * math.ceil(abs(s.turns) + 1) + 1)
    xs, ys = s.x + s.length * shares, s.y - s.size * np.sin(2 * math.pi * s.turns * shares + s.phase)
    if s.depth:
        yield look.area([*xs, s.x + s.length, s.x], [*ys, s.y + s.depth, s.y + s.depth])
    else:
        yield look.line(xs, ys)


def _layers(s: Any, look: Pen, _: NamedNumbers) -> Iterator[GlyphRow]:
    for share in np.arange(1, s.count) / s.count:
        x = s.x + s.length * share + s.size * math.sin(2 * math.pi * s.turns * share)
        yield look.line([x, x], [s.y, s.y + s.height])


def _label(s: Any, look: Pen, _: NamedNumbers) -> Iterator[GlyphRow]:
    size = next((word for word in s.style.split() if word in SIZES), "t1")
    yield text_row(s.x, s.y, s.words, look.tint, size, s.anchor, "b" in s.style.split())


def text_row(
    x: float, y: float, text: Runs | str, tint: str, size: str, anchor: str, bold: bool = False, align: str = ""
) -> GlyphRow:
    """Return a text on its base line, whose live numbers are filled in later.

    `anchor` says how it may move: "inside" a box it stays, "beside" a point it is right or left of it.
    """
    align = align or {"middle": "center", "end": "right"}.get(anchor, "left")
    look = {"font": f"{SIZES[size]}px", "bold": "bold" if bold else "normal", "colour": colours()[tint]}
    return GlyphRow("texts", {"x": x, "y": y, "text": text, "anchor": anchor, "align": align, **look})


def _wall(s: Any, look: Pen, _: NamedNumbers) -> Iterator[GlyphRow]:
    upright, depth = s.side in ("left", "right"), -s.depth if s.side in ("left", "top") else s.depth
    hatch = Pen("mute", 1.0)
    for at in np.arange(0.0, s.length - s.depth / 2 + 1e-9, 0.9 * s.depth):
        if upright:
            yield hatch.line([s.x, s.x + depth], [s.y + at, s.y + at + s.depth])
        else:
            yield hatch.line([s.x + at + s.depth, s.x + at], [s.y, s.y + depth])
    end = (s.x, s.y + s.length) if upright else (s.x + s.length, s.y)
    yield Pen("ink", 3.0).line([s.x, end[0]], [s.y, end[1]])


def _beads(s: Any, _: Pen, named: NamedNumbers) -> Iterator[GlyphRow]:
    """Each mass as a square in the colour of its side, and a line for each spring."""
    count = round(s.count)
    shifts = np.array([named.get(f"{s.of}{i}", s.drift) for i in range(1, count + 1)]) - s.drift
    rests = s.x + s.length * (s.first + np.arange(count)) / s.parts
    xs, ys = rests + s.along * shifts, s.y - s.across * shifts
    ends = [([s.x], [s.y])] * bool(s.left), [([s.x + s.length], [s.y])] * bool(s.right)
    left, right = ([x for x, _ in end] for end in ends)
    yield Pen("k").line(np.concatenate([*left, xs, *right]), np.concatenate([*([[s.y]] * len(left)), ys,
                                                                            *([[s.y]] * len(right))]))  # fmt: skip
    half = min(54 / math.sqrt(count + 1), 0.75 * s.length / s.parts) / 2
    for x, y, shift in zip(xs, ys, shifts, strict=True):
        tint = "m1" if shift > s.least else "m2" if shift < -s.least else "k"
        square = Pen(tint, 0.0, fill="")
        yield square.area([x - half, x + half, x + half, x - half], [y - half, y - half, y + half, y + half])


Draw = Callable[[Any, Pen, NamedNumbers], Iterator[GlyphRow]]
KINDS: dict[str, tuple[str | None, Draw]] = {
    "Spring": (None, _spring),
    "Box": ("", _box),
    "Line": (None, _line),
    "Arrow": ("", _arrow),
    "Circle": ("", _circle),
    "Path": (None, _path),
    "Arc": (None, _arc),
    "Wave": (None, _wave),
    "Layers": (None, _layers),
    "Label": (None, _label),
    "Wall": (None, _wall),
    "Beads": ("", _beads),
}
"""The fill of each kind of shape, and the function that draws it."""


def marks(shape: AnyShape, named: NamedNumbers) -> Iterator[GlyphRow]:
    """Return the marks of a shape at an instant. Raises KeyError if one of its numbers needs an absent name."""
    fill, draw = KINDS[type(shape).__name__]
    return draw(evaluated(shape, named), pen(shape, fill), named)


_STEP = re.compile(r"([MLHVCAZmlhvcaz])([^MLHVCAZmlhvcaz]*)")
_NUMBER = re.compile(r"-?(?:\d+\.?\d*|\.\d+)(?:e-?\d+)?")


@lru_cache(maxsize=256)
def outlines(d: str) -> tuple[Any, ...]:
    """Return the parts of SVG path data, each as points (n, 2): lines, cubic curves, and half ellipses from left to
    right or back, the arcs that our outlines have."""
    parts: list[list[tuple[float, float]]] = []
    for letter, rest in _STEP.findall(d):
        given = [float(text) for text in _NUMBER.findall(rest)]
        if letter in "Zz":
            parts[-1].append(parts[-1][0])
        elif letter in "Mm":
            parts.append([(given[0], given[1])])
            _extend(parts[-1], "L" if letter == "M" else "l", given[2:])
        else:
            _extend(parts[-1], letter, given)
    return tuple(np.array(part) for part in parts)


COUNTS = {"L": 2, "H": 1, "V": 1, "C": 6, "A": 7}


def _extend(points: list[tuple[float, float]], letter: str, given: list[float]) -> None:
    """Add the steps of one letter of a path."""
    count = COUNTS[letter.upper()]
    for i in range(0, len(given), count):
        (x, y), step = points[-1], given[i : i + count]
        a, b = (x, y) if letter.islower() else (0.0, 0.0)
        match letter.upper():
            case "H":
                points.append((a + step[0], y))
            case "V":
                points.append((x, b + step[0]))
            case "C":
                corners = np.array([(x, y), *((a + step[j], b + step[j + 1]) for j in (0, 2, 4))])
                for t in np.linspace(0, 1, 9)[1:]:
                    weights = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3]
                    points.append(tuple(weights @ corners))
            case "A":
                end_x, height = a + step[5], step[1]
                way = math.copysign(1.0, end_x - x) * (1 if step[4] else -1)
                for t in np.linspace(0, math.pi, 17)[1:]:
                    middle = (x + end_x) / 2
                    points.append((middle + (x - middle) * math.cos(t), y - way * height * math.sin(t)))
            case _:
                points.append((a + step[0], b + step[1]))
