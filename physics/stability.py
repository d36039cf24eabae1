"""The stability of methods with fixed steps, found by stepping x'' + omega^2 x = 0 in steps of h."""

from functools import cache
from math import inf, pi

import numpy as np
from numpy.typing import ArrayLike

from physics.coupled import TwoMassChain
from physics.exact import Array
from physics.integrators import STEPPING
from physics.problem import Problem

GROWS = 1e-9  # a growth a step below this is rounding
REACH = 4.0  # no explicit method here is stable at this h omega
ONE = TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=0.0)


def amplification(method: str, h_omega: ArrayLike) -> Array:
    """Growth of a free oscillation a step, against h omega (n,): up to 1 is stable, above 1 it explodes.

    The spectral radius of one step's 2 x 2 matrix in (x, v/omega).
    """
    z = np.atleast_1d(np.asarray(h_omega, dtype=float))
    (p, r), (q, s) = (np.transpose([_stepped(method, h, start) for h in z.tolist()]) for start in ((1, 0), (0, 1)))
    half_trace, determinant = (p + s) / 2, p * s - q * r
    discriminant = half_trace**2 - determinant
    real = np.abs(half_trace) + np.sqrt(np.maximum(discriminant, 0.0))
    growth: Array = np.where(discriminant > 0, real, np.sqrt(np.abs(determinant)))
    return growth


def _stepped(method: str, h: float, start: tuple[float, float]) -> tuple[float, float]:
    x_0, v_0 = start
    problem = Problem(chain=ONE, x_0=(x_0, 0.0), v_0=(v_0, 0.0), t=np.array([0.0, h]))
    run = STEPPING[method].steps(problem, h)
    next(run)
    x, _, v, _ = run.send(1)
    return x, v


@cache
def stability_limit(method: str) -> float:
    """The first h omega_+ at which the method explodes: 0 for one that always does, inf for one that never does."""
    z = np.linspace(0, REACH, 401)[1:]
    unstable = amplification(method, z) > 1 + GROWS
    if not unstable.any():
        return inf
    first = int(np.argmax(unstable))
    if not first:
        return 0.0
    below, above = float(z[first - 1]), float(z[first])
    while below < (middle := (below + above) / 2) < above:
        stable = amplification(method, middle)[0] <= 1 + GROWS
        below, above = (middle, above) if stable else (below, middle)
    return below


def stable_steps(method: str, chain: TwoMassChain) -> float:
    """Steps a slow period that the method needs to be stable; like sqrt(k2/k1) where it has a limit."""
    slow, fast = chain.modes().omega
    return float(2 * pi * (fast / slow) / stability_limit(method))
