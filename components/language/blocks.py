"""Blocks: the arrangement of the paper in rows and columns of stages, plots, words, tables and choices."""

from __future__ import annotations

from typing import Any, Literal, TypeAlias

from msgspec import Struct

from components.language.plots import Curve, Handle, Mark, Region, Room, Term
from components.language.shapes import AnyShape
from components.language.text import Forms, Html


class Part(Struct, frozen=True, kw_only=True, tag_field="kind"):
    """The fields that all blocks have.

    `part` is the block's name in links and walks: stage, plot:x, words:why, table. A block without `views` is in all of
    them. `grow` and `basis` divide the height (in a column) or the width (in a row). `phone` is its position from top
    to bottom on a narrow screen and `height` its height there. It is visible while the picture has the form `form`.
    `hall`, if set, shows it only with (or only without) the large type of hall mode.
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
    """Blocks below each other."""

    blocks: tuple[Block, ...]
    gap: int = 0


class StageBlock(Part, frozen=True, kw_only=True, tag="stage"):
    """The animated drawing of a scene; `label` describes it for screen readers. Alone in a row, it is at most `widest`
    times as wide as high."""

    shapes: tuple[AnyShape, ...]
    label: str
    widest: float = 3.4


class WordsBlock(Part, frozen=True, kw_only=True, tag="words"):
    """Sentences and formulas."""

    items: tuple[Forms, ...]


class TableBlock(Part, frozen=True, kw_only=True, tag="table"):
    """Rows of cells with column headings; the first cell of a row is its name."""

    head: tuple[Html, ...]
    rows: tuple[tuple[Forms, ...], ...]


class Option(Struct, frozen=True):
    """A value of a choice: its word in links, and its label."""

    value: str
    label: str


class ChoiceBlock(Part, frozen=True, kw_only=True, tag="choice"):
    """Joined buttons for the options of the parameter `name`."""

    name: str
    label: str
    options: tuple[Option, ...]


class ModesBlock(Part, frozen=True, kw_only=True, tag="modes"):
    """Buttons with the mode shapes of the modal signal `of`; if there are many modes, only of the strongest.

    Each button sets the parameter `name` to the number of its mode, and the values in `sets`. If only one mode moves,
    the picture's text `chosen` is its number.
    """

    name: str
    label: str
    of: str
    chosen: str
    sets: dict[str, str]


class MeasuredBlock(Part, frozen=True, kw_only=True, tag="measured"):
    """A part of a visitor's measured record: the file, the numbers of its fit, or the residuals of the column `column`
    below the plot `plot` with its points. `examples` maps the names of files that are ready to their addresses."""

    shows: Literal["file", "fit", "residuals"]
    plot: str = ""
    column: str = ""
    examples: dict[str, str] = {}


class PlotBlock(Part, frozen=True, kw_only=True, tag="plot"):
    """A plot: `x` and `y` name axes of the picture, `title` is its text alternative, `brief` its name in a list.

    `time`: its abscissa is time, and the visitor can drag the time cursor. `square`: both axes have the same scale.
    `plain`: no numbers at the axes. `shapes` are drawn over it as on a stage. A press near a point of a curve sets the
    list `pick` to its source and its index in the column. `room` is the margin around the frame; labels and handles are
    placed with it before the figure is loaded. `modal`: a signal whose masses are drawn under the curves, one column
    each, with time downwards and colours for displacements; the scalar `full` is the displacement with the full colour.
    `says` maps names to texts with {live numbers} that a screen reader reads with the title and after a change.
    """

    name: str
    title: str
    says: dict[str, str]
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
    modal: str
    full: str
    figure: dict[str, Any]  # Bokeh's own JSON
    """A Bokeh document, as JSON, with only this figure."""


Block: TypeAlias = (
    Row | Column | StageBlock | WordsBlock | TableBlock | ChoiceBlock | ModesBlock | MeasuredBlock | PlotBlock
)
