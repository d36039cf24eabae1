"""Compiled integrators of `make bench` give the same numbers as those in Python."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np
import pytest

from physics.integrators.accuracy import SYSTEMS
from physics.integrators.fixed_steps import STEPPING
from physics.integrators.problem import Problem, Watch
from physics.integrators.solvers import METHODS
from tools.bench.compiled import compiled_linear, run_compiled, run_modes, run_slides

pytestmark = pytest.mark.slow  # compilation
DRIVEN = replace(SYSTEMS["near"].problem(), x_0=(1.0, -0.5), v_0=(0.2, 0.3))
RUBBED = SYSTEMS["dashpot"].problem()


@pytest.mark.parametrize(
    ("method", "problem"),
    [*((slug, DRIVEN) for slug in STEPPING), *((slug, RUBBED) for slug in ("rk4", "newmark", "radau5", "alpha"))],
    ids=lambda value: value if isinstance(value, str) else "rubbed" if value.c else "driven",
)
def test_both_kinds_give_the_same_numbers(method: str, problem: Problem) -> None:
    short = replace(problem, t=(1e-5 if problem.c else 1.0) * problem.t[:40])
    for steps in (1, 7):
        python, compiled = Watch(), Watch()
        one, other = METHODS[method].run(short, steps, python), run_compiled(method, short, steps, compiled)
        np.testing.assert_allclose(other.x, one.x, rtol=0, atol=1e-13 * np.max(np.abs(one.x)))
        np.testing.assert_allclose(other.v, one.v, rtol=0, atol=1e-13 * np.max(np.abs(one.v)))
        assert (python.steps, python.evaluations) == (compiled.steps, compiled.evaluations)


@pytest.mark.parametrize("slug", ["benign", "wide", "dashpot", "near"])
def test_formulas_and_solvers_give_the_same_motion(slug: str) -> None:
    problem = SYSTEMS[slug].problem(2, 40)
    compiled = {"slides": run_slides} | ({} if problem.c else {"eigh": run_modes})
    for method, run in compiled.items():
        one, other = METHODS[method].run(problem, 0, Watch()), run(problem, 0, Watch())
        np.testing.assert_allclose(other.x, one.x, rtol=0, atol=1e-9 * np.max(np.abs(one.x)))
        np.testing.assert_allclose(other.v, one.v, rtol=0, atol=1e-9 * np.max(np.abs(one.v)))
    for method in ("rk45", "lsoda", "fortran") if slug in ("benign", "near") else ():
        one, watch = METHODS[method].run(problem, 1e-6, Watch()), Watch()
        other = partial(METHODS[method].run, linear=compiled_linear)(problem, 1e-6, watch)
        assert watch.evaluations > 100
        np.testing.assert_allclose(other.x, one.x, rtol=0, atol=1e-4)
