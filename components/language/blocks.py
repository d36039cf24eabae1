"""Blocks: the arrangement of the paper in rows and columns of stages, plots, words, tables and choices."""

from __future__ import annotations

from typing import Any, TypeAlias

from msgspec import Struct

from components.language.plots import Curve, Handle, Mark, Region, Room, Term
from components.language.shapes import AnyShape
from components.language.text import Forms, Html


class Part(Struct, frozen=True, kw_only=True, tag_field="kind"):
    """The fields that all blocks have.

    `part` is its name in lists of what a step shows: stage, plot:x, words:why, table. Without any `views` it is in all
    of them. `grow` and `basis` say how a block shares the height (in a column) or the width (in a row), `phone` its
    place from top to bottom on a narrow screen and `height` its height there; it stands while the picture has the form
    `form`, and with the large type of a `hall` or not there.
    """

    part: str = ""
    views: tuple[str, ...] = ()

    grow: float = 0.0
    basis: int = 0
    phone: int | None = None
    height: int | None = None
    form: str = ""
    hall: bool = True
    style: str = ""


class Row(Part, frozen=True, kw_only=True, tag="row"):
    """Blocks side by side."""

    blocks: tuple[Block, ...]
    gap: int = 0


class Column(Part, frozen=True, kw_only=True, tag="column"):
    """Blocks one under the other."""

    blocks: tuple[Block, ...]
    gap: int = 0


class StageBlock(Part, frozen=True, kw_only=True, tag="stage"):
    """The picture; `label` describes it to those who do not see it. Where it stands alone it is at most `widest` times
    as wide as high."""

    shapes: tuple[AnyShape, ...]
    label: str
    widest: float = 3.4


class WordsBlock(Part, frozen=True, kw_only=True, tag="words"):
    """Sentences and formulas."""

    items: tuple[Forms, ...]


class TableBlock(Part, frozen=True, kw_only=True, tag="table"):
    """Rows of cells under their heads; the first cell of a row is its name."""

    head: tuple[Html, ...]
    rows: tuple[tuple[Forms, ...], ...]


class Option(Struct, frozen=True):
    """A value of a choice, by its word, and its name on the screen."""

    value: str
    label: str


class ChoiceBlock(Part, frozen=True, kw_only=True, tag="choice"):
    """A joined segment of options that sets the parameter `name`."""

    name: str
    label: str
    options: tuple[Option, ...]


class PlotBlock(Part, frozen=True, kw_only=True, tag="plot"):
    """A plot: `x` and `y` name axes of the picture, `title` is its text alternative, `brief` its name in a list.

    `time` says whether its abscissa is the instant shown, which then can be dragged; `square` draws both axes to one
    scale; `plain` leaves out numbers at the axes; `shapes` are drawn over it as on a stage; a press near a point of a
    curve sets the list `pick` to its source and its place in the column. The frame leaves free the room around it, so
    that what stands over the figure has its place before the figure is there.
    """

    name: str
    title: str
    brief: str
    x: str
    y: str
    curves: tuple[Curve, ...]
    regions: tuple[Region, ...]
    heading: tuple[Term, ...]
    handles: tuple[Handle, ...]
    marks: tuple[Mark, ...]
    shapes: tuple[AnyShape, ...]
    room: Room
    x_labels: bool
    cursor: bool
    time: bool
    square: bool
    plain: bool
    pick: str
    figure: dict[str, Any]  # Bokeh's own JSON
    """A document of the Bokeh figure alone, in Bokeh's own language."""


Block: TypeAlias = Row | Column | StageBlock | WordsBlock | TableBlock | ChoiceBlock | PlotBlock
