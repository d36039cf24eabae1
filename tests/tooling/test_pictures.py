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


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "tools.pictures", *arguments]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True)


@pytest.mark.nightly
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
