"""docs/adding-a-scene.md is correct: its code makes a scene that is typed, tested, served and drawn."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.serving.server import ROOT
from tools.trials import copied

TUTORIAL = ROOT / "docs" / "adding-a-scene.md"
REGISTRY = "components/scenes/__init__.py"


def code() -> dict[str, str]:
    """Return the code of the page by file. A block belongs to the file of its last `# name` line."""
    found: dict[str, str] = {}
    name = ""
    for block in re.findall(r"```python\n(.*?)```", TUTORIAL.read_text(encoding="utf-8"), re.S):
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
    for name, text in code().items():
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
def test_the_scene_is_typed_and_passes_its_own_tests_and_those_of_every_scene(project: Path) -> None:
    for command in (["ruff", "check"], ["ruff", "format", "--check"], ["mypy"]):
        run(project, *command, "components/scenes/friction")
    run(project, "tools.house_rules")
    files = [f"tests/scenes/test_{name}.py" for name in ("friction", "every_scene", "presets", "grabs", "traces")]
    files += [f"tests/page/test_{name}.py" for name in ("names", "covers", "opening", "frames")]
    told = run(project, "pytest", "-q", "-p", "no:cacheprovider", "-k", "friction", *files)
    passed = re.search(r"(\d+) passed", told)
    assert passed and int(passed[1]) >= 12, told


@pytest.mark.browser
@pytest.mark.slow
@pytest.mark.timeout(300)
def test_the_scene_is_served_and_drawn(project: Path) -> None:
    """Nothing is wrong in its view, and a phone's first screen shows everything that its tasks name."""
    told = run(project, "pytest", "-q", "-p", "no:cacheprovider", "-k", "friction", "tests/browser/test_views.py")
    assert " passed" in told and "skipped" not in told, told
