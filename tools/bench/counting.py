"""The spread of the evaluations of recorded runs with rounding, counted without timing: also on a busy machine.

Solvers that choose their steps get a start that differs by one unit in its last place. That is the same motion to all
that a solver can tell: counts that differ nevertheless differ from machine to machine too.
"""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import suppress
from dataclasses import replace
from functools import cache
from math import inf, nextafter

from physics.integrators.accuracy import SYSTEMS, Run
from physics.integrators.problem import Problem, StoppedError, Watch
from physics.integrators.solvers import METHODS
from physics.reference.driven_chain import reference
from tools.bench.record import Report, Spread

ASKED = (1e-3, 1e-6, 1e-9)
LONGEST = 2.0
"""Seconds that a run took: longer ones are not repeated."""


def counted(report: Report) -> Report:
    """The report with the widest spread of each solver."""
    with ProcessPoolExecutor(2) as pool:
        spreads = [one for many in pool.map(_spreads, report.runs.values()) for one in many]
    worst: dict[str, Spread] = {}
    for spread in spreads:
        worst[spread.method] = max(worst.get(spread.method, spread), spread, key=lambda one: one.share)
    return replace(report, rounding=list(worst.values()))


@cache
def asked(system: str) -> Problem:
    """Return the problem as measured: tolerances are relative to its largest displacement."""
    problem = SYSTEMS[system].problem()
    return replace(problem, size=reference(problem).size)


def _spreads(runs: list[Run]) -> list[Spread]:
    """The evaluations of solvers at three tolerances, from the start and from the two next to it."""
    chosen = [
        run for run in runs if run.family == "adaptive" and not run.compiled and run.setting in ASKED and run.error
    ]
    chosen = [run for run in chosen if (run.time or 0.0) < LONGEST]
    return [
        Spread(run.method, run.system, run.setting, tuple(_watched(near, run).evaluations for near in neighbours(run)))
        for run in chosen
    ]


def neighbours(run: Run) -> Iterator[Problem]:
    """The problem of a run, and two with the next doubles in place of its largest start, or of a drive from rest."""
    problem = asked(run.system)
    yield problem
    place = max(range(4), key=lambda i: abs(problem.start[i]))
    for towards in (-inf, inf):
        start = list(problem.start)
        start[place] = nextafter(start[place], towards)
        x1, x2, v1, v2 = start
        moved = {"x_0": (x1, x2), "v_0": (v1, v2)} if problem.start[place] else {"F_0": nextafter(problem.F_0, towards)}
        yield replace(problem, **moved)


def _watched(problem: Problem, run: Run) -> Watch:
    watch = Watch()
    with suppress(StoppedError):
        METHODS[run.method].run(problem, run.setting, watch)
    return watch
