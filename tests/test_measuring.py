"""The queue of measurements and its worker process."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import psutil
import pytest

from components.measuring import Job, Measuring
from physics.accuracy import SYSTEMS, plan
from physics.accuracy_worker import decoded, encoded
from tests.bench.visitor import Visitor
from tests.serving import FLAGS, Server, serving

BENIGN = SYSTEMS["benign"]


def wait(until: Callable[[], object], seconds: float = 60.0) -> None:
    end = time.monotonic() + seconds
    while not until():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.02)


def nothing() -> None:
    """A listener that does not listen."""


def test_a_system_survives_json() -> None:
    for system in SYSTEMS.values():
        assert decoded(encoded(system)) == system


def test_a_measurement_comes_run_by_run_and_is_remembered() -> None:
    queue, seen = Measuring(budget=60.0), list[int]()
    job: Job | None = None

    def heard() -> None:
        if job:
            seen.append(len(job.runs))

    job = queue.ask(BENIGN, 0.1, heard)
    assert job.total == len(plan(BENIGN))
    wait(lambda: job.state == "done")
    assert len(job.runs) == job.total
    assert seen == sorted(seen) and len(set(seen)) > 5
    closed = next(run for run in job.runs if run.method == "closed")
    assert closed.error is not None and closed.error < 1e-15
    assert any(run.failure and "time limit" in run.failure for run in job.runs)
    again = queue.ask(BENIGN, 0.1, nothing)
    assert again is job


def test_one_at_a_time_with_the_place_in_the_queue() -> None:
    queue = Measuring(budget=60.0)
    first = queue.ask(BENIGN, 30.0, nothing)
    second = queue.ask(SYSTEMS["beats"], 30.0, heard := (lambda: None))
    shared = queue.ask(SYSTEMS["beats"], 30.0, nothing)
    assert shared is second
    assert (queue.place(first), queue.place(second)) == (0, 1)
    assert (first.state, second.state) == ("running", "waiting")
    queue.leave(second, heard)
    assert queue.place(second) == 1
    queue.leave(second, nothing)
    queue.leave(first, nothing)
    wait(lambda: first.state == "done")
    assert first.reason == "cancelled"
    assert second.state == "waiting" and queue.place(second) == 0
    third = queue.ask(replace(BENIGN, slug="own"), 0.05, nothing)
    wait(lambda: third.state == "done")
    assert len(third.runs) == third.total


def test_a_method_can_be_skipped() -> None:
    queue = Measuring(budget=60.0)
    job = queue.ask(replace(BENIGN, slug="skipped"), 20.0, nothing)
    wait(lambda: job.method == "verlet")
    queue.skip(job)
    wait(lambda: job.method not in ("", "verlet"))
    assert len([run for run in job.runs if run.method == "verlet"]) < 5
    queue.leave(job, nothing)
    wait(lambda: job.state == "done")


def test_nobody_skips_what_others_wait_for() -> None:
    queue = Measuring(budget=60.0)
    job = queue.ask(replace(BENIGN, slug="shared"), 20.0, nothing)
    queue.ask(replace(BENIGN, slug="shared"), 20.0, other := (lambda: None))
    with pytest.raises(ValueError, match="Others wait"):
        queue.skip(job)
    queue.leave(job, nothing)
    queue.leave(job, other)
    wait(lambda: job.state == "done")


def test_what_lacks_a_method_is_not_kept_for_others() -> None:
    queue = Measuring(budget=60.0)
    job: Job | None = None

    def heard() -> None:
        if job and job.method == "verlet":
            queue.skip(job)

    job = queue.ask(replace(BENIGN, slug="lacking"), 0.05, heard)
    wait(lambda: job.state == "done")
    assert (job.reason, job.skipped) == ("", {"verlet"})
    assert queue.remembered(job.system, job.seconds) is None


def test_a_worker_that_dies_while_it_writes_does_not_stop_the_queue(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    worker = tmp_path / "worker"
    worker.write_text("""#!/bin/sh\nread order\nprintf '{"method": "verl'\n""")
    worker.chmod(0o755)
    monkeypatch.setattr("components.measuring.sys.executable", str(worker))
    queue = Measuring()
    jobs = [queue.ask(SYSTEMS[slug], 1.0, nothing) for slug in ("benign", "beats")]
    wait(lambda: all(job.state == "done" for job in jobs))
    assert [job.reason for job in jobs] == ["the measuring process stopped"] * 2


def test_the_limit_for_a_visitor() -> None:
    queue = Measuring(budget=1.0)
    job = queue.ask(BENIGN, 20.0, nothing)
    wait(lambda: job.state == "done")
    assert "limit for one visitor" in job.reason
    assert queue.remembered(BENIGN, 20.0) is None


def test_nothing_to_measure() -> None:
    queue = Measuring(budget=30.0)
    rest = replace(BENIGN, x_0=(0.0, 0.0), v_0=(0.0, 0.0))
    job = queue.ask(rest, 1.0, nothing)
    wait(lambda: job.state == "done")
    assert job.reason and not job.runs
    with pytest.raises(ValueError, match="no period"):
        queue.ask(replace(BENIGN, chain=replace(BENIGN.chain, k1=0.0, k2=0.0)), 1.0, nothing)


def test_a_visitor_who_leaves_ends_the_measurement(tmp_path: Path) -> None:
    soon = ("--unused-session-lifetime", "50", "--check-unused-sessions", "50")
    with serving(tmp_path / "log", app=(*FLAGS, *soon)) as server:
        asyncio.run(_measure_and_leave(server))
        wait(lambda: not workers(server))
        assert "on_session_destroyed" not in server.log.read_text()


def workers(server: Server) -> list[psutil.Process]:
    return psutil.Process(server.process.pid).children()


async def _measure_and_leave(server: Server) -> None:
    visitor = await Visitor.arrive(server.url, "scene=accuracy&limit=60")
    await visitor.say({"type": "run", "order": "start"})
    wait(lambda: workers(server))
    visitor.leave()
