"""Documents: tests run the code of the tutorial, figures agree with the measured ones, and all that is named exists."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.serving.server import ROOT
from tools.house_rules import code
from tools.trials import copied

PATHS = [*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")]
DOCS = {path.relative_to(ROOT).as_posix(): path.read_text("utf-8") for path in PATHS}
README, MEASURED = DOCS["README.md"], DOCS["docs/measured.md"]


def test_the_figures_of_readme_agree_with_the_measured_ones() -> None:
    rows = re.findall(r"^\| ([^|]+) \| ([^|]+) \|$", README, re.M)
    figures = [(name, figure) for name, figure in rows if name not in ("what", "---")]
    assert len(figures) == 10
    for name, figure in figures:
        (row,) = [line for line in MEASURED.splitlines() if line.startswith(f"| {name} |")]
        assert f"| {figure} |" in row, name


@pytest.mark.parametrize("page", DOCS)
def test_links_lead_to_existing_files(page: str) -> None:
    for target in re.findall(r"\]\(([\w./-]+)(?:#[\w-]*)?\)", DOCS[page]):
        assert ((ROOT / page).parent / target).exists(), target


def test_files_named_in_code_and_documents_exist() -> None:
    texts = [*DOCS.values(), *(path.read_text("utf-8") for path in (ROOT / "types").glob("*.ts"))]
    texts += [source.text for source in code() if source.is_product]
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


def taught_code() -> dict[str, str]:
    """Return the code of docs/adding-a-scene.md by file. A block belongs to the file of its last `# name` line."""
    found: dict[str, str] = {}
    name = ""
    for block in re.findall(r"```python\n(.*?)```", DOCS["docs/adding-a-scene.md"], re.S):
        first, _, rest = block.partition("\n")
        if first.startswith("# ") and first.endswith(".py"):
            name, block = first.removeprefix("# "), rest
            found[name] = block
        else:
            found[name] += "\n\n" + block
    return found


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the project, extended as the page says."""
    folder = copied(ROOT, tmp_path_factory.mktemp("copy") / "project")
    if (ROOT / ".mypy_cache").exists():  # mypy then checks only the new files
        shutil.copytree(ROOT / ".mypy_cache", folder / ".mypy_cache")
    for name, text in taught_code().items():
        file = folder / name
        file.parent.mkdir(exist_ok=True)
        file.write_text(registered(text.strip()) if name == REGISTRY else text, encoding="utf-8")
    return folder


def registered(line: str) -> str:
    """Return the registry with the scene."""
    text = (ROOT / REGISTRY).read_text(encoding="utf-8").replace("\nSCENES: dict", f"{line}\n\nSCENES: dict")
    assert text.count("        Accuracy,\n") == 1, "the list of scenes ends as it did when this was written"
    return text.replace("        Accuracy,\n", "        Accuracy,\n        Friction,\n")


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
