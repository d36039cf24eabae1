"""Columns of a picture under names with their units in SI, for files and for notebooks."""

from __future__ import annotations

import re
from collections.abc import Mapping
from unicodedata import normalize

from components.quantities.axes import Axis
from components.quantities.numbers import excerpt
from components.scene.picture import Picture
from components.scene.traces import Columns

SI = {
    "ft": "m", "ft/s": "m/s", "knots": "m/s", "km/h": "m/s", "mm": "m", "°": "rad", "%": "", "√(k₁/m₁)": "rad/s",
    "F₀/k₁": "m",
}  # fmt: skip
"""Of units that axes count in though columns do not, what the columns are in."""


def with_units(picture: Picture, axes: Mapping[str, Mapping[str, str]], source: str = "") -> Columns:
    """The columns of a source under names such as "x1 [m]"; those of the first source that has any, if none is named.

    `axes` are the names of the axes that columns are drawn on, by source and column. ValueError for a source without
    numbers, which names those that have some.
    """
    found = {
        of: {name: column for name, column in columns.items() if len(column) and name in ("t", *axes.get(of, ()))}
        for of, columns in picture.sources.items()
    }
    known = [of for of, columns in found.items() if columns]
    chosen = source or known[0]
    if chosen not in known:
        raise ValueError(f"“{excerpt(source)}” has no numbers here: choose one of {', '.join(known)}.")
    drawn = axes.get(chosen, {})
    return {headed(name, unit_of(picture.axes.get(drawn.get(name, "")))): one for name, one in found[chosen].items()}


def headed(name: str, unit: str) -> str:
    """The name of a column with its unit, 1 for a pure number."""
    return f"{name} [{unit or 1}]"


def unit_of(axis: Axis | None) -> str:
    """The unit of a column in SI, whatever the axis counts in; without an axis it is a time."""
    if axis is None:
        return "s"
    if axis.si:
        return axis.si
    own = axis.factor == 1 and axis.unit in ("°", "%")  # some columns count in these themselves
    unit = axis.unit if own else SI.get(axis.unit, axis.unit)
    return in_ascii(unit.removeprefix("(").removesuffix(")²") if axis.power == 2 else unit)


_RAISED = re.compile("[⁻⁰¹²³⁴-⁹]+")
_ASCII = str.maketrans({
    "₀": "_0", "₁": "1", "₂": "2", "√": "sqrt", "°": "deg", "·": " ", "−": "-", "′": "'", "½": "1/2",
})  # fmt: skip


def in_ascii(text: str) -> str:
    """A text in letters that every program reads."""
    return _RAISED.sub(lambda power: "^" + normalize("NFKC", power[0]), text).translate(_ASCII)
