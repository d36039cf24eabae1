"""Benchmarks in short forms: visitors and classes are all served, records are complete, documents agree with them."""

from __future__ import annotations

import asyncio
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from components.scenes import SCENES
from physics.integrators.accuracy import SYSTEMS
from physics.integrators.fixed_steps import STEPPING
from physics.integrators.problem import Problem, Watch
from physics.integrators.solvers import METHODS
from tests.serving.server import serving
from tools.bench import changes, error_vs_time, studies
from tools.bench.classroom import CHOICE, SKETCH, answered, drawing, measured
from tools.bench.compiled import run_compiled
from tools.bench.crowd import SETTINGS, arrive, depart, drag, dragged, p95
from tools.bench.record import Report, recalled
from tools.bench.soak import soak, still_open
from tools.bench.tables import markdown


@pytest.mark.nightly
@pytest.mark.timeout(300)
def test_visitors_of_every_scene_and_a_class_are_served_and_leave_nothing_behind(tmp_path: Path) -> None:
    async def visits() -> None:
        for slug, scene in SCENES.items():
            _, visitors = await arrive([server], f"scene={slug}", 2)
            waits = await drag(visitors, dragged(scene), rate=20, seconds=0.1)
            assert len(waits) >= 2 and 0 < p95(waits) <= max(waits)
            await depart(visitors)

    with serving(tmp_path / "log", environment={**SETTINGS, "UNUSED_SECONDS": "2"}) as server:
        asyncio.run(visits())
        figures = asyncio.run(measured(server, 20, 2.0))
        assert figures.missed == 0 and figures.updates >= 2
        assert figures.bytes <= 5000 and max(figures.reach) < float("inf")
        asyncio.run(answered(server, 20, CHOICE, {"option": 1}))
        asyncio.run(answered(server, 20, SKETCH, drawing()))
        assert len(soak(server, rounds=2, sessions=9)) == 2
        assert still_open(server) == 0
        assert server.complaints() == []


def test_the_document_agrees_with_the_record() -> None:
    report = recalled(error_vs_time.RECORDED)
    assert (error_vs_time.ROOT / "docs/bench/error_vs_time.md").read_text(encoding="utf-8") == markdown(report)
    for run in (run for many in report.runs.values() for run in many if run.time):
        long = run.family == "adaptive" and run.method in error_vs_time.LONG.get(run.system, {})
        assert 0.0 < run.time < 2 * (error_vs_time.PATIENCE if long else 1.0)


@pytest.mark.nightly
def test_a_tiny_record_is_complete_and_each_option_changes_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    few = {slug: METHODS[slug] for slug in ("closed", "slides", "eigh", "naive", "expm", "rk4", "gauss4", "lsoda")}
    monkeypatch.setattr("tools.bench.compiled.compiled_methods", lambda systems: [])
    for name, value in (("LENGTHS", (5, 10)), ("STEPPING", ("rk4",)), ("TOLERANCES", {"lsoda": 1e-6})):
        monkeypatch.setattr(studies, name, value)
    monkeypatch.setattr(studies, "NEIGHBOURS", (1.0,))
    monkeypatch.setattr(error_vs_time, "METHODS", few)
    monkeypatch.setattr(error_vs_time, "LONG", {"wide": {"lsoda": (1e-2, 1e-13)}})
    folders = ["--recorded", str(tmp_path / "record"), "--output", str(tmp_path / "docs")]

    def changed(*options: str) -> Report:
        error_vs_time.main([*folders, *options])
        return recalled(tmp_path / "record")

    first = changed("--record", "--systems", "wide", "--seconds", "0.02")
    assert list(first.runs) == ["wide"] and changes.recorded_kinds(first) == {(slug, False) for slug in few}
    again = changed("--again", "--seconds", "0.02")
    assert any(run.again for run in again.runs["wide"]) and "again" in again.about
    monkeypatch.setattr(error_vs_time, "METHODS", few | {"adams": METHODS["adams"]})
    more = changed("--add", "--systems", "wide", "--seconds", "0.02")
    assert ("adams", False) in changes.recorded_kinds(more) and more.about["added"].endswith(": VODE-Adams")
    long = changed("--long", "--seconds", "0.02")
    assert [run.setting for run in long.runs["wide"] if run.method == "lsoda"] == [1e-2] and "long" in long.about
    assert changed("--count").about["counted"].startswith("spread of counts")
    page = (tmp_path / "docs/error_vs_time.md").read_text()
    changed("--rewrite")
    assert (tmp_path / "docs/error_vs_time.md").read_text() == page and "at least" in page


NEAR = replace(SYSTEMS["near"].problem(), x_0=(1.0, -0.5), v_0=(0.2, 0.3))
RUBBED = SYSTEMS["dashpot"].problem()


@pytest.mark.nightly  # compilation
@pytest.mark.parametrize(
    ("method", "problem"),
    [*((slug, NEAR) for slug in STEPPING), *((slug, RUBBED) for slug in ("rk4", "newmark", "radau5", "alpha"))],
    ids=lambda value: value if isinstance(value, str) else "rubbed" if value.c else "driven",
)
def test_compiled_integrators_give_the_same_numbers(method: str, problem: Problem) -> None:
    short = replace(problem, t=(1e-5 if problem.c else 1.0) * problem.t[:40])
    for steps in (1, 7):
        python, compiled = Watch(), Watch()
        one, other = METHODS[method].run(short, steps, python), run_compiled(method, short, steps, compiled)
        np.testing.assert_allclose(other.x, one.x, rtol=0, atol=1e-13 * np.max(np.abs(one.x)))
        np.testing.assert_allclose(other.v, one.v, rtol=0, atol=1e-13 * np.max(np.abs(one.v)))
        assert (python.steps, python.evaluations) == (compiled.steps, compiled.evaluations)
