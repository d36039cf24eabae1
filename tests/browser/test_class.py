"""A class of two phones in lectures of a step of each kind, from files: a clicker leads, a remote control looks on."""

import re

import pytest
from playwright.sync_api import Page, Route, expect

from tests.browser.classroom import FILLED, LED, counted, draw, joined, onward, put, remote_of, sent, taught
from tests.browser.fixtures import CONNECTED, READY, Open
from tests.browser.looks import in_hall
from tests.browser.waiting import clicked, drop, tap
from tests.live_class.caller import WORDS

pytestmark = pytest.mark.browser

STEPS = {"pull": "d31-03", "mass": "d31-02", "place": "d31-12", "curve": "d34-14"}
POLL = """[[step]]
id = "speed"
poll = true
question = "How fast is this?"
options = [{ text = "Too fast" }, { text = "Right" }, { text = "Too slow" }]
"""
PULL, MASS, PLACE, CURVE = (f'[[step]]\nid = "{name}"\nfrom = "{step}"\n' for name, step in STEPS.items())
BOLD = "<b>Energy</b> 🙂"
STATUS = ".card-body > .hint[role=status]"
SENT = "oscillations.asked.card.question.pad.sent"
TAKEN = "oscillations.asked?.card && oscillations.asked.delivery.isTaken(oscillations.asked.name)"
ABOVE = """() => document.querySelector(".drawing").getBoundingClientRect().bottom
  <= document.querySelector(".class-bar").getBoundingClientRect().top"""
INKED = """() => {
  const {plot: {frame, unit}, canvas} = oscillations.classes.led.votes.layer
  const ink = canvas.getContext("2d"), scale = devicePixelRatio * unit
  const hasInk = (x, y) => ink.getImageData(scale * x - 5, scale * y - 5, 11, 11).data.some(Boolean)
  return [0.2, 0.4, 0.6, 0.8].every(share =>
    hasInk(frame.left + share * frame.width, frame.top + (0.1 + 0.88 * share) * frame.height))
}"""
"""True if the line that both phones have drawn is at its place."""
KEPT = "Object.keys(localStorage).filter(key => key.startsWith('class-')).length"


def fits(lecture: Page) -> None:
    """The hall is readable with the votes of the class."""
    assert list(in_hall(lecture, lecture.evaluate("innerHeight"), "")) == []


def back_again(lecture: Page, phone: Page) -> None:
    """The answer is taken back for all, also after a reload, and shown again without a new vote."""
    clicked(lecture, "PageUp")
    for _ in range(2):
        expect(lecture.locator(FILLED)).to_have_text("Vote again")
        expect(lecture.locator(".votes")).to_contain_text("have answered. The answer has been shown.")
        expect(phone.get_by_text("This question has been answered. It takes no more answers.")).to_be_visible()
        lecture.reload()
        lecture.wait_for_function(f"{CONNECTED} && {LED}")
    assert phone.evaluate("oscillations.asked.card.question.element.inert && Boolean(oscillations.asked.given)")
    lecture.get_by_role("button", name="Show the answer").click()
    expect(phone.locator(".card .after > *").first).to_be_attached()


def choice(lecture: Page, phone: Page, other: Page, _: Page) -> None:
    """Two votes with a discussion between them; nobody sees the first while the second is open."""
    put("pull", lecture, phone, other)
    for i, one in enumerate((other, phone)):
        tap(one, i)
        sent(one)
    expect(phone.locator(STATUS)).to_contain_text("Sent: Longer: the distance is longer. You can change it until")
    expect(phone.locator(STATUS)).to_contain_text("2 of 2 have answered.")
    expect(lecture.locator(".votes")).to_contain_text("2 of 2 have answered")
    assert lecture.locator(".vote-bar").count() == 0  # first the number of answers is visible, then the answers
    clicked(lecture)
    counted(lecture, "1", "1", "0")
    lecture.get_by_role("button", name="Vote again").click()
    expect(lecture.locator(".votes")).to_contain_text("Vote 2: 0 of 2 have answered")
    assert lecture.locator(".vote-bar").count() == 0
    for one in (phone, other):
        expect(one.get_by_text("A new vote, number 2: answer once more.")).to_be_visible()
        tap(one, 0)
    expect(lecture.locator(".votes")).to_contain_text("2 of 2 have answered")
    lecture.get_by_role("button", name="Close the vote").click()
    expect(phone.get_by_text("The vote is closed.")).to_be_visible()
    assert phone.evaluate("oscillations.asked.card.question.element.inert")
    clicked(lecture)
    counted(lecture, "1 → 2", "1 → 0", "0 → 0")
    expect(lecture.locator(".vote-bar .before")).to_have_count(2)  # the first vote stays outlined
    fits(lecture)
    assert len({tuple(page.locator(".answers .name").all_inner_texts()) for page in (lecture, phone)}) == 1, "one order"
    clicked(lecture)
    judged(lecture, phone, other)


