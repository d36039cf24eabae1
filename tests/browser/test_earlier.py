"""The votes of an earlier class, from its CSV, outlined next to today's."""

from __future__ import annotations

import pytest
from playwright.sync_api import FilePayload, Page, expect

from tests.browser.classroom import Open, counted, joined, taught
from tests.browser.waiting import clicked

pytestmark = pytest.mark.browser
HEAD = "phone,time,here,walk,step,vote,question,answer,unit,right,sure\r\n"
ROW = "{},,9,d31,d31-03,1,How long?,{},,no,\r\n"
ANSWERS = ["Just as long as it did before"] * 3 + ["Longer: the distance is longer"]
TABLE = HEAD + "".join(ROW.format(i, answer) for i, answer in enumerate(ANSWERS))
CHOSEN = "Votes of an earlier class"


def choose(lecture: Page, text: str) -> None:
    with lecture.expect_file_chooser() as chooser:
        lecture.get_by_role("button", name=CHOSEN).click()
    table: FilePayload = {"name": "class.csv", "mimeType": "text/csv", "buffer": text.encode()}
    chooser.value.set_files(table)


def test_their_split_is_outlined_and_a_file_that_is_none_of_this_walk_is_refused(window: Open) -> None:
    lecture, code = taught(window, "walk=d31&step=d31-03&projector")
    lecture.set_viewport_size({"width": 1280, "height": 720})
    phone = joined(window, code)
    phone.wait_for_function("oscillations.asked.card")
    phone.locator(".answers [data-option='1']").click()
    lecture.keyboard.press("j")
    choose(lecture, TABLE.replace(",d31,", ",mine,"))
    expect(lecture.get_by_text("Its answers belong to the walk “mine”. Open")).to_be_visible()
    choose(lecture, "<html>🙂")
    expect(lecture.get_by_text("This is not the CSV of a class")).to_be_visible()
    choose(lecture, TABLE)
    expect(lecture.get_by_text("Its votes on 1 question are outlined.")).to_be_visible()
    lecture.keyboard.press("j")
    clicked(lecture)
    expect(lecture.locator(".votes [role=status]")).to_have_text("1 of 1 have answered, outlined: earlier class")
    counted(lecture, "3 → 0", "1 → 1", "0 → 0")
    shares = "bars => bars.map(bar => bar.style.getPropertyValue('--share'))"
    assert sorted(lecture.locator(".vote-bar .before").evaluate_all(shares)) == ["0.25", "0.75"]
