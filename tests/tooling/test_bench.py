"""Benchmarks in short forms: visitors and classes are all served, records are complete, documents agree with them."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest

from components.scenes import SCENES
from physics.integrators.solvers import METHODS
from tests.serving.server import serving
from tools.bench import changes, error_vs_time, studies
from tools.bench.classroom import CHOICE, SKETCH, answered, drawing, measured
from tools.bench.crowd import SETTINGS, arrive, depart, drag, dragged, p95
from tools.bench.record import recalled
from tools.bench.soak import soak, still_open
from tools.bench.tables import markdown


@pytest.mark.nightly
@pytest.mark.timeout(300)
def test_visitors_of_every_scene_and_a_class_are_served_and_leave_nothing_behind(tmp_path: Path) -> None:
    async def visits() -> None:
        for slug, scene in SCENES.items():
            _, visitors = await arrive([server], f"scene={slug}", 2)
            waits = await drag(visitors, dragged(scene), rate=20, seconds=0.1)
            assert len(waits) >= 2 and p95(waits) > 0
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


@pytest.mark.nightly
def test_a_tiny_record_is_written_and_its_document_is_made_again_from_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    few = {slug: METHODS[slug] for slug in ("closed", "slides", "eigh", "naive", "expm", "rk4", "gauss4", "lsoda")}
    monkeypatch.setattr("tools.bench.compiled.compiled_methods", lambda systems: [])
    for name, value in (("LENGTHS", (5, 10)), ("STEPPING", ("rk4",)), ("TOLERANCES", {"lsoda": 1e-6})):
        monkeypatch.setattr(studies, name, value)
    monkeypatch.setattr(studies, "NEIGHBOURS", (1.0,))
    monkeypatch.setattr(error_vs_time, "METHODS", few)
    folders = ["--recorded", str(tmp_path / "record"), "--output", str(tmp_path / "docs")]
    pages = []
    for options in (["--record", "--systems", "wide", "--seconds", "0.02"], ["--rewrite"]):
        error_vs_time.main([*folders, *options])
        pages.append((tmp_path / "docs/error_vs_time.md").read_text())
    assert pages[0] == pages[1] and "at least" in pages[0]
    assert changes.recorded_kinds(recalled(tmp_path / "record")) == {(slug, False) for slug in few}
