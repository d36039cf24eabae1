"""The list of prices: what the wanted error costs with each method, and why it has no price with the others."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from components.quantities.numbers import short, three
from components.scenes.accuracy.data import Known
from physics.accuracy import Run
from physics.price import Price, dearness, in_doubles, prices
from physics.solvers import METHODS

PriceRow = tuple[str, tuple[str, ...]]
"""A method and its cells."""
NEVER = ("floor", "finest", "spacing")
"""Why a method is refined no further although time is left: then it does not get there."""


def price_list(measured: Known, methods: Sequence[str], wanted: float, unit: str = "app") -> list[PriceRow]:
    """Rows (method, cells), cheapest first, then what does not get there, then what has no result.

    Ratios are to the closed form, of the same machine: as the app runs it, or in doubles with the `unit` "doubles".
    """
    found = {method: runs for method in methods if (runs := measured.of(method))}
    here, before, compiled = (
        {price.method: price for price in prices(series.by_method.values(), wanted)}
        for series in (measured.here, measured.before, measured.compiled)
    )
    units = {True: _unit(here, unit), False: _unit(before, unit)}
    quoted = ((here if measured.is_here(slug) else before).get(slug) for slug in found)
    rows = []
    for price in sorted(filter(None, quoted), key=dearness):
        slug = price.method
        own = price_cells(price, units[measured.is_here(slug)], found[slug][-1])
        other = compiled.get(slug)
        name, evaluations = own[0], evaluations_text(slug, _evaluations(price, other))
        rows.append((slug, (name, evaluations, *own[1:], *_timed(other, units[False]))))
    known = {method for method, _ in rows}
    return rows + [
        (method, (METHODS[method].mark, "", "no result", _why(runs[-1]), *_timed(compiled.get(method), units[False])))
        for method, runs in found.items()
        if method not in known
    ]


def _evaluations(*prices: Price | None) -> float | None:
    """Of the first that has them: they are the same in Python and compiled."""
    return next((price.evaluations for price in prices if price and price.evaluations is not None), None)


def _unit(quoted: Mapping[str, Price], unit: str) -> float | None:
    """The run time of the closed form."""
    price = in_doubles(quoted) if unit == "doubles" else quoted.get("closed")
    return price.time if price else None


def evaluations_text(method: str, evaluations: float | None) -> str:
    """Evaluations of the right-hand side, or outputs of a method that has none."""
    if evaluations is None:
        return ""
    if METHODS[method].family in ("closed", "exact"):
        return "outputs"
    return short(float(f"{evaluations:.1e}"))


def _timed(price: Price | None, unit: float | None) -> tuple[str, str]:
    """A run time and its ratio, where there is one."""
    if price is None or price.time is None:
        return "", ""
    unsteady = "" if price.repeats is not False else " ±"
    return f"{three(1e3 * price.time)}{unsteady}", short(price.time / unit) if unit else ""


def price_cells(price: Price, unit: float | None, last: Run) -> tuple[str, ...]:
    """Name, run time and its ratio to the closed form's; or why not, by the method's last run, and the least error."""
    name = METHODS[price.method].mark
    if price.time is None:
        return name, _not_reached(price, last), f"≥ {short(float(f'{price.best:.0e}'))}"
    return name, *_timed(price, unit)


def _not_reached(price: Price, last: Run) -> str:
    if price.end in NEVER:
        return "never"
    return _in_words(last.failure) if price.end == "time limit" and last.failure else "not yet"


def _why(last: Run) -> str:
    """Why a method has no result at all, up to what follows a colon."""
    reason = _in_words(last.failure or "").partition(":")[0]
    return re.sub(r"\d(\.\d+)?e[+-]\d+", lambda match: short(float(match[0])), reason)


def _in_words(failure: str) -> str:
    return failure.replace("time limit", "over").replace("omega_+", "ω₊").replace("omega", "ω")


def time_text(seconds: float) -> str:
    """A run time as a person says it."""
    return f"{three(seconds * 1e3)} ms" if seconds < 1 else f"{three(seconds)} s"


def power(value: float) -> str:
    """A number in which 1·10⁻⁶ is 10⁻⁶."""
    return short(value).removeprefix("1·")
