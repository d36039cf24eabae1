"""Documents: the code of the tutorial and the notebooks runs, figures agree with the measured ones, and all named files
exist. Tools that developers run: house rules, known and random faults, benchmarks.
"""

import ast
import asyncio
import os
import re
import shutil
import subprocess
import sys
from itertools import islice
from pathlib import Path
from typing import Any

import pytest

from components.scenes import SCENES
from tests.grids import sample
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
from tools.trials import copied

PATHS = [*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")]
DOCS = {path.relative_to(ROOT).as_posix(): path.read_text("utf-8") for path in PATHS}
README, MEASURED = DOCS["README.md"], DOCS["docs/measured.md"]


def test_figures_agree_with_the_measured_ones() -> None:
    rows = re.findall(r"^\| ([^|]+) \| ([^|]+) \|$", README, re.M)
    figures = [(name, figure) for name, figure in rows if name not in ("what", "---")]
    assert len(figures) == 10
    for name, figure in figures:
        (row,) = [line for line in MEASURED.splitlines() if line.startswith(f"| {name} |")]
        assert f"| {figure} |" in row, name
    assert DOCS["docs/bench/error_vs_time.md"] == markdown(recalled(error_vs_time.RECORDED))


@pytest.mark.parametrize("page", DOCS)
def test_links_lead_to_existing_files(page: str) -> None:
    for target in re.findall(r"\]\(([\w./-]+)(?:#[\w-]*)?\)", DOCS[page]):
        assert ((ROOT / page).parent / target).exists(), target


def test_files_named_in_code_and_documents_exist() -> None:
    texts = [*DOCS.values(), *(path.read_text("utf-8") for path in (ROOT / "types").glob("*.ts"))]
    texts += [source.text for source in house_rules.code() if source.is_product]
    named = re.compile(
        r"(?<![\w/])(?:components|docs|physics|static|tests|tools|types)/[\w/-]+\.(?:css|d\.ts|html|js|md|py|toml)\b"
    )
    found = {name for text in texts for name in named.findall(text)}
    assert len(found) > 100
    written = ("components/scenes/friction/", "tests/scenes/test_friction.py")  # by docs/adding-a-scene.md
    assert [name for name in found if not ((ROOT / name).exists() or name.startswith(written))] == []


TEST = re.compile(r"(tests/\S+\.py)::(test_\w+)")


def test_every_criterion_of_wcag_2_2_has_a_row_and_supported_ones_name_tests_that_exist() -> None:
    rows = re.findall(r"^\| (\d\.\d\.\d+) [^|]+ \| ([^|]+) \| ([^|]+) \|$", DOCS["docs/accessibility.md"], re.M)
    assert len(rows) == 55
    named = set()
    for number, conformance, remarks in rows:
        assert conformance in ("Supports", "Partially Supports", "Does Not Support", "Not Applicable"), number
        found = TEST.findall(remarks)
        assert (found or conformance != "Supports") and remarks.strip(), number
        named.update(found)
    assert len(named) > 20
    for path, name in named:
        assert re.search(rf"^def {name}\(", (ROOT / path).read_text(encoding="utf-8"), re.M), f"{path}::{name}"


REGISTRY = "components/scenes/__init__.py"


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the project, extended as docs/adding-a-scene.md says."""
    folder = copied(ROOT, tmp_path_factory.mktemp("copy") / "project")
    if (ROOT / ".mypy_cache").exists():  # mypy then checks only the new files
        shutil.copytree(ROOT / ".mypy_cache", folder / ".mypy_cache")
    found, name = dict[str, str](), ""
    for block in re.findall(r"```python\n(.*?)```", DOCS["docs/adding-a-scene.md"], re.S):
        if named := re.match(r"# (.*\.py)\n", block):
            name = named[1]
        # A block without the name of a file belongs to the last one.
        found[name] = f"{found[name]}\n\n{block}" if name in found else block.partition("\n")[2]
    text = (ROOT / REGISTRY).read_text(encoding="utf-8")
    text = text.replace("\nSCENES: dict", f"{found[REGISTRY].strip()}\n\nSCENES: dict")
    assert text.count("        Accuracy,\n") == 1, "the list of scenes ends as it did when this was written"
    found[REGISTRY] = text.replace("        Accuracy,\n", "        Accuracy,\n        Friction,\n")
    for name, text in found.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return folder


def run(project: Path, *command: str) -> str:
    every = {**os.environ, "GRIDS": "whole"}
    done = subprocess.run([sys.executable, "-m", *command], cwd=project, env=every, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.slow
@pytest.mark.timeout(300)  # mypy without a cache
def test_the_scene_of_the_tutorial_is_typed_and_passes_its_own_tests_and_those_of_every_scene(project: Path) -> None:
    for command in (["ruff", "check"], ["ruff", "format", "--check"], ["mypy"]):
        run(project, *command, "components/scenes/friction")
    run(project, "tools.house_rules")
    files = [f"tests/scenes/test_{name}.py" for name in ("friction", "every_scene", "presets", "drawn")]
    files += [f"tests/page/test_{name}.py" for name in ("names", "covers", "opening", "frames")]
    told = run(project, "pytest", "-q", "-p", "no:cacheprovider", "-k", "friction", *files)
    passed = re.search(r"(\d+) passed", told)
    assert passed and int(passed[1]) >= 12, told


@pytest.mark.browser
@pytest.mark.slow
@pytest.mark.timeout(300)
def test_the_scene_of_the_tutorial_is_served_and_drawn(project: Path) -> None:
    """Nothing is wrong in its view, and a phone's first screen shows everything that its tasks name."""
    told = run(project, "pytest", "-q", "-p", "no:cacheprovider", "-k", "friction", "tests/browser/test_views.py")
    assert " passed" in told and "skipped" not in told, told


NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))
STEPPED = "against-scipy"
"""Its digits are not compared: the rounding errors of SciPy differ between machines."""
FIGURES = {"a-scene": "panel.models.widgets.Player", "a-sweep": "Figure"}
"""The model that is stored with a notebook, so that its figures are readable without running anything."""


def shown(notebook: Any, kind: str = "text/plain") -> str:
    """Join all outputs of a kind: a kernel splits printed text arbitrarily."""
    found = (output for cell in notebook.cells for output in cell.get("outputs", ()))
    return "".join(output.get("text", "") or output.get("data", {}).get(kind, "") for output in found)


@pytest.mark.slow  # it starts a kernel, whose client leaves open what the warnings are about
@pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::DeprecationWarning")
@pytest.mark.parametrize("path", sample(NOTEBOOKS, 6), ids=lambda path: path.stem)
def test_a_notebooks_stored_outputs_are_current(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PYTHONPATH", str(ROOT))  # as if the lecture were installed, which the notebooks expect
    # Importing this compiles grammars for two seconds, so it happens only when the test runs.
    import nbformat
    from nbclient import NotebookClient

    notebook = nbformat.read(path, as_version=4)
    stored = shown(notebook)
    assert stored and rf"\"name\":\"{FIGURES.get(path.stem, '')}" in path.read_text("utf-8")
    NotebookClient(notebook, timeout=60, resources={"metadata": {"path": str(path.parent)}}).execute()
    assert path.stem != "a-scene" or "Slider" in shown(notebook, "text/html")
    digits = re.compile(r"\d+" if path.stem == STEPPED else "$^")
    assert digits.sub("#", shown(notebook)) == digits.sub("#", stored)


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
