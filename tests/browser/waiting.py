"""Waits of the browser tests, for conditions and never for a number of seconds; a hand, a clicker, a typed value."""

from collections.abc import Iterable, Mapping
from time import time
from typing import Any

import param
from playwright.sync_api import Locator, Page

from components.layout.choices import stated
from components.scenes import SCENES
from tools.browsers.driven import DrivenWindow

Point = tuple[float, float]
RESTS = 0.4  # seconds
FRAMES = """count => new Promise(drawn => {
  const {clock} = oscillations, last = clock.frames + count
  const look = () => (clock.frames >= last ? drawn() : requestAnimationFrame(look))
  clock.dirty = true
  look()
})"""
PASSED = """count => new Promise(passed => {
  const wait = left => (left ? requestAnimationFrame(() => wait(left - 1)) : passed())
  wait(count)
})"""
QUIET = "!oscillations.messages.asked && !oscillations.messages.outbox.length"
"""All messages are answered."""
TURNED = """([slug, given]) => document.documentElement.dataset.ready === "true"
  && oscillations.page.spec.slug === slug && !oscillations.messages.asked && !oscillations.messages.outbox.length
  && Object.entries(given).every(([name, value]) => oscillations.shown.settings[name].value === value)"""
UNFOLD = "document.querySelectorAll('.panel details.fold').forEach(fold => { fold.open = true })"


def unfold(page: Page) -> None:
    """Opens everything that is folded in the panel, so that every control can be reached."""
    page.evaluate(UNFOLD)


def turned(page: Page, slug: str, given: Mapping[str, object]) -> None:
    """The page shows a scene with these values, opened by its navigation, in half the time of a link."""
    parameters = SCENES[slug].param
    words = {name: one if isinstance(parameters[name], param.Number) else stated(one) for name, one in given.items()}
    page.evaluate("([scene, parameters]) => oscillations.open({scene, parameters})", [slug, words])
    page.wait_for_function(TURNED, arg=[slug, words])


def seek(page: Page, t: float) -> None:
    """Stops at an instant, which is drawn on return."""
    page.evaluate("t => { oscillations.clock.playing = false; oscillations.clock.seek(t) }", t)
    played(page)


def played(page: Page, frames: int = 1) -> None:
    """Wait until a number of frames have been drawn, with all received data."""
    page.evaluate(FRAMES, frames)


def passed(page: Page, frames: int = 3) -> None:
    """The browser has had this many chances to draw. Two are needed until the page has drawn an event, because a page
    that waited for work may ask for its frame after the test has.
    """
    page.evaluate(PASSED, frames)


def clicked(page: Page, key: str = "PageDown") -> None:
    """A press of a clicker, long enough after the previous one to count as another."""
    page.wait_for_function("performance.now() > (globalThis.pressed ?? -1e9) + 420")
    page.keyboard.press(key)
    page.evaluate("() => { globalThis.pressed = performance.now() }")


def tap(page: Page, option: int) -> None:
    page.locator(f".answers [data-option='{option}']").click()


def typed(page: Page, name: str, text: str) -> None:
    """Type a value into the field of a parameter, which keeps the focus."""
    field = page.locator(f"input[name={name}]").last
    field.fill(text)
    field.press("Enter")


def type_in(page: Page, name: str, text: str) -> None:
    """Type a value into the field of a parameter, and leave it."""
    typed(page, name, text)
    page.locator(f"input[name={name}]").last.blur()


def is_shown(page: Page, **values: float) -> None:
    """The page shows these values."""
    for name, value in values.items():
        page.wait_for_function(f"oscillations.shown.settings.{name}?.value === {value}")


DROP = """([name, text]) => {
  const data = new DataTransfer()
  data.items.add(new File([text], name))
  for (const kind of ["dragover", "drop"])
    document.querySelector(".paper").dispatchEvent(
      new DragEvent(kind, {dataTransfer: data, bubbles: true, cancelable: true}))
}"""
MINE = 'title = "Mine"\n[[step]]\nid = "pull"\nfrom = "d31-03"\n'
"""An instructor's own walk of one step."""


def drop(page: Page, name: str, content: str) -> None:
    """Drop a text file of this name onto the paper."""
    page.evaluate(DROP, [name, content])


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
