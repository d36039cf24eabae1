"""The stability of methods with fixed steps, found by stepping x'' + omega^2 x = 0 in steps of h."""

from dataclasses import replace
from functools import cache
from math import ceil, inf, pi

import numpy as np
from numpy.typing import ArrayLike

from physics.coupled import TwoMassChain
from physics.integrators.fixed_steps import run_fixed
from physics.integrators.problem import Problem, Watch
from physics.precision.exact import Array

GROWS = 1e-9  # a growth a step below this is rounding
REACH = 4.0  # no explicit method here is stable at this h omega
ONE = TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=0.0)


def amplification(method: str, h_omega: ArrayLike, slow: float | None = None) -> Array:
    """Growth of a free oscillation a step, against h omega (n,): up to 1 is stable, above 1 it explodes.

    The spectral radius of one step's 2 x 2 matrix in (x, v/omega). With `slow` it is for two decays, against h
    times the fast rate, of which the slow one is so large a part.
    """
    z = np.atleast_1d(np.asarray(h_omega, dtype=float))
    starts = ((1.0, 0.0), (0.0, 1.0))
    (p, r), (q, s) = (np.transpose([_stepped(method, h, start, slow) for h in z.tolist()]) for start in starts)
    half_trace, determinant = (p + s) / 2, p * s - q * r
    discriminant = half_trace**2 - determinant
    real = np.abs(half_trace) + np.sqrt(np.maximum(discriminant, 0.0))
    growth: Array = np.where(discriminant > 0, real, np.sqrt(np.abs(determinant)))
    return growth


def _stepped(method: str, h: float, start: tuple[float, float], slow: float | None) -> tuple[float, float]:
    x_0, v_0 = start
    chain, c = (ONE, 0.0) if slow is None else (replace(ONE, k1=slow), 1.0 + slow)
    problem = Problem(chain=chain, x_0=(x_0, 0.0), v_0=(v_0, 0.0), c=c, t=np.array([0.0, h]))
    result = run_fixed(method, problem, 1, Watch())
    return float(result.x[0, 1]), float(result.v[0, 1])


@cache
def stability_limit(method: str, slow: float | None = None) -> float:
    """The first h omega_+ at which the method explodes: 0 for one that always does, inf for one that never does.

    With `slow`, as in `amplification`, the first h times the fast rate.
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
    """Steps an output, a hundredth more than stability asks for; 1 where every number of steps or none is stable."""
    slow, fast = problem.rates
    limit = stability_limit(method, slow / fast if problem.c else None)
    return max(1, ceil(1.01 * problem.spacing * fast / limit)) if limit else 1


def stable_steps(method: str, chain: TwoMassChain) -> float:
    """Steps a slow period that the method needs to be stable; like sqrt(k2/k1) where it has a limit."""
    slow, fast = chain.modes().omega
    return float(2 * pi * (fast / slow) / stability_limit(method))


def decay_factor(method: str, z: float) -> float:
    """R(-z): the share of v that a step of h = z leaves of v' = -v.

    As z grows a method that is stable at every step leaves at most 1, one that is L-stable nothing.
    """
    problem = Problem(
        chain=replace(ONE, k1=0.0), x_0=(0.0, 0.0), v_0=(1.0, 0.0), c=1.0, t=np.array([0.0, z])
    )  # fmt: skip
    return float(run_fixed(method, problem, 1, Watch()).v[0, 1])


def area(method: str, h_omega: float) -> float:
    """The determinant of a step of x'' + omega^2 x = 0 in (x, v/omega): 1 for a symplectic method."""
    (p, r), (q, s) = (_stepped(method, h_omega, start, None) for start in ((1.0, 0.0), (0.0, 1.0)))
    return p * s - q * r
