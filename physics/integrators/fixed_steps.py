"""Methods with fixed steps, for comparison with the closed form. The equations are in physics.integrators.problem.

- explicit Euler (order 1): grows at every step; semi-implicit Euler (order 1): stable for h omega_+ < 2;
- Verlet, the central difference (order 2): half a kick, a drift, half a kick; stable for h omega_+ < 2;
- Yoshida 4 and 6: Verlet steps of chosen lengths, some backwards (H. Yoshida, Phys. Lett. A 150 (1990) 262; the
  weights of order 6 are his solution A, to 20 digits as in Hairer, Lubich, Wanner, Geometric Numerical
  Integration, V.3.2);
- RK4, the classical Runge-Kutta method (order 4): stable for h omega_+ < 2.83, where it damps;
- Nystroem 4 and 6, for forces without x': E. J. Nystroem's method of order 4 with three evaluations and J. Albrecht's
  of order 6 with five (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.14); stable for
  h omega_+ < 2.58 and 3.04, where they damp;
- implicit midpoint and Newmark with the average acceleration (order 2): stable at every step, their phase is not.
  They take the drive in the middle of the step or at both ends; without one they are the same method;
- Gauss 4, two stages at the nodes of Gauss (order 4): stable at every step.

Implicit methods solve their linear equations once for all steps, as constant matrices allow.

A stepping function is plain arithmetic on plain floats: for two masses NumPy's cost of a call would be most of the
time, and a compiler can take it unchanged (tests/bench/compiled.py).
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, partial
from math import sin, sqrt, ulp
from types import MappingProxyType
from typing import Any

import numpy as np

from physics.integrators.problem import Problem, StepTooSmallError, StoppedError, Trajectory, Watch, trajectory
from physics.precision.exact import Array

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

Constants = tuple[float, ...]
"""m1, m2, k1, k2, F_0, omega and c of a problem."""
StepState = tuple[float, float, float, float, float, float]
"""x1, x2, v1, v2, and their accelerations, for methods that reuse the last ones of the previous step."""


Acceleration = Callable[[Constants, float, float, float, float], tuple[float, float]]
"""The two accelerations of a chain: of its constants, a time, two displacements and the velocity of mass 1."""
Advance = Callable[..., StepState]
"""A stepping function: `advance(p, numbers, h, n, count, *state)` is the state after `count` steps of length h, of
which the first is step n. `numbers` are what the method has computed of the problem for this h."""
Compiler = Callable[[Any], Any]
"""A maker of a faster function of a function of plain arithmetic."""


@dataclass(frozen=True)
class Stepping:
    """A method: its order, how often it evaluates the right-hand side in a step, and its stepping function.

    `advance` writes it around a right-hand side; `numbers` is what it is given of a problem and a step. Without
    `friction` it is for forces that depend on the position alone; `solved` are linear equations solved in advance.
    """

    order: int
    evaluations: int
    advance: Callable[[Acceleration], Advance]
    numbers: Callable[[Problem, float], Any]
    friction: bool = True
    solved: bool = False


def interpreted(function: Any) -> Any:
    """The function as Python runs it."""
    return function


@cache
def advance_of(method: str, side: Acceleration, compiler: Compiler = interpreted) -> Advance:
    """The stepping function of a method on a right-hand side."""
    advance: Advance = compiler(STEPPING[method].advance(compiler(side)))
    return advance


def run_fixed(method: str, problem: Problem, steps: float, watch: Watch) -> Trajectory:
    """A whole number of equal steps of a method of STEPPING from one output time to the next."""
    h, state = begun(problem, steps)
    side = right_hand_side(problem)
    fixed = (constants(problem), STEPPING[method].numbers(problem, h), h)
    advance, states = partial(advance_of(method, side), *fixed), np.empty((problem.t.size, 4))
    states[0] = state[:4]
    for n in range(1, problem.t.size):
        state = _advanced(advance, state, int(steps), h, watch)
        states[n] = state[:4]
        watch.evaluations = watch.steps * STEPPING[method].evaluations
        if STEPPING[method].solved:
            watch.factorisations, watch.solves = 1, watch.steps
        if not (abs(state[0]) <= watch.bound and abs(state[1]) <= watch.bound):
            raise exploded(problem, h, n)
    return trajectory(states)


def begun(problem: Problem, steps: float) -> tuple[float, StepState]:
    """The step h and the state at the start; ValueError or StepTooSmallError where there is no such step."""
    if not (steps >= 1 and steps == int(steps)):
        raise ValueError(
            f"{steps!r} steps from one output time to the next are not possible: a whole number from 1 on is needed"
        )
    h, end = problem.spacing / steps, float(problem.t[-1])
    if h < ulp(end):
        raise StepTooSmallError(f"step below spacing: h = {h:.3g} s, doubles at {end:.3g} s lie wider", 0.0)
    x1, x2, v1, v2 = problem.start
    return h, (x1, x2, v1, v2, *right_hand_side(problem)(constants(problem), 0.0, x1, x2, v1))


def exploded(problem: Problem, h: float, n: int) -> StoppedError:
    """The end of a run whose displacements have left all bounds at output n."""
    fastest = "f" if problem.c else "omega_+"
    return StoppedError(f"unstable step: h {fastest} = {h * problem.rates[1]:.3g}", float(problem.t[n]))


def _advanced(advance: Callable[..., StepState], state: StepState, left: int, h: float, watch: Watch) -> StepState:
    """The state so many steps later."""
    while left:
        count = min(left, CHUNK)
        state = advance(watch.steps, count, *state)
        left -= count
        watch.steps += count
        watch.check(watch.steps * h)
    return state


def constants(problem: Problem) -> Constants:
    """The numbers that the right-hand side is given."""
    chain = problem.chain
    return chain.m1, chain.m2, chain.k1, chain.k2, problem.F_0, problem.omega, problem.c


def right_hand_side(problem: Problem) -> Acceleration:
    """The accelerations of the problem, with no more in them than the problem has."""
    return damped if problem.c else driven if problem.F_0 else free


def free(p: Constants, t: float, x1: float, x2: float, v1: float) -> tuple[float, float]:
    """Springs alone."""
    m1, m2, k1, k2, _, _, _ = p
    pull = k2 * (x2 - x1)
    return (pull - k1 * x1) / m1, -pull / m2


def driven(p: Constants, t: float, x1: float, x2: float, v1: float) -> tuple[float, float]:
    """Springs and the drive."""
    m1, m2, k1, k2, F_0, omega, _ = p
    pull = k2 * (x2 - x1)
    return (pull - k1 * x1 + F_0 * sin(omega * t)) / m1, -pull / m2


def damped(p: Constants, t: float, x1: float, x2: float, v1: float) -> tuple[float, float]:
    """Springs, the drive and the dashpot."""
    m1, m2, k1, k2, F_0, omega, c = p
    pull = k2 * (x2 - x1)
    return (pull - k1 * x1 - c * v1 + F_0 * sin(omega * t)) / m1, -pull / m2


Fractions = tuple[Fraction, ...]


@dataclass(frozen=True)
class Tableau:
    """An explicit method for x'' = f(t, x, x'): the stages f_i at t + c_i h, x + c_i h v + h^2 sum_j X_ij f_j and
    v + h sum_j V_ij f_j; the last rows of X and V lead to the end of the step.

    Where all rows of V but the last are empty it is a method of Nystroem, for f that does not depend on x'.
    """

    order: int
    nodes: Fractions
    X: tuple[Fractions, ...]
    V: tuple[Fractions, ...]


def _rows(*rows: str) -> tuple[Fractions, ...]:
    return tuple(tuple(Fraction(number) for number in row.split()) for row in rows)


def runge_kutta(order: int, *rows: str) -> Tableau:
    """A Runge-Kutta method by its rows a_ij and, last, its weights: in x they act twice."""
    V = _rows(*rows)
    X = tuple(
        tuple(sum((a * V[i][j] for i, a in enumerate(row) if i > j), Fraction(0)) for j in range(len(row))) for row in V
    )
    return Tableau(order, tuple(sum(row, Fraction(0)) for row in V[:-1]), X, V)


def nystroem(order: int, nodes: str, weights: str, *rows: str) -> Tableau:
    """A method of Nystroem by its nodes, its weights for v, and its rows for x of which the last are the weights."""
    (c,), (b,) = _rows(nodes), _rows(weights)
    return Tableau(order, c, _rows(*rows), (*((),) * len(c), b))


TABLEAUX = {
    "euler": runge_kutta(1, "", "1"),
    "rk4": runge_kutta(4, "", "1/2", "0 1/2", "0 0 1", "1/6 1/3 1/3 1/6"),
    "nystrom4": nystroem(4, "0 1/2 1", "1/6 2/3 1/6", "", "1/8", "0 1/2", "1/6 1/3 0"),
    "nystrom6": nystroem(
        6, "0 1/4 1/2 3/4 1", "7/90 16/45 2/15 16/45 7/90",
        "", "1/32", "-1/24 1/6", "3/32 1/8 1/16", "0 3/7 -1/14 1/7", "7/90 4/15 1/15 4/45 0",
    ),
}  # fmt: skip


def _explicit(tableau: Tableau) -> Stepping:
    """Steps of a tableau, written out as one would by hand: a loop over its numbers takes 2.6 times as long."""
    source, held = _written(tableau)

    def advance(accelerate: Acceleration) -> Advance:
        names: dict[str, Any] = {"accelerate": accelerate}
        exec(source, names)
        written: Advance = names["advance"]
        return written

    return Stepping(
        order=tableau.order,
        evaluations=len(tableau.nodes),
        advance=advance,
        numbers=lambda problem, h: tuple(float(number) * h**power for number, power in held),
        friction=any(tableau.V[:-1]) or len(tableau.nodes) == 1,
    )


def _written(tableau: Tableau) -> tuple[str, list[tuple[Fraction, int]]]:
    """The source of a stepping function, and the coefficients, each with its power of h, that it is given."""
    held: dict[tuple[Fraction, int], str] = {}

    def times(number: Fraction, power: int) -> str:
        return held.setdefault((number, power), f"h{len(held)}")

    def total(row: Sequence[Fraction], power: int, i: int) -> str:
        return "".join(f" + {times(a, power)} * f{j}_{i}" for j, a in enumerate(row) if a)

    def drift(c: Fraction, i: int) -> str:
        return f" + {times(c, 1)} * v{i}" if c else ""

    lines = []
    for s, (c, to_x, to_v) in enumerate(zip(tableau.nodes, tableau.X, tableau.V, strict=False)):
        time = f"t + {times(c, 1)}" if c else "t"
        x = ", ".join(f"x{i}{drift(c, i)}{total(to_x, 2, i)}" for i in (1, 2))
        lines.append(f"f{s}_1, f{s}_2 = accelerate(p, {time}, {x}, v1{total(to_v, 1, 1)})")
    lines += [f"x{i} = x{i}{drift(Fraction(1), i)}{total(tableau.X[-1], 2, i)}" for i in (1, 2)]
    lines += [f"v{i} = v{i}{total(tableau.V[-1], 1, i)}" for i in (1, 2)]
    source = [
        "def advance(p, numbers, h, n, count, x1, x2, v1, v2, a1, a2):",
        f"    ({', '.join(held.values())},) = numbers",
        "    for i in range(n, n + count):",
        "        t = i * h",
        *(f"        {line}" for line in lines),
        "    return x1, x2, v1, v2, a1, a2",
    ]
    return "\n".join(source), list(held)


def _composition(order: int, parts: tuple[tuple[float, float, float], ...], friction: bool = False) -> Stepping:
    """Kicks, drifts and kicks of the lengths in `parts`; the drive's clock moves with the drift, as the order asks."""

    def advance(accelerate: Acceleration) -> Advance:
        def composed(
            p: Constants, numbers: Any, h: float, n: int, count: int,
            x1: float, x2: float, v1: float, v2: float, a1: float, a2: float,
        ) -> StepState:  # fmt: skip
            for i in range(n, n + count):
                t = i * h
                for before, length, after in numbers:
                    v1 += before * a1
                    v2 += before * a2
                    x1 += length * v1
                    x2 += length * v2
                    t += length
                    a1, a2 = accelerate(p, t, x1, x2, v1)
                    v1 += after * a1
                    v2 += after * a2
            return x1, x2, v1, v2, a1, a2

        return composed

    return Stepping(
        order=order,
        evaluations=len(parts),
        advance=advance,
        numbers=lambda problem, h: tuple((h * one, h * two, h * three) for one, two, three in parts),
        friction=friction,
    )


def _halved(weights: tuple[float, ...]) -> tuple[tuple[float, float, float], ...]:
    """Verlet steps of these lengths."""
    return tuple((weight / 2, weight, weight / 2) for weight in weights)


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


GAUSS_NODES = (0.5 - sqrt(3) / 6, 0.5 + sqrt(3) / 6)
GAUSS = np.array([[0.25, 0.25 - sqrt(3) / 6], [0.25 + sqrt(3) / 6, 0.25]])


def _gauss(accelerate: Acceleration) -> Advance:
    """The stages' accelerations are G times those at x + c_i h v: one small linear map gives both increments."""
    first, second = GAUSS_NODES

    def staged(
        p: Constants, numbers: Any, h: float, n: int, count: int,
        x1: float, x2: float, v1: float, v2: float, a1: float, a2: float,
    ) -> StepState:  # fmt: skip
        (p1, q1, r1, s1), (p2, q2, r2, s2), (p3, q3, r3, s3), (p4, q4, r4, s4) = numbers
        for i in range(n, n + count):
            w1, w2 = h * v1, h * v2
            b1, b2 = accelerate(p, (i + first) * h, x1 + first * w1, x2 + first * w2, v1)
            c1, c2 = accelerate(p, (i + second) * h, x1 + second * w1, x2 + second * w2, v1)
            x1 += w1 + (p1 * b1 + q1 * b2 + r1 * c1 + s1 * c2)
            x2 += w2 + (p2 * b1 + q2 * b2 + r2 * c1 + s2 * c2)
            v1 += p3 * b1 + q3 * b2 + r3 * c1 + s3 * c2
            v2 += p4 * b1 + q4 * b2 + r4 * c1 + s4 * c2
        return x1, x2, v1, v2, a1, a2

    return staged


def _gauss_map(problem: Problem, h: float) -> tuple[tuple[float, ...], ...]:
    """The map from the accelerations (a1, a2, b1, b2) of the stages at first to the gains of x - h v and v, (4, 4)."""
    chain = problem.chain
    stiffness = np.array([[-(chain.k1 + chain.k2), chain.k2], [chain.k2, -chain.k2]]) / [[chain.m1], [chain.m2]]
    friction = np.diag([-problem.c / chain.m1, 0.0])
    mean = np.full(2, 0.5)
    stages = np.eye(4) - h * h * np.kron(GAUSS @ GAUSS, stiffness) - h * np.kron(GAUSS, friction)
    gains = np.vstack([np.kron(h * h * mean @ GAUSS, np.eye(2)), np.kron(h * mean, np.eye(2))])
    rows: Array = np.linalg.solve(stages.T, gains.T).T
    return tuple(tuple(row) for row in rows.tolist())


STEPPING: Mapping[str, Stepping] = MappingProxyType(
    {
        "euler": _explicit(TABLEAUX["euler"]),
        "semi": _composition(1, ((1.0, 1.0, 0.0),), friction=True),
        "verlet": _composition(2, _halved(WEIGHTS["verlet"])),
        "yoshida4": _composition(4, _halved(YOSHIDA_4)),
        "yoshida6": _composition(6, _halved(YOSHIDA_6)),
        **{slug: _explicit(TABLEAUX[slug]) for slug in ("rk4", "nystrom4", "nystrom6")},
        "midpoint": Stepping(2, 1, _averaging, partial(_averaged_numbers, 0.5, 0.5), solved=True),
        "newmark": Stepping(2, 1, _averaging, partial(_averaged_numbers, 0.0, 1.0), solved=True),
        "gauss4": Stepping(4, 2, _gauss, _gauss_map, solved=True),
    }
)
FIXED_STEP = tuple(STEPPING)
