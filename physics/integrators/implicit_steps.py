"""Implicit methods with fixed steps; their linear equations are solved once for all steps, as constant matrices allow.

- implicit midpoint and Newmark with the average acceleration (order 2): stable at every step, without damping. They
  take the drive in the middle of the step or at both ends; without one they are the same method;
- Gauss 4, two stages at the nodes of Gauss (order 4): the same;
- implicit Euler (order 1), SDIRK 2 (R. Alexander, SIAM J. Numer. Anal. 14 (1977) 1006, order 2) and Radau IIA (order 5,
  Hairer and Wanner, Solving Ordinary Differential Equations II, IV.5): L-stable, so a fast part is gone in a few steps;
- generalized-alpha (J. Chung, G. M. Hulbert, J. Appl. Mech. 60 (1993) 371, order 2): stable at every step, of a fast
  oscillation a step leaves the share RHO. HHT-alpha and Newmark are of the same family.
"""

from functools import partial
from math import sin, sqrt
from typing import Any

import numpy as np

from physics.integrators.problem import Problem
from physics.integrators.stepping import Acceleration, Advance, Constants, Stepping, StepState
from physics.precision.exact import Array


def _averaging(accelerate: Acceleration) -> Advance:
    """x moves by h u and v becomes 2 u - v, with the mean velocity u from (1 + h c/2m + h^2 K/4M) u = v + h a/2.

    a is the acceleration at the start of the step but for friction, under the mean of the drive at the nodes of the
    step. Cramer's rule, its determinant without cancellation.
    """

    def averaged(
        p: Constants, numbers: Any, h: float, n: int, count: int,
        x1: float, x2: float, v1: float, v2: float, a1: float, a2: float,
    ) -> StepState:  # fmt: skip
        m1, m2, k1, k2, F_0, omega, _ = p
        p11, p12, p21, p22, half, first, last = numbers
        for i in range(n, n + count):
            pull = k2 * (x2 - x1)
            force = pull - k1 * x1
            if F_0:
                drive = sin(omega * (i + first) * h)
                if last > first:
                    drive = (drive + sin(omega * (i + last) * h)) / 2
                force += F_0 * drive
            r1, r2 = v1 + half * force / m1, v2 - half * pull / m2
            u1, u2 = p11 * r1 + p12 * r2, p21 * r1 + p22 * r2
            x1 += h * u1
            x2 += h * u2
            v1, v2 = 2 * u1 - v1, 2 * u2 - v2
        return x1, x2, v1, v2, a1, a2

    return averaged


def _averaged_numbers(first: float, last: float, problem: Problem, h: float) -> Constants:
    """The inverse matrix of the mean velocity, half a step, and the nodes of the drive."""
    chain, half = problem.chain, h / 2
    s1, s2, rub = half * half / chain.m1, half * half / chain.m2, half * problem.c / chain.m1
    p, q, r, s = 1 + rub + s1 * (chain.k1 + chain.k2), s1 * chain.k2, s2 * chain.k2, 1 + s2 * chain.k2
    determinant = (1 + rub + s1 * chain.k1) * s + s1 * chain.k2
    return s / determinant, q / determinant, r / determinant, p / determinant, half, first, last


def _collocated(order: int, nodes: tuple[float, ...], matrix: Array, weights: Array) -> Stepping:
    """A Runge-Kutta method with unrolled steps."""
    source = _written(nodes)

    def advance(accelerate: Acceleration) -> Advance:
        names: dict[str, Any] = {"accelerate": accelerate}
        exec(source, names)
        written: Advance = names["advance"]
        return written

    return Stepping(order, len(nodes), advance, partial(_gains, matrix, weights), solved=True)


def _written(nodes: tuple[float, ...]) -> str:
    """The source of the steps: the accelerations f at x + c h v, and one linear map of them to both increments."""
    lines = [
        f"f{s}_1, f{s}_2 = accelerate(p, (i + {c!r}) * h, x1 + {c!r} * w1, x2 + {c!r} * w2, v1)"
        for s, c in enumerate(nodes)
    ]
    values = [f"f{s}_{mass}" for s in range(len(nodes)) for mass in (1, 2)]
    for row, (old, drift) in enumerate((("x1", " + w1"), ("x2", " + w2"), ("v1", ""), ("v2", ""))):
        gain = " + ".join(f"g{row}_{column} * {value}" for column, value in enumerate(values))
        lines.append(f"{old} = {old}{drift} + ({gain})")
    held = (", ".join(f"g{row}_{column}" for column in range(len(values))) for row in range(4))
    source = [
        "def advance(p, numbers, h, n, count, x1, x2, v1, v2, a1, a2):",
        f"    {', '.join(f'({row})' for row in held)} = numbers",
        "    for i in range(n, n + count):",
        "        w1, w2 = h * v1, h * v2",
        *(f"        {line}" for line in lines),
        "    return x1, x2, v1, v2, a1, a2",
    ]
    return "\n".join(source)


