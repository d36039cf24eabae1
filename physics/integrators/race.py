"""The race: every method on the same motions, refined side by side and timed round after round.

    for run in measure([SYSTEMS["benign"]]): ...

yields a Run when it is complete, and again after each further timing. In the first round all methods on all
systems are refined side by side, coarse to fine, each until its error stops falling, its settings end or it is out of
time. Each further round times every run again, so that a disturbance of the machine affects all equally. Times
are of the processor, not of the clock on the wall, and relative to how long a fixed piece of work took just then.
"""

import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import count
from math import inf
from statistics import median
from time import perf_counter, thread_time
from typing import Any

import numpy as np

from physics.integrators.accuracy import COUNTS, MARKS, PERIODS, Limits, Run, System, entered
from physics.integrators.problem import CancelledError, OverTimeError, Problem, StoppedError, Trajectory, Watch
from physics.integrators.solvers import METHODS, Method
from physics.integrators.stability import stable_count
from physics.precision.exact import Array
from physics.reference.driven_chain import Reference, reference
from physics.valid import DOUBLES

EXPLODED = 1e3  # a method counts as unstable if a displacement exceeds the largest exact one by this factor
SMALLEST_ENERGY = 1e-290  # J: below, doubles run out of digits
GLANCE = 64  # steps of SciPy's solvers, or outputs, between two checks of the time limit
STANDS, GAIN, RESOLVED = 2, 2.0, 0.1  # so many rungs without such a gain, the fast mode resolved so well: the floor
FORESEEN, GLIMPSE = 0.7, 0.01  # a run is not tried that would get so far, by a run before it of so many seconds

clock = perf_counter if sys.platform == "win32" else thread_time  # Windows counts a thread's time in 16 ms
Cancelled = Callable[[str], bool]


def measure(
    systems: Sequence[System],
    methods: Sequence[Method] = tuple(METHODS.values()),
    limits: Limits | None = None,
    cancelled: Cancelled = lambda method: False,
) -> Iterator[Run]:
    """Yield runs as they are completed, and again with each round that times them.

    ValueError if there is nothing to compare with: a chain at rest, an energy that no double holds.

    Parameters
    ----------
    systems : sequence of System
        The motions.
    methods : sequence of Method
        The methods.
    limits : Limits or None
        The limits of time.
    cancelled : callable
        Called with the slug of a method before and within each run: True gives that method up.

    Returns
    -------
    iterator of Run
        The runs.
    """
    limits = limits or Limits()
    pace = median(yardstick() for _ in range(5))
    benches = [bench_of(system, limits, cancelled, pace) for system in systems]
    ladders = [Ladder(bench, method) for method in methods for bench in benches if entered(bench.system, [method.slug])]
    while any(not ladder.end for ladder in ladders):
        for ladder in ladders:
            if not ladder.end and (run := ladder.climb()):
                yield run
    for _ in range(limits.rounds - 1):
        for rung in range(max(len(ladder.runs) for ladder in ladders)):
            for ladder in ladders:
                if run := ladder.again(rung):
                    yield run


def yardstick() -> float:
    """Return the seconds that a fixed piece of work takes, half of it plain Python, half NumPy on small arrays."""
    start, x, matrix, vector = clock(), 0.1, np.full((4, 4), 0.2), np.ones(4)
    for _ in range(10_000):
        x = 3.7 * x * (1 - x)
    for _ in range(1_000):
        vector = matrix.dot(vector)
    return clock() - start


