"""The lead of a class moves to another computer, which continues in the same state; the old one keeps its picture."""

from __future__ import annotations

import re
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.classroom import CONNECTED, LED, Open, joined, taught
from tests.browser.waiting import QUIET, clicked, passed
from tests.serving.server import Server

pytestmark = pytest.mark.browser

STEP = "d31-02"
"""Its numbers differ between visitors, but not within a class."""
ASKED = "One swing takes 1.00 s."
LAID = """[...document.querySelectorAll("h1, .paper .block, .card, .card .asks, .class-corner, .foot *")].map(one => {
  const {x, y, width, height} = one.getBoundingClientRect()
  return [one.className, Math.round(x), Math.round(y), Math.round(width), Math.round(height)]
})"""
SHOWN = """JSON.stringify([oscillations.shown.state, oscillations.walks.walk.numbers,
  document.querySelector("h1").innerHTML])"""


def handed_over(lecture: Page) -> str:
    """The link with which another computer takes the lead."""
    lecture.keyboard.press("j")
    with lecture.expect_response(re.compile("/word$")) as answer:
        lecture.get_by_role("button", name="Another computer").click()
    lecture.keyboard.press("j")
    expect(lecture.get_by_role("dialog")).to_have_count(0)
    address: str = answer.value.json()["address"]
    return address


def picture(page: Page) -> tuple[Any, Any]:
    page.wait_for_function(QUIET)
    passed(page)
    return page.evaluate(LAID), page.evaluate(SHOWN)


@pytest.mark.parametrize("is_taught", [False, True], ids=["asked", "taught"])
@pytest.mark.parametrize("mode", ["&projector", ""], ids=["hall", "desk"])
def test_another_computer_takes_the_lead_in_the_current_state(
    server: Server, browser: Browser, window: Open, mode: str, is_taught: bool
) -> None:
    lecture, code = taught(window, f"walk=d31&step={STEP}{mode}")
    phone = joined(window, code)
    phone.get_by_role("textbox", name="Your answer").fill("2")
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered")
    if is_taught:
        clicked(lecture)
        clicked(lecture)
        lecture.wait_for_function(f"oscillations.walks.walk.lesson && {LED}.news.question.lesson")
    lecture.evaluate("oscillations.clock.playing = false; oscillations.clock.seek(0)")
    address = handed_over(lecture)
    laid, shown = picture(lecture)
    context = browser.new_context(viewport={"width": 1920, "height": 1080}, bypass_csp=True)  # another computer
    other = context.new_page()
    other.goto(address)
    other.wait_for_function(f"{LED}?.news.number && {LED}.votes.tally?.now.answered === 1 && {CONNECTED}")
    expect(lecture.get_by_text("led by another computer").locator("visible=true")).to_have_count(1)
    expect(lecture.locator(".notice")).to_be_hidden()
    now, stands = picture(lecture)
    assert stands == shown
    assert is_taught or now == laid
    assert other.evaluate("document.documentElement.dataset.mode ?? ''") == mode[1:]
    assert bool(other.evaluate("oscillations.walks.walk.lesson")) == is_taught
    for page in (lecture, other, phone):
        question = page.locator(".card .asks, .asked-line, h1").filter(has_text="One swing takes")
        expect(question.first).to_contain_text(ASKED)
    clicked(other, "PageUp")
    if is_taught:
        expect(other.locator(".card .foot .filled")).to_have_text("Vote again")
    else:
        other.wait_for_function(f"{LED}.news.question.step === 'd31-01'")
    assert not lecture.evaluate(LED)
    context.close()
