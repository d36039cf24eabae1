"""Files around the code: locked requirements, commands of the documents, Dockerfile, package."""

import asyncio
import json
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tomllib
import venv
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path
from subprocess import PIPE
from urllib.request import urlopen
from zipfile import ZipFile

import pytest
from packaging.requirements import Requirement

from components.scenes.accuracy.measuring import LIVE
from physics.integrators.accuracy import SYSTEMS
from physics.integrators.accuracy_worker import encoded_system
from tests.serving.server import ROOT, START, Server, free_port, serving
from tests.serving.visitor import ask, refused, token_of
from tools.cut import cut
from tools.readme import table

LOCKS = ("requirements.txt", "requirements-notebook.txt", "requirements-test.txt")
PAGES = {name: (ROOT / name).read_text("utf-8") for name in ("README.md", "CONTRIBUTING.md", "docs/deployment.md")}
PLAIN = {name: text for name, text in os.environ.items() if not re.match("MAKE|MFLAGS|VENV|(ARGS|PORT|PYTHON)$", name)}
"""The environment without the settings of the make that runs these tests."""
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
DOCKERFILE = (ROOT / "Dockerfile").read_text(encoding="utf-8")
PIN = re.compile(
    r"^([a-z0-9-]+)(?:\[[\w,-]+\])?==([\w.]+)((?: ; [^\\]+)?) \\\n((?:    --hash=sha256:[0-9a-f]{64}(?: \\)?\n)+)", re.M
)


def make(*arguments: str) -> str:
    """Return the commands that make would run."""
    command = ["make", "--dry-run", *arguments]
    return subprocess.run(command, cwd=ROOT, env=PLAIN, check=True, capture_output=True, text=True).stdout


def instructions(name: str) -> list[str]:
    """Return the arguments of each instruction `name` of the Dockerfile, with continued lines joined."""
    return re.findall(rf"^{name} (.*)$", DOCKERFILE.replace("\\\n", " "), re.M)


def copied(recipe: str = DOCKERFILE) -> list[str]:
    """Return the files of the project that the Dockerfile copies."""
    lines = re.findall(r"^COPY (?!--from)(.*)$", recipe, re.M)
    return [source for line in lines for source in line.split()[:-1]]


@pytest.mark.parametrize("name", LOCKS)
def test_every_requirement_is_pinned_with_hashes_and_no_host_is_named(name: str) -> None:
    text = (ROOT / name).read_text()
    assert [line for line in PIN.sub("", text).splitlines() if not re.match(r" *#", line)] == []
    assert not re.search(r"://|--(extra-)?index|--find-links|--trusted-host|@ ", text)
    asked = {
        "requirements.txt": PROJECT["dependencies"],
        "requirements-notebook.txt": PROJECT["dependencies"] + PROJECT["optional-dependencies"]["notebook"],
        "requirements-test.txt": re.findall(r"^[a-z].*", (ROOT / "requirements-test.in").read_text(), re.M),
    }[name]
    assert {Requirement(need).name for need in asked} <= pinned(name).keys()
    app = pinned("requirements.txt")
    assert {p: v for p, v in pinned(name).items() if app.get(p, v) != v} == {}, "the locks agree"


def pinned(name: str) -> dict[str, str]:
    """Return the pinned version of each package."""
    return {package: version for package, version, *_ in PIN.findall((ROOT / name).read_text())}


def test_the_commands_of_the_pages_exist() -> None:
    targets = set(re.findall(r"(?:`|    )make ([a-z-]+)", "\n".join(PAGES.values())))
    assert {"run", "test", "load", "accuracy", "bench"} <= targets
    assert make(*targets)


def test_the_table_of_scenes_is_current() -> None:
    assert table() in (ROOT / "docs" / "scenes.md").read_text(encoding="utf-8"), "run make readme"


def test_all_starts_use_the_same_command_and_run_accepts_a_port() -> None:
    command, run = "python " + " ".join(START), make("run", "PORT=8000")
    for text in (run, PAGES["docs/deployment.md"], " ".join(json.loads(instructions("CMD")[-1]))):
        assert command in text
    assert "--port 8000" in run and "5006" not in run


