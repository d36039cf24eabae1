"""A lecture with an instructor, a remote control and two phones, each a browser window."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Page, expect

from tests.browser.classroom import CONNECTED, LED, Open, counted, joined, remote_of, taught
from tests.browser.fixtures import READY
from tests.browser.waiting import clicked
from tests.live_class.caller import call
from tests.serving.server import Server

pytestmark = pytest.mark.browser


def by_another_window(lecture: Page) -> None:
    """An answer that one window of the instructor shows is visible in the others."""
    second = lecture.context.new_page()
    second.goto(lecture.url)
    second.wait_for_function(CONNECTED)
    second.keyboard.press("t")
    second.wait_for_function(f"{LED}?.news.question && oscillations.walks.walk.lesson")
    for page in (lecture, second):
        page.evaluate("oscillations.walks.walk.go(12)")
        page.wait_for_function("oscillations.walks.walk.place === 12 && oscillations.classes.led.votes.isUnopened")
    second.evaluate("oscillations.walks.walk.show(true)")
    lecture.wait_for_function("oscillations.walks.walk.lesson")


def voted_again(lecture: Page, phones: list[Page]) -> None:
    """The class votes again after a discussion, until the vote is closed; the first result is hidden meanwhile."""
    lecture.get_by_role("button", name="Vote again").click()
    expect(lecture.locator(".votes")).to_contain_text("0 of 2 have answered")
    expect(lecture.locator(".votes")).to_contain_text("Vote 2:")
    assert lecture.locator(".vote-bar").count() == 0  # a student who votes again does not see the others' votes
    for phone in phones:
        phone.wait_for_function("oscillations.asked.question.vote === 2 && oscillations.asked.card")
        expect(phone.get_by_text("A new vote, number 2: answer once more.")).to_be_visible()
        phone.locator(".answers [data-option='1']").click()
    expect(lecture.locator(".votes")).to_contain_text("2 of 2 have answered")
    lecture.get_by_role("button", name="Close the vote").click()
    expect(phones[0].get_by_text("The vote is closed.")).to_be_visible()
    assert phones[0].evaluate("oscillations.asked.card.question.element.inert")
    clicked(lecture)
    counted(lecture, "1 → 0", "1 → 2", "0 → 0", "0 → 0")


def test_a_question_is_asked_answered_twice_and_shown(window: Open) -> None:
    lecture, code = taught(window, "walk=d34&step=d34-12")
    phones = [joined(window, code) for _ in range(2)]
    for i, phone in enumerate(phones):
        phone.locator(f".answers [data-option='{i}']").click()
        expect(phone.get_by_text("You can change it")).to_be_visible()
    expect(lecture.locator(".votes")).to_contain_text("2 of 2 have answered")
    assert lecture.locator(".vote-bar").count() == 0  # first the number of answers is visible, then the answers
    clicked(lecture)
    counted(lecture, "1", "1", "0", "0")
    voted_again(lecture, phones)
    lecture.reload()
    lecture.wait_for_function(f"{CONNECTED} && {LED}")
    assert lecture.evaluate(f"{LED}.room.code") == code
    expect(lecture.locator(".votes")).to_contain_text("2 of 2 have answered")
    clicked(lecture)
    clicked(lecture)
    for phone in phones:
        expect(phone.locator("h1")).to_have_text("Undamped motion never becomes steady")
        expect(phone.locator(".answers [data-option='1']")).to_contain_text("your answer")
    lecture.wait_for_function("oscillations.clock.playing")
    phones[0].wait_for_function("oscillations.clock.playing")
    lecture.keyboard.press("Space")
    at = lecture.evaluate("oscillations.clock.t")
    for phone in phones:
        phone.wait_for_function("t => !oscillations.clock.playing && Math.abs(oscillations.clock.t - t) < 1e-6", arg=at)
        assert phone.evaluate("oscillations.timing.bound") < 1000
    lecture.reload()
    lecture.wait_for_function("oscillations.walks.walk?.lesson")  # a question whose answer was shown is not asked again
    counted(lecture, "1 → 0", "1 → 2", "0 → 0", "0 → 0")
    phones[0].wait_for_function(
        "oscillations.asked.question.vote === 2 && oscillations.asked.card.walk.lesson !== null"
    )
    by_another_window(lecture)


def test_who_looks_around_cannot_show_the_step_that_the_lecture_asks(window: Open) -> None:
    lecture, code = taught(window, "walk=d34&step=d34-12")
    own = joined(window, code)
    own.get_by_role("button", name="Only the drive's, in the end").click()
    expect(own.get_by_text("You can change it")).to_be_visible()
    clicked(lecture)
    clicked(lecture)
    own.locator(".replied").get_by_text(
        "Show such a case"
    ).click()  # the case that a reply mentions opens on the student's own page
    own.wait_for_function(f"{CONNECTED} && oscillations.shown.state.scene === 'forced' && oscillations.walks")
    own.wait_for_function("oscillations.shown.state.parameters.c1 === 0.4")
    expect(own.locator(".class-bar")).to_contain_text("On your own")
    assert own.evaluate("!oscillations.shown.state.step && !oscillations.shown.state.covered.length")
    own.get_by_text("Back to the lecture").click()
    own.wait_for_function(f"{READY} && oscillations.asked?.card")
    own.get_by_text("Try it on your own").click()  # and it is not searched again
    own.wait_for_function(f"{CONNECTED} && !globalThis.sessionStorage['class-sought']")
    lecture.evaluate("oscillations.walks.walk.go(4)")
    own.goto(f"{own.url.partition('?')[0]}?walk=d34&step=d34-05")
    own.wait_for_function(f"{CONNECTED} && oscillations.classes.askedStep === 'd34/d34-05'")
    own.locator(".answers button").first.click()
    own.get_by_role("button", name="Show the answer").click()
    expect(own.get_by_role("alert").filter(has_text="The lecture is at this step now.")).to_be_visible()
    clicked(lecture)
    clicked(lecture)
    own.wait_for_function("oscillations.classes.askedStep === ''")
    own.get_by_role("button", name="Show the answer").click()
    own.wait_for_function("Boolean(oscillations.walks.walk.lesson)")


def test_a_remote_control_is_let_in_and_turns_the_pages(window: Open) -> None:
    lecture, _ = taught(window, "walk=d31&step=d31-01")
    lecture.keyboard.press("j")
    with lecture.expect_response(re.compile("/tickets$")) as answer:
        lecture.get_by_role("button", name="Remote control").click()
    query = answer.value.json()["address"].partition("?")[2]
    lecture.keyboard.press("j")
    dialog = lecture.get_by_role("dialog")
    expect(dialog).to_have_count(0)
    remote = window(query, 390, 844)
    expect(remote.locator("h1")).to_have_text(re.compile(r"^\d\d$"))
    asked = f"show {remote.locator('h1').inner_text()}?"
    expect(dialog).to_contain_text(asked)  # it opens on its own, and asks while the phone waits
    lecture.keyboard.press("j")
    lecture.keyboard.press("j")
    expect(dialog).to_contain_text(asked)
    lecture.reload()
    expect(dialog).to_contain_text(asked)
    lecture.get_by_role("button", name="Yes, connect it").click()
    remote.get_by_role("button", name="Close").click()
    expect(lecture.get_by_role("dialog", name="Join the class")).to_have_count(0)
    remote.get_by_role("button", name="Show the answer").click()
    lecture.wait_for_function("oscillations.walks.walk.lesson")
    remote.get_by_role("button", name="How it follows").click()
    expect(lecture.locator(".card .follows .lines")).to_be_visible()
    expect(lecture.locator(".card .why")).to_be_visible()
    remote.get_by_role("button", name="Next").click()
    lecture.wait_for_function("oscillations.shown.state.step === 'd31/d31-02'")
    expect(remote.locator(".class-remote > [role=status]")).to_contain_text("2 of 16")
    remote.get_by_role("button", name="Contents").click()
    remote.get_by_role("button", name="Where energy goes back and forth").click()
    lecture.wait_for_function("oscillations.shown.state.step === 'd31/d31-11'")
    expect(remote.get_by_role("button", name="Show the votes")).to_be_visible()


def test_a_key_asks_for_a_vote_on_what_is_said_aloud_and_leads_back(window: Open) -> None:
    """An open step shows nothing by itself. A class without a walk votes too."""
    lecture, code = taught(window, "walk=d34&step=d34-04&projector")
    phone = joined(window, code)
    phone.wait_for_function("oscillations.asked.question?.step === 'd34-04'")
    covered = lecture.evaluate("oscillations.shown.state.covered")
    lecture.keyboard.press("v")
    phone.wait_for_function("oscillations.asked.question?.step === 'vote-1' && oscillations.asked.card")
    assert covered and lecture.evaluate("oscillations.shown.state.covered") == covered
    phone.get_by_role("button", name="B", exact=False).and_(phone.locator("[data-option='1']")).click()
    expect(phone.get_by_text("You can change it until the vote is closed.")).to_be_visible()
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered")
    clicked(lecture)
    counted(lecture, "0", "1", "0", "0")
    expect(lecture.locator(".card .foot .filled")).to_have_text("Go on")
    clicked(lecture)
    lecture.wait_for_function("oscillations.walks.walk?.step?.id === 'd34-04'")
    phone.wait_for_function("oscillations.asked.question?.step === 'd34-04'")
    lecture.keyboard.press("w")
    lecture.wait_for_function("!oscillations.walks.walk")
    lecture.keyboard.press("v")
    phone.wait_for_function("oscillations.asked.question?.step === 'vote-2' && oscillations.asked.card")
    expect(phone.locator(".card .given")).to_have_text("Vote 2.")


BUZZES = """() => { globalThis.buzzes = 0
  Object.defineProperty(navigator, "vibrate", {value: () => { globalThis.buzzes += 1; return true }}) }"""
PRESSES = ("Show the votes", "Show the answer", "Show the explanation", "How it follows", "Next")
CLOSES = "Close the QR code"


def offered(remote: Page) -> list[str]:
    """The texts of its buttons, the next action last."""
    return remote.locator(".remote-deeds .act:visible").all_inner_texts()


def answered(server: Server, code: str, options: list[int]) -> None:
    for option in options:
        token = call(server.url, f"/class/{code}/token", "POST").json["token"]
        call(server.url, f"/class/{code}/now", word=token)
        given = {"walk": "d34", "step": "d34-04", "option": option}
        assert call(server.url, f"/class/{code}/answer", "PUT", given, token).status == 204


@pytest.mark.parametrize(("width", "height"), [(390, 844), (844, 390)])
def test_it_says_what_the_class_answers_and_what_the_next_press_does(
    width: int, height: int, server: Server, window: Open
) -> None:
    lecture, code = taught(window, "walk=d34&step=d34-04&projector")
    phone = joined(window, code)
    remote = remote_of(lecture, window, width, height)
    remote.evaluate(BUZZES)
    body = remote.locator(".remote-body")
    expect(body).to_contain_text("0 of 1 have answered")
    answered(server, code, [0, 0, 1, 2, 3])
    expect(body).to_contain_text("5 of 6 have answered")
    expect(body).to_contain_text("40 % are right: let them talk, then vote again.")
    expect(body.locator(".right-vote")).to_contain_text("Neither: there are always exactly two")
    expect(body.locator(".right-vote b")).to_have_text("2")
    phone.wait_for_function("oscillations.asked.card")
    phone.locator(".answers button").first.click()
    remote.wait_for_function("globalThis.buzzes > 0")  # all have answered
    for words in PRESSES:
        expect(remote.locator(".remote-deeds .filled")).to_have_text(words)
        assert CLOSES not in offered(remote)
        assert ("Vote again" in offered(remote)) == (words == "Show the answer")
        remote.locator(".remote-deeds .filled").click()
    lecture.wait_for_function("oscillations.walks.walk.step.id === 'd34-05'")
    lecture.keyboard.press("j")
    remote.get_by_role("button", name=CLOSES).click()
    expect(lecture.get_by_role("dialog", name="Join the class")).to_have_count(0)
    remote.get_by_role("button", name="Blank the screen").click()
    remote.get_by_role("button", name="Show the screen").click()
    expect(lecture.locator(".blank")).to_have_count(0)
    assert not remote.evaluate("document.documentElement.scrollWidth > innerWidth")
