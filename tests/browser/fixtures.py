"""Fixtures of the browser tests: a running app, a Chromium, and pages that fail the test on a fault."""

import os
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, Request, Route, expect, sync_playwright

from components.scenes import SCENES
from tests.browser.waiting import unfold
from tests.serving.server import Server, serving
from tools.browsers.chromium import find

READY = "document.documentElement.dataset.ready === 'true'"
CONNECTED = f"{READY} && document.documentElement.dataset.connected === 'true'"
# Long enough for a busy machine, but shorter than the page's own timers of 10 s.
expect.set_options(timeout=9_000)
Open = Callable[..., Page]
CALMER = """{
  const real = requestAnimationFrame
  const waiting = new Map()
  let last = 0, count = 0
  const pump = now => {
    if (++count % 3 && globalThis.oscillations?.page?.clock.playing) return real(pump)
    const due = [...waiting.values()]
    waiting.clear()
    for (const act of due) try { act(now) } catch (fault) { reportError(fault) }
  }
  globalThis.requestAnimationFrame = act => {
    if (!waiting.size) real(pump)
    waiting.set(++last, act)
    return last
  }
  globalThis.cancelAnimationFrame = id => waiting.delete(id)
}"""
"""Draw only every third frame while a picture plays, which takes more than one core without a graphics card."""


@contextmanager
def visitors(browser: Browser, home: str = "") -> Iterator[Open]:
    """Makes pages, each in its own context: `new_page(width=390, height=844, color_scheme="dark")` and whatever else a
    context takes.

    None may throw an exception; with a `home`, none may log an error to the console or ask another host for anything.
    """
    contexts, faults = list[BrowserContext](), list[str]()

    def note(fault: str) -> None:
        faults.append(f"{fault} during {os.environ.get('PYTEST_CURRENT_TEST')}")

    def make(width: int = 1280, height: int = 720, **options: Any) -> Page:
        # Playwright waits for an expression with eval, which the page forbids: tests/serving/test_assets.py.
        options = {"viewport": {"width": width, "height": height}, "bypass_csp": True, **options}
        contexts.append(browser.new_context(**options))
        contexts[-1].add_init_script(CALMER)
        page = contexts[-1].new_page()
        page.on("pageerror", lambda error: note(f"page error: {error}"))
        if home:
            page.on("console", lambda said: said.type == "error" and note(f"console: {said.text} {said.location}"))
            page.on("request", lambda request: _is_foreign(request, home) and note(f"another host: {request.url}"))
        return page

    yield make
    for context in contexts:
        context.close()
    assert not faults, "\n".join(faults)


def _is_foreign(request: Request, home: str) -> bool:
    address = urlsplit(request.url)
    return address.scheme not in ("data", "blob") and address.netloc != urlsplit(home).netloc


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Skip reading modules without browser tests if only these are requested, and the other way round."""
    asked = re.match(r"(not )?browser($| and )", config.option.markexpr)
    if not asked or collection_path.suffix != ".py":
        return None
    text = collection_path.read_text(encoding="utf-8")
    has_none = re.search(r"^pytestmark = .*mark\.browser", text, re.M) if asked[1] else "mark.browser" not in text
    return bool(has_none) or None


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Run browser tests last: Playwright leaves an event loop running, which would disturb other tests."""
    items.sort(key=lambda item: item.get_closest_marker("browser") is not None)


@pytest.fixture(scope="session")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    with serving(tmp_path_factory.mktemp("server") / "log") as running:
        yield running
        assert not running.complaints(), running.log.read_text()


@pytest.fixture(scope="session")
def framed(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server whose pages any site may show in a frame."""
    with serving(tmp_path_factory.mktemp("framed") / "log", environment={"FRAME_ANCESTORS": "*"}) as running:
        yield running


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    path = find()
    if path is None:
        (pytest.fail if os.environ.get("CI") == "true" else pytest.skip)("no Chromium: make test installs one")
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=path)
        yield chromium
        chromium.close()


@pytest.fixture
def new_page(browser: Browser, server: Server) -> Iterator[Open]:
    """Makes a visitor's pages, without any fault."""
    with visitors(browser, server.url) as make:
        yield make


@pytest.fixture
def quiet(browser: Browser) -> Iterator[Open]:
    """Makes pages that may log errors to the console, as a browser does without a network."""
    with visitors(browser) as make:
        yield make


@pytest.fixture
def page(new_page: Open) -> Page:
    return new_page()


@pytest.fixture(scope="session")
def shared(browser: Browser, server: Server) -> Iterator[Open]:
    """Makes one page of each size for all tests."""
    with visitors(browser, server.url) as make:
        yield cache(make)


def _turning(request: pytest.FixtureRequest, width: int, height: int, **options: Any) -> Page:
    """A page of this size that changes from scene to scene, as its last test has left it."""
    page: Page = request.getfixturevalue("shared")(width, height, **options)
    has_failed = getattr(request.node, "execution_count", 1) > 1  # whatever a failed run has left is in the way
    if has_failed or page.url == "about:blank":
        page.goto(f"{request.getfixturevalue('server').url}?scene={next(iter(SCENES))}")
        page.wait_for_function(READY)
    page.set_viewport_size({"width": width, "height": height})
    page.evaluate("document.activeElement.blur()")
    return page


@pytest.fixture
def desk(request: pytest.FixtureRequest) -> Page:
    return _turning(request, 1280, 720)


@pytest.fixture
def phone(request: pytest.FixtureRequest) -> Page:
    return _turning(request, 390, 844, has_touch=True, is_mobile=True)


@pytest.fixture
def open_scene(server: Server) -> Open:
    """Opens a link on a page and waits until the scene is drawn: `open_scene(page, scene="forced", k2=3)`.

    All controls of the panel are unfolded, and a scene alone is opened at its defaults; `folded=True` leaves the page
    as a visitor meets it.
    """

    def go(page: Page, *, folded: bool = False, **query: object) -> Page:
        if not folded and query.keys() <= {"scene", "projector", "theme"}:
            scene = SCENES[str(query.get("scene", next(iter(SCENES))))]
            query = {"scene": scene.slug, **{name: scene().values[name] for name in scene.opens}, **query}
        page.goto(server.url + "?" + "&".join(f"{name}={value}" for name, value in query.items()))
        page.wait_for_function(READY)
        if not folded:
            unfold(page)
        return page

    return go


def another_version(route: Route) -> None:
    """Return the page as a later version of the server would send it."""
    answer = route.fetch()
    route.fulfill(response=answer, body=answer.text().replace('data-version="', 'data-version="x'))
