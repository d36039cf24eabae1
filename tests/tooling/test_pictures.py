"""The tool that compares pictures before and after a change: the pages it visits and the differences it lists."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from components.scenes import SCENES
from components.state.page_state import fitted
from tests.serving.server import ROOT
from tools.pictures import differing

WIDE, HIGH = 200, 100


def picture(folder: Path, pixels: int = 0, level: int = 0, size: tuple[int, int] = (HIGH, WIDE)) -> None:
    """A grey picture in which `pixels` pixels are greener by `level`."""
    folder.mkdir(exist_ok=True)
    grey = np.full((*size, 3), 100, np.uint8)
    grey.reshape(-1, 3)[:pixels, 1] += level
    Image.fromarray(grey).save(folder / "one.png")


@pytest.mark.parametrize(
    ("pixels", "level", "listed"),
    [
        (WIDE * HIGH, 32, []),
        (20, 100, []),
        (21, 33, ["one.png: 0.10% of the pixels, from (0, 0) to (20, 0)"]),
        (3 * WIDE, 33, ["one.png: 3.00% of the pixels, from (0, 0) to (199, 2)"]),
    ],
)
def test_visible_differences_are_listed(tmp_path: Path, pixels: int, level: int, listed: list[str]) -> None:
    picture(tmp_path / "before")
    picture(tmp_path / "after", pixels, level)
    assert list(differing(tmp_path / "before", tmp_path / "after")) == listed


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "tools.pictures", *arguments]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True)


@pytest.mark.slow
@pytest.mark.browser
@pytest.mark.timeout(400)  # two servers start
def test_two_runs_of_one_commit_agree(browser: object, tmp_path: Path) -> None:
    view = fitted(SCENES["modes"].at()).query
    folders = [str(tmp_path / name) for name in ("before", "after")]
    for folder in folders:
        # After the answer, this step still hides quantities that later steps ask for.
        shot = run("shoot", folder, "--only", f"^({re.escape(view)}|walk d34-01)$")
        assert shot.stdout.startswith("9 pictures in "), shot.stderr
    same = run("compare", *folders)
    assert (same.returncode, same.stdout) == (0, "No picture differs.\n")
    (path,) = (tmp_path / "after").glob("scene*-desk.png")
    Image.fromarray(255 - np.asarray(Image.open(path))).save(path)
    other = run("compare", *folders)
    assert other.returncode == 1
    assert re.fullmatch(rf"{re.escape(path.name)}: \d+\.\d+% of the pixels, .*\n", other.stdout)
