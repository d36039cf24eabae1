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
- implicit methods: physics.integrators.implicit_steps; exponential ones: physics.integrators.exponential_steps.

A stepping function is plain arithmetic on plain floats: for two masses NumPy's cost of a call would be most of the
time, and a compiler can take it unchanged (tools/bench/compiled.py).
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, partial
from math import sin, ulp
from types import MappingProxyType
from typing import Any

import numpy as np

from physics.integrators.exponential_steps import EXPONENTIAL
from physics.integrators.implicit_steps import IMPLICIT
from physics.integrators.problem import Problem, StepTooSmallError, StoppedError, Trajectory, Watch, trajectory
from physics.integrators.stepping import Acceleration, Advance, Compiler, Constants, Stepping, StepState

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
CHUNK = 1024  # steps between two checks of the time limit


def interpreted(function: Any) -> Any:
    """Return the `function` as Python runs it."""
    return function


@cache
def advance_of(method: str, side: Acceleration, compiler: Compiler = interpreted) -> Advance:
    """Return the stepping function of a method.

    Parameters
    ----------
    method : str
        A key of STEPPING.
    side : Acceleration
        The right-hand side.
    compiler : Compiler
        The compiler of both.

    Returns
    -------
    Advance
        The function, which is cached.
    """
    advance: Advance = compiler(STEPPING[method].advance(compiler(side)))
    return advance


def run_fixed(method: str, problem: Problem, steps: float, watch: Watch) -> Trajectory:
    """Compute the motion with equal steps of a method.

    Parameters
    ----------
    method : str
        A key of STEPPING.
    problem : Problem
        The motion.
    steps : float
        The number of steps from one output time to the next, a whole number.
    watch : Watch
        The counts and limits of the run.

    Returns
    -------
    Trajectory
        The motion at the output times.

    Raises
    ------
    ValueError
        If the number of steps is not possible.
    StoppedError
        If the steps are below the spacing of doubles, or displacements leave the bound.
    """
    given, state = begun(method, problem, steps)
    h, side = given[2], right_hand_side(problem)
    advance, states = partial(advance_of(method, side), *given), np.empty((problem.t.size, 4))
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


def begun(method: str, problem: Problem, steps: float) -> tuple[tuple[Constants, Any, float], StepState]:
    """Return the arguments of a stepping function, and its initial state.

    Parameters
    ----------
    method : str
        A key of STEPPING.
    problem : Problem
        The motion.
    steps : float
        The number of steps from one output time to the next, a whole number.

    Returns
    -------
    tuple
        The arguments (p, numbers, h), and the StepState at t = 0.

    Raises
    ------
    ValueError
        If the number of steps is not possible.
    StepTooSmallError
        If a step is below the spacing of doubles.
    """
    if not (steps >= 1 and steps == int(steps)):
        raise ValueError(
            f"{steps!r} steps from one output time to the next are not possible: a whole number from 1 on is needed"
        )
    h, end = problem.spacing / steps, float(problem.t[-1])
    if h < ulp(end):
        raise StepTooSmallError(f"step below spacing: h = {h:.3g} s, doubles at {end:.3g} s lie wider", 0.0)
    step, (x1, x2, v1, v2) = STEPPING[method], problem.start
    p = constants(problem)
    if step.splits:
        p = (*p[:3], 0.0, *p[4:])
    return (p, step.numbers(problem, h), h), (x1, x2, v1, v2, *right_hand_side(problem)(p, 0.0, x1, x2, v1))


def exploded(problem: Problem, h: float, n: int) -> StoppedError:
    """Return the end of a run whose displacements have left all bounds.

    Parameters
    ----------
    problem : Problem
        The motion.
    h : float
        The step in s.
    n : int
        The output at which they have left.

    Returns
    -------
    StoppedError
        The reason, and the time reached.
    """
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
    """Return the numbers of the `problem` that its right-hand side takes."""
    chain = problem.chain
    return chain.m1, chain.m2, chain.k1, chain.k2, problem.F_0, problem.omega, problem.c


