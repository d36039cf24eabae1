"""Scene accuracy: its picture of recorded runs, the queue of measurements and its worker process."""

import re
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import cycle
from pathlib import Path
from unittest.mock import Mock

import numpy as np
import psutil
import pytest

from components.scenes.accuracy import Accuracy
from components.scenes.accuracy.data import Known, Series, picked_run, reached_text, setting_text
from components.scenes.accuracy.measurement import known
from components.scenes.accuracy.measuring import LIVE, WAITING, Job, Measuring
from components.scenes.accuracy.prices import price_list, time_text, unreached
from components.scenes.accuracy.recorded import recorded
from physics.integrators.accuracy import MARKS, PERIODS, SYSTEMS, Run, entered
from physics.integrators.exponential_steps import EXPONENTIAL
from physics.integrators.fixed_steps import STEPPING
from physics.integrators.price import prices
from physics.integrators.solvers import METHODS
from tests.page.headless_page import Page, unpacked
from tests.scenes.checks import check_picture
from tests.serving.server import serving
from tests.serving.visitor import Visitor

pytestmark = pytest.mark.timeout(600)
BENIGN = SYSTEMS["benign"]
KINDS = {
    "wide": r"Highly oscillatory: step times fast rate may be 0\.03\d* for accuracy, 2\.83 for stability\.",
    "wider": r"Stiff: step times fast rate may be 43900 for accuracy, 2\.83.*",
    "benign": r"Neither stiff nor highly oscillatory.*",
}
"""Sentences about the step that three systems allow."""
VIEWS = [view.slug for view in Accuracy.views]
TWO = ("closed", "verlet")
SOLVING = [slug for slug, step in STEPPING.items() if step.solved or step.splits]
"""Methods that solve equations, or the coupling spring, exactly: no step of theirs is too long for stability."""


def a_run(method: str, setting: float, time: float | None, error: float | None, **more: object) -> Run:
    levels = {"error_growth": tuple((error or 0.0) * mark / 50 for mark in MARKS), "energy_growth": 15 * (1e-6,)}
    facts = {"system": "benign", "energy_error": 1e-3, "evaluations": 1000, **(levels if error else {})}
    return Run(method=method, setting=setting, time=time, error=error, **(facts | more))  # type: ignore[arg-type]


HERE = (
    a_run("closed", 0, 1e-3, 2e-16, end="finest"),
    a_run("verlet", 1, 1e-2, 1e-2),
    a_run("verlet", 4, 1e-1, 1e-4, evaluations=16000),
    a_run("verlet", 6, None, None, failure="time limit 1 s", reached=0.4, end="time limit"),
    a_run("lsoda", 1e-3, 2e-2, 5.0),
)
BEFORE = (a_run("closed", 0, 2e-3, 2e-16), a_run("rk4", 3, 4e-3, 1e-4), a_run("bdf", 1e-9, 0.5, 1e-9, end="finest"))


def measured(**values: object) -> Accuracy:
    scene = Accuracy(**values)
    scene.set({"measured": (BENIGN, scene.limit, HERE, "done")})
    return scene


