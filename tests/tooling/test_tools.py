"""Tools that developers run: house rules, known and random faults, benchmarks."""

import ast
import asyncio
from itertools import islice
from pathlib import Path

import pytest

from components.scenes import SCENES
from tests.serving.server import ROOT, serving
from tools import house_rules
from tools.bench import error_vs_time
from tools.bench.classroom import CHOICE, SKETCH, answered, drawing, measured
from tools.bench.crowd import SETTINGS, arrive, depart, drag, dragged, p95
from tools.bench.record import recalled
from tools.bench.soak import soak, still_open
from tools.bench.tables import markdown
from tools.faults import MUTANTS, Mutant, broken
from tools.house_rules import Source
from tools.random_faults import put, random_sites

WORDS = (
    "one.py: has 503 lines",
    "one.py:503: has 121 characters",
    "one.py:2: many has 501 lines",
    "one.py:1: begins with “The same”",
    "a.py:1 and b.py:1: two types are called Case",
)


def test_a_broken_rule_is_reported_with_its_place() -> None:
    bad = Source("one.py", '"""The same."""\ndef many():\n' + 500 * "    one()\n" + 121 * "a")
    rules = (house_rules.long_modules, house_rules.long_lines, house_rules.long_functions, house_rules.vague_docstrings)
    found = [said for rule in rules for said in rule(bad)]
    found += house_rules.shared_names(Source(name, "class Case: ...") for name in ("a.py", "b.py"))
    assert [said[: len(words)] for said, words in zip(found, WORDS, strict=True)] == [*WORDS]


@pytest.mark.parametrize("mutant", MUTANTS, ids=lambda mutant: mutant.name)
def test_a_fault_can_be_applied(mutant: Mutant) -> None:
    assert mutant.old not in broken(mutant, ROOT) or mutant.old in mutant.new
    assert all((ROOT / name).exists() for name in mutant.tests.split())


def test_a_random_fault_changes_what_is_executed() -> None:
    for fault in (put(ROOT, site) for site in islice(random_sites(ROOT, 56), 5)):
        assert ast.dump(ast.parse(fault.text)) != ast.dump(ast.parse((ROOT / fault.site.file).read_text("utf-8")))


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
