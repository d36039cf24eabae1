"""An instructor goes back in a class: hall and phones show the same, and no vote is lost."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

from tests.browser.classroom import LED, Open, counted, draw, joined, put, taught
from tests.browser.waiting import clicked

pytestmark = pytest.mark.browser

WALK = {"d31-03": "choice", "d31-02": "number", "d34-08": "point", "d34-14": "sketch"}
"""A step of each kind of question."""
SENT = "You can change it"
QUESTION = "(({walk, step, vote, closed, answered, lesson}) => [walk, step, vote, closed, answered, Boolean(lesson)])"
FILLED = ".card .foot .filled"


def answered(phone: Page, kind: str) -> None:
    if kind == "choice":
        phone.locator(".answers [data-option='1']").click()
    elif kind == "number":
        phone.get_by_role("textbox", name="Your answer").fill("2")
    elif kind == "point":
        phone.locator(".pill-mark").press("ArrowRight")
    else:
        draw(phone, lambda x: 0.9 - 0.8 * x)
    expect(phone.get_by_text(SENT)).to_be_visible()


def shown(lecture: Page, phone: Page) -> None:
    """The votes, then the answer."""
    clicked(lecture)
    expect(lecture.locator(FILLED)).to_have_text("Show the answer")
    clicked(lecture)
    lecture.wait_for_function("oscillations.walks.walk.lesson")
    expect(phone.locator(".card .after > *").first).to_be_attached()  # with the reply to the phone's own answer


def alike(lecture: Page, phone: Page, *, is_answered: bool) -> None:
    """Hall and phone have the same information on the question, and no number on the phone is missing."""
    for page, news in ((lecture, f"{LED}.news"), (phone, "oscillations.news")):
        page.wait_for_function(f"is => {QUESTION}({news}.question)[4] === is", arg=is_answered)
    asked = [page.evaluate(f"{QUESTION}({news}.question)") for page, news in
             ((lecture, f"{LED}.news"), (phone, "oscillations.news"))]  # fmt: skip
    assert asked[0] == asked[1]
    told = "[...document.querySelectorAll('.card .after, .findings')].map(part => part.textContent).join()"
    assert "?" not in phone.evaluate(told)


@pytest.mark.parametrize(("step", "kind"), WALK.items(), ids=WALK.values())
def test_an_answer_that_is_taken_back_is_taken_back_for_all(window: Open, step: str, kind: str) -> None:
    lecture, code = taught(window, f"walk={step[:3]}&step={step}")
    phone = joined(window, code)
    put(lecture, phone, step)
    answered(phone, kind)
    shown(lecture, phone)
    clicked(lecture, "PageUp")
    expect(lecture.locator(FILLED)).to_have_text("Vote again")
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered. The answer has been shown.")
    expect(phone.get_by_text("This question has been answered. It takes no more answers.")).to_be_visible()
    assert phone.evaluate("oscillations.asked.card.question.element.inert && Boolean(oscillations.asked.given)")
    alike(lecture, phone, is_answered=True)
    lecture.get_by_role("button", name="Show the answer").click()
    expect(phone.locator(".card .after > *").first).to_be_attached()
    alike(lecture, phone, is_answered=False)
    clicked(lecture, "PageUp")
    expect(lecture.locator(FILLED)).to_have_text("Vote again")
    clicked(lecture)
    expect(phone.get_by_text("A new vote, number 2: answer once more.")).to_be_visible()
    answered(phone, kind)
    expect(lecture.locator(".votes")).to_contain_text("Vote 2: 1 of 1 have answered")
    alike(lecture, phone, is_answered=False)
    votes = lecture.evaluate(f"{LED}.votes.tally.before.answered")
    assert votes == 1, "the first vote is kept"


def test_a_step_that_was_answered_comes_back_with_its_answer(window: Open) -> None:
    lecture, code = taught(window, "walk=d31&step=d31-03")
    phone = joined(window, code)
    put(lecture, phone, "d31-03")
    answered(phone, "choice")
    shown(lecture, phone)
    clicked(lecture)
    clicked(lecture)
    lecture.wait_for_function(f"{LED}.news.question.step !== 'd31-03' && !oscillations.walks.walk.lesson")
    clicked(lecture, "PageUp")
    put(lecture, phone, "d31-03")
    lecture.wait_for_function("oscillations.walks.walk.lesson")
    expect(phone.locator(".card .after > *").first).to_be_attached()
    counted(lecture, "0", "1", "0")
    expect(lecture.locator(FILLED)).to_have_text("Show the explanation")
    clicked(lecture, "PageUp")
    expect(lecture.locator(FILLED)).to_have_text("Vote again")
    lecture.reload()
    expect(lecture.locator(FILLED)).to_have_text("Vote again")
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered. The answer has been shown.")
    clicked(lecture, "PageUp")
    lecture.wait_for_function(f"{LED}.news.question.step !== 'd31-03'")
    clicked(lecture)
    clicked(lecture)
    lecture.wait_for_function("oscillations.walks.walk.lesson")
    clicked(lecture)
    clicked(lecture)
    put(lecture, phone, "d31-03")
    expect(phone.locator(".card .after > *").first).to_be_attached()