@pytest.mark.slow
def test_make_run_serves_the_lecture(tmp_path: Path) -> None:
    port, unset = free_port(), dict.fromkeys(("MAKEFLAGS", "MAKELEVEL", "DISPLAY", "WAYLAND_DISPLAY"), "")
    # The environment exists already: this test installs nothing.
    command = ["make", "run", f"PORT={port}", "HOST=0.0.0.0", "--old-file", ".venv/run.stamp"]
    with serving(tmp_path / "log", port=port, command=command, environment=unset) as server:
        assert b"<title>" in urlopen(server.url).read()


FAKE_PYTHON = """#!/bin/sh
test "$1 $2" = "-m venv" && shift 2 || exit 1
for folder; do :; done
case "$*" in *--clear*) rm -rf "$folder"/*;; esac
mkdir -p "$folder/bin" && printf '#!/bin/sh\\n' > "$folder/bin/pip" && chmod +x "$folder/bin/pip"
"""
"""Creates what make needs of a virtual environment; building a real one takes long."""
FOLDERS: dict[str, list[str] | None] = {
    "missing": None,
    "empty": [],
    "a virtual environment of somebody": ["bin/pip", "lib/theirs", "pyvenv.cfg"],
    "the same, used by make before": ["bin/pip", "lib/theirs", "run.stamp"],
    "a folder of something else": ["letter.txt"],
    "a virtual environment without pip": ["bin/python", "lib/theirs"],
}


@pytest.mark.parametrize("linked", [False, True])
@pytest.mark.parametrize("names", FOLDERS.values(), ids=FOLDERS)
def test_make_removes_nothing_that_it_did_not_create(tmp_path: Path, names: list[str] | None, linked: bool) -> None:
    """The folder has only the Makefile, and make gets a Python that does almost nothing."""
    for name in ("Makefile", *LOCKS):
        shutil.copy(ROOT / name, tmp_path)
    venv, there, python = tmp_path / "env", tmp_path / ("elsewhere" if linked else "env"), tmp_path / "python"
    theirs = {there / name: f"# {name}\n" for name in names or ()}
    for path in [there / "any", *theirs] if names is not None else ():
        path.parent.mkdir(parents=True, exist_ok=True)
    for path, text in [*theirs.items(), (python, FAKE_PYTHON)]:
        path.write_text(text)
        path.chmod(0o755)
        os.utime(path, (0, 0))
    if linked and there.exists():
        venv.symlink_to(there)
    usable = not theirs or there / "bin/pip" in theirs
    for target in ("env/run.stamp", "clean", "env/run.stamp"):
        command = ["make", f"PYTHON={python}", "VENV=env", target]
        ran = subprocess.run(command, cwd=tmp_path, env=PLAIN, capture_output=True, text=True)
        assert {path: path.read_text() for path in theirs} == theirs
        if target == "clean":
            assert ran.returncode == 0 and (bool(theirs) == ("stays" in ran.stdout)) and venv.exists() == bool(theirs)
        else:
            assert (ran.returncode == 0) == usable, ran.stderr
            assert usable or "is not empty and no virtual environment" in ran.stdout


# The container. There may be no container engine, so the Dockerfile is linted and its steps run in a clean folder.


