"""Comparison in Chromium: Hold and its table of numbers, the curves from before a drag, and predictions."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.browser.waiting import type_in

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
DRAWN = """name => [...oscillations.plots.find(plot => plot.block.name === name).host
  .querySelectorAll('.ghosts path')].map(path => path.getAttribute('d').split('L').length)"""
OUTLINES = "document.querySelectorAll('.held-shape:not([style*=none])').length"


def test_what_is_held_stays_until_it_is_released(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="oscillator")
    page.keyboard.press("h")
    page.wait_for_function("oscillations.shown.state.held")
    type_in(page, "m", "4")
    ledger = page.get_by_role("region", name="Held and now")
    expect(ledger.get_by_role("row", name="m 1.00 → 4.00 kg × 4")).to_be_visible()
    expect(ledger.get_by_role("row", name="k 39.4 = 39.4 N/m same")).to_be_visible()
    assert page.evaluate(DRAWN, "x") == [301]
    page.wait_for_function(f"{OUTLINES} > 2")
    expect(page.locator(".same circle")).to_have_count(2)  # x and v start alike, a does not
    expect(page.locator(".stage").get_by_text(re.compile(r"^held [+−]0\.\d{3} m$"))).to_be_visible()
    expect(page.locator(".control:has(input[name=m]) .was")).to_be_visible()
    expect(page.locator(".control:has(input[name=k]) .was")).to_be_hidden()
    page.get_by_role("button", name="Light or dark").click()
    page.keyboard.press("Control+z")
    page.wait_for_function("oscillations.shown.settings.m.value === 1")
    assert page.evaluate(DRAWN, "x") == [], "the same picture again"
    page.keyboard.press("Control+Shift+z")
    page.wait_for_function("oscillations.shown.settings.m.value === 4 && location.search.includes('m=4')")
    page.reload()
    page.wait_for_function("document.documentElement.dataset.ready === 'true'")
    expect(ledger).to_be_visible()
    page.get_by_role("button", name="Release").click()
    expect(ledger).to_be_hidden()
    assert page.evaluate(DRAWN, "x") == []
    assert page.evaluate(OUTLINES) == 0


PLACES = "[...document.querySelectorAll('.paper .block')].map(b => JSON.stringify(b.getBoundingClientRect()))"


STOOD = "document.querySelector('.stage').innerHTML"


def test_what_the_next_change_shows_waits_for_a_prediction_in_its_place(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    button = page.get_by_role("button", name="Predict")
    button.click()
    page.get_by_role("menuitem", name="Everything that changes next").click()
    page.wait_for_function("oscillations.shown.state.covered.length === 1")
    places = page.evaluate(PLACES)
    type_in(page, "k2", "5")
    expect(page.locator(".cover:visible")).to_have_count(2)
    expect(page.locator("[data-value=omega_minus]:visible").first).to_contain_text("?")
    assert page.evaluate(PLACES) == places
    for view, covers in (("Energy", 1), ("x₂ against x₁", 1), ("Motion", 2)):
        page.get_by_role("tab", name=view).click()
        expect(page.get_by_role("tab", name=view, selected=True)).to_be_visible()
        expect(page.locator(".cover:visible")).to_have_count(covers)
    for part, heard in ((".play", False), (".seg", False), (".note", True)):
        found = page.locator(f".transport {part}")
        assert found.evaluate("part => !part.closest('[inert]')") is heard, f"{part}: the reason alone is heard"
    stood = page.evaluate(STOOD)
    page.evaluate("document.activeElement.blur()")
    page.keyboard.press("Space")
    assert not page.evaluate("oscillations.clock.playing")
    page.evaluate("oscillations.clock.seek(1); new Promise(done => requestAnimationFrame(() => setTimeout(done)))")
    assert page.evaluate(STOOD) == stood, "the stage stands at what it showed"
    page.keyboard.press("r")
    page.wait_for_function("stood => document.querySelector('.stage').innerHTML !== stood", arg=stood)
    expect(page.locator("[data-value=omega_minus]:visible").first).to_have_text("1.10")
    button.click()
    page.get_by_role("menuitem", name="Displacement of mass 2 against time").click()
    expect(page.locator(".cover:visible")).to_have_count(1)
    page.get_by_label("Controls").get_by_role("button", name="Reveal").click()
    expect(page.locator(".cover:visible")).to_have_count(0)


def test_arming_a_prediction_is_said_and_its_list_is_walked_by_keys(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    note = page.locator(".transport .note")
    page.get_by_role("button", name="Predict").press("Enter")
    items = page.get_by_role("menuitem")
    expect(items.first).to_be_focused()
    for key, place in (("ArrowDown", 1), ("ArrowUp", 0), ("ArrowUp", -1), ("ArrowDown", 0), ("End", -1), ("Home", 0)):
        page.keyboard.press(key)
        expect(items.nth(place)).to_be_focused()
    page.keyboard.press("Enter")
    expect(note).to_contain_text("The next change is covered until you press Reveal")
    play = page.locator(".transport .play")
    look = "one => Number(getComputedStyle(one).opacity)"
    assert play.evaluate(look) == 1
    type_in(page, "k2", "5")
    expect(note).to_contain_text("Press Reveal to see it and to play")
    assert play.evaluate(look) < 0.5, "what does nothing looks so"
    page.keyboard.press("Escape")
    page.get_by_label("Controls").get_by_role("button", name="Reveal").click()
    expect(note).not_to_contain_text("Reveal")


def test_what_is_offered_to_be_covered_can_be_and_what_it_begins_cannot_be_taken_in_hand(
    page: Page, open_scene: Open
) -> None:
    open_scene(page, scene="accuracy", view="time")
    button = page.get_by_role("button", name="Predict")
    button.click()
    expect(page.get_by_role("menuitem")).to_have_count(3)  # the next change and two plots: no apparatus moves
    page.get_by_role("menuitem").last.click()
    page.wait_for_function("oscillations.shown.state.covered.length === 1")
    open_scene(page, scene="coupled", cover="plot:x1")
    expect(page.get_by_role("slider", name="Slow mode, start, by mass 2")).to_have_count(0)
    page.get_by_label("Controls").get_by_role("button", name="Reveal").click()
    expect(page.get_by_role("slider", name="Slow mode, start, by mass 2")).to_be_visible()


def test_the_navigation_takes_the_chain_along_and_reset_gives_it_up(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled", k2=3)
    page.get_by_role("link", name="Forced").click()
    page.wait_for_function("oscillations.shown.scene === 'forced' && oscillations.shown.settings.m1.value === 2")
    page.wait_for_url("**/?scene=forced&m1=2&k1=4&k2=3&view=response")
    page.get_by_role("button", name="Reset").click()
    page.wait_for_function("oscillations.shown.settings.m1.value === 1")
    expect(page.get_by_role("button", name="Reset")).to_be_disabled()
    page.get_by_role("button", name="Undo").click()
    page.wait_for_function("oscillations.shown.settings.k2.value === 3")
    page.go_back()
    page.wait_for_function("oscillations.shown.settings.k2.value === 3 && oscillations.shown.scene === 'forced'")


def test_a_preset_says_what_to_watch_until_something_is_changed(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="oscillator")
    note = page.locator(".transport .note")
    expect(note).not_to_contain_text("half as fast")
    page.get_by_role("button", name="Heavy").click()
    expect(note).to_contain_text("Four times the mass of the others: it swings half as fast.")
    type_in(page, "m", "3")
    expect(note).not_to_contain_text("half as fast")
