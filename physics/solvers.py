"""Every way the project knows to compute the motion of the driven chain, behind one face.

    METHODS[slug].run(problem, setting, watch) -> Trajectory

- no steps: this project's closed form; the slides' formulas as they stand, in plain float64; modes by the
  dense eigensolver scipy.linalg.eigh; the matrix exponential from one output time to the next;
- fixed steps: physics.integrators, the setting is the number of steps from one output time to the next;
- chosen steps: scipy.integrate.solve_ivp, the setting is rtol.

A method that cannot go on raises StoppedError with the reason.
"""

import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from math import ceil, log
from types import MappingProxyType
from typing import Literal

import numpy as np

from physics.coupled import free_motion
from physics.exact import Array
from physics.forced import forced_motion
from physics.integrators import (
    Problem,
    StoppedError,
    Trajectory,
    Watch,
    acceleration,
    run_fixed,
    stability_limit,
    trajectory,
)

Family = Literal["closed", "fixed", "adaptive"]
Runner = Callable[[Problem, float, Watch], Trajectory]

TOLERANCES = (1e-3, 1e-6, 1e-9, 1e-12)
STEPS = (1, 4, 16, 64, 256)


@dataclass(frozen=True)
class Method:
    """One method; its setting is rtol, or steps an output for fixed steps, or 0 where there is none."""

    slug: str
    name: str
    family: Family
    run: Runner

    def settings(self, problem: Problem) -> tuple[float, ...]:
        """Coarse to fine; a fixed step that is stable is among them, however short it has to be."""
        if self.family == "adaptive":
            return TOLERANCES
        return _steps(self.slug, problem) if self.family == "fixed" else (0,)


def _steps(method: str, problem: Problem) -> tuple[float, ...]:
    reach = problem.spacing * problem.chain.modes().omega[1] / stability_limit(method)
    stable = 4 ** ceil(log(max(reach, 1.0), 4))
    return STEPS if stable <= STEPS[-1] else (*STEPS, stable)


def closed_form(problem: Problem, _: float, watch: Watch) -> Trajectory:
    """This project's own."""
    watch.evaluations = problem.t.size
    if problem.F_0:
        motion = forced_motion(problem.chain, problem.F_0, problem.omega, problem.t, problem.x_0, problem.v_0)
    else:
        motion = free_motion(problem.chain, problem.x_0, problem.v_0, problem.t)
    return Trajectory(x=motion.x, v=motion.v, stretch=motion.e[1])


def slide_formulas(problem: Problem, _: float, watch: Watch) -> Trajectory:
    """The lecture's formulas (D34, slides 3 to 8) in the order they are printed, in float64."""
    chain = problem.chain
    b = chain.m1 * chain.k2 + chain.m2 * (chain.k1 + chain.k2)
    root = np.sqrt(b * b - 4 * chain.m1 * chain.m2 * chain.k1 * chain.k2)
    squares = np.array([b - root, b + root]) / (2 * chain.m1 * chain.m2)
    ratios = -(chain.m1 * squares - chain.k1 - chain.k2) / chain.k2
    particular = _slide_particular(problem, squares)
    return _superposed(problem, np.sqrt(squares), np.array([[1.0, 1.0], ratios]), particular, watch)


def dense_eigh(problem: Problem, _: float, watch: Watch) -> Trajectory:
    """Frequencies and shapes from scipy.linalg.eigh(K, M), mode by mode under the drive."""
    from scipy.linalg import eigh

    stiffness, mass = _matrices(problem)
    squares, shapes = eigh(stiffness, np.diag(mass))
    particular = shapes @ (shapes[0] * problem.F_0 / (squares - problem.omega**2))
    return _superposed(problem, np.sqrt(squares), shapes, particular, watch)


def exponential(problem: Problem, _: float, watch: Watch) -> Trajectory:
    """exp(A dt) from one output time to the next, the drive carried along as an oscillator of its own."""
    from scipy.linalg import expm

    stiffness, mass = _matrices(problem)
    A = np.zeros((6, 6))
    A[:2, 2:4] = np.eye(2)
    A[2:4, :2] = -stiffness / mass[:, None]
    A[2, 4] = problem.F_0 / mass[0]
    A[4, 5], A[5, 4] = problem.omega, -problem.omega
    step = expm(A * problem.spacing)
    states = np.empty((problem.t.size, 6))
    states[0] = *problem.start, 0.0, 1.0
    for n in range(1, problem.t.size):
        states[n] = step @ states[n - 1]
        watch.check(float(problem.t[n]))
    watch.evaluations = watch.steps = problem.t.size - 1
    return trajectory(states[:, :2].T, states[:, 2:4].T)