@dataclass(frozen=True)
class Bench:
    """The setting that all runs on one system share.

    Attributes
    ----------
    system, problem : System, Problem
        The motion, and its times.
    truth : Reference
        The true motion.
    limits : Limits
        The limits of time.
    cancelled : callable
        True for the slug of a method that is given up.
    pace : float
        The time in s that the yardstick took at first.
    """

    system: System
    problem: Problem
    truth: Reference
    limits: Limits
    cancelled: Cancelled
    pace: float

    def visit(self, method: Method, setting: float) -> Run:
        """Return a timed and judged run of a `method` at a `setting`, or the row that says why there is none.

        A quick run is repeated for a while.
        """
        times, runs, pace = list[float](), list[Run](), yardstick()
        while not times or sum(times) < self.limits.visit:
            watch = Watch(bound=EXPLODED * self.truth.size)
            try:
                with np.errstate(all="raise", under="ignore"):
                    time, result = self._timed(method, setting, watch)
                    runs = runs or [self._judged(method, setting, watch, result)]
            except StoppedError as stop:
                reached = stop.reached / float(self.problem.t[-1])
                return self._row(method, setting, watch, str(stop), stop.end, reached)
            except (ArithmeticError, ValueError, np.linalg.LinAlgError) as fault:
                return self._row(method, setting, watch, f"cannot be computed: {fault}")
            except MemoryError:
                return self._row(method, setting, watch, "no memory left", "no memory left")
            times.append(time)
        time = median(times) * 2 * self.pace / (pace + yardstick())
        return runs[0] if runs[0].failure else replace(runs[0], time=time, time_low=time, time_high=time, rounds=1)

    def late(self, method: Method, setting: float, share: float) -> Run:
        """Return the row of a run that is too slow.

        Parameters
        ----------
        method : Method
            The method.
        setting : float
            Its setting.
        share : float
            The share of the motion that it would reach in time.

        Returns
        -------
        Run
            A run with the reason.
        """
        return self._row(method, setting, Watch(), f"time limit {self.limits.seconds:g} s", OverTimeError.end, share)

    def _row(
        self, method: Method, setting: float, watch: Watch, failure: str, end: str = "", reached: float = 0.0
    ) -> Run:
        return Run(
            system=self.system.slug, method=method.slug, setting=setting, compiled=method.compiled, failure=failure,
            end=end, reached=reached, **counts(watch),
        )  # fmt: skip

    def _timed(self, method: Method, setting: float, watch: Watch) -> tuple[float, Trajectory]:
        fresh = replace(self.problem, chain=replace(self.problem.chain))  # nothing kept from the run before
        start = clock()
        watch.check = self._clock(method.slug, start + self.limits.seconds)
        result = method.run(fresh, setting, watch)
        return clock() - start, result

    def _clock(self, method: str, deadline: float) -> Callable[[float], None]:
        calls = count()

        def check(t: float) -> None:
            if next(calls) % GLANCE:
                return
            if clock() > deadline:
                raise OverTimeError(f"time limit {self.limits.seconds:g} s", t)
            if self.cancelled(method):
                raise CancelledError("cancelled", t)

        return check

    def _judged(self, method: Method, setting: float, watch: Watch, result: Trajectory) -> Run:
        error, chain = self.truth.errors(result.x), self.problem.chain
        if self.problem.c:
            error = np.maximum(error, self.truth.velocity_errors(result.v))
        energy_error = self.truth.energy_errors(chain, result)
        if not np.all(np.isfinite(error + energy_error)):
            return self._row(method, setting, watch, "not a number")
        return Run(
            system=self.system.slug,
            method=method.slug,
            setting=setting,
            compiled=method.compiled,
            **counts(watch),
            error=float(np.max(error)),
            energy_error=float(np.max(energy_error)),
            final_error=float(error[-1]),
            mode_errors=self.truth.mode_errors(chain, result.x) if chain.k2 else (),
            stiff_share=watch.stiff_steps / watch.steps if watch.steps else 0.0,
            error_growth=_growth(error),
            energy_growth=_growth(energy_error),
        )


def counts(watch: Watch) -> dict[str, Any]:
    """Return what a run has cost by its `watch`, by the names of Run."""
    return {name: getattr(watch, name) for name in COUNTS}


