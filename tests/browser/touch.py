"""A finger on a page."""

from __future__ import annotations

from time import time

from playwright.sync_api import Page


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
