"""A class whose server is killed, whose phones are behind proxies or of another version, or that needs a passphrase."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, Request, Route, expect

from tests.browser.classroom import (
    CONNECTED,
    LED,
    Open,
    counted,
    draw,
    explained,
    joined,
    opening,
    put,
    remote_of,
    sent,
    tap,
    taught,
    ticket,
)  # fmt: skip
from tests.browser.dropping import drop
from tests.browser.fixtures import READY, another_version
from tests.browser.waiting import clicked, passed
from tests.live_class.caller import call
from tests.serving.server import Server, serving
from tools.bench.between import between
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
HIDDEN = """hidden => {
  Object.defineProperty(document, "hidden", {value: hidden, configurable: true})
  document.dispatchEvent(new Event("visibilitychange"))
}"""
"""A headless browser's page is always visible."""


def copied(question: str, answers: int) -> str:
    """True if the instructor's page has copies of so many answers to a question."""
    of = f"{LED}.copies.answers.get('{question}/1')"
    return f"Object.keys({of} ?? {{}}).length === {answers} && !{LED}.copies.stale.size"


def answered_without_a_server(site: GatedSite, phones: list[Page], remote: Page) -> None:
    """The third phone answers while there is no server, and all notice that."""
    site.kill()
    tap(phones[2], 1)
    expect(phones[2].get_by_text("Not sent yet; trying again.")).to_be_visible()
    expect(phones[0].locator(".class-bar")).to_contain_text("Not connected")
    expect(remote.locator(".class-remote > [role=status]")).to_contain_text("The server does not answer")
    site.start()
    sent(phones[2], READING)
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


def led_by_another_computer(site: GatedSite, window: Open, lecture: Page, phones: list[Page]) -> None:
    """It has never opened the file. It takes over at the second question, goes back to the first, which it has never
    shown, and ends the class.
    """
    lecture.wait_for_function(CONNECTED, timeout=BACK)
    for _ in range(2):
        clicked(lecture)
    put("curve", lecture, *phones, timeout=BACK)
    for phone in phones:
        draw(phone, lambda x: 0.2 + 0.6 * x)
        sent(phone)
    lecture.wait_for_function(copied("mine/curve", 3))
    other = window("", 1280, 844)
    other.goto(ticket(lecture, "Another computer", "word"))
    other.wait_for_function(f"{LED}?.news.number && oscillations.walks.walk?.card", timeout=BACK)
    other.wait_for_function(copied("mine/pull", 3))  # which the first computer had copied
    assert other.evaluate("oscillations.walks.walk.sheet.name") == "mine"
    expect(lecture.get_by_text("led by another computer").first).to_be_visible()
    expect(other.locator(".notice")).to_be_hidden()
    code, key = other.evaluate(f"[{LED}.room.code, {LED}.room.key]")
    assert call(site.url, f"/class/{code}/stored", word=key).json == {"answers": 6, "questions": 2}
    clicked(other, "PageUp")
    put("pull", other, *phones, timeout=BACK)
    other.wait_for_function("oscillations.walks.walk.lesson", timeout=BACK)
    counted(other, "2", "1", "0")
    other.evaluate(f"{LED}.end()")


@pytest.mark.slow
@pytest.mark.timeout(400)  # six windows
def test_no_answer_is_lost_when_the_server_is_killed(browser: Browser, tmp_path: Path) -> None:
    with GatedSite(tmp_path) as site, opening(browser, site.url) as window:
        lecture, code = taught(window, "scene=oscillator", 1280, 844)
        drop(lecture, "mine.toml", MINE)
        lecture.wait_for_function(f"{LED}?.news.question?.step === 'pull'", timeout=READING)
        remote, phones = remote_of(lecture, window), [joined(window, code) for _ in range(3)]
        put("pull", lecture, *phones, timeout=BACK)
        for phone in phones[:2]:
            tap(phone, 0)
            sent(phone)
        answered_without_a_server(site, phones, remote)
        expect(lecture.locator(".votes")).to_contain_text("3 of 3 have answered", timeout=BACK)
        lecture.wait_for_function(CONNECTED, timeout=BACK)
        remote.get_by_role("button", name="Show the votes").click()  # it is still accepted
        counted(lecture, "2", "1", "0")
        remote.get_by_role("button", name="Show the answer").click()
        lecture.wait_for_function("oscillations.walks.walk.lesson")
        expect(phones[2].get_by_text("Twice the pull is twice the force")).to_be_visible()
        loaded_again(site, lecture)
        led_by_another_computer(site, window, lecture, phones)
        for page in (*phones, remote):  # one that misses the last news doubts for half a minute that the class is over
            expect(page.locator("h1")).to_contain_text("The class is over.", timeout=2 * BACK)


def test_phones_behind_proxies(server: Server, browser: Browser, window: Open) -> None:
    """One polls, because its proxy holds streams back. The other wakes up with dead connections; asleep, it is not
    counted.
    """
    lecture, code = taught(window, "scene=coupled")
    with (
        between(server.port, holds=True) as holding, opening(browser, holding.url) as far,
        between(server.port) as proxy, opening(browser, proxy.url) as near,
    ):  # fmt: skip
        polls, sleeps = joined(far, code), joined(near, code)
        lecture.wait_for_function(f"{LED}.news.here === 2")
        sleeps.evaluate(HIDDEN, True)
        lecture.wait_for_function(f"{LED}.news.here === 1")
        proxy.silence()
        lecture.evaluate("oscillations.open({scene: 'forced'})")
        polls.wait_for_function("oscillations.page.spec.slug === 'forced'")
        assert sleeps.evaluate("oscillations.page.spec.slug") == "coupled"
        sleeps.evaluate(HIDDEN, False)
        sleeps.wait_for_function("oscillations.page.spec.slug === 'forced'")
        for page in (polls, sleeps):
            expect(page.locator(".class-bar")).to_contain_text("Following")
        lecture.evaluate(f"{LED}.end()")
        for page in (polls, sleeps):
            expect(page.get_by_role("heading", name="The class is over.")).to_be_visible()


