"""The instructor's other means: a remote control, a countdown, votes aloud or of an earlier class, other computers."""

from __future__ import annotations

import math
import re

import pytest
from playwright.sync_api import Browser, FilePayload, Page, expect

from tests.browser.classroom import CONNECTED, FILLED, LED, Open, counted, explained, joined, put, tap, taught, ticket
from tests.browser.fixtures import READY
from tests.browser.tabs import calm_context
from tests.browser.waiting import QUIET, clicked
from tests.live_class.caller import call
from tests.serving.server import Server

pytestmark = pytest.mark.browser
BUZZES = """() => { globalThis.buzzes = 0
  Object.defineProperty(navigator, "vibrate", {value: () => { globalThis.buzzes += 1; return true }}) }"""
PRESSES = ("Show the votes", "Show the answer", "Show the explanation", "Next")
CLOSES = "Close the QR code"
HEAD = "phone,time,here,walk,step,vote,question,answer,unit,right,sure\r\n"
ANSWERS = ["Just as long as it did before"] * 3 + ["Longer: the distance is longer"]
TABLE = HEAD + "".join(f"{i},,9,d31,d31-03,1,How long?,{answer},,no,\r\n" for i, answer in enumerate(ANSWERS))
THIRTY = re.compile("0:(30|2[0-9])")
FORTY_FIVE = re.compile("0:(4[0-5]|3[1-9])")
SHOWN = """JSON.stringify([oscillations.shown.state, oscillations.walks.walk.numbers,
  document.querySelector("h1").innerHTML])"""


def let_in(lecture: Page, window: Open) -> Page:
    """The instructor's page asks on its own, also after a reload, while the phone waits."""
    query = ticket(lecture, "Remote control", "tickets").partition("?")[2]
    lecture.keyboard.press("j")
    dialog = lecture.get_by_role("dialog")
    expect(dialog).to_have_count(0)
    remote = window(query, 390, 844)
    expect(remote.locator("h1")).to_have_text(re.compile(r"^\d\d$"))
    for _ in range(2):
        expect(dialog).to_contain_text(f"show {remote.locator('h1').inner_text()}?")
        lecture.reload()
    lecture.get_by_role("button", name="Yes, connect it").click()
    remote.get_by_role("button", name="Close").click()
    expect(lecture.get_by_role("dialog", name="Join the class")).to_have_count(0)
    remote.evaluate(BUZZES)
    return remote


def compared(lecture: Page) -> None:
    """The votes of an earlier class come from its CSV."""
    lecture.keyboard.press("j")
    with lecture.expect_file_chooser() as chooser:
        lecture.get_by_role("button", name="Votes of an earlier class").click()
    chooser.value.set_files(FilePayload(name="class.csv", mimeType="text/csv", buffer=TABLE.encode()))
    expect(lecture.get_by_text("Its votes on 1 question are outlined.")).to_be_visible()
    lecture.keyboard.press("j")


def briefed(server: Server, code: str, lecture: Page, phone: Page, remote: Page) -> None:
    """The remote control says what the class answers, and what the next press does."""
    body = remote.locator(".remote-body")
    expect(body).to_contain_text("0 of 1 have answered")
    for option in (0, 0, 1, 2, 2):
        token = call(server.url, f"/class/{code}/token", "POST").json["token"]
        call(server.url, f"/class/{code}/now", word=token)
        given = {"walk": "d31", "step": "d31-03", "option": option}
        assert call(server.url, f"/class/{code}/answer", "PUT", given, token).status == 204
    expect(body).to_contain_text("5 of 6 have answered")
    expect(body).to_contain_text("40 % are right: let them talk, then vote again.")
    expect(body.locator(".right-vote")).to_contain_text(ANSWERS[0])
    expect(body.locator(".right-vote b")).to_have_text("2")
    tap(phone, 0)
    remote.wait_for_function("globalThis.buzzes > 0")  # all have answered
    forward = remote.locator(".remote-deeds .filled")
    for words in PRESSES:
        expect(forward).to_have_text(words)
        offered = remote.locator(".remote-deeds .act:visible").all_inner_texts()
        assert CLOSES not in offered and ("Vote again" in offered) == (words == "Show the answer")
        if words == "Show the answer":
            status = lecture.locator(".votes [role=status]")
            expect(status).to_have_text(re.compile("^6 (of 6 )?have answered, outlined: earlier class$"))
            counted(lecture, "3 → 3", "1 → 1", "0 → 2")
        for width, height in ((844, 390), (390, 844)):
            remote.set_viewport_size({"width": width, "height": height})
            assert not remote.evaluate("document.documentElement.scrollWidth > innerWidth")
        forward.click()
    put("d31-04", lecture, phone)


