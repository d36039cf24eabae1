"""A problem for a method that computes motion, and the trajectory that it gives back.

    m1 x1'' = -k1 x1 - k2 (x1 - x2) - c x1' + F_0 sin(omega t),   m2 x2'' = k2 (x1 - x2)

The dashpot c is parallel to spring 1 and is used only for an overdamped oscillator: k2 = 0, mass 2 is
at rest, and both rates of decay of mass 1 are real.

Source: lecture D34, slides 2 and 6; the dashpot is beyond lecture D31.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import inf

import numpy as np

from physics.coupled import TwoMassChain
from physics.damped import DampedOscillator
from physics.precision.exact import Array
from physics.valid import in_range

MotionState = tuple[float, float, float, float]  # x1, x2, v1, v2


@dataclass(frozen=True, kw_only=True)
class Problem:
    """A chain, its drive, its initial conditions, and the times at which the motion is wanted.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    x_0, v_0 : tuple of two floats
        Displacements in m and velocities in m/s at t = 0.
    t : ndarray (n,)
        Output times in s, equally spaced from 0 on.
    F_0, omega : float
        The force F_0 sin(omega t) on mass 1, in N and rad/s.
    c : float
        The damping parallel to spring 1 in N s/m.
    size : float
        The largest displacement to be expected in m.

    Raises
    ------
    ValueError
        If there is a dashpot and mass 2 is not at rest without a spring, or if omega t of a drive leaves the
        range of doubles.
    """

    chain: TwoMassChain
    x_0: tuple[float, float]
    v_0: tuple[float, float]
    t: Array
    F_0: float = 0.0
    omega: float = 0.0
    c: float = 0.0
    size: float = 1.0

    def __post_init__(self) -> None:
        if self.c and (self.chain.k2 or self.x_0[1] or self.v_0[1]):
            raise ValueError(
                f"the damping c = {self.c:g} N s/m is not possible here: k2 = 0 and mass 2 at rest are needed"
            )
        if self.F_0:
            with np.errstate(over="ignore"):
                in_range("omega t", self.omega * self.t[-1:])

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
        """The slow and the fast one: natural frequencies in rad/s (0 for a drift), or rates of decay in 1/s.

        ValueError if a dashpot lets the mass swing.
        """
        if not self.c:
            slow, fast = self.chain.modes().omega.tolist()
            return slow, fast
        decays = self.damped.decays(1.0, 0.0)
        if len(decays) < 2:
            raise ValueError(f"the damping c = {self.c:g} N s/m lets the mass swing: more than 2 sqrt(k1 m1) is needed")
        return decays[0].rate, decays[1].rate


class StoppedError(Exception):
    """A run that was given up.

    `end` is why nothing finer is tried after it, "" where something finer may succeed.

    Parameters
    ----------
    reason : str
        The message.
    reached : float
        The time in s that the run reached.
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
    """A watch over one run: it counts what the run costs, and may stop it.

    Attributes
    ----------
    check : callable
        Called now and then with the time in s that the run has reached; it may raise StoppedError.
    bound : float
        Fixed steps whose displacements pass it (m) are given up as unstable.
    evaluations, steps : int
        Evaluations of the right-hand side, and steps.
    stiff_steps : int
        LSODA's steps with formulas for stiff equations.
    jacobians, factorisations, solves : int
        Jacobians, LU factorisations of the method's matrices, and linear systems solved with them. LSODA does not
        report the last.
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
    """A computed motion.

    Attributes
    ----------
    x, v : ndarray (2, n)
        Displacements in m and velocities in m/s.
    stretch : ndarray (n,)
        x2 - x1 in m, which is often better than the difference of x.
    """

    x: Array
    v: Array
    stretch: Array


def trajectory(states: Array) -> Trajectory:
    """Return the trajectory of a method that knows `states` (n, 4) only: x1, x2, v1, v2."""
    x, v = states[:, :2].T, states[:, 2:4].T
    return Trajectory(x=x, v=v, stretch=x[1] - x[0])


Runner = Callable[[Problem, float, Watch], Trajectory]
"""A function that computes a motion: of the problem, the setting of the method (rtol, or steps from one output time to
the next, or 0) and the watch over the run, it returns the motion at the output times, or raises StoppedError."""