def right_hand_side(problem: Problem) -> Acceleration:
    """Return the accelerations of the `problem`, with no more in them than the problem has."""
    return damped if problem.c else driven if problem.F_0 else free


def free(p: Constants, t: float, x1: float, x2: float, v1: float) -> tuple[float, float]:
    """Springs alone. Parameters and result as in `Acceleration`."""
    m1, m2, k1, k2, _, _, _ = p
    pull = k2 * (x2 - x1)
    return (pull - k1 * x1) / m1, -pull / m2


def driven(p: Constants, t: float, x1: float, x2: float, v1: float) -> tuple[float, float]:
    """Springs and the drive. Parameters and result as in `Acceleration`."""
    m1, m2, k1, k2, F_0, omega, _ = p
    pull = k2 * (x2 - x1)
    return (pull - k1 * x1 + F_0 * sin(omega * t)) / m1, -pull / m2


def damped(p: Constants, t: float, x1: float, x2: float, v1: float) -> tuple[float, float]:
    """Springs, the drive and the dashpot. Parameters and result as in `Acceleration`."""
    m1, m2, k1, k2, F_0, omega, c = p
    pull = k2 * (x2 - x1)
    return (pull - k1 * x1 - c * v1 + F_0 * sin(omega * t)) / m1, -pull / m2


Fractions = tuple[Fraction, ...]


@dataclass(frozen=True)
class Tableau:
    """An explicit method for x'' = f(t, x, x'): the stages f_i at t + c_i h, x + c_i h v + h^2 sum_j X_ij f_j and
    v + h sum_j V_ij f_j; the last rows of X and V lead to the end of the step.

    Where all rows of V but the last are empty it is a method of Nystroem, for f that does not depend on x'.

    Attributes
    ----------
    order : int
        The order of the method.
    nodes : tuple of Fraction
        c_i.
    X, V : tuple of tuples of Fraction
        The rows X_ij and V_ij.
    """

    order: int
    nodes: Fractions
    X: tuple[Fractions, ...]
    V: tuple[Fractions, ...]


def _rows(*rows: str) -> tuple[Fractions, ...]:
    return tuple(tuple(Fraction(number) for number in row.split()) for row in rows)


def runge_kutta(order: int, *rows: str) -> Tableau:
    """Return the Runge-Kutta method of an `order` by its rows a_ij and, last, its weights: in x they act twice."""
    V = _rows(*rows)
    X = tuple(
        tuple(sum((a * V[i][j] for i, a in enumerate(row) if i > j), Fraction(0)) for j in range(len(row))) for row in V
    )
    return Tableau(order, tuple(sum(row, Fraction(0)) for row in V[:-1]), X, V)


def nystroem(order: int, nodes: str, weights: str, *rows: str) -> Tableau:
    """Return a method of Nystroem.

    Parameters
    ----------
    order : int
        The order of the method.
    nodes, weights : str
        Its nodes c_i, and its weights for v, as fractions.
    *rows : str
        Its rows for x; the last one has the weights.

    Returns
    -------
    Tableau
        The method.
    """
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


STEPPING: Mapping[str, Stepping] = MappingProxyType(
    {
        "euler": _explicit(TABLEAUX["euler"]),
        "semi": _composition(1, ((1.0, 1.0, 0.0),), friction=True),
        "verlet": _composition(2, _halved(WEIGHTS["verlet"])),
        "yoshida4": _composition(4, _halved(YOSHIDA_4)),
        "yoshida6": _composition(6, _halved(YOSHIDA_6)),
        **{slug: _explicit(TABLEAUX[slug]) for slug in ("rk4", "nystrom4", "nystrom6")},
        **IMPLICIT,
        **EXPONENTIAL,
    }
)
FIXED_STEP = tuple(STEPPING)
