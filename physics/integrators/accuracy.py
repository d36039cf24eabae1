"""Error against run time: the motions that every method is measured on, and what is noted of each run.

A System is a chain with a start and perhaps a drive or a dashpot. Each method at each setting is asked for the motion
at the same 1000 times over about 50 slow periods; physics.integrators.race times it and compares it with a reference in
mpmath. The outputs see every phase of the fast mode: at one phase alone, errors of the phase would hide.

Errors are the worst over both masses, in units of the largest displacement, and with a dashpot the velocity's in units
of the largest velocity if they are worse: what a stiff method must lose at once is seen there. Energy errors are in
units of the largest energy. Conserved energy does not certify phase: implicit midpoint keeps every digit of the energy
while its motion is all wrong.
"""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from math import frexp, ldexp, pi
from types import MappingProxyType
from typing import Any

import numpy as np

from physics.coupled import TwoMassChain
from physics.integrators.problem import Problem
from physics.integrators.solvers import METHODS
from physics.precision.exact import Array

PERIODS, OUTPUTS = 50, 1000
MARKS = (0, 1, 2, 3, 5, 7, 10, 15, 20, 25, 30, 35, 40, 45, 50)
"""The slow periods after which a run reports its worst error so far."""
REPEATS = 1.2  # a run time counts as repeatable if the longest is at most so many times the shortest


@dataclass(frozen=True, kw_only=True)
class System:
    """A motion to compute: a chain, its initial conditions, and perhaps a drive or a dashpot.

    Attributes
    ----------
    slug, name : str
        Its name in addresses, and for readers.
    chain : TwoMassChain
        The masses and springs.
    x_0, v_0 : tuple of two floats
        Displacements in m and velocities in m/s at t = 0.
    F_0, omega : float
        The force F_0 sin(omega t) on mass 1, in N and rad/s.
    c : float
        The damping parallel to spring 1 in N s/m.
    periods : float
        The duration in slow periods, or in relaxation times with a dashpot.
    """

    slug: str
    name: str
    chain: TwoMassChain
    x_0: tuple[float, float] = (0.0, 0.0)
    v_0: tuple[float, float] = (0.0, 0.0)
    F_0: float = 0.0
    omega: float = 0.0
    c: float = 0.0
    periods: float = PERIODS

    @property
    def unit(self) -> str:
        """The unit in which its time is counted."""
        return "relaxation times" if self.c else "slow periods"

    @cached_property
    def rates(self) -> tuple[float, float]:
        """The slow and the fast one, as `Problem.rates`."""
        return self._asked_for(np.arange(2.0)).rates

    def problem(self, periods: float | None = None, outputs: int = OUTPUTS) -> Problem:
        """Return the problem over so many `periods`, slow ones, or fast ones if the slow mode is a drift.

        It has `outputs` + 1 times, whose spacing has 40 bits, so that each is a double: steps and formulas meet there
        exactly. ValueError if the chain has no period.
        """
        slow, fast = self.rates
        if not fast:
            raise ValueError(
                "k1 = k2 = 0: two free masses have no period to measure; at least one stiffness above 0 N/m is needed"
            )
        period = (1 if self.c else 2 * pi) / (slow or fast)
        return self._asked_for(_with_40_bits(period * (periods or self.periods) / outputs) * np.arange(outputs + 1.0))

    def _asked_for(self, t: Array) -> Problem:
        facts: dict[str, Any] = {name: getattr(self, name) for name in ("chain", "x_0", "v_0", "F_0", "omega", "c")}
        return Problem(t=t, **facts)


@dataclass(frozen=True, kw_only=True)
class Limits:
    """Limits of a race.

    Attributes
    ----------
    seconds : float
        The longest time of a run in s.
    rounds : int
        The number of rounds of timing.
    visit : float
        The time in s for which quick runs are repeated in each round.
    budget, least : float, int
        A run whose times come to more than `budget` s is timed `least` times only.
    """

    seconds: float = 1.0
    rounds: int = 3
    visit: float = 0.02
    budget: float = 0.3
    least: int = 2


