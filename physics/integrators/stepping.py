"""The interface of a method with fixed steps: its arguments and its results."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from physics.integrators.problem import Problem

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
    """A method with fixed steps.

    Attributes
    ----------
    order : int
        The order of the method.
    evaluations : int
        The evaluations of the right-hand side in a step.
    advance : callable
        Returns the stepping function around a right-hand side.
    numbers : callable
        Returns the coefficients of a problem and a step in s.
    friction : bool
        False if it is for forces that depend on the position only.
    solved : bool
        True if linear equations are solved in advance.
    memory : bool
        True if the next step depends on the accelerations too.
    splits : bool
        True if it solves the coupling spring exactly: the right-hand side that it evaluates has k2 = 0.
    """

    order: int
    evaluations: int
    advance: Callable[[Acceleration], Advance]
    numbers: Callable[[Problem, float], Any]
    friction: bool = True
    solved: bool = False
    memory: bool = False
    splits: bool = False
