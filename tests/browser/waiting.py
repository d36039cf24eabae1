"""Waits of the browser tests, for conditions and never for a number of seconds; a press of a clicker, a typed value."""

from collections.abc import Mapping

import param
from playwright.sync_api import Page

from components.layout.choices import stated
from components.scenes import SCENES

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
    words = {
        name: value if isinstance(parameters[name], param.Number) else stated(value) for name, value in given.items()
    }
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
