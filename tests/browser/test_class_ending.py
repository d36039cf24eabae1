"""The end of a class: the page says what it deletes and offers the CSV; with keys, and by the remote control."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Page, expect

from tests.browser.classroom import LED, Open, joined, taught

pytestmark = pytest.mark.browser
DELETES = "This deletes 1 answer to 1 question. The code stops working, and phones leave the class."


def asked(lecture: Page) -> None:
    """The class is still open, and the page asks whether to end it."""
    expect(lecture.get_by_role("dialog", name="End the class")).to_contain_text(DELETES)
    assert lecture.evaluate(f"{LED} && !{LED}.isOver")


def with_an_answer(window: Open) -> tuple[Page, Page]:
    lecture, code = taught(window, "walk=d31&step=d31-03&projector")
    phone = joined(window, code)
    phone.locator(".answers [data-option='1']").click()
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered")
    return lecture, phone


def test_the_end_of_a_class_says_what_it_deletes_and_offers_the_csv(window: Open) -> None:
    lecture, phone = with_an_answer(window)
    for cancel in ("Escape", "Cancel"):
        lecture.keyboard.press("j")
        lecture.get_by_role("button", name="End the class").click()
        asked(lecture)
        for page_key in ("PageDown", "PageUp"):  # a clicker does not end a class
            lecture.keyboard.press(page_key)
        asked(lecture)
        if cancel == "Escape":
            lecture.keyboard.press("Escape")
        else:
            lecture.get_by_role("button", name="Cancel").click()
        expect(lecture.get_by_role("dialog", name="End the class")).to_have_count(0)
        assert lecture.evaluate(f"{LED} && !{LED}.isOver")
        lecture.keyboard.press("j")
    lecture.keyboard.press("j")
    lecture.get_by_role("button", name="End the class").press("Enter")
    asked(lecture)
    with lecture.expect_download() as download:
        lecture.keyboard.press("Enter")  # the filled button saves
    assert re.fullmatch(r"class-\w{4}\.csv", download.value.suggested_filename)
    expect(lecture.get_by_text("Saved as class-")).to_be_visible()
    lecture.keyboard.press("Enter")  # the next press ends the class
    expect(phone.get_by_role("heading", name="The class is over.")).to_be_visible()
    expect(lecture.get_by_text("The class is over.")).to_be_visible()
    expect(lecture.get_by_role("dialog")).to_have_count(0)


def test_a_class_without_answers_has_none_to_save(window: Open) -> None:
    lecture, _ = taught(window, "scene=energy")
    lecture.keyboard.press("j")
    lecture.get_by_role("button", name="End the class").click()
    dialog = lecture.get_by_role("dialog", name="End the class")
    expect(dialog).to_contain_text("Nobody has answered yet.")
    expect(dialog.get_by_role("button").first).to_have_text("Cancel")
    expect(dialog.get_by_role("button", name="Save")).to_have_count(0)
    lecture.keyboard.press("Enter")
    expect(dialog).to_have_count(0)
    assert lecture.evaluate(f"{LED} && !{LED}.isOver")


def test_the_remote_control_asks_on_the_first_screen_before_it_ends_a_class(failing: Open) -> None:
    lecture, phone = with_an_answer(failing)
    lecture.keyboard.press("j")
    with lecture.expect_response(re.compile("/tickets$")) as answer:
        lecture.get_by_role("button", name="Remote control").click()
    remote = failing(answer.value.json()["address"].partition("?")[2], 390, 844)
    lecture.get_by_role("button", name="Yes, connect it").click()
    remote.get_by_role("button", name="End the class").click()
    asked(lecture)
    remote.get_by_role("button", name="Cancel").click()
    expect(lecture.get_by_role("dialog", name="End the class")).to_have_count(0)
    assert lecture.evaluate(f"{LED} && !{LED}.isOver")
    remote.get_by_role("button", name="End the class").click()
    asked(lecture)
    remote.get_by_role("button", name="End the class").click()
    expect(remote.get_by_role("heading", name="The class is over.")).to_be_visible()
    expect(phone.get_by_role("heading", name="The class is over.")).to_be_visible()
