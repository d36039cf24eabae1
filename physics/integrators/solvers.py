"""Every way the project knows to compute the motion of the driven chain, behind one face.

    METHODS[slug].run(problem, setting, watch) -> Trajectory

- no steps: this project's closed form; the slides' formulas in plain float64; modes by the
  dense eigensolver scipy.linalg.eigh, with the response to the drive in a form that stays regular at resonance,
  and in the usual one that does not;
- exact steps: the matrix exponential from one output time to the next;
- fixed steps: physics.integrators.fixed_steps, the setting is the number of steps from one output time to the next;
- chosen steps: SciPy's solvers, the setting is rtol. In solve_ivp all but LSODA are Python; VODE and the second
  DOP853 are compiled and call Python for the right-hand side alone.

A method that cannot go on raises StoppedError with the reason.
"""

import warnings
from bisect import bisect_right
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from math import inf, sin
from types import MappingProxyType
from typing import Any, Literal

import numpy as np

from physics.integrators.fixed_steps import STEPPING, run_fixed
from physics.integrators.formulas import (
    closed_form,
    dense_eigh,
    matrices,
    matrix_exponential,
    naive_eigh,
    slide_formulas,
)
from physics.integrators.implicit_steps import RHO
from physics.integrators.problem import (
    Problem,
    Runner,
    StepTooSmallError,
    StoppedError,
    Trajectory,
    Watch,
    trajectory,
)
from physics.precision.exact import Array

Family = Literal["closed", "exact", "fixed", "adaptive"]

IN_PYTHON = ("rk23", "rk45", "dop853", "radau", "bdf")
"""Solvers that choose their steps and are Python themselves: at best their right-hand side is compiled."""
TOLERANCES = tuple(float(f"1e-{n}") for n in range(2, 14))
FINEST = 2.0**40
"""Largest number of steps per output."""
ATOL = 1e-3
"""The absolute tolerance over the relative one, in units of what is to be expected."""
STRETCH = 500
"""Steps of a compiled solver between two checks of the time limit."""
MUSED, BDF = 18, 2
"""Location of the formulas of LSODA's last step, and the number of the stiff ones."""


@dataclass(frozen=True)
class Method:
    """One method.

    Attributes
    ----------
    slug, name : str
        Its name in addresses, and for readers.
    family : {"closed", "exact", "fixed", "adaptive"}
        The kind of its steps.
    run : Runner
        The function that computes a motion. Its setting is rtol, or steps per output for fixed steps, or 0.
    order : int
        The order of fixed steps.
    friction : bool
        False if it is for chains without a dashpot.
    solved : bool
        True if its linear equations are solved in advance.
    compiled : bool
        True if its stepping function is compiled, as in the benchmark.
    tolerances : tuple of float
        The settings of an adaptive method.
    """

    slug: str
    name: str
    family: Family
    run: Runner
    order: int = 0
    friction: bool = True
    solved: bool = False
    compiled: bool = False
    tolerances: tuple[float, ...] = TOLERANCES

    @cached_property
    def mark(self) -> str:
        """The name without what explains it."""
        return self.name.partition(" (")[0]

    def settings(self) -> tuple[float, ...]:
        """Return the settings, coarse to fine: tolerances, or as many steps as shrink the error by 10 each time."""
        if self.family == "adaptive":
            return self.tolerances
        if self.family != "fixed":
            return (0,)
        ratio, steps, n = 10 ** (1 / self.order), [1.0], 0
        while steps[-1] < FINEST:
            n += 1
            if round(ratio**n) > steps[-1]:
                steps.append(float(round(ratio**n)))
        return tuple(steps)


RightHandSide = Callable[[float, Array], Array]
"""A right-hand side y' of t and y = (x1, x2, v1, v2)."""
Linear = Callable[[Problem], tuple[Array, RightHandSide]]
"""A maker of the matrix of y' = A y + b sin(omega t), and of its right-hand side."""


def solve_ivp(method: str, problem: Problem, rtol: float, watch: Watch, linear: Linear | None = None) -> Trajectory:
    """Compute the motion with a solver of scipy.integrate.solve_ivp, by the name of its class.

    Its steps are not kept: each is interpolated at the output times that it passes, and forgotten. atol is ATOL rtol
    of the displacements and velocities to be expected. `linear` gives another right-hand side than the one in Python.

    Parameters and result as in `Runner`, whose setting is rtol. StepTooSmallError or StoppedError if the solver gives
    up.
    """
    from scipy import integrate

    A, rates = (linear or _linear)(problem)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        solver = getattr(integrate, method)(
            rates, 0.0, np.array(problem.start), problem.t[-1],
            rtol=rtol, atol=_tolerances(problem, rtol), **_jacobian_option(method, A),
        )  # fmt: skip
        states, message = _stepped(solver, problem, watch)
    if solver.status == "failed":
        words = " ".join([message or "", *(str(warning.message) for warning in told)])
        if "spacing" in words:
            raise StepTooSmallError("step below spacing", float(solver.t))
        raise StoppedError(words, float(solver.t))
    return trajectory(states)


def _stepped(solver: Any, problem: Problem, watch: Watch) -> tuple[Array, str | None]:
    """The states (n, 4) at the output times, and what the solver says where it gives up."""
    states, message = np.empty((problem.t.size, 4)), None
    states[0] = problem.start
    times, n = [*problem.t.tolist(), inf], 1
    inner = getattr(solver, "_lsoda_solver", None)
    if solve := getattr(solver, "solve_lu", None):

        def counted(*given: Any) -> Any:
            watch.solves += 1
            return solve(*given)

        solver.solve_lu = counted
    try:
        while solver.status == "running":
            message = solver.step()
            watch.steps += 1
            if inner and inner._integrator.iwork[MUSED] == BDF:
                watch.stiff_steps += 1
            watch.check(solver.t)
            if times[n] <= solver.t:
                first, n = n, bisect_right(times, solver.t)
                states[first:n] = solver.dense_output()(problem.t[first:n]).T
    finally:
        watch.evaluations, watch.jacobians, watch.factorisations = solver.nfev, int(solver.njev), int(solver.nlu)
    return states, message


