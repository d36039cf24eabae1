"""A phone of a class that loads its page again: another version of the page, and its own answers."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import expect

from tests.browser.classroom import Open, draw, joined, taught
from tests.browser.fixtures import READY, another_version
from tests.browser.waiting import passed
from tests.live_class.caller import call
from tests.serving.server import Server

pytestmark = pytest.mark.browser

COUNT = "sessionStorage.setItem('loads', 1 + Number(sessionStorage.getItem('loads')))"
LOADS = "sessionStorage.getItem('loads')"
VERSION = "document.documentElement.dataset.version[0]"
HEARD = "globalThis.oscillations?.news?.number"


def test_a_phone_of_another_version_loads_the_page_anew_and_not_again_at_once(server: Server, failing: Open) -> None:
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


RESENT = "oscillations.asked.given && oscillations.asked.delivery.isTaken(oscillations.asked.name)"
"""True if the server has the answer that the phone kept and sends again after a while."""


def test_a_phone_that_is_loaded_anew_has_its_answers(window: Open) -> None:
    lecture, code = taught(window, "walk=d34&step=d34-14")
    page = joined(window, code)
    draw(page, lambda x: 0.2 + 0.6 * x)
    expect(page.get_by_text("You can change it")).to_be_visible()
    drawn = page.evaluate("oscillations.asked.card.question.pad.sent")
    page.reload()
    page.wait_for_function(f"{READY} && oscillations.asked?.card && oscillations.asked.given")
    again = page.evaluate("oscillations.asked.card.question.pad.sent")
    assert again == drawn and len(again["Xp1"]) == 101
    expect(page.get_by_text("You can change it")).to_be_visible()
    page.wait_for_function(RESENT)  # otherwise it meets the next question, and is refused
    lecture.evaluate("oscillations.walks.walk.go(7)")  # d34-08, a point
    page.wait_for_function("oscillations.asked?.card?.question.marker")
    page.locator(".pill-mark").press("ArrowRight")
    expect(page.get_by_text("You can change it")).to_be_visible()
    marked = page.evaluate("oscillations.asked.card.question.marker.value")
    page.reload()
    page.wait_for_function("globalThis.oscillations?.asked?.card?.question.marker")
    assert page.evaluate("oscillations.asked.card.question.marker.value") == marked
    page.wait_for_function(RESENT)
    assert page.evaluate("Object.keys(localStorage).filter(key => key.startsWith('class-')).length") == 1
    lecture.evaluate("oscillations.classes.led.end()")
    expect(page.get_by_role("heading", name="The class is over.")).to_be_visible()
    assert page.evaluate("Object.keys(localStorage).filter(key => key.startsWith('class-')).length") == 0
