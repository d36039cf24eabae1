"""A problem for a method that computes motion, and the trajectory that it gives back.

    m1 x1'' = -k1 x1 - k2 (x1 - x2) - c x1' + F_0 sin(omega t),   m2 x2'' = k2 (x1 - x2)

The dashpot c is parallel to spring 1 and is used only for an overdamped oscillator: k2 = 0, mass 2 is
at rest, and both rates of decay of mass 1 are real.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import inf

from physics.coupled import TwoMassChain
from physics.damped import DampedOscillator
from physics.precision.exact import Array

MotionState = tuple[float, float, float, float]  # x1, x2, v1, v2


@dataclass(frozen=True, kw_only=True)
class Problem:
    """A chain, its drive, its start, and the times t (n,) it is asked for: equally spaced, from 0 on."""

    chain: TwoMassChain
    x_0: tuple[float, float]
    v_0: tuple[float, float]
    t: Array
    F_0: float = 0.0
    omega: float = 0.0
    c: float = 0.0  # N s/m
    size: float = 1.0  # the largest displacement to be expected, in m

    def __post_init__(self) -> None:
        if self.c and (self.chain.k2 or self.x_0[1] or self.v_0[1]):
            raise ValueError(
                f"the damping c = {self.c:g} N s/m is not possible here: k2 = 0 and mass 2 at rest are needed"
            )

    @property
    def start(self) -> MotionState:
        """The displacements in m and velocities in m/s at t = 0."""
        return *self.x_0, *self.v_0

    @property
    def spacing(self) -> float:
        """The time in s between two outputs."""
        return float(self.t[1] - self.t[0])

    @property
    def damped(self) -> DampedOscillator:
        """Mass 1 on its spring with its dashpot."""
        return DampedOscillator(m=self.chain.m1, c=self.c, k=self.chain.k1)

    @property
    def rates(self) -> tuple[float, float]:
        """The slow and the fast one: natural frequencies in rad/s (0 for a drift), or rates of decay in 1/s."""
        if not self.c:
            slow, fast = self.chain.modes().omega.tolist()
            return slow, fast
        decays = self.damped.decays(1.0, 0.0)
        if len(decays) < 2:
            raise ValueError(f"the damping c = {self.c:g} N s/m lets the mass swing: more than 2 sqrt(k1 m1) is needed")
        return decays[0].rate, decays[1].rate


class StoppedError(Exception):
    """A run that was given up; the message is the reason, reached the time it got to in s.

    `end` is why nothing finer is tried after it, "" where something finer may succeed.
    """

    end = ""

    def __init__(self, reason: str, reached: float) -> None:
        super().__init__(reason)
        self.reached = reached


class OverTimeError(StoppedError):
    """The time limit of a run is over."""

    end = "time limit"


class CancelledError(StoppedError):
    """The run was cancelled."""

    end = "cancelled"


class StepTooSmallError(StoppedError):
    """The step is below the spacing of doubles at the time it starts from."""

    end = "spacing"


@dataclass
class Watch:
    """A watch over one run: it counts what the run costs; check(t), called now and then, may raise StoppedError.

    `jacobians` counts evaluated Jacobians, `factorisations` LU of the method's matrices, `solves` the linear systems
    solved with them, which LSODA does not report. `stiff_steps` counts LSODA's steps with formulas for stiff equations.
    Fixed steps whose displacements pass `bound` (m) are given up as unstable.
    """

    check: Callable[[float], None] = lambda t: None
    bound: float = inf
    evaluations: int = 0
    steps: int = 0
    stiff_steps: int = 0
    jacobians: int = 0
    factorisations: int = 0
    solves: int = 0


@dataclass(frozen=True)
class Trajectory:
    """A computed motion: x and v, each (2, n), and x2 - x1 (n,), which is often better than their difference."""

    x: Array
    v: Array
    stretch: Array


def trajectory(states: Array) -> Trajectory:
    """The trajectory of a method that knows states (n, 4) only: x1, x2, v1, v2."""
    x, v = states[:, :2].T, states[:, 2:4].T
    return Trajectory(x=x, v=v, stretch=x[1] - x[0])
