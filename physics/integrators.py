"""Methods that step through the motion of the driven chain, for comparison with the closed form.

    m1 x1'' = -k1 x1 - k2 (x1 - x2) + F_0 sin(omega t),   m2 x2'' = k2 (x1 - x2)

- velocity Verlet (order 2), half a kick, a drift, half a kick: stable for h omega_+ < 2; - Yoshida 4 and 6,
Verlet steps of chosen lengths, some backwards (H. Yoshida, Phys. Lett. A 150 (1990) 262; the
  weights of order 6 are his solution A, to 20 digits as in Hairer, Lubich, Wanner, Geometric Numerical
  Integration, V.3.2);
- implicit midpoint (order 2): stable at every step, its phase is not.

The drive's clock moves with the drift, so that the order holds for a driven chain too. Loops run over plain
floats: for two masses NumPy's cost of a call would be most of the time.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from math import inf, pi, sin, ulp
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from physics.coupled import TwoMassChain
from physics.exact import Array

CUBE_ROOT_2 = 2 ** (1 / 3)
YOSHIDA_4 = (1 / (2 - CUBE_ROOT_2), -CUBE_ROOT_2 / (2 - CUBE_ROOT_2), 1 / (2 - CUBE_ROOT_2))
YOSHIDA_6 = (
    0.78451361047755726382,
    0.23557321335935813368,
    -1.17767998417887100695,
    1.31518632068391121888,
    -1.17767998417887100695,
    0.23557321335935813368,
    0.78451361047755726382,
)
WEIGHTS = {"verlet": (1.0,), "yoshida4": YOSHIDA_4, "yoshida6": YOSHIDA_6}
FIXED_STEP = ("verlet", "yoshida4", "yoshida6", "midpoint")

State = tuple[float, float, float, float]  # x1, x2, v1, v2


@dataclass(frozen=True, kw_only=True)
class Problem:
    """A chain, its drive, its start, and the times t (n,) it is asked for: equally spaced, from 0 on."""

    chain: TwoMassChain
    x_0: tuple[float, float]
    v_0: tuple[float, float]
    t: Array
    F_0: float = 0.0
    omega: float = 0.0
    size: float = 1.0  # the largest displacement to be expected, in m

    @property
    def start(self) -> State:
        return *self.x_0, *self.v_0

    @property
    def spacing(self) -> float:
        return float(self.t[1] - self.t[0])


class StoppedError(Exception):
    """A run that was given up; the message is the reason, reached the time it got to in s."""

    def __init__(self, reason: str, reached: float) -> None:
        super().__init__(reason)
        self.reached = reached


@dataclass
class Watch:
    """Counts evaluations and steps of one run; check(t), called at every evaluation, may raise StoppedError.

    A fixed step whose displacements pass `bound` (m) is given up as unstable.
    """

    check: Callable[[float], None] = lambda t: None
    bound: float = inf
    evaluations: int = 0
    steps: int = 0


@dataclass(frozen=True)
class Trajectory:
    """x and v, each (2, n), and x2 - x1 (n,), which a method may know better than their difference."""

    x: Array
    v: Array
    stretch: Array


def trajectory(x: Array, v: Array) -> Trajectory:
    """Of a method that knows displacements and velocities only."""
    return Trajectory(x=x, v=v, stretch=x[1] - x[0])


class Acceleration(Protocol):
    """The two accelerations at a time and two displacements."""

    def __call__(self, t: float, x1: float, x2: float) -> tuple[float, float]: ...


def acceleration(problem: Problem, watch: Watch) -> Acceleration:
    """The right-hand side of the problem, watched."""
    chain, omega = problem.chain, problem.omega
    m1, m2, k1, k2, F_0 = chain.m1, chain.m2, chain.k1, chain.k2, problem.F_0
    check = watch.check

    def evaluate(t: float, x1: float, x2: float) -> tuple[float, float]:
        watch.evaluations += 1
        check(t)
        pull = k2 * (x2 - x1)
        return (pull - k1 * x1 + F_0 * sin(omega * t)) / m1, -pull / m2

    return evaluate


def run_fixed(method: str, problem: Problem, steps: float, watch: Watch) -> Trajectory:
    """A whole number of equal steps of a method of FIXED_STEP from one output time to the next."""
    if not (steps >= 1 and steps == int(steps)):
        raise ValueError(f"steps = {steps!r}: a whole number from one output time to the next")
    h, end = problem.spacing / steps, float(problem.t[-1])
    if h < ulp(end):
        raise StoppedError(f"step below spacing: h = {h:.3g} s, doubles at {end:.3g} s lie wider", 0.0)
    stepping = _midpoint if method == "midpoint" else _composition
    states = np.empty((problem.t.size, 4))
    states[0] = problem.start
    for n, state in enumerate(stepping(method, problem, int(steps), watch), start=1):
        if not (abs(state[0]) <= watch.bound and abs(state[1]) <= watch.bound):
            reach = h * problem.chain.modes().omega[1]
            raise StoppedError(f"unstable step: h omega_+ = {reach:.3g}", float(problem.t[n]))
        states[n] = state
    return trajectory(states[:, :2].T, states[:, 2:].T)


def _composition(method: str, problem: Problem, steps: int, watch: Watch) -> Iterator[State]:
    """Verlet steps of the lengths that the method weighs, state by output time."""
    evaluate = acceleration(problem, watch)
    h = problem.spacing / steps
    lengths = [weight * h for weight in WEIGHTS[method]]
    x1, x2, v1, v2 = problem.start
    a1, a2 = evaluate(0.0, x1, x2)
    for n in range((problem.t.size - 1) * steps):
        t = n * h
        for length in lengths:
            half = length / 2
            v1 += half * a1
            v2 += half * a2
            x1 += length * v1
            x2 += length * v2
            t += length
            a1, a2 = evaluate(t, x1, x2)
            v1 += half * a1
            v2 += half * a2
        watch.steps += 1
        if (n + 1) % steps == 0:
            yield x1, x2, v1, v2


def _midpoint(_: str, problem: Problem, steps: int, watch: Watch) -> Iterator[State]:
    """(M + h^2/4 K) x_mid = M (x + h/2 v) + h^2/4 f_mid, solved by Cramer's rule without cancellation."""
    evaluate = acceleration(problem, watch)
    chain = problem.chain
    h = problem.spacing / steps
    s1, s2 = h * h / 4 / chain.m1, h * h / 4 / chain.m2
    a, b, c, d = 1 + s1 * (chain.k1 + chain.k2), s1 * chain.k2, s2 * chain.k2, 1 + s2 * chain.k2
    determinant = 1 + s1 * (chain.k1 + chain.k2) + s2 * chain.k2 + s1 * s2 * chain.k1 * chain.k2
    x1, x2, v1, v2 = problem.start
    for n in range((problem.t.size - 1) * steps):
        middle = (n + 0.5) * h
        r1 = x1 + h / 2 * v1 + s1 * problem.F_0 * sin(problem.omega * middle)
        r2 = x2 + h / 2 * v2
        a1, a2 = evaluate(middle, (d * r1 + b * r2) / determinant, (c * r1 + a * r2) / determinant)
        x1, x2 = x1 + h * (v1 + h / 2 * a1), x2 + h * (v2 + h / 2 * a2)
        v1, v2 = v1 + h * a1, v2 + h * a2
        watch.steps += 1
        if (n + 1) % steps == 0:
            yield x1, x2, v1, v2


