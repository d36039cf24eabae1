"""The measurement of one visitor: the system shown, its job in the queue, and the runs that are known of it."""

from __future__ import annotations

from typing import Any, Protocol

from msgspec.structs import replace

from components.page.picture import Progress
from components.parameters import Values
from components.running import Running
from components.scenes.accuracy.data import Known, Series
from components.scenes.accuracy.measuring import LIVE, Job, queue
from components.scenes.accuracy.recorded import recorded, records
from physics.accuracy import Run, System, entered
from physics.solvers import METHODS

SCALE = "benign"
"""The system whose records stand behind a motion that has none."""
Measured = tuple[System, float, tuple[Run, ...], str]
"""A system, its limit in s, the runs so far, and how the job stands."""


class Measurable(Protocol):
    """What is measured: a scene with a system, a limit for each run in s, and what its page has been told."""

    limit: Any
    measured: Any

    def shown_system(self) -> System: ...

    def set(self, values: Values) -> None: ...


class Measurement(Running):
    """A visitor's place in the queue of this server process."""

    def __init__(self, scene: Measurable) -> None:
        super().__init__(scene)
        self._scene = scene
        self._job: Job | None = None

    @classmethod
    def pending(cls) -> int:
        return len(queue())

    @property
    def progress(self) -> Progress:
        job = self._job
        if job is None or (job.system, job.seconds) != self._wanted():
            return self._idle()
        if job.state == "done":
            reason = job.reason and f"{job.reason[0].upper()}{job.reason[1:]}."
            return replace(self._idle(), text=reason)
        told = Progress(state=job.state, done=int(job.spent), total=int(queue().budget), unit="s", text="")
        if job.state == "waiting":
            before = queue().place(job)
            return replace(told, text=f"{before} measurement{'s' if before > 1 else ''} before yours.")
        running = f"{METHODS[job.method].mark} is running" if job.method else "It begins"
        return replace(told, text=f"{running}, round {max((run.rounds for run in job.runs), default=1)}.")

    def obey(self, order: str) -> None:
        if order == "start":
            self._job = queue().ask(*self._wanted(), self._heard, self.network())
            self._heard()
        elif order == "skip" and self._job:
            queue().skip(self._job)
        elif order == "cancel":
            self.close()

    def close(self) -> None:
        if self._job:
            queue().leave(self._job, self._heard)
            self._job = None

    def known(self) -> Known:
        """What is known of the system: measured for this visitor or for another one, and recorded."""
        system, seconds = self._wanted()
        here, before = Series(self._here(system, seconds)), records(system.slug)
        return Known(here, before.runs) if before else Known(here, Series(), scale=recorded(SCALE).runs)

    def _here(self, system: System, seconds: float) -> tuple[Run, ...]:
        if self._has_own():
            return tuple(self._scene.measured[2])
        remembered = queue().remembered(system, seconds)
        return remembered.runs if remembered else ()

    def _idle(self) -> Progress:
        """What is shown while nothing runs: how many methods have been measured here."""
        system, seconds = self._wanted()
        count = len({run.method for run in self._here(system, seconds)})
        text = "" if count else f"Run measures {len(entered(system, LIVE))} methods here."
        return Progress(state="idle", done=count, total=count, unit="methods measured here", text=text)

    def _wanted(self) -> tuple[System, float]:
        return self._scene.shown_system(), self._scene.limit

    def _has_own(self) -> bool:
        """Whether this visitor has results of the system, all or some."""
        measured = self._scene.measured
        return bool(measured) and measured[:2] == self._wanted()

    def _heard(self) -> None:
        self.later(self._look)

    def _look(self) -> None:
        """Show what has come; a new tuple each time, so that the picture is made anew."""
        job = self._job
        if job:
            measured: Measured = (job.system, job.seconds, job.runs, job.state)
            self._scene.set({"measured": measured})
