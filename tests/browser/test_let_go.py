"""The end of a drag or a key press: axes that have become too wide are fitted again, with the earlier curves under the
new ones; Fit fits them by hand.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.browser.waiting import QUIET

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
END = "oscillations.shown.view.axes.x.end"
WIDTH = "(({start, end}) => end - start)(oscillations.shown.view.axes.x)"
GHOSTS = (
    """() => oscillations.plots.find(({block}) => block.name === 'x').host.querySelectorAll('.ghosts path').length"""
)
LINGERED = "since => performance.now() > since + 1700"  # longer than earlier curves stay on their own

PRESS = """([key, count]) => {
  for (const type of Array(count).fill(["keydown", "keyup"]).flat())
    document.activeElement.dispatchEvent(new KeyboardEvent(type, {key, bubbles: true, cancelable: true}))
}"""
"""A key, pressed so often that there is no pause between presses."""
NOTE_REST = """() => {
  const {messages} = oscillations, {send} = messages
  addEventListener("keyup", () => { globalThis.released = performance.now() })
  messages.send = (message, about) => {
    if (message.holding === false) globalThis.rest = performance.now() - released
    send.call(messages, message, about)
  }
}"""
"""A script that measures the time without a key press when the end is reported."""
KEEP_BACK = """() => {
  const {messages} = oscillations, {send} = messages.wire
  messages.patience = 60000
  messages.wire.send = message => {
    if (message.holding === false) globalThis.sent = () => send(message)
    else send(message)
  }
}"""
"""A script that holds back the message at the end of a drag until the test sends it."""


def opened(page: Page, open_scene: Open) -> float:
    open_scene(page, scene="oscillator")
    end: float = page.evaluate(END)
    return end


def is_wide(page: Page) -> None:
    page.wait_for_function(f"{WIDTH} > 2")


def is_fitted(page: Page) -> None:
    page.wait_for_function(f"{WIDTH} < 1")


def typed(page: Page, name: str, text: str) -> None:
    field = page.locator(f"input[name={name}]")
    field.fill(text)
    field.press("Enter")


def wait_for_earlier_curves(page: Page) -> None:
    page.wait_for_function(f"({GHOSTS})() > 0")
    page.wait_for_function(LINGERED, arg=page.evaluate("performance.now()"))
    assert page.evaluate(GHOSTS) > 0, "until the next change"


def test_a_sweep_by_mouse_is_one_change(page: Page, open_scene: Open) -> None:
    opens = opened(page, open_scene)
    box = page.locator("input[name=k-slider]").bounding_box()
    assert box
    y, width = box["y"] + box["height"] / 2, box["width"]
    page.mouse.move(box["x"] + 0.5 * width, y)
    page.mouse.down()
    page.mouse.move(box["x"] - 20, y, steps=5)
    is_wide(page)
    page.mouse.move(box["x"] + 0.6 * width, y, steps=5)
    page.wait_for_function(f"oscillations.shown.settings.k.value > 10 && {QUIET}")
    is_wide(page)  # a drag only widens it
    page.mouse.up()
    is_fitted(page)
    wait_for_earlier_curves(page)
    page.get_by_role("button", name="Undo", exact=True).click()
    page.wait_for_function(f"{END} === {opens} && !oscillations.shown.state.frame")
    expect(page.get_by_role("button", name="Undo", exact=True)).to_be_disabled()
    page.wait_for_function(f"({GHOSTS})() === 0")
    page.get_by_role("button", name="Redo", exact=True).click()
    page.wait_for_function(f"oscillations.shown.settings.k.value > 10 && {END} < 0.5")


def test_keys_let_go_when_they_rest(page: Page, open_scene: Open) -> None:
    opened(page, open_scene)
    page.locator("input[name=k-slider]").focus()
    page.evaluate(NOTE_REST)
    page.evaluate(PRESS, ["PageDown", 9])
    is_wide(page)
    page.evaluate(PRESS, ["PageUp", 12])
    is_fitted(page)
    wait_for_earlier_curves(page)
    assert page.evaluate("rest") > 490, "a key that comes sooner goes on with the same change"


def test_the_curves_of_before_await_what_the_server_makes_of_letting_go(page: Page, open_scene: Open) -> None:
    opened(page, open_scene)
    typed(page, "k", "0.001")
    is_wide(page)
    page.wait_for_function(f"{QUIET} && !oscillations.page.compare.undoGroup")
    page.evaluate(KEEP_BACK)
    typed(page, "k", "40")
    page.wait_for_function("Boolean(globalThis.sent)")
    page.wait_for_function(LINGERED, arg=page.evaluate("performance.now()"))
    page.evaluate("sent()")
    is_fitted(page)
    wait_for_earlier_curves(page)


def test_typed_values_let_go(page: Page, open_scene: Open) -> None:
    opened(page, open_scene)
    typed(page, "k", "0.001")
    is_wide(page)
    typed(page, "k", "40")
    is_fitted(page)
    wait_for_earlier_curves(page)
    page.keyboard.press("Control+Shift+Z")  # it belongs to the field and undoes nothing in the scene
    page.locator("input[name=m]").blur()
    typed(page, "m", "1.5")
    page.wait_for_function("oscillations.shown.settings.m.value === 1.5")
    page.wait_for_function(f"({GHOSTS})() > 0")
    page.wait_for_function(f"({GHOSTS})() === 0")


ANSWERS = """() => {
  const {messages} = oscillations, {handle} = messages
  Object.assign(globalThis, {answers: [], due: []})
  messages.handle = (message, asked) => {
    due.push("values" in asked.message && !Object.keys(asked.message.values).length ? "kept" : "shown")
    answers.push(message.type)
    handle(message, asked)
  }
}"""
"""A script that notes each answer, and the answer that is due: a message that sets nothing needs no picture."""
ENDED = f"!oscillations.page.compare.undoGroup && !oscillations.page.hand.grab && {QUIET}"


def test_a_change_is_answered_with_one_picture(page: Page, open_scene: Open) -> None:
    """Typed, by a key, on a slider, by a grip. Actions that wait for the end of the change get it."""
    opened(page, open_scene)
    page.evaluate("() => { oscillations.clock.playing = false; oscillations.clock.seek(0) }")
    page.evaluate(ANSWERS)
    grip = page.locator("[data-grab*=x_0]").first
    for pictures, change in (
        (1, lambda: typed(page, "m", "1.02")),
        (1, lambda: page.locator("input[name=k-slider]").press("ArrowRight")),
        (2, lambda: (grip.press("ArrowUp"), grip.press("Enter"))),  # taken, then moved
    ):
        page.wait_for_function(f"{ENDED} && !oscillations.page.compare.beforeDrag")
        page.evaluate("answers.length = due.length = 0")
        change()
        page.wait_for_function(f"answers.length >= {pictures} && {ENDED}")
        answers = page.evaluate("answers")
        assert answers == page.evaluate("due")
        assert answers.count("shown") == pictures
    page.wait_for_function("oscillations.clock.playing && !oscillations.page.hand.grab")


def test_a_grip_lets_go(page: Page, open_scene: Open) -> None:
    opened(page, open_scene)
    typed(page, "x_0", "9")
    is_wide(page)
    page.wait_for_function(QUIET)
    page.locator("[data-grab*=x_0]").first.focus()
    page.keyboard.press("Home")
    page.wait_for_function("Math.abs(oscillations.shown.settings.x_0.value) < 1")
    assert page.evaluate(END) > 9, "held, it stands"
    page.keyboard.press("Enter")
    page.wait_for_function(f"{END} < 2")


def test_a_frame_of_a_link_is_kept(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="oscillator", **{"frame.x": "-9,9"})
    page.locator("input[name=m-slider]").focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_function(f"oscillations.shown.settings.m.value !== 1 && {QUIET}")
    page.wait_for_function("!oscillations.page.compare.undoGroup")  # the key has been released
    page.wait_for_function(QUIET)
    assert page.evaluate(END) == 9


def test_twice_as_far_is_seen_to_be_twice_as_far(page: Page, open_scene: Open) -> None:
    open_scene(page, walk="d31", step="d31-03", folded=True)
    expect(page.locator("h1")).to_be_visible()
    start = page.evaluate(END)
    page.evaluate("oscillations.walks.walk.show(true)")
    page.wait_for_function("oscillations.walks.walk.lesson && oscillations.shown.settings.x_0.value === 0.2")
    assert page.evaluate(END) == start, "question and answer share one scale"
    wait_for_earlier_curves(page)
    typed(page, "x_0", "0.15")
    page.wait_for_function("oscillations.shown.settings.x_0.value === 0.15")
    assert page.evaluate(END) == start, "no step of a walk is fitted anew by a hand"


WINDOW = "oscillations.shown.view.axes.t.end"


def heavier(page: Page) -> None:
    """Four times the mass, typed: the window stays, so the doubled period is visible."""
    before = page.evaluate(WINDOW)
    field = page.locator("input[name=m].field, input[name=m]").last
    field.fill("4")
    field.press("Enter")
    page.wait_for_function("oscillations.shown.settings.m.value === 4")
    assert page.evaluate(WINDOW) == before


def test_fit_by_button_key_and_double_click(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="oscillator")
    button = page.get_by_role("button", name="Fit", exact=True)
    expect(button).not_to_be_visible()
    plot = page.locator(".plot-area").first

    def press_key() -> None:
        page.locator("h1").focus()
        page.keyboard.press("0")

    for deed in (button.click, press_key, plot.dblclick):
        heavier(page)
        expect(button).to_be_visible()
        page.evaluate("document.activeElement.blur()")
        window = page.evaluate(WINDOW)
        deed()
        expect(button).not_to_be_visible()
        assert page.evaluate(WINDOW) == pytest.approx(2 * window)
        page.get_by_role("button", name="Pushed back").click()
        page.wait_for_function("oscillations.shown.settings.m.value === 1")
        expect(button).not_to_be_visible()
