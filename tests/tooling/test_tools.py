"""Each tool that developers run: house rules, known and random faults, compared pictures, benchmarks."""

import ast
import asyncio
import re
import shutil
import subprocess
import sys
from functools import partial
from itertools import islice
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from components.layout.views import View
from components.scenes import SCENES
from physics.integrators.solvers import METHODS
from tests.serving.server import ROOT, serving
from tools import house_rules
from tools.bench import changes, error_vs_time, studies
from tools.bench.classroom import CHOICE, SKETCH, answered, drawing, measured
from tools.bench.crowd import SETTINGS, arrive, depart, drag, dragged, p95
from tools.bench.record import recalled
from tools.bench.soak import soak, still_open
from tools.bench.tables import markdown
from tools.docstrings import gaps_of
from tools.faults import MUTANTS, Mutant, broken
from tools.house_rules import Source
from tools.random_faults import put, random_sites

UNEXPLAINED = 'def f(a, b):\n    """Return the sum."""\n    raise ValueError("no")'
WORDS = (
    "one.py: has 503 lines",
    "one.py:503: has 121 characters",
    "one.py:2: many has 501 lines",
    "one.py:1: begins with “The same”",
    "a.py:1 and b.py:1: two types are called Case",
    "static: 2 types are called One",
    "static: a.js, b.js, c.js, d.js import each other",
    "components/scenes/friction: the example “Heavy” has a sentence of 10 characters",
    "components/scenes/friction: the task of the view “A” begins with “Behold”",
)


def test_a_broken_rule_is_reported_with_its_place(tmp_path: Path) -> None:
    bad = Source("one.py", '"""The same."""\ndef many():\n' + 500 * "    one()\n" + 121 * "a")
    scripts = [tmp_path / name for name in ("a.js", "b.js", "c.js", "d.js")]
    for one, other in zip(scripts, [*scripts[1:], scripts[0]], strict=True):
        one.write_text(f"import('./{other.name}')")
    found = [
        *house_rules.long_modules(bad),
        *house_rules.long_lines(bad),
        *house_rules.long_functions(bad),
        *house_rules.vague_docstrings(bad),
        *house_rules.shared_names(Source(name, "class Case: ...") for name in ("a.py", "b.py")),
        *house_rules.shared_script_names(["class One {}", "/** @typedef {number} One */"]),
        *house_rules.import_circles(scripts),
        *house_rules.bad_sentences("friction", {"Heavy": "It creeps."}),
        *house_rules.bad_tasks("friction", [View("A", "Behold it.")]),
    ]
    assert [said[: len(words)] for said, words in zip(found, WORDS, strict=True)] == [*WORDS]
    (module, function) = gaps_of("physics/one.py", f'"""The sum."""\n{UNEXPLAINED}')
    assert (module.lacks, function.lacks) == (("a source",), ("ValueError", "a", "b"))


@pytest.mark.parametrize("mutant", MUTANTS, ids=lambda mutant: mutant.name)
def test_a_fault_can_be_applied(mutant: Mutant) -> None:
    assert mutant.old not in broken(mutant, ROOT) or mutant.old in mutant.new
    assert all((ROOT / name).exists() for name in mutant.tests.split())


def test_a_random_fault_changes_what_is_executed() -> None:
    for fault in (put(ROOT, site) for site in islice(random_sites(ROOT, 56), 5)):
        assert ast.dump(ast.parse(fault.text)) != ast.dump(ast.parse((ROOT / fault.site.file).read_text("utf-8")))


TOOL = (sys.executable, "-m", "tools.pictures")
run = partial(subprocess.run, cwd=ROOT, capture_output=True, text=True)


@pytest.mark.nightly
@pytest.mark.browser
@pytest.mark.timeout(400)  # a server starts
def test_a_changed_picture_is_listed(browser: object, tmp_path: Path) -> None:
    before, after = tmp_path / "before", tmp_path / "after"
    # After the answer, this step still hides quantities that later steps ask for.
    shot = run([*TOOL, "shoot", before, "--only", "^walk d34-01$"])
    assert " pictures in " in shot.stdout, shot.stderr
    shutil.copytree(before, after)
    path = next(after.glob("*-desk.png"))
    Image.fromarray(255 - np.asarray(Image.open(path))).save(path)
    assert re.fullmatch(
        rf"{re.escape(path.name)}: \d+\.\d+% of the pixels, .*\n", run([*TOOL, "compare", before, after]).stdout
    )


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
