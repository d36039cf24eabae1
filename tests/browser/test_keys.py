"""Keys of a scene and of a clicker: their actions, where they work, and that none works while something is typed."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.browser.waiting import clicked
from tests.grids import sample

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
AT = "id => oscillations.shown.state.step === id && oscillations.walks.walk?.card"
TAUGHT = "() => oscillations.walks.walk?.lesson"
ASKED = (
    "() => oscillations.walks.walk?.card && !oscillations.walks.walk.lesson && oscillations.shown.state.covered.length"
)
TWICE = """() => {
  for (const type of ["keydown", "keyup", "keydown", "keyup"])
    document.body.dispatchEvent(new KeyboardEvent(type, {key: "PageDown", bubbles: true, cancelable: true}))
  globalThis.pressed = performance.now()
}"""
"""Two presses at once."""


def at(page: Page, step: str) -> None:
    page.wait_for_function(AT, arg=step)


def playing(page: Page) -> bool:
    return bool(page.evaluate("oscillations.clock.playing"))


def test_keys_of_a_scene(page: Page, open_scene: Open) -> None:
    """None acts while something is typed. The key that ends a blank screen does nothing else."""
    now = "oscillations.clock.t"
    open_scene(page, scene="coupled")
    before = playing(page)
    page.keyboard.press("Space")
    assert playing(page) is not before
    page.keyboard.press("]")
    later = page.evaluate(now)
    assert later > 0 and not playing(page)
    page.keyboard.press("[")
    assert page.evaluate(now) < later
    page.keyboard.press("]")
    page.keyboard.press("Home")
    assert page.evaluate(now) == 0
    page.keyboard.press("2")
    page.wait_for_function("oscillations.shown.preset === oscillations.page.spec.panel.presets[1].name")
    page.keyboard.press("b")
    expect(page.locator(".blank")).to_be_visible()
    before = playing(page)
    page.keyboard.press("Space")
    expect(page.locator(".blank")).to_have_count(0)
    assert playing(page) is before
    for count in (1, 0):  # a clicker sends the same one again
        page.keyboard.press(".")
        expect(page.locator(".blank")).to_have_count(count)
    state = page.evaluate("[oscillations.clock.playing, oscillations.shown.preset]")
    field = page.locator(".panel input[name=k2]").last
    field.fill("")
    field.press_sequentially("2 fwb?.")
    assert field.input_value() == "2 fwb?."
    assert page.locator(".blank, dialog.keys, .walks[open]").count() == 0
    assert page.evaluate("[oscillations.clock.playing, oscillations.shown.preset]") == state


def test_the_list_names_each_key_and_single_letters_can_be_switched_off(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    page.keyboard.press("?")
    keys = page.get_by_role("dialog", name="Keys")
    for shown in ("Space", "Home", "Page Down", "W", "R", "F", "B or .", "Esc", "Arrows", "?"):
        expect(keys.locator("kbd").get_by_text(shown, exact=True)).to_be_visible()
    before = playing(page)
    keys.get_by_role("button", name="Play or pause").click()
    assert playing(page) is not before
    keys.get_by_label("Single-letter shortcuts on").uncheck()
    keys.get_by_role("button", name="Close", exact=True).click()
    page.keyboard.press("b")
    assert page.locator(".blank").count() == 0
    page.keyboard.press("?")
    expect(keys).to_be_visible()
    keys.get_by_label("Single-letter shortcuts on").check()
    page.keyboard.press("Escape")
    expect(keys).to_have_count(0)
    page.keyboard.press("b")
    expect(page.locator(".blank")).to_be_visible()


def test_lists_open_at_their_beginning_with_the_way_out_in_sight(
    new_page: Callable[..., Page], open_scene: Open
) -> None:
    page = open_scene(new_page(844, 390), walk="d31", step=3)
    page.wait_for_function("document.querySelector('.card')")
    for name, button in (("Keys", "Keys"), ("Steps of this lecture", "Contents")):
        page.get_by_role("button", name=button, exact=True).click()
        opened = page.get_by_role("dialog", name=name)
        close = opened.get_by_role("button", name="Close", exact=True)
        expect(close).to_be_focused()
        expect(close).to_be_in_viewport(ratio=1)
        assert opened.evaluate("list => [list.scrollTop, list.scrollHeight > list.clientHeight]") == [0, True]
        opened.evaluate("list => list.scrollTo(0, 1000)")
        if button == "Contents":  # a dialog is closed from anywhere
            expect(close).to_be_in_viewport(ratio=1)
        close.click()
        expect(opened).to_be_hidden()
    menu, leave = page.locator(".walks summary"), page.get_by_role("button", name="Leave the walk")
    menu.click()
    expect(leave).to_be_visible()
    page.keyboard.press("Escape")
    expect(leave).to_be_hidden()
    clicked(page)
    page.wait_for_function(TAUGHT)
    page.locator(".card input[name=x_0]").focus()
    clicked(page)  # a clicker also acts while a field has the focus
    page.wait_for_function("oscillations.walks.walk.place === 3")


def closes_the_topmost_dialog(page: Page) -> None:
    for shut, show in (("dialog.keys", "?"), (".walks[open]", None)):
        if show:
            page.keyboard.press(show)
        else:
            page.locator(".walks summary").click()
        expect(page.locator(shut)).to_be_visible()
        clicked(page)
        expect(page.locator(shut)).to_have_count(0)
        assert not page.evaluate(TAUGHT)
    page.evaluate("oscillations.walks.walk.open()")
    contents = page.locator("dialog.contents")
    expect(contents).to_be_visible()
    contents.evaluate("one => one.scrollTop = one.scrollHeight")
    clicked(page)
    expect(contents).to_be_hidden()
    assert not page.evaluate(TAUGHT)


def stops_at_the_last_slide(page: Page) -> None:
    """Then it goes back."""
    page.wait_for_function("oscillations.walks.walk?.card")
    page.evaluate("oscillations.walks.walk.go(oscillations.walks.walk.sheet.steps.length - 1)")
    page.wait_for_function("oscillations.walks.walk.place === oscillations.walks.walk.sheet.steps.length - 1")
    clicked(page)
    page.wait_for_function(TAUGHT)
    for _ in range(3):
        clicked(page)
        expect(page.locator("dialog.finish")).to_be_visible()
    for _ in range(4):  # up to its top, then out of it
        if page.locator("dialog.finish").is_visible():
            clicked(page, "PageUp")
    expect(page.locator("dialog.finish")).to_be_hidden()


def test_a_clicker_leads_through_a_walk_and_takes_an_answer_back(page: Page, open_scene: Open) -> None:
    """Two presses at once are one. It closes the topmost dialog first, and stops at the last slide."""
    open_scene(page, walk="d34", step="d34-02")
    at(page, "d34/d34-02")
    page.keyboard.press("Space")
    assert not playing(page), "nothing plays before the answer"
    page.keyboard.press("2")
    expect(page.locator(".answers button").nth(1)).to_have_attribute("aria-pressed", "true")
    closes_the_topmost_dialog(page)
    page.wait_for_function("performance.now() > pressed + 420")
    page.evaluate(TWICE)
    page.wait_for_function(TAUGHT)
    clicked(page, "PageUp")
    page.wait_for_function(ASKED)
    at(page, "d34/d34-02")
    clicked(page)
    page.wait_for_function(TAUGHT)
    formulas = page.locator(".card .follows .lines")
    expect(formulas).to_be_hidden()
    for key, visible in (("PageDown", True), ("PageUp", False), ("PageDown", True)):
        clicked(page, key)
        expect(formulas).to_be_visible(visible=visible)
    clicked(page)
    at(page, "d34/d34-03")
    clicked(page, "PageUp")
    at(page, "d34/d34-02")
    page.keyboard.press("Escape")
    expect(page.locator(".card")).to_be_visible()  # Esc never leaves a walk
    open_scene(page, walk="tour", step="1")
    stops_at_the_last_slide(page)


@pytest.mark.parametrize("key", sample(["w", "PageDown"], 3))
def test_out_of_a_scene_it_comes_back_to_the_step_as_it_was_left(key: str, page: Page, open_scene: Open) -> None:
    """Leaving by key uncovers no open question. Leaving by clicker is tried after the answer."""
    taught = key == "PageDown"
    open_scene(page, walk="d34", step="d34-08")
    at(page, "d34/d34-08")
    if taught:
        page.locator(".card").press("PageDown")
        page.wait_for_function(TAUGHT)
    page.evaluate("oscillations.open({scene: 'energy'}, true)")
    page.wait_for_function("oscillations.shown.scene === 'energy' && !oscillations.walks.walk")
    expect(page.locator("#back-to-walk")).to_have_text("Back to step 8 (W)")
    clicked(page, key)
    at(page, "d34/d34-08")
    page.wait_for_function(TAUGHT if taught else ASKED)
    expect(page.locator("#back-to-walk")).to_be_hidden()
    covered = page.evaluate("oscillations.shown.state.covered")
    page.keyboard.press("w")
    page.wait_for_function("!oscillations.shown.state.step")
    expect(page.locator(".card")).to_have_count(0)
    assert page.evaluate("oscillations.shown.state.covered") == covered and bool(covered) is not taught
