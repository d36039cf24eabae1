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
from components.layout.choices import word
from components.quantities.numbers import excerpt, shortest
from components.quantities.parameters import Quantity
from components.scene import Picture, Scene
from components.scene.columns import headed, in_ascii, unit_of
from components.scene.traces import Columns
from components.state.scene_sheet import column_axes, plots
from components.state.standing import Standing

READING = "SI units; the unit of a column stands in brackets after its name, 1 for a pure number; full precision"


@dataclass(frozen=True)
class CsvTable:
    """A table of numbers: rows under the names of their columns."""

    name: str
    head: tuple[str, ...]
    rows: list[tuple[object, ...]]


def as_file(told: Standing, picture: Picture, page: str = "", answer: int | None = None) -> File:
    """The numbers of all plots that are seen, a table a file; several are packed. `page` is its address."""
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


def as_table(told: Standing, picture: Picture, page: str = "", name: str = "") -> File:
    """One of the files of `as_file`: the table of a name, or the first; ValueError, with their names, for another."""
    found = {table.name: table for table in tables(told.kind, picture) or readouts(told, picture)}
    if name and name not in found:
        raise ValueError(f"“{excerpt(name)}” is not a table of these numbers: choose one of {', '.join(found)}.")
    table, head = found.get(name or next(iter(found), "")), comments(told, picture, page)
    content = as_csv(table, head) if table else _noted(head).encode("ascii")
    return File(name=f"{told.scene.slug}.csv", kind="text/csv", content=content)


def as_csv(table: CsvTable, head: Iterable[str]) -> bytes:
    """One table, unrounded, under lines that begin with #. All is ASCII and no comment has a comma or a quotation mark:
    a spreadsheet, which knows of no comments, shows each in one cell."""
    text = io.StringIO(newline="")
    text.write(_noted(head))
    writer = csv.writer(text)
    writer.writerow(table.head)
    writer.writerows(table.rows)
    return text.getvalue().encode("ascii")


def _noted(head: Iterable[str]) -> str:
    return "".join(f"# {line}\r\n" for line in head)


def comments(told: Standing, picture: Picture, page: str = "") -> list[str]:
    """The head of a file: the link, the parameters, the equations, the plots that the numbers belong to."""
    scene, alone = told.scene, replace(told, covered=(), step="")
    link = quote(page, safe=":/[]@!$&'()*+;=%") + "?" + alone.query.replace(",", "%2C")
    title = f"Oscillations: {scene.title}: {scene.headline}"
    lines = [title, link, *_parameters(scene, picture), *scene.equations, *_plots(type(scene), picture), READING]
    return [in_ascii(line).replace(",", ";").replace('"', "'") for line in lines]


def _parameters(scene: Scene, picture: Picture) -> Iterator[str]:
    """The parameters that count, a line each: none of another system, or of another way to begin."""
    apart = (group for group in scene.groups if group.apart and not group.stands(picture.forms))
    idle = {name for group in apart for name in group.names}
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
    """The columns of each plot, a line each; the edges of a stack are explained by its layers."""
    for plot in plots(scene):
        curves = [
            c for c in plot.curves if plot.y in picture.axes and len(picture.sources.get(c.source, {}).get(c.y, ()))
        ]
        layers = [r for r in plot.regions if r.read and len(picture.sources.get(r.source, {}).get(r.high, ()))]
        names = [*dict.fromkeys(curve.y for curve in curves)]
        names += [f"{layer.read} = {layer.high} - {layer.low}" for layer in layers]
        if names:
            yield f"{', '.join(names)}: {plot.title}"


def tables(scene: type[Scene], picture: Picture) -> list[CsvTable]:
    """The columns of all sources that are drawn. Sources with the same columns are pieces of one table, whose first
    column says which."""
    pieces: dict[tuple[str, ...], dict[str, Columns]] = {}
    for source, columns in picture.sources.items():
        drawn = _drawn(scene, picture, source, columns)
        if drawn:
            pieces.setdefault(tuple(drawn), {})[source] = columns
    return [_table(scene, picture, _with_times(names, sources), sources) for names, sources in pieces.items()]


def readouts(told: Standing, picture: Picture) -> list[CsvTable]:
    """The readouts of a picture as a table, where no plot is seen, unless one of them is covered."""
    covered = {*told.shown.values, *told.shown.live} - {*picture.values, *picture.live}
    found = told.scene.readouts()
    if not found or any(one.is_in(covered) for one in found):
        return []
    head = tuple(headed(one.name, in_ascii(one.unit)) for one in found)
    return [CsvTable("numbers", head, [tuple(one.value for one in found)])]


def _drawn(scene: type[Scene], picture: Picture, source: str, columns: Columns) -> list[str]:
    axes = column_axes(scene).get(source, {})
    return [name for name, column in columns.items() if len(column) and axes.get(name) in picture.axes]


def _with_times(names: tuple[str, ...], sources: dict[str, Columns]) -> tuple[str, ...]:
    """A path in a plane has its times beside it, though no axis shows them."""
    timed = "t" not in names and all("t" in columns for columns in sources.values())
    return ("t", *names) if timed else names


def _table(scene: type[Scene], picture: Picture, names: tuple[str, ...], sources: dict[str, Columns]) -> CsvTable:
    first = next(iter(sources))
    axes = {name: picture.axes.get(axis) for name, axis in column_axes(scene)[first].items()}
    head = tuple(headed(name, unit_of(axes.get(name))) for name in names)
    bodies = {
        source: zip(*(columns[name].tolist() for name in names), strict=True) for source, columns in sources.items()
    }
    if len(sources) == 1:
        return CsvTable(first, head, list(bodies[first]))
    rows = chain.from_iterable(((source, *row) for row in body) for source, body in bodies.items())
    return CsvTable("-".join(names[1:]), ("curve", *head), list(rows))
