"""Phones behind proxies, of another version, and with requests that fail: every page finds back by itself."""

from __future__ import annotations

import json
import re

import pytest
from playwright.sync_api import Browser, Page, Request, Route, expect

from tests.browser.classroom import CONNECTED, LED, Open, explained, joined, opening, put, tap, taught
from tests.browser.fixtures import READY, another_version
from tests.browser.waiting import passed
from tests.live_class.caller import call
from tests.serving.server import Server
from tools.bench.between import between

pytestmark = pytest.mark.browser

HIDDEN = """hidden => {
  Object.defineProperty(document, "hidden", {value: hidden, configurable: true})
  document.dispatchEvent(new Event("visibilitychange"))
}"""
"""A headless browser's page is always visible."""


def test_phones_behind_proxies(server: Server, browser: Browser, window: Open) -> None:
    """One polls, because its proxy holds streams back. The other wakes up with dead connections; asleep, it is not
    counted.
    """
    lecture, code = taught(window, "scene=coupled")
    with (
        between(server.port, holds=True) as holding, opening(browser, holding.url) as far,
        between(server.port) as proxy, opening(browser, proxy.url) as near,
    ):  # fmt: skip
        polls, sleeps = joined(far, code), joined(near, code)
        lecture.wait_for_function(f"{LED}.news.here === 2")
        sleeps.evaluate(HIDDEN, True)
        lecture.wait_for_function(f"{LED}.news.here === 1")
        proxy.silence()
        lecture.evaluate("oscillations.open({scene: 'forced'})")
        polls.wait_for_function("oscillations.page.spec.slug === 'forced'")
        assert sleeps.evaluate("oscillations.page.spec.slug") == "coupled"
        sleeps.evaluate(HIDDEN, False)
        sleeps.wait_for_function("oscillations.page.spec.slug === 'forced'")
        for page in (polls, sleeps):
            expect(page.locator(".class-bar")).to_contain_text("Following")
        lecture.evaluate(f"{LED}.end()")
        for page in (polls, sleeps):
            expect(page.get_by_role("heading", name="The class is over.")).to_be_visible()


COUNT = "sessionStorage.setItem('loads', 1 + Number(sessionStorage.getItem('loads')))"
LOADS = "sessionStorage.getItem('loads')"
VERSION = "document.documentElement.dataset.version[0]"
HEARD = "globalThis.oscillations?.news?.number"


def test_a_phone_of_another_version_reloads_the_page_but_not_twice_at_once(server: Server, failing: Open) -> None:
    page = failing(f"class={call(server.url, '/class', 'POST').json['code']}", 390, 844)
    page.wait_for_function(HEARD)
    page.add_init_script(COUNT)
    page.route(f"{server.url}?*", another_version)
    page.reload(wait_until="commit")  # the page reloads, perhaps before all of this one is loaded
    page.wait_for_function(f"{LOADS} === '2' && {HEARD}")
    passed(page)  # it would have happened by now
    assert page.evaluate(f"[{LOADS}, {VERSION}]") == ["2", "x"]
    page.unroute(f"{server.url}?*", another_version)
    page.reload(wait_until="commit")
    page.wait_for_function(f"{LOADS} === '3' && {HEARD}")
    page.evaluate("sessionStorage.removeItem('class-renewed')")
    with page.expect_response(re.compile("/events")):  # a stream of the same version again
        page.evaluate("oscillations.stream.control.abort()")
    passed(page)  # it would have happened by now
    assert page.evaluate(LOADS) == "3"
    assert page.evaluate(VERSION) != "x"


def losing(page: Page, path: str, kind: str = "") -> list[str]:
    """Let the first request to a path get no answer; return the data that was sent to it, in order."""
    found: list[str] = []

    def go(route: Route) -> None:
        told = json.loads(route.request.post_data or "{}")
        if told.get("type", "") == kind:
            found.append(told.get("step", route.request.url))
            if len(found) == 1:
                return route.abort()
        return route.continue_()

    page.route(re.compile(path), go)
    return found


def test_a_class_is_opened_once_no_order_is_overtaken_and_lost_requests_are_repeated(failing: Open) -> None:
    lecture = failing("walk=d31&step=d31-01", 1920, 1080)
    lecture.wait_for_function(CONNECTED)
    made: list[Request] = []
    lecture.on("request", lambda request: made.append(request) if request.url.endswith("/class") else None)
    lecture.evaluate("oscillations.classes.begin(); oscillations.classes.begin()")
    lecture.wait_for_function(LED)
    phone = joined(failing, lecture.evaluate(f"{LED}.room.code"))
    put("d31-01", lecture, phone)
    steps = losing(lecture, "/lead$", "put")
    for place in (1, 2):
        lecture.evaluate("place => oscillations.walks.walk.go(place)", place)
    put("d31-03", lecture, phone)
    assert steps == ["d31-02", "d31-02", "d31-03"]
    assert len(made) == lecture.locator(".class-code").count() == 1
    losing(lecture, "/tally$")
    tap(phone, 1)
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered")
    replies = losing(phone, "/answer$")
    explained(lecture, phone)
    expect(phone.locator(".answers [data-option='1'] .line")).not_to_be_empty()
    assert len(replies) == 2  # the reply to its answer is requested again
    losing(lecture, "/tickets$")
    lecture.keyboard.press("j")
    lecture.get_by_role("button", name="Remote control").click()
    expect(lecture.get_by_role("dialog")).to_contain_text("The server does not answer")
    sheets = losing(phone, "/assets/.*json")
    lecture.evaluate("oscillations.walks.leave(); oscillations.open({scene: 'forced'})")
    phone.wait_for_function(f"{READY} && oscillations.page.spec.slug === 'forced'")
    assert len(sheets) == 2