def judged(lecture: Page, phone: Page, other: Page) -> None:
    """The answer on all pages, with the counts of the class; then the explanation in the hall."""
    for page in (lecture, phone, other):
        expect(page.locator("h1")).to_have_text("Twice as far takes just as long")
    expect(phone.locator(".answers [data-option='0']").get_by_role("img", name="right")).to_be_visible()
    expect(phone.locator(".answers [data-option='0']")).to_contain_text("your answer")
    expect(phone.locator(STATUS)).to_have_text("2 of 2 are right.")
    assert phone.locator(".answers .vote-count").all_inner_texts().count("2") == 1
    expect(phone.locator(".card .try")).to_have_count(0)  # there is no slider
    lecture.reload()
    lecture.wait_for_function("oscillations.walks.walk?.lesson")  # a question whose answer was shown is not asked again
    counted(lecture, "1 → 2", "1 → 0", "0 → 0")
    fits(lecture)
    clicked(lecture)
    expect(lecture.locator(".card .why")).to_be_visible()
    fits(lecture)
    clicked(lecture)


def number(lecture: Page, phone: Page, other: Page, remote: Page) -> None:
    """With the question of how sure the class is; led by the remote control."""
    put("mass", lecture, phone, other)
    expect(phone.get_by_role("group", name="How sure are you?")).to_be_hidden()
    lecture.keyboard.press("s")
    phone.get_by_role("button", name="Fairly sure").click()
    for one, text in ((phone, "2"), (other, "1")):
        one.get_by_role("textbox", name="Your answer").fill(text)
        sent(one)
    expect(remote.get_by_text("How sure: 0 guessed, 1 fairly sure (1 right), 0 certain")).to_be_visible()
    expect(remote.get_by_role("button", name="How sure?")).to_have_count(0)  # it is asked
    clicked(lecture)
    expect(lecture.locator(".vote-line circle")).to_have_count(2)
    expect(lecture.locator(".votes .sure")).to_have_text("How sure: 0 guessed, 1 fairly sure, 0 certain")
    asked = list[Route]()
    other.route("**/answer", lambda route: asked.append(route))
    with other.expect_request("**/answer"):  # for the reply to the answer that counts
        onward(remote, "Show the answer")
    typed = other.locator(".question input")
    typed.evaluate("field => { field.value = '2' }")  # even if the reply takes too long, so that the field is closed
    asked[0].continue_()
    other.unroute("**/answer")
    expect(other.locator(".yours")).to_have_text("your answer")
    expect(typed).to_have_value("1")
    expect(lecture.locator(".votes .all")).to_have_text("1 of 2 is right")
    expect(lecture.locator(".votes .sure")).to_contain_text("1 fairly sure (1 right)")
    expect(lecture.locator(".vote-line .truth")).to_have_text("2 s")
    fits(lecture)
    back_again(lecture, phone)
    remote.get_by_role("button", name="How it follows").click()
    expect(lecture.locator(".card .follows .lines")).to_be_visible()


def point(lecture: Page, phone: Page, other: Page, remote: Page) -> None:
    put("place", lecture, phone, other)
    for one in (phone, other):
        one.locator(".pill-mark").press("ArrowRight")
        sent(one)
    clicked(lecture)
    lecture.wait_for_function("""() => {
      const parts = [".vote-dots circle", ".pill-mark"].map(part => document.querySelector(part))
      const [dot, mark] = parts.map(part => part?.getBoundingClientRect()).map(box => box && box.x + box.width / 2)
      return Math.abs(dot - mark) < 20
    }""")  # the answers are on the axis itself, next to where the mark begins
    clicked(lecture)
    expect(lecture.locator(".votes .all")).to_have_text("0 of 2 are right")
    fits(lecture)
    clicked(lecture)
    expect(lecture.locator(".card .why")).to_be_visible()
    clicked(lecture)
    expect(remote.locator(".class-remote > [role=status]")).to_contain_text("3 of 4")


def words(lecture: Page, phone: Page, other: Page, remote: Page) -> None:
    """The hall sees what the remote control shows, as text, and nothing else."""
    put("why", lecture, phone, other)
    for one, text in ((phone, BOLD), (other, "Rubbish")):
        one.get_by_label("Your answer in a few words").fill(text)
        expect(one.get_by_text(f"Sent: {text}.")).to_be_visible()
    clicked(lecture)
    expect(lecture.get_by_text("2 answers wait for “Show” on the remote control")).to_be_visible()
    assert "Rubbish" not in lecture.locator("body").inner_text() and BOLD not in lecture.locator("body").inner_text()
    remote.get_by_role("listitem").filter(has_text="Rubbish").get_by_role("button", name="Remove").click()
    remote.get_by_role("listitem").filter(has_text=BOLD).get_by_role("button", name="Show").click()
    expect(lecture.locator(".words-shown li")).to_have_text([BOLD])
    expect(lecture.locator(".words-shown b")).to_have_count(0)
    fits(lecture)
    expect(remote.get_by_role("button", name="Remove")).to_have_count(1)
    remote.get_by_role("button", name="Remove").click()
    expect(lecture.locator(".words-shown li")).to_have_count(0)
    onward(remote, "Show the answer")
    expect(phone.get_by_text("Energy goes to and fro.")).to_be_visible()
    for _ in range(2):
        clicked(lecture)


