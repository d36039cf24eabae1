"""The countdown of a vote, in the hall, on a phone and on the remote control."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import expect

from tests.browser.classroom import LED, Open, joined, remote_of, taught
from tests.live_class.caller import call
from tests.serving.server import Server

pytestmark = pytest.mark.browser
THIRTY = re.compile("0:(30|2[0-9])")
FORTY_FIVE = re.compile("0:(4[0-5]|3[1-9])")


def test_it_is_seen_by_all_and_closes_the_vote_where_that_is_asked_for(server: Server, window: Open) -> None:
    lecture, code = taught(window, "walk=d31&step=d31-03&projector")
    lecture.set_viewport_size({"width": 1280, "height": 720})
    phone = joined(window, code)
    phone.wait_for_function("oscillations.asked.card")
    remote = remote_of(lecture, window)
    timers = [page.get_by_role("timer") for page in (lecture, phone, remote)]
    for timer in timers:
        expect(timer).to_have_count(0)  # hidden
    lecture.keyboard.press("d")
    for timer in timers:
        expect(timer).to_have_text(THIRTY)
    remote.get_by_role("button", name="15 s more").click()
    for timer in timers:
        expect(timer).to_have_text(FORTY_FIVE)
    lecture.get_by_role("button", name="Close at 0").click()
    expect(lecture.get_by_role("button", name="Close at 0")).to_have_attribute("aria-pressed", "true")
    remote.get_by_role("button", name="Stay open at 0").click()
    expect(lecture.get_by_role("button", name="Close at 0")).to_have_attribute("aria-pressed", "false")
    key = lecture.evaluate(f"{LED}.room.key")
    again = {"type": "put", "walk": "d31", "step": "d31-03", "vote": 2}
    for order in (again, {"type": "countdown", "seconds": 1, "closes": True}):
        assert call(server.url, f"/class/{code}/lead", "POST", order, key).status == 204
    expect(phone.get_by_text("The vote is closed.")).to_be_visible()
    for timer in timers:
        expect(timer).to_have_count(0)
