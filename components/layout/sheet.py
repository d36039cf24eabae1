"""Builders of the paper's blocks (components.language.blocks), with texts in the notation of components.layout.text,
and functions that look things up in a sheet."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Literal

import msgspec
import param
from msgspec.structs import replace

from components.language.blocks import (
    Block,
    ChoiceBlock,
    Column,
    MeasuredBlock,
    ModesBlock,
    PlotBlock,
    Row,
    StageBlock,
    TableBlock,
    WordsBlock,
)
from components.language.expressions import Name
from components.language.plots import Term
from components.language.shapes import AnyShape
from components.language.text import Forms
from components.layout.choices import labelled
from components.layout.text import rich

MOST_TIMES = 50
"""Largest ratio of the shares of two neighbouring blocks."""
STRING = re.compile(r'"((?:[^"\\]|\\.)*)"(:?)')
"""Matches a string in JSON, with the colon after it if it is a key."""
LIVE = re.compile(r'data-value="(\w+)"')
"""Matches the name of a live number in HTML."""
Paragraph = str | Forms
"""A text, or several forms of it."""


def row(*blocks: Block, grow: float = 1, basis: int = 0, gap: int = 24) -> Block:
    return Row(blocks=_sharing(blocks), grow=grow, basis=basis, gap=gap)


def column(*blocks: Block, grow: float = 1, basis: int = 0, gap: int = 0) -> Block:
    return Column(blocks=_sharing(blocks), grow=grow, basis=basis, gap=gap)


def _sharing(blocks: tuple[Block, ...]) -> tuple[Block, ...]:
    """Return blocks that share the remaining room. Raises ValueError if one would get almost none of it."""
    shares = [block.grow for block in blocks if block.grow]
    least, most = min(shares, default=1.0), max(shares, default=1.0)
    if most > MOST_TIMES * least:
        raise ValueError(f"A block with grow={least:g} has no room beside one with grow={most:g}: give it more.")
    return blocks


def stage(
    *shapes: AnyShape,
    label: str,
    grow: float = 1,
    basis: int = 0,
    phone: int = 0,
    height: int = 180,
    widest: float = 3.4,
    style: str = "",
    name: str = "",
) -> Block:
    """Return a stage. `label` describes it for screen readers; a second stage needs a `name`."""
    place: dict[str, Any] = {"grow": grow, "basis": basis, "phone": phone, "height": height}
    part = f"stage:{name}" if name else "stage"
    return StageBlock(shapes=shapes, label=label, part=part, widest=widest, style=style, **place)


def words(
    *paragraphs: Paragraph, name: str = "", style: str = "facts", grow: float = 0, basis: int = 0, phone: int = 50
) -> Block:
    """Return a block of sentences and formulas. A step of a walk can list the block if it has a `name`."""
    items, part = tuple(map(_item, paragraphs)), f"words:{name}" if name else ""
    return WordsBlock(items=items, part=part, style=style, grow=grow, basis=basis, phone=phone)


def table(
    *rows: Sequence[Paragraph],
    head: Sequence[str] = (),
    grow: float = 0,
    basis: int = 0,
    phone: int = 50,
    style: str = "",
) -> Block:
    """Return a table of cells, each a paragraph as in `words`. The first cell of a row is its name."""
    cells = tuple(tuple(map(_item, line)) for line in rows)
    heads = tuple(map(rich, head))
    return TableBlock(head=heads, rows=cells, part="table", style=style, grow=grow, basis=basis, phone=phone)


def either(form: Name, /, **variants: str) -> Forms:
    """Return a text with several variants. The picture's form `name` says which one is shown, "" for none."""
    return Forms({name: rich(text) for name, text in variants.items()}, form.name)


def _item(paragraph: Paragraph) -> Forms:
    return paragraph if isinstance(paragraph, Forms) else Forms({"": rich(paragraph)})


def when(form: Name, block: Block) -> Block:
    """Return the block, which is then visible only while the picture has the form `name`."""
    return replace(block, form=form.name)


def desk(block: Block) -> Block:
    """Return the block for the desktop only; in hall mode, with large text, it is hidden."""
    return replace(block, hall=False)


def choice(parameter: param.Selector[Any], grow: float = 0, basis: int = 34, phone: int = 50, style: str = "") -> Block:
    """Return joined buttons for the two to four options of a parameter.

    In the style "views" they are to the right of the headline and switch the views of the scene.
    """
    return ChoiceBlock(
        part=f"choice:{parameter.name}",
        name=parameter.name or "",
        options=labelled(parameter),
        label=parameter.label or "",
        style=style,
        grow=grow,
        basis=basis,
        phone=phone,
    )


