"""The curves of before: held, left by a drag, or hidden by a prediction. Undo, the back button, from scene to scene."""

import re

import pytest
from playwright.sync_api import Locator, Page, expect

from components.scenes import SCENES
from tests.browser.fixtures import READY, Open
from tests.browser.waiting import QUIET, is_shown, seek, turned, type_in, typed
from tests.grids import sample

pytestmark = pytest.mark.browser
DRAWN = """[...oscillations.plots.find(plot => plot.block.name === 'x').host
  .querySelectorAll('.ghosts path')].map(path => path.getAttribute('d').split('L').length)"""
END = "oscillations.shown.view.axes.x.end"
WIDE = "(({start, end}) => end - start)(oscillations.shown.view.axes.x) > 2"
STAGE = "document.querySelector('.stage').innerHTML"
LOOK = "one => Number(getComputedStyle(one).opacity)"
ENDED = f"!oscillations.page.compare.undoGroup && !oscillations.page.hand.grab && {QUIET}"
PRESS = """([key, count]) => {
  for (const type of Array(count).fill(["keydown", "keyup"]).flat())
    document.activeElement.dispatchEvent(new KeyboardEvent(type, {key, bubbles: true, cancelable: true}))
}"""
"""A key, pressed so often that there is no pause between presses."""
SAME_PLACES = """() => oscillations.plots.filter(plot => plot.figure.manager).every(plot => {
  const [view] = plot.figure.manager
  return ["left", "top", "width", "height"].every(side => view.frame.bbox[side] === plot.frame[side])
})"""
NAVIGATION = "[...document.querySelectorAll('.nav a, .nav button')].map(one => one.textContent || one.ariaLabel)"


def is_fitted(page: Page) -> None:
    """With the earlier curves under the new ones until the next change."""
    page.wait_for_function(WIDE.replace("> 2", "< 1"))
    page.wait_for_function(f"{DRAWN}.length")
    since = page.evaluate("performance.now()")  # longer than earlier curves stay on their own
    page.wait_for_function(f"performance.now() > {since} + 1700")
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
    page.keyboard.press("Control+z")
    is_shown(page, m=1)
    assert page.evaluate(DRAWN) == [], "the same picture again"
    page.keyboard.press("Control+Shift+z")
    is_shown(page, m=4)
    expect(ledger).to_be_visible()
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


def test_what_the_next_change_shows_waits_for_a_prediction_in_its_place(desk: Page) -> None:
    """It is armed by keys and revealed by mouse and keys. Nothing plays, and of the bar only the reason is heard."""
    places = "[...document.querySelectorAll('.paper .block')].map(b => JSON.stringify(b.getBoundingClientRect()))"
    turned(desk, "coupled", {})
    button, covers = desk.get_by_role("button", name="Predict"), desk.locator(".cover:visible")
    armed(desk, button)
    before = desk.evaluate(places)
    type_in(desk, "k2", "5")
    expect(covers).to_have_count(2)
    expect(desk.locator("[data-value=omega_minus]:visible").first).to_contain_text("?")
    assert desk.evaluate(places) == before
    for view, count in (("Energy", 1), ("x₂ against x₁", 1), ("Motion", 2)):
        desk.get_by_role("tab", name=view).click()
        expect(covers).to_have_count(count)
    stood, play = desk.evaluate(STAGE), desk.locator(".transport [inert] .play, .transport .play[inert]")
    expect(desk.locator(".transport .note")).to_contain_text("Press Reveal to see it and to play")
    expect(play).to_have_count(1)
    assert play.evaluate(LOOK) < 0.5, "what does nothing looks so"
    desk.evaluate("document.activeElement.blur()")
    desk.keyboard.press("Space")
    assert not desk.evaluate("oscillations.clock.playing")
    seek(desk, 1)
    assert desk.evaluate(STAGE) == stood
    desk.keyboard.press("r")
    desk.wait_for_function(f"stood => {STAGE} !== stood", arg=stood)
    expect(desk.locator("[data-value=omega_minus]:visible").first).to_have_text("1.10")
    button.click()
    desk.get_by_role("menuitem", name="Displacement of mass 1 against time").click()
    expect(covers).to_have_count(1)
    start = desk.get_by_role("slider", name="Slow mode, start, by mass 2")
    expect(start).to_have_count(0)  # what begins a hidden motion cannot be taken in hand
    desk.get_by_label("Controls").get_by_role("button", name="Reveal").click()
    expect(covers).to_have_count(0)
    expect(start).to_be_visible()


