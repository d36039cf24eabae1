"""The reduced packages of the container: the page is built and every method runs without the removed files."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path
from subprocess import PIPE

import pytest

from components.scenes.accuracy.measuring import LIVE
from physics.integrators.accuracy import SYSTEMS
from physics.integrators.accuracy_worker import encoded_system
from tests.serving.server import ROOT
from tools.cut import cut


@pytest.fixture(scope="module")
def packages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The packages that the app requires, as installed here, after the cut."""
    folder = tmp_path_factory.mktemp("packages")
    for name in re.findall(r"^([a-z0-9-]+)==", (ROOT / "requirements.txt").read_text(), re.M):
        try:
            files = distribution(name).files or []
        except PackageNotFoundError:  # for another system or Python version
            continue
        for file in files:
            source = Path(str(file.locate()))
            if ".." not in file.parts and source.exists():  # bytecode may be missing
                (folder / file).parent.mkdir(parents=True, exist_ok=True)
                try:
                    os.link(source, folder / file)
                except OSError:  # on another disk
                    shutil.copy2(source, folder / file)
    assert sum(saved for _, saved in cut(folder)) > 100
    return folder


def run(packages: Path, *arguments: str, order: str = "") -> str:
    """Return the output of a Python process that has only these packages and gets an order on its open standard
    input.
    """
    environment = {**os.environ, "PYTHONPATH": str(packages), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-S", *arguments]
    with subprocess.Popen(command, cwd=ROOT, env=environment, stdin=PIPE, stdout=PIPE, text=True) as process:
        assert process.stdin and process.stdout
        process.stdin.write(order + "\n")
        process.stdin.flush()
        return process.stdout.read()


@pytest.mark.slow
def test_every_scene_is_made(packages: Path) -> None:
    made = (
        "import app, components.serving.__main__; from components.scenes import SCENES; [S() for S in SCENES.values()]"
    )
    assert run(packages, "-c", made + "; print('made')") == "made\n"


@pytest.mark.slow
def test_every_method_runs(packages: Path) -> None:
    order = {"system": encoded_system(SYSTEMS["benign"]), "seconds": 0.01, "budget": 60, "methods": list(LIVE)}
    said = run(packages, "-m", "physics.integrators.accuracy_worker", order=json.dumps(order)).splitlines()
    assert {line["run"]["method"] for line in map(json.loads, said) if "run" in line} == set(LIVE)
