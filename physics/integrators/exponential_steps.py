"""Exponential (trigonometric) integrators: the coupling spring is solved exactly, the other forces act as kicks.

    half a kick, the exact motion of both masses on the spring k2 alone, half a kick

Two filters, functions of h omega with the angular frequency omega of that spring, act on the stretch alone: `psi` on a
kick, `phi` on the stretch at which the other forces are evaluated (Hairer, Lubich, Wanner, Geometric Numerical
Integration, XIII.2; there psi_1 and phi). Both methods are of order 2 and symmetric; the error of a slow part does not
depend on omega, so a step may be far longer than a fast swing.

- Gautschi (W. Gautschi, Numer. Math. 3 (1961) 381): psi = tan(h omega/2)/(h omega/2), phi = 1. Steps in resonance with
  the spring fail: near whole swings they meet it at the same phase each time, near odd halves kicks have no bound.
- mollified impulse (B. Garcia-Archilla, J. M. Sanz-Serna, R. D. Skeel, SIAM J. Sci. Comput. 20 (1999) 930):
  psi = phi = sin(h omega)/(h omega). It is symplectic, and no step is in resonance.
"""

from collections.abc import Callable
from functools import partial
from math import sin, sqrt
from typing import Any

from physics.integrators.problem import Problem
from physics.integrators.stepping import Acceleration, Advance, Constants, Stepping, StepState

Filter = Callable[[float], float]


def _kicked(accelerate: Acceleration) -> Advance:
    """The accelerations are those of the last kick; accelerate() knows nothing of the coupling spring."""

    def kicked(
        p: Constants, numbers: Any, h: float, n: int, count: int,
        x1: float, x2: float, v1: float, v2: float, a1: float, a2: float,
    ) -> StepState:  # fmt: skip
        share1, share2, kick1, kick2, cosine, sine, rise, shift = numbers
        if n == 0:
            a1, a2 = accelerate(p, 0.0, x1 + shift * (x2 - x1), x2, v1)
        for i in range(n, n + count):
            v1 += kick1 * a1
            v2 += kick2 * a1
            stretch, rate, drift = x2 - x1, v2 - v1, h * (share1 * v1 + share2 * v2)
            gain, turn = cosine * stretch + sine * rate, cosine * rate - rise * stretch
            x1 += drift - share2 * gain
            x2 += drift + share1 * gain
            v1 -= share2 * turn
            v2 += share1 * turn
            a1, a2 = accelerate(p, (i + 1) * h, x1 + shift * (x2 - x1), x2, v1)
            v1 += kick1 * a1
            v2 += kick2 * a1
        return x1, x2, v1, v2, a1, a2

    return kicked


def _numbers(psi: Filter, phi: Filter, problem: Problem, h: float) -> Constants:
    """Shares of the masses, half a kick on each mass, the exact motion of the stretch, and the shift of phi."""
    chain = problem.chain
    share1, share2 = (mass / (chain.m1 + chain.m2) for mass in (chain.m1, chain.m2))
    omega = sqrt(chain.k2 / chain.m1 + chain.k2 / chain.m2)
    z = h * omega
    kick1, kick2 = h / 2 * (share1 + share2 * psi(z)), h / 2 * share1 * (1 - psi(z))
    cosine = -2 * sin(z / 2) ** 2  # less 1, without cancellation
    return share1, share2, kick1, kick2, cosine, h * _sinc(z), omega * sin(z), share2 * (1 - phi(z))


def _sinc(z: float) -> float:
    return sin(z) / z if z else 1.0


def _tangent(z: float) -> float:
    """tan(z/2)/(z/2)."""
    return _sinc(z / 2) ** 2 / _sinc(z)


def _one(z: float) -> float:
    return 1.0


EXPONENTIAL = {
    slug: Stepping(2, 1, _kicked, partial(_numbers, psi, phi), friction=False, splits=True)
    for slug, psi, phi in (("gautschi", _tangent, _one), ("mollified", _sinc, _sinc))
}
"""The methods of this module, and their stepping functions."""
