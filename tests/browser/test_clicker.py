"""The two keys of a clicker: through a walk, from a scene back to it, and past everything that covers the page."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.browser.waiting import clicked

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
AT = "id => oscillations.shown.state.step === id && oscillations.walks.walk?.card"
TAUGHT = "() => oscillations.walks.walk?.lesson"
ASKED = (
    "() => oscillations.walks.walk?.card && !oscillations.walks.walk.lesson && oscillations.shown.state.covered.length"
)


def at(page: Page, step: str) -> None:
    page.wait_for_function(AT, arg=step)


def test_it_leads_through_a_walk_and_takes_an_answer_back(page: Page, open_scene: Open) -> None:
    open_scene(page, walk="d34", step="d34-02")
    at(page, "d34/d34-02")
    clicked(page)
    page.wait_for_function(TAUGHT)
    clicked(page, "PageUp")
    page.wait_for_function(ASKED)
    at(page, "d34/d34-02")
    clicked(page)
    page.wait_for_function(TAUGHT)
    formulas = page.locator(".card .follows .lines")
    clicked(page)
    expect(formulas).to_be_visible()
    clicked(page, "PageUp")
    expect(formulas).to_be_hidden()
    clicked(page)
    expect(formulas).to_be_visible()
    clicked(page)
    at(page, "d34/d34-03")
    clicked(page, "PageUp")
    at(page, "d34/d34-02")


def test_two_presses_at_once_are_one(page: Page, open_scene: Open) -> None:
    open_scene(page, walk="d34", step="d34-02")
    at(page, "d34/d34-02")
    page.keyboard.press("PageDown")
    page.keyboard.press("PageDown")
    page.wait_for_function(TAUGHT)
    assert page.evaluate("oscillations.shown.state.step") == "d34/d34-02"


@pytest.mark.parametrize("taught", [True, False])
@pytest.mark.parametrize("key", ["PageDown", "w"])
def test_out_of_a_scene_it_comes_back_to_the_step_as_it_was_left(
    key: str, taught: bool, page: Page, open_scene: Open
) -> None:
    open_scene(page, walk="d34", step="d34-08")
    at(page, "d34/d34-08")
    if taught:
        clicked(page)
        page.wait_for_function(TAUGHT)
    page.evaluate("oscillations.open({scene: 'energy'}, true)")
    page.wait_for_function("oscillations.shown.scene === 'energy' && !oscillations.walks.walk")
    expect(page.locator("#back-to-walk")).to_have_text("Back to step 8 (W)")
    clicked(page, key)
    at(page, "d34/d34-08")
    page.wait_for_function(TAUGHT if taught else ASKED)
    expect(page.locator("#back-to-walk")).to_be_hidden()


def test_leaving_uncovers_no_open_question(page: Page, open_scene: Open) -> None:
    open_scene(page, walk="d34", step="d34-08")
    at(page, "d34/d34-08")
    covered = page.evaluate("oscillations.shown.state.covered")
    page.keyboard.press("w")
    page.wait_for_function("!oscillations.shown.state.step")
    assert page.evaluate("oscillations.shown.state.covered") == covered
    assert covered


def test_it_closes_what_lies_on_top_first(page: Page, open_scene: Open) -> None:
    open_scene(page, walk="d34", step="d34-02")
    at(page, "d34/d34-02")
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


def test_after_the_last_step_it_stops_at_the_last_slide_and_goes_back(page: Page, open_scene: Open) -> None:
    open_scene(page, walk="tour", step="1")
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
