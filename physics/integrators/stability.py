"""The stability of methods with fixed steps, found by stepping x'' + omega^2 x = 0 in steps of h.

Sources: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed. (1996), IV.3 (stability functions);
E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed. (2006), VI.2 (symplectic maps).
"""

from dataclasses import replace
from functools import cache
from math import ceil, inf, pi

import numpy as np
from numpy.typing import ArrayLike

from physics.coupled import TwoMassChain
from physics.integrators.fixed_steps import STEPPING, advance_of, begun, right_hand_side
from physics.integrators.problem import Problem
from physics.precision.exact import Array

GROWS = 1e-9  # smaller growth per step is rounding error
REACH = 4.0  # h omega at which no explicit method here is stable
ONE = TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=0.0)
PAIR = TwoMassChain(m1=2.0, m2=2.0, k1=0.0, k2=1.0)
"""Two masses on the coupling spring alone: they swing against each other with omega = 1 rad/s."""
COUPLED = TwoMassChain(m1=1.0, m2=2.0, k1=1.0, k2=2.0)


def amplification(method: str, h_omega: ArrayLike, slow: float | None = None) -> Array:
    """Return the growth of a free oscillation in a step: up to 1 is stable, above 1 it explodes.

    It is the spectral radius of one step's matrix in (x, v/omega), and in the acceleration where a method remembers it.

    Parameters
    ----------
    method : str
        A key of STEPPING.
    h_omega : array_like (n,)
        The step times the frequency, in rad.
    slow : float or None
        For two decays instead: the slow rate over the fast one. Then h_omega is the step times the fast rate.

    Returns
    -------
    ndarray (n,)
        The growth.
    """
    z = np.atleast_1d(np.asarray(h_omega, dtype=float))
    growth: Array = np.array([_radius(_of_mass_1(method, h, slow)) for h in z.tolist()])
    return growth


def _of_mass_1(method: str, h: float, slow: float | None) -> Array:
    """The matrix of a step of x'' + x = 0, or with two decays; on the coupling spring where a method solves that."""
    chain, c = (ONE, 0.0) if slow is None else (replace(ONE, k1=slow), 1.0 + slow)
    step = step_matrix(
        method, Problem(chain=chain, x_0=(0.0, 0.0), v_0=(0.0, 0.0), c=c, t=np.array([0.0, h])), _size(method)
    )
    if STEPPING[method].splits:
        step = step_matrix(method, Problem(chain=PAIR, x_0=(0.0, 0.0), v_0=(0.0, 0.0), t=np.array([0.0, h])))
        step = step - np.roll(step, -1, axis=1)  # mass 2 moves against mass 1
    return step[::2, ::2]


def _radius(step: Array) -> float:
    """The spectral radius of a matrix; of (2, 2) without rounding where the eigenvalues are a pair."""
    if len(step) > 2:
        return float(np.max(np.abs(np.linalg.eigvals(step))))
    (p, q), (r, s) = step.tolist()
    half_trace, determinant = (p + s) / 2, p * s - q * r
    discriminant = half_trace**2 - determinant
    return float(abs(half_trace) + np.sqrt(discriminant) if discriminant > 0 else np.sqrt(abs(determinant)))


def step_matrix(method: str, problem: Problem, size: int = 4) -> Array:
    """Return the matrix of one step without a drive.

    Parameters
    ----------
    method : str
        A key of STEPPING.
    problem : Problem
        The chain; its spacing is the step.
    size : {4, 6}
        4 for the state (x1, x2, v1, v2), 6 with the accelerations.

    Returns
    -------
    ndarray (size, size)
        The matrix, in SI units.
    """
    side, columns = right_hand_side(problem), []
    (given, _), advance = begun(method, problem, 1), advance_of(method, side)
    for x1, x2, v1, v2, *a in np.eye(size).tolist():
        start = (x1, x2, v1, v2, *(a or side(given[0], 0.0, x1, x2, v1)))
        columns.append(advance(*given, 0, 1, *start)[:size])
    return np.array(columns).T


def _size(method: str) -> int:
    return 6 if STEPPING[method].memory else 4


@cache
def stability_limit(method: str, slow: float | None = None) -> float:
    """Return the first h omega_+ at which the `method` explodes: 0 if it always does, inf if it never does.

    If `slow` is given (see `amplification`), return the first product of h and the fast rate instead.
    """
    z = np.linspace(0, REACH, 401)[1:]
    unstable = amplification(method, z, slow) > 1 + GROWS
    if not unstable.any():
        return inf
    first = int(np.argmax(unstable))
    if not first:
        return 0.0
    below, above = float(z[first - 1]), float(z[first])
    while below < (middle := (below + above) / 2) < above:
        stable = amplification(method, middle, slow)[0] <= 1 + GROWS
        below, above = (middle, above) if stable else (below, middle)
    return below


def stable_count(method: str, problem: Problem) -> int:
    """Return how many steps per output the `method` needs for the `problem`, with a hundredth to spare.

    It is 1 where every number of steps or none is stable.
    """
    slow, fast = problem.rates
    limit = stability_limit(method, slow / fast if problem.c else None)
    return max(1, ceil(1.01 * problem.spacing * fast / limit)) if limit else 1


def stable_steps(method: str, chain: TwoMassChain) -> float:
    """Return how many steps in a slow period the `method` needs to be stable on the `chain`.

    They grow like sqrt(k2/k1) where the method has a limit.
    """
    slow, fast = chain.modes().omega
    return float(2 * pi * (fast / slow) / stability_limit(method))


def decay_factor(method: str, z: float) -> float:
    """Return R(-z), the share of v that a step of the `method` with h = z leaves of v' = -v.

    Where a method remembers accelerations it is a spectral radius. As z grows a method that is stable at every step
    leaves at most 1, one that is L-stable nothing.
    """
    chain = replace(ONE, k1=0.0)
    step = step_matrix(
        method, Problem(chain=chain, x_0=(0.0, 0.0), v_0=(0.0, 0.0), c=1.0, t=np.array([0.0, z])), _size(method)
    )
    decay = step[2::2, 2::2]
    return _radius(decay) if len(decay) > 1 else float(decay[0, 0])


def form_change(method: str, h_omega: float) -> float:
    """Return by how much a step of the `method` with h omega_+ = h_omega changes areas: 0 for a symplectic method.

    It is the largest entry of S^T J S - J, with J of the momenta m v and the displacements, on a chain with both
    springs.
    """
    h = h_omega / COUPLED.modes().omega[1]
    S = step_matrix(method, Problem(chain=COUPLED, x_0=(0.0, 0.0), v_0=(0.0, 0.0), t=np.array([0.0, h])))
    mass, none = np.diag([COUPLED.m1, COUPLED.m2]), np.zeros((2, 2))
    J = np.block([[none, mass], [-mass, none]])
    return float(np.max(np.abs(S.T @ J @ S - J)))
