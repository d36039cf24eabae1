"""One measurement at a time for all visitors of a server process: a queue, a worker process, a cache of results.

A measurement takes a minute of a processor. It runs in a process of its own at low priority, so that other visitors'
sliders do not feel it; who asks for what is already running shares it, and what was measured before comes at once.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections import OrderedDict
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from threading import RLock, Thread
from typing import Any, Literal

from physics.accuracy import Run, System, plan
from physics.accuracy_worker import encoded

ROOT = Path(__file__).parent.parent
KEPT = 64
"""How many finished measurements are remembered."""
BUDGET = 180.0
"""Seconds that one measurement may take in all."""

Listener = Callable[[], None]


@dataclass(eq=False)
class Job:
    """One measurement; `runs` grows as results come. `reason` says why one ended early, `skipped` what was given up."""

    system: System
    seconds: float
    total: int
    state: Literal["waiting", "running", "done"] = "waiting"
    runs: tuple[Run, ...] = ()
    method: str = ""
    skipped: set[str] = field(default_factory=set)
    reason: str = ""
    listeners: list[Listener] = field(default_factory=list)
    process: subprocess.Popen[str] | None = None


class Measuring:
    """The queue. All methods may be called from any thread; listeners are called from the reader's thread."""

    def __init__(self, budget: float = BUDGET) -> None:
        self.budget = budget
        self._lock = RLock()
        self._waiting: list[Job] = []
        self._active: Job | None = None
        self._done: OrderedDict[tuple[System, float], Job] = OrderedDict()

    def ask(self, system: System, seconds: float, listener: Listener) -> Job:
        """The measurement of a system with so many seconds a run: remembered, shared, or put at the end of the queue.

        ValueError where the system has nothing to measure.
        """
        with self._lock:
            job = self._find(system, seconds)
            if job is None:
                job = Job(system, seconds, len(plan(system)))
                self._waiting.append(job)
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
                job.reason = "cancelled"
                if job.process:
                    job.process.kill()

    def skip(self, job: Job) -> None:
        """Give up the method that is running. ValueError where others wait for its result."""
        with self._lock:
            if len(job.listeners) > 1:
                raise ValueError("Others wait for this measurement too, so that no method is skipped.")
            if job.process and job.process.stdin and job.method and job.method not in job.skipped:
                job.skipped.add(job.method)
                with suppress(OSError):  # it has just come to its end
                    job.process.stdin.write(json.dumps({"skip": job.method}) + "\n")
                    job.process.stdin.flush()

    def place(self, job: Job) -> int:
        """How many measurements come before this one."""
        with self._lock:
            return self._waiting.index(job) + 1 if job in self._waiting else 0

    def _find(self, system: System, seconds: float) -> Job | None:
        if (system, seconds) in self._done:
            self._done.move_to_end((system, seconds))
            return self._done[system, seconds]
        open_jobs = [*self._waiting, *([self._active] if self._active else [])]
        return next(
            (job for job in open_jobs if (job.system, job.seconds) == (system, seconds) and not job.reason), None
        )

    def _next(self) -> None:
        if self._active or not self._waiting:
            return
        self._active = self._waiting.pop(0)
        self._active.state = "running"
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
        command = [sys.executable, "-m", "physics.accuracy_worker"]
        pipes: dict[str, Any] = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True, "cwd": ROOT}
        with subprocess.Popen(command, **pipes) as process:
            assert process.stdin and process.stdout
            order = {"system": encoded(job.system), "seconds": job.seconds, "budget": self.budget}
            process.stdin.write(json.dumps(order) + "\n")
            process.stdin.flush()
            with self._lock:
                job.process = process
                if job.reason:  # everybody has left while it started
                    process.kill()
            for line in process.stdout:
                if not line.endswith("\n"):  # killed while it wrote
                    break
                ended = self._take(job, json.loads(line))
                self._tell(job)
                if ended:
                    return True
        return False

    def _take(self, job: Job, message: dict[str, Any]) -> bool:
        """Note what the worker says; whether it has come to its end."""
        with self._lock:
            match message:
                case {"method": method}:
                    job.method = method
                case {"run": run}:
                    job.runs = (*job.runs, decoded_run(run))
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

    def _tell(self, job: Job) -> None:
        with self._lock:
            listeners = list(job.listeners)
        for listener in listeners:
            listener()


def decoded_run(data: dict[str, Any]) -> Run:
    """A Run from its JSON."""
    facts: dict[str, Any] = {name: tuple(value) if isinstance(value, list) else value for name, value in data.items()}
    return Run(**facts)


@cache
def measuring() -> Measuring:
    """The queue of this server process."""
    return Measuring()
