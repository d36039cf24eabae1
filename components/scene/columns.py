"""Columns of a picture under names with their units in SI, for files and for notebooks."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple
from unicodedata import normalize

import numpy as np

from components.quantities.axes import TIME_AXIS, Axis
from components.quantities.formatting import excerpt, shortest
from components.scene.picture import Picture
from components.scene.traces import BAND, FIRST_PERIODS, FLOOR, PER_PERIOD, TIME, Columns, Traces

SI = {
    "ft": "m", "ft/s": "m/s", "knots": "m/s", "km/h": "m/s", "mm": "m", "°": "rad", "%": "", "√(k₁/m₁)": "rad/s",
    "F₀/k₁": "m",
}  # fmt: skip
"""SI units of columns, by the unit of their axis, where the two differ."""

MEAN = "_mean"
"""Suffix of the names of columns that have means over a period."""
FIRST = (
    f"Rows: the first {FIRST_PERIODS} periods of the fastest motion with {PER_PERIOD} points in each. "
    "The window ends at t = {end} s; the table {bands} covers all of it."
)
WHOLE = (
    "Rows: the whole window. NAME_lo and NAME_hi are the bounds of a motion NAME that is too fast for a curve; "
    "NAME_mean is its mean over a period. The table {source} has the motion itself at the start of the window."
)


class NumberTable(NamedTuple):
    """Columns for a file in SI units, the unit of each, and a sentence that explains the rows, or "".

    `plane`: the table is a path in a plane; no axis shows its times.
    """

    columns: Columns
    units: Mapping[str, str]
    note: str = ""
    plane: bool = False


def tables_of(picture: Picture, axes: Mapping[str, Mapping[str, str]]) -> dict[str, NumberTable]:
    """Return the tables of a picture by name: one per drawn source, unless a `FileTable` replaces it.

    `axes` are the names of the axes that columns are drawn on, by source and column. The table of a source over time
    has all its motions, including those that are drawn as bands. If that table covers only a part of the window, a
    second table has the bands over the whole window.
    """
    replaced = {source for table in picture.tables.values() for source in table.instead}
    found: dict[str, NumberTable] = {}
    for source in {**picture.traces, **picture.columns}:
        on = {name: picture.axes[axis] for name, axis in axes.get(source, {}).items() if axis in picture.axes}
        if trace := picture.traces.get(source):
            found |= _over_time(picture, source, trace, on, axes)
        elif source not in {*replaced, *found}:
            found[source] = _table(picture.columns[source], on)
    for name, table in picture.tables.items():
        found[name] = NumberTable(table.seen(picture.columns), table.units, table.note)
    return {name: table for name, table in found.items() if table.columns.keys() - {TIME_AXIS}}


def _over_time(
    picture: Picture, source: str, trace: Traces, on: Mapping[str, Axis], axes: Mapping[str, Mapping[str, str]]
) -> dict[str, NumberTable]:
    """Return the table of motions over time, and the table of their bands if the first table does not cover the
    window."""
    on = {**on, **{name: on[high] for name, (_, high) in trace.layers.items() if high in on}}
    if trace.axis in picture.axes:
        on |= {TIME_AXIS: picture.axes[TIME_AXIS], **dict.fromkeys(trace.names, picture.axes[trace.axis])}
    motions = _table(trace.file, on)
    if trace.whole:
        return {source: motions}
    bands = BAND if source == TIME else f"{source}_{BAND}"
    bounds = {name: column for name, column in picture.columns.get(bands, {}).items() if name != TIME_AXIS}
    means = _means(trace, picture.columns.get(source, {}))
    drawn = {name: column for name, column in picture.sources[source].items() if name not in trace.averaged}
    edges = {name: picture.axes[axis] for name, axis in axes.get(bands, {}).items() if axis in picture.axes}
    on_bands = {**on, **edges, **{f"{name}{MEAN}": axis for name, axis in on.items()}}
    window = _table({**drawn, **bounds, **means}, on_bands)
    return {
        source: motions._replace(note=FIRST.format(bands=bands, end=shortest(trace.end))),
        bands: window._replace(note=WHOLE.format(source=source)),
    }


def _means(trace: Traces, columns: Columns) -> Columns:
    """Return the columns that are drawn as means; for a layer, the difference between its edges."""
    moving = trace.moving or ()
    known = trace.averaged & columns.keys()
    edges = {name: trace.edges(name) for name in moving if known.issuperset(trace.edges(name))}
    return {
        f"{name}{MEAN}": columns[of[-1]] - columns[of[0]] if of[1:] else columns[name] for name, of in edges.items()
    }


def _table(columns: Columns, on: Mapping[str, Axis]) -> NumberTable:
    """Return a table of the drawn columns; for a path in a plane, with its times."""
    names = [name for name, column in columns.items() if len(column) and name in on and name != FLOOR]
    plane = TIME_AXIS in columns and TIME_AXIS not in names
    names = [TIME_AXIS, *names] if plane else names
    return NumberTable(
        {name: columns[name] for name in names}, {name: unit_of(on.get(name)) for name in names}, plane=plane
    )


def with_units(
    picture: Picture, axes: Mapping[str, Mapping[str, str]], plots: Mapping[str, Sequence[str]], source: str = ""
) -> Columns:
    """Return the columns of a table, or of a plot, under names such as "x1 [m]". The default is the first table.

    `axes` as in `tables_of`; `plots` are the sources of the curves of each plot. If a curve of a plot is in parts with
    the same columns, such as a response below and above its resonance, these are joined. Raises ValueError, with the
    names of all tables and plots, if there are no such numbers.
    """
    found = tables_of(picture, axes)
    drawn = {plot: [one for one in sources if one in found] for plot, sources in plots.items()}
    known = list(dict.fromkeys([*found, *(plot for plot, sources in drawn.items() if sources)]))
    chosen = source or known[0]
    if chosen not in known:
        raise ValueError(f"“{excerpt(str(source))}” has no numbers here: choose one of {', '.join(known)}.")
    first, *others = [found[one] for one in ([chosen] if chosen in found else drawn[chosen])]
    parts = [first, *(one for one in others if one.columns.keys() == first.columns.keys())]
    joined = {name: np.concatenate([part.columns[name] for part in parts]) for name in first.columns}
    return {headed(name, first.units[name]): column for name, column in joined.items()}


def headed(name: str, unit: str) -> str:
    """Return the name of a column with its unit in brackets; a pure number has the unit 1."""
    return f"{name} [{unit or 1}]"


def unit_of(axis: Axis | None) -> str:
    """Return the SI unit of a column that is drawn on this axis; without an axis it is a time."""
    if axis is None:
        return "s"
    if axis.si:
        return axis.si
    own = axis.factor == 1 and axis.unit in ("°", "%")  # some columns are in degrees or per cent themselves
    unit = axis.unit if own else SI.get(axis.unit, axis.unit)
    return in_ascii(unit.removeprefix("(").removesuffix(")²") if axis.power == 2 else unit)


_RAISED = re.compile("[⁻⁰¹²³⁴-⁹]+")
_ASCII = str.maketrans({
    "₀": "_0", "₁": "1", "₂": "2", "√": "sqrt", "°": "deg", "·": " ", "−": "-", "′": "'", "½": "1/2",
})  # fmt: skip


def in_ascii(text: str) -> str:
    """Return a text in ASCII: Greek letters as words, signs as ASCII signs."""
    return _RAISED.sub(lambda power: "^" + normalize("NFKC", power[0]), text).translate(_ASCII)
