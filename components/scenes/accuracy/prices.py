"""The list of prices: what the wanted error costs with each method, and which of them do not get there."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from components.quantities.formatting import short, three
from components.scenes.accuracy.data import Known
from physics.integrators.accuracy import Run
from physics.integrators.price import Price, in_doubles, prices
from physics.integrators.solvers import IN_PYTHON, METHODS

PriceRow = tuple[str, tuple[str, ...]]
"""A method and its cells."""
NEVER = ("floor", "finest", "spacing")
"""Why a method is refined no further although time is left: then it does not get there."""


def price_list(
    measured: Known, methods: Sequence[str], wanted: float, unit: str = "app", compiled: bool = False
) -> list[PriceRow]:
    """Return rows (method, cells) of the methods that reach the wanted error, cheapest first.

    Ratios are to the closed form, of the same machine: as the app runs it, or in doubles with the `unit` "doubles".
    Next to `compiled` methods, those that are not compiled are marked and have no ratio.
    """
    units = {
        here: _unit({price.method: price for price in prices(series.by_method.values(), wanted)}, unit)
        for here, series in ((True, measured.here), (False, measured.before))
    }
    quoted = (one for one in _quoted(measured, methods, wanted) if one.time is not None)
    rows = [(one, units[measured.is_here(one.method)]) for one in quoted]
    return [
        (one.method, price_cells(one, None, " (Python)") if compiled and not one.compiled else price_cells(one, unit))
        for one, unit in rows
    ]


def method_name(price: Price) -> str:
    """The name, with a mark where only the right-hand side is compiled."""
    return METHODS[price.method].mark + (" °" if price.compiled and price.method in IN_PYTHON else "")


def _quoted(measured: Known, methods: Sequence[str], wanted: float) -> list[Price]:
    return prices((runs for method in methods if (runs := measured.of(method))), wanted)


def unreached(measured: Known, methods: Sequence[str], wanted: float) -> str:
    """Return a sentence on the methods that do not reach the wanted error: the best error of each, and the reason."""
    quoted = _quoted(measured, methods, wanted)
    told = [
        f"{METHODS[one.method].mark} ({_best(one.best)}, {_not_reached(one, measured.of(one.method)[-1])})"
        for one in quoted
        if one.time is None
    ]
    known = {one.method for one in quoted}
    told += [
        f"{METHODS[slug].mark} ({_why(runs[-1])})"
        for slug in methods
        if slug not in known and (runs := measured.of(slug))
    ]
    return f"Not reached: {', '.join(told)}." if told else ""


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


def price_cells(price: Price, unit: float | None, mark: str = "") -> tuple[str, ...]:
    """Name with a mark, evaluations, run time in ms, and its ratio to the closed form's where there is one."""
    time, unsteady = price.time or 0.0, "" if price.repeats is not False else " ±"
    ratio = short(time / unit) if unit else ""
    name, evaluations = method_name(price), evaluations_text(price.method, price.evaluations)
    return name + mark, evaluations, f"{three(1e3 * time)}{unsteady}", ratio


def _best(best: float) -> str:
    return f"{short(float(f'{best:.0e}'))} at best"


def _not_reached(price: Price, last: Run) -> str:
    if price.end in NEVER:
        return "no finer"
    return _in_words(last.failure) if price.end == "time limit" and last.failure else "not refined so far"


def _why(last: Run) -> str:
    """Why a method has no result at all, up to what follows a colon."""
    reason = _in_words(last.failure or "").partition(":")[0]
    return re.sub(r"\d(\.\d+)?e[+-]\d+", lambda match: short(float(match[0])), reason)


def _in_words(failure: str) -> str:
    return failure.replace("time limit", "more than").replace("omega_+", "ω₊").replace("omega", "ω")


def time_text(seconds: float) -> str:
    """A run time as a person says it."""
    return f"{three(seconds * 1e3)} ms" if seconds < 1 else f"{three(seconds)} s"


def power(value: float) -> str:
    """A number in which 1·10⁻⁶ is 10⁻⁶."""
    return short(value).removeprefix("1·")