def amplification(method: str, h_omega: ArrayLike) -> Array:
    """Growth of a free oscillation a step, against h omega (n,): 1 is stable, above 1 it explodes.

    The spectral radius of the method's 2 x 2 matrix, whose determinant is 1.
    """
    z = np.atleast_1d(np.asarray(h_omega, dtype=float))
    if method == "midpoint":
        return np.ones_like(z)
    half_trace, discriminant = _stability(method, z)
    growth: Array = np.abs(half_trace) + np.sqrt(np.where(discriminant > 0, discriminant, 0.0))
    return np.where(discriminant > 0, growth, 1.0)


@cache
def stability_limit(method: str) -> float:
    """The first h omega_+ at which the method explodes; inf for one that never does."""
    if method == "midpoint":
        return inf
    z = np.linspace(0, 4, 4001)[1:]
    _, discriminant = _stability(method, z)
    above = float(z[np.argmax(discriminant > 0)])
    below = above - 1e-3
    while below < (middle := (below + above) / 2) < above:
        stable = _stability(method, np.array([middle]))[1][0] <= 0
        below, above = (middle, above) if stable else (below, middle)
    return below


def stable_steps(method: str, chain: TwoMassChain) -> float:
    """Steps a slow period that the method needs to be stable; like sqrt(k2/k1) for an explicit one."""
    slow, fast = chain.modes().omega
    return float(2 * pi * (fast / slow) / stability_limit(method))


def _stability(method: str, z: Array) -> tuple[Array, Array]:
    """Half the trace of one step's matrix in (x, v/omega), and its square less the determinant."""
    p, q, r, s = np.ones_like(z), np.zeros_like(z), np.zeros_like(z), np.ones_like(z)
    for weight in WEIGHTS[method]:
        w = weight * z
        r, s = r - w / 2 * p, s - w / 2 * q
        p, q = p + w * r, q + w * s
        r, s = r - w / 2 * p, s - w / 2 * q
    return (p + s) / 2, ((p - s) / 2) ** 2 + q * r
