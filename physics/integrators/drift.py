"""Drift: a motion in steps next to the exact one, over the first few periods.

The steps are taken by physics.integrators.fixed_steps; the module follows each of them, not only the state at output
times.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import copysign, inf

import numpy as np

from physics.integrators.accuracy import System, entered
from physics.integrators.fixed_steps import advance_of, begun, right_hand_side
from physics.integrators.formulas import closed_form
from physics.integrators.problem import Problem, Watch
from physics.precision.exact import Array

PERIODS = 4
SMOOTH = 100
"""Points of the exact curve in a period."""
EXPLODED = 100.0
"""A displacement so many times the largest exact one ends a motion: the method is unstable."""


@dataclass(frozen=True)
class Drift:
    """The displacement of mass 1 after each step.

    Attributes
    ----------
    t : ndarray (n,)
        Times in s.
    x : ndarray (n,)
        Displacements in m.
    error : float
        The largest distance from the exact motion over the largest exact displacement; inf if the motion explodes.
    """

    t: Array
    x: Array
    error: float = 0.0


@lru_cache(maxsize=64)
def exact(system: System) -> Drift:
    """Return the exact motion of a `system`, by the closed form."""
    problem = system.problem(PERIODS, PERIODS * SMOOTH)
    return Drift(problem.t, _exact(problem))


@lru_cache(maxsize=256)
def drifts(system: System, steps: int, methods: Sequence[str]) -> dict[str, Drift]:
    """Return the motion of each method that can compute a system.

    Parameters
    ----------
    system : System
        The motion.
    steps : int
        The number of steps in a period.
    methods : sequence of str
        The slugs of the methods.

    Returns
    -------
    dict of Drift
        The motions by slug.
    """
    problem, size = system.problem(PERIODS, PERIODS * steps), float(np.max(np.abs(exact(system).x)))
    true, found = _exact(problem), {}
    for method in entered(system, methods):
        x = _stepped(method, problem, EXPLODED * size)
        exploded = bool(abs(x[-1]) == EXPLODED * size)
        error = inf if exploded or not size else float(np.max(np.abs(x - true))) / size
        found[method] = Drift(problem.t[: x.size], x, error)
    return found


def _exact(problem: Problem) -> Array:
    x: Array = closed_form(problem, 0, Watch()).x[0]
    return x


def _stepped(method: str, problem: Problem, bound: float) -> Array:
    """The displacement after each step, the spacing of the problem, up to the first that reaches the bound."""
    given, state = begun(method, problem, 1)
    advance, x = advance_of(method, right_hand_side(problem)), [state[0]]
    for n in range(problem.t.size - 1):
        state = advance(*given, n, 1, *state)
        if not abs(state[0]) < bound:
            return np.array([*x, copysign(bound, state[0])])
        x.append(state[0])
    return np.array(x)
