"""The queue of measurements and its worker process."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import psutil
import pytest

from components.scenes.accuracy.measuring import WAITING, Job, Measuring
from physics.integrators.accuracy import SYSTEMS
from tests.serving.server import Server, serving
from tests.serving.visitor import Visitor

BENIGN = SYSTEMS["benign"]
pytestmark = pytest.mark.timeout(600)
TWO = ("closed", "verlet")


def wait(until: Callable[[], object], seconds: float = 400.0) -> None:
    end = time.monotonic() + seconds
    while not until():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.02)


def nothing() -> None:
    """A listener that does not listen."""


def visitors(count: int) -> list[Callable[[], None]]:
    """Listeners that differ."""
    return [partial(print, end="") for _ in range(count)]


@pytest.fixture
def two(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two methods are measured, not eight, so that the run also ends on a busy machine."""
    monkeypatch.setattr("components.scenes.accuracy.measuring.LIVE", TWO)


@pytest.fixture
def full() -> Iterator[tuple[Measuring, list[Job], list[Callable[[], None]]]]:
    """A queue with no room left, its jobs (the first one runs) and who waits for each."""
    queue, people = Measuring(budget=60.0), visitors(WAITING + 1)
    jobs = [queue.ask(replace(BENIGN, slug=f"own{n}"), 30.0, one) for n, one in enumerate(people)]
    yield queue, jobs, people
    for job, one in reversed(list(zip(jobs, people, strict=True))):
        queue.leave(job, one)
    wait(lambda: jobs[0].state == "done")


Full = tuple[Measuring, list[Job], list[Callable[[], None]]]


def test_a_measurement_comes_run_by_run_and_the_latest_are_remembered(
    two: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("components.scenes.accuracy.measuring.KEPT", 1)
    queue, seen = Measuring(budget=60.0), list[int]()
    job: Job | None = None

    def heard() -> None:
        if job:
            seen.append(len(job.runs))

    job = queue.ask(BENIGN, 0.02, heard)
    assert job.methods == TWO
    wait(lambda: job.state == "done")
    assert seen == sorted(seen) and len(set(seen)) > 5
    assert {run.method for run in job.runs} == set(TWO)
    closed = next(run for run in job.runs if run.method == "closed")
    assert closed.error is not None and closed.error < 1e-15 and closed.rounds == 3
    assert any(run.failure and "time limit" in run.failure for run in job.runs)
    again = queue.ask(BENIGN, 0.02, nothing)
    assert again is job
    later = queue.ask(replace(BENIGN, slug="later"), 0.02, nothing)
    wait(lambda: later.state == "done")
    assert [queue.remembered(one.system, 0.02) for one in (job, later)] == [None, later]


def test_a_full_queue_stays_as_it_is_and_a_network_has_one_measurement_waiting(full: Full) -> None:
    queue, jobs, people = full
    late, ours, other, again = visitors(4)
    for one in (late, people[0]):
        with pytest.raises(ValueError, match="8 measurements wait already"):
            queue.ask(SYSTEMS["wide"], 30.0, one)
    assert [queue.place(job) for job in jobs] == list(range(WAITING + 1))
    assert queue.ask(jobs[5].system, 30.0, late) is jobs[5]
    queue.leave(jobs[5], late)
    gone, jobs[3] = jobs[3], queue.ask(SYSTEMS["wide"], 30.0, people[3])  # a visitor who waits changes the system
    assert queue.place(gone) == 0 and gone.listeners == [] and queue.place(jobs[3]) == WAITING
    for job, one in list(zip(jobs, people, strict=True))[4:]:
        queue.leave(job, one)
    systems = [replace(BENIGN, slug=name) for name in ("a", "b", "c")]
    job = queue.ask(systems[0], 30.0, ours, "192.0.2.0/24")
    with pytest.raises(ValueError, match="from this network waits already"):
        queue.ask(systems[1], 30.0, other, "192.0.2.0/24")
    assert queue.ask(systems[0], 30.0, other, "192.0.2.0/24") is job  # the same one is shared
    theirs = queue.ask(systems[1], 30.0, again, "198.51.100.0/24")
    queue.leave(job, other)
    changed = queue.ask(systems[2], 30.0, ours, "192.0.2.0/24")  # in place of the visitor's own
    for each, one in ((changed, ours), (theirs, again)):
        queue.leave(each, one)


@pytest.mark.parametrize(
    ("script", "budget", "reason"),
    [
        ("exec sleep 600", 0.1, "stopped after 0.1 s"),
        ("""read order\nprintf '{"method": "verl'""", 60.0, "the measuring process stopped"),
    ],
    ids=["does not end", "dies while it writes"],
)
def test_a_faulty_worker_does_not_stop_the_queue(
    script: str, budget: float, reason: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    worker = tmp_path / "worker"
    worker.write_text(f"#!/bin/sh\n{script}\n")
    worker.chmod(0o755)
    monkeypatch.setattr("components.processes.sys.executable", str(worker))
    monkeypatch.setattr("components.scenes.accuracy.measuring.GRACE", 0.2)
    queue = Measuring(budget)
    jobs = [queue.ask(SYSTEMS[slug], 1.0, one) for slug, one in zip(("benign", "beats"), visitors(2), strict=True)]
    wait(lambda: all(job.state == "done" for job in jobs))
    assert [job.reason for job in jobs] == [reason] * 2


def test_a_method_can_be_skipped_unless_others_wait_for_it(two: None) -> None:
    queue, (other,) = Measuring(budget=300.0), visitors(1)
    job: Job | None = None

    def heard() -> None:
        if job and job.method == "verlet" and len(job.listeners) == 1:
            queue.skip(job)

    job = queue.ask(replace(BENIGN, slug="skipped"), 20.0, heard)
    queue.ask(job.system, 20.0, other)
    with pytest.raises(ValueError, match="Others wait"):
        queue.skip(job)
    queue.leave(job, other)
    wait(lambda: job.state == "done")
    assert (job.reason, job.skipped) == ("", {"verlet"})
    ends = {run.end for run in job.runs if run.method == "verlet"}
    assert ends <= {"", "cancelled"}, "it has not come to an end of its own, such as the time limit"
    assert queue.remembered(job.system, job.seconds) is None, "a measurement without a method is not kept for others"


def test_nothing_to_measure() -> None:
    queue = Measuring(budget=30.0)
    rest = replace(BENIGN, x_0=(0.0, 0.0), v_0=(0.0, 0.0))
    job = queue.ask(rest, 1.0, nothing)
    wait(lambda: job.state == "done")
    assert job.reason and not job.runs
    with pytest.raises(ValueError, match="no period"):
        queue.ask(replace(BENIGN, chain=replace(BENIGN.chain, k1=0.0, k2=0.0)), 1.0, nothing)


@pytest.mark.nightly
def test_a_visitor_who_leaves_ends_the_measurement(tmp_path: Path) -> None:
    soon = ("--unused-seconds", "0.05")
    with serving(tmp_path / "log", options=soon) as server:
        asyncio.run(_measure_and_leave(server))
        wait(lambda: not workers(server))
        assert "on_session_destroyed" not in server.log.read_text()


def workers(server: Server) -> list[psutil.Process]:
    return psutil.Process(server.process.pid).children()


async def _measure_and_leave(server: Server) -> None:
    visitor = await Visitor.arrive(server.url, "scene=accuracy&limit=60")
    await visitor.send({"type": "run", "order": "start"})
    wait(lambda: workers(server))
    await visitor.depart()
