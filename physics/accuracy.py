"""Error against run time: every method on the same motions, measured against arbitrary precision.

A System is a chain with a start and perhaps a drive. Each method at each setting is asked for the motion at
the same 1000 times over 50 slow periods, timed a few times, and compared with a reference in mpmath:

    for run in measure(SYSTEMS["stiff"]): ...

yields a Run as soon as it is there. A run that fails is a Run with its reason. Errors are the worst over both
masses, in units of the largest displacement; energy errors in units of the largest energy. Conserved energy
does not certify phase: implicit midpoint keeps every digit of the energy while its motion is all wrong.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from math import frexp, inf, ldexp, pi
from statistics import median
from time import perf_counter
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from physics.coupled import TwoMassChain
from physics.exact import Array
from physics.integrators import Problem, StoppedError, Trajectory, Watch
from physics.reference import Reference, reference
from physics.solvers import METHODS

PERIODS = 50
OUTPUTS_A_PERIOD = 20
EXPLODED = 1e3  # times the largest true displacement: a step that gets there is unstable
SMALLEST_ENERGY = 1e-290  # J: below, doubles run out of digits
TIME_LIMIT = "time limit"
GLANCE = 256  # evaluations between two looks at the clock

Cancelled = Callable[[str], bool]


@dataclass(frozen=True, kw_only=True)
class System:
    """A motion to compute: the chain, its start, and F_0 sin(omega t) on mass 1."""

    slug: str
    name: str
    chain: TwoMassChain
    x_0: tuple[float, float] = (0.0, 0.0)
    v_0: tuple[float, float] = (0.0, 0.0)
    F_0: float = 0.0
    omega: float = 0.0

    def problem(self) -> Problem:
        """50 slow periods (fast ones where the slow mode is a drift), 20 output times in each.

        The spacing has 40 bits, so that every output time is a double: steps and formulas meet there exactly.
        """
        slow, fast = self.chain.modes().omega
        if not fast:
            raise ValueError("k1 = k2 = 0: two free masses have no period to measure")
        spacing = _with_40_bits(2 * pi / float(slow or fast) / OUTPUTS_A_PERIOD)
        t = spacing * np.arange(PERIODS * OUTPUTS_A_PERIOD + 1.0)
        return Problem(chain=self.chain, x_0=self.x_0, v_0=self.v_0, t=t, F_0=self.F_0, omega=self.omega)


class Case(NamedTuple):
    """One run to make."""

    method: str
    setting: float


@dataclass(frozen=True, kw_only=True)
class Limits:
    """Seconds a run may take; a quick one is repeated at most `repeats` times, within `budget` seconds."""

    seconds: float = 8.0
    repeats: int = 5
    budget: float = 0.5


@dataclass(frozen=True, kw_only=True)
class Run:
    """What one method did at one setting; times in s. Where failure says why, there are no errors."""

    system: str
    method: str
    name: str
    family: str
    setting: float
    failure: str | None = None
    reached: float = 1.0  # share of the motion
    evaluations: int = 0
    steps: int = 0
    time: float | None = None  # median
    time_low: float | None = None
    time_high: float | None = None
    error: float | None = None
    energy_error: float | None = None
    error_growth: tuple[float, ...] = ()  # worst so far, at the end of each slow period, from 0 on
    energy_growth: tuple[float, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """For JSON: numbers, strings, lists and None."""
        return asdict(self)


def plan(system: System, methods: Sequence[str] = tuple(METHODS)) -> tuple[Case, ...]:
    """The runs that measure() makes, in its order."""
    problem = system.problem()
    return tuple(Case(slug, setting) for slug in methods for setting in METHODS[slug].settings(problem))


def measure(
    system: System,
    cases: Sequence[Case] | None = None,
    limits: Limits | None = None,
    cancelled: Cancelled = lambda method: False,
) -> Iterator[Run]:
    """Runs as they come. cancelled(method) is asked before and within each run: True gives that method up.

    ValueError where there is nothing to compare with: a chain at rest, an energy no double holds.
    """
    import scipy.integrate  # here, so that no run pays for it
    import scipy.linalg  # noqa: F401

    problem = system.problem()
    truth = reference(problem)
    if not (truth.size > 0 and SMALLEST_ENERGY < truth.largest_energy < inf):
        raise ValueError(f"largest displacement {truth.size:g} m, energy {truth.largest_energy:g} J: no scale")
    bench = _Bench(system, replace(problem, size=truth.size), truth, limits or Limits(), cancelled)
    out_of_time: set[str] = set()
    for case in plan(system) if cases is None else cases:
        if cancelled(case.method):
            continue
        if case.method in out_of_time:
            yield bench.row(case, failure="not started: time limit at a coarser setting", reached=0.0)
            continue
        run = bench.measured(case)
        if run.failure and run.failure.startswith(TIME_LIMIT):
            out_of_time.add(case.method)
        yield run


@dataclass(frozen=True)
class _Bench:
    """What all runs on one system share."""

    system: System
    problem: Problem
    truth: Reference
    limits: Limits
    cancelled: Cancelled

    def measured(self, case: Case) -> Run:
        """A timed and judged run, or the row that says why there is none."""
        times: list[float] = []
        while not times or (len(times) < self.limits.repeats and sum(times) < self.limits.budget):
            watch = Watch(bound=EXPLODED * self.truth.size)
            try:
                with np.errstate(all="raise", under="ignore"):
                    time, result = self._timed(case, watch)
                    run = self._judged(case, watch, result)
            except StoppedError as stop:
                reached = stop.reached / float(self.problem.t[-1])
                return self.row(case, watch, failure=str(stop), reached=reached)
            except (ArithmeticError, ValueError, np.linalg.LinAlgError) as fault:
                return self.row(case, watch, failure=f"cannot be computed: {fault}", reached=0.0)
            times.append(time)
        return replace(run, time=median(times), time_low=min(times), time_high=max(times))

    def row(self, case: Case, watch: Watch | None = None, **outcome: Any) -> Run:
        """The bare row of a case."""
        method, watch = METHODS[case.method], watch or Watch()
        return Run(
            system=self.system.slug,
            method=case.method,
            name=method.name,
            family=method.family,
            setting=case.setting,
            evaluations=watch.evaluations,
            steps=watch.steps,
            **outcome,
        )

    def _timed(self, case: Case, watch: Watch) -> tuple[float, Trajectory]:
        fresh = replace(self.problem, chain=replace(self.problem.chain))  # nothing kept from the run before
        start = perf_counter()
        watch.check = self._clock(case.method, watch, start + self.limits.seconds)
        result = METHODS[case.method].run(fresh, case.setting, watch)
        return perf_counter() - start, result

    def _clock(self, method: str, watch: Watch, deadline: float) -> Callable[[float], None]:
        def check(t: float) -> None:
            if watch.evaluations % GLANCE:
                return
            if perf_counter() > deadline:
                raise StoppedError(f"{TIME_LIMIT} {self.limits.seconds:g} s", t)
            if self.cancelled(method):
                raise StoppedError("cancelled", t)

        return check

    def _judged(self, case: Case, watch: Watch, result: Trajectory) -> Run:
        error = self.truth.errors(result.x)
        energy_error = self.truth.energy_errors(self.problem.chain, result)
        if not np.all(np.isfinite(error + energy_error)):
            return self.row(case, watch, failure="not a number", reached=0.0)
        return self.row(
            case,
            watch,
            error=float(np.max(error)),
            energy_error=float(np.max(energy_error)),
            error_growth=_growth(error),
            energy_growth=_growth(energy_error),
        )


def _growth(errors: Array) -> tuple[float, ...]:
    worst = np.maximum.accumulate(errors)[::OUTPUTS_A_PERIOD]
    return tuple(float(value) for value in worst)


def _with_40_bits(x: float) -> float:
    mantissa, exponent = frexp(x)
    return ldexp(round(mantissa * 2**40), exponent - 40)


def _system(slug: str, name: str, masses_and_springs: tuple[float, ...], **start: Any) -> System:
    m1, m2, k1, k2 = masses_and_springs
    return System(slug=slug, name=name, chain=TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2), **start)


_SLOW_MODE = float(TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=1e10).modes().ratio[0])

SYSTEMS: Mapping[str, System] = MappingProxyType(
    {
        system.slug: system
        for system in (
            _system("benign", "Benign", (1.0, 1.5, 2.0, 3.0), x_0=(1.0, -0.5), v_0=(0.2, 0.3)),
            _system("beats", "Beats", (1.0, 1e-3, 0.999, 1e-3), x_0=(1.0, 0.0)),
            _system("stiff", "Stiff 1e6", (1.0, 1.0, 1.0, 1e6), x_0=(1.0, 1.001)),
            _system("stiffer", "Stiff 1e10", (1.0, 1.0, 1.0, 1e10), x_0=(1.0, _SLOW_MODE)),
            _system("light", "Light mass 2", (1.0, 1e-6, 1.0, 1.0), x_0=(1.0, 1.001)),
            _system("near", "Near resonance", (2.0, 1.0, 4.0, 2.0), F_0=1.0, omega=1.0 + 1e-8),
            _system("resonance", "At resonance", (2.0, 1.0, 4.0, 2.0), F_0=1.0, omega=1.0),
        )
    }
)
