"""A finger or a mouse on a page."""

from collections.abc import Iterable
from time import time
from typing import Any

from playwright.sync_api import Locator, Page

from tests.browser.waiting import QUIET, passed, seek
from tools.browsers.driven import DrivenWindow

Point = tuple[float, float]
RESTS = 0.4  # seconds
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


def stroke(hand: Any, points: Iterable[Point], **up: str) -> None:
    """Press a finger or a mouse at the first point, move it over the others, and release it."""
    for i, (x, y) in enumerate(points):
        hand.move(x, y)
        if not i:
            hand.down()
    hand.up(**up)


def stopped(page: Page, t: float = 0.3) -> None:
    seek(page, t)
    passed(page)


class Finger:
    """A finger, with the methods of a mouse. It rests before it is lifted.

    Without a rest, the browser takes it for a throw and ignores the next tap, as it does while a page rolls.
    """

    def __init__(self, page: Page) -> None:
        self.browser, self.at = page.context.new_cdp_session(page), {"x": 0.0, "y": 0.0}
        self.is_down = False

    def _send(self, kind: str) -> None:
        points, when = ([self.at], time() - RESTS) if self.is_down else ([], time())
        self.browser.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points, "timestamp": when})

    def move(self, x: float, y: float) -> None:
        self.at = {"x": x, "y": y}
        if self.is_down:
            self._send("touchMove")

    def down(self) -> None:
        self.is_down = True
        self._send("touchStart")

    def up(self, kind: str = "touchEnd") -> None:
        self.is_down = False
        self._send(kind)
