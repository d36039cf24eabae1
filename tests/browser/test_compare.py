"""The curves of before: held, left by a drag, or hidden by a prediction; axes are fitted when a hand lets go."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.waiting import QUIET, is_shown, turned, type_in, typed

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
DRAWN = """[...oscillations.plots.find(plot => plot.block.name === 'x').host
  .querySelectorAll('.ghosts path')].map(path => path.getAttribute('d').split('L').length)"""
END = "oscillations.shown.view.axes.x.end"
WIDTH = "(({start, end}) => end - start)(oscillations.shown.view.axes.x)"
STAGE = "document.querySelector('.stage').innerHTML"
LOOK = "one => Number(getComputedStyle(one).opacity)"
LINGERED = "since => performance.now() > since + 1700"  # longer than earlier curves stay on their own
ENDED = f"!oscillations.page.compare.undoGroup && !oscillations.page.hand.grab && {QUIET}"
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


def is_wide(page: Page) -> None:
    page.wait_for_function(f"{WIDTH} > 2")


def is_fitted(page: Page) -> None:
    """With the earlier curves under the new ones until the next change."""
    page.wait_for_function(f"{WIDTH} < 1")
    page.wait_for_function(f"{DRAWN}.length")
    page.wait_for_function(LINGERED, arg=page.evaluate("performance.now()"))
    assert page.evaluate(f"{DRAWN}.length")


def test_what_is_held_stays_until_it_is_released(page: Page, open_scene: Open) -> None:
    outlines = "document.querySelectorAll('.held-shape:not([style*=none])').length"
    open_scene(page, scene="oscillator")
    page.keyboard.press("h")
    page.wait_for_function("oscillations.shown.state.held")
    type_in(page, "m", "4")
    ledger = page.get_by_role("region", name="Held and now")
    expect(ledger.get_by_role("row", name="m 1.00 → 4.00 kg × 4")).to_be_visible()
    expect(ledger.get_by_role("row", name="k 39.4 = 39.4 N/m same")).to_be_visible()
    assert page.evaluate(DRAWN) == [301]
    page.wait_for_function(f"{outlines} > 2")
    expect(page.locator(".same circle")).to_have_count(2)  # x and v start alike, a does not
    expect(page.locator(".stage").get_by_text(re.compile(r"^held [+−]0\.\d{3} m$"))).to_be_visible()
    expect(page.locator(".control:has(input[name=m]) .was")).to_be_visible()
    expect(page.locator(".control:has(input[name=k]) .was")).to_be_hidden()
    page.keyboard.press("Control+z")
    is_shown(page, m=1)
    assert page.evaluate(DRAWN) == [], "the same picture again"
    page.keyboard.press("Control+Shift+z")
    page.wait_for_function("oscillations.shown.settings.m.value === 4 && location.search.includes('m=4')")
    page.reload()
    page.wait_for_function("document.documentElement.dataset.ready === 'true'")
    expect(ledger).to_be_visible()
    page.get_by_role("tab", name="Force").click()
    page.wait_for_function("oscillations.shown.settings.view.value === 'force'")
    expect(ledger).to_be_visible()
    page.get_by_role("tab").first.click()
    page.get_by_role("button", name="Release").click()
    expect(ledger).to_be_hidden()
    assert page.evaluate(DRAWN) == [] and page.evaluate(outlines) == 0


def armed(page: Page, button: Locator) -> None:
    """The next change is covered, chosen from the list by keys."""
    items = page.get_by_role("menuitem")
    button.press("Enter")
    expect(items.first).to_be_focused()
    for key, place in (("ArrowDown", 1), ("ArrowUp", 0), ("ArrowUp", -1), ("ArrowDown", 0), ("End", -1), ("Home", 0)):
        page.keyboard.press(key)
        expect(items.nth(place)).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.locator(".transport .note")).to_contain_text("The next change is covered until you press Reveal")
    assert page.locator(".transport .play").evaluate(LOOK) == 1


def is_still(page: Page) -> None:
    """Nothing plays, the stage is as it was, and of the bar only the reason is heard."""
    expect(page.locator(".transport .note")).to_contain_text("Press Reveal to see it and to play")
    assert page.locator(".transport .play").evaluate(LOOK) < 0.5, "what does nothing looks so"
    for part, heard in ((".play", False), (".seg", False), (".note", True)):
        assert page.locator(f".transport {part}").evaluate("part => !part.closest('[inert]')") is heard, part
    stood = page.evaluate(STAGE)
    page.evaluate("document.activeElement.blur()")
    page.keyboard.press("Space")
    assert not page.evaluate("oscillations.clock.playing")
    page.evaluate("oscillations.clock.seek(1); new Promise(done => requestAnimationFrame(() => setTimeout(done)))")
    assert page.evaluate(STAGE) == stood


def test_what_the_next_change_shows_waits_for_a_prediction_in_its_place(page: Page, open_scene: Open) -> None:
    """It is armed by keys and revealed by mouse and keys."""
    places = "[...document.querySelectorAll('.paper .block')].map(b => JSON.stringify(b.getBoundingClientRect()))"
    open_scene(page, scene="coupled")
    button, covers, items = (
        page.get_by_role("button", name="Predict"),
        page.locator(".cover:visible"),
        page.get_by_role("menuitem"),
    )
    armed(page, button)
    before = page.evaluate(places)
    type_in(page, "k2", "5")
    expect(covers).to_have_count(2)
    expect(page.locator("[data-value=omega_minus]:visible").first).to_contain_text("?")
    assert page.evaluate(places) == before
    for view, count in (("Energy", 1), ("x₂ against x₁", 1), ("Motion", 2)):
        page.get_by_role("tab", name=view).click()
        expect(page.get_by_role("tab", name=view, selected=True)).to_be_visible()
        expect(covers).to_have_count(count)
    is_still(page)
    stood = page.evaluate(STAGE)
    page.keyboard.press("r")
    page.wait_for_function(f"stood => {STAGE} !== stood", arg=stood)
    expect(page.locator("[data-value=omega_minus]:visible").first).to_have_text("1.10")
    button.click()
    page.get_by_role("menuitem", name="Displacement of mass 1 against time").click()
    expect(covers).to_have_count(1)
    start = page.get_by_role("slider", name="Slow mode, start, by mass 2")
    expect(start).to_have_count(0)  # what begins a hidden motion cannot be taken in hand
    page.get_by_label("Controls").get_by_role("button", name="Reveal").click()
    expect(covers).to_have_count(0)
    expect(start).to_be_visible()
    turned(page, "accuracy", {"view": "time"})
    button.click()
    expect(items).to_have_count(3)  # the next change and two plots: no apparatus moves
    items.last.click()
    page.wait_for_function("oscillations.shown.state.covered.length === 1")


def test_a_sweep_by_mouse_is_one_change_that_fits_the_axes_when_it_ends(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="oscillator")
    opens = page.evaluate(END)
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
    page.get_by_role("button", name="Undo", exact=True).click()
    page.wait_for_function(f"{END} === {opens} && !oscillations.shown.state.frame")
    expect(page.get_by_role("button", name="Undo", exact=True)).to_be_disabled()
    page.wait_for_function(f"!{DRAWN}.length")
    page.get_by_role("button", name="Redo", exact=True).click()
    page.wait_for_function(f"oscillations.shown.settings.k.value > 10 && {END} < 0.5")


def test_keys_and_typed_values_let_go_when_they_rest(page: Page, open_scene: Open) -> None:
    """The curves of before await what the server makes of letting go."""
    open_scene(page, scene="oscillator")
    page.locator("input[name=k-slider]").focus()
    page.evaluate(NOTE_REST)
    page.evaluate(PRESS, ["PageDown", 9])
    is_wide(page)
    page.evaluate(PRESS, ["PageUp", 12])
    is_fitted(page)
    assert page.evaluate("rest") > 490, "a key that comes sooner goes on with the same change"
    page.wait_for_function(ENDED)
    typed(page, "m", "1.5")
    page.wait_for_function(f"{DRAWN}.length")
    page.wait_for_function(f"!{DRAWN}.length")  # a change that fits no axis leaves its curves for a moment only
    typed(page, "k", "0.001")
    is_wide(page)
    page.wait_for_function(ENDED)
    page.evaluate(KEEP_BACK)
    typed(page, "k", "40")
    page.wait_for_function("Boolean(globalThis.sent)")
    page.wait_for_function(LINGERED, arg=page.evaluate("performance.now()"))
    page.evaluate("sent()")
    is_fitted(page)
    page.keyboard.press("Control+Shift+Z")  # it belongs to the field and undoes nothing in the scene
    is_shown(page, k=40)


def test_fit_by_button_key_and_double_click_and_frames_that_are_kept(page: Page, open_scene: Open) -> None:
    """A changed mass keeps the window, so the doubled period is visible. A hand fits no frame of a link or a step."""
    window = "oscillations.shown.view.axes.t.end"
    open_scene(page, scene="oscillator")
    button = page.get_by_role("button", name="Fit", exact=True)
    expect(button).not_to_be_visible()

    def press_key() -> None:
        page.locator("h1").focus()
        page.keyboard.press("0")

    for deed in (button.click, press_key, page.locator(".plot-area").first.dblclick):
        before = page.evaluate(window)
        type_in(page, "m", "4")
        is_shown(page, m=4)
        assert page.evaluate(window) == before
        expect(button).to_be_visible()
        deed()
        expect(button).not_to_be_visible()
        assert page.evaluate(window) == pytest.approx(2 * before)
        page.get_by_role("button", name="Pushed back").click()
        is_shown(page, m=1)
        expect(button).not_to_be_visible()
    open_scene(page, scene="oscillator", **{"frame.x": "-9,9"})
    page.locator("input[name=m-slider]").press("ArrowRight")
    page.wait_for_function(f"oscillations.shown.settings.m.value !== 1 && {ENDED}")
    assert page.evaluate(END) == 9
    open_scene(page, walk="d31", step="d31-03", folded=True)
    page.wait_for_function("oscillations.walks.walk?.card")
    start = page.evaluate(END)
    page.evaluate("oscillations.walks.walk.show(true)")
    page.wait_for_function("oscillations.walks.walk.lesson && oscillations.shown.settings.x_0.value === 0.2")
    page.wait_for_function(f"{DRAWN}.length")
    typed(page, "x_0", "0.15")
    is_shown(page, x_0=0.15)
    page.wait_for_function(ENDED)
    assert page.evaluate(END) == start, "twice as far is seen to be twice as far"
