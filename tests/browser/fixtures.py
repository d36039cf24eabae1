"""Fixtures of the browser tests: a running app, a Chromium, and pages that fail the test on a fault."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator
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


EMPTY = '<!DOCTYPE html><link rel="icon" href="data:,">'
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
FORGET = "() => { localStorage.clear(); sessionStorage.clear() }"


def calm_context(browser: Browser, size: dict[str, int], **options: Any) -> BrowserContext:
    """A visitor whose pages draw less often."""
    # Playwright waits for an expression with eval, which the page forbids: tests/serving/test_assets.py.
    context = browser.new_context(viewport=size, **{"bypass_csp": True, **options})
    context.add_init_script(CALMER)
    return context


class Tab:
    """A page in its own context: one visitor."""

    def __init__(self, browser: Browser, size: dict[str, int], options: dict[str, Any]) -> None:
        self.context = calm_context(browser, size, **options)
        self.page = self.context.new_page()
        self.faults: list[str] = []
        self.page.on("console", lambda message: self.faults.extend(_console_fault(message)))
        self.page.on("pageerror", lambda error: self.faults.append(f"page error: {error}"))

    def close(self) -> None:
        self.context.close()


class Tabs:
    """Free tabs, by the options of their contexts."""

    def __init__(self, browser: Browser) -> None:
        self.browser = browser
        self.free: dict[str, list[Tab]] = {}

    def take(self, size: dict[str, int], options: dict[str, Any]) -> Tab:
        free = self.free.setdefault(str(sorted(options.items())), [])
        if not free:
            return Tab(self.browser, size, options)
        tab = free.pop()
        tab.page.set_viewport_size(size)
        return tab

    def give_back(self, tab: Tab, options: dict[str, Any], home: str) -> None:
        """Remove everything of the last test except the browser's cache."""
        if tab.page.is_closed() or len(tab.context.pages) > 1:
            return tab.close()
        tab.page.unroute_all()
        asked = {name: options.get(name, "null") for name in ("reduced_motion", "color_scheme")}
        tab.page.emulate_media(media="null", **asked)
        tab.context.set_offline(False)
        tab.page.route(home, lambda route: route.fulfill(body=EMPTY, content_type="text/html"))
        tab.page.goto(home)
        tab.page.evaluate(FORGET)
        tab.page.unroute(home)
        tab.faults.clear()
        self.free[str(sorted(options.items()))].append(tab)


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


@pytest.fixture(scope="session")
def tabs(browser: Browser) -> Tabs:
    return Tabs(browser)


@pytest.fixture
def new_page(browser: Browser, tabs: Tabs, server: Server) -> Iterator[Callable[..., Page]]:
    """Makes pages: `new_page(width=390, height=844, color_scheme="dark")` and whatever else a context takes.

    Each is a visitor's first, in a tab that tests of before have used; `fresh=True` where the test changes the tab
    itself. The test fails if one of them logged an error to the console or asked another host for anything.
    """
    taken: list[tuple[Tab, dict[str, Any] | None]] = []
    faults: list[str] = []

    def look(request: Request) -> None:
        faults.extend(_foreign(request, server))

    def make(width: int = 1280, height: int = 720, fresh: bool = False, **given: Any) -> Page:
        size = {"width": width, "height": height}
        tab = Tab(browser, size, given) if fresh else tabs.take(size, given)
        taken.append((tab, None if fresh else given))
        tab.page.on("request", look)
        return tab.page

    yield make
    for tab, options in taken:
        faults.extend(tab.faults)
        tab.page.remove_listener("request", look)
        if options is None:
            tab.close()
        else:
            tabs.give_back(tab, options, server.url)
    assert not faults, "\n".join(faults)


@pytest.fixture
def quiet(browser: Browser) -> Iterator[Callable[..., Page]]:
    """Makes pages that may log errors to the console, as a browser does without a network, but throw no exception."""
    contexts, faults = list[BrowserContext](), list[str]()

    def make(width: int = 1280, height: int = 720, **options: Any) -> Page:
        contexts.append(calm_context(browser, {"width": width, "height": height}, **options))
        page = contexts[-1].new_page()
        page.on("pageerror", lambda error: faults.append(str(error)))
        return page

    yield make
    for context in contexts:
        context.close()
    assert not faults


@pytest.fixture
def page(new_page: Callable[..., Page]) -> Page:
    return new_page()


def _turning(browser: Browser, server: Server, width: int, height: int, **given: Any) -> Iterator[Page]:
    """A page for all tests of a module, which changes from scene to scene."""
    tab = Tab(browser, {"width": width, "height": height}, given)
    tab.page.on("request", lambda request: tab.faults.extend(_foreign(request, server)))
    tab.page.goto(f"{server.url}?scene={next(iter(SCENES))}")
    tab.page.wait_for_function(READY)
    yield tab.page
    tab.close()
    assert not tab.faults, "\n".join(tab.faults)


@pytest.fixture(scope="module")
def desk(browser: Browser, server: Server) -> Iterator[Page]:
    yield from _turning(browser, server, 1280, 720)


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


def _foreign(request: Request, server: Server) -> list[str]:
    address = urlsplit(request.url)
    at_home = address.scheme in ("data", "blob") or address.netloc == urlsplit(server.url).netloc
    return [] if at_home else [f"request to another host: {request.url}"]


def another_version(route: Route) -> None:
    """Return the page as a later version of the server would send it."""
    answer = route.fetch()
    route.fulfill(response=answer, body=answer.text().replace('data-version="', 'data-version="x'))
