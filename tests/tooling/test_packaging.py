"""The package: the files of its wheel, a server that starts from it outside the checkout, and the container's packages.

The container's packages are reduced: the page is built and every method runs without the removed files.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tomllib
import venv
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path
from subprocess import PIPE
from urllib.request import urlopen
from zipfile import ZipFile

import pytest

from components.scenes.accuracy.measuring import LIVE
from physics.integrators.accuracy import SYSTEMS
from physics.integrators.accuracy_worker import encoded_system
from tests.serving.server import ROOT, free_port, serving
from tools.cut import cut

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
PIP = (sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check")
MADE = "import app, components.serving.__main__; from components.scenes import SCENES; [S() for S in SCENES.values()]"


def test_the_citation_has_the_version_and_licence_of_the_package() -> None:
    cited = dict(re.findall(r"^(\w+): (\S+)$", (ROOT / "CITATION.cff").read_text(encoding="utf-8"), re.M))
    assert (cited["version"], cited["license"]) == (PROJECT["version"], PROJECT["license"])


@pytest.mark.slow
@pytest.mark.timeout(300)  # pip installs a package
def test_an_installed_lecture_has_its_files_and_serves_its_first_page(tmp_path: Path) -> None:
    alone = ("--no-deps", "--no-index", "--no-build-isolation")
    subprocess.run([*PIP, "wheel", *alone, "--wheel-dir", tmp_path, ROOT], check=True)
    (wheel,) = tmp_path.glob("*.whl")
    folders = (ROOT / name for name in ("components", "physics", "static"))
    files = (path for folder in folders for path in folder.rglob("*") if path.is_file() and path.suffix != ".pyc")
    wanted = {"app.py", "reading.py", *(path.relative_to(ROOT).as_posix() for path in files)}
    assert {name for name in ZipFile(wheel).namelist() if ".dist-info/" not in name} == wanted
    venv.create(tmp_path / "env", with_pip=False)
    (python,) = tmp_path.glob("env/*/python")
    subprocess.run([*PIP, "--python", python, "install", "--no-deps", "--no-index", wheel], check=True)
    (packages,) = tmp_path.glob("env/lib/*/site-packages")
    # The requirements of the lecture are installed there.
    (packages / "needs.pth").write_text(sysconfig.get_path("purelib"))
    port = free_port()
    command = [str(python.parent / "oscillations"), "--address", "127.0.0.1", "--port", str(port)]
    with serving(tmp_path / "log", port=port, command=command, folder=tmp_path) as server:
        for link in ("", "?scene=coupled", "?walk=d34"):
            assert b"</html>" in urlopen(server.url + link, timeout=20).read()
        assert b"x1 [m]" in urlopen(server.url + "data.csv?scene=coupled", timeout=60).read()  # of the worker process
    assert not server.complaints()


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
    """Return the output of a Python process that has only these packages and gets an order on its standard input."""
    environment = {**os.environ, "PYTHONPATH": str(packages), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-S", *arguments]
    with subprocess.Popen(command, cwd=ROOT, env=environment, stdin=PIPE, stdout=PIPE, text=True) as process:
        assert process.stdin and process.stdout
        process.stdin.write(order + "\n")
        process.stdin.flush()
        return process.stdout.read()


@pytest.mark.slow
def test_every_scene_is_made_and_every_method_runs_with_the_reduced_packages(packages: Path) -> None:
    assert run(packages, "-c", MADE + "; print('made')") == "made\n"
    order = {"system": encoded_system(SYSTEMS["benign"]), "seconds": 0.01, "budget": 60, "methods": list(LIVE)}
    said = run(packages, "-m", "physics.integrators.accuracy_worker", order=json.dumps(order)).splitlines()
    assert {line["run"]["method"] for line in map(json.loads, said) if "run" in line} == set(LIVE)
