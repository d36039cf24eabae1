"""Windows of Safari's engine and of Firefox, with visible scrollbars; pointer and keys in a window of any engine."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import pytest
from playwright.sync_api import Page

from tests.browser.fixtures import READY
from tools.browsers import firefox, webkit
from tools.browsers.driven import DrivenWindow

Window = Page | DrivenWindow
ENGINES = {"webkit": (webkit.WebKit, webkit.find), "firefox": (firefox.Firefox, firefox.find)}
Point = tuple[float, float]
SEEN = "one => one.checkVisibility({opacityProperty: true, visibilityProperty: true})"
NAMED = f"""([role, name]) => [...document.querySelectorAll({{
    button: "button, summary, [role=button]", link: "a[href]", tab: "[role=tab]", slider: "[role=slider]",
  }}[role])].filter({SEEN}).find(one => (one.getAttribute("aria-label") ?? one.textContent).trim() === name)"""
"""Return the element with a role and a name, as a screen reader announces them."""
MIDDLE = """found => {
  found.scrollIntoView({block: "nearest", inline: "nearest"})
  const {left, top, width, height} = found.getBoundingClientRect()
  return [left + width / 2, top + height / 2]
}"""
CONNECTED = f"{READY} && document.documentElement.dataset.connected === 'true'"


def opened(window: Window, address: str) -> None:
    window.goto(address)
    window.wait_for_function(CONNECTED)


def middle(window: Window, selector: str) -> Point:
    """Return the middle of an element, scrolled into view, in pixels of the page."""
    window.wait_for_function(f"[...document.querySelectorAll({selector!r})].some({SEEN})")
    x, y = window.evaluate(f"({MIDDLE})([...document.querySelectorAll({selector!r})].find({SEEN}))")
    return x, y


def click(window: Window, role: str, name: str) -> None:
    """Press the part with a role and a name: ("button", "Play")."""
    window.wait_for_function(NAMED, arg=[role, name])
    x, y = window.evaluate(f"given => ({MIDDLE})(({NAMED})(given))", [role, name])
    press(window, (x, y))


def press(window: Window, at: Point) -> None:
    stroke(window, [at])


def stroke(window: Window, points: Iterable[Point]) -> None:
    """Press the button at the first point, move over the others, and release it."""
    for i, (x, y) in enumerate(points):
        window.mouse.move(x, y)
        if not i:
            window.mouse.down()
    window.mouse.up()


def drag(window: Window, selector: str, dx: float, dy: float = 0.0) -> None:
    """Drag the middle of an element by a number of pixels, in steps."""
    x, y = middle(window, selector)
    stroke(window, [(x + i / 8 * dx, y + i / 8 * dy) for i in range(9)])


@pytest.fixture(scope="session", params=ENGINES)
def engine(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[DrivenWindow]:
    """A window of 1280 x 720 in each engine; engines that the machine lacks are skipped."""
    kind, find = ENGINES[request.param]
    path = find()
    if path is None:
        pytest.skip(f"{kind.__name__} is not installed: make browsers installs it")
    window = kind(path, tmp_path_factory.mktemp(request.param))
    try:
        window.set_viewport_size({"width": 1280, "height": 720})
        yield window
    finally:
        window.close()
