"""The page around a scene: its HTML template and the names of the static files, once a process."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING

from jinja2 import Environment, FileSystemLoader, Template

if TYPE_CHECKING:
    from components.scene import Scene

STATIC = Path(__file__).parent.parent / "static"


@cache
def version() -> str:
    """A short hash of the static files: a new deployment is not mixed with files that a browser has kept."""
    content = b"".join(path.read_bytes() for path in sorted(STATIC.iterdir()) if path.is_file())
    return sha256(content).hexdigest()[:12]


@cache
def page_template() -> Template:
    folder = Path(__file__).parent
    return Environment(loader=FileSystemLoader(folder), autoescape=True).get_template("page.html")


def navigation(scenes: Mapping[str, type[Scene]], here: str) -> list[dict[str, object]]:
    """The scenes in lecture order, grouped under the lecture they belong to."""
    groups: list[dict[str, object]] = []
    for slug, scene in scenes.items():
        if not groups or groups[-1]["lecture"] != scene.lecture:
            groups.append({"lecture": scene.lecture, "scenes": []})
        entry = {"slug": slug, "title": scene.title, "here": slug == here}
        groups[-1]["scenes"].append(entry)  # type: ignore[attr-defined]
    return groups


def when_open(document: Document, act: Callable[[], None]) -> None:
    """Run `act` under the document's lock, from any thread, as long as somebody looks at the page."""
    context = document.session_context
    if context and context.session.connection_count:
        document.add_next_tick_callback(act)
