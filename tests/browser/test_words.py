"""Short answers in the hall: the remote control shows them one by one; markup stays text."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.browser.classroom import Open, joined, remote_of, taught, walked
from tests.browser.waiting import clicked

pytestmark = pytest.mark.browser
WALK = """title = "Why"
[[step]]
id = "why"
kind = "words"
title = "Energy goes to and fro"
state = "?scene=oscillator"
show = ["stage", "plot:x"]
question = "Why does it swing on?"
explain = "Energy goes to and fro."
"""
BOLD = "<b>Energy</b> 🙂"


@pytest.fixture
def window(tmp_path: Path, browser: Browser) -> Iterator[Open]:
    with walked(browser, tmp_path, "why", WALK) as go:
        yield go


def test_the_hall_sees_what_is_let_in_and_nothing_else(window: Open) -> None:
    lecture, code = taught(window, "walk=why&projector")
    lecture.set_viewport_size({"width": 1280, "height": 720})
    phones, remote = [joined(window, code) for _ in range(2)], remote_of(lecture, window)
    lecture.wait_for_function("oscillations.walks.walk?.step?.id === 'why'")
    for phone, text in zip(phones, (BOLD, "Rubbish"), strict=True):
        phone.wait_for_function("oscillations.asked.card")
        phone.get_by_label("Your answer in a few words").fill(text)
        expect(phone.get_by_text(f"Sent: {text}.")).to_be_visible()
    clicked(lecture)
    expect(lecture.get_by_text("2 answers wait for “Show” on the remote control")).to_be_visible()
    assert "Rubbish" not in lecture.locator("body").inner_text() and BOLD not in lecture.locator("body").inner_text()
    remote.get_by_role("listitem").filter(has_text="Rubbish").get_by_role("button", name="Remove").click()
    remote.get_by_role("listitem").filter(has_text=BOLD).get_by_role("button", name="Show").click()
    expect(lecture.locator(".words-shown li")).to_have_text([BOLD])
    expect(lecture.locator(".words-shown b")).to_have_count(0)
    expect(remote.get_by_role("button", name="Remove")).to_have_count(1)
    remote.get_by_role("button", name="Remove").click()
    expect(lecture.locator(".words-shown li")).to_have_count(0)
    lecture.keyboard.press("p")  # on the instructor's own screen there are buttons
    remote.get_by_role("button", name="Show the answer").click()
    expect(phones[0].get_by_text("Energy goes to and fro.")).to_be_visible()
