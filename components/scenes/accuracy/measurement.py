"""Measurements for one visitor: the job in the queue, and the runs that are known of a system."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from msgspec.structs import replace

from components.language.picture import Progress
from components.quantities.parameters import Values
from components.scene.running import Running
from components.scenes.accuracy.data import Known, Series
from components.scenes.accuracy.measuring import LIVE, Job, queue
from components.scenes.accuracy.recorded import recorded, records
from physics.integrators.accuracy import Run, System, entered
from physics.integrators.solvers import METHODS

SCALE = "benign"
"""The system whose records stand behind a motion that has none."""
Measured = tuple[System, float, tuple[Run, ...], str]
"""A system, its limit in s, the runs so far, and how the job stands."""


MOST_FOUND = 16
"""Measurements that a page remembers, whole or in part: what it goes back to is there again."""


class Measurable(Protocol):
    """A scene with a system, a time limit for each run in s, and the results that its page has already received."""

    limit: Any
    measured: Any

    def shown_system(self) -> System: ...


def known(scene: Measurable) -> Known:
    """The runs of a scene's system: measured here, and recorded."""
    system = scene.shown_system()
    here, before = Series(_here(scene)), records(system.slug)
    if before is None:
        return Known(here, Series(), scale=recorded(SCALE).runs)
    return Known(here, before.runs, compiled=before.compiled)


def _here(scene: Measurable) -> tuple[Run, ...]:
    measured: Measured | None = scene.measured
    return measured[2] if measured and measured[:2] == _wanted(scene) else ()


def _wanted(scene: Measurable) -> tuple[System, float]:
    return scene.shown_system(), scene.limit


class Measurement(Running):
    """A visitor's place in the queue of this server process."""

    def __init__(self, network: Callable[[], str] = lambda: "") -> None:
        super().__init__(network)
        self._job: Job | None = None
        self._found: dict[tuple[System, float], Measured] = {}

    @classmethod
    def pending(cls) -> int:
        return len(queue())

    def progress(self, scene: Measurable) -> Progress:
        job = self._job
        if job is None or (job.system, job.seconds) != _wanted(scene):
            return _idle(scene)
        if job.state == "done":
            reason = job.reason and f"{job.reason[0].upper()}{job.reason[1:]}."
            return replace(_idle(scene), text=reason)
        told = Progress(state=job.state, done=int(job.spent), total=int(queue().budget), unit="s", text="")
        if job.state == "waiting":
            before = queue().place(job)
            return replace(told, text=f"{before} measurement{'s' if before > 1 else ''} before yours.")
        running = f"{METHODS[job.method].mark} is running" if job.method else "It begins"
        return replace(told, text=f"{running}, round {max((run.rounds for run in job.runs), default=1)}.")

    def obey(self, order: str, scene: Measurable) -> None:
        if order == "start":
            self._job = queue().ask(*_wanted(scene), self._heard, self.network())
        elif order == "skip" and self._job:
            queue().skip(self._job)
        elif order == "cancel":
            self._keep()
            self.close()

    def close(self) -> None:
        if self._job:
            queue().leave(self._job, self._heard)
            self._job = None

    def news(self, scene: Measurable) -> Values:
        """Found for this visitor, or else for another one."""
        self._keep()
        wanted = _wanted(scene)
        found = self._found.get(wanted)
        if found is None and (remembered := queue().remembered(*wanted)):
            found = (*wanted, remembered.runs, remembered.state)
        return {"measured": found or scene.measured}

    def _keep(self) -> None:
        """Keep the runs that have come, the newest last."""
        if job := self._job:
            self._found.pop((job.system, job.seconds), None)
            self._found[job.system, job.seconds] = (job.system, job.seconds, job.runs, job.state)
            if len(self._found) > MOST_FOUND:
                del self._found[next(iter(self._found))]

    def _heard(self) -> None:
        self.notify()


def _idle(scene: Measurable) -> Progress:
    """The progress while nothing runs: how many methods have been measured here."""
    count = len({run.method for run in _here(scene)})
    text = "" if count else f"Run measures {len(entered(scene.shown_system(), LIVE))} methods here."
    return Progress(state="idle", done=count, total=count, unit="methods measured here", text=text)
