"""Scene accuracy: what it shows of measured runs, without measuring."""

from __future__ import annotations

import math

import numpy as np
import pytest

from components.scenes.accuracy import Accuracy
from components.scenes.accuracy.data import (
    FLOOR,
    picked_run,
    price_texts,
    prices,
    recorded,
    setting_text,
    step_explosion,
    stopped,
    work,
)
from physics.accuracy import SYSTEMS, Run, plan
from physics.coupled import TwoMassChain
from tests.scene_checks import check_picture


def a_run(method: str, setting: float, time: float | None, error: float | None, **more: object) -> Run:
    facts = {"system": "benign", "name": method, "family": "fixed", "energy_error": 1e-3}
    return Run(method=method, setting=setting, time=time, error=error, **(facts | more))  # type: ignore[arg-type]


RUNS = (
    a_run(
        "closed",
        0,
        1e-3,
        2e-16,
        family="closed",
        name="Closed form",
        error_growth=(0.0, 2e-16),
        energy_growth=(0.0, 1e-16),
    ),
    a_run("verlet", 1, 1e-2, 1e-2, name="Verlet", error_growth=(0.0, 1e-2), energy_growth=(0.0, 1e-4)),
    a_run("verlet", 4, 1e-1, 1e-4, name="Verlet", error_growth=(0.0, 1e-4), energy_growth=(0.0, 1e-6)),
    a_run("rk45", 1e-9, None, None, name="RK45", family="adaptive", failure="time limit 1 s", reached=0.4),
)


def measured(**values: object) -> Accuracy:
    scene = Accuracy(**values)
    scene.set({"measured": (SYSTEMS["benign"], scene.limit, RUNS, "done")})
    return scene


def test_work_precision_columns() -> None:
    scene = measured()
    np.testing.assert_allclose(scene.sources["verlet"].data["error"], [1e-2, 1e-4])
    np.testing.assert_allclose(scene.sources["verlet"].data["time"], [1e-2, 1e-1])
    assert work(RUNS)["closed"]["error"][0] == pytest.approx(2e-16)
    check_picture(scene)


def test_a_price_between_two_runs_is_read_off_their_line() -> None:
    by_name = {price.name: price for price in prices(RUNS, 1e-3)}
    assert by_name["Verlet"].time == pytest.approx(math.sqrt(1e-2 * 1e-1))
    assert by_name["Closed form"].time == 1e-3
    late = {price.name: price for price in prices(RUNS, 1e-6)}["Verlet"]
    assert late.time is None and late.best == 1e-4
    assert price_texts([late], 1e-3) == [("Verlet", "not reached", "best 1·10⁻⁴")]


def test_a_failure_is_a_row_with_its_reason() -> None:
    assert stopped(RUNS) == [("RK45, rtol 10⁻⁹", "time limit 1 s, at 40 %")]
    scene = measured()
    assert scene.shown.values["stopped0_why"] == "time limit 1 s, at 40 %"
    assert scene.shown.forms["stopped0"] == "shown" and "stopped1" not in scene.shown.forms


def test_the_picked_run_keeps_energy_and_loses_phase() -> None:
    scene = measured(picked=["verlet", "1"])
    kept = scene.sources["kept"].data
    np.testing.assert_allclose(kept["motion"], [0, 1e-2])
    np.testing.assert_allclose(kept["energy"], [0, 1e-4])
    assert picked_run(RUNS, ["verlet", "9"]) is None
    assert setting_text(RUNS[1]) == "Verlet, 1 step an output"


def test_results_of_another_system_are_not_shown() -> None:
    scene = measured(limit=3.0)
    scene.set({"system": "stiff"})
    assert not any(len(scene.sources[m].data["time"]) for m in ("closed", "verlet"))


@pytest.mark.parametrize("view", ["time", "growth", "energy", "stability"])
@pytest.mark.parametrize("system", [*SYSTEMS, "own"])
def test_every_view_of_every_system(view: str, system: str) -> None:
    check_picture(measured(view=view, system=system))


def test_steps_explode_like_the_root_of_the_stiffness() -> None:
    columns = step_explosion(TwoMassChain(m1=1, m2=1, k1=1, k2=1))
    slope = np.diff(np.log(columns["steps_verlet"])) / np.diff(np.log(columns["ratio"]))
    assert slope[-1] == pytest.approx(0.5, abs=1e-3)


def test_own_system_from_a_link() -> None:
    scene = Accuracy(system="own", m1=2.0, k2=7.0, F_0=1.5)
    system = scene._system()
    assert (system.chain.m1, system.chain.k2, system.F_0) == (2.0, 7.0, 1.5)
    with pytest.raises(ValueError, match="no period"):
        scene.set({"k1": 0.0, "k2": 0.0})
    assert scene.k1 == 1.0
    assert FLOOR < 2.0**-53


def test_recorded_runs_stand_before_anything_is_measured() -> None:
    scene = Accuracy()
    assert len(scene.sources["verlet"].data["time"]) > 3
    assert scene.sources["closed"].data["error"][0] < 2.0**-52
    assert "Recorded" in scene.progress["text"]
    assert set(recorded().runs) == set(SYSTEMS)
    assert not len(Accuracy(limit=3.0).sources["verlet"].data["time"])


def test_what_was_stopped_is_not_told_as_recorded_elsewhere() -> None:
    told = measured().progress
    assert told["text"].startswith("Stopped before its end")
    assert (told["done"], told["total"]) == (len(RUNS), len(plan(SYSTEMS["benign"])))
