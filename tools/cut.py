"""`python -m tools.cut FOLDER` removes files that this app never reads from a folder of packages, and says what that
saves.

The container is built with it: tests that packages bring along, scripts for panes and widgets that no page has, and
what only a developer of a script needs.
"""

from __future__ import annotations

import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

CUTS: dict[str, tuple[str, ...]] = {
    "scripts of Panel's": ("panel/dist/*", "panel_material_ui/dist/*"),
    "scripts of Bokeh's for other pages": ("bokeh/server/static/js/*", "bokeh/server/static/css/*"),
    "tests": ("*/tests", "*/*/tests", "*/*/*/tests"),
    "sources and types of scripts": ("panel/models/*.ts", "panel/node_modules", "panel/package-lock.json"),
    "headers and static libraries for building": ("numpy/_core/include", "numpy/_core/lib", "*/*.pyi"),
}
"""The files that are cut, as patterns below the folder, by kind."""
KEPT = ("bokeh/server/static/js/bokeh.min.js",)
"""The files among these that are served."""


def cut(folder: Path) -> Iterator[tuple[str, float]]:
    """Remove the files; return the kinds of removed files, each with the MB that it saves."""
    kept = {folder / name for name in KEPT}
    for name, patterns in CUTS.items():
        found = [path for pattern in patterns for path in folder.glob(pattern) if path not in kept]
        yield name, sum(_size(path) for path in found) / 1e6
        for path in found:
            shutil.rmtree(path) if path.is_dir() else path.unlink(missing_ok=True)


def _size(path: Path) -> int:
    files = path.rglob("*") if path.is_dir() else [path]
    return sum(file.stat().st_size for file in files if file.is_file())


if __name__ == "__main__":
    for name, saved in cut(Path(sys.argv[1])):
        print(f"{name}: {saved:.0f} MB")
