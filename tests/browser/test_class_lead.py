"""A class: remote control, countdown, votes aloud, another computer; a killed server, lost requests, a passphrase."""

import json
import re
from pathlib import Path

import pytest
from playwright.sync_api import FilePayload, Page, Request, Route, expect

from tests.browser.classroom import FILLED, LED, counted, joined, onward, opening, put, remote_of, sent, taught, ticket
from tests.browser.fixtures import CONNECTED, READY, Open, another_version
from tests.browser.waiting import MINE, QUIET, clicked, drop, passed, tap
from tests.live_class.caller import call
from tests.serving.server import Server, serving
from tools.reconnect.site import GatedSite

pytestmark = pytest.mark.browser
BUZZES = """() => { globalThis.buzzes = 0
  Object.defineProperty(navigator, "vibrate", {value: () => { globalThis.buzzes += 1; return true }}) }"""
CLOSES = "Close the QR code"
ANSWERS = ["Just as long as it did before"] * 3 + ["Longer: the distance is longer"]
TABLE = "phone,time,here,walk,step,vote,question,answer,unit,right,sure\r\n" + "".join(
    f"{i},,9,d31,d31-03,1,How long?,{answer},,no,\r\n" for i, answer in enumerate(ANSWERS)
)
SHOWN = """JSON.stringify([oscillations.shown.state, oscillations.walks.walk.numbers,
  document.querySelector("h1").innerHTML])"""
BACK = 30_000
"""Milliseconds in which pages must reconnect."""
READING = 3 * BACK
"""The same for a new process of the server that reads walks."""
LOADS = "sessionStorage.getItem('loads')"
HEARD = "globalThis.oscillations?.news?.number"


def briefed(server: Server, code: str, lecture: Page, phone: Page, remote: Page) -> None:
    """The remote control says what the class answers, and what the next press does. An earlier class is compared."""
    lecture.keyboard.press("j")
    with lecture.expect_file_chooser() as chooser:
        lecture.get_by_role("button", name="Votes of an earlier class").click()
    chooser.value.set_files(FilePayload(name="class.csv", mimeType="text/csv", buffer=TABLE.encode()))
    expect(lecture.get_by_text("Its votes on 1 question are outlined.")).to_be_visible()
    lecture.keyboard.press("j")
    body = remote.locator(".remote-body")
    expect(body).to_contain_text("0 of 1 have answered")
    for option in (0, 0, 1, 2, 2):
        token = call(server.url, f"/class/{code}/token", "POST").json["token"]
        call(server.url, f"/class/{code}/now", word=token)
        given = {"walk": "d31", "step": "d31-03", "option": option}
        assert call(server.url, f"/class/{code}/answer", "PUT", given, token).status == 204
    expect(body).to_contain_text("5 of 6 have answered")
    expect(body).to_contain_text("40 % are right: let them talk, then vote again.")
    tap(phone, 0)
    remote.wait_for_function("globalThis.buzzes > 0")  # all have answered
    forward = remote.locator(".remote-deeds .filled")
    for words in ("Show the votes", "Show the answer", "Show the explanation", "Next"):
        expect(forward).to_have_text(words)
        offered = remote.locator(".remote-deeds .act:visible").all_inner_texts()
        assert CLOSES not in offered and ("Vote again" in offered) == (words == "Show the answer")
        if words == "Show the answer":
            status = lecture.locator(".votes [role=status]")
            expect(status).to_have_text(re.compile("^6 (of 6 )?have answered, outlined: earlier class$"))
            counted(lecture, "3 → 3", "1 → 1", "0 → 2")
        forward.click()
    put("d31-04", lecture, phone)


def counted_down(server: Server, code: str, lecture: Page, phone: Page, remote: Page) -> None:
    """A countdown is visible to all, and closes the vote if that is asked for."""
    timers = [page.get_by_role("timer") for page in (lecture, phone, remote)]
    for timer in timers:
        expect(timer).to_have_count(0)  # hidden
    lecture.keyboard.press("d")
    for timer in timers:
        expect(timer).to_have_text(re.compile("0:(30|2[0-9])"))
    remote.get_by_role("button", name="15 s more").click()
    for timer in timers:
        expect(timer).to_have_text(re.compile("0:(4[0-5]|3[1-9])"))
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


def aloud(lecture: Page, phone: Page, remote: Page) -> None:
    """A vote on what is said aloud leads back to the open step and shows nothing by itself. Then the other buttons."""
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


def explained(lecture: Page, *phones: Page) -> None:
    """A clicker shows the votes, then the answer, to hall and phones."""
    clicked(lecture)
    expect(lecture.locator(FILLED)).to_have_text("Show the answer")
    assert not lecture.evaluate("oscillations.walks.walk.lesson")
    clicked(lecture)
    lecture.wait_for_function("oscillations.walks.walk.lesson")
    for phone in phones:
        expect(phone.locator(".card .after > *").first).to_be_attached()  # with the reply to the phone's own answer


