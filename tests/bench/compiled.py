"""Methods with fixed steps, compiled: the stepping functions of physics.integrators.fixed_steps as numba makes them of
Python.

A run is one loop over the outputs, compiled too; between blocks of it the clock is looked at. What numba takes to
compile is no part of a run: `compiled_methods` has all of it done.
"""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cache, partial
from typing import Any

import numba
import numpy as np

from physics.integrators.accuracy import System, entered
from physics.integrators.fixed_steps import (
    FIXED_STEP,
    STEPPING,
    StepState,
    advance_of,
    begun,
    constants,
    exploded,
    right_hand_side,
)
from physics.integrators.problem import Problem, StoppedError, Trajectory, Watch, trajectory
from physics.integrators.solvers import METHODS, Method
from physics.precision.exact import Array

BLOCK = 2**14
"""Steps, at least, between two looks at the clock."""
compiler = cache(numba.njit(error_model="numpy"))
"""One compiled function of each, so that all methods share their right-hand sides."""


@numba.njit
def through(
    advance: Any, given: Any, steps: int, first: int, last: int, bound: float, state: StepState, states: Array
) -> tuple[int, StepState]:
    """States from the output after `first` to `last`, or to the first whose displacements are out of bounds."""
    p, numbers, h = given
    for n in range(first + 1, last + 1):
        state = advance(p, numbers, h, (n - 1) * steps, steps, *state)
        x1, x2, v1, v2, _, _ = state
        states[n, 0], states[n, 1], states[n, 2], states[n, 3] = x1, x2, v1, v2
        if not (abs(x1) <= bound and abs(x2) <= bound):
            return n, state
    return last, state


def run_compiled(method: str, problem: Problem, steps: float, watch: Watch) -> Trajectory:
    """A run of physics.integrators.fixed_steps.run_fixed, compiled."""
    h, state = begun(problem, steps)
    advance = advance_of(method, right_hand_side(problem), compiler)
    given = (constants(problem), STEPPING[method].numbers(problem, h), h)
    states, n, end = np.empty((problem.t.size, 4)), 0, problem.t.size - 1
    states[0] = state[:4]
    block = max(1, BLOCK // int(steps))
    while n < end:
        n, state = through(advance, given, int(steps), n, min(n + block, end), watch.bound, state, states)
        watch.steps = n * int(steps)
        watch.evaluations = watch.steps * STEPPING[method].evaluations
        if not (abs(state[0]) <= watch.bound and abs(state[1]) <= watch.bound):
            raise exploded(problem, h, n)
        watch.check(float(problem.t[n]))
    return trajectory(states)


def compiled_methods(systems: Sequence[System]) -> list[Method]:
    """The compiled methods, with their code made for what drives and damps these systems."""
    methods = [replace(METHODS[slug], run=partial(run_compiled, slug), compiled=True) for slug in FIXED_STEP]
    asked = {right_hand_side(system.problem()): system for system in systems}
    for method in methods:
        for system in asked.values():
            if entered(system, [method.slug]):
                _make(method, system)
    return methods


def _make(method: Method, system: System) -> None:
    """A run of two outputs, be it unstable."""
    with suppress(StoppedError):
        method.run(system.problem(0.1, 2), 1, Watch())
