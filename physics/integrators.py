"""Methods with fixed steps, for comparison with the closed form. The equations are those of physics.problem.

- explicit Euler (order 1): grows at every step; semi-implicit Euler (order 1): stable for h omega_+ < 2;
- Verlet, the central difference (order 2): half a kick, a drift, half a kick; stable for h omega_+ < 2;
- Yoshida 4 and 6: Verlet steps of chosen lengths, some backwards (H. Yoshida, Phys. Lett. A 150 (1990) 262; the
  weights of order 6 are his solution A, to 20 digits as in Hairer, Lubich, Wanner, Geometric Numerical
  Integration, V.3.2);
- RK4, the classical Runge-Kutta method (order 4): stable for h omega_+ < 2.83, where it damps;
- implicit midpoint and Newmark with the average acceleration (order 2): stable at every step, their phase is not.
  They take the drive in the middle of the step or at both ends; without one they are the same method;
- Gauss 4, two stages at the nodes of Gauss (order 4): stable at every step.

Implicit methods solve their linear equations once, as constant matrices allow. Loops run over plain floats: for two
masses NumPy's cost of a call would be most of the time.
"""

from collections.abc import Callable, Generator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from math import sin, sqrt, ulp
from types import MappingProxyType
from typing import Protocol

import numpy as np

from physics.exact import Array
from physics.problem import MotionState, Problem, StepTooSmallError, StoppedError, Trajectory, Watch, trajectory

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
CHUNK = 1024  # steps between two looks at the clock

States = Generator[MotionState, int, None]
"""Yields the start; sent a number of steps, it takes them and yields where they lead."""


class Acceleration(Protocol):
    """The two accelerations at a time, two displacements and the velocity of mass 1."""

    def __call__(self, t: float, x1: float, x2: float, v1: float) -> tuple[float, float]: ...


@dataclass(frozen=True)
class Stepping:
    """A method: its order, how often it evaluates the right-hand side in a step, and its steps of length h.

    Without `friction` it is for forces that depend on the position alone.
    """

    order: int
    evaluations: int
    steps: Callable[[Problem, float], States]
    friction: bool = True


def run_fixed(method: str, problem: Problem, steps: float, watch: Watch) -> Trajectory:
    """A whole number of equal steps of a method of STEPPING from one output time to the next."""
    if not (steps >= 1 and steps == int(steps)):
        raise ValueError(
            f"{steps!r} steps from one output time to the next are not possible: a whole number from 1 on is needed"
        )
    h, end = problem.spacing / steps, float(problem.t[-1])
    if h < ulp(end):
        raise StepTooSmallError(f"step below spacing: h = {h:.3g} s, doubles at {end:.3g} s lie wider", 0.0)
    stepping = STEPPING[method]
    run, states = stepping.steps(problem, h), np.empty((problem.t.size, 4))
    states[0] = next(run)
    for n in range(1, problem.t.size):
        x1, x2, *_ = states[n] = _advanced(run, int(steps), h, watch)
        watch.evaluations = watch.steps * stepping.evaluations
        if not (abs(x1) <= watch.bound and abs(x2) <= watch.bound):
            fastest = "f" if problem.c else "omega_+"
            raise StoppedError(f"unstable step: h {fastest} = {h * problem.rates[1]:.3g}", float(problem.t[n]))
    return trajectory(states)


def _advanced(run: States, left: int, h: float, watch: Watch) -> MotionState:
    """The state so many steps later."""
    while True:
        count = min(left, CHUNK)
        state = run.send(count)
        left -= count
        watch.steps += count
        watch.check(watch.steps * h)
        if not left:
            return state


