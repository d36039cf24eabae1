"""The page around a scene: its HTML template and the names of the static files, read once per process."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from itertools import groupby

from bokeh.document import Document
from jinja2 import Template

from components.scene import Scene
from components.serving.assets import BOKEH, folder_of, library_files, static_files, written_scripts
from components.serving.handlers import templates
from components.serving.scripts import needed_later
from components.state.scene_sheet import sheet_address


@cache
def version() -> str:
    """A short hash of the static files. It keeps a new deployment apart from files that a browser has cached."""
    return folder_of(static_files())


def library() -> str:
    """The address of BokehJS."""
    return f"assets/{folder_of(library_files())}/{BOKEH.name}"


@cache
def page_template() -> Template:
    """The template page.html, filled with everything that is the same for every visitor."""
    modules = needed_later("walks/walk.js", written_scripts())
    files = {"version": version(), "library": library(), "walk_modules": modules}
    return templates().get_template("page.html", globals=files)


@cache
def follow_template() -> Template:
    """The page follow.html of a phone in a class, which is the same for everyone."""
    files = {"version": version(), "library": library()}
    return templates().get_template("follow.html", globals=files)


LECTURES = {
    "D31": "Linear Harmonic Oscillator",
    "D32, D33": "Damped Free Vibration, Forced Vibration",
    "D34": "Coupled Oscillators",
}
"""The lectures of the MIT course 16.07, Dynamics, that the scenes follow, by number."""
SUBJECTS = {
    "D31": "One mass on a spring",
    "D32, D33": "Friction, and a push",
    "D34": "Two masses",
    "Many": "Many masses",
    "Numerics": "How computers solve it",
}
"""The headings of the start page, by lecture."""


@dataclass(frozen=True)
class SceneLink:
    """A scene in the navigation and on the start page."""

    slug: str
    title: str
    claim: str
    sheet: str
    here: bool


@dataclass(frozen=True)
class SceneGroup:
    """The scenes of one lecture: its name, its subject and its title."""

    name: str
    subject: str
    about: str
    scenes: tuple[SceneLink, ...]

    @property
    def here(self) -> bool:
        """Return True if the current scene is one of them."""
        return any(scene.here for scene in self.scenes)


def navigation(scenes: Mapping[str, type[Scene]], here: str = "") -> list[SceneGroup]:
    """The scenes in lecture order, grouped under the lecture they belong to."""
    return [
        SceneGroup(name, SUBJECTS.get(name, name), _about(name), tuple(_link(scene, here) for scene in group))
        for name, group in groupby(scenes.values(), key=lambda scene: scene.lecture)
    ]


def _about(lecture: str) -> str:
    title = LECTURES.get(lecture)
    return f"Lecture {lecture} of the MIT course 16.07, Dynamics: {title}" if title else ""


def _link(scene: type[Scene], here: str) -> SceneLink:
    return SceneLink(scene.slug, scene.title, scene.headline, sheet_address(scene), scene.slug == here)


def when_open(document: Document, act: Callable[[], None]) -> None:
    """Run `act` under the document's lock, from any thread, unless the visitor has left the page."""
    context = document.session_context
    if context and context.session.connection_count:
        document.add_next_tick_callback(act)