def taken_over(lecture: Page, other: Page) -> None:
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
    for page in (lecture, other):
        question = page.locator(".card .asks, .asked-line, h1").filter(has_text="One swing takes")
        expect(question.first).to_contain_text("One swing takes 1.00 s.")  # its numbers differ between visitors
    assert not lecture.evaluate(LED)


@pytest.mark.timeout(400)  # four windows on a busy machine
@pytest.mark.slow  # five pages, one of them a remote control
def test_a_remote_control_and_another_computer_lead(server: Server, window: Open, failing: Open) -> None:
    lecture, code = taught(window, "walk=d31&step=d31-03&projector", 1280, 720)
    remote, phone = remote_of(lecture, failing), joined(window, code)
    remote.evaluate(BUZZES)
    put("d31-03", lecture, phone)
    briefed(server, code, lecture, phone, remote)
    counted_down(server, code, lecture, phone, remote)
    aloud(lecture, phone, remote)
    lecture.evaluate("oscillations.walks.walk.show(true)")
    for page in (lecture, phone):
        page.wait_for_function("oscillations.clock.playing")
    lecture.keyboard.press("Space")
    at = lecture.evaluate("oscillations.clock.t")
    phone.wait_for_function("t => !oscillations.clock.playing && Math.abs(oscillations.clock.t - t) < 1e-6", arg=at)
    lecture.evaluate("oscillations.walks.walk.go(1)")
    put("d31-02", lecture, phone)
    phone.get_by_role("textbox", name="Your answer").fill("2")
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered")
    other = failing("", 1280, 720)
    taken_over(lecture, other)
    explained(other, phone)
    dialog = other.get_by_role("dialog", name="End the class")
    for answer in ("Cancel", "End the class"):  # the remote control asks on the first screen, too
        remote.get_by_role("button", name="End the class").click()
        expect(dialog).to_contain_text("This deletes 8 answers to 3 questions.")
        assert other.evaluate(f"{LED} && !{LED}.isOver")
        remote.get_by_role("button", name=answer).click()
        expect(dialog).to_have_count(0)
    for page in (phone, remote):
        expect(page.get_by_role("heading", name="The class is over.")).to_be_visible()


@pytest.mark.slow  # two windows of a class
def test_who_looks_around_cannot_show_the_step_that_the_lecture_asks(window: Open) -> None:
    lecture, code = taught(window, "walk=d34&step=d34-12")
    own = joined(window, code)
    own.get_by_role("button", name="Only the drive's, in the end").click()
    explained(lecture, own)
    own.locator(".replied").get_by_text("Show such a case").click()  # on the student's own page
    own.wait_for_function(f"{CONNECTED} && oscillations.walks && oscillations.shown.state.parameters.c1 === 0.4")
    expect(own.locator(".class-bar")).to_contain_text("On your own")
    assert own.evaluate("!oscillations.shown.state.step && !oscillations.shown.state.covered.length")
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


@pytest.mark.slow
@pytest.mark.timeout(400)  # five windows
def test_no_answer_is_lost_when_the_server_is_killed(quiet: Open, tmp_path: Path) -> None:
    with GatedSite(tmp_path) as site:
        window = opening(quiet, site.url)
        lecture, code = taught(window, "scene=oscillator", 1280, 844)
        drop(lecture, "mine.toml", MINE)
        lecture.wait_for_function(f"{LED}?.news.question?.step === 'pull'", timeout=READING)
        remote, phones = remote_of(lecture, window), [joined(window, code) for _ in range(3)]
        put("pull", lecture, *phones, timeout=BACK)
        for phone in phones[:2]:
            tap(phone, 0)
            sent(phone)
        site.kill()  # the third phone answers while there is no server, and all notice that
        tap(phones[2], 1)
        expect(phones[2].get_by_text("Not sent yet; trying again.")).to_be_visible()
        expect(phones[0].locator(".class-bar")).to_contain_text("Not connected")
        expect(remote.locator(".class-remote > [role=status]")).to_contain_text("The server does not answer")
        site.start()
        sent(phones[2], READING)
        expect(phones[0].locator(".class-bar")).to_contain_text("Following", timeout=BACK)
        expect(remote.locator(".class-remote > [role=status]")).to_contain_text("1 of 1", timeout=BACK)
        expect(lecture.locator(".votes")).to_contain_text("3 of 3 have answered", timeout=BACK)
        lecture.wait_for_function(CONNECTED, timeout=BACK)
        onward(remote, "Show the votes")  # it is still accepted
        counted(lecture, "2", "1", "0")
        onward(remote, "Show the answer")
        lecture.wait_for_function("oscillations.walks.walk.lesson")
        expect(phones[2].get_by_text("Twice the pull is twice the force")).to_be_visible()
        copies = f"{LED}.copies.answers.get('mine/pull/1') ?? {{}}"  # of three answers
        lecture.wait_for_function(f"Object.keys({copies}).length === 3 && !{LED}.copies.stale.size")
        site.kill()  # the instructor's page is loaded again, too, after the answer was shown
        site.start()
        lecture.reload()
        lecture.wait_for_function(f"{LED}?.news.question?.lesson", timeout=READING)
        lecture.wait_for_function(f"{LED}.votes.tally?.now.answered === 3", timeout=BACK)
        lecture.wait_for_function("oscillations.walks.walk?.lesson")
        lecture.evaluate(f"{LED}.end()")
        for page in (*phones, remote):  # one that misses the last news doubts for half a minute that the class is over
            expect(page.locator("h1")).to_contain_text("The class is over.", timeout=2 * BACK)


