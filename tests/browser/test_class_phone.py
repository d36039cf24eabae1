"""Votes on a phone and in the hall: answers, counts, an earlier class, a countdown, other numbers on each phone."""

from __future__ import annotations

import math
import re

import pytest
from playwright.sync_api import FilePayload, Page, expect

from tests.browser.classroom import LED, Open, counted, joined, remote_of, taught
from tests.browser.waiting import clicked
from tests.live_class.caller import call
from tests.serving.server import Server

pytestmark = pytest.mark.browser
WAITS = ".card-body > .hint[role=status]"


@pytest.mark.parametrize("size", [(390, 844), (844, 390)])
def test_a_choice(size: tuple[int, int], window: Open) -> None:
    lecture, code = taught(window, "walk=d31&step=d31-03&projector")
    phone, other = joined(window, code, *size), joined(window, code)
    for one, option in ((phone, 1), (other, 0)):
        one.wait_for_function("oscillations.asked.card")
        one.locator(f".answers [data-option='{option}']").click()
    expect(phone.locator(WAITS)).to_contain_text("Sent: Longer: the distance is longer. You can change it until")
    expect(phone.locator(WAITS)).to_contain_text("2 of 2 have answered.")
    for _ in range(2):
        clicked(lecture)
    expect(phone.locator(WAITS)).to_have_text("1 of 2 is right.")
    expect(phone.locator(".answers .vote-count")).to_have_count(3)
    assert phone.locator(".answers .vote-count").all_inner_texts().count("1") == 2
    expect(phone.locator(".answers [data-option='1']")).to_contain_text("your answer")
    expect(phone.locator(".answers [data-option='1'] .line")).not_to_be_empty()
    expect(phone.locator(".card .try")).to_have_count(0)  # there is no slider
    own = phone.get_by_role("link", name="Try it on your own")
    own.click()
    expect(phone.get_by_role("slider").first).to_be_visible()
    expect(phone.get_by_role("link", name="Back to the lecture")).to_be_visible()


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


ASKED = "globalThis.oscillations?.walks?.walk?.card && oscillations.walks.walk.numbers"
CLASS = f"{ASKED} === 0 && oscillations.shown.state.step === 'd31/d31-02'"


def stiffness(page: Page) -> float:
    page.wait_for_function(f"{ASKED} > 0")
    return float(page.evaluate("oscillations.shown.settings.k.value"))


def test_a_visitor_has_numbers_that_stay_and_a_class_those_of_the_file(window: Open) -> None:
    page = window("walk=d31&step=d31-02", 1280, 720)
    k = stiffness(page)
    query = page.evaluate("location.search")
    assert query.startswith("?walk=d31&step=d31-02&seed=")
    expect(page.locator(".card .given").first).to_contain_text(f"{2 * math.pi / math.sqrt(k):.3g}"[:4])
    page.get_by_label("Your answer").fill(f"{4 * math.pi / math.sqrt(k):.2f}")
    page.get_by_role("button", name="Show the answer", exact=True).click()
    page.wait_for_function("oscillations.walks.walk.lesson?.right")
    page.reload()
    assert stiffness(page) == k and page.evaluate("location.search") == query
    page.evaluate("oscillations.walks.walk.go(2)")
    page.wait_for_function("oscillations.shown.state.step === 'd31/d31-03'")
    page.evaluate("oscillations.walks.walk.go(1)")
    assert stiffness(page) == k, "the same visitor has the same numbers"

    page.evaluate("oscillations.classes.begin()")
    page.wait_for_function(LED)
    page.wait_for_function(CLASS)
    expect(page.locator(".card .given").first).to_contain_text("1.00 s")
    phone = joined(window, page.evaluate(f"{LED}.room.code"))
    phone.wait_for_function("oscillations.asked.card?.step === undefined && oscillations.asked.question?.step")
    expect(phone.locator(".card .given")).to_contain_text("1.00 s")
    page.evaluate("oscillations.walks.walk.go(2)")
    page.wait_for_function("oscillations.shown.state.step === 'd31/d31-03'")
    page.evaluate("oscillations.walks.walk.go(1)")
    page.wait_for_function(CLASS)
    page.reload()
    page.wait_for_function(f"{LED} && {CLASS}")
