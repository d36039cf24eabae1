"""Stiff and highly oscillatory motions, distinguished by the limit of the step.

- A motion is stiff if stability, not accuracy, limits the step of an explicit method.
- It is highly oscillatory if accuracy limits the step because a fast oscillation, which nothing damps, carries part
  of the motion: only a method that solves it exactly can step over it.

The measure is |lambda| h, with the fast rate |lambda| and the step h in s: the step of RK4 at the limit of
stability, and at the limit of accuracy the step at which Gauss 4, of the same order but stable at every step,
has the accepted error.

Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed. (1996), IV.1.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from math import exp, log
from typing import Literal

from physics.integrators.accuracy import Run, System
from physics.integrators.stability import stability_limit

WANTED = 1e-3
FAR = 100.0
"""A fast rate so many times the slow one is far from it."""
MotionKind = Literal["stiff", "highly oscillatory", "neither"]


@dataclass(frozen=True)
class Stiffness:
    """The limits of the step of a motion.

    Attributes
    ----------
    accurate, stable : float
        |lambda| h at the limits of accuracy and of stability.
    spread : float
        The fast rate over the slow one.
    """

    accurate: float
    stable: float
    spread: float

    @property
    def kind(self) -> MotionKind:
        """The name of the motion."""
        if self.accurate > self.stable:
            return "stiff"
        return "highly oscillatory" if self.spread > FAR else "neither"


def stiffness(system: System, runs: Iterable[Run], wanted: float = WANTED) -> Stiffness | None:
    """Return the measure of a system.

    Parameters
    ----------
    system : System
        The motion.
    runs : iterable of Run
        Its runs, of which those of Gauss 4 count.
    wanted : float
        The accepted error.

    Returns
    -------
    Stiffness or None
        None if no run of Gauss 4 has the wanted error.
    """
    problem = system.problem()
    slow, fast = problem.rates
    steps = _steps([run for run in runs if run.method == "gauss4" and run.error], wanted)
    if steps is None:
        return None
    stable = stability_limit("rk4", slow / fast if problem.c else None)
    return Stiffness(fast * problem.spacing / steps, stable, fast / slow if slow else float("inf"))


def _steps(runs: list[Run], wanted: float) -> float | None:
    """Steps an output with this error, on the line from run to run, both axes logarithmic."""
    before = None
    for run in sorted(runs, key=lambda run: run.setting):
        error = run.error or 0.0
        if error <= wanted:
            if before is None:
                return run.setting
            share = log((before.error or 0.0) / wanted) / log((before.error or 0.0) / error)
            return before.setting * exp(share * log(run.setting / before.setting))
        before = run
    return None