def _gains(matrix: Array, weights: Array, problem: Problem, h: float) -> tuple[tuple[float, ...], ...]:
    """The map (4, 2 s) from the accelerations at x + c h v, with the velocities v, to the gains of x - h v and v."""
    stiffness, friction = _forces(problem)
    stages = np.eye(2 * weights.size) - h * h * np.kron(matrix @ matrix, stiffness) - h * np.kron(matrix, friction)
    gains = np.vstack([np.kron(h * h * weights @ matrix, np.eye(2)), np.kron(h * weights, np.eye(2))])
    rows: Array = np.linalg.solve(stages.T, gains.T).T
    return tuple(tuple(row) for row in rows.tolist())


def _forces(problem: Problem) -> tuple[Array, Array]:
    """The matrices (2, 2) that make accelerations of displacements and of velocities."""
    chain = problem.chain
    stiffness = np.array([[-(chain.k1 + chain.k2), chain.k2], [chain.k2, -chain.k2]]) / [[chain.m1], [chain.m2]]
    return stiffness, np.diag([-problem.c / chain.m1, 0.0])


RHO = 0.8
"""The share of a much too fast oscillation that a step of generalized-alpha leaves."""
ALPHA_M, ALPHA_F = (2 * RHO - 1) / (RHO + 1), RHO / (RHO + 1)
GAMMA, BETA = 0.5 - ALPHA_M + ALPHA_F, (1 - ALPHA_M + ALPHA_F) ** 2 / 4


def _generalized(accelerate: Acceleration) -> Advance:
    """M a at alpha_m and the forces at alpha_f between the new state (at 0) and the old one (at 1) are in balance.

    x and v follow from a as with Newmark, with beta and gamma.
    """

    def generalized(
        p: Constants, numbers: Any, h: float, n: int, count: int,
        x1: float, x2: float, v1: float, v2: float, a1: float, a2: float,
    ) -> StepState:  # fmt: skip
        g11, g12, g21, g22, old_x, new_x, old_v, new_v = numbers
        for i in range(n, n + count):
            y1, y2 = x1 + h * v1 + old_x * a1, x2 + h * v2 + old_x * a2
            u1, u2 = v1 + old_v * a1, v2 + old_v * a2
            f1, f2 = accelerate(
                p, (i + 1 - ALPHA_F) * h, y1 + ALPHA_F * (x1 - y1), y2 + ALPHA_F * (x2 - y2), u1 + ALPHA_F * (v1 - u1)
            )
            r1, r2 = f1 - ALPHA_M * a1, f2 - ALPHA_M * a2
            a1, a2 = g11 * r1 + g12 * r2, g21 * r1 + g22 * r2
            x1, x2 = y1 + new_x * a1, y2 + new_x * a2
            v1, v2 = u1 + new_v * a1, u2 + new_v * a2
        return x1, x2, v1, v2, a1, a2

    return generalized


def _generalized_numbers(problem: Problem, h: float) -> Constants:
    """The inverse matrix of the new accelerations, and the weights of old and new ones in x and v."""
    stiffness, friction = _forces(problem)
    new_x, new_v = h * h * BETA, h * GAMMA
    matrix = (1 - ALPHA_M) * np.eye(2) - (1 - ALPHA_F) * (new_x * stiffness + new_v * friction)
    g11, g12, g21, g22 = np.linalg.inv(matrix).ravel().tolist()
    return g11, g12, g21, g22, h * h * (0.5 - BETA), new_x, h * (1 - GAMMA), new_v


def _tableau(order: int, nodes: tuple[float, ...], *rows: tuple[float, ...]) -> Stepping:
    """A method by its nodes and rows; the last row is its weights, and where there are no more rows than nodes also
    the last stage."""
    matrix = np.array(rows)
    return _collocated(order, nodes, matrix[: len(nodes)], matrix[-1])


R3, R6, G = sqrt(3), sqrt(6), 1 - sqrt(0.5)
IMPLICIT = {
    "midpoint": Stepping(2, 1, _averaging, partial(_averaged_numbers, 0.5, 0.5), solved=True),
    "newmark": Stepping(2, 1, _averaging, partial(_averaged_numbers, 0.0, 1.0), solved=True),
    "gauss4": _tableau(
        4, (0.5 - R3 / 6, 0.5 + R3 / 6), (0.25, 0.25 - R3 / 6), (0.25 + R3 / 6, 0.25), (0.5, 0.5)
    ),
    "ieuler": _tableau(1, (1.0,), (1.0,)),
    "sdirk2": _tableau(2, (G, 1.0), (G, 0.0), (1 - G, G)),
    "radau5": _tableau(
        5, ((4 - R6) / 10, (4 + R6) / 10, 1.0),
        ((88 - 7 * R6) / 360, (296 - 169 * R6) / 1800, (-2 + 3 * R6) / 225),
        ((296 + 169 * R6) / 1800, (88 + 7 * R6) / 360, (-2 - 3 * R6) / 225),
        ((16 - R6) / 36, (16 + R6) / 36, 1 / 9),
    ),
    "alpha": Stepping(2, 1, _generalized, _generalized_numbers, solved=True, memory=True),
}  # fmt: skip
"""The methods of this module, and their stepping functions."""
