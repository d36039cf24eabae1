"""The connection is lost and returns: no value is lost, and the page names everything that is lost for good."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, Page, Route, expect

from tests.browser.fixtures import READY, another_version
from tests.browser.tabs import calm_context
from tests.browser.waiting import unfold
from tests.grids import sample
from tests.serving.server import Server
from tools.reconnect.losses import CONNECTED, LINK, LOSSES, SETTLED, too_late, visit
from tools.reconnect.site import GatedSite

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
MINE = 'title = "Mine"\n[[step]]\nid = "one"\nfrom = "d31-03"\n'


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Iterator[GatedSite]:
    with GatedSite(tmp_path_factory.mktemp("site")) as found:
        yield found


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """Without the fixture of pages, because the browser logs errors of a lost connection."""
    context = calm_context(browser, {"width": 1280, "height": 720}, bypass_csp=True)
    page = context.new_page()
    faults: list[str] = []
    page.on("pageerror", lambda error: faults.append(str(error)))
    yield page
    context.close()
    assert not faults


def opened(page: Page, server: Server) -> None:
    page.goto(server.url + LINK)
    page.wait_for_function(READY)
    page.wait_for_function(CONNECTED.format("true"))
    unfold(page)


def lost(page: Page) -> None:
    """There is no network, and the page knows it: changes wait from now on."""
    page.context.set_offline(True)
    page.wait_for_function(CONNECTED.format("false"))


@pytest.mark.parametrize("name", sample([*LOSSES], 20))
def test_every_last_value_is_kept_when_the_connection_is_back(page: Page, site: GatedSite, name: str) -> None:
    visit(page, site, LOSSES[name], seed=1)


def test_a_token_that_came_too_late_is_replaced(page: Page, site: GatedSite) -> None:
    too_late(page, site, seed=1)


def preset_and_scene_wait(page: Page) -> None:
    """They are shown as chosen."""
    lost(page)
    beats = page.get_by_role("button", name="Beats")
    beats.click()
    expect(beats).to_have_class(re.compile("waits"))
    expect(beats).to_have_attribute("aria-pressed", "true")
    expect(page.locator(".control.waits")).not_to_have_count(0)
    expect(page.locator(".lost .next")).to_contain_text("1 change waits.")
    page.locator("input[name=k2-slider]").fill("0.5")
    expect(beats).not_to_have_class(re.compile("waits"))  # values other than its own wait now
    beats.click()
    page.get_by_role("link", name="Forced").click()
    expect(page.locator(".lost .next")).to_contain_text("Forced opens then.")
    page.context.set_offline(False)
    page.wait_for_function(f"oscillations.page.spec.slug === 'forced' && {SETTLED}")
    expect(page.locator(".waits:not(h1)")).to_have_count(0)


def handle_choice_and_window_wait(page: Page) -> None:
    """They stay as they were set."""
    lost(page)
    pill = page.locator(".pill[data-grab=omega]:visible").first
    for _ in range(2):
        pill.press("ArrowRight")
    moved = pill.get_attribute("aria-valuenow")
    choice = page.locator(".seg[data-name]:visible").first
    option = choice.locator("[aria-pressed=false]").first.get_attribute("data-option")
    other, window = choice.locator(f"[data-option={option}]"), page.get_by_label("Time window")
    other.click()
    window.fill("17.3")
    window.press("Enter")
    for part in (page.locator(".seg.waits"), page.locator(".window.waits")):
        expect(part).to_have_count(1)
    expect(pill).to_have_class(re.compile("waits"))
    page.context.set_offline(False)
    page.wait_for_function(SETTLED)
    expect(page.locator(".waits:not(h1)")).to_have_count(0)
    expect(window).to_have_value("17.3")
    expect(other).to_have_attribute("aria-pressed", "true")
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
    frames = page.evaluate("oscillations.clock.frames")
    page.wait_for_function("frames => oscillations.clock.frames > frames", arg=frames)
    page.context.set_offline(False)
    expect(page.get_by_role("status").filter(has_text="Connected again")).to_be_visible()
    expect(alert).to_be_hidden()
    page.wait_for_function(SETTLED)
    expect(page.get_by_text("1 value waits")).to_be_hidden()
    expect(waits).to_have_count(0)
    preset_and_scene_wait(page)
    handle_choice_and_window_wait(page)


def test_a_page_that_comes_back_shows_its_token_and_its_ticket(page: Page, server: Server) -> None:
    opened(page, server)
    token = page.evaluate("oscillations.connection.token")
    shown: list[tuple[str, str]] = []

    def full_once(route: Route) -> None:
        headers = route.request.headers
        shown.append((headers["page-token"], headers["page-ticket"]))
        if len(shown) == 1:
            route.fulfill(status=503, headers={"Page-Ticket": "second"}, body="All places are taken")
        else:
            route.continue_()

    page.route(server.url + "?*", full_once)
    page.context.set_offline(True)
    page.get_by_role("alert").filter(has_text="Not connected.").wait_for()
    page.context.set_offline(False)
    page.wait_for_function(SETTLED)
    assert shown == [(token, ""), (token, "second")]
    now = page.evaluate("(({token, ticket}) => ({token, ticket}))(oscillations.connection)")
    assert now["ticket"] == "" and now["token"] != token


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
    page.wait_for_function("!globalThis.old && globalThis.oscillations?.page")
    page.wait_for_function(SETTLED)
    state = page.evaluate("oscillations.messages.state")
    assert state["parameters"] == {"k2": k2, "m1": 5}
    assert (state["hidden"], state["covered"]) == (["x1_slow"], ["plot:x2"])


def test_a_proxy_that_refuses_sockets_is_named(page: Page, server: Server) -> None:
    page.add_init_script("globalThis.WebSocket = class { constructor() { throw new Error('refused') } }")
    page.goto(server.url + LINK)
    page.wait_for_function(READY)
    alert = page.get_by_role("alert").filter(has_text="Not connected.")
    expect(alert).to_contain_text("blocks WebSockets", timeout=30_000)


def test_a_walk_of_ones_own_is_known_to_the_next_session(page: Page, server: Server) -> None:
    """Its answer waits while the connection is lost, and arrives later; also after going back in the history of a
    reloaded page.
    """
    page.goto(f"{server.url}?scene=energy")
    page.wait_for_function(READY)
    page.evaluate("text => oscillations.walks.run('mine', text)", MINE)
    page.wait_for_function("oscillations.walks.walk?.card?.page === oscillations.page")
    lost(page)
    page.keyboard.press("1")
    page.keyboard.press("PageDown")
    page.context.set_offline(False)
    expect(page.locator("h1")).to_have_text("Twice as far takes just as long")
    page.wait_for_function(SETTLED)
    page.evaluate("oscillations.open({scene: 'energy'})")
    page.wait_for_function(f"oscillations.page.spec.slug === 'energy' && {READY} && !oscillations.walks.walk")
    page.wait_for_function("location.search === '?scene=energy&view=energy'")
    page.reload()
    page.wait_for_function(READY)
    page.go_back()
    expect(page.locator("h1")).to_have_text("How long does one swing take?")
    expect(page.locator(".note:not(:empty)")).to_have_count(0)


def test_a_link_too_long_for_a_server_loses_nothing(page: Page, server: Server) -> None:
    opened(page, server)
    page.evaluate(
        """() => {
          const {messages} = oscillations, {handle} = messages
          const long = `&hidden=${"x".repeat(8000)}`
          messages.handle = (message, asked) => handle({...message, query: message.query + long}, asked)
        }"""
    )
    page.evaluate("oscillations.send({type: 'set', values: {k2: 3}})")
    page.wait_for_function("oscillations.shown.settings.k2.value === 3 && location.search === '?scene=coupled'")
    page.get_by_role("button", name="Copy link").click()
    expect(page.get_by_role("button", name="Too long")).to_be_visible()
    lost(page)
    page.context.set_offline(False)
    page.wait_for_function(SETTLED)
    page.reload()
    page.wait_for_function("globalThis.oscillations?.shown?.settings.k2.value === 3")
    assert page.evaluate("oscillations.messages.state.hidden") == ["x1_slow"]
