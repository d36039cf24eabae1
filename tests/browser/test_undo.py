"""Undo and redo, the back button, and the way from scene to scene, which loads no page."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Browser, Page, Request, Route, expect

from components.scenes import SCENES
from tests.browser.waiting import QUIET, is_shown, turned, type_in
from tests.serving.server import Server

pytestmark = pytest.mark.browser
Open = Callable[..., Page]


def test_changes_are_undone_one_by_one_and_done_again(page: Page, open_scene: Open) -> None:
    """A refused change is no entry; a field undoes its own text; each scene has its own past."""
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
    field = page.locator("input[name=m1]")
    field.focus()
    page.keyboard.type("5")
    page.keyboard.press("Control+z")
    page.wait_for_function(f"!oscillations.page.compare.undoGroup && {QUIET}")
    expect(field).to_have_value("3.00")
    is_shown(page, k2=7)
    field.blur()
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


def test_a_preset_plays_from_the_start_says_what_to_watch_and_keeps_what_it_does_not_name(
    page: Page, open_scene: Open
) -> None:
    open_scene(page, scene="coupled", hidden="x1_slow", window=40)
    note = page.locator(".transport .note")
    page.get_by_role("button", name="Pause").click()
    page.evaluate("oscillations.clock.seek(20)")
    page.get_by_role("button", name="Beats").click()
    page.wait_for_function("oscillations.shown.preset === 'beats'")
    assert page.evaluate("oscillations.clock.playing && oscillations.clock.t < 20")
    state = page.evaluate("oscillations.messages.state")
    assert (state["hidden"], state["parameters"]["window"]) == (["x1_slow"], 40)
    turned(page, "oscillator", {})
    page.get_by_role("button", name="Heavy").click()
    expect(note).to_contain_text("Four times the mass of the others: it swings half as fast.")
    type_in(page, "m", "3")
    expect(note).not_to_contain_text("half as fast")
    turned(page, "forced", {"window": 1e-3})
    page.evaluate("oscillations.take({omega: 1e300})")
    expect(page.locator(".notice")).to_contain_text("Still drawn as before.")
    expect(page.get_by_role("button", name="Undo", exact=True)).to_be_disabled()


SAME_PLACES = """() => oscillations.plots.filter(plot => plot.figure.manager).every(plot => {
  const [view] = plot.figure.manager
  return ["left", "top", "width", "height"].every(side => view.frame.bbox[side] === plot.frame[side])
})"""
NAVIGATION = "[...document.querySelectorAll('.nav a, .nav button')].map(one => one.textContent || one.ariaLabel)"


def turn(page: Page, slug: str) -> None:
    page.locator(f".nav nav a[data-scene={slug}]").evaluate("link => link.click()")
    arrived(page, slug)


def arrived(page: Page, slug: str) -> None:
    page.wait_for_function(
        "slug => globalThis.oscillations?.page?.spec.slug === slug"
        " && document.documentElement.dataset.ready === 'true'",
        arg=slug,
    )
    expect(page.get_by_role("heading", level=1)).to_have_text(SCENES[slug].headline)


def test_every_scene_is_reached_without_loading_a_page(page: Page, open_scene: Open) -> None:
    """Each has its own title and the same navigation. Each plot already has the size that Bokeh gives its figure."""
    asked: list[str] = []
    page.set_viewport_size({"width": 1001, "height": 611})
    open_scene(page, scene="coupled", k2=3)
    page.evaluate("document.documentElement.dataset.theme = 'dark', globalThis.mine = true")
    navigation = page.evaluate(NAVIGATION)

    def note(request: Request) -> None:
        asked.append(request.url)

    page.on("request", note)
    for slug in (*SCENES, "coupled", "forced"):
        turn(page, slug)
        assert page.title() == f"{SCENES[slug].headline} – Oscillations"
        assert page.evaluate("document.documentElement.lang") == "en"
        assert page.evaluate(NAVIGATION) == navigation
        expect(page.get_by_role("button", name="Keys")).to_be_visible()
        expect(page.locator(".nav nav [aria-current=page]")).to_have_text(SCENES[slug].title)
        assert page.evaluate("document.activeElement.tagName") == "H1"
        assert page.locator(".page").count() == 1
        seen = page.evaluate("oscillations.plots.filter(plot => plot.host.offsetParent && !plot.absent).length")
        assert page.evaluate("Bokeh.documents.length") == seen + 1
        page.wait_for_function(SAME_PLACES)
    assert page.evaluate("mine && document.documentElement.dataset.theme") == "dark"
    assert len(asked) == len(set(asked)), "a sheet is fetched once"
    assert not [url for url in asked if "/assets/" not in url]
    find = "oscillations.plots.find(plot => plot.block.name === 'mode_energy').host.querySelector('.figure').firstChild"
    turned(page, "coupled", {"view": "energy"})
    assert not page.evaluate(find), "a plot gets its figure when it is first seen"
    page.evaluate("oscillations.send({type: 'choose', name: 'energy', value: 'modes'})")
    page.wait_for_function(find)


def opens_another_tab(page: Page) -> None:
    """A click for another tab is the browser's own."""
    with page.context.expect_page() as other:
        page.locator(".nav nav a[data-scene=coupled]").click(modifiers=["ControlOrMeta"])
    expect(other.value.locator("h1")).to_have_text(SCENES["coupled"].headline, timeout=30_000)
    assert page.evaluate("oscillations.shown.scene") == "forced"
    other.value.close()


def test_the_back_button_steps_through_scenes_and_presets_and_not_through_values(
    new_page: Callable[..., Page], open_scene: Open
) -> None:
    """Links between scenes take the chain along."""
    page = open_scene(new_page(fresh=True), scene="coupled")
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
    opens_another_tab(page)
    page.get_by_role("button", name="Reset").click()
    is_shown(page, m1=1)
    expect(page.get_by_role("button", name="Reset")).to_be_disabled()
    page.get_by_role("button", name="Undo").click()
    is_shown(page, k1=0, m1=2)
    page.evaluate(
        "oscillations.open({scene: 'chain', parameters: "
        "{N: 2, ends: 'fixed-free', starts: 'mass', p: 1, m: 2, k: 3, h: 0.3}})"
    )
    page.get_by_role("link", name="Open in Coupled").click()
    is_shown(page, m1=2, m2=2, k1=3, k2=3, x1_0=0.3, x2_0=0)
    page.get_by_role("link", name="Open in Chain").click()
    is_shown(page, h=0.3)


def test_a_link_can_be_chosen_before_the_first_page_is_drawn(server: Server, page: Page) -> None:
    def late(route: Route) -> None:
        page.locator(".nav nav a[data-scene=modes]").evaluate("link => link.click()")
        route.continue_()

    page.route("**/sheets/**", late, times=1)
    page.goto(f"{server.url}?scene=coupled")
    arrived(page, "modes")
    assert page.locator(".page").count() == 1


def test_a_sheet_that_could_not_be_fetched_is_asked_for_again(browser: Browser, open_scene: Open) -> None:
    page = browser.new_page(bypass_csp=True)  # the browser logs the file that could not be fetched
    open_scene(page, scene="coupled", k2=3)
    page.evaluate("globalThis.mine = true")
    page.route("**/sheets/forced.*", lambda route: route.abort(), times=2)  # it is requested twice
    turn(page, "forced")
    assert page.evaluate("globalThis.mine")
    page.go_back()
    arrived(page, "coupled")
    is_shown(page, k2=3)
    page.close()
