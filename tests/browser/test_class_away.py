"""A class of three phones whose server is killed twice while they answer, and whose lead moves to another computer."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect

from tests.browser.classroom import CONNECTED, LED, counted, draw
from tests.browser.dropping import drop
from tests.browser.tabs import calm_context
from tests.browser.waiting import clicked
from tests.live_class.caller import call
from tools.reconnect.site import GatedSite

pytestmark = pytest.mark.browser

MINE = """title = "Mine"
[[step]]
id = "pull"
from = "d31-03"

[[step]]
id = "curve"
from = "d31-04"
"""
BACK = 30_000
"""Milliseconds in which pages must reconnect."""
READING = 3 * BACK
"""The same for a new process of the server that reads walks."""
SENT = "You can change it"


def copied(question: str, answers: int) -> str:
    """True if the instructor's page has copies of so many answers to a question."""
    of = f"{LED}.copies.answers.get('{question}/1')"
    return f"Object.keys({of} ?? {{}}).length === {answers} && !{LED}.copies.stale.size"


@pytest.fixture
def contexts(browser: Browser) -> Iterator[list[BrowserContext]]:
    """The browsers of the instructor, of three phones, of the remote control, and of a second computer. They log errors
    while the server is away."""
    sizes = ((1280, 844), *[(390, 844)] * 4, (1280, 844))
    made = [calm_context(browser, {"width": w, "height": h}, bypass_csp=True) for w, h in sizes]
    yield made
    for context in made:
        context.close()


def put(pages: list[Page], step: str) -> None:
    for page in pages:
        page.wait_for_function(
            "step => oscillations.asked.question?.step === step && oscillations.asked.card", arg=step, timeout=BACK
        )


def tap(phone: Page, option: int) -> None:
    phone.locator(f".answers [data-option='{option}']").click()


def begun(context: BrowserContext, site: GatedSite) -> tuple[Page, str]:
    """The instructor's page with a class that asks the first question of a walk from a file, and the class's code."""
    lecture = context.new_page()
    lecture.goto(f"{site.url}?scene=oscillator")
    lecture.wait_for_function(CONNECTED)
    lecture.keyboard.press("t")
    lecture.wait_for_function(LED)
    drop(lecture, "mine.toml", MINE)
    lecture.wait_for_function(f"{LED}?.news.question?.step === 'pull'", timeout=READING)
    return lecture, lecture.evaluate(f"{LED}.room.code")


def paired(lecture: Page, remote: Page) -> None:
    """A phone is accepted as the remote control."""
    remote.goto(address_of(lecture, "Remote control", "tickets"))
    lecture.get_by_role("button", name="Yes, connect it").click()
    remote.get_by_role("button", name="Close").click()
    expect(lecture.get_by_role("dialog")).to_have_count(0)


def address_of(lecture: Page, button: str, answer: str) -> str:
    """The address on a QR code that the instructor's dialog shows."""
    lecture.keyboard.press("j")
    with lecture.expect_response(re.compile(f"/{answer}$")) as response:
        lecture.get_by_role("button", name=button).click()
    address: str = response.value.json()["address"]
    return address


def answered_without_a_server(site: GatedSite, phones: list[Page], remote: Page) -> None:
    """The third phone answers while there is no server, and all notice that."""
    site.kill()
    tap(phones[2], 1)
    expect(phones[2].get_by_text("Not sent yet; trying again.")).to_be_visible()
    expect(phones[0].locator(".class-bar")).to_contain_text("Not connected")
    expect(remote.locator(".class-remote > [role=status]")).to_contain_text("The server does not answer")
    site.start()
    expect(phones[2].get_by_text(SENT)).to_be_visible(timeout=READING)
    expect(phones[0].locator(".class-bar")).to_contain_text("Following", timeout=BACK)
    expect(remote.locator(".class-remote > [role=status]")).to_contain_text("1 of 2", timeout=BACK)


