"""Evaluations and times of runs that would have taken too long, estimated from the record.

In this order:

- A method whose error falls already: on along its own line, with fixed steps by its order, else by its last two runs.
- Where a fast oscillation carries part of the motion: from Benign. The error of a method grows with the number of
  oscillations, so it takes as many evaluations an oscillation as an error that is smaller by the ratio of those numbers
  takes on Benign.
- Otherwise stability limits the steps: at least the evaluations of the run that was stopped, continued to its end.

Times are evaluations by the time of one: that of the finest run in the same language, on Benign where there is none.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from math import log

from physics.integrators.accuracy import OUTPUTS, SYSTEMS, Run
from physics.integrators.exponential_steps import EXPONENTIAL
from physics.integrators.fixed_steps import STEPPING
from physics.integrators.price import grouped, price
from physics.integrators.solvers import METHODS
from physics.integrators.stiffness import stiffness

FALLING = 0.1
"""A larger error does not yet fall as the order says."""
RunsBySystem = Mapping[str, Sequence[Run]]


@dataclass(frozen=True)
class Estimate:
    """Evaluations that an error needs with one method, or the least of them."""

    evaluations: float
    least: bool = False

    def text(self, amount: str) -> str:
        """An amount of this estimate in words: about 2e+07, at least 2e+07."""
        return f"{'at least' if self.least else 'about'} {amount}"


def estimate(runs: RunsBySystem, system: str, method: str, wanted: float) -> Estimate | None:
    """Return the evaluations needed for an error, or None if the record does not determine them."""
    own = [run for run in runs[system] if run.method == method]
    if found := _continued(own, wanted) or from_benign(runs, system, method, wanted):
        return Estimate(found)
    whole = [count for run in own if run.failure and run.end == "time limit" and (count := _whole(run))]
    return Estimate(min(whole), least=True) if whole else None


def from_benign(runs: RunsBySystem, system: str, method: str, wanted: float) -> float | None:
    """Return the evaluations on a highly oscillatory motion, with the cost per oscillation of Benign."""
    measure = stiffness(SYSTEMS[system], runs[system])
    if not measure or measure.kind != "highly oscillatory" or method in EXPONENTIAL:
        return None
    more = _oscillations(system) / _oscillations("benign")
    benign = [run for run in runs.get("benign", ()) if run.method == method]
    found = _reached(benign, wanted / more) or _continued(benign, wanted / more)
    return more * found if found else None


def checked(runs: RunsBySystem, wanted: Iterable[float]) -> list[float]:
    """Return ratios of the estimates from Benign to measured values, where both are known."""
    ratios = []
    for (system, many), error in product(runs.items(), wanted):
        for method in grouped(many):
            measured = _reached([run for run in many if run.method == method], error)
            guess = from_benign(runs, system, method, error) if measured else None
            if guess and measured and METHODS[method].family in ("fixed", "adaptive"):
                ratios.append(guess / measured)
    return ratios


def time_of_one(runs: RunsBySystem, system: str, method: str, compiled: bool) -> float | None:
    """The run time of an evaluation, in s."""
    for slug in (system, "benign"):
        timed = [
            run for run in runs.get(slug, ())
            if (run.method, run.compiled) == (method, compiled) and run.time and run.evaluations
        ]  # fmt: skip
        if timed:
            finest = max(timed, key=lambda run: run.evaluations)
            return (finest.time or 0.0) / finest.evaluations
    return None


def _oscillations(slug: str) -> float:
    """The number of fast oscillations of a motion."""
    slow, fast = SYSTEMS[slug].rates
    return fast / slow * SYSTEMS[slug].periods


def _reached(runs: Sequence[Run], wanted: float) -> float | None:
    """The evaluations of an error that was reached."""
    counts = [price(many, wanted).evaluations for many in _by_language(runs)]
    return min((count for count in counts if count), default=None)


def _continued(runs: Sequence[Run], wanted: float) -> float | None:
    """The evaluations of an error that is further down the line of a method."""
    lines = [sorted(many, key=lambda run: run.evaluations) for many in _by_language(runs)]
    lines = [line for line in lines if line and (line[-1].error or 1.0) < FALLING]
    if not lines:
        return None
    line = max(lines, key=lambda many: many[-1].evaluations)
    last, order = line[-1], _order(line)
    return last.evaluations * ((last.error or wanted) / wanted) ** (1 / order) if order else None


def _order(line: Sequence[Run]) -> float | None:
    """The power of the evaluations with which the error falls."""
    if METHODS[line[0].method].family == "fixed":
        return METHODS[line[0].method].order
    falling = [run for run in line if run.error and run.error < FALLING][-2:]
    if len(falling) < 2:
        return None
    (one, first), (two, second) = ((run.evaluations, run.error or 1.0) for run in falling)
    return log(first / second) / log(two / one) if second < first and one < two else None


def _by_language(runs: Iterable[Run]) -> list[list[Run]]:
    good = [run for run in runs if run.error is not None and run.time is not None]
    return [many for kind in (False, True) if (many := [run for run in good if run.compiled == kind])]


def _whole(run: Run) -> float | None:
    """The evaluations of a run that was stopped, had it gone on to the end."""
    if run.family == "fixed":
        return run.setting * OUTPUTS * STEPPING[run.method].evaluations
    return run.evaluations / run.reached if run.reached else None
