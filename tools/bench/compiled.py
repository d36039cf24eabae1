"""Methods compiled by numba, for a fair comparison.

- fixed steps: the stepping functions of physics.integrators.fixed_steps. A run is one loop over the outputs, compiled
  too; between blocks of it the clock is looked at;
- solvers with adaptive steps: their right-hand side, one function for each motion;
- the closed form in doubles: modes by eigh and the slide formulas, from the constants to the last output.

What numba takes to compile is no part of a run: `compiled_methods` has all of it done.
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
    advance_of,
    begun,
    constants,
    exploded,
    right_hand_side,
)
from physics.integrators.formulas import matrices
from physics.integrators.problem import Problem, StoppedError, Trajectory, Watch, trajectory
from physics.integrators.solvers import METHODS, Method, RightHandSide, jacobian
from physics.integrators.stepping import Constants, StepState
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
    given, state = begun(method, problem, steps)
    h, advance = given[2], advance_of(method, right_hand_side(problem), compiler)
    states, n, end = np.empty((problem.t.size, 4)), 0, problem.t.size - 1
    states[0] = state[:4]
    block = max(1, BLOCK // int(steps))
    while n < end:
        n, state = through(advance, given, int(steps), n, min(n + block, end), watch.bound, state, states)
        watch.steps = n * int(steps)
        watch.evaluations = watch.steps * STEPPING[method].evaluations
        if STEPPING[method].solved:
            watch.factorisations, watch.solves = 1, watch.steps
        if not (abs(state[0]) <= watch.bound and abs(state[1]) <= watch.bound):
            raise exploded(problem, h, n)
        watch.check(float(problem.t[n]))
    return trajectory(states)


@cache
def compiled_rates(p: Constants) -> Any:
    """The right-hand side of a motion, its constants frozen."""
    m1, m2, k1, k2, F_0, omega, c = p

    @numba.njit(error_model="numpy")
    def rates(t: float, y: Array) -> Array:
        pull = k2 * (y[1] - y[0])
        push = F_0 * np.sin(omega * t) if F_0 else 0.0
        return np.array([y[2], y[3], (pull - k1 * y[0] - c * y[2] + push) / m1, -pull / m2])

    rates(0.0, np.zeros(4))
    return rates


def compiled_linear(problem: Problem) -> tuple[Array, RightHandSide]:
    """The matrix of a motion, and its right-hand side compiled."""
    rates: RightHandSide = compiled_rates(constants(problem))
    return jacobian(problem), rates


MotionArrays = tuple[Array, Array]
"""Displacements and velocities, each (2, n)."""


@numba.njit
def superposed(
    omega: Array, shapes: Array, particular: Array, drive: float, x_0: Array, v_0: Array, t: Array
) -> MotionArrays:
    """Modes with constants that fit the start, and the particular solution."""
    cosine = np.linalg.solve(shapes, x_0)
    sine = np.linalg.solve(shapes, v_0 - drive * particular) / omega
    x, v = np.empty((2, t.size)), np.empty((2, t.size))
    for n in range(t.size):
        c1, s1, c2, s2 = (
            np.cos(omega[0] * t[n]),
            np.sin(omega[0] * t[n]),
            np.cos(omega[1] * t[n]),
            np.sin(omega[1] * t[n]),
        )
        q1, q2 = cosine[0] * c1 + sine[0] * s1, cosine[1] * c2 + sine[1] * s2
        p1, p2 = omega[0] * (sine[0] * c1 - cosine[0] * s1), omega[1] * (sine[1] * c2 - cosine[1] * s2)
        push, pace = np.sin(drive * t[n]), drive * np.cos(drive * t[n])
        for i in range(2):
            x[i, n] = shapes[i, 0] * q1 + shapes[i, 1] * q2 + particular[i] * push
            v[i, n] = shapes[i, 0] * p1 + shapes[i, 1] * p2 + particular[i] * pace
    return x, v


@numba.njit
def modes(stiffness: Array, mass: Array, F_0: float, drive: float, x_0: Array, v_0: Array, t: Array) -> MotionArrays:
    """physics.integrators.formulas.dense_eigh."""
    root = np.sqrt(mass)
    squares, turned = np.linalg.eigh(stiffness / np.outer(root, root))
    omega, shapes = np.sqrt(squares), turned / root.reshape(2, 1)
    x, v = superposed(omega, shapes, np.zeros(2), drive, x_0, v_0, t)
    if F_0:
        for n in range(t.size):
            for k in range(2):
                s, d = (drive + omega[k]) / 2, (drive - omega[k]) / 2
                slow = t[n] * np.sinc(d * t[n] / np.pi)
                fast, share = np.sin(s * t[n]), shapes[0, k] * F_0
                response = (np.cos(d * t[n]) * fast / s - np.cos(s * t[n]) * slow) / (2 * omega[k])
                rate = drive * fast * slow / (2 * s) if s else 0.0
                for i in range(2):
                    x[i, n] += shapes[i, k] * share * response
                    v[i, n] += shapes[i, k] * share * rate
    return x, v


@numba.njit(error_model="numpy")
def slides(p: Constants, x_0: Array, v_0: Array, t: Array) -> MotionArrays:
    """physics.integrators.formulas.slide_formulas on two masses."""
    m1, m2, k1, k2, F_0, drive, _ = p
    b = m1 * k2 + m2 * (k1 + k2)
    root = np.sqrt(b * b - 4 * m1 * m2 * k1 * k2)
    squares = np.array([b - root, b + root]) / (2 * m1 * m2)
    shapes = np.ones((2, 2))
    shapes[1] = -(m1 * squares - k1 - k2) / k2
    D = m1 * m2 * (drive**2 - squares[0]) * (drive**2 - squares[1])
    if F_0 and D == 0:
        return np.full((2, 1), np.inf), np.full((2, 1), np.inf)
    particular = np.array([k2 - m2 * drive**2, k2]) * F_0 / D if F_0 else np.zeros(2)
    return superposed(np.sqrt(squares), shapes, particular, drive, x_0, v_0, t)


@numba.njit
def exponentials(p: Constants, x_0: float, v_0: float, t: Array) -> MotionArrays:
    """The slide formulas on one mass with its dashpot."""
    m, _, k, _, F_0, drive, c = p
    root = np.sqrt(c * c - 4 * m * k)
    slow, fast = (-c + root) / (2 * m), (-c - root) / (2 * m)
    X = F_0 / complex(k - m * drive**2, c * drive) if F_0 else 0j
    x_0, v_0 = x_0 - X.imag, v_0 - drive * X.real
    A, B = (v_0 - fast * x_0) / (slow - fast), (v_0 - slow * x_0) / (fast - slow)
    x, v = np.zeros((2, t.size)), np.zeros((2, t.size))
    for n in range(t.size):
        first, second = A * np.exp(slow * t[n]), B * np.exp(fast * t[n])
        S, C = np.sin(drive * t[n]), np.cos(drive * t[n])
        x[0, n] = first + second + X.real * S + X.imag * C
        v[0, n] = slow * first + fast * second + drive * (X.real * C - X.imag * S)
    return x, v


def multiplied(
    matrix: tuple[float, ...], count: int, x1: float, x2: float, v1: float, v2: float
) -> tuple[float, float, float, float]:
    """The state after `count` steps, each of them one matrix (4, 4), given row by row."""
    (a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p) = matrix  # noqa: E741
    for _ in range(count):
        x1, x2, v1, v2 = (
            a * x1 + b * x2 + c * v1 + d * v2,
            e * x1 + f * x2 + g * v1 + h * v2,
            i * x1 + j * x2 + k * v1 + l * v2,
            m * x1 + n * x2 + o * v1 + p * v2,
        )
    return x1, x2, v1, v2


def run_modes(problem: Problem, _: float, watch: Watch) -> Trajectory:
    """A run of modes by eigh, compiled."""
    watch.evaluations, (stiffness, mass) = problem.t.size, matrices(problem)
    start = np.array(problem.x_0), np.array(problem.v_0)
    x, v = modes(stiffness, mass, problem.F_0, problem.omega, *start, problem.t)
    return Trajectory(x=x, v=v, stretch=x[1] - x[0])


def run_slides(problem: Problem, _: float, watch: Watch) -> Trajectory:
    """A run of the slide formulas, compiled."""
    watch.evaluations, p = problem.t.size, constants(problem)
    if problem.c:
        x, v = exponentials(p, problem.x_0[0], problem.v_0[0], problem.t)
    else:
        x, v = slides(p, np.array(problem.x_0), np.array(problem.v_0), problem.t)
        if not np.isfinite(x).all():
            raise StoppedError("D(omega) = 0: no particular solution", 0.0)
    return Trajectory(x=x, v=v, stretch=x[1] - x[0])


def compiled_methods(systems: Sequence[System]) -> list[Method]:
    """The compiled methods, with their code made for what drives and damps these systems."""
    runs: dict[str, Any] = {"eigh": run_modes, "slides": run_slides}
    runs |= {slug: partial(run_compiled, slug) for slug in FIXED_STEP}
    runs |= {
        slug: partial(method.run, linear=compiled_linear)
        for slug, method in METHODS.items()
        if method.family == "adaptive"
    }
    methods = [replace(METHODS[slug], run=run, compiled=True) for slug, run in runs.items()]
    for system in systems:
        compiled_rates(constants(system.problem()))
    asked = {right_hand_side(system.problem()): system for system in systems}
    for method in methods:
        for system in asked.values():
            if method.family != "adaptive" and entered(system, [method.slug]):
                _make(method, system)
    return methods


def _make(method: Method, system: System) -> None:
    """A run of two outputs, be it unstable."""
    with suppress(StoppedError):
        method.run(system.problem(0.1, 2), 1, Watch())
