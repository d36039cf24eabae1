"""The page around a scene: its HTML template and the names of the static files, once a process."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING

from bokeh.document import Document
from bokeh.server.views.static_handler import StaticHandler
from jinja2 import Environment, FileSystemLoader, Template
from panel.io.resources import JS_VERSION, LOCAL_DIST

if TYPE_CHECKING:
    from components.scene import Scene

STATIC = Path(__file__).parent.parent / "static"
LIBRARIES = ("bokeh", "bokeh-widgets", "bokeh-tables")
"""The parts of BokehJS that Panel's script cannot be without; a page of its own would ask for twice as much."""


@cache
def version() -> str:
    """A short hash of the static files: a new deployment is not mixed with files that a browser has kept."""
    content = b"".join(path.read_bytes() for path in sorted(STATIC.rglob("*")) if path.is_file())
    return sha256(content).hexdigest()[:12]


@cache
def modules() -> dict[str, str]:
    """Of each of our modules, by its address, the address with its version: the page's import map."""
    names = [path.relative_to(STATIC).as_posix() for path in sorted(STATIC.rglob("*.js"))]
    return {f"./assets/{name}": f"./assets/{name}?v={version()}" for name in names}


def preloaded() -> list[str]:
    """The addresses of those that every scene needs; what lies in static/later/ is fetched when it is asked for."""
    return [address for name, address in modules().items() if "/later/" not in name]


@cache
def libraries() -> tuple[str, ...]:
    """The addresses of the scripts of Bokeh and Panel."""
    bokeh = (f"static/{StaticHandler.append_version(f'js/{name}.min.js')}" for name in LIBRARIES)
    return *bokeh, f"{LOCAL_DIST}panel.min.js?v={JS_VERSION}"


@cache
def page_template() -> Template:
    """page.html, to which everything that is the same for every visitor is already known."""
    environment = Environment(loader=FileSystemLoader(Path(__file__).parent), autoescape=True)
    files = {"version": version(), "modules": modules(), "preloaded": preloaded(), "libraries": libraries()}
    return environment.get_template("page.html", globals=files)


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


def answer_at_once(document: Document) -> None:
    """Send every frame to those who look at the page when it is written.

    An answer is several small frames. By default TCP holds the later ones back until the browser has acknowledged the
    first, which it delays by up to 40 ms; Bokeh leaves it at that, and has no public way to its sockets.
    """
    context = document.session_context
    for connection in context.session._subscribed_connections if context else ():
        connection._socket.set_nodelay(True)


def ending(act: Callable[[], None]) -> Callable[[object], None]:
    """`act` as a callback for the end of a session, which comes when the names of the served script are gone."""
    return lambda _: act()
