"""The size of Python code: tokens and lines without comments, docstrings and blank lines."""

from __future__ import annotations

from pathlib import Path

from components.scenes import SCENES
from tests.serving.server import ROOT
from tools.size import Size, kits_of, size_of, sizes

CODE = '''"""A module."""

# A comment.
WIDE = 3  # of the stage
"""The width."""


def wide() -> str:
    """Return it."""
    return """two
lines"""
'''


def test_only_code_is_counted(tmp_path: Path) -> None:
    (tmp_path / "inner").mkdir()
    (tmp_path / "inner" / "one.py").write_text(CODE, encoding="utf-8")
    (tmp_path / "two.py").write_text("x = 1\n", encoding="utf-8")
    assert size_of([tmp_path / "two.py"]) == Size(tokens=3, lines=1, files=1)
    assert size_of([tmp_path]) == Size(tokens=15, lines=5, files=2)


def test_every_scene_is_counted_with_its_kits() -> None:
    found = sizes()
    assert found.keys() >= set(SCENES)
    assert found["damped with dashpot"].tokens > found["damped"].tokens > 0
    folders = {path.name: path for path in (ROOT / "components" / "scenes").iterdir() if path.is_dir()}
    assert (kits_of(folders["coupled"]), kits_of(folders["damped"])) == (["chain"], ["dashpot"])
