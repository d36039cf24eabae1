"""Fixtures of the browser tests: a running app, a Chromium, and pages that fail the test on a fault."""

import os
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, BrowserContext, ConsoleMessage, Page, Request, Route, expect, sync_playwright

from components.scenes import SCENES
from tests.browser.waiting import unfold
from tests.serving.server import Server, serving
from tools.browsers.chromium import find

READY = "document.documentElement.dataset.ready === 'true'"
CONNECTED = f"{READY} && document.documentElement.dataset.connected === 'true'"
# Long enough for a busy machine, but shorter than the page's own timers of 10 s.
expect.set_options(timeout=9_000)


CALMER = """{
  const real = requestAnimationFrame
  const waiting = new Map()
  let last = 0, count = 0
  const pump = now => {
    if (++count % 3) return real(pump)
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
"""Draw only every third frame: without a graphics card a playing picture takes more than one core."""


@contextmanager
def visitors(browser: Browser, home: str = "") -> Iterator[Callable[..., Page]]:
    """Makes pages, each in its own context: `new_page(width=390, height=844, color_scheme="dark")` and whatever else a
    context takes.

    None may throw an exception; with a `home`, none may log an error to the console or ask another host for anything.
    """
    contexts, faults = list[BrowserContext](), list[str]()

    def make(width: int = 1280, height: int = 720, **options: Any) -> Page:
        # Playwright waits for an expression with eval, which the page forbids: tests/serving/test_assets.py.
        options = {"viewport": {"width": width, "height": height}, "bypass_csp": True, **options}
        contexts.append(browser.new_context(**options))
        contexts[-1].add_init_script(CALMER)
        page = contexts[-1].new_page()
        page.on("pageerror", lambda error: faults.append(f"page error: {error}"))
        if home:
            page.on("console", lambda message: faults.extend(_console_fault(message)))
            page.on("request", lambda request: faults.extend(_foreign(request, home)))
        return page

    yield make
    for context in contexts:
        context.close()
    assert not faults, "\n".join(faults)


def _console_fault(message: ConsoleMessage) -> list[str]:
    return [f"console: {message.text} {message.location}"] if message.type == "error" else []


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
def new_page(browser: Browser, server: Server) -> Iterator[Callable[..., Page]]:
    """Makes a visitor's pages, without any fault."""
    with visitors(browser, server.url) as make:
        yield make


@pytest.fixture
def quiet(browser: Browser) -> Iterator[Callable[..., Page]]:
    """Makes pages that may log errors to the console, as a browser does without a network."""
    with visitors(browser) as make:
        yield make


@pytest.fixture
def page(new_page: Callable[..., Page]) -> Page:
    return new_page()


def _turning(browser: Browser, server: Server, *size: int, **options: Any) -> Iterator[Page]:
    """A page for all tests of a module, which changes from scene to scene."""
    with visitors(browser, server.url) as make:
        page = make(*size, **options)
        page.goto(f"{server.url}?scene={next(iter(SCENES))}")
        page.wait_for_function(READY)
        yield page


@pytest.fixture(scope="module")
def desk(browser: Browser, server: Server) -> Iterator[Page]:
    yield from _turning(browser, server)


@pytest.fixture(scope="module")
def phone(browser: Browser, server: Server) -> Iterator[Page]:
    yield from _turning(browser, server, 390, 844, has_touch=True, is_mobile=True)


@pytest.fixture
def open_scene(server: Server) -> Callable[..., Page]:
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


def _foreign(request: Request, home: str) -> list[str]:
    address = urlsplit(request.url)
    at_home = address.scheme in ("data", "blob") or address.netloc == urlsplit(home).netloc
    return [] if at_home else [f"request to another host: {request.url}"]


def another_version(route: Route) -> None:
    """Return the page as a later version of the server would send it."""
    answer = route.fetch()
    route.fulfill(response=answer, body=answer.text().replace('data-version="', 'data-version="x'))
