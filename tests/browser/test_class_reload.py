"""Pages of a class that load again, and requests that fail or are answered late: nothing is lost."""

from __future__ import annotations

import json
import re

import pytest
from playwright.sync_api import APIResponse, Page, Request, Route, expect

from tests.browser.classroom import CONNECTED, LED, Open, draw, joined, taught
from tests.browser.fixtures import READY, another_version
from tests.browser.waiting import passed
from tests.live_class.caller import call
from tests.serving.server import Server

pytestmark = pytest.mark.browser

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


RESENT = "oscillations.asked.given && oscillations.asked.delivery.isTaken(oscillations.asked.name)"
"""True if the server has the answer that the phone kept and sends again after a while."""


def test_a_reloaded_phone_has_its_answers(window: Open) -> None:
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


ANSWERS = "code => Object.keys(JSON.parse(localStorage.getItem(`class-${code}`)).answers)"
GO = "place => oscillations.walks.walk.go(place)"


def put(phone: Page, step: str) -> None:
    phone.wait_for_function("step => oscillations.asked.question?.step === step && oscillations.asked.card", arg=step)


def losing(page: Page, path: str, kind: str = "") -> list[str]:
    """Let the first request to a path get no answer; return the data that was sent to it, in order."""
    sent: list[str] = []

    def go(route: Route) -> None:
        told = json.loads(route.request.post_data or "{}")
        if told.get("type", "") == kind:
            sent.append(told.get("step", route.request.url))
            if len(sent) == 1:
                return route.abort()
        return route.continue_()

    page.route(re.compile(path), go)
    return sent


def test_a_class_is_opened_once_and_no_order_is_overtaken(failing: Open) -> None:
    lecture = failing("walk=d31&step=d31-01", 1920, 1080)
    lecture.wait_for_function(CONNECTED)
    opened: list[Request] = []

    def note(request: Request) -> None:
        if request.url.endswith("/class"):
            opened.append(request)

    lecture.on("request", note)
    lecture.evaluate("oscillations.classes.begin(); oscillations.classes.begin()")
    lecture.wait_for_function(LED)
    phone = joined(failing, lecture.evaluate(f"{LED}.room.code"))
    put(phone, "d31-01")
    sent = losing(lecture, "/lead$", "put")
    lecture.evaluate(GO, 1)
    lecture.evaluate(GO, 2)
    put(phone, "d31-03")
    assert sent == ["d31-02", "d31-02", "d31-03"]
    assert len(opened) == lecture.locator(".class-code").count() == 1
    losing(lecture, "/tally$")
    phone.locator(".answers [data-option='0']").click()
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered")  # a count that is lost is requested again
    losing(lecture, "/tickets$")
    lecture.keyboard.press("j")
    lecture.get_by_role("button", name="Remote control").click()
    expect(lecture.get_by_role("dialog")).to_contain_text("The server does not answer")


def test_a_phone_survives_late_and_failing_requests(failing: Open) -> None:
    lecture = failing("walk=d31&step=d31-01", 1920, 1080)
    lecture.wait_for_function(CONNECTED)
    lecture.keyboard.press("t")
    lecture.wait_for_function(LED)
    code = lecture.evaluate(f"{LED}.room.code")
    phone = joined(failing, code)
    put(phone, "d31-01")
    late: list[tuple[Route, APIResponse]] = []
    phone.route(re.compile("/answer$"), lambda route: late.append((route, route.fetch())))
    with phone.expect_request(re.compile("/answer$")):
        phone.locator(".answers [data-option='0']").click()
    phone.locator(".answers [data-option='1']").click()
    phone.wait_for_timeout(600)  # longer than it waits for another change
    assert len(late) == 1  # the second is not sent before the first has arrived, because it might overtake
    lecture.evaluate(GO, 2)
    put(phone, "d31-03")
    late[0][0].fulfill(response=late[0][1])
    phone.wait_for_function(f"code => ({ANSWERS})(code).length", arg=code)
    assert phone.evaluate(ANSWERS, code) == ["d31/d31-01/1"]
    expect(phone.get_by_text("Sent.")).to_have_count(0)
    phone.unroute_all()
    asked = losing(phone, "/assets/.*json")
    lecture.evaluate("oscillations.walks.leave(); oscillations.open({scene: 'forced'})")
    phone.wait_for_function(f"{READY} && oscillations.page.spec.slug === 'forced'")
    assert len(asked) == 2  # a sheet that did not arrive is fetched again
    nowhere: list[Route] = []

    def once(route: Route) -> None:
        nowhere.append(route)
        if len(nowhere) > 1:
            return route.continue_()
        return route.fulfill(status=404, json={"sentence": "No class has this code now."})

    phone.route(re.compile("/events"), once)
    phone.reload()  # while the shared store is refilled, no replica knows the room
    phone.wait_for_function(f"{READY} && oscillations.news.number")
