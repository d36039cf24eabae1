"""A lost connection, an old browser, missing files, failing parts: a sentence says so, and no value is lost."""

import re
from collections.abc import Iterator
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, Page, Route, expect

from components.scenes import SCENES
from tests.browser.fixtures import READY, Open, another_version
from tests.browser.waiting import QUIET, played, unfold
from tests.grids import sample
from tests.serving.server import Server
from tools.attack.stage import faults_of
from tools.reconnect.losses import CONNECTED, LINK, LOSSES, SETTLED, too_late, visit
from tools.reconnect.site import GatedSite

pytestmark = pytest.mark.browser
LACKS = {
    "modules": "delete HTMLScriptElement.prototype.noModule",
    "DecompressionStream": "delete globalThis.DecompressionStream",
    "the selector :has()": "CSS.supports = rule => !rule.includes(':has')",
    "nested rules": "CSS.supports = rule => rule !== 'selector(&)'",
}
"""Scripts that remove a feature of the browser, or report that it is missing."""
PRINTED = "oscillations.page.print"
"""The last parts have come."""
BROKEN = """() => {
  const {page, undo, hall, address, walks} = oscillations
  for (const [host, method] of [[page.parts.find(part => part.update), "update"], [undo, "record"],
    [hall, "applyStep"], [hall, "shown"], [address, "write"], [page.live, "draw"], [page.compare, "frame"],
    [page.stages[0], "frame"], [page.plots[0], "draw"]])
    host[method] = () => { throw Error(`${method} is broken`) }
  globalThis.last = {}
  for (const [host, method] of [[page.parts.findLast(part => part.update), "update"], [page.compare, "update"],
    [walks, "shown"], [page.stages.at(-1), "frame"], [page.plots.at(-1), "draw"]]) {
    const act = host[method].bind(host)
    host[method] = (...given) => (last[host.constructor.name] = 1, act(...given))
  }
}"""
"""Let the first part of each kind fail that takes a picture, and note which of the last parts still take it."""


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Iterator[GatedSite]:
    with GatedSite(tmp_path_factory.mktemp("site")) as found:
        yield found


NIGHTLY = dict.fromkeys(("tab suspended", "worker killed"), pytest.mark.nightly)
SLOWER = {"server killed and restarted": pytest.mark.slow, **NIGHTLY}


@pytest.fixture
def page(quiet: Open) -> Page:
    return quiet()


def opened(page: Page, server: Server, query: str = LINK) -> None:
    page.goto(server.url + query)
    page.wait_for_function(f"{READY} && {CONNECTED.format('true')}")
    unfold(page)


def lost(page: Page) -> None:
    """There is no network, and the page knows it: changes wait from now on."""
    page.context.set_offline(True)
    page.wait_for_function(CONNECTED.format("false"))


@pytest.mark.parametrize("name", [pytest.param(name, marks=SLOWER.get(name, ())) for name in LOSSES])
def test_every_last_value_is_kept_when_the_connection_is_back(page: Page, site: GatedSite, name: str) -> None:
    visit(page, site, LOSSES[name], seed=1)


def test_a_token_that_came_too_late_is_replaced(page: Page, site: GatedSite) -> None:
    too_late(page, site, seed=1)


def preset_choice_window_and_scene_wait(page: Page) -> None:
    """They are shown as chosen. A handle stays as it was set."""
    lost(page)
    beats = page.get_by_role("button", name="Beats")
    beats.click()
    expect(beats).to_have_class(re.compile("waits"))
    expect(page.locator(".lost .next")).to_contain_text("1 change waits.")
    page.locator("input[name=k2-slider]").fill("0.5")
    expect(beats).not_to_have_class(re.compile("waits"))  # values other than its own wait now
    page.get_by_role("link", name="Forced").click()
    expect(page.locator(".lost .next")).to_contain_text("Forced opens then.")
    page.context.set_offline(False)
    page.wait_for_function(f"oscillations.page.spec.slug === 'forced' && {SETTLED}")
    expect(page.locator(".waits:not(h1)")).to_have_count(0)
    lost(page)
    pill = page.locator(".pill[data-grab=omega]:visible").first
    pill.press("ArrowRight")
    moved = pill.get_attribute("aria-valuenow")
    choice, window = page.locator(".seg[data-name]:visible").first, page.get_by_label("Time window")
    option = choice.locator("[aria-pressed=false]").first.get_attribute("data-option")
    choice.locator(f"[data-option={option}]").click()
    window.fill("17.3")
    window.press("Enter")
    for part in (".seg", ".window", ".pill"):
        expect(page.locator(f"{part}.waits")).not_to_have_count(0)
    page.context.set_offline(False)
    page.wait_for_function(SETTLED)
    expect(page.locator(".waits:not(h1)")).to_have_count(0)
    expect(window).to_have_value("17.3")
    expect(choice.locator(f"[data-option={option}]")).to_have_attribute("aria-pressed", "true")
    assert pill.get_attribute("aria-valuenow") == moved


