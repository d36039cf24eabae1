"""README: tests run its commands, its figures agree with the measured ones, its links work."""

from __future__ import annotations

import os
import re
import subprocess
import time
from pathlib import Path
from urllib.request import urlopen

import pytest
from PIL import Image

from tests.grids import spread
from tests.serving.server import ROOT, free_port
from tools.animation import MOST_BYTES, MOVING

README = (ROOT / "README.md").read_text(encoding="utf-8")
MEASURED = (ROOT / "docs" / "measured.md").read_text(encoding="utf-8")
COMMANDS = "tests/tooling/test_commands.py"
TRIED = {
    "make run": "tests/tooling/test_readme.py::test_make_run_serves_the_lecture",
    "make run PORT=8000": "tests/tooling/test_readme.py::test_make_run_serves_the_lecture",
    "make run HOST=0.0.0.0": "tests/tooling/test_readme.py::test_make_run_serves_the_lecture",
    "make test": f"{COMMANDS}::test_ci_runs_the_tests_of_the_readme",
    "docker build -t oscillations . && docker run -p 5006:5006 oscillations": (
        f"{COMMANDS}::test_the_container_serves_page_and_static_files"
    ),
    "make up REPLICAS=4 SITE=lecture.example": "tests/tooling/test_compose.py",
    "panel serve app.py": "tests/serving/test_panel_serve.py",
    "pip install .": "tests/tooling/test_packaging.py::test_an_installed_lecture_serves_its_first_page",
}
"""Each command of README and the test that runs it. Steps of the image run without a container engine."""
PATIENCE = 110.0


def commands(text: str) -> set[str]:
    """Return the commands of indented lines and of `code`."""
    lines = re.findall(r"^    (\S.*)$", text, re.M)
    coded = [code for code in re.findall(r"`([^`]+)`", text) if re.match(r"(make|docker|panel|python|pip) ", code)]
    said = re.findall(r"make run PORT=\d+", text)
    return {re.split(r"\s{2,}#|\s{3,}", line)[0].strip() for line in (*lines, *coded)} | set(said)


def test_every_command_is_run_by_a_test() -> None:
    assert commands(README) == TRIED.keys()
    for place in TRIED.values():
        path, _, name = place.partition("::")
        assert f"def {name}" in (ROOT / path).read_text(encoding="utf-8")


@pytest.mark.parametrize("more", spread([("HOST=0.0.0.0",), ()]))
def test_make_run_serves_the_lecture(more: tuple[str, ...]) -> None:
    port = free_port()
    plain = {name: value for name, value in os.environ.items() if not name.startswith(("MAKE", "MFLAGS", "DISPLAY"))}
    # The environment exists already: this test installs nothing.
    command = ["make", "run", f"PORT={port}", *more, "--old-file", ".venv/run.stamp"]
    process = subprocess.Popen(command, cwd=ROOT, env=plain, stdout=subprocess.DEVNULL, start_new_session=True)
    end = time.monotonic() + PATIENCE
    try:
        while True:
            try:
                with urlopen(f"http://localhost:{port}/") as page:
                    assert b"<title>" in page.read()
                return
            except OSError:
                assert time.monotonic() < end and process.poll() is None
                time.sleep(0.1)
    finally:
        os.killpg(process.pid, 15)
        process.wait()


def test_the_figures_agree_with_the_measured_ones() -> None:
    rows = re.findall(r"^\| ([^|]+) \| ([^|]+) \|$", README, re.M)
    figures = [(name, figure) for name, figure in rows if name not in ("what", "---")]
    assert len(figures) == 10
    for name, figure in figures:
        (row,) = [line for line in MEASURED.splitlines() if line.startswith(f"| {name} |")]
        assert f"| {figure} |" in row, name


def test_the_picture_moves_and_is_small() -> None:
    assert f"]({MOVING.relative_to(ROOT).as_posix()})" in README
    assert MOVING.stat().st_size <= MOST_BYTES
    with Image.open(MOVING) as picture:
        assert getattr(picture, "n_frames", 1) > 20


PAGES = [*ROOT.glob("*.md"), *ROOT.glob("docs/*.md")]


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.name)
def test_links_lead_to_existing_files(page: Path) -> None:
    for target in re.findall(r"\]\(([\w./-]+)(?:#[\w-]*)?\)", page.read_text(encoding="utf-8")):
        assert (page.parent / target).exists(), target
