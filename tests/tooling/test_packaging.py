"""The package: the files of its wheel, and a server that starts from it outside the checkout."""

from __future__ import annotations

import re
import subprocess
import sys
import sysconfig
import tomllib
import venv
from pathlib import Path
from urllib.request import urlopen
from zipfile import ZipFile

import pytest

from tests.serving.server import ROOT, free_port, serving

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
PIP = (sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check")


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    alone = ("--no-deps", "--no-index", "--no-build-isolation")
    subprocess.run([*PIP, "wheel", *alone, "--wheel-dir", folder, ROOT], check=True)
    (built,) = folder.iterdir()
    return built


def test_the_citation_has_the_version_and_licence_of_the_package() -> None:
    cited = dict(re.findall(r"^(\w+): (\S+)$", (ROOT / "CITATION.cff").read_text(encoding="utf-8"), re.M))
    assert (cited["version"], cited["license"]) == (PROJECT["version"], PROJECT["license"])


@pytest.mark.slow
def test_a_wheel_has_all_files_the_lecture_reads(wheel: Path) -> None:
    folders = (ROOT / name for name in ("components", "physics", "static"))
    files = (path for folder in folders for path in folder.rglob("*") if path.is_file() and path.suffix != ".pyc")
    wanted = {"app.py", "reading.py", *(path.relative_to(ROOT).as_posix() for path in files)}
    assert {name for name in ZipFile(wheel).namelist() if ".dist-info/" not in name} == wanted


@pytest.mark.slow
def test_an_installed_lecture_serves_its_first_page(wheel: Path, tmp_path: Path) -> None:
    venv.create(tmp_path / "env", with_pip=False)
    (python,) = tmp_path.glob("env/*/python")
    subprocess.run([*PIP, "--python", python, "install", "--no-deps", "--no-index", wheel], check=True)
    (packages,) = tmp_path.glob("env/lib/*/site-packages")
    (packages / "needs.pth").write_text(
        sysconfig.get_path("purelib")
    )  # the requirements of the lecture are installed there
    port = free_port()
    command = [str(python.parent / "oscillations"), "--address", "127.0.0.1", "--port", str(port)]
    with serving(tmp_path / "log", port=port, command=command, folder=tmp_path) as server:
        for link in ("", "?scene=coupled", "?walk=d34"):
            assert b"</html>" in urlopen(server.url + link, timeout=20).read()
        assert b"x1 [m]" in urlopen(server.url + "data.csv?scene=coupled", timeout=60).read()  # of the worker process
    assert not server.complaints()