def ode(
    name: str, problem: Problem, rtol: float, watch: Watch, linear: Linear | None = None, **options: Any
) -> Trajectory:
    """Compute the motion with a solver of scipy.integrate.ode, by its name, for one output time after the other.

    Tolerances and `linear` are those of `solve_ivp`; DOP853 takes a single atol, the least of them. The options are the
    solver's own.

    Parameters and result as in `Runner`, whose setting is rtol. StepTooSmallError if the solver gets no further.
    """
    from scipy import integrate

    _, rates = (linear or _linear)(problem)
    atol = _tolerances(problem, rtol)

    def counted(t: float, y: Array) -> Array:
        watch.evaluations += 1  # the counter of DOP853 leaves some out, which ones depends on the machine
        return rates(t, y)

    tolerances = {"rtol": rtol, "atol": atol if name == "vode" else float(np.min(atol)), "nsteps": STRETCH}
    solver = integrate.ode(rates if name == "vode" else counted).set_integrator(name, **tolerances, **options)
    solver.set_initial_value(np.array(problem.start), 0.0)
    inner, states = solver._integrator, np.empty((problem.t.size, 4))
    states[0] = problem.start
    for n, t in enumerate(problem.t[1:].tolist(), 1):
        while solver.t < t:
            before = solver.t
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # it has not got there within STRETCH steps
                states[n] = solver.integrate(t)
            _count(name, inner.iwork, watch)
            watch.check(solver.t)
            if solver.t == before:
                raise StepTooSmallError("step below spacing", before)
    return trajectory(states)


def _count(name: str, told: Array, watch: Watch) -> None:
    """Count what VODE did so far, and the steps of DOP853 to this output, at the places that their sources name."""
    if name == "vode":
        watch.evaluations, watch.steps = int(told[11]), int(told[10])
    else:
        watch.steps += int(told[17])


def _tolerances(problem: Problem, rtol: float) -> Array:
    """The absolute ones: ATOL rtol of the displacements and velocities to be expected."""
    slow, fast = problem.rates
    tolerances: Array = ATOL * rtol * problem.size * np.array([1.0, 1.0, slow or fast, slow or fast])
    return tolerances


def jacobian(problem: Problem) -> Array:
    """Return the matrix A (4, 4) of y' = A y of a `problem`, with y = (x1, x2, v1, v2)."""
    stiffness, mass = matrices(problem)
    A = np.zeros((4, 4))
    A[:2, 2:] = np.eye(2)
    A[2:, :2] = -stiffness / mass[:, None]
    A[2, 2] = -problem.c / mass[0]
    return A


def _linear(problem: Problem) -> tuple[Array, RightHandSide]:
    """The matrix, and the right-hand side as Python runs it."""
    A = jacobian(problem)
    push, omega, multiply = problem.F_0 / problem.chain.m1, problem.omega, A.dot

    def free(_: float, y: Array) -> Array:
        rates: Array = multiply(y)
        return rates

    def driven(t: float, y: Array) -> Array:
        rates: Array = multiply(y)
        rates[2] += push * sin(omega * t)
        return rates

    return A, driven if problem.F_0 else free


def _jacobian_option(method: str, A: Array) -> dict[str, Any]:
    """The constant Jacobian, for a method that takes one."""
    if method in ("Radau", "BDF"):
        return {"jac": A}
    return {"jac": lambda t, y: A} if method == "LSODA" else {}


NAMES = {
    "euler": "Explicit Euler",
    "semi": "Semi-implicit Euler",
    "verlet": "Verlet (central difference)",
    "midpoint": "Implicit midpoint",
    "newmark": "Newmark (average acceleration)",
    "rk4": "RK4",
    "nystrom4": "Nyström 4",
    "nystrom6": "Nyström 6",
    "gauss4": "Gauss 4",
    "ieuler": "Implicit Euler",
    "sdirk2": "SDIRK 2",
    "radau5": "Radau IIA 5",
    "alpha": f"Generalized-α (ρ∞ = {RHO:g})",
    "gautschi": "Gautschi",
    "mollified": "Mollified impulse",
    "yoshida4": "Yoshida 4",
    "yoshida6": "Yoshida 6",
}


def _methods() -> dict[str, Method]:
    without = (
        Method("closed", "Closed form", "closed", closed_form),
        Method("slides", "Slide formulas", "closed", slide_formulas),
        Method("eigh", "Modes by eigh", "closed", dense_eigh, friction=False),
        Method("naive", "Modes by eigh, naive", "closed", naive_eigh, friction=False),
        Method("expm", "expm", "exact", matrix_exponential),
    )
    fixed = (
        Method(slug, name, "fixed", partial(run_fixed, slug), step.order, step.friction, step.solved)
        for slug, name in NAMES.items()
        for step in [STEPPING[slug]]
    )
    chosen = (
        Method(name.lower(), name, "adaptive", partial(solve_ivp, name))
        for name in ("RK23", "RK45", "DOP853", "Radau", "BDF", "LSODA")
    )
    compiled = (
        Method("fortran", "DOP853 C (compiled, restarted at each output)", "adaptive", partial(ode, "dop853")),
        Method("adams", "VODE-Adams", "adaptive", partial(ode, "vode", method="adams")),
    )
    return {method.slug: method for method in (*without, *fixed, *chosen, *compiled)}


METHODS: Mapping[str, Method] = MappingProxyType(_methods())
