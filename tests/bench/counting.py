"""Jacobians, factorisations and solves of recorded runs, counted in runs without timing."""

from __future__ import annotations

from dataclasses import replace

from physics.integrators.accuracy import SYSTEMS, Run
from physics.integrators.fixed_steps import STEPPING
from physics.integrators.problem import Problem, Watch
from physics.integrators.race import counts
from physics.integrators.solvers import METHODS
from tests.bench.record import Report


def counted(report: Report) -> Report:
    """The report with these counts for all runs that have a result; times, errors and evaluations stay."""
    runs = {slug: [_counted(SYSTEMS[slug].problem(), run) for run in many] for slug, many in report.runs.items()}
    return replace(report, runs=runs)


def _counted(problem: Problem, run: Run) -> Run:
    if run.error is None:
        return run
    if run.family == "fixed":
        solved = STEPPING[run.method].solved
        return replace(run, factorisations=int(solved), solves=run.steps if solved else 0)
    if run.family != "adaptive":
        return run
    watch = Watch()
    METHODS[run.method].run(problem, run.setting, watch)
    found = counts(watch)
    return replace(run, **{name: found[name] for name in ("jacobians", "factorisations", "solves")})