def test_a_phone_of_another_version_reloads_the_page_but_not_twice_at_once(server: Server, failing: Open) -> None:
    page = failing(f"class={call(server.url, '/class', 'POST').json['code']}", 390, 844)
    page.wait_for_function(HEARD)
    page.add_init_script(f"sessionStorage.setItem('loads', 1 + Number({LOADS}))")
    page.route(f"{server.url}?*", another_version)
    page.reload(wait_until="commit")  # the page reloads, perhaps before all of this one is loaded
    page.wait_for_function(f"{LOADS} === '2' && {HEARD}")
    passed(page)  # it would have happened by now
    assert page.evaluate(f"[{LOADS}, document.documentElement.dataset.version[0]]") == ["2", "x"]


def test_a_class_is_opened_once_has_the_files_numbers_and_repeats_a_lost_order(failing: Open) -> None:
    lecture = failing("walk=d31&step=d31-02", 1920, 1080)
    lecture.wait_for_function(f"{CONNECTED} && oscillations.walks?.walk?.card && oscillations.walks.walk.numbers")
    made: list[Request] = []
    lecture.on("request", lambda request: made.append(request) if request.url.endswith("/class") else None)
    lecture.evaluate("oscillations.classes.begin(); oscillations.classes.begin()")
    lecture.wait_for_function(f"{LED} && !oscillations.walks.walk.numbers")
    phone = joined(failing, lecture.evaluate(f"{LED}.room.code"))
    put("d31-02", lecture, phone)
    for page in (lecture, phone):
        expect(page.locator(".card .given").first).to_contain_text("1.00 s")
    steps: list[str] = []

    def first_lost(route: Route) -> None:
        told = json.loads(route.request.post_data or "{}")
        if told["type"] == "put":
            steps.append(told["step"])
        (route.abort if steps == ["d31-03"] else route.continue_)()

    lecture.route(re.compile("/lead$"), first_lost)
    for place in (2, 3):
        lecture.evaluate("place => oscillations.walks.walk.go(place)", place)
    put("d31-04", lecture, phone)
    assert steps == ["d31-03", "d31-03", "d31-04"]
    assert len(made) == lecture.locator(".class-code").count() == 1


@pytest.mark.slow  # it starts a server
def test_a_passphrase_is_asked_for_and_the_qr_code_lets_phones_in(tmp_path: Path, quiet: Open) -> None:
    phrase = "swinging über springs"
    with serving(tmp_path / "log", environment={"CLASS_PASSPHRASE": phrase}) as server:
        window = opening(quiet, server.url)
        page = window("scene=coupled", 1280, 800)
        page.wait_for_function(CONNECTED)
        page.keyboard.press("t")
        dialog = page.get_by_role("dialog", name="Passphrase")
        expect(dialog.get_by_role("heading")).to_have_text("Opening a class here needs the instructors' passphrase.")
        dialog.get_by_label("Passphrase").fill("another one")
        page.keyboard.press("Enter")
        expect(dialog.get_by_role("heading")).to_have_text(re.compile("^This is not the instructors' passphrase"))
        dialog.get_by_label("Passphrase").fill(phrase)
        dialog.get_by_role("button", name="Open the class").click()
        page.wait_for_function(LED)
        code, address = page.evaluate(f"[{LED}.room.code, {LED}.room.address]")
        phone, word = window("", 390, 844), address.partition("join=")[2]
        with phone.expect_request(lambda request: request.headers.get("authorization") == f"Bearer {word}"):
            phone.goto(f"{server.url}?class={code}&join={word}")
        phone.wait_for_function(f"{READY} && Boolean(oscillations.clock.lead)")
        assert not server.complaints()
