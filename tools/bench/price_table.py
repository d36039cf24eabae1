"""The prices of an error on one system, in Python and compiled: a table of the document."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from math import inf, ulp

from components.scenes.accuracy.prices import NEVER
from physics.integrators.accuracy import SYSTEMS, Run
from physics.integrators.fixed_steps import STEPPING
from physics.integrators.price import Price, grouped, in_doubles, prices
from physics.integrators.solvers import ATOL, IN_PYTHON, METHODS
from tools.bench.estimates import Estimate, RunsBySystem, estimate, time_of_one

HEAD = ["method", "evaluations", "Python", "× app", "× doubles", "compiled", "× doubles", "best error"]
APART = 1.3
"""Ratios of two recordings that differ by more are marked."""
SETTINGS = {"closed": "", "exact": "", "fixed": "{:g} steps an output", "adaptive": "rtol {:g}, atol {:g}"}
Quotes = dict[tuple[str, bool], Price]
"""Prices by method and by whether it was compiled."""


def price_table(runs: list[Run], wanted: float, record: RunsBySystem | None = None) -> list[str]:
    """The price of an error on one system; where it was not measured, an estimate from the record."""
    first, second = _quotes(runs, wanted), _quotes(_once_more(runs), wanted)
    known = record or {runs[0].system: runs}
    lines = [line(HEAD), line(["---"] * len(HEAD))]
    for slug in grouped(run for run in runs if not run.compiled):
        both = [first.get((slug, kind)) for kind in (False, True)]
        counts = [price.evaluations for price in both if price and price.evaluations is not None]
        guess = Estimate(counts[0]) if counts else estimate(known, runs[0].system, slug, wanted)
        cells = []
        for kind, price in zip((False, True), both, strict=True):
            if price and price.time is not None:
                cells += _price_cells(price, first, second)
            else:
                one = time_of_one(known, runs[0].system, slug, kind)
                own = [run for run in runs if (run.method, run.compiled) == (slug, kind)]
                if not own and one and not counts:  # it has the errors that it has in Python
                    own = [run for run in runs if run.method == slug]
                told = _reason(own, price) or _guessed(guess, runs[0].system, one, slug)
                cells += [told, *[""] * (1 if kind else 2)]
        guessed = guess and not counts and any(cell.startswith(("about", "at least")) for cell in cells)
        count = guess.text(evaluations_text(slug, guess.evaluations)) if guess and guessed else ""
        lines.append(
            line([doc_name(slug), evaluations_text(slug, counts[0]) if counts else count, *cells, _best(both)])
        )
    return [*lines, ""]


def _price_cells(price: Price, first: Quotes, second: Quotes) -> list[str]:
    """The time and its ratios."""
    marks = " °" * (price.compiled and price.method in IN_PYTHON) + " †" * (price.repeats is False)
    units = zip(_units(first, price.compiled), _units(second, price.compiled), strict=True)
    again = second.get((price.method, price.compiled))
    return [time_text(price.time) + marks, *(_ratio(price, again, one, two) for one, two in units)]


def _reason(own: Sequence[Run], price: Price | None) -> str:
    """Why there is no time, or "" if only time was short or nothing was measured."""
    end = own[-1].end if own else "time limit"
    if end == "time limit":
        return ""
    return "never" if end in NEVER else "not refined so far" if price else f"none: {own[-1].failure}"


def _guessed(guess: Estimate | None, system: str, one: float | None, method: str) -> str:
    """Return an estimate of the time from that of one evaluation in s."""
    if one is None:
        return ""
    if guess is None:
        return "not in time"
    return "never" if guess.evaluations > _most(system, method) else guess.text(time_text(guess.evaluations * one))


def _most(system: str, method: str) -> float:
    """Evaluations with steps as short as the spacing of doubles at the end of the motion."""
    end = float(SYSTEMS[system].problem().t[-1])
    return end / ulp(end) * STEPPING[method].evaluations if method in STEPPING else inf


def _best(both: Iterable[Price | None]) -> str:
    """The best error of a method where it is not good enough, in Python and compiled."""
    late = [price for price in both if price and price.time is None]
    return ", ".join(f"{price.best:.1e}{' compiled' if price.compiled else ''}" for price in late)


def _quotes(runs: list[Run], wanted: float) -> Quotes:
    found: Quotes = {}
    for kind in (False, True):
        many = grouped(run for run in runs if run.compiled == kind).values()
        found |= {(price.method, kind): price for price in prices(many, wanted)}
    return found


def _once_more(runs: list[Run]) -> list[Run]:
    """Return the runs with their second times, without those that have none."""
    return [replace(run, time=run.again) for run in runs if run.again or run.failure]


def _units(quotes: Quotes, compiled: bool) -> list[float | None]:
    """Run times of the closed form: in Python as the app runs it, and in doubles in the same language."""
    same = {slug: price for (slug, kind), price in quotes.items() if kind == compiled}
    found = [in_doubles(same)] if compiled else [same.get("closed"), in_doubles(same)]
    return [price.time if price else None for price in found]


def _ratio(price: Price, second: Price | None, unit: float | None, other: float | None) -> str:
    """Return the ratio, with that of the second recording in brackets."""
    if not unit or price.time is None:
        return ""
    ratio = price.time / unit
    if second is None or second.time is None or not other:
        return f"{ratio:.3g}"
    again = second.time / other
    mark = "" if max(ratio, again) <= APART * min(ratio, again) else " ‡"
    return f"{ratio:.3g} ({again:.3g}){mark}"


def doc_name(slug: str) -> str:
    """A method, and whether its equations are solved in advance."""
    method = METHODS[slug]
    return f"{method.name}{', systems solved in advance' if method.solved else ''}"


def evaluations_text(slug: str, evaluations: float | None) -> str:
    """Evaluations, or outputs of a method that has none."""
    if evaluations is None:
        return ""
    return f"{evaluations:.3g}{' outputs' if METHODS[slug].family in ('closed', 'exact') else ''}"


def line(cells: Iterable[str]) -> str:
    return "| " + " | ".join(cells) + " |"


def setting_text(run: Run) -> str:
    return SETTINGS[run.family].format(run.setting, ATOL * run.setting)


def time_text(seconds: float | None) -> str:
    return f"{1e3 * (seconds or 0):.3g} ms" if (seconds or 0) < 1 else f"{seconds:.3g} s"