def counted_down(server: Server, code: str, lecture: Page, phone: Page, remote: Page) -> None:
    """A countdown is visible to all, and closes the vote if that is asked for."""
    timers = [page.get_by_role("timer") for page in (lecture, phone, remote)]
    for timer in timers:
        expect(timer).to_have_count(0)  # hidden
    lecture.keyboard.press("d")
    for timer in timers:
        expect(timer).to_have_text(THIRTY)
    remote.get_by_role("button", name="15 s more").click()
    for timer in timers:
        expect(timer).to_have_text(FORTY_FIVE)
    close = lecture.get_by_role("button", name="Close at 0")
    close.click()
    expect(close).to_have_attribute("aria-pressed", "true")
    remote.get_by_role("button", name="Stay open at 0").click()
    expect(close).to_have_attribute("aria-pressed", "false")
    again = {"type": "put", "walk": "d31", "step": "d31-04", "vote": 2}
    for order in (again, {"type": "countdown", "seconds": 1, "closes": True}):
        assert call(server.url, f"/class/{code}/lead", "POST", order, lecture.evaluate(f"{LED}.room.key")).status == 204
    expect(phone.get_by_text("The vote is closed.")).to_be_visible()
    for timer in timers:
        expect(timer).to_have_count(0)


def aloud(lecture: Page, phone: Page) -> None:
    """A vote on what is said aloud leads back to the open step, which shows nothing by itself."""
    covered = lecture.evaluate("oscillations.shown.state.covered")
    lecture.keyboard.press("v")
    put("vote-1", lecture, phone)
    assert covered and lecture.evaluate("oscillations.shown.state.covered") == covered
    tap(phone, 1)
    expect(phone.get_by_text("You can change it until the vote is closed.")).to_be_visible()
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered")
    clicked(lecture)
    counted(lecture, "0", "1", "0", "0")
    expect(lecture.locator(FILLED)).to_have_text("Go on")
    clicked(lecture)
    put("d31-04", lecture, phone)


def pressed(lecture: Page, remote: Page) -> None:
    """The other buttons of the remote control."""
    lecture.keyboard.press("j")
    remote.get_by_role("button", name=CLOSES).click()
    expect(lecture.get_by_role("dialog", name="Join the class")).to_have_count(0)
    remote.get_by_role("button", name="Blank the screen").click()
    expect(lecture.locator(".blank")).to_have_count(1)
    remote.get_by_role("button", name="Show the screen").click()
    expect(lecture.locator(".blank")).to_have_count(0)
    remote.get_by_role("button", name="Contents").click()
    remote.get_by_role("button", name="Where energy goes back and forth").click()
    put("d31-11", lecture)
    expect(remote.locator(".class-remote > [role=status]")).to_contain_text("11 of 16")


def by_another_window(lecture: Page, phone: Page) -> None:
    """An answer that one window of the instructor shows is visible in the others; the class has the lecture's clock."""
    second = lecture.context.new_page()
    second.goto(lecture.url)
    second.wait_for_function(CONNECTED)
    second.keyboard.press("t")
    second.wait_for_function(f"{LED}?.votes.isUnopened")
    second.evaluate("oscillations.walks.walk.show(true)")
    lecture.wait_for_function("oscillations.walks.walk.lesson")
    second.close()
    for page in (lecture, phone):
        page.wait_for_function("oscillations.clock.playing")
    lecture.keyboard.press("Space")
    at = lecture.evaluate("oscillations.clock.t")
    phone.wait_for_function("t => !oscillations.clock.playing && Math.abs(oscillations.clock.t - t) < 1e-6", arg=at)
    assert phone.evaluate("oscillations.timing.bound") < 1000


def taken_over(lecture: Page, other: Page, *, is_taught: bool) -> None:
    """Another computer continues in the same state; this one keeps its picture."""
    lecture.evaluate("oscillations.clock.playing = false; oscillations.clock.seek(0)")
    address = ticket(lecture, "Another computer", "word")
    lecture.keyboard.press("j")
    expect(lecture.get_by_role("dialog")).to_have_count(0)
    lecture.wait_for_function(QUIET)
    shown = lecture.evaluate(SHOWN)
    other.goto(address)
    other.wait_for_function(f"{LED}?.news.number && {LED}.votes.tally?.now.answered === 1 && {CONNECTED}")
    expect(lecture.get_by_text("led by another computer").locator("visible=true")).to_have_count(1)
    expect(lecture.locator(".notice")).to_be_hidden()
    lecture.wait_for_function(QUIET)
    assert lecture.evaluate(SHOWN) == shown
    assert bool(other.evaluate("oscillations.walks.walk.lesson")) == is_taught
    for page in (lecture, other):
        question = page.locator(".card .asks, .asked-line, h1").filter(has_text="One swing takes")
        expect(question.first).to_contain_text("One swing takes 1.00 s.")  # its numbers differ between visitors
    assert not lecture.evaluate(LED)


def ended(lecture: Page, remote: Page) -> None:
    """The remote control asks on the first screen, too, before it ends a class."""
    dialog = lecture.get_by_role("dialog", name="End the class")
    for answer in ("Cancel", "End the class"):
        remote.get_by_role("button", name="End the class").click()
        expect(dialog).to_contain_text("This deletes 8 answers to 3 questions.")
        assert lecture.evaluate(f"{LED} && !{LED}.isOver")
        remote.get_by_role("button", name=answer).click()
        expect(dialog).to_have_count(0)