def modes(parameter: str, label: str, of: str, chosen: str, sets: dict[str, str], phone: int = 50) -> Block:
    """Return buttons with the shapes of the modes of a modal signal: components.language.blocks.ModesBlock."""
    return ModesBlock(part="modes", name=parameter, label=label, of=of, chosen=chosen, sets=sets, phone=phone)


def measured(shows: Literal["file", "fit"], phone: int = 50, examples: Sequence[str] = ()) -> Block:
    """The block for the visitor's measured record: its file, or the numbers of the fit. `examples`: labels of simulated
    files in static/measured that visitors can try."""
    files = {f"Simulated: {what}": f"simulated-{what.replace(' ', '-')}.csv" for what in examples}
    return MeasuredBlock(part=f"measured:{shows}", shows=shows, phone=phone, examples=files)


def residuals(plot: str, column: str, grow: float = 0, phone: int = 50, height: int | None = None) -> Block:
    """The residuals of a column of the visitor's measured record, below the plot with its points."""
    return MeasuredBlock(
        part="measured:residuals", shows="residuals", plot=plot, column=column, style="lane", grow=grow, phone=phone,
        height=height,
    )  # fmt: skip


def term(
    curve: Name | str = "", key: str = "line", tint: str = "ink", *, form: Name | None = None, **forms: str
) -> Term:
    """Return a term of a plot's heading: the formula of a curve, a sample of its line, and its switch.

    `key` is the kind of line: sum, line, dash, band or none. `forms` are formulas in LaTeX by variant; a single one is
    called `formula`. `form` names the picture's form that chooses the variant; it defaults to the one of the curve.
    """
    return phrase(curve, key, tint, form=form, **{name: f"${latex}$" if latex else "" for name, latex in forms.items()})


def phrase(
    curve: Name | str = "", key: str = "line", tint: str = "ink", *, form: Name | None = None, **forms: str
) -> Term:
    """Return a term of a heading with words in place of formulas."""
    variants = {name: rich(text) for name, text in forms.items()}
    group = curve if isinstance(curve, str) else curve.name
    chosen = form.name if form else group
    return Term(curve=group, form=chosen, key=key, tint=tint, variants=variants)  # type: ignore[arg-type]


def blocks(block: Block) -> Iterator[Block]:
    """Yield a block and all blocks inside it."""
    yield block
    if isinstance(block, (Row, Column)):
        for inner in block.blocks:
            yield from blocks(inner)


def in_force(block: Block, forms: Mapping[str, str]) -> Iterator[Block]:
    """Yield a block and all blocks inside it, except those that are hidden in these forms."""
    if not block.form or forms.get(block.form):
        yield block
        if isinstance(block, (Row, Column)):
            for inner in block.blocks:
                yield from in_force(inner, forms)


def needed_names(parts: Iterable[object]) -> frozenset[str]:
    """Return the names of the signals, numbers, texts and forms that some parts of a sheet need.

    All strings in these parts count as names, so that none is missed.
    """
    text = msgspec.json.encode([*parts]).decode()
    strings = {string for string, key in STRING.findall(text) if not key}
    return frozenset(strings.union(LIVE.findall(text.replace(r"\"", '"'))))


def axes_of_columns(sheet: Block) -> dict[str, dict[str, str]]:
    """Return the axis on which each column of each source is drawn: {source: {column: axis}}."""
    axes: dict[str, dict[str, str]] = {}
    for plot in (block for block in blocks(sheet) if isinstance(block, PlotBlock)):
        for curve in plot.curves:
            axes.setdefault(curve.source, {}).update({curve.x: plot.x, curve.y: plot.y})
        for region in plot.regions:
            own = {region.x: plot.x, region.low: plot.y, region.high: plot.y}
            axes.setdefault(region.source, {}).update(own)
    return axes


def sources_of_plots(sheet: Block) -> dict[str, list[str]]:
    """Return the sources of the curves of each plot, in the order of the curves: {plot: sources}."""
    plots = (block for block in blocks(sheet) if isinstance(block, PlotBlock))
    return {plot.name: list(dict.fromkeys(curve.source for curve in plot.curves)) for plot in plots}