def test_what_is_lost_is_said_and_what_waits_is_shown(page: Page, server: Server) -> None:
    """Values, presets, handles, choices, the window and a scene."""
    opened(page, server)
    page.context.set_offline(True)
    alert, waits = page.get_by_role("alert").filter(has_text="Not connected."), page.locator(".control.waits")
    expect(alert).to_have_text("Not connected. Your changes wait for the server.")
    page.locator("input[name=k2-slider]").fill("0.5")
    expect(page.get_by_text("1 value waits")).to_be_visible()
    expect(waits).to_have_count(1)
    for width in (320, 1920):  # the message does not cover anything for good
        page.set_viewport_size({"width": width, "height": 568})
        page.get_by_role("button", name="Hold").click(trial=True)
        assert page.evaluate("(bar => bar.scrollWidth - bar.clientWidth)(document.querySelector('.lost'))") == 0
    page.set_viewport_size({"width": 1280, "height": 720})
    page.locator("a[href='./']:visible").last.click(trial=True)
    page.context.set_offline(False)
    expect(page.get_by_role("status").filter(has_text="Connected again")).to_be_visible()
    expect(alert).to_be_hidden()
    page.wait_for_function(SETTLED)
    expect(page.get_by_text("1 value waits")).to_be_hidden()
    expect(waits).to_have_count(0)
    preset_choice_window_and_scene_wait(page)


def test_a_page_older_than_the_server_takes_the_new_one_but_not_under_a_hand(page: Page, server: Server) -> None:
    opened(page, server)
    page.evaluate("globalThis.old = true")
    lost(page)
    page.locator("input[name=k2-slider]").fill("0.5")
    k2 = page.evaluate("oscillations.messages.left[0].values.k2")
    page.locator("input[name=m1]").press_sequentially("5")
    page.route(server.url + "?*", another_version)
    with page.expect_response(lambda answer: urlsplit(answer.url).path == "/"):
        page.context.set_offline(False)
    page.wait_for_function("oscillations.connection.isOutdated")
    assert page.evaluate("old && document.documentElement.dataset.connected") == "false"
    page.unroute(server.url + "?*", another_version)
    page.locator("input[name=m1]").fill("5")
    page.locator("input[name=m1]").press("Enter")
    page.wait_for_function(f"!globalThis.old && globalThis.oscillations?.page && {SETTLED}")
    state = page.evaluate("oscillations.messages.state")
    kept = {"parameters": {"k2": k2, "m1": 5}, "hidden": ["x1_slow"], "covered": ["plot:x2"]}
    assert {name: state[name] for name in kept} == kept


def test_a_link_too_long_for_a_server_loses_nothing(page: Page, server: Server) -> None:
    """Nor does a page that waits for a place: it shows its ticket."""
    opened(page, server)
    page.evaluate("""() => {
      const {messages} = oscillations, {handle} = messages, long = `&hidden=${"x".repeat(8000)}`
      messages.handle = (message, asked) => handle({...message, query: message.query + long}, asked)
    }""")
    page.evaluate("oscillations.send({type: 'set', values: {k2: 3}})")
    page.wait_for_function("oscillations.shown.settings.k2.value === 3 && location.search === '?scene=coupled'")
    page.get_by_role("button", name="Copy link").click()
    expect(page.get_by_role("button", name="Too long")).to_be_visible()
    shown: list[str] = []

    def full_once(route: Route) -> None:
        shown.append(route.request.headers["page-ticket"])
        if len(shown) > 1:
            return route.continue_()
        return route.fulfill(status=503, headers={"Page-Ticket": "second"}, body="All places are taken")

    page.route(server.url + "?*", full_once)
    lost(page)
    page.context.set_offline(False)
    page.wait_for_function(SETTLED)
    assert shown == ["", "second"]
    page.unroute(server.url + "?*")
    page.reload()
    page.wait_for_function("globalThis.oscillations?.shown?.settings.k2.value === 3")
    assert page.evaluate("oscillations.messages.state.hidden") == ["x1_slow"]


