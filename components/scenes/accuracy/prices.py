"""The list of prices: what the wanted error costs with each method, and why it has no price with the others."""

from __future__ import annotations

import re
from collections.abc import Sequence

from components.language.blocks import Block
from components.language.text import Forms
from components.layout.sheet import either, table
from components.quantities.numbers import short, three
from components.scenes.accuracy.data import Known
from physics.accuracy import Run
from physics.price import Price, prices
from physics.solvers import METHODS

ROWS = len(METHODS)
PriceRow = tuple[str, tuple[str, ...]]
"""A method and its cells."""
CELLS = ("name", "time", "ratio")
NEVER = ("floor", "finest", "spacing")
"""Why a method is refined no further although time is left: then it does not get there."""


def price_list(measured: Known, methods: Sequence[str], wanted: float) -> list[PriceRow]:
    """Rows (method, cells), cheapest first, then what does not get there, then what has no result."""
    found = {method: runs for method in methods if (runs := measured.of(method))}
    closed, recorded = measured.of("closed"), measured.before.by_method.get("closed", ())
    here, before = (next((price.time for price in prices([runs], wanted)), None) for runs in (closed, recorded))
    rows = []
    for price in prices(found.values(), wanted):
        unit = here if measured.is_here(price.method) else before
        rows.append((price.method, price_cells(price, unit, found[price.method][-1])))
    known = {method for method, _ in rows}
    return rows + [
        (method, (METHODS[method].mark, "no result", _why(runs[-1])))
        for method, runs in found.items()
        if method not in known
    ]


def price_cells(price: Price, unit: float | None, last: Run) -> tuple[str, ...]:
    """Name, run time and its ratio to the closed form's; or why not, by the method's last run, and the best error."""
    name = METHODS[price.method].mark
    if price.time is None:
        return name, _not_reached(price, last), f"best {short(float(f'{price.best:.0e}'))}"
    unsteady = "" if price.repeats is not False else " ±"
    ratio = f"× {short(price.time / unit)}" if unit else ""
    return name, f"{time_text(price.time)}{unsteady}", ratio


def _not_reached(price: Price, last: Run) -> str:
    if price.end in NEVER:
        return "never"
    return _in_words(last.failure) if price.end == "time limit" and last.failure else "not yet"


def _why(last: Run) -> str:
    """Why a method has no result at all."""
    reason = _in_words(last.failure or "")
    reason = reason.partition(":")[0] if "cannot" in reason or "unstable" in reason else reason
    return re.sub(r"\d(\.\d+)?e[+-]\d+", lambda match: short(float(match[0])), reason)


def _in_words(failure: str) -> str:
    return failure.replace("time limit", "over").replace("omega_+", "ω₊").replace("omega", "ω")


def time_text(seconds: float) -> str:
    """A run time as a person says it."""
    return f"{three(seconds * 1e3)} ms" if seconds < 1 else f"{three(seconds)} s"


def price_texts(rows: Sequence[PriceRow]) -> dict[str, str]:
    return {
        f"price{i}_{cell}": text for i, (_, cells) in enumerate(rows) for cell, text in zip(CELLS, cells, strict=True)
    }


def price_forms(rows: Sequence[PriceRow], measured: Known) -> dict[str, str]:
    """Rows read from records are quiet where others were measured here."""
    return {
        f"price{i}": "before" if measured.here.every and not measured.is_here(method) else "here"
        for i, (method, _) in enumerate(rows)
    }


def price_rows(phone: int) -> Block:
    """The methods in the order of what the wanted error costs with each."""
    return table(*([_cell(f"price{i}", cell) for cell in CELLS] for i in range(ROWS)), style="tight", phone=phone)


def _cell(form: str, cell: str) -> Forms:
    return either(form, here=f"{{{form}_{cell}}}", before=f"[mute|{{{form}_{cell}}}]")


def power(value: float) -> str:
    """A number in which 1·10⁻⁶ is 10⁻⁶."""
    return short(value).removeprefix("1·")
