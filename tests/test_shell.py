"""The page around a scene: what a browser asks for, and that a new version is not mixed with what it has kept."""

from __future__ import annotations

import re
import weakref
from collections.abc import Callable

import pytest
from bokeh.document import Document
from bokeh.server.connection import ServerConnection
from bokeh.server.contexts import BokehSessionContext
from bokeh.server.session import ServerSession
from playwright.sync_api import Page, Request

from components.shell import STATIC, answer_at_once, libraries, modules, preloaded, version


def test_every_module_has_an_address_with_the_version() -> None:
    assert set(modules()) == {f"./assets/{path.relative_to(STATIC).as_posix()}" for path in STATIC.rglob("*.js")}
    assert {to.removeprefix(address) for address, to in modules().items()} == {f"?v={version()}"}


def test_every_import_of_a_module_is_in_the_map() -> None:
    for path in STATIC.rglob("*.js"):
        for imported in re.findall(r'(?:from |import\()"(.*)"', path.read_text(encoding="utf-8")):
            name = (path.parent / imported).resolve().relative_to(STATIC).as_posix()
            assert f"./assets/{name}" in modules()


def test_libraries_are_those_of_bokeh_and_panel() -> None:
    names = [re.sub(r".*/|\?.*", "", address) for address in libraries()]
    assert names == ["bokeh.min.js", "bokeh-widgets.min.js", "bokeh-tables.min.js", "panel.min.js"]


@pytest.mark.browser
def test_scripts_and_styles_are_asked_for_once_and_with_a_version(page: Page, open_scene: Callable[..., Page]) -> None:
    asked: list[str] = []

    def note(request: Request) -> None:
        if request.resource_type in ("script", "stylesheet") and request.url.startswith("http"):
            asked.append(request.url)

    page.on("request", note)
    open_scene(page, scene="coupled")
    assert len(asked) == len(set(asked)) > len(preloaded())
    assert [url for url in asked if "?v=" not in url] == []
    assert not any("/later/" in url for url in asked)


def test_answers_are_not_held_back() -> None:
    """On Bokeh's own session and connection, whose sockets it keeps to itself."""

    class Socket:
        def __init__(self) -> None:
            self.told: list[bool] = []

        def set_nodelay(self, value: bool) -> None:
            self.told.append(value)

    document, socket = Document(), Socket()
    context = BokehSessionContext("name", None, document)
    context._set_session(ServerSession("name", document))
    document._session_context = weakref.ref(context)
    ServerConnection(None, socket, None, context.session)
    answer_at_once(document)
    assert socket.told == [True]
    answer_at_once(Document())
