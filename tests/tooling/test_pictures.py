"""The tool that compares pictures before and after a change: the pages it visits and the differences it lists."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.serving.server import ROOT

TOOL = (sys.executable, "-m", "tools.pictures")
run = partial(subprocess.run, cwd=ROOT, capture_output=True, text=True)


@pytest.mark.nightly
@pytest.mark.browser
@pytest.mark.timeout(400)  # a server starts
def test_a_changed_picture_is_listed(browser: object, tmp_path: Path) -> None:
    before, after = tmp_path / "before", tmp_path / "after"
    # After the answer, this step still hides quantities that later steps ask for.
    shot = run([*TOOL, "shoot", before, "--only", "^walk d34-01$"])
    assert " pictures in " in shot.stdout, shot.stderr
    shutil.copytree(before, after)
    path = next(after.glob("*-desk.png"))
    Image.fromarray(255 - np.asarray(Image.open(path))).save(path)
    assert re.fullmatch(
        rf"{re.escape(path.name)}: \d+\.\d+% of the pixels, .*\n", run([*TOOL, "compare", before, after]).stdout
    )
