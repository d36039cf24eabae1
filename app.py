"""The page of one visitor: the scene that the link names, with the link's parameters, in the shell."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from html import escape
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

import panel as pn
from bokeh.document import Document
from panel.theme.fast import Fast

from components.language.state import State
from components.live_class.question_bank import QuestionBank
from components.panel_face.face import PanelFace
from components.scene import Picture
from components.scene.face import SceneFace, face_of
from components.scenes import SCENES
from components.scenes.things import THINGS
from components.serving.assets import STATIC, Asset, packed_files
from components.serving.shell import navigation, page_template, when_open
from components.serving.start import StartPage
from components.session.links import linked
from components.session.opening import opened
from components.session.panel_bridge import SceneView
from components.session.session import Publish, Session
from components.session.worker import Worker
from components.state.commands import sentence
from components.state.link import read_query, write_query
from components.state.scene_sheet import sheet_address, sheet_json
from components.state.wire import on_page
from components.walks import Query, Walks
from components.walks.cards import walk_file
from components.walks.registry import all_walks

pn.config.browser_info = False
# The page has its own themes. Without this line, Panel would read any `theme` of a link.
pn.config.theme = "default"  # type: ignore[misc]


FIGURES = {
    "measurements": (
        "Measurements that run or wait",
        lambda: sum(scene.work.pending() for scene in SCENES.values() if scene.work),
    )
}
"""Values for /metrics that come from scenes: by name, a description and a function that returns the value."""


NO_WALKS: Walks = MappingProxyType({})


def visited(query: Query, walks: Walks) -> Session:
    """The session that a link asks for: a scene, or a step of a walk."""
    link, step = linked(query, SCENES, walks)
    return opened(SCENES, link, walks, step)


class Lectured(NamedTuple):
    """The parts from which a server is made: the function that opens a page, the files of all scenes and walks by their
    address below assets/, the questions for live classes, and the start page."""

    open_page: Callable[..., None]
    files: dict[str, Asset]
    bank: QuestionBank
    start: StartPage


def walked(folders: Iterable[Path]) -> Lectured:
    """Return the parts of a server with the built-in walks and the walks in these folders."""
    walks = all_walks(folders, SCENES)
    sheets = {sheet_address(scene): sheet_json(scene) for scene in SCENES.values()}
    files = [walk_file(walk, SCENES) for walk in walks.values()]
    listed = [
        {"name": walk.name, "title": walk.title, "sheet": address}
        for walk, (address, _) in zip(walks.values(), files, strict=True)
    ]
    opening = partial(open_page, walks=walks, listed=listed)
    packed = packed_files(sheets | dict(files))
    return Lectured(opening, packed, QuestionBank(walks, SCENES), StartPage(SCENES, listed, THINGS))


def open_page(
    document: Document,
    walks: Walks = NO_WALKS,
    listed: Sequence[dict[str, str]] = (),
    lead: Callable[[str, str], Publish] | None = None,
    worker: Worker | None = None,
) -> None:
    """Fill `document`, the Bokeh document of a new session.

    `lead` connects the session to a live class; `worker` is the worker process.
    """
    session = visited(pn.state.session_args, walks)
    kind = session.now.kind
    document.title = kind.headline
    document.template = page_template()
    document.template_variables.update(
        headline=kind.headline,
        slug=kind.slug,
        step=session.now.step,
        opening=on_page(session.first or session.opening()),
        scene_title=kind.title,
        navigation=navigation(SCENES, kind.slug),
        sheet=sheet_address(kind),
        walks=listed,
    )
    context = document.session_context
    session.network = context.token_payload.get("network", "") if context else ""
    session.later = partial(when_open, document)
    session.lead = lead or session.lead
    session.worker = worker
    pn.state.on_session_destroyed(lambda _: session.close())
    SceneView(session).server_doc(document, location=False)


ELSEWHERE = """The whole lecture, with guided walks and live classes, runs on another server.
Start it in this folder by `make run`, or by `python -m components.serving --show`."""


NARROW = "@media (width < 600px) { .title { font-size: 20px } }"
"""On a phone the title leaves room for the mark of a busy page."""


def scene_page(query: Query) -> pn.template.FastListTemplate:
    """Build the page of `panel serve`: a menu of the scenes, and the scene of the link with its values.

    The address of the page follows changes of the values.
    """
    link = read_query(query, SCENES).as_opened(SCENES)
    kind, problems = SCENES[link.slug], list(link.problems)
    scene = face_of(kind)()
    try:
        scene.set(link.values)
    except ValueError as reason:
        problems.append(sentence(reason))
    face = PanelFace(scene)
    links = "".join(f'<li><a href="?scene={slug}">{escape(one.title)}</a></li>' for slug, one in SCENES.items())
    menu = pn.pane.HTML(f"<details><summary><b>All scenes</b></summary><ul>{links}</ul></details>")
    said = [pn.pane.Alert(problem, alert_type="warning") for problem in problems]
    if location := pn.state.location:

        def follow(_: Picture) -> None:
            location.search = f"?{write_query(state_of(scene), kind)}"

        scene.on_picture(follow)
    return pn.template.FastListTemplate(
        title=f"Oscillations: {kind.title}",
        sidebar=[menu, face.panel],
        main=[pn.Column(*said, face.paper, ELSEWHERE, sizing_mode="stretch_width")],
        raw_css=[math_font(), NARROW],
        font="sans-serif",
        theme_toggle=False,
        main_layout=None,
        sidebar_width=300,
        meta_viewport="width=device-width, initial-scale=1",
        collapsed_sidebar="Mobi" in pn.state.headers.get("User-Agent", ""),
    )


def state_of(scene: SceneFace) -> State:
    """The state for a link of `panel serve`: the values that are not at their defaults."""
    values: dict[str, Any] = dict(scene.value.off_default())
    return State(scene=scene.scene_kind.slug, parameters=values)


def math_font() -> str:
    """The font of formulas, embedded into the style sheet, because `panel serve` does not serve our files."""
    font = b64encode((STATIC / "fonts" / "stix-two-math.woff").read_bytes()).decode()
    return f'@font-face {{ font-family: "Lecture Math"; src: url("data:font/woff;base64,{font}") format("woff"); }}'


if __name__.startswith("bokeh_app_"):  # `panel serve` runs this file under such a name
    Fast._resources.pop("font", None)  # a font of another host; Panel has no option that leaves it out
    scene_page(pn.state.session_args).servable()
