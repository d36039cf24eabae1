"""CSV export: the numbers of all plots, with the link, parameters and equations behind them."""

from __future__ import annotations

import csv
import io
import zipfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import chain
from urllib.parse import quote

from components.language.messages import File
from components.language.plots import Region
from components.layout.choices import word
from components.quantities.formatting import excerpt, shortest
from components.quantities.parameters import Quantity
from components.scene import Picture, Scene
from components.scene.columns import NumberTable, headed, in_ascii, tables_of
from components.state.page_state import PageState
from components.state.scene_sheet import column_axes, plots

READING = "SI units; the unit of a column is in brackets after its name, 1 for a pure number; full precision"


@dataclass(frozen=True)
class CsvTable:
    """A table of numbers: rows under the names of their columns."""

    name: str
    head: tuple[str, ...]
    rows: list[tuple[object, ...]]
    notes: tuple[str, ...] = ()


def as_file(told: PageState, picture: Picture, page: str = "", answer: int | None = None) -> File:
    """Return a file with the numbers of all visible plots: a CSV, or a ZIP of several. `page` is the page's address.

    A table of motions has at most 1281 rows, one of bands at most 681. The physics is evaluated at most once for each
    row; in the scenes with dashpots with 80 digits.
    """
    scene, head = told.scene, comments(told, picture, page)
    found = tables(told.kind, picture) or readouts(told, picture)
    if len(found) < 2:
        content = as_csv(found[0], head) if found else _noted(head).encode("ascii")
        return File(name=f"{scene.slug}.csv", kind="text/csv", content=content, answer=answer)
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as files:
        for table in found:
            files.writestr(zipfile.ZipInfo(f"{scene.slug}-{table.name}.csv"), as_csv(table, head))
    return File(name=f"{scene.slug}.zip", kind="application/zip", content=packed.getvalue(), answer=answer)


def as_table(told: PageState, picture: Picture, page: str = "", name: str = "") -> File:
    """Return the table with this name, or the first, as CSV. Raises ValueError, with all names, for another name."""
    found = {table.name: table for table in tables(told.kind, picture) or readouts(told, picture)}
    if name and name not in found:
        raise ValueError(f"“{excerpt(name)}” is not a table of these numbers: choose one of {', '.join(found)}.")
    table, head = found.get(name or next(iter(found), "")), comments(told, picture, page)
    content = as_csv(table, head) if table else _noted(head).encode("ascii")
    return File(name=f"{told.scene.slug}.csv", kind="text/csv", content=content)


def as_csv(table: CsvTable, head: Iterable[str]) -> bytes:
    """Return a table with unrounded numbers, under comments that begin with #.

    The text is ASCII. Comments have no comma and no quotation mark, so a spreadsheet shows each in one cell.
    """
    text = io.StringIO(newline="")
    text.write(_noted([*head, *table.notes]))
    writer = csv.writer(text)
    writer.writerow(table.head)
    writer.writerows(table.rows)
    return text.getvalue().encode("ascii")


def _noted(head: Iterable[str]) -> str:
    return "".join(f"# {line}\r\n" for line in head)


def comments(told: PageState, picture: Picture, page: str = "") -> list[str]:
    """Return the head of a file: the link, the parameters, the equations, the plots that the numbers belong to."""
    scene, alone = told.scene, replace(told, covered=(), step="")
    link = quote(page, safe=":/[]@!$&'()*+;=%") + "?" + alone.query.replace(",", "%2C")
    title = f"Oscillations: {scene.title}: {scene.headline}"
    lines = [title, link, *_parameters(scene, picture), *scene.equations, *_plots(type(scene), picture), READING]
    return [in_ascii(line).replace(",", ";").replace('"', "'") for line in lines]


def _parameters(scene: Scene, picture: Picture) -> Iterator[str]:
    """Yield a line for each parameter that has an effect in the current state of the scene."""
    hidden = (group for group in scene.groups if group.idle_when_hidden and not group.is_shown(picture.forms))
    idle = {name for group in hidden for name in group.names}
    for name, parameter in scene.linked().items():
        if name in idle:
            continue
        value = getattr(scene, name)
        if isinstance(parameter, Quantity):
            if value is not None:
                yield f"{name} = {shortest(value)} {parameter.unit}".rstrip()
        elif not isinstance(value, list):
            yield f"{name} = {word(value)}"


def _plots(scene: type[Scene], picture: Picture) -> Iterator[str]:
    """Yield a line with the columns of each plot; the layers of a stack explain its edges."""
    found, home = tables_of(picture, column_axes(scene)), _home(picture)
    for plot in plots(scene):
        sources = {*(curve.source for curve in plot.curves), *(layer.source for layer in plot.regions)}
        here = {home.get(source, source) for source in sources} & found.keys()
        known = {name for of in here for name in found[of].columns}
        names = [*dict.fromkeys(curve.y for curve in plot.curves if curve.y in known)]
        names += [text for layer in plot.regions for text in _layer(picture, layer, known)]
        if names and plot.y in picture.axes:
            yield f"{', '.join(names)}: {plot.title}"


def _home(picture: Picture) -> dict[str, str]:
    """Return the table with the numbers of a source, if a `FileTable` replaces it."""
    return {source: name for name, table in picture.tables.items() for source in table.instead}


def _layer(picture: Picture, layer: Region, known: set[str]) -> Iterator[str]:
    """Return the column of a layer, or the difference between its edges."""
    trace = picture.traces.get(layer.source)
    own = [name for name, edges in (trace.layers if trace else {}).items() if edges == (layer.low, layer.high)]
    if own:
        yield from (name for name in own if name in known)
    elif layer.read and {layer.low, layer.high} <= known:
        yield f"{layer.read} = {layer.high} - {layer.low}"


def tables(scene: type[Scene], picture: Picture) -> list[CsvTable]:
    """Return the tables of a picture. Tables with the same columns are joined; their first column names the source."""
    pieces: dict[tuple[bool, tuple[str, ...]], dict[str, NumberTable]] = {}
    for name, table in tables_of(picture, column_axes(scene)).items():
        pieces.setdefault((table.plane, tuple(table.columns)), {})[name] = table
    return [_table(names, found) for (_, names), found in pieces.items()]


def readouts(told: PageState, picture: Picture) -> list[CsvTable]:
    """Return the readouts of a picture as a table, for a scene without plots; nothing if a readout is covered."""
    covered = {*told.shown.values, *told.shown.live} - {*picture.values, *picture.live}
    found = told.scene.readouts()
    if not found or any(one.is_in(covered) for one in found):
        return []
    head = tuple(headed(one.name, in_ascii(one.unit)) for one in found)
    return [CsvTable("numbers", head, [tuple(one.value for one in found)])]


def _table(names: tuple[str, ...], found: dict[str, NumberTable]) -> CsvTable:
    first, *others = found.items()
    head = tuple(headed(name, first[1].units[name]) for name in names)
    bodies = {
        name: zip(*(column.tolist() for column in table.columns.values()), strict=True) for name, table in found.items()
    }
    notes = tuple(dict.fromkeys(in_ascii(table.note).replace(",", ";") for table in found.values() if table.note))
    if not others:
        return CsvTable(first[0], head, list(bodies[first[0]]), notes)
    rows = chain.from_iterable(((name, *row) for row in body) for name, body in bodies.items())
    return CsvTable("-".join(names[1:]), ("curve", *head), list(rows), notes)
