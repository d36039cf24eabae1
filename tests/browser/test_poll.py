"""A poll between two steps of a walk, and the question of how sure the class is."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.classroom import Open, counted, joined, remote_of, taught, walked
from tests.browser.waiting import clicked

pytestmark = pytest.mark.browser
WALK = """title = "Three"
[[step]]
id = "first"
from = "d34-04"

[[step]]
id = "speed"
poll = true
question = "How fast is this?"
options = [{ text = "Too fast" }, { text = "Right" }, { text = "Too slow" }]

[[step]]
id = "last"
from = "d34-07"
"""
AT = "id => oscillations.walks.walk?.step?.id === id"


@pytest.fixture
def window(tmp_path: Path, browser: Browser) -> Iterator[Open]:
    with walked(browser, tmp_path, "three", WALK) as go:
        yield go


@pytest.fixture
def class_of(window: Open) -> tuple[Page, Page, Page]:
    """The instructor's page, a phone and a remote control."""
    lecture, code = taught(window, "walk=three&projector")
    lecture.set_viewport_size({"width": 1280, "height": 720})
    phone, remote = joined(window, code), remote_of(lecture, window)
    phone.wait_for_function("oscillations.asked.card")
    return lecture, phone, remote


def test_a_poll_is_between_two_steps(class_of: tuple[Page, Page, Page]) -> None:
    lecture, phone, _ = class_of
    for _ in range(5):  # votes, answer, explanation, formulas, the poll
        clicked(lecture)
    lecture.wait_for_function(AT, arg="speed")
    expect(lecture.locator(".card .foot .filled")).to_have_text("Show the votes")
    phone.get_by_role("button", name="Right").click()
    expect(phone.get_by_text("Sent: Right. You can change it until the vote is closed.")).to_be_visible()
    clicked(lecture)
    counted(lecture, "0", "1", "0")
    clicked(lecture)
    lecture.wait_for_function(AT, arg="last")
    clicked(lecture, "PageUp")
    lecture.wait_for_function(AT, arg="speed")


def test_how_sure_the_class_is_can_be_asked_with_any_vote(class_of: tuple[Page, Page, Page]) -> None:
    lecture, phone, remote = class_of
    expect(phone.get_by_role("group", name="How sure are you?")).to_be_hidden()
    lecture.keyboard.press("s")
    phone.get_by_role("button", name="Neither").click()
    phone.get_by_role("button", name="Fairly sure").click()
    expect(phone.get_by_text("Sent: Neither")).to_be_visible()
    expect(remote.get_by_text("How sure: 0 guessed, 1 fairly sure (1 right), 0 certain")).to_be_visible()
    expect(remote.get_by_role("button", name="How sure?")).to_have_count(0)  # it is asked
    clicked(lecture)
    expect(lecture.locator(".votes .sure")).to_have_text("How sure: 0 guessed, 1 fairly sure, 0 certain")
    clicked(lecture)
    expect(lecture.locator(".votes .sure")).to_contain_text("1 fairly sure (1 right)")
