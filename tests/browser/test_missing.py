"""Features that a browser lacks, files it cannot fetch, parts that fail: a sentence reports it, everything else works,
and files come later.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect

from components.scenes import SCENES
from tests.browser.fixtures import READY
from tests.browser.tabs import calm_context
from tests.browser.waiting import QUIET, played, type_in, unfold
from tests.grids import sample
from tests.serving.server import Server
from tools.attack.stage import faults_of

pytestmark = pytest.mark.browser
Quiet = Callable[..., Page]
NO_STORAGE = """Object.defineProperty(globalThis, "localStorage", {
  get() { throw new DOMException("Access is denied for this document.", "SecurityError") }
})"""
LACKS = {
    "modules": "delete HTMLScriptElement.prototype.noModule",
    "DecompressionStream": "delete globalThis.DecompressionStream",
    "the selector :has()": "CSS.supports = rule => !rule.includes(':has')",
    "nested rules": "CSS.supports = rule => rule !== 'selector(&)'",
}
"""Scripts that remove a feature of the browser, or report that it is missing."""
BY_ANYTHING = 30_000
PRINTED = f"{READY} && oscillations.page.print"
"""The last parts have come."""


@pytest.fixture
def quiet(browser: Browser) -> Iterator[Quiet]:
    """Makes pages that may log errors to the console; `thrown` collects exceptions, of which none may be there."""
    contexts, faults = [], []

    def make(script: str = "", **options: Any) -> Page:
        context = calm_context(browser, {"width": 1280, "height": 720}, bypass_csp=True, **options)
        contexts.append(context)
        page = context.new_page()
        page.on("pageerror", lambda error: faults.append(str(error)))
        if script:
            page.add_init_script(script)
        return page

    yield make
    for context in contexts:
        context.close()
    assert not faults


def test_what_an_old_browser_lacks_is_named(quiet: Quiet, browser: Browser, server: Server) -> None:
    page = quiet(java_script_enabled=False)
    page.goto(f"{server.url}?scene=coupled")
    expect(page.locator("noscript p")).to_be_in_viewport()
    expect(page.locator("noscript p")).to_contain_text("JavaScript, which is switched off")
    for feature, script in LACKS.items():
        page = browser.new_page()
        page.add_init_script(script)
        page.goto(f"{server.url}?scene=coupled")
        alert = page.get_by_role("alert").filter(has_text=f"This browser does not have {feature},")
        expect(alert).to_contain_text("Firefox 121")
        expect(alert).to_be_in_viewport()
        page.close()


def test_a_browser_that_keeps_nothing_says_so_once(quiet: Quiet, server: Server) -> None:
    page = quiet(NO_STORAGE)
    page.goto(f"{server.url}?scene=coupled")
    page.wait_for_function(READY)
    remark = page.get_by_text("This browser stores nothing for this page")
    expect(remark).to_have_count(0)
    before = page.evaluate("document.documentElement.dataset.theme")
    page.locator("#theme").click()
    expect(remark).to_be_visible()
    page.get_by_role("status").filter(has=remark).get_by_role("button", name="Close").click()
    page.locator("#theme").click()
    assert page.evaluate("document.documentElement.dataset.theme") == before
    expect(remark).to_have_count(0)
    page = quiet(NO_STORAGE.replace("localStorage", "sessionStorage"))
    page.goto(f"{server.url}?class=ABCD&remote=ticket")
    expect(page.locator("h1")).to_contain_text("This code has been used")


def test_files_that_cannot_be_fetched_are_missed_in_a_sentence_and_come_later(quiet: Quiet, server: Server) -> None:
    page = quiet()
    page.route("**/start.js", lambda route: route.abort())
    page.goto(f"{server.url}?scene=oscillator")
    expect(page.get_by_role("alert").filter(has_text="Part of this page could not be loaded")).to_be_in_viewport()
    page = quiet()
    page.route("**/bokeh.min.js", lambda route: route.abort())
    page.goto(f"{server.url}?scene=coupled")
    page.wait_for_function(READY)
    lacks = page.get_by_text("The program that draws the curves could not be loaded. Trying again.")
    expect(lacks).to_be_visible()
    played(page, 3)
    expect(page.get_by_role("alert").filter(has_text="Not connected.")).to_be_visible()
    page.unroute("**/bokeh.min.js")
    # Visible or not, because the page also tries on its own.
    page.locator("button", has_text="Try now").dispatch_event("click")
    page.wait_for_function("oscillations.plots.filter(plot => plot.box && !plot.absent).every(plot => plot.mounted)")
    expect(lacks).to_have_count(0)


def test_parts_and_walks_asked_for_without_a_network_come_with_it(quiet: Quiet, server: Server) -> None:
    page = quiet()
    page.goto(f"{server.url}?scene=coupled")
    page.wait_for_function(PRINTED)
    unfold(page)
    page.context.set_offline(True)
    page.locator("details.about summary").click()
    for _ in range(2):
        page.get_by_role("button", name="Keys").click()
        page.get_by_role("button", name="Pictures", exact=True).click()
    remark = page.get_by_text("Part of this page could not be loaded")
    expect(remark).to_have_count(1)
    page.context.set_offline(False)
    expect(page.get_by_role("dialog", name="Save a picture")).to_be_visible(timeout=BY_ANYTHING)
    expect(remark).to_have_count(0)
    page.keyboard.press("Escape")
    expect(page.get_by_role("dialog", name="Keys")).to_be_visible()
    expect(page.locator("details.about table").first).to_be_visible()
    page.keyboard.press("Escape")
    page.context.set_offline(True)
    page.locator(".walks summary").click()
    page.locator("[data-walk=d34]").click()
    expect(remark).to_be_visible()
    page.context.set_offline(False)
    page.wait_for_function("oscillations.walks.walk?.card", timeout=BY_ANYTHING)
    expect(page.get_by_role("button", name="Show the answer", exact=True)).to_be_visible()


BREAKABLE = """() => {
  const lecture = oscillations, {page} = lecture
  const parts = page.parts.map((part, i) => [part, "update", `part ${i}`]).filter(([part]) => part.update)
  const stages = page.stages.map((stage, i) => [stage, "frame", `stage ${i}`])
  const plots = page.plots.map((plot, i) => [plot, "draw", `plot ${i}`])
  const others = [[page.live, "draw", "live"], [page.compare, "frame", "compare"], [lecture.undo, "record", "undo"],
    [lecture.hall, "applyStep", "hall"], [lecture.hall, "shown", "hall shown"], [lecture.address, "write", "address"],
    [lecture.walks, "shown", "walks"]]
  globalThis.counts = {}
  const all = [...parts, ...stages, ...plots, ...others]
  for (const [host, method, name] of all) {
    const act = host[method]
    host[method] = function (...given) {
      if (globalThis.broken === `${name}.`) throw Error(`The broken thing is ${name}.`)
      counts[`${name}.`] = 1
      return act.apply(this, given)
    }
  }
  return all.map(([, , name]) => `${name}.`)
}"""
"""Let every object that takes a picture count its calls in `counts`, or fail if it is `broken`; return all names."""


@pytest.mark.parametrize("slug", sample(["coupled", "accuracy"], 3))
def test_an_exception_in_one_part_stops_no_other_and_is_reported_once(slug: str, quiet: Quiet, server: Server) -> None:
    page, logged = quiet(), list[str]()
    page.on("console", lambda message: logged.append(message.text) if message.type == "error" else None)
    page.goto(f"{server.url}?scene={slug}")
    page.wait_for_function(f"{PRINTED} && oscillations.page.voice")
    names = page.evaluate(BREAKABLE)
    for i, name in enumerate(names):
        page.evaluate("name => Object.assign(globalThis, {broken: name, counts: {}})", name)
        page.evaluate("k1 => oscillations.send({type: 'set', values: {k1}})", 2 + i / 100)
        page.wait_for_function(QUIET)
        played(page, 2)
        counts = page.evaluate("counts")
        assert [other for other in names if other != name and not counts.get(other)] == [], name
        assert any(name in line for line in logged), name
    lost = "[oscillations.messages.lostConnections, document.documentElement.dataset.connected].join()"
    assert page.evaluate(lost) == "0,true"
    assert page.evaluate("oscillations.shown.settings.k1.value") == pytest.approx(2 + (len(names) - 1) / 100)
    expect(page.locator(".remark")).to_have_count(1)
    expect(page.locator(".remark")).to_contain_text(names[0])
    if slug == "coupled":
        page.evaluate("""() => {
          broken = ""
          oscillations.page.apply = () => { delete oscillations.page.apply; throw Error() }
        }""")
        type_in(page, "k2", "7")
        page.wait_for_function("!Object.hasOwn(oscillations.page, 'apply')")
        type_in(page, "k2", "8")
        page.wait_for_function("oscillations.shown.settings.k2.value === 8")
        assert page.evaluate(lost) == "0,true"


def test_an_exception_of_a_button_is_reported(browser: Browser, server: Server) -> None:
    page = browser.new_page(bypass_csp=True)
    page.goto(f"{server.url}?scene=coupled")
    page.wait_for_function(READY)
    page.evaluate("() => { oscillations.page.compare.toggle = () => { throw Error('Hold is broken') } }")
    page.get_by_role("button", name="Hold").click()
    expect(page.locator(".remark")).to_contain_text("Hold is broken")
    page.close()


@pytest.mark.parametrize("slug", sample([*SCENES], 20))
def test_extreme_pictures_are_drawn_with_numbers(page: Page, open_scene: Callable[..., Page], slug: str) -> None:
    open_scene(page, scene=slug)
    assert list(faults_of(page, SCENES[slug], size=12, start=1)) == []