def acceleration(problem: Problem) -> Acceleration:
    """The right-hand side of the problem, with no more in it than the problem has."""
    chain, omega, F_0, c = problem.chain, problem.omega, problem.F_0, problem.c
    m1, m2, k1, k2 = chain.m1, chain.m2, chain.k1, chain.k2

    def free(t: float, x1: float, x2: float, v1: float) -> tuple[float, float]:
        pull = k2 * (x2 - x1)
        return (pull - k1 * x1) / m1, -pull / m2

    def driven(t: float, x1: float, x2: float, v1: float) -> tuple[float, float]:
        pull = k2 * (x2 - x1)
        return (pull - k1 * x1 + F_0 * sin(omega * t)) / m1, -pull / m2

    def damped(t: float, x1: float, x2: float, v1: float) -> tuple[float, float]:
        pull = k2 * (x2 - x1)
        return (pull - k1 * x1 - c * v1 + F_0 * sin(omega * t)) / m1, -pull / m2

    return damped if c else driven if F_0 else free


def _euler(semi_implicit: bool, problem: Problem, h: float) -> States:
    """The explicit method moves x by the velocities before a step, the semi-implicit one by those after it."""
    accelerate = acceleration(problem)
    x1, x2, v1, v2 = problem.start
    n, count = 0, (yield problem.start)
    while True:
        for i in range(n, n + count):
            a1, a2 = accelerate(i * h, x1, x2, v1)
            u1, u2 = v1 + h * a1, v2 + h * a2
            x1, x2 = (x1 + h * u1, x2 + h * u2) if semi_implicit else (x1 + h * v1, x2 + h * v2)
            v1, v2 = u1, u2
        n, count = n + count, (yield x1, x2, v1, v2)


def _composition(weights: tuple[float, ...], problem: Problem, h: float) -> States:
    """Verlet steps of the lengths that the method weighs; the drive's clock moves with the drift, as the order asks."""
    accelerate = acceleration(problem)
    parts = [(weight * h, weight * h / 2) for weight in weights]
    x1, x2, v1, v2 = problem.start
    a1, a2 = accelerate(0.0, x1, x2, 0.0)
    n, count = 0, (yield problem.start)
    while True:
        for i in range(n, n + count):
            t = i * h
            for length, half in parts:
                v1 += half * a1
                v2 += half * a2
                x1 += length * v1
                x2 += length * v2
                t += length
                a1, a2 = accelerate(t, x1, x2, 0.0)
                v1 += half * a1
                v2 += half * a2
        n, count = n + count, (yield x1, x2, v1, v2)


def _rk4(problem: Problem, h: float) -> States:
    accelerate, half, sixth = acceleration(problem), h / 2, h / 6
    x1, x2, v1, v2 = problem.start
    n, count = 0, (yield problem.start)
    while True:
        for i in range(n, n + count):
            t = i * h
            a1, a2 = accelerate(t, x1, x2, v1)
            p1, p2 = v1 + half * a1, v2 + half * a2
            b1, b2 = accelerate(t + half, x1 + half * v1, x2 + half * v2, p1)
            q1, q2 = v1 + half * b1, v2 + half * b2
            c1, c2 = accelerate(t + half, x1 + half * p1, x2 + half * p2, q1)
            r1, r2 = v1 + h * c1, v2 + h * c2
            d1, d2 = accelerate(t + h, x1 + h * q1, x2 + h * q2, r1)
            x1 += sixth * (v1 + 2 * (p1 + q1) + r1)
            x2 += sixth * (v2 + 2 * (p2 + q2) + r2)
            v1 += sixth * (a1 + 2 * (b1 + c1) + d1)
            v2 += sixth * (a2 + 2 * (b2 + c2) + d2)
        n, count = n + count, (yield x1, x2, v1, v2)


