"""Requests of a class that fail or are answered late: later changes are kept."""

from __future__ import annotations

import json
import re

import pytest
from playwright.sync_api import APIResponse, Page, Request, Route, expect

from tests.browser.classroom import CONNECTED, LED, Open, joined
from tests.browser.fixtures import READY

pytestmark = pytest.mark.browser

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


def test_a_phone_stands_what_is_late_and_what_fails(failing: Open) -> None:
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
