"""The start page in a browser: it leads to every scene, walk and class, on every screen."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Browser, Page, expect

from components.scenes import SCENES
from tests.browser.fixtures import READY
from tests.browser.views import GRID
from tests.browser.waiting import PASSED
from tests.serving.server import Server

pytestmark = pytest.mark.browser
PLACES = """() => [...document.querySelectorAll(".thumb")].map(thumb => [...thumb.querySelectorAll("g")].map(part => {
  const {x, y, width, height} = part.getBoundingClientRect()
  const {top} = thumb.getBoundingClientRect()
  return [x, y - top, width, height].map(Math.round).join()
}).join(" "))"""
FAULTS = """() => [...document.querySelectorAll("body *")].filter(one => one.checkVisibility()).filter(one => {
  const {right, height} = one.getBoundingClientRect()
  const leaves = !one.closest("svg") && right > innerWidth + 0.5
  return leaves || (one.matches("a, button, input") && height < 24)
}).map(one => one.outerHTML.slice(0, 80))"""
"""Parts that leave the screen, and targets that are too small."""
READ = """() => [...document.querySelectorAll("h1, h2, a, button, input")].filter(one => one.checkVisibility())
  .map(one => one.getBoundingClientRect()).map(({left, top, height}) => [Math.round(top + height / 2), left])"""
"""How far down and right each part is, in the order in which a screen reader reads them."""
INK = """all => all.filter(one => getComputedStyle(one).backgroundColor === getComputedStyle(document.body).color)
  .map(one => one.textContent)"""


@pytest.fixture
def home(page: Page, server: Server) -> Page:
    page.goto(server.url)
    return page


def test_every_scene_is_there_and_opens_by_mouse_and_keys(home: Page) -> None:
    cards = home.locator("a.scene-card")
    expect(cards.locator(".name")).to_have_text([scene.title for scene in SCENES.values()])
    expect(cards.locator(".claim")).to_have_text([scene.headline for scene in SCENES.values()])
    card = cards.filter(has_text="Coupled")
    for opens in (lambda: card.click(), lambda: card.press("Enter")):
        card.hover()
        fetched = f'head link[rel=prefetch][href="assets/{card.get_attribute("data-sheet")}"]'
        expect(home.locator(fetched)).to_be_attached()  # before it is pressed
        opens()
        home.wait_for_function(READY)
        expect(home.get_by_role("heading", level=1)).to_have_text(SCENES["coupled"].headline)
        home.locator(".brand").click()
        expect(home.get_by_role("heading", level=1)).to_have_text("Pull a mass and see how it oscillates")


def test_nothing_leaves_any_screen_all_can_be_hit_and_is_read_in_the_order_in_which_it_is_seen(home: Page) -> None:
    for width, height in GRID:
        home.set_viewport_size({"width": width, "height": height})
        assert home.evaluate("document.documentElement.scrollWidth <= innerWidth"), (width, height)
        assert home.evaluate(FAULTS) == [], (width, height)
    home.set_viewport_size({"width": 390, "height": 844})
    read = home.evaluate(READ)
    rows = sorted({round(y / 8) for y, _ in read})
    assert len(rows) > 10
    assert [y for y, _ in read] == pytest.approx(sorted(y for y, _ in read), abs=8)
    for row in rows:
        places = [x for y, x in read if round(y / 8) == row]
        assert places == sorted(places)
    home.emulate_media(media="print")
    expect(home.locator("a.scene-card:visible")).to_have_count(len(SCENES))
    expect(home.get_by_role("link", name="Start here")).to_be_hidden()


def test_each_picture_in_view_moves_and_no_other(home: Page) -> None:
    home.set_viewport_size({"width": 390, "height": 844})
    home.reload()
    before = home.evaluate(PLACES)
    home.wait_for_function(f"before => ({PLACES})()[0] !== before", arg=before[0])
    assert home.evaluate(PLACES)[-1] == before[-1]
    for i in range(len(SCENES)):
        home.locator(".thumb").nth(i).scroll_into_view_if_needed()
        home.wait_for_function(f"([i, before]) => ({PLACES})()[i] !== before", arg=[i, before[i]])
    home.wait_for_function("document.querySelector('.thumb').animationsPaused()")


def test_with_reduced_motion_nothing_moves(new_page: Callable[..., Page], server: Server) -> None:
    page = new_page(reduced_motion="reduce")
    page.goto(server.url)
    page.locator("a.scene-card").first.hover()
    before = page.evaluate(PLACES)
    page.evaluate(PASSED, 10)
    assert page.evaluate(PLACES) == before
    page.emulate_media(reduced_motion="no-preference")
    page.wait_for_function(f"before => ({PLACES})()[0] !== before", arg=before[0])


def test_light_and_dark_are_kept_and_one_filled_button_begins_the_tour(home: Page) -> None:
    home.locator("#theme").click()
    theme = home.evaluate("document.documentElement.dataset.theme")
    home.reload()
    assert home.evaluate("document.documentElement.dataset.theme") == theme == "dark"
    filled = home.locator("body :is(a, button)").evaluate_all(INK)
    assert filled == ["Start here five questions, ten minutes"]
    home.get_by_role("link", name="Start here").click()
    home.wait_for_function(READY)
    expect(home.locator(".card-head span")).to_contain_text("1 of 5")


def test_a_code_that_no_class_has_is_said_and_stays(browser: Browser, server: Server) -> None:
    page = browser.new_page()  # the browser logs the refusal
    page.goto(server.url)
    field = page.get_by_label("In a live class?")
    field.fill("ZZZZ")
    page.keyboard.press("Enter")
    expect(page.locator("#no-class")).to_have_text("No class has this code now. A code has four letters and digits.")
    expect(field).to_be_focused()
    expect(field).to_have_value("ZZZZ")
    page.close()