def _averaged(nodes: tuple[float, ...], problem: Problem, h: float) -> States:
    """x moves by h u and v becomes 2 u - v, with the mean velocity u from (1 + h c/2m + h^2 K/4M) u = v + h a/2.

    a is the acceleration at the start of the step but for friction, under the mean of the drive at the nodes of the
    step. Cramer's rule, its determinant without cancellation.
    """
    chain, half, omega = problem.chain, h / 2, problem.omega
    accelerate = acceleration(replace(problem, F_0=0.0, c=0.0))
    push = problem.F_0 / chain.m1 / len(nodes)
    s1, s2, rub = half * half / chain.m1, half * half / chain.m2, half * problem.c / chain.m1
    p, q, r, s = 1 + rub + s1 * (chain.k1 + chain.k2), s1 * chain.k2, s2 * chain.k2, 1 + s2 * chain.k2
    determinant = (1 + rub + s1 * chain.k1) * s + s1 * chain.k2
    p, q, r, s = p / determinant, q / determinant, r / determinant, s / determinant
    x1, x2, v1, v2 = problem.start
    n, count = 0, (yield problem.start)
    while True:
        for i in range(n, n + count):
            a1, a2 = accelerate(0.0, x1, x2, v1)
            if push:
                a1 += push * sum([sin(omega * (i + node) * h) for node in nodes])
            r1, r2 = v1 + half * a1, v2 + half * a2
            u1, u2 = s * r1 + q * r2, r * r1 + p * r2
            x1 += h * u1
            x2 += h * u2
            v1, v2 = 2 * u1 - v1, 2 * u2 - v2
        n, count = n + count, (yield x1, x2, v1, v2)


GAUSS_NODES = (0.5 - sqrt(3) / 6, 0.5 + sqrt(3) / 6)
GAUSS = np.array([[0.25, 0.25 - sqrt(3) / 6], [0.25 + sqrt(3) / 6, 0.25]])


def _gauss(problem: Problem, h: float) -> States:
    """The stages' accelerations are G times those at x + c_i h v: one small linear map gives both increments."""
    accelerate, (first, second) = acceleration(problem), GAUSS_NODES
    rows = _gauss_map(problem, h).tolist()
    x1, x2, v1, v2 = problem.start
    n, count = 0, (yield problem.start)
    while True:
        for i in range(n, n + count):
            w1, w2 = h * v1, h * v2
            a1, a2 = accelerate((i + first) * h, x1 + first * w1, x2 + first * w2, v1)
            b1, b2 = accelerate((i + second) * h, x1 + second * w1, x2 + second * w2, v1)
            d1, d2, e1, e2 = [p * a1 + q * a2 + r * b1 + s * b2 for p, q, r, s in rows]
            x1 += w1 + d1
            x2 += w2 + d2
            v1 += e1
            v2 += e2
        n, count = n + count, (yield x1, x2, v1, v2)


def _gauss_map(problem: Problem, h: float) -> Array:
    """The map from the accelerations (a1, a2, b1, b2) of the stages at first to the gains of x - h v and v, (4, 4)."""
    chain = problem.chain
    stiffness = np.array([[-(chain.k1 + chain.k2), chain.k2], [chain.k2, -chain.k2]]) / [[chain.m1], [chain.m2]]
    friction = np.diag([-problem.c / chain.m1, 0.0])
    mean = np.full(2, 0.5)
    stages = np.eye(4) - h * h * np.kron(GAUSS @ GAUSS, stiffness) - h * np.kron(GAUSS, friction)
    gains = np.vstack([np.kron(h * h * mean @ GAUSS, np.eye(2)), np.kron(h * mean, np.eye(2))])
    rows: Array = np.linalg.solve(stages.T, gains.T).T
    return rows


STEPPING: Mapping[str, Stepping] = MappingProxyType(
    {
        "euler": Stepping(1, 1, partial(_euler, False)),
        "semi": Stepping(1, 1, partial(_euler, True)),
        **{
            slug: Stepping(order, len(WEIGHTS[slug]), partial(_composition, WEIGHTS[slug]), friction=False)
            for slug, order in (("verlet", 2), ("yoshida4", 4), ("yoshida6", 6))
        },
        "rk4": Stepping(4, 4, _rk4),
        "midpoint": Stepping(2, 1, partial(_averaged, (0.5,))),
        "newmark": Stepping(2, 1, partial(_averaged, (0.0, 1.0))),
        "gauss4": Stepping(4, 2, _gauss),
    }
)
FIXED_STEP = tuple(STEPPING)