@pytest.mark.timeout(400)  # four windows on a busy machine
def test_a_remote_control_and_other_computers_lead(
    server: Server, browser: Browser, window: Open, failing: Open
) -> None:
    lecture, code = taught(window, "walk=d31&step=d31-03&projector", 1280, 720)
    remote, phone = let_in(lecture, failing), joined(window, code)
    put("d31-03", lecture, phone)
    compared(lecture)
    briefed(server, code, lecture, phone, remote)
    counted_down(server, code, lecture, phone, remote)
    aloud(lecture, phone)
    pressed(lecture, remote)
    by_another_window(lecture, phone)
    lecture.evaluate("oscillations.walks.walk.go(1)")
    put("d31-02", lecture, phone)
    phone.get_by_role("textbox", name="Your answer").fill("2")
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered")
    contexts = [calm_context(browser, {"width": 1280, "height": 720}, bypass_csp=True) for _ in range(2)]
    other, third = (context.new_page() for context in contexts)
    taken_over(lecture, other, is_taught=False)
    explained(other, phone)
    other.keyboard.press("p")
    taken_over(other, third, is_taught=True)
    clicked(third, "PageUp")
    expect(third.locator(FILLED)).to_have_text("Vote again")
    ended(third, remote)
    for page in (phone, remote):
        expect(page.get_by_role("heading", name="The class is over.")).to_be_visible()
    for context in contexts:
        context.close()


def test_who_looks_around_cannot_show_the_step_that_the_lecture_asks(window: Open) -> None:
    lecture, code = taught(window, "walk=d34&step=d34-12")
    own = joined(window, code)
    own.get_by_role("button", name="Only the drive's, in the end").click()
    explained(lecture, own)
    own.locator(".replied").get_by_text("Show such a case").click()  # on the student's own page
    own.wait_for_function(f"{CONNECTED} && oscillations.walks && oscillations.shown.state.parameters.c1 === 0.4")
    expect(own.locator(".class-bar")).to_contain_text("On your own")
    assert own.evaluate("!oscillations.shown.state.step && !oscillations.shown.state.covered.length")
    own.get_by_text("Back to the lecture").click()
    own.wait_for_function(f"{READY} && oscillations.asked?.card")
    own.get_by_text("Try it on your own").click()  # and the case is not searched again
    own.wait_for_function(f"{CONNECTED} && !globalThis.sessionStorage['class-sought']")
    expect(own.get_by_role("slider").first).to_be_visible()
    lecture.evaluate("oscillations.walks.walk.go(4)")
    own.goto(f"{own.url.partition('?')[0]}?walk=d34&step=d34-05")
    own.wait_for_function(f"{CONNECTED} && oscillations.classes.askedStep === 'd34/d34-05'")
    own.locator(".answers button").first.click()
    own.get_by_role("button", name="Show the answer").click()
    expect(own.get_by_role("alert").filter(has_text="The lecture is at this step now.")).to_be_visible()
    explained(lecture)
    own.wait_for_function("oscillations.classes.askedStep === ''")
    own.get_by_role("button", name="Show the answer").click()
    own.wait_for_function("Boolean(oscillations.walks.walk.lesson)")


ASKED = "globalThis.oscillations?.walks?.walk?.card && oscillations.walks.walk.numbers"
CLASS = f"{ASKED} === 0 && oscillations.shown.state.step === 'd31/d31-02'"


def turned(page: Page, then: str) -> None:
    """To the next step and back."""
    page.evaluate("oscillations.walks.walk.go(2)")
    page.wait_for_function("oscillations.shown.state.step === 'd31/d31-03'")
    page.evaluate("oscillations.walks.walk.go(1)")
    page.wait_for_function(then)


def test_a_visitor_has_numbers_that_stay_and_a_class_those_of_the_file(window: Open) -> None:
    page = window("walk=d31&step=d31-02", 1280, 720)
    page.wait_for_function(f"{ASKED} > 0")
    k = page.evaluate("oscillations.shown.settings.k.value")
    query = page.evaluate("location.search")
    assert query.startswith("?walk=d31&step=d31-02&seed=")
    expect(page.locator(".card .given").first).to_contain_text(f"{2 * math.pi / math.sqrt(k):.3g}"[:4])
    page.get_by_label("Your answer").fill(f"{4 * math.pi / math.sqrt(k):.2f}")
    page.get_by_role("button", name="Show the answer", exact=True).click()
    page.wait_for_function("oscillations.walks.walk.lesson?.right")
    page.reload()
    page.wait_for_function(f"{ASKED} > 0")
    assert page.evaluate("location.search") == query
    turned(page, f"{ASKED} > 0")
    assert page.evaluate("oscillations.shown.settings.k.value") == k, "the same visitor has the same numbers"
    page.evaluate("oscillations.classes.begin()")
    page.wait_for_function(f"{LED} && {CLASS}")
    expect(page.locator(".card .given").first).to_contain_text("1.00 s")
    phone = joined(window, page.evaluate(f"{LED}.room.code"))
    put("d31-02", page, phone)
    expect(phone.locator(".card .given")).to_contain_text("1.00 s")
    turned(page, CLASS)
    page.reload()
    page.wait_for_function(f"{LED} && {CLASS}")
