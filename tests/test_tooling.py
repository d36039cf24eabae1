"""What surrounds the code: imports, locked requirements, README's commands, the container's recipe."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from http.client import HTTPConnection
from pathlib import Path
from urllib.request import urlopen

import grimp
import pytest

from components.scenes import SCENES
from tests.serving import FLAGS, ROOT, Server, free_port, serving

LOCKS = ("requirements.txt", "requirements-test.txt")
README = (ROOT / "README.md").read_text(encoding="utf-8")
DOCKERFILE = (ROOT / "Dockerfile").read_text(encoding="utf-8")
PIN = re.compile(r"^([a-z0-9-]+)==([\w.]+)((?: ; [^\\]+)?) \\\n((?:    --hash=sha256:[0-9a-f]{64}(?: \\)?\n)+)", re.M)


def make(*arguments: str, folder: Path = ROOT) -> str:
    """What make would do."""
    command = ["make", "--dry-run", *arguments]
    # What the make that runs these tests was given is not meant for this one.
    given = {"MAKEFLAGS", "MAKEOVERRIDES", "MAKELEVEL", "ARGS", "PORT", "PYTHON", "VENV"}
    plain = {name: value for name, value in os.environ.items() if name not in given}
    return subprocess.run(command, cwd=folder, env=plain, check=True, capture_output=True, text=True).stdout


def tool(name: str) -> str:
    """A command of the environment that runs the tests."""
    return str(Path(sys.executable).parent / name)


def instructions(name: str) -> list[str]:
    """The arguments of each instruction `name` of the Dockerfile, joined lines as one."""
    return re.findall(rf"^{name} (.*)$", DOCKERFILE.replace("\\\n", " "), re.M)


def copied() -> list[str]:
    return [source for line in instructions("COPY") for source in line.split()[:-1]]


# Imports


def test_only_scenes_and_the_page_import_scenes() -> None:
    graph = grimp.build_graph("components", "physics", cache_dir=None)
    scenes = {m for m in graph.modules if f"{m}.".startswith("components.scenes.")}
    assert scenes
    importers = {importer for scene in scenes for importer in graph.find_modules_that_directly_import(scene)}
    assert importers <= scenes


# Requirements


@pytest.mark.parametrize("name", LOCKS)
def test_every_requirement_is_pinned_and_hashed_and_no_host_is_named(name: str) -> None:
    text = (ROOT / name).read_text()
    rest = [line for line in PIN.sub("", text).splitlines() if not re.match(r" *#", line)]
    assert PIN.findall(text)
    assert rest == []
    assert not re.search(r"://|--(extra-)?index|--find-links|--trusted-host|@ ", text)


@pytest.mark.parametrize("name", LOCKS)
def test_the_lock_holds_what_is_asked_for(name: str) -> None:
    asked = re.findall(r"^([a-z][\w-]*)", (ROOT / name).with_suffix(".in").read_text(), re.M)
    pinned = {package for package, *_ in PIN.findall((ROOT / name).read_text())}
    assert asked
    assert set(asked) <= pinned


def test_both_locks_agree() -> None:
    app, test = ({p: v for p, v, *_ in PIN.findall((ROOT / name).read_text())} for name in LOCKS)
    assert {p: test[p] for p in app.keys() & test.keys()} == {p: app[p] for p in app.keys() & test.keys()}


# Commands


def test_the_commands_of_the_readme_exist() -> None:
    targets = set(re.findall(r"make ([a-z]+)", README))
    assert {"run", "test", "load", "accuracy", "bench"} <= targets
    for target in targets:
        assert make(target)


def test_the_readme_has_a_link_to_every_scene() -> None:
    assert re.findall(r"^\| `/\?scene=(\w+)` \|", README, re.M) == list(SCENES)


def test_every_way_to_start_serves_the_app_with_the_same_flags() -> None:
    flags = " ".join(FLAGS)
    for text in (make("run"), README, instructions("CMD")[-1]):
        assert f"panel serve {flags}" in text


def test_run_takes_a_port() -> None:
    command = make("run", "PORT=8000")
    assert "--port 8000 " in command
    assert "localhost:8000" in command
    assert "5006" not in command


def test_run_installs_once_and_again_when_the_lock_changes(tmp_path: Path) -> None:
    for name in ("Makefile", *LOCKS):
        shutil.copy(ROOT / name, tmp_path)
    assert "pip install" in make("run", folder=tmp_path)
    stamp = tmp_path / ".venv" / "run.stamp"
    stamp.parent.mkdir()
    stamp.touch()
    assert "pip install" not in make("run", folder=tmp_path)
    os.utime(stamp, (0, 0))
    assert "pip install" in make("run", folder=tmp_path)


def test_ci_runs_the_tests_of_the_readme() -> None:
    assert "\nmake test\n" in (ROOT / ".ci" / "run").read_text()
    assert os.access(ROOT / ".ci" / "run", os.X_OK)


# The container: there may be no engine, so its recipe is linted and its steps are walked in a clean folder.


def test_the_dockerfile_is_clean() -> None:
    result = subprocess.run([tool("hadolint"), "Dockerfile"], cwd=ROOT, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr


def test_the_container_installs_by_hash_and_runs_as_a_user() -> None:
    assert any("--require-hashes" in line and "requirements.txt" in line for line in instructions("RUN"))
    (user,) = instructions("USER")
    assert any(f"useradd --create-home --uid {user} " in line for line in instructions("RUN"))


def test_the_builder_is_sent_what_is_copied_and_nothing_else() -> None:
    lines = (ROOT / ".dockerignore").read_text().splitlines()
    assert [line for line in lines if not line.startswith(("#", "!", "**/__pycache__"))] == ["*"]
    assert {line[1:] for line in lines if line.startswith("!")} == set(copied())


@contextmanager
def walked(folder: Path, **settings: str) -> Iterator[Server]:
    """The Dockerfile's CMD, with its ENV and what `docker run -e` adds, in a folder with what it copies."""
    folder.mkdir(exist_ok=True)
    for source in copied():
        copy = shutil.copytree if (ROOT / source).is_dir() else shutil.copy
        copy(ROOT / source, folder / source)
    port = free_port()
    environment = {
        **dict(pair.split("=", 1) for line in instructions("ENV") for pair in line.split()),
        "PORT": str(port),
        "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
        **settings,
    }
    log = folder.with_suffix(".log")
    command = json.loads(instructions("CMD")[-1])
    with serving(log, port=port, command=command, folder=folder, environment=environment) as running:
        yield running
        assert "Traceback" not in log.read_text()