@pytest.mark.slow  # it opens six pages
def test_what_an_old_browser_lacks_and_a_proxy_refuses_is_named(quiet: Open, browser: Browser, server: Server) -> None:
    page = quiet(java_script_enabled=False)
    page.goto(f"{server.url}?scene=coupled")
    expect(page.locator("noscript p")).to_be_in_viewport()
    expect(page.locator("noscript p")).to_contain_text("JavaScript, which is switched off")
    for feature, script in LACKS.items():
        page = browser.new_page()  # parts of the page fail
        page.add_init_script(script)
        page.goto(f"{server.url}?scene=coupled")
        alert = page.get_by_role("alert").filter(has_text=f"This browser does not have {feature},")
        expect(alert).to_contain_text("Firefox 121")
        expect(alert).to_be_in_viewport()
        page.close()
    page = quiet()
    page.add_init_script("globalThis.WebSocket = class { constructor() { throw new Error('refused') } }")
    page.goto(server.url + LINK)
    expect(page.get_by_role("alert").filter(has_text="blocks WebSockets")).to_be_visible(timeout=30_000)


def test_files_that_cannot_be_fetched_are_missed_in_a_sentence_and_come_later(page: Page, server: Server) -> None:
    page.route("**/start.js", lambda route: route.abort())
    page.goto(f"{server.url}?scene=oscillator")
    expect(page.get_by_role("alert").filter(has_text="Part of this page could not be loaded")).to_be_in_viewport()
    page.unroute("**/start.js")
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


@pytest.mark.slow  # it waits until the page tries again
def test_parts_asked_for_without_a_network_come_with_it(page: Page, server: Server) -> None:
    opened(page, server, "?scene=coupled")
    page.wait_for_function(PRINTED)
    page.context.set_offline(True)
    page.locator("details.about summary").click()
    for _ in range(2):
        page.get_by_role("button", name="Keys").click()
        page.get_by_role("button", name="Pictures", exact=True).click()
    remark = page.get_by_text("Part of this page could not be loaded")
    expect(remark).to_have_count(1)
    page.context.set_offline(False)
    expect(page.get_by_role("dialog", name="Save a picture")).to_be_visible(timeout=30_000)
    expect(remark).to_have_count(0)
    page.keyboard.press("Escape")
    expect(page.get_by_role("dialog", name="Keys")).to_be_visible()
    expect(page.locator("details.about table").first).to_be_visible(timeout=30_000)


def test_exceptions_in_some_parts_stop_no_other_and_are_reported_once(browser: Browser, server: Server) -> None:
    page, logged = browser.new_page(bypass_csp=True), list[str]()
    page.on("console", lambda message: logged.append(message.text) if message.type == "error" else None)
    opened(page, server, "?scene=coupled")
    page.wait_for_function(f"{PRINTED} && oscillations.page.voice && oscillations.page.stages.length > 1")
    page.evaluate(BROKEN)
    for k1 in (2, 3):
        page.evaluate("k1 => oscillations.send({type: 'set', values: {k1}})", k1)
        page.wait_for_function(f"oscillations.shown.settings.k1.value === {k1} && {QUIET}")
        played(page, 2)
    assert len(page.evaluate("Object.keys(last)")) == 5, page.evaluate("last")
    assert all(any(name in line for line in logged) for name in ("update", "record", "applyStep", "draw", "frame"))
    lost = "[oscillations.messages.lostConnections, document.documentElement.dataset.connected]"
    assert page.evaluate(lost) == [0, "true"]
    expect(page.locator(".remark")).to_have_count(1)
    opened(page, server, "?scene=coupled")
    page.evaluate("() => { oscillations.page.compare.toggle = () => { throw Error('Hold is broken') } }")
    page.get_by_role("button", name="Hold").click()
    expect(page.locator(".remark")).to_contain_text("Hold is broken")
    page.close()


@pytest.mark.parametrize("slug", sample([*SCENES], 20))
def test_extreme_pictures_are_drawn_with_numbers(new_page: Open, open_scene: Open, slug: str) -> None:
    page = open_scene(new_page(), scene=slug)
    assert list(faults_of(page, SCENES[slug], size=12, start=1)) == []