def bench_of(
    system: System, limits: Limits, cancelled: Cancelled, pace: float, problem: Problem | None = None
) -> Bench:
    """Return the bench of a system.

    Parameters
    ----------
    system : System
        The motion.
    limits : Limits
        The limits of time.
    cancelled : callable
        True for the slug of a method that is given up.
    pace : float
        The time in s that the yardstick took at first.
    problem : Problem or None
        A problem of another length than the system's own.

    Returns
    -------
    Bench
        The bench, with the true motion.

    Raises
    ------
    ValueError
        If there is nothing to compare with: a chain at rest, an energy that no double holds.
    """
    import scipy.integrate  # here, so that no run pays for it
    import scipy.linalg  # noqa: F401

    problem = problem or system.problem()
    truth = reference(problem)
    if not (truth.size > 0 and SMALLEST_ENERGY < truth.largest_energy < inf):
        raise ValueError(
            f"the largest displacement is {truth.size:g} m and the largest energy {truth.largest_energy:g} J: "
            f"errors are compared with both, which must be above 0 m and {SMALLEST_ENERGY:g} J and within {DOUBLES}"
        )
    return Bench(system, replace(problem, size=truth.size), truth, limits, cancelled, pace)


class Ladder:
    """One method on one system, refined rung by rung; `end` says why it is refined no further."""

    def __init__(self, bench: Bench, method: Method) -> None:
        self.bench, self.method, self.end = bench, method, ""
        self.runs: list[Run] = []
        self._settings = method.settings()
        if method.family == "fixed":  # the fewest steps that are stable, too
            self._settings = tuple(sorted({*self._settings, float(stable_count(method.slug, bench.problem))}))
        self._times: list[list[float]] = []

    def climb(self) -> Run | None:
        """Return the run at the next setting; None if the method is given up."""
        if self.bench.cancelled(self.method.slug):
            self.end = "cancelled"
            return None
        setting = self._settings[len(self.runs)]
        run = self.foreseen(setting) or self.bench.visit(self.method, setting)
        self.runs.append(run)
        self._times.append([] if run.time is None else [run.time])
        self.end = self.ending()
        self.runs[-1] = replace(run, end=self.end)
        return self.runs[-1]

    def foreseen(self, setting: float) -> Run | None:
        """Return the row of a run at `setting` that would be far out of time, by the time of the run before it.

        None if the run is to be tried.
        """
        before, limit = self.runs[-1] if self.runs else None, self.bench.limits.seconds
        if before is None or before.time is None or self.method.family != "fixed":
            return None
        share = limit / (before.time * setting / before.setting)
        if share > FORESEEN or before.time < GLIMPSE:
            return None
        return self.bench.late(self.method, setting, share)

    def again(self, rung: int) -> Run | None:
        """Return the run at a `rung` with its time measured once more; None if it is not measured again."""
        if rung >= len(self.runs) or not self._times[rung] or self.bench.cancelled(self.method.slug):
            return None
        if len(self._times[rung]) >= self.bench.limits.least and sum(self._times[rung]) > self.bench.limits.budget:
            return None
        run = self.bench.visit(self.method, self._settings[rung])
        if run.time is None:  # this time it was too slow
            return None
        times = self._times[rung]
        times.append(run.time)
        told: dict[str, Any] = {"time": median(times), "time_low": min(times), "time_high": max(times)}
        self.runs[rung] = replace(self.runs[rung], rounds=len(times), **told)
        return self.runs[rung]

    def ending(self) -> str:
        """Return why the method is refined no further, as `Run.end`; "" if it is."""
        if self.runs[-1].end:
            return self.runs[-1].end
        if len(self.runs) == len(self._settings):
            return "finest"
        return "floor" if self.method.family == "fixed" and self._stands() else ""

    def _stands(self) -> bool:
        """True if the error no longer falls with shorter steps, because only rounding errors remain."""
        errors = [run.error for run in self.runs if run.error is not None]
        if len(errors) <= STANDS or min(errors[-STANDS:]) * GAIN < min(errors[:-STANDS]):
            return False
        problem, (_, fast) = self.bench.problem, self.bench.problem.rates
        h = problem.spacing / self.runs[-STANDS].setting
        return (h * fast) ** self.method.order * fast * float(problem.t[-1]) < RESOLVED


def _growth(errors: Array) -> tuple[float, ...]:
    worst = np.maximum.accumulate(errors)
    return tuple(float(worst[mark * (worst.size - 1) // PERIODS]) for mark in MARKS)
