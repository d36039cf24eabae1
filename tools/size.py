"""`python -m tools.size` counts the Python of each scene, of its kits, and of the rooms that all scenes share.

It prints tokens, lines and files. Comments, docstrings and blank lines do not count, and neither do line breaks.
`python -m tools.size PATH ...` counts other files or folders.
"""

from __future__ import annotations

import ast
import sys
import tokenize
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
SCENES, KITS = ROOT / "components" / "scenes", ("chain", "dashpot")
ROOMS = ("components/paper", "components/scene", "components/layout", "components/quantities", "physics")
LAYOUT = {
    tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENCODING,
    tokenize.ENDMARKER,
}  # fmt: skip
"""Kinds of tokens that do not count."""


class Size(NamedTuple):
    """The size of some Python code."""

    tokens: int
    lines: int
    files: int


def size_of(paths: Iterable[Path]) -> Size:
    """Return the size of files, or of all files in folders."""
    files = sorted({file for path in paths for file in (path.rglob("*.py") if path.is_dir() else [path])})
    counts = [_count(file) for file in files]
    return Size(sum(tokens for tokens, _ in counts), sum(lines for _, lines in counts), len(files))


def _count(file: Path) -> tuple[int, int]:
    """The tokens of a file and its lines that hold some."""
    docs = _docstring_lines(ast.parse(file.read_text(encoding="utf-8")))
    with file.open("rb") as source:
        found = [one for one in tokenize.tokenize(source.readline) if one.type not in LAYOUT]
    code = [one for one in found if one.type != tokenize.STRING or one.start[0] not in docs]
    lines = {line for one in code for line in range(one.start[0], one.end[0] + 1)}
    return len(code), len(lines)


def _docstring_lines(tree: ast.Module) -> set[int]:
    """Return the first lines of docstrings, including docstrings of constants."""
    alone = (node.value for node in ast.walk(tree) if isinstance(node, ast.Expr))
    return {one.lineno for one in alone if isinstance(one, ast.Constant) and isinstance(one.value, str)}


def kits_of(scene: Path) -> list[str]:
    """Return the kits that the files of a scene import."""
    texts = [file.read_text(encoding="utf-8") for file in scene.rglob("*.py")]
    return [kit for kit in KITS if any(f"components.{kit}" in text or f"import {kit}" in text for text in texts)]


def sizes() -> dict[str, Size]:
    """Return the size of each scene, of each with its kits, and of the shared rooms."""
    found = dict[str, Size]()
    for scene in sorted(path.parent for path in SCENES.glob("*/__init__.py")):
        found[scene.name] = size_of([scene])
        if kits := kits_of(scene):
            folders = [ROOT / "components" / kit for kit in kits]
            found[f"{scene.name} with {' and '.join(kits)}"] = size_of([scene, *folders])
    return found | {name: size_of([ROOT / name]) for name in (*(f"components/{kit}" for kit in KITS), *ROOMS)}


if __name__ == "__main__":
    given = [Path(name) for name in sys.argv[1:]]
    for name, size in ({str(path): size_of([path]) for path in given} or sizes()).items():
        print(f"{name:32} {size.tokens:7} tokens {size.lines:6} lines {size.files:3} files")
