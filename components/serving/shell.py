"""The page around a scene: its HTML template and the names of the static files, once a process."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache

from bokeh.document import Document
from jinja2 import Template

from components.scene import Scene
from components.serving.assets import folder_of, library_files, static_files
from components.serving.handlers import templates
from components.state.scene_sheet import sheet_address


@cache
def version() -> str:
    """A short hash of the static files: a new deployment is not mixed with files that a browser has kept."""
    return folder_of(static_files())


def library() -> str:
    """The address of BokehJS."""
    files = library_files()
    (name,) = files
    return f"assets/{folder_of(files)}/{name}"


@cache
def page_template() -> Template:
    """page.html, to which everything that is the same for every visitor is already known."""
    files = {"version": version(), "library": library()}
    return templates().get_template("page.html", globals=files)


@cache
def follow_template() -> Template:
    """follow.html, the page of who follows a class: the same for all."""
    files = {"version": version(), "library": library()}
    return templates().get_template("follow.html", globals=files)


LECTURES = {"D31": "Linear Harmonic Oscillator", "D34": "Coupled Oscillators"}
"""The lectures of the MIT course 16.07, Dynamics, that the scenes follow, by number."""


def navigation(scenes: Mapping[str, type[Scene]], here: str) -> list[dict[str, object]]:
    """The scenes in lecture order, grouped under the lecture they belong to."""
    groups: list[dict[str, object]] = []
    for slug, scene in scenes.items():
        if not groups or groups[-1]["lecture"] != scene.lecture:
            title = LECTURES.get(scene.lecture)
            about = f"Lecture {scene.lecture} of the MIT course 16.07, Dynamics: {title}" if title else ""
            groups.append({"lecture": scene.lecture, "about": about, "scenes": []})
        entry = {"slug": slug, "title": scene.title, "sheet": sheet_address(scene), "here": slug == here}
        groups[-1]["scenes"].append(entry)  # type: ignore[attr-defined]
    return groups


def when_open(document: Document, act: Callable[[], None]) -> None:
    """Run `act` under the document's lock, from any thread, as long as somebody looks at the page."""
    context = document.session_context
    if context and context.session.connection_count:
        document.add_next_tick_callback(act)