COUNT = "sessionStorage.setItem('loads', 1 + Number(sessionStorage.getItem('loads')))"
LOADS = "sessionStorage.getItem('loads')"
VERSION = "document.documentElement.dataset.version[0]"
HEARD = "globalThis.oscillations?.news?.number"


def test_a_phone_of_another_version_reloads_the_page_but_not_twice_at_once(server: Server, failing: Open) -> None:
    page = failing(f"class={call(server.url, '/class', 'POST').json['code']}", 390, 844)
    page.wait_for_function(HEARD)
    page.add_init_script(COUNT)
    page.route(f"{server.url}?*", another_version)
    page.reload(wait_until="commit")  # the page reloads, perhaps before all of this one is loaded
    page.wait_for_function(f"{LOADS} === '2' && {HEARD}")
    passed(page)  # it would have happened by now
    assert page.evaluate(f"[{LOADS}, {VERSION}]") == ["2", "x"]
    page.unroute(f"{server.url}?*", another_version)
    page.reload(wait_until="commit")
    page.wait_for_function(f"{LOADS} === '3' && {HEARD}")
    page.evaluate("sessionStorage.removeItem('class-renewed')")
    with page.expect_response(re.compile("/events")):  # a stream of the same version again
        page.evaluate("oscillations.stream.control.abort()")
    passed(page)  # it would have happened by now
    assert page.evaluate(LOADS) == "3"
    assert page.evaluate(VERSION) != "x"


def losing(page: Page, path: str, kind: str = "") -> list[str]:
    """Let the first request to a path get no answer; return the data that was sent to it, in order."""
    found: list[str] = []

    def go(route: Route) -> None:
        told = json.loads(route.request.post_data or "{}")
        if told.get("type", "") == kind:
            found.append(told.get("step", route.request.url))
            if len(found) == 1:
                return route.abort()
        return route.continue_()

    page.route(re.compile(path), go)
    return found


def test_a_class_is_opened_once_no_order_is_overtaken_and_lost_requests_are_repeated(failing: Open) -> None:
    lecture = failing("walk=d31&step=d31-01", 1920, 1080)
    lecture.wait_for_function(CONNECTED)
    made: list[Request] = []
    lecture.on("request", lambda request: made.append(request) if request.url.endswith("/class") else None)
    lecture.evaluate("oscillations.classes.begin(); oscillations.classes.begin()")
    lecture.wait_for_function(LED)
    phone = joined(failing, lecture.evaluate(f"{LED}.room.code"))
    put("d31-01", lecture, phone)
    steps = losing(lecture, "/lead$", "put")
    for place in (1, 2):
        lecture.evaluate("place => oscillations.walks.walk.go(place)", place)
    put("d31-03", lecture, phone)
    assert steps == ["d31-02", "d31-02", "d31-03"]
    assert len(made) == lecture.locator(".class-code").count() == 1
    losing(lecture, "/tally$")
    tap(phone, 1)
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered")
    replies = losing(phone, "/answer$")
    explained(lecture, phone)
    expect(phone.locator(".answers [data-option='1'] .line")).not_to_be_empty()
    assert len(replies) == 2  # the reply to its answer is requested again
    losing(lecture, "/tickets$")
    lecture.keyboard.press("j")
    lecture.get_by_role("button", name="Remote control").click()
    expect(lecture.get_by_role("dialog")).to_contain_text("The server does not answer")
    sheets = losing(phone, "/assets/.*json")
    lecture.evaluate("oscillations.walks.leave(); oscillations.open({scene: 'forced'})")
    phone.wait_for_function(f"{READY} && oscillations.page.spec.slug === 'forced'")
    assert len(sheets) == 2


PHRASE = "swinging über springs"


def test_who_opens_a_class_is_asked_for_the_passphrase_and_the_qr_code_lets_phones_in(
    tmp_path: Path, browser: Browser
) -> None:
    environment = {"CLASS_PASSPHRASE": PHRASE}
    with serving(tmp_path / "log", environment=environment) as server, opening(browser, server.url) as window:
        page = window("scene=coupled", 1280, 800)
        page.wait_for_function(CONNECTED)
        page.keyboard.press("t")
        dialog = page.get_by_role("dialog", name="Passphrase")
        expect(dialog.get_by_role("heading")).to_have_text("Opening a class here needs the instructors' passphrase.")
        dialog.get_by_label("Passphrase").fill("another one")
        page.keyboard.press("Enter")
        expect(dialog.get_by_role("heading")).to_have_text(re.compile("^This is not the instructors' passphrase"))
        dialog.get_by_role("button", name="Cancel").click()
        expect(page.get_by_text("No class was opened.")).to_be_visible()
        page.keyboard.press("t")
        dialog.get_by_label("Passphrase").fill(PHRASE)
        dialog.get_by_role("button", name="Open the class").click()
        page.wait_for_function(LED)
        code, address = page.evaluate(f"[{LED}.room.code, {LED}.room.address]")
        phone, word = window("", 390, 844), address.partition("join=")[2]
        with phone.expect_request(lambda request: request.headers.get("authorization") == f"Bearer {word}"):
            phone.goto(f"{server.url}?class={code}&join={word}")
        phone.wait_for_function(f"{READY} && Boolean(oscillations.clock.lead)")
        assert not server.complaints()
