"""One measurement at a time for all visitors of a server process: a queue, a worker process, a cache of results.

A measurement takes up to a minute of a processor. It runs in a process of its own, with low priority and little
memory, so that other visitors' sliders do not feel it; who asks for what is already running shares it, and what was
measured before comes at once. A visitor has one measurement at a time, and few may wait.
"""

from __future__ import annotations

import json
import subprocess
from collections import OrderedDict
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from functools import cache
from threading import RLock, Thread, Timer
from time import monotonic
from typing import Any, Literal

from components.processes import started
from physics.integrators.accuracy import Run, System, entered
from physics.integrators.accuracy_worker import encoded_system

KEPT = 64
"""The number of finished measurements that are remembered."""
LIVE = (
    "closed", "slides", "eigh", "expm", "verlet", "newmark", "rk4", "gauss4", "radau5", "yoshida6",
    "nystrom6", "gautschi", "dop853", "radau", "bdf", "lsoda", "fortran", "adams",
)  # fmt: skip
"""The methods that are measured while a visitor looks on, the best of each kind: few enough for a minute."""
WAITING = 8
"""The number of measurements that may wait for their turn."""
BUDGET = 60.0
"""Seconds that one measurement may take in all."""
GRACE = 5.0
"""Seconds after which a worker that does not keep to its budget is ended."""

Listener = Callable[[], None]
Json = dict[str, Any]
"""An object that the worker, a process of our own, writes on a line."""


@dataclass(eq=False)
class Job:
    """One measurement; `found` grows as results come, by method and setting.

    `reason` says why one ended early, `skipped` what was given up.
    """

    system: System
    seconds: float
    methods: tuple[str, ...]
    state: Literal["waiting", "running", "done"] = "waiting"
    found: dict[tuple[str, float], Run] = field(default_factory=dict)
    began: float = 0.0
    method: str = ""
    skipped: set[str] = field(default_factory=set)
    reason: str = ""
    listeners: list[Listener] = field(default_factory=list)
    process: subprocess.Popen[bytes] | None = None
    network: str = ""

    @property
    def runs(self) -> tuple[Run, ...]:
        """Each run as it was last timed."""
        return tuple(self.found.values())

    @property
    def spent(self) -> float:
        """Seconds since it began."""
        return monotonic() - self.began if self.state == "running" else 0.0


