"""The price of an error with each method: the one rule by which prices are read off measured runs."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import repeat
from math import exp, log
from typing import Any

from physics.integrators.accuracy import Run
from physics.integrators.solvers import METHODS

LEAST = 1e-17
"""The error drawn for 0 on logarithmic scales: a double has no more digits."""
ErrorAndRun = tuple[float, Run]
Offer = tuple[float, float, list[Run]]
"""Run time, evaluations and the runs that they are read off."""


@dataclass(frozen=True, kw_only=True)
class Price:
    """The cost of an error with one method.

    Attributes
    ----------
    method : str
        The slug of the method.
    time, evaluations : float or None
        The run time in s and the evaluations; None if the error was not reached.
    best : float
        The smallest error of the method.
    end : str
        Why the method was not refined further; "" where it was cut short.
    repeats : bool or None
        True if the run times repeat within 20 %; None where they were measured once.
    compiled : bool
        True if the method was compiled.
    """

    method: str
    time: float | None
    evaluations: float | None
    best: float
    end: str
    repeats: bool | None = None
    compiled: bool = False

    @property
    def name(self) -> str:
        """The name of the method."""
        return METHODS[self.method].name


IN_DOUBLES = ("eigh", "slides")
"""Closed forms in plain doubles: the modes, or for a dashpot the textbook formulas."""


def in_doubles(of: Mapping[str, Price]) -> Price | None:
    """Return the price of the closed form in doubles, `of` the prices by method; None if it is not among them."""
    return next((of[slug] for slug in IN_DOUBLES if slug in of), None)


def grouped(runs: Iterable[Run]) -> dict[str, list[Run]]:
    """Return the `runs` by method, in their order."""
    found: dict[str, list[Run]] = {}
    for run in runs:
        found.setdefault(run.method, []).append(run)
    return found


def prices(methods: Iterable[Sequence[Run]], wanted: float) -> list[Price]:
    """Return the prices of the error `wanted`, cheapest first, by the runs of each of `methods` that has a result."""
    found = [price(many, wanted) for many in methods if any(run.error is not None for run in many)]
    return sorted(found, key=dearness)


def dearness(price: Price) -> tuple[bool, float, float]:
    """Return the key that sorts by `price`; methods that do not reach the error are last."""
    return price.time is None, price.time or 0.0, price.best


def price(runs: Sequence[Run], wanted: float) -> Price:
    """Return the price of the error `wanted` with one method, by its `runs` from coarse to fine.

    It is the least run time at which the straight lines from run to run, both axes logarithmic, are good enough.
    At least one run must have a result.
    """
    good = [run for run in runs if run.error is not None]
    errors = [max(run.error or 0.0, LEAST) for run in good]
    facts: dict[str, Any] = {"method": good[0].method, "best": min(errors), "end": runs[-1].end}
    facts["compiled"] = good[0].compiled
    points = list(zip(errors, good, strict=True))
    offers = [offer for offer in map(_offer, [None, *points], points, repeat(wanted)) if offer]
    if not offers:
        return Price(time=None, evaluations=None, **facts)
    time, evaluations, pair = min(offers, key=lambda offer: offer[0])
    told = [run.repeats for run in pair]
    return Price(time=time, evaluations=evaluations, repeats=None if None in told else all(told), **facts)


def _offer(before: ErrorAndRun | None, point: ErrorAndRun, wanted: float) -> Offer | None:
    """The cheapest good enough point of the line that ends in a run."""
    error, run = point
    if before is None or (before[0] > wanted) == (error > wanted):
        return _itself(run) if error <= wanted else None
    error_before, coarser = before
    share = log(error_before / wanted) / log(error_before / error)
    time = _between(coarser.time or 0.0, run.time or 0.0, share)
    there = (time, _between(coarser.evaluations, run.evaluations, share), [coarser, run])
    return there if error > wanted or time < (run.time or 0.0) else _itself(run)


def _itself(run: Run) -> Offer:
    return run.time or 0.0, float(run.evaluations), [run]


def _between(start: float, end: float, share: float) -> float:
    """Logarithmically so far from one to the other."""
    return start * exp(share * log(end / start)) if start > 0 else end


def at_error(runs: Sequence[Run], wanted: float) -> Run | None:
    """Return the first of the `runs` of a method whose error is at most `wanted`; None if there is none."""
    return next((run for run in runs if run.error is not None and run.error <= wanted), None)


def at_cost(runs: Sequence[Run], seconds: float) -> Run | None:
    """Return the finest of the `runs` of a method that takes at most so many `seconds`; None if there is none."""
    return next((run for run in reversed(runs) if run.time is not None and run.time <= seconds), None)