def test_the_dockerfile_is_clean_installs_by_hash_from_a_pinned_base_and_runs_as_a_user() -> None:
    hadolint = Path(sys.executable).parent / "hadolint"
    result = subprocess.run([hadolint, "Dockerfile"], cwd=ROOT, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr
    runs = instructions("RUN")
    assert any("--require-hashes" in line and "requirements.txt" in line for line in runs)
    assert any("pip uninstall --yes" in line for line in runs)
    (user,), (base,) = instructions("USER"), instructions("ARG")
    assert any(f"useradd --create-home --uid {user} " in line for line in runs)
    assert re.fullmatch(r"BASE=python:[\w.-]+@sha256:[0-9a-f]{64}", base)
    assert [line.split()[0] for line in instructions("FROM")] == ["${BASE}"] * len(instructions("FROM"))


def test_the_build_context_has_only_the_copied_files() -> None:
    lines = (ROOT / ".dockerignore").read_text().splitlines()
    assert [line for line in lines if not line.startswith(("#", "!", "**/__pycache__"))] == ["*"]
    assert {line[1:] for line in lines if line.startswith("!")} == set(copied())


@contextmanager
def container_run(folder: Path, **settings: str) -> Iterator[Server]:
    """Run the Dockerfile's CMD with its ENV and `settings` on a read-only copy of its files."""
    folder.mkdir()
    for source in copied(DOCKERFILE.rpartition("\nFROM ")[2]):
        copy = shutil.copytree if (ROOT / source).is_dir() else shutil.copy
        copy(ROOT / source, folder / source)
    files = [folder, *folder.rglob("*")]
    for path in files:
        path.chmod(path.stat().st_mode & 0o555 | 0o444)
    port = free_port()
    environment = {
        **dict(pair.split("=", 1) for line in instructions("ENV") for pair in line.split()),
        "PORT": str(port),
        "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
        **settings,
    }
    command, log = [sys.executable, *json.loads(instructions("CMD")[-1])[1:]], folder.parent / "log"
    with serving(log, port=port, command=command, folder=folder, environment=environment) as running:
        yield running
        assert "Traceback" not in log.read_text()
    for path in files:
        path.chmod(0o755)


def _is_healthy(port: int, tries: int = 3) -> bool:
    """Return the result of the image's HEALTHCHECK; like Docker, it takes three failures."""
    (line,) = instructions("HEALTHCHECK")
    python, *check = json.loads(line[line.index("CMD") + 3 :])
    assert python == "python"
    there = {**os.environ, "PORT": str(port)}
    runs = (subprocess.run([sys.executable, *check], env=there, stderr=subprocess.DEVNULL) for _ in range(tries))
    return any(ran.returncode == 0 for ran in runs)


@pytest.mark.slow
def test_the_container_serves_page_and_static_files(tmp_path: Path) -> None:
    """It is healthy until it is asked to end, and accepts the allowed origins only."""
    settings = {"ALLOWED_ORIGIN": "lecture.example,second.example:8000", "NOTICE_SECONDS": "8"}
    with container_run(tmp_path / "app", **settings) as running:
        assets = set(re.findall(r'(?:href|src)="(assets/[^"]+)"', urlopen(running.url, timeout=90).read().decode()))
        assert assets
        for asset in assets:
            assert urlopen(running.url + asset, timeout=30).status == 200
        assert _is_healthy(running.port) and not _is_healthy(free_port())
        origins = {"lecture.example": 101, "second.example:8000": 101, f"localhost:{running.port}": 403}
        for origin, status in origins.items():
            token = token_of(ask(running.url, "/?scene=oscillator").text)
            assert asyncio.run(refused(running.url, token, {"Origin": f"http://{origin}"})) == status
        running.process.terminate()
        while _is_healthy(running.port, tries=1):
            assert running.process.poll() is None
        assert urlopen(f"{running.url}liveness", timeout=30).status == 200


# The package, which also runs outside the checkout, and the container's reduced packages.

PIP = (sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check")
MADE = "import app, components.serving.__main__; from components.scenes import SCENES; [S() for S in SCENES.values()]"


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
def test_every_scene_is_made_and_every_method_runs_with_the_reduced_packages(tmp_path: Path) -> None:
    for name in pinned("requirements.txt"):
        try:
            files = distribution(name).files or []
        except PackageNotFoundError:  # for another system or Python version
            continue
        for file in files:
            source = Path(str(file.locate()))
            if ".." not in file.parts and source.exists():  # bytecode may be missing
                (tmp_path / file).parent.mkdir(parents=True, exist_ok=True)
                try:
                    os.link(source, tmp_path / file)
                except OSError:  # on another disk
                    shutil.copy2(source, tmp_path / file)
    assert sum(saved for _, saved in cut(tmp_path)) > 100
    assert run(tmp_path, "-c", MADE + "; print('made')") == "made\n"
    order = {"system": encoded_system(SYSTEMS["benign"]), "seconds": 0.01, "budget": 60, "methods": list(LIVE)}
    said = run(tmp_path, "-m", "physics.integrators.accuracy_worker", order=json.dumps(order)).splitlines()
    assert {line["run"]["method"] for line in map(json.loads, said) if "run" in line} == set(LIVE)
