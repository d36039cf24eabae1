"""The start page in a browser: it leads to every scene, walk and class, on every screen."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Browser, Page, expect

from components.scenes import SCENES
from tests.browser.fixtures import READY
from tests.browser.views import GRID
from tests.serving.server import Server

pytestmark = pytest.mark.browser
PLACES = """() => [...document.querySelectorAll(".thumb")].map(thumb => [...thumb.querySelectorAll("g")].map(part => {
  const {x, y, width, height} = part.getBoundingClientRect()
  const {top} = thumb.getBoundingClientRect()
  return [x, y - top, width, height].map(Math.round).join()
}).join(" "))"""
LEAVES = """() => [...document.querySelectorAll("body *")].filter(one => one.checkVisibility() && !one.closest("svg")
  && one.getBoundingClientRect().right > innerWidth + 0.5).map(one => one.outerHTML.slice(0, 80))"""
SMALL = """() => [...document.querySelectorAll("a, button, input")].filter(one => one.checkVisibility())
  .filter(one => one.getBoundingClientRect().height < 24).map(one => one.outerHTML.slice(0, 80))"""

READ = """() => [...document.querySelectorAll("h1, h2, a, button, input")].filter(one => one.checkVisibility())
  .map(one => one.getBoundingClientRect()).map(({left, top, height}) => [Math.round(top + height / 2), left])"""
"""How far down and right each part is, in the order in which a screen reader reads them."""


@pytest.mark.parametrize("how", ["mouse", "keys"])
def test_every_scene_is_there_and_opens(how: str, page: Page, server: Server) -> None:
    page.goto(server.url)
    cards = page.locator("a.scene-card")
    expect(cards.locator(".name")).to_have_text([scene.title for scene in SCENES.values()])
    expect(cards.locator(".claim")).to_have_text([scene.headline for scene in SCENES.values()])
    card = cards.filter(has_text="Coupled")
    if how == "mouse":
        card.click()
    else:
        card.focus()
        page.keyboard.press("Enter")
    page.wait_for_function(READY)
    expect(page.get_by_role("heading", level=1)).to_have_text(SCENES["coupled"].headline)
    page.locator(".brand").click()
    expect(page.get_by_role("heading", level=1)).to_have_text("Pull a mass and see how it oscillates")


def test_nothing_leaves_any_screen_and_all_can_be_hit(page: Page, server: Server) -> None:
    page.goto(server.url)
    for width, height in GRID:
        page.set_viewport_size({"width": width, "height": height})
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), (width, height)
        assert page.evaluate(LEAVES) == [], (width, height)
        assert page.evaluate(SMALL) == [], (width, height)


def test_on_a_phone_it_is_read_in_the_order_in_which_it_is_seen(page: Page, server: Server) -> None:
    page.set_viewport_size({"width": 390, "height": 844})
    page.goto(server.url)
    read = page.evaluate(READ)
    rows = sorted({round(y / 8) for y, _ in read})
    assert len(rows) > 10
    assert [y for y, _ in read] == pytest.approx(sorted(y for y, _ in read), abs=8)
    for row in rows:
        places = [x for y, x in read if round(y / 8) == row]
        assert places == sorted(places)


def test_each_picture_in_view_moves_and_no_other(page: Page, server: Server) -> None:
    page.set_viewport_size({"width": 390, "height": 844})
    page.goto(server.url)
    before = page.evaluate(PLACES)
    page.wait_for_function(f"before => ({PLACES})()[0] !== before", arg=before[0])
    assert page.evaluate(PLACES)[-1] == before[-1]
    for i in range(len(SCENES)):
        page.locator(".thumb").nth(i).scroll_into_view_if_needed()
        page.wait_for_function(f"([i, before]) => ({PLACES})()[i] !== before", arg=[i, before[i]])
    page.wait_for_function("document.querySelector('.thumb').animationsPaused()")


def test_a_scene_is_fetched_before_it_is_pressed(page: Page, server: Server) -> None:
    page.goto(server.url)
    last = page.locator("a.scene-card").filter(has_text="Absorber")
    last.hover()
    sheet = last.get_attribute("data-sheet")
    expect(page.locator(f'head link[rel=prefetch][href="assets/{sheet}"]')).to_be_attached()


def test_with_reduced_motion_nothing_moves(new_page: Callable[..., Page], server: Server) -> None:
    page = new_page(reduced_motion="reduce")
    page.goto(server.url)
    page.locator("a.scene-card").first.hover()
    before = page.evaluate(PLACES)
    page.evaluate(
        "() => new Promise(done => { let n = 0; const f = () => ++n > 10 ? done() : requestAnimationFrame(f); f() })"
    )
    assert page.evaluate(PLACES) == before
    page.emulate_media(reduced_motion="no-preference")
    page.wait_for_function(f"before => ({PLACES})()[0] !== before", arg=before[0])


def test_one_filled_button_begins_the_tour(page: Page, server: Server) -> None:
    page.goto(server.url)
    ink = "getComputedStyle(document.body).color"
    filled = page.locator("body :is(a, button)").evaluate_all(
        f"all => all.filter(one => getComputedStyle(one).backgroundColor === {ink}).map(one => one.textContent)"
    )
    assert filled == ["Start here five questions, ten minutes"]
    page.get_by_role("link", name="Start here").click()
    page.wait_for_function(READY)
    expect(page.locator(".card-head span")).to_contain_text("1 of 5")


def test_it_can_be_printed(page: Page, server: Server) -> None:
    page.goto(server.url)
    page.emulate_media(media="print")
    expect(page.locator("a.scene-card:visible")).to_have_count(len(SCENES))
    expect(page.get_by_role("link", name="Start here")).to_be_hidden()


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


def test_light_and_dark_are_kept(page: Page, server: Server) -> None:
    page.goto(server.url)
    page.locator("#theme").click()
    theme = page.evaluate("document.documentElement.dataset.theme")
    page.reload()
    assert page.evaluate("document.documentElement.dataset.theme") == theme == "dark"
