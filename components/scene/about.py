"""The window 'About these numbers': error bounds of the drawn numbers, and a few points in arbitrary precision."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence, Sized
from dataclasses import dataclass
from decimal import ROUND_CEILING, Context, Decimal
from math import ulp
from typing import NamedTuple, TypeVar

import numpy as np

from components.language.expressions import Name
from components.language.messages import AboutNumbers, AboutPoint, AboutTable
from components.layout.text import rich
from components.quantities.formatting import MINUS, PLAIN_EXPONENTS, short, shortest, ten_to, three
from components.quantities.refusals import SORRY, as_on_screen, in_words, report
from components.scene.traces import BAND, Columns, Floats, band_columns
from physics.precision.exact import precise
from physics.reference.driven_chain import Point

SHARES = (0.21, 0.55, 0.93)
"""Positions of the checked points in a column, as shares of its length. The shares are no round numbers, so that the
points are at no special times."""
PLACES = 20
READING = (
    "**Shown**: the computed number that is drawn, a double of about 16 digits, in SI units and radians. **Exact**: "
    "its value by other formulas, with 40 digits or more. Digits that differ are grey. An **ulp**, a unit in the last "
    "place, is the step from one double to the next: at most 2 in the 16th digit of the size that is named."
)
NO_BAND = "All curves are drawn as lines."
One = TypeVar("One", bound=Name)


@dataclass(frozen=True)
class CheckedPoint:
    """One number: its name and position (texts for `rich`), the drawn value, and the exact one."""

    name: str
    place: str
    drawn: float
    true: Point

    @property
    def off(self) -> float:
        """The difference between `drawn` and `true` in ulp (units in the last place) of `true.size`."""
        with precise():
            unit = ulp(min(float(self.true.size), sys.float_info.max))
            return float(abs(Decimal(self.drawn) - self.true.value) / Decimal(unit))


@dataclass(frozen=True)
class Table:
    """A table of checked points, and the sentence that bounds their errors, by `limit` ulp."""

    bound: str
    limit: float
    rows: tuple[CheckedPoint, ...]


@dataclass(frozen=True)
class About:
    """The tables of 'About these numbers', with sentences on the drift of the energy and on envelopes."""

    tables: tuple[Table, ...]
    energy: str = ""
    envelope: str = NO_BAND


def few(column: Sized) -> list[int]:
    """Return the indices of the entries at `SHARES` of the length."""
    return [round(share * (len(column) - 1)) for share in SHARES] if len(column) else []


def few_of(column: Floats) -> list[float]:
    """Return the entries of a column at the indices `few`."""
    entries: list[float] = column[few(column)].tolist()
    return entries


def bounded(names: str, limit: float, of: str, rows: Iterable[CheckedPoint]) -> Table:
    """Return a table with its bound: the error of `names` is at most `limit` ulp of `of`, rounded up to 3 digits."""
    limit = float(Context(prec=3, rounding=ROUND_CEILING).create_decimal(limit))
    bound = f"The error of {names} is at most {short(limit)} ulp of {of}."
    return Table(bound, limit, tuple(rows))


class Place(NamedTuple):
    """The variable that a curve is drawn against: its column, its symbol and its unit."""

    column: str
    symbol: str
    unit: str


TIME = Place("t", "$t$", "s")


def rows(
    names: Mapping[One, str],
    columns: Columns,
    true: Mapping[str, Sequence[Point]],
    place: Place = TIME,
    at: list[int] | None = None,
) -> list[CheckedPoint]:
    """Return `points` of curves that are named by declared objects."""
    return points(_by_name(names), columns, true, place, at)


def points(
    names: Mapping[str, str],
    columns: Columns,
    true: Mapping[str, Sequence[Point]],
    place: Place = TIME,
    at: list[int] | None = None,
) -> list[CheckedPoint]:
    """Return points of the named curves, at the indices `at` (default: a few), ordered by place."""
    found = []
    for n, i in enumerate(few(columns[place.column]) if at is None else at):
        where = f"{place.symbol} = {every_digit(columns[place.column][i])} {place.unit}"
        found += [
            CheckedPoint(text, where, float(columns[name][i]), true[name][n])
            for name, text in names.items()
            if name in columns
        ]
    return found


def _by_name(names: Mapping[One, str]) -> dict[str, str]:
    return {one.name: text for one, text in names.items()}


def every_digit(value: float) -> str:
    """Return a number with all its digits, with which a reader can recompute the point."""
    head, _, power = shortest(float(value)).replace("-", MINUS).partition("e")
    return head + (ten_to(int(power.replace(MINUS, "-"))) if power else "")


def drift(total: Floats, level: float, what: str = "$T + V$", unit: str = "J") -> str:
    """Return a sentence that says by how much a conserved quantity changes over the window."""
    if not level:
        return f"{what} is 0: nothing moves."
    strays = float(np.max(np.abs(total / level - 1)))
    by = f"changes by at most {short(strays)} of this value" if strays else "keeps every digit"
    return f"{what} = {three(level)} {unit}; over the window it {by}."


def drawn_as_bands(columns: Mapping[str, Columns], names: Mapping[One, str]) -> str:
    """Return the sentence of `bands_among` for curves that are named by declared objects."""
    return bands_among(columns, _by_name(names))


def bands_among(columns: Mapping[str, Columns], names: Mapping[str, str]) -> str:
    """Return a sentence that says which of the named curves are drawn as bands."""
    drawn = columns.get(BAND, {})
    bands = list(dict.fromkeys(text for name, text in names.items() if band_columns(name)[0] in drawn))
    if not bands:
        return f"{NO_BAND} Each has at least 12 points a swing."
    one = len(bands) == 1
    return (
        f"{listed(bands)} {'is' if one else 'are'} too fast for a line and drawn as an **envelope**: the band that "
        f"the motion fills. {'It has' if one else 'They have'} no single points to recompute."
    )


def listed(names: Sequence[str]) -> str:
    """Return a list in words: a, b and c."""
    return " and ".join(part for part in (", ".join(names[:-1]), names[-1]) if part)


def digits(value: Decimal) -> str:
    """Return a number with twenty significant digits."""
    if not value:
        return "0"
    with precise():
        rounded = Decimal(f"{value:.{PLACES - 1}e}")
        if rounded.adjusted() in PLAIN_EXPONENTS:
            return f"{rounded:.{PLACES - 1 - rounded.adjusted()}f}".replace("-", MINUS)
        mantissa = f"{rounded.scaleb(-rounded.adjusted()):.{PLACES - 1}f}"
        return mantissa.replace("-", MINUS) + ten_to(rounded.adjusted())


def reason_of(error: ValueError) -> str:
    """Return the message of an error without its full stop, for use inside a sentence."""
    text = as_on_screen(str(error)).rstrip(".")
    return re.sub(r"(?<=\d)e\+?(-?\d+)", lambda found: ten_to(int(found[1])), text)


def about_numbers(ask: Callable[[], About | None], answer: int | None = None) -> AboutNumbers:
    """Return the message about the errors of a scene's numbers, or the reason if there is none."""
    try:
        with in_words():
            return _numbers(ask() or About(()), answer)
    except ValueError as reason:
        note = f"These numbers cannot be recomputed: {reason_of(reason)}."
    except Exception as error:
        report(error)
        note = SORRY
    return no_numbers(note, answer)


def no_numbers(reason: str, answer: int | None = None) -> AboutNumbers:
    """Return the message that gives a reason in place of numbers."""
    return AboutNumbers(answer=answer, reading="", tables=(), notes=(rich(reason),))


def _numbers(about: About, answer: int | None) -> AboutNumbers:
    tables = tuple(AboutTable(rich(each.bound), tuple(map(_point, each.rows))) for each in about.tables if each.rows)
    notes = tuple(rich(text) for text in (about.energy, about.envelope) if text)
    return AboutNumbers(answer=answer, reading=rich(READING) if tables else "", tables=tables, notes=notes)


def _point(row: CheckedPoint) -> AboutPoint:
    return AboutPoint(
        name=rich(row.name),
        place=rich(row.place),
        drawn=digits(Decimal(row.drawn)),
        true=digits(row.true.value),
        off=f"{row.off:.2f}" if row.off < 1000 else three(row.off),
    )
