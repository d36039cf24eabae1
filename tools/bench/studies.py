"""Studies beyond the race over 50 periods: other lengths, and where digits beyond a double's begin to matter."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from statistics import median
from typing import Any

import numpy as np

from physics.coupled import TwoMassChain
from physics.integrators.accuracy import SYSTEMS, Limits, Run, System
from physics.integrators.fixed_steps import STEPPING as STEPS
from physics.integrators.fixed_steps import advance_of, begun, interpreted, right_hand_side
from physics.integrators.problem import Problem, StoppedError, Watch
from physics.integrators.race import Bench, bench_of, clock, yardstick
from physics.integrators.solvers import METHODS
from physics.integrators.stability import step_matrix
from physics.precision.exact import Array
from physics.reference.driven_chain import Reference, reference

LENGTHS = (5, 10, 20, 50, 100, 200, 500)
OUTPUTS = 100
EVALUATIONS_A_PERIOD = 2800  # whole steps from output to output with 1, 2, 4, 5 or 7 evaluations a step
PATIENCE = 10.0
STEPPING = ("verlet", "newmark", "rk4", "gauss4", "nystrom6", "yoshida6")
TOLERANCES = {"dop853": 1e-6, "lsoda": 1e-6, "rk45": 1e-6}
AS_MATRIX, MANY, TURNS = ("verlet", "rk4", "nystrom6", "gauss4"), 20_000, 9
WITHOUT = ("closed", "slides", "eigh", "naive")

NEIGHBOURS = (1.0, 1.17, 1.41, 1.73)

StudyCurves = dict[str, list[float | None]]
"""Columns: "x", and the largest error of each method there, None where it has no answer."""


def lengths(limits: Limits) -> list[Run]:
    """The benign chain for 5 to 500 slow periods and 100 outputs, all fixed steps with equally many evaluations in a
    period, tolerances kept; `setting` is the length.

    Every method in turn at each length, and all of that in two rounds.
    """
    pace, benign = median(yardstick() for _ in range(5)), SYSTEMS["benign"]
    patient = replace(limits, seconds=PATIENCE)
    benches = {n: bench_of(benign, patient, lambda _: False, pace, benign.problem(n, OUTPUTS)) for n in LENGTHS}
    rounds = [[_at_length(benches[n], slug, n) for n in LENGTHS for slug in _lasting()] for _ in range(2)]
    return [_merged(one, two) for one, two in zip(*rounds, strict=True)]


def _lasting() -> tuple[str, ...]:
    return "closed", "eigh", "expm", *STEPPING, *TOLERANCES


def _at_length(bench: Bench, slug: str, periods: int) -> Run:
    setting = TOLERANCES.get(slug, 0.0)
    if slug in STEPPING:
        setting = periods * EVALUATIONS_A_PERIOD / STEPS[slug].evaluations / OUTPUTS
    return replace(bench.visit(METHODS[slug], setting), setting=float(periods))


def _merged(one: Run, two: Run) -> Run:
    if one.time is None or two.time is None:
        return one
    times = (one.time, two.time)
    return replace(one, time=median(times), time_low=min(times), time_high=max(times), rounds=2)


def digits() -> dict[str, StudyCurves]:
    """Errors of the ways without steps where doubles begin to fail: wide chains, near resonance, long runs.

    The worst over a few neighbours of each place, because at a round number the roundings may happen to cancel.
    """
    near, benign = SYSTEMS["near"], SYSTEMS["benign"]
    return {
        "ratio": _worst(10.0 ** np.arange(0, 17), lambda ratio: _wide(ratio).problem(50, 100)),
        "detuning": _worst(10.0 ** -np.arange(1, 16), lambda d: replace(near, omega=1 + d).problem(50, 100)),
        "periods": _worst(10.0 ** np.arange(0, 13), lambda periods: benign.problem(periods, 100)),
    }


def _wide(ratio: float) -> System:
    chain = TwoMassChain(m1=1.0, m2=1.5, k1=2.0, k2=2.0 * ratio)
    return System(slug="wide", name="", chain=chain, x_0=(1.0, 1.0))


def _worst(places: Array, problem: Callable[[float], Problem]) -> StudyCurves:
    curves: StudyCurves = {"x": places.tolist(), **{slug: [] for slug in WITHOUT}}
    for place in places.tolist():
        asked = [problem(place * neighbour) for neighbour in NEIGHBOURS]
        truths = [reference(each) for each in asked]
        for slug in WITHOUT:
            errors = [_error(slug, each, truth) for each, truth in zip(asked, truths, strict=True)]
            known = [error for error in errors if error is not None]
            curves[slug].append(max(known) if len(known) == len(errors) else None)
    return curves


def _error(slug: str, asked: Problem, truth: Reference) -> float | None:
    """Return the largest error of the motion, or None if the method has no answer."""
    try:
        with np.errstate(all="raise", under="ignore"):
            return float(np.max(truth.errors(METHODS[slug].run(asked, 0, Watch()).x)))
    except (StoppedError, ArithmeticError, ValueError):
        return None


def costs() -> list[dict[str, Any]]:
    """The cost of the 80 digits: milliseconds of the closed form at two times and at a thousand, and of eigh there."""
    rows = []
    for name, slug in (("free", "benign"), ("driven", "near")):
        whole = SYSTEMS[slug].problem()
        few = replace(whole, t=whole.t[:2])
        pairs = [("closed", few), ("closed", whole), ("eigh", whole)]
        times = np.array([[_seconds(method, problem) for method, problem in pairs] for _ in range(200)])
        found = [float(f"{1e3 * value:.4g}") for value in np.median(times, axis=0)]
        rows.append({"motion": name, **dict(zip(("digits", "closed", "eigh"), found, strict=True))})
    return rows


def both_ways() -> list[dict[str, Any]]:
    """Nanoseconds a step on the benign chain: by the right-hand side and as one matrix, in Python and compiled."""
    from tools.bench.compiled import compiler, multiplied

    problem, rows = SYSTEMS["benign"].problem(1, 100), []
    for method in AS_MATRIX:
        given, state = begun(method, problem, 1)
        matrix = tuple(step_matrix(method, problem).ravel().tolist())
        ways: dict[str, Callable[[], Any]] = {}
        for kind, made in (("", interpreted), (", compiled", compiler)):
            advance = advance_of(method, right_hand_side(problem), made)
            ways[f"right-hand side{kind}"] = partial(advance, *given, 0, MANY, *state)
            ways[f"one matrix{kind}"] = partial(made(multiplied), matrix, MANY, *state[:4])
        times = np.array([[_lasts(way) for way in ways.values()] for _ in range(TURNS)])
        found = [float(f"{1e9 * value / MANY:.3g}") for value in np.min(times[1:], axis=0)]  # the first one compiles
        rows.append({"method": method, **dict(zip(ways, found, strict=True))})
    return rows


def _lasts(way: Callable[[], Any]) -> float:
    start = clock()
    way()
    return clock() - start


def _seconds(method: str, problem: Problem) -> float:
    fresh = replace(problem, chain=replace(problem.chain))
    start = clock()
    METHODS[method].run(fresh, 0, Watch())
    return clock() - start