def sketch(lecture: Page, phone: Page, other: Page, _: Page) -> None:
    """The sketches take the whole screen. On a phone held sideways the pad is above the bar of the class."""
    put("curve", lecture, phone, other)
    other.wait_for_function(ABOVE)
    for one in (phone, other):
        draw(one, lambda x: 0.9 - 0.88 * x)
        sent(one)
    drawn = phone.evaluate(SENT)
    phone.reload()  # the server has the answer that the phone has kept
    phone.wait_for_function(f"{READY} && {TAKEN}")
    assert drawn["Xp1"] and phone.evaluate(SENT) == drawn
    sent(phone)
    clicked(lecture)
    ink = lecture.get_by_role("img", name="2 sketches of the class")
    expect(ink).to_be_visible()
    clicked(lecture)
    expect(lecture.locator("h1")).to_have_text(re.compile("^“.*” is right in 2 of 2 sketches, “.*” in 0$"))
    box = ink.bounding_box()
    assert box and box["width"] > 1700 and box["height"] > 500
    lecture.wait_for_function(INKED)
    fits(lecture)
    for one in (phone, other):
        expect(one.locator(".findings li")).to_have_count(5)
    clicked(lecture)
    expect(lecture.locator("h1")).to_have_text("Two poles, and a zero between them")
    expect(ink).to_have_count(0)
    clicked(lecture)
    expect(lecture.locator(".card .follows .lines")).to_be_visible()
    clicked(lecture)


def poll(lecture: Page, phone: Page, other: Page, _: Page) -> None:
    """A poll has no answer. Then back to the step before, whose answer stays."""
    put("speed", lecture, phone, other)
    expect(lecture.locator(FILLED)).to_have_text("Show the votes")
    phone.get_by_role("button", name="Right").click()
    expect(phone.get_by_text("Sent: Right. You can change it until the vote is closed.")).to_be_visible()
    clicked(lecture)
    counted(lecture, "0", "1", "0")
    clicked(lecture, "PageUp")
    put("curve", lecture, phone, other)
    lecture.wait_for_function("oscillations.walks.walk.lesson")
    for one in (phone, other):
        expect(one.locator(".findings li")).to_have_count(5)
        assert len(one.evaluate(SENT)["Xp1"]) == 101, "it is still theirs"


def ended(lecture: Page, phone: Page, deletes: str) -> None:
    """The page says what the end of a class deletes, and offers the CSV; a clicker does not end a class."""
    dialog = lecture.get_by_role("dialog", name="End the class")
    lecture.keyboard.press("j")
    for cancels in (True, False):
        lecture.get_by_role("button", name="End the class").press("Enter")
        expect(dialog).to_contain_text(f"This deletes {deletes}. The code stops working, and phones")
        for key in ("PageDown", "PageUp"):
            lecture.keyboard.press(key)
        assert lecture.evaluate(f"{LED} && !{LED}.isOver")
        if cancels:
            dialog.get_by_role("button", name="Cancel").click()
            expect(dialog).to_have_count(0)
    with lecture.expect_download() as download:
        lecture.keyboard.press("Enter")  # the filled button saves
    assert re.fullmatch(r"class-\w{4}\.csv", download.value.suggested_filename)
    expect(lecture.get_by_text("Saved as class-")).to_be_visible()
    assert phone.evaluate(KEPT) == 1
    lecture.keyboard.press("Enter")  # the next press ends the class
    expect(lecture.get_by_text("The class is over.")).to_be_visible()
    expect(dialog).to_have_count(0)
    assert download.value.path().read_text("utf-8").startswith("phone,time,here,walk,step,vote,question,answer")


LECTURES = {
    "choices": (PULL + MASS, (choice, number), "6 answers to 2 questions"),
    "places": (WORDS + PLACE + CURVE + POLL, (words, point, sketch, poll), "7 answers to 4 questions"),
}


@pytest.mark.timeout(600)  # four windows on a busy machine
@pytest.mark.parametrize("name", ["choices", pytest.param("places", marks=pytest.mark.slow)])
def test_a_lecture(window: Open, name: str) -> None:
    file, acts, deletes = LECTURES[name]
    lecture, code = taught(window, "scene=oscillator&projector")
    remote = remote_of(lecture, window)
    phone, other = joined(window, code), joined(window, code, 844, 390)
    expect(lecture.locator(".class-corner")).to_contain_text(f"{code}2 here")
    drop(lecture, "own.toml", f'title = "Own"\n{file}')
    lecture.wait_for_function("oscillations.walks.walk", timeout=90_000)  # the process that reads walks may be starting
    for act in acts:
        act(lecture, phone, other, remote)
    remote.close()  # it would continue to poll, and get the answer that there is no such class
    ended(lecture, phone, deletes)
    for one in (phone, other):
        expect(one.get_by_role("heading", name="The class is over.")).to_be_visible()
        assert one.evaluate(KEPT) == 0