@dataclass(frozen=True, kw_only=True)
class Run:
    """The result of one method at one setting; times are in s.

    Attributes
    ----------
    system, method : str
        The slugs of the system and the method.
    setting : float
        The setting of the method: steps per output, or rtol.
    compiled : bool
        True if the method was compiled for it.
    failure : str or None
        The reason why there are no errors.
    reached : float
        The share of the motion that was computed.
    end : str
        Why the method is not refined further: "floor", "finest", "time limit", "spacing", "no memory left" or
        "cancelled"; "" where it is.
    evaluations, jacobians, factorisations, solves, steps : int
        The counts of `Watch`.
    rounds : int
        The number of rounds in which it was timed.
    time, time_low, time_high : float or None
        The median, the shortest and the longest of the times.
    again : float or None
        The time when the whole benchmark was run once more.
    error, final_error : float or None
        The largest error, and that at the last output alone, over the largest displacement.
    energy_error : float or None
        The largest error of the energy, over the largest energy.
    mode_errors : tuple of float
        The parts of the error in the slow and the fast mode.
    stiff_share : float
        The share of LSODA's steps by formulas for stiff equations.
    error_growth, energy_growth : tuple of float
        The largest errors so far, at MARKS.
    """

    system: str
    method: str
    setting: float
    compiled: bool = False
    failure: str | None = None
    reached: float = 1.0
    end: str = ""
    evaluations: int = 0
    jacobians: int = 0
    factorisations: int = 0
    solves: int = 0
    steps: int = 0
    rounds: int = 0
    time: float | None = None
    time_low: float | None = None
    time_high: float | None = None
    again: float | None = None
    error: float | None = None
    energy_error: float | None = None
    final_error: float | None = None
    mode_errors: tuple[float, ...] = ()
    stiff_share: float = 0.0
    error_growth: tuple[float, ...] = ()
    energy_growth: tuple[float, ...] = ()

    @property
    def name(self) -> str:
        """The name of the method."""
        return METHODS[self.method].name

    @property
    def family(self) -> str:
        """The family of the method."""
        return METHODS[self.method].family

    @property
    def repeats(self) -> bool | None:
        """True if its time repeats within 20 %; None if it was measured only once."""
        if self.rounds < 2 or not self.time_low or self.time_high is None:
            return None
        return self.time_high <= REPEATS * self.time_low

    def to_dict(self) -> dict[str, Any]:
        """Return the run for JSON: numbers, strings, lists and None."""
        return asdict(self)


COUNTS = ("evaluations", "jacobians", "factorisations", "solves", "steps")
"""The counts of a run, which no machine changes."""


def entered(system: System, methods: Sequence[str] = tuple(METHODS)) -> tuple[str, ...]:
    """Return those of the `methods` that are made for the `system`."""
    return tuple(slug for slug in methods if METHODS[slug].friction or not system.c)


def _with_40_bits(x: float) -> float:
    mantissa, exponent = frexp(x)
    return ldexp(round(mantissa * 2**40), exponent - 40)


def _system(slug: str, name: str, masses_and_springs: tuple[float, ...], **more: Any) -> System:
    m1, m2, k1, k2 = masses_and_springs
    return System(slug=slug, name=name, chain=TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2), **more)


_SLOW_MODE = float(TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=1e10).modes().ratio[0])

SYSTEMS: Mapping[str, System] = MappingProxyType(
    {
        system.slug: system
        for system in (
            _system("benign", "Benign", (1.0, 1.5, 2.0, 3.0), x_0=(1.0, -0.5), v_0=(0.2, 0.3)),
            _system("beats", "Beats", (1.0, 1e-3, 0.999, 1e-3), x_0=(1.0, 0.0)),
            _system("wide", "Wide apart, 1e6", (1.0, 1.0, 1.0, 1e6), x_0=(1.0, 0.0), periods=50.309),
            _system("wider", "Wide apart, 1e10", (1.0, 1.0, 1.0, 1e10), x_0=(1.0, _SLOW_MODE)),
            _system("light", "Light mass 2", (1.0, 1e-6, 1.0, 1.0), x_0=(1.0, 2.0), periods=50.618),
            _system(
                "dashpot", "Stiff: a dashpot", (1.0, 1.0, 1e6, 0.0), x_0=(1.0, 0.0), c=1e6 + 1.0, F_0=1e6, omega=1.0
            ),
            _system("near", "Near resonance", (2.0, 1.0, 4.0, 2.0), F_0=1.0, omega=1.0 + 1e-8),
            _system("resonance", "At resonance", (2.0, 1.0, 4.0, 2.0), F_0=1.0, omega=1.0),
        )
    }
)
"""Wide apart: natural frequencies 2e3 and 2e5 to one. With 1e6 both modes swing, by equal parts, and none may be
stepped over: that is highly oscillatory, as is Light mass 2. With 1e10 only the slow one swings: that is stiff, as is
the dashpot, by physics.integrators.stiffness. Over 50 periods the outputs of Wide apart, 1e6 and of Light mass 2 would
all be near one phase of the fast mode, where 0.16 and 0.31 of an error of its phase are seen; so these two last a
little longer. The dashpot's rates are 1 and 1e6 in a second; it starts at rest, off
the motion that is left when the fast part is gone."""