def loaded_again(site: GatedSite, lecture: Page) -> None:
    """The server is killed again, and the instructor's page is loaded again, after the answer was shown."""
    code = lecture.evaluate(f"{LED}.room.code")
    lecture.wait_for_function(copied("mine/pull", 3))
    site.kill()
    site.start()
    lecture.reload()
    lecture.wait_for_function(f"{LED}?.news.number && {LED}.room.code === '{code}'", timeout=READING)
    lecture.wait_for_function(f"{LED}.news.question?.lesson && {LED}.votes.tally?.now.answered === 3", timeout=BACK)
    lecture.wait_for_function("oscillations.walks.walk?.lesson")


def taken_over(lecture: Page, context: BrowserContext) -> Page:
    """The page of another computer, which takes the lead and has never opened the file of the walk."""
    lecture.wait_for_function(copied("mine/curve", 3))
    address = address_of(lecture, "Another computer", "word")
    other = context.new_page()
    other.goto(address)
    other.wait_for_function(f"{LED}?.news.number && oscillations.walks.walk?.card", timeout=BACK)
    other.wait_for_function(copied("mine/pull", 3))  # which the first computer had copied
    assert other.evaluate("oscillations.walks.walk.sheet.name") == "mine"
    expect(lecture.get_by_text("led by another computer").first).to_be_visible()
    expect(other.locator(".notice")).to_be_hidden()
    return other


@pytest.mark.slow
@pytest.mark.timeout(400)  # six windows
def test_no_answer_is_lost_when_the_server_is_killed(contexts: list[BrowserContext], tmp_path: Path) -> None:
    with GatedSite(tmp_path) as site:
        lecture, code = begun(contexts[0], site)
        remote, *phones = (contexts[i].new_page() for i in (4, 1, 2, 3))
        paired(lecture, remote)
        for phone in phones:
            phone.goto(f"{site.url}{code}")
        put(phones, "pull")
        for phone in phones[:2]:
            tap(phone, 0)
            expect(phone.get_by_text(SENT)).to_be_visible()
        answered_without_a_server(site, phones, remote)
        expect(lecture.locator(".votes")).to_contain_text("3 of 3 have answered", timeout=BACK)
        lecture.wait_for_function(CONNECTED, timeout=BACK)
        remote.get_by_role("button", name="Show the votes").click()  # it is still accepted
        counted(lecture, "2", "1", "0")
        remote.get_by_role("button", name="Show the answer").click()
        lecture.wait_for_function("oscillations.walks.walk.lesson")
        expect(phones[2].get_by_text("Twice the pull is twice the force")).to_be_visible()
        loaded_again(site, lecture)
        led_by_another_computer(site, lecture, phones, contexts[5])
        for page in (*phones, remote):  # one that misses the last news doubts for half a minute that the class is over
            expect(page.locator("h1")).to_contain_text("The class is over.", timeout=2 * BACK)


def led_by_another_computer(site: GatedSite, lecture: Page, phones: list[Page], context: BrowserContext) -> None:
    """It takes over at the second question, goes back to the first, which it has never shown, and ends the class."""
    lecture.wait_for_function(CONNECTED, timeout=BACK)
    for _ in range(2):
        clicked(lecture)
    put(phones, "curve")
    for phone in phones:
        draw(phone, lambda x: 0.2 + 0.6 * x)
        expect(phone.get_by_text(SENT)).to_be_visible()
    other = taken_over(lecture, context)
    code, key = other.evaluate(f"[{LED}.room.code, {LED}.room.key]")
    assert call(site.url, f"/class/{code}/stored", word=key).json == {"answers": 6, "questions": 2}
    clicked(other, "PageUp")
    put(phones, "pull")
    other.wait_for_function("oscillations.walks.walk.lesson", timeout=BACK)
    counted(other, "2", "1", "0")
    other.evaluate(f"{LED}.end()")
