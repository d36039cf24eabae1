"""Scene accuracy: its picture of recorded runs, without measuring; its claims on methods in Python and compiled."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import cycle

import numpy as np
import pytest

from components.scenes.accuracy import Accuracy
from components.scenes.accuracy.data import Known, Series, picked_run, reached_text, setting_text
from components.scenes.accuracy.measurement import known
from components.scenes.accuracy.measuring import LIVE, Job
from components.scenes.accuracy.prices import price_list, time_text, unreached
from components.scenes.accuracy.recorded import recorded
from physics.integrators.accuracy import MARKS, SYSTEMS, Run, entered
from physics.integrators.solvers import METHODS
from tests.page.headless_page import Page, unpacked
from tests.scenes.checks import check_picture


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
    scene.set({"measured": (SYSTEMS["benign"], scene.limit, HERE, "done")})
    return scene


class HalfDone:
    """A queue with one measurement that is half done, until it is `done`."""

    done, budget = False, 90.0
    job = Job(SYSTEMS["benign"], 1.0, LIVE, "running", {(run.method, run.setting): run for run in HERE[:2]})

    def ask(self, *_: object) -> Job:
        return self.job

    def remembered(self, system: object, _: float) -> Job | None:
        return replace(self.job, state="done") if self.done and system == self.job.system else None

    def leave(self, *_: object) -> None:
        """No visitor is kept here."""


def test_what_has_been_measured_is_there_again_after_undo_and_on_a_new_page(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a measurement that is half done the page itself remembers, of one that has ended all pages of the process."""
    one = HalfDone()
    monkeypatch.setattr("components.scenes.accuracy.measurement.queue", lambda: one)
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
    one.done = True
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
    scene = measured(view="growth", wanted=1e-3)
    assert scene.sources["error_growth_verlet"].data["error_growth"][-1] == pytest.approx(1e-4)
    scene.set({"equal": "cost", "cost": 0.05})
    assert scene.sources["error_growth_verlet"].data["error_growth"][-1] == pytest.approx(1e-2)
    scene.set({"cost": 1.5e-3})
    assert not scene.sources["error_growth_verlet"].data
    assert "Verlet" in scene.shown.values["missing"] and "Closed" not in scene.shown.values["missing"]
    assert scene.shown.axes["period"].unit == "slow periods"
    assert Accuracy(system="dashpot").shown.axes["period"].unit == "relaxation times"


KINDS = {
    "wide": r"Highly oscillatory: step times fast rate may be 0\.03\d* for accuracy, 2\.83 for stability\.",
    "wider": r"Stiff: step times fast rate may be 43900 for accuracy, 2\.83.*",
    "benign": r"Neither stiff nor highly oscillatory.*",
}
"""Sentences about the step that three systems allow."""
VIEWS = [view.slug for view in Accuracy.views]


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
