"""A finger or a mouse on a page."""

from __future__ import annotations

from collections.abc import Iterable
from time import time
from typing import Any

from playwright.sync_api import Locator, Page

from tests.browser.waiting import QUIET, passed, seek
from tools.browsers.driven import DrivenWindow

Point = tuple[float, float]
FREE = f"!oscillations.page.hand.grab && !oscillations.page.compare.undoGroup && {QUIET}"
"""No hand holds anything, and the server has answered."""
OUTLINE = "getComputedStyle(document.activeElement).outlineStyle"
SCROLLING = """() => oscillations.page.plots
  .filter(({host, absent, block: {handles, time, pick}}) => !absent && host.checkVisibility() &&
    host.style.touchAction !== "none" && (handles.length || time || pick))
  .map(({block}) => block.name)"""
"""Plots that act on a press, and that a finger scrolls."""
IN_PLOT = """name => {
  const plot = oscillations.page.plots.find(({block}) => block.name === name)
  plot.host.scrollIntoView({block: "center"})
  const {left, top} = plot.host.getBoundingClientRect()
  const {frame} = plot
  return [left + frame.left + 0.7 * frame.width, top + frame.top + 0.6 * frame.height]
}"""


def value(page: Page | DrivenWindow, name: str) -> Any:
    """The value of a parameter, once all messages are answered."""
    page.wait_for_function(QUIET)
    return page.evaluate("name => oscillations.shown.settings[name].value", name)


def middle(part: Locator) -> tuple[float, float]:
    """The middle of a part, scrolled into view."""
    part.evaluate("part => part.scrollIntoView({block: 'center'})")
    box = part.bounding_box()
    assert box
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def stroke(page: Page | DrivenWindow, points: Iterable[Point]) -> None:
    """Press the button at the first point, move over the others, and release it."""
    for i, (x, y) in enumerate(points):
        page.mouse.move(x, y)
        if not i:
            page.mouse.down()
    page.mouse.up()


def top(part: Locator) -> float:
    return float(part.evaluate("part => part.getBoundingClientRect().top"))


def stopped(page: Page, t: float = 0.3) -> None:
    seek(page, t)
    passed(page)


def swipe(page: Page, start: tuple[float, float], way: tuple[int, int], end: str = "touchEnd") -> None:
    """A finger put down, moved, and lifted after a rest, or taken away by the browser.

    Without a rest, the browser takes it for a throw and ignores the next tap, as it does while a page rolls.
    """
    browser, now = page.context.new_cdp_session(page), time()
    for kind, share, ago in (
        ("touchStart", 0.0, 0.6),
        ("touchMove", 0.5, 0.5),
        ("touchMove", 1.0, 0.4),
        (end, None, 0.0),
    ):
        points = [] if share is None else [{"x": start[0] + share * way[0], "y": start[1] + share * way[1]}]
        browser.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points, "timestamp": now - ago})


class Finger:
    """One finger, moved step by step."""

    def __init__(self, page: Page) -> None:
        self.browser = page.context.new_cdp_session(page)

    def _send(self, kind: str, *points: dict[str, float]) -> None:
        self.browser.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    def down(self, x: float, y: float) -> None:
        self._send("touchStart", {"x": x, "y": y})

    def move(self, x: float, y: float) -> None:
        self._send("touchMove", {"x": x, "y": y})

    def up(self) -> None:
        self._send("touchEnd")


class Mouse:
    """A mouse button, with the methods of a `Finger`."""

    def __init__(self, page: Page) -> None:
        self.mouse = page.mouse

    def down(self, x: float, y: float) -> None:
        self.mouse.move(x, y)
        self.mouse.down()

    def move(self, x: float, y: float) -> None:
        self.mouse.move(x, y)

    def up(self) -> None:
        self.mouse.up()