def test_what_has_been_measured_is_there_again_after_undo_and_on_a_new_page(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a measurement that is half done the page itself remembers, of one that has ended all pages of the process."""
    job = Job(BENIGN, 1.0, LIVE, "running", {(run.method, run.setting): run for run in HERE[:2]})
    queue = Mock(spec=Measuring, budget=90.0, ask=Mock(return_value=job), remembered=Mock(return_value=None))
    monkeypatch.setattr("components.scenes.accuracy.measurement.queue", lambda: queue)
    page = Page(Accuracy())
    page.send({"type": "run", "order": "start", "number": 1})
    page.session.running.notify()
    assert known(page.scene).here.every == HERE[:2] and unpacked(page.packets[-1])["answer"] is None
    before = page.opening()["state"]
    told = page.send({"type": "choose", "name": "system", "value": "dashpot", "number": 2})
    assert told["errors"] == {} and not known(page.scene).here.every
    page.send({"type": "run", "order": "cancel", "number": 3})
    page.send({"type": "open", "state": before, "number": 4})
    assert known(page.scene).here.every == HERE[:2]
    assert not known(Page(Accuracy()).scene).here.every
    queue.remembered.side_effect = lambda system, _: replace(job, state="done") if system == job.system else None
    assert known(Page(Accuracy()).scene).here.every == HERE[:2]


def test_dots_are_measured_here_and_lines_recorded() -> None:
    scene = Accuracy()
    assert not any(scene.sources[slug].data for slug in METHODS)
    known = recorded("benign").runs.points
    assert {slug for slug in METHODS if scene.sources[f"rec_{slug}"].data} == set(known) > {"closed", "rk4", "nystrom6"}
    scene = measured()
    np.testing.assert_allclose(scene.sources["verlet"].data["error"], [1e-2, 1e-4])
    np.testing.assert_allclose(scene.sources["verlet"].data["time"], [1e-2, 1e-1])
    assert not scene.sources["rec_verlet"].data and len(scene.sources["old_verlet"].data["time"]) > 3
    assert not scene.sources["lsoda"].data, "what is all wrong is not drawn"
    assert scene.shown.forms["origin"] == "both"
    check_picture(scene)
    scene.set({"system": "wide"})
    assert not any(scene.sources[slug].data for slug in METHODS), "results of another system"
    scene = Accuracy(system="own", m1=2.0, k2=7.0, F_0=1.5)
    assert scene.shown_system().chain.k2 == 7.0 and len(scene.sources["old_verlet"].data["time"]), "another, for scale"
    assert not scene.sources["rec_verlet"].data and scene.shown.forms["origin"] == "none"


def test_rows_of_prices_are_of_one_machine_and_say_what_was_not_reached() -> None:
    found = Known(Series(HERE), Series(BEFORE))
    rows = dict(price_list(found, ("closed", "verlet", "rk4", "bdf", "lsoda"), 1e-3))
    assert rows["closed"] == ("Closed form", "outputs", "1.00", "1")
    assert rows["verlet"] == ("Verlet", "4000", "31.6", "31.6")
    assert rows["rk4"] == ("RK4", "1000", "4.00", "2"), "recorded with recorded"
    assert dict(price_list(found, ("verlet",), 1e-3, "doubles"))["verlet"][3] == "", "no closed form in doubles ran"
    fine = ("verlet", "rk4", "bdf")
    assert price_list(found, fine, 1e-10) == [] and unreached(found, fine, 1e-3) == ""
    assert unreached(found, fine, 1e-10) == (
        "Not reached: BDF (1·10⁻⁹ at best, no finer), Verlet (1·10⁻⁴ at best, more than 1 s), "
        "RK4 (1·10⁻⁴ at best, not refined so far)."
    )


def test_the_picked_run_keeps_energy_and_loses_phase() -> None:
    scene = measured(picked=["verlet", "1"])
    kept = scene.sources["kept"].data
    assert kept["period"].tolist() == list(MARKS)
    assert kept["motion"][-1] == pytest.approx(1e-2) and kept["energy"][-1] == pytest.approx(1e-4)
    found = Known(Series(HERE), Series(BEFORE))
    assert picked_run(found, ["verlet", "9"]) is None and picked_run(found, ["what", "0"]) is None
    assert picked_run(found, ["old_rk4", "0"]) == picked_run(found, ["rec_rk4", "0"]) == BEFORE[1]
    assert setting_text(HERE[1]) == "Verlet, 1 step an output"
    run = a_run("rk45", 1e-6, 1.0, 5.6e-5, final_error=4.4e-5, mode_errors=(6e-10, 5.6e-5))
    assert reached_text(run) == (
        "RK45, rtol 10⁻⁶, atol 10⁻⁹ of the largest displacement: error 6·10⁻⁵, at the end 4·10⁻⁵, slow mode 6·10⁻¹⁰, "
        "fast mode 6·10⁻⁵"
    )


def test_growth_at_equal_error_and_at_equal_cost() -> None:
    scene = measured(view="growth")
    for values, error in (({"wanted": 1e-3}, 1e-4), ({"equal": "cost", "cost": 0.05}, 1e-2), ({"cost": 1.5e-3}, None)):
        scene.set(values)
        found = scene.sources["error_growth_verlet"].data
        assert found["error_growth"][-1] == pytest.approx(error) if error else not found
    assert "Verlet" in scene.shown.values["missing"] and "Closed" not in scene.shown.values["missing"]
    assert scene.shown.axes["period"].unit == "slow periods"
    assert Accuracy(system="dashpot").shown.axes["period"].unit == "relaxation times"


@pytest.mark.parametrize(("slug", "view"), [*zip(SYSTEMS, cycle(VIEWS))])
def test_a_system_on_record_is_shown_before_anything_is_measured(slug: str, view: str) -> None:
    known = recorded(slug)
    assert set(known.runs.by_method) == set(entered(SYSTEMS[slug]))
    assert {run.system for run in known.runs.every} == {slug}
    (closed,) = known.runs.by_method["closed"]
    assert closed.error is not None and closed.error < 2.0**-51 and closed.rounds == 3
    assert known.about["machine"] and known.origin.startswith(known.about["date"][:10])
    scene = Accuracy(system=slug, view=view, limit=0.01, hidden=[])
    shown, longest = scene.shown, max(run.time or 0.0 for run in (*known.runs.every, *known.compiled.every))
    assert shown.forms["origin"] == "before" and shown.axes["time"].end > longest, "every run is within the plot"
    longer = f", chosen steps up to {time_text(longest)}" if longest > 2 else ""
    assert (shown.values["limit"], shown.values["recorded_limit"]) == ("10.0 ms", f"each run at most 1.00 s{longer}")
    assert re.fullmatch(KINDS.get(slug, ".+"), shown.values["kind"])
    check_picture(scene)
    check_picture(measured(view=view, system=slug))


def test_the_first_view_draws_three_methods_that_leave_the_exact_motion() -> None:
    scene = Accuracy()
    drawn = {slug: scene.sources[f"drift_{slug}"].data for slug in ("exact", "euler", "verlet", "rk4")}
    assert all(data["drift_x"][0] == 1.0 for data in drawn.values())
    ends = {slug: data["drift_t"][-1] for slug, data in drawn.items()}
    assert ends["exact"] == pytest.approx(4) == ends["rk4"] and ends["euler"] < 4
    assert re.fullmatch(
        r"With 30 steps a period, at worst: Explicit Euler explodes, Verlet is \d+ % off, RK4 is \d+ % off\.",
        scene.shown.values["drifted"],
    )
    scene.set({"steps": 8.0, "system": "wide"})
    assert "more steps a period are needed: Verlet 6350, RK4 4490." in scene.shown.values["drifted"]


def stepping(slug: str, wanted: float) -> dict[str, float]:
    """Evaluations of the adaptive methods, without one that 1,000 restarts make more accurate than asked."""
    found = prices(recorded(slug).runs.by_method.values(), wanted)
    known = {price.method: price.evaluations or 0.0 for price in found if price.time is not None}
    return {name: n for name, n in known.items() if METHODS[name].family in ("fixed", "adaptive") and name != "fortran"}


def test_what_the_presets_say_of_methods_is_true_of_the_record() -> None:
    """Close frequencies cost no steps, a fast mode that swings does, and explicit methods follow one at rest."""
    beats, benign = (stepping(slug, 1e-6) for slug in ("beats", "benign"))
    assert all(beats[method] < benign[method] for method in beats.keys() & benign.keys())
    for slug, ratio in (("wide", 2000), ("light", 1000)):
        found = stepping(slug, 1e-3)
        assert all(count > PERIODS * ratio for name, count in found.items() if name not in EXPONENTIAL)
    found = stepping("wider", 1e-6)
    assert all(found[slug] > 1000 * found["gauss4"] for slug in found if slug in STEPPING and slug not in SOLVING)
    for method in ("midpoint", "newmark", "gauss4", "radau", "bdf"):
        run = next(run for run in recorded("dashpot").runs.by_method[method] if run.error is not None)
        assert ((run.final_error or 0.0) < 0.01) == (method in ("radau", "bdf")), "long steps ring, or do not"


def wait(until: Callable[[], object], seconds: float = 400.0) -> None:
    end = time.monotonic() + seconds
    while not until():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.02)


def visitors(count: int) -> list[Callable[[], None]]:
    """Listeners that differ."""
    return [partial(print, end="") for _ in range(count)]


@pytest.fixture
def two(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two methods are measured, not eight, so that the run also ends on a busy machine."""
    monkeypatch.setattr("components.scenes.accuracy.measuring.LIVE", TWO)


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
    assert queue.ask(BENIGN, 0.02, print) is job
    later = queue.ask(replace(BENIGN, slug="later"), 0.02, heard)
    wait(lambda: later.state == "done")
    assert [queue.remembered(one.system, 0.02) for one in (job, later)] == [None, later]


def test_a_full_queue_stays_as_it_is_and_a_network_has_one_measurement_waiting() -> None:
    queue, people = Measuring(budget=60.0), visitors(WAITING + 1)
    jobs = [queue.ask(replace(BENIGN, slug=f"own{n}"), 30.0, one) for n, one in enumerate(people)]
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
    for each, one in ((changed, ours), (theirs, again), *reversed(list(zip(jobs, people, strict=True)))):
        queue.leave(each, one)
    with pytest.raises(ValueError, match="no period"):
        queue.ask(replace(BENIGN, chain=replace(BENIGN.chain, k1=0.0, k2=0.0)), 1.0, late)
    job = queue.ask(replace(BENIGN, x_0=(0.0, 0.0), v_0=(0.0, 0.0)), 1.0, late)
    wait(lambda: job.state == "done")
    assert job.reason and not job.runs, "nothing moves"


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


@pytest.mark.nightly
async def test_a_visitor_who_leaves_ends_the_measurement(tmp_path: Path) -> None:
    with serving(tmp_path / "log", options=("--unused-seconds", "0.05")) as server:
        process = psutil.Process(server.process.pid)
        visitor = await Visitor.arrive(server.url, "scene=accuracy&limit=60")
        await visitor.send({"type": "run", "order": "start"})
        wait(process.children)
        await visitor.depart()
        wait(lambda: not process.children())
        assert "on_session_destroyed" not in server.log.read_text()
