"""From scene to scene within a session: no page is loaded, the back button returns, nothing is left in memory."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Browser, Page, Request, Route, expect

from components.scenes import SCENES
from tests.serving.server import Server

pytestmark = pytest.mark.browser
SAME_PLACES = """() => oscillations.plots.filter(plot => plot.figure.manager).every(plot => {
  const [view] = plot.figure.manager
  return ["left", "top", "width", "height"].every(side => view.frame.bbox[side] === plot.frame[side])
})"""
Open = Callable[..., Page]


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
    """Each plot already has the size that Bokeh gives its figure."""
    asked: list[str] = []
    page.set_viewport_size({"width": 1001, "height": 611})
    open_scene(page, scene="coupled", k2=3)
    page.evaluate("document.documentElement.dataset.theme = 'dark', globalThis.mine = true")

    def note(request: Request) -> None:
        asked.append(request.url)

    page.on("request", note)
    for slug in (*SCENES, "coupled", "forced"):
        turn(page, slug)
        assert page.title() == f"{SCENES[slug].headline} – Oscillations"
        expect(page.locator(".nav nav [aria-current=page]")).to_have_text(SCENES[slug].title)
        assert page.evaluate("document.activeElement.tagName") == "H1"
        assert page.locator(".page").count() == 1
        seen = page.evaluate("oscillations.plots.filter(plot => plot.host.offsetParent && !plot.absent).length")
        assert page.evaluate("Bokeh.documents.length") == seen + 1
        page.wait_for_function(SAME_PLACES)
    assert page.evaluate("mine && document.documentElement.dataset.theme") == "dark"
    assert len(asked) == len(set(asked)), "a sheet is fetched once"
    assert not [url for url in asked if "/assets/" not in url]


def test_a_link_can_be_chosen_before_the_first_page_stands(server: Server, page: Page) -> None:
    def late(route: Route) -> None:
        page.locator(".nav nav a[data-scene=modes]").evaluate("link => link.click()")
        route.continue_()

    page.route("**/sheets/**", late, times=1)
    page.goto(f"{server.url}?scene=coupled")
    arrived(page, "modes")
    assert page.locator(".page").count() == 1


def test_the_back_button_steps_through_scenes_and_presets_and_not_through_values(
    new_page: Callable[..., Page], open_scene: Open
) -> None:
    page = open_scene(new_page(fresh=True), scene="coupled")
    length = page.evaluate("history.length")
    page.locator("input[name=k2]").fill("3")
    page.locator("input[name=k2]").press("Enter")
    page.wait_for_function("location.search.startsWith('?scene=coupled&k2=3')")
    page.get_by_role("button", name="Drift").click()
    page.wait_for_function("location.search.includes('k1=0')")
    turn(page, "forced")
    assert page.evaluate("history.length") == length + 2
    page.go_back()
    arrived(page, "coupled")
    assert page.evaluate("oscillations.shown.preset") == "drift"
    page.go_back()
    page.wait_for_function("oscillations.shown.settings.k2.value === 3")
    assert page.evaluate("location.search.startsWith('?scene=coupled&k2=3')")
    page.go_forward()
    page.wait_for_function("oscillations.shown.preset === 'drift'")
    page.go_forward()
    arrived(page, "forced")
    assert page.evaluate("location.search") == "?scene=forced&m1=2&k1=0&k2=2&view=response"


def test_a_click_for_another_tab_is_the_browsers_own(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    with page.context.expect_page() as opened:
        page.locator(".nav nav a[data-scene=forced]").click(modifiers=["ControlOrMeta"])
    other = opened.value
    expect(other.get_by_role("heading", level=1)).to_have_text(SCENES["forced"].headline, timeout=30_000)
    assert page.evaluate("oscillations.shown.scene") == "coupled"


def test_a_sheet_that_could_not_be_fetched_is_asked_for_again(browser: Browser, open_scene: Open) -> None:
    page = browser.new_page(bypass_csp=True)  # the browser logs the file that could not be fetched
    open_scene(page, scene="coupled", k2=3)
    page.evaluate("globalThis.mine = true")
    page.route("**/sheets/forced.*", lambda route: route.abort(), times=2)  # it is requested twice
    page.locator(".nav nav a[data-scene=forced]").evaluate("link => link.click()")
    arrived(page, "forced")
    assert page.evaluate("globalThis.mine")
    page.go_back()
    arrived(page, "coupled")
    page.wait_for_function("oscillations.shown.settings.k2.value === 3")
    page.close()


def test_a_plot_gets_its_figure_when_it_is_first_seen(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled", view="energy")
    find = "oscillations.plots.find(plot => plot.block.name === 'mode_energy')"
    assert not page.evaluate(f"{find}.host.querySelector('.figure').firstChild")
    page.evaluate("oscillations.send({type: 'choose', name: 'energy', value: 'modes'})")
    page.wait_for_function(f"{find}.host.querySelector('.figure').firstChild")