def solve_ivp(method: str, problem: Problem, rtol: float, watch: Watch) -> Trajectory:
    """SciPy's solver of that name; atol is 1e-3 rtol of the displacements and velocities to be expected."""
    from scipy import integrate

    evaluate = acceleration(problem, watch)
    slow, fast = problem.chain.modes().omega
    size = np.array([1.0, 1.0, slow or fast, slow or fast]) * problem.size

    def rates(t: float, y: Array) -> tuple[float, float, float, float]:
        x1, x2, v1, v2 = y.tolist()
        return v1, v2, *evaluate(t, x1, x2)

    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        solution = integrate.solve_ivp(
            rates, (0.0, problem.t[-1]), problem.start, t_eval=problem.t,
            method=method, rtol=rtol, atol=1e-3 * rtol * size, dense_output=True,
        )  # fmt: skip
    if solution.status != 0:
        words = " ".join([solution.message, *(str(warning.message) for warning in told)])
        reason = "step below spacing" if "spacing" in words else words
        raise StoppedError(reason, float(solution.t[-1]) if len(solution.t) else 0.0)
    watch.steps = len(solution.sol.ts) - 1
    return trajectory(solution.y[:2], solution.y[2:])


def _matrices(problem: Problem) -> tuple[Array, Array]:
    """K (2, 2) and the diagonal of M."""
    chain = problem.chain
    stiffness = np.array([[chain.k1 + chain.k2, -chain.k2], [-chain.k2, chain.k2]])
    return stiffness, np.array([chain.m1, chain.m2])


def _slide_particular(problem: Problem, squares: Array) -> Array:
    """Xp of slide 8."""
    chain, square = problem.chain, problem.omega**2
    D = chain.m1 * chain.m2 * (square - squares[0]) * (square - squares[1])
    if not D:
        raise StoppedError("D(omega) = 0: no particular solution", 0.0)
    amplitudes: Array = np.array([chain.k2 - chain.m2 * square, chain.k2]) * problem.F_0 / D
    return amplitudes


def _superposed(problem: Problem, omega: Array, shapes: Array, particular: Array, watch: Watch) -> Trajectory:
    """x_c + x_p: the columns of shapes at the frequencies omega, with constants that fit the start."""
    watch.evaluations = problem.t.size
    drive = problem.omega * problem.t
    cosine = np.linalg.solve(shapes, np.array(problem.x_0))
    sine = np.linalg.solve(shapes, np.array(problem.v_0) - problem.omega * particular) / omega
    angle = np.outer(omega, problem.t)
    q = cosine[:, None] * np.cos(angle) + sine[:, None] * np.sin(angle)
    p = omega[:, None] * (sine[:, None] * np.cos(angle) - cosine[:, None] * np.sin(angle))
    return trajectory(
        shapes @ q + np.outer(particular, np.sin(drive)),
        shapes @ p + problem.omega * np.outer(particular, np.cos(drive)),
    )


def _methods() -> dict[str, Method]:
    none = (
        Method("closed", "Closed form", "closed", closed_form),
        Method("slides", "Slide formulas", "closed", slide_formulas),
        Method("eigh", "Modes by eigh", "closed", dense_eigh),
        Method("expm", "expm, step by step", "closed", exponential),
    )
    fixed = {
        "verlet": "Verlet",
        "yoshida4": "Yoshida 4",
        "yoshida6": "Yoshida 6",
        "midpoint": "Implicit midpoint",
    }
    chosen = ("RK45", "DOP853", "Radau", "BDF", "LSODA")
    return {
        method.slug: method
        for method in (
            *none,
            *(Method(slug, name, "fixed", partial(run_fixed, slug)) for slug, name in fixed.items()),
            *(Method(name.lower(), name, "adaptive", partial(solve_ivp, name)) for name in chosen),
        )
    }


METHODS: Mapping[str, Method] = MappingProxyType(_methods())
