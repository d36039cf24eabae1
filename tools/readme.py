"""`python -m tools.readme` writes the tables of scenes in docs/scenes.md and of settings in docs/deployment.md, from
the code."""

from __future__ import annotations

import re
from pathlib import Path

from components.scenes import SCENES
from components.serving import settings

ROOT = Path(__file__).parents[1]


def table() -> str:
    """Return the table of scenes in order: link, part of the lecture, headline."""
    rows = [
        f"| `/?scene={slug}` | {scene.lecture}, {scene.points} | {scene.headline} |" for slug, scene in SCENES.items()
    ]
    return "\n".join(["| link | lecture | shows |", "|---|---|---|", *rows])


def write(name: str, first: str, rows: str) -> None:
    """Replace the table that has the same first column."""
    page = ROOT / name
    old = re.compile(rf"^\| {first} \|.*?(?=\n\n)", re.M | re.S)
    page.write_text(old.sub(lambda _: rows, page.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    write("docs/scenes.md", "link", table())
    write("docs/deployment.md", "setting", settings.table())