class Measuring:
    """The queue. All methods may be called from any thread; listeners are called from the reader's thread."""

    def __init__(self, budget: float = BUDGET) -> None:
        self.budget = budget
        self._lock = RLock()
        self._waiting: list[Job] = []
        self._active: Job | None = None
        self._done: OrderedDict[tuple[System, float], Job] = OrderedDict()

    def ask(self, system: System, seconds: float, listener: Listener, network: str = "") -> Job:
        """The measurement of a system with so many seconds a run: remembered, shared, or put at the end of the queue.

        It takes the place of what the listener has waited for so far. ValueError, and all as it was, where the system
        has nothing to measure, where too many wait already, or another from the same network.
        """
        with self._lock:
            job, before = self._find(system, seconds), self._of(listener)
            if job is None:
                system.problem()
                job = Job(system, seconds, entered(system, LIVE), network=network)
                self._line_up(job, before if before and before.listeners == [listener] else None)
            if before and before is not job:
                self.leave(before, listener)
            if job.state != "done" and job is not before:
                job.listeners.append(listener)
            self._next()
            return job

    def remembered(self, system: System, seconds: float) -> Job | None:
        """A finished measurement of this system."""
        with self._lock:
            return self._done.get((system, seconds))

    def leave(self, job: Job, listener: Listener) -> None:
        """Stop listening; a measurement that nobody waits for any more is stopped."""
        with self._lock:
            if listener in job.listeners:
                job.listeners.remove(listener)
            if job.listeners or job.state == "done":
                return
            if job in self._waiting:
                self._waiting.remove(job)
            else:
                self._stop(job, "cancelled")

    def skip(self, job: Job) -> None:
        """Give up the method that is running. ValueError where others wait for its result."""
        with self._lock:
            if len(job.listeners) > 1:
                raise ValueError("Others wait for this measurement too, so that no method is skipped.")
            if job.process and job.process.stdin and job.method and job.method not in job.skipped:
                job.skipped.add(job.method)
                with suppress(OSError):  # it has just come to its end
                    job.process.stdin.write(json.dumps({"skip": job.method}).encode() + b"\n")
                    job.process.stdin.flush()

    def __len__(self) -> int:
        """The number of measurements that run or wait."""
        with self._lock:
            return len(self._waiting) + (self._active is not None)

    def place(self, job: Job) -> int:
        """The number of measurements that come before this one."""
        with self._lock:
            return self._waiting.index(job) + 1 if job in self._waiting else 0

    def _find(self, system: System, seconds: float) -> Job | None:
        if (system, seconds) in self._done:
            self._done.move_to_end((system, seconds))
            return self._done[system, seconds]
        return next(
            (job for job in self._open() if (job.system, job.seconds) == (system, seconds) and not job.reason), None
        )

    def _of(self, listener: Listener) -> Job | None:
        """The measurement that has not ended and that this one waits for."""
        return next((job for job in self._open() if listener in job.listeners), None)

    def _open(self) -> list[Job]:
        return [*self._waiting, *([self._active] if self._active else [])]

    def _line_up(self, job: Job, going: Job | None) -> None:
        """Put a measurement at the end of the queue, which the one that is `going` will leave."""
        others = [each for each in self._waiting if each is not going]
        if job.network and job.network in [each.network for each in others]:
            raise ValueError("A measurement from this network waits already: press Run again when it has begun.")
        if len(others) >= WAITING:
            raise ValueError(f"{WAITING} measurements wait already: press Run again in a few minutes.")
        self._waiting.append(job)

    def _next(self) -> None:
        if self._active or not self._waiting:
            return
        self._active = self._waiting.pop(0)
        self._active.state, self._active.began = "running", monotonic()
        Thread(target=self._run, args=(self._active,), daemon=True).start()

    def _run(self, job: Job) -> None:
        """Measure, and whatever comes of it let the next one begin."""
        ended = False
        try:
            ended = self._measure(job)
        finally:
            self._finish(job, ended)

    def _measure(self, job: Job) -> bool:
        """Read a worker until nothing more comes; whether it has come to its end."""
        with started("physics.integrators.accuracy_worker") as process, self._ending(job):
            assert process.stdin and process.stdout
            order = {
                "system": encoded_system(job.system),
                "seconds": job.seconds,
                "budget": self.budget,
                "methods": job.methods,
            }
            process.stdin.write(json.dumps(order).encode() + b"\n")
            process.stdin.flush()
            with self._lock:
                job.process = process
                if job.reason:  # everybody has left while it started
                    process.kill()
            for line in process.stdout:
                if not line.endswith(b"\n"):  # killed while it wrote
                    break
                ended = self._take(job, json.loads(line))
                self._tell(job)
                if ended:
                    return True
        return False

    @contextmanager
    def _ending(self, job: Job) -> Iterator[None]:
        """End a worker that does not end by itself."""
        timer = Timer(self.budget + GRACE, self._stop, (job, f"stopped after {self.budget:g} s"))
        timer.daemon = True
        timer.start()
        try:
            yield
        finally:
            timer.cancel()

    def _stop(self, job: Job, reason: str) -> None:
        with self._lock:
            job.reason = job.reason or reason
            if job.process:
                job.process.kill()

    def _take(self, job: Job, message: Json) -> bool:
        """Note what the worker says; whether it has come to its end."""
        with self._lock:
            match message:
                case {"method": method}:
                    job.method = method
                case {"run": run}:
                    told = decoded_run(run)
                    job.found[told.method, told.setting] = told
                case {"end": reason}:
                    job.reason = job.reason or reason or ""
                    return True
        return False

    def _finish(self, job: Job, ended: bool) -> None:
        with self._lock:
            job.state, job.method, job.process = "done", "", None
            job.reason = job.reason or ("" if ended else "the measuring process stopped")
            if ended and not job.reason and not job.skipped:
                self._done[job.system, job.seconds] = job
                while len(self._done) > KEPT:
                    self._done.popitem(last=False)
            self._active = None
            self._next()
        self._tell(job)
        job.listeners.clear()

    def _tell(self, job: Job) -> None:
        with self._lock:
            listeners = list(job.listeners)
        for listener in listeners:
            listener()


def decoded_run(data: Json) -> Run:
    """A Run from its JSON."""
    facts: Json = {name: tuple(value) if isinstance(value, list) else value for name, value in data.items()}
    return Run(**facts)


@cache
def queue() -> Measuring:
    """The queue of this server process."""
    return Measuring()
