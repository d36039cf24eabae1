"""Measurements of a walk in a browser: `make walk ARGS=--look` reports what the last row of a hall cannot read."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from components.walks.loading import load_walks, read_walk, steps_of
from tests.serving.server import ROOT, Server, serving
from tools.look import faults

pytestmark = [pytest.mark.browser, pytest.mark.slow]
FLAT = """title = "Too flat"
[[step]]
id = "flat"
from = "d32-33-04"
state = "?scene=damped&zeta=1&frame.x=-2,2"
"""


@pytest.mark.timeout(600)  # sixteen steps, asked and answered, at two sizes
@pytest.mark.parametrize("name", sorted(load_walks(())))
def test_the_last_row_can_read_every_step(name: str, server: Server, browser: Browser) -> None:
    found = list(faults(load_walks(())[name], browser, server.url))
    assert not found, "\n".join(found)


def test_pictures_of_each_step_are_next_to_its_problems(tmp_path: Path) -> None:
    """In its own process, because this one already has a Playwright."""
    (tmp_path / "flat.toml").write_text(FLAT.replace("[[step]]", "[[step]]\ncover = []", 1), encoding="utf-8")
    command = [sys.executable, "-m", "tools.walk", "flat.toml", "--pictures"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    told = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert told.returncode == 1, told.stderr
    folder = tmp_path / "build" / "walk" / "flat"
    names = {f"01-flat-{when}-{size}.png" for when in ("question", "answer") for size in ("hall", "phone")}
    assert {one.name for one in folder.glob("*.png")} == names
    page = (folder / "index.html").read_text(encoding="utf-8")
    assert all(f'src="{name}"' in page for name in names) and "cover: nothing is hidden" in page
    assert "build/walk/flat/index.html has its pictures" in told.stdout


def test_a_curve_that_is_too_flat_is_reported_with_its_step_and_size(tmp_path: Path, browser: Browser) -> None:
    (tmp_path / "flat.toml").write_text(FLAT, encoding="utf-8")
    walk = read_walk(FLAT, "flat", steps_of(load_walks(()).values()))
    with serving(tmp_path / "log", environment={"WALKS": str(tmp_path)}) as server:
        found = list(faults(walk, browser, server.url))
    for size in ("1280 x 720", "853 x 480"):
        start = f"flat, step 1 (flat), question at {size}: plot x: its curves use "
        assert [fault for fault in found if fault.startswith(start) and fault.endswith("10% are the least.")]