def test_a_sweep_by_mouse_or_keys_is_one_change_that_fits_the_axes_when_it_ends(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="oscillator")
    opens = page.evaluate(END)
    box = page.locator("input[name=k-slider]").bounding_box()
    assert box
    y, width = box["y"] + box["height"] / 2, box["width"]
    page.mouse.move(box["x"] + 0.5 * width, y)
    page.mouse.down()
    page.mouse.move(box["x"] - 20, y, steps=5)
    page.wait_for_function(WIDE)
    page.mouse.move(box["x"] + 0.6 * width, y, steps=5)
    page.wait_for_function(f"oscillations.shown.settings.k.value > 10 && {QUIET}")
    page.wait_for_function(WIDE)  # a drag only widens it
    page.mouse.up()
    is_fitted(page)
    page.get_by_role("button", name="Undo", exact=True).click()
    page.wait_for_function(f"{END} === {opens} && !oscillations.shown.state.frame")
    expect(page.get_by_role("button", name="Undo", exact=True)).to_be_disabled()
    page.wait_for_function(f"!{DRAWN}.length")
    page.get_by_role("button", name="Redo", exact=True).click()
    page.wait_for_function(f"oscillations.shown.settings.k.value > 10 && {END} < 0.5")
    turned(page, "oscillator", {})
    page.locator("input[name=k-slider]").focus()
    page.evaluate(PRESS, ["PageDown", 9])
    page.wait_for_function(WIDE)
    page.evaluate(PRESS, ["PageUp", 12])
    is_fitted(page)
    page.wait_for_function(ENDED)
    typed(page, "m", "1.5")
    page.wait_for_function(f"{DRAWN}.length")
    page.wait_for_function(f"!{DRAWN}.length")  # a change that fits no axis leaves its curves for a moment only
    typed(page, "k", "40")
    is_shown(page, k=40)
    page.keyboard.press("Control+Shift+Z")  # it belongs to the field and undoes nothing in the scene
    page.wait_for_function(ENDED)
    is_shown(page, k=40)


def test_fit_by_button_key_and_double_click(desk: Page) -> None:
    """A changed mass keeps the window, so the doubled period is visible."""
    window = "oscillations.shown.view.axes.t.end"
    turned(desk, "oscillator", {})
    button = desk.get_by_role("button", name="Fit", exact=True)
    for deed in (button.click, lambda: desk.locator("h1").press("0"), desk.locator(".plot-area").first.dblclick):
        before = desk.evaluate(window)
        expect(button).not_to_be_visible()
        type_in(desk, "m", "4")
        is_shown(desk, m=4)
        assert desk.evaluate(window) == before
        expect(button).to_be_visible()
        deed()
        expect(button).not_to_be_visible()
        assert desk.evaluate(window) == pytest.approx(2 * before)
        desk.get_by_role("button", name="Pushed back").click()
        is_shown(desk, m=1)


def test_changes_are_undone_one_by_one_and_done_again(page: Page, open_scene: Open) -> None:
    """A refused change is no entry; each scene has its own past."""
    open_scene(page, scene="coupled", m1=3)
    undo, redo = (page.get_by_role("button", name=name, exact=True) for name in ("Undo", "Redo"))
    expect(undo).to_be_disabled()
    type_in(page, "k2", "7")
    is_shown(page, k2=7)
    type_in(page, "k2", "-3")
    expect(page.get_by_role("alert").filter(has_text="−3 N/m is not possible")).to_be_visible()
    type_in(page, "k1", "9")
    is_shown(page, k1=9)
    page.get_by_role("button", name="All equal").click()
    is_shown(page, m1=1)
    undo.click()
    is_shown(page, m1=3, k2=7, k1=9)
    page.keyboard.press("Control+z")
    is_shown(page, m1=3, k2=7, k1=4)
    page.get_by_role("link", name="Forced").click()
    page.wait_for_function("oscillations.shown.scene === 'forced'")
    expect(undo).to_be_disabled()
    page.go_back()
    page.wait_for_function("oscillations.shown.scene === 'coupled'")
    undo.click()
    is_shown(page, m1=3, k2=2, k1=4)
    expect(undo).to_be_disabled()
    page.keyboard.press("Control+Shift+z")
    is_shown(page, k2=7, k1=4)
    redo.click()
    is_shown(page, k2=7, k1=9)
    type_in(page, "m2", "4")
    is_shown(page, m2=4)
    expect(redo).to_be_disabled()