@pytest.fixture(scope="module")
def container(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    with walked(tmp_path_factory.mktemp("container")) as running:
        yield running


def test_the_container_is_healthy(container: Server) -> None:
    (line,) = instructions("HEALTHCHECK")
    check = json.loads(line[line.index("CMD") + 3 :])
    command = [sys.executable, *check[1:]]
    environment = {**os.environ, "PORT": str(container.port)}
    assert check[0] == "python"
    assert subprocess.run(command, env=environment).returncode == 0
    environment["PORT"] = str(free_port())
    assert subprocess.run(command, env=environment, stderr=subprocess.DEVNULL).returncode != 0


def test_the_container_serves_page_and_static_files(container: Server) -> None:
    page = urlopen(container.url, timeout=30).read().decode()
    assets = set(re.findall(r'(?:href|src)="(assets/[^"]+)"', page))
    assert assets
    for asset in assets:
        assert urlopen(container.url + asset, timeout=30).status == 200


def test_the_container_takes_no_visitors_from_elsewhere(container: Server) -> None:
    assert handshake(container, f"127.0.0.1:{container.port}") == 101
    assert handshake(container, f"localhost:{container.port}") == 101
    assert handshake(container, f"elsewhere.example:{container.port}") == 403


def test_the_container_takes_visitors_from_the_allowed_origins(tmp_path: Path) -> None:
    with walked(tmp_path / "container", ALLOWED_ORIGIN="lecture.example,second.example:8000") as running:
        assert handshake(running, "lecture.example") == 101
        assert handshake(running, "second.example:8000") == 101
        assert handshake(running, f"localhost:{running.port}") == 403


def handshake(server: Server, host: str) -> int:
    """The answer to a page's WebSocket, where `host` is what stands in the browser's address."""
    page = urlopen(server.url, timeout=30).read().decode()
    token = re.search(r'"token":"([^"]+)"', page)[1]
    headers = {
        "Connection": "Upgrade",
        "Upgrade": "websocket",
        "Origin": f"http://{host}",
        "Sec-WebSocket-Key": "MDEyMzQ1Njc4OWFiY2RlZg==",
        "Sec-WebSocket-Protocol": f"bokeh, {token}",
        "Sec-WebSocket-Version": "13",
    }
    connection = HTTPConnection("127.0.0.1", server.port, timeout=30)
    connection.request("GET", "/ws", headers=headers)
    try:
        return connection.getresponse().status
    finally:
        connection.close()