def test_a_preset_plays_from_the_start_says_what_to_watch_and_keeps_what_it_does_not_name(desk: Page) -> None:
    turned(desk, "coupled", {"window": 40.0})
    desk.locator(".block.plot .part.slow").first.click()  # a term of the formula takes its curve away
    desk.wait_for_url(re.compile("hidden=x1_slow"))
    note = desk.locator(".transport .note")
    seek(desk, 20)
    desk.get_by_role("button", name="Beats").click()
    desk.wait_for_function("oscillations.shown.preset === 'beats'")
    assert desk.evaluate("oscillations.clock.playing && oscillations.clock.t < 20")
    state = desk.evaluate("oscillations.messages.state")
    assert (state["hidden"], state["parameters"]["window"]) == (["x1_slow"], 40)
    turned(desk, "oscillator", {})
    desk.get_by_role("button", name="Heavy").click()
    expect(note).to_contain_text("Four times the mass of the others: it swings half as fast.")
    type_in(desk, "m", "3")
    expect(note).not_to_contain_text("half as fast")


def turn(page: Page, slug: str) -> None:
    page.locator(f".nav nav a[data-scene={slug}]").evaluate("link => link.click()")
    arrived(page, slug)


def arrived(page: Page, slug: str) -> None:
    page.wait_for_function(f"globalThis.oscillations?.page?.spec.slug === '{slug}' && {READY}")
    expect(page.get_by_role("heading", level=1)).to_have_text(SCENES[slug].headline)


def test_every_scene_is_reached_without_loading_a_page(page: Page, open_scene: Open) -> None:
    """Each has its own title and the same navigation. Each plot already has the size that Bokeh gives its figure."""
    page.set_viewport_size({"width": 1001, "height": 611})
    open_scene(page, scene="coupled", k2=3)
    page.evaluate("document.documentElement.dataset.theme = 'dark', globalThis.mine = true")
    navigation = page.evaluate(NAVIGATION)
    for slug in (*sample([*SCENES]), "coupled"):
        turn(page, slug)
        assert page.title() == f"{SCENES[slug].headline} – Oscillations"
        assert page.evaluate(f"[document.documentElement.lang, {NAVIGATION}]") == ["en", navigation]
        expect(page.get_by_role("button", name="Keys")).to_be_visible()
        expect(page.locator(".nav nav [aria-current=page]")).to_have_text(SCENES[slug].title)
        assert page.evaluate("document.activeElement.tagName") == "H1" and page.locator(".page").count() == 1
        seen = page.evaluate("oscillations.plots.filter(plot => plot.host.offsetParent && !plot.absent).length")
        assert page.evaluate("Bokeh.documents.length") == seen + 1
        page.wait_for_function(SAME_PLACES)
    assert page.evaluate("mine && document.documentElement.dataset.theme") == "dark"


def test_the_back_button_steps_through_scenes_and_presets_and_not_through_values(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    length = page.evaluate("history.length")
    type_in(page, "k2", "3")
    page.wait_for_function("location.search.startsWith('?scene=coupled&k2=3')")
    page.get_by_role("button", name="Drift").click()
    page.wait_for_function("location.search.includes('k1=0')")
    turn(page, "forced")
    assert page.evaluate("history.length") == length + 2
    assert page.evaluate("location.search") == "?scene=forced&m1=2&k1=0&k2=2&view=response"
    page.go_back()
    arrived(page, "coupled")
    assert page.evaluate("oscillations.shown.preset") == "drift"
    page.go_back()
    is_shown(page, k2=3)
    assert page.evaluate("location.search.startsWith('?scene=coupled&k2=3')")
    page.go_forward()
    page.wait_for_function("oscillations.shown.preset === 'drift'")
    page.go_forward()
    arrived(page, "forced")
    with page.context.expect_page() as other:  # a click for another tab is the browser's own
        page.locator(".nav nav a[data-scene=coupled]").click(modifiers=["ControlOrMeta"])
    expect(other.value.locator("h1")).to_have_text(SCENES["coupled"].headline, timeout=30_000)
    assert page.evaluate("oscillations.shown.scene") == "forced"
    other.value.close()
    page.get_by_role("button", name="Reset").click()
    is_shown(page, m1=1)
    expect(page.get_by_role("button", name="Reset")).to_be_disabled()
    page.get_by_role("button", name="Undo").click()
    is_shown(page, k1=0, m1=2)
