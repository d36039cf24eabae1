"""A server is killed and started again during a class; it gets the class back from the instructor's page."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect

from tests.browser.classroom import CONNECTED, LED, counted
from tests.browser.dropping import drop
from tests.browser.fixtures import READY
from tests.browser.tabs import calm_context
from tests.live_class.caller import call
from tests.reconnect.site import Site

pytestmark = pytest.mark.browser

BOTH = f"Object.keys({LED}.copies.answers.get('d31/d31-03/1')).length === 2"
COPIED = f"{LED}.copies.answers.size && !{LED}.copies.stale.size"
MINE = 'title = "Mine"\n[[step]]\nid = "pull"\nfrom = "d31-03"\n'
AGAIN = 30_000
"""Milliseconds in which a page must reconnect."""


@pytest.fixture
def contexts(browser: Browser) -> Iterator[list[BrowserContext]]:
    """The browsers of the instructor, of a phone, and of the remote control, later that of another computer; they note
    as errors what a lost server refuses."""
    sizes = ((1280, 844), (390, 844), (390, 844))
    made = [calm_context(browser, {"width": w, "height": h}, bypass_csp=True) for w, h in sizes]
    yield made
    for context in made:
        context.close()


@pytest.mark.slow
@pytest.mark.timeout(300)  # two servers are killed under four windows
def test_a_killed_server_has_the_class_again(contexts: list[BrowserContext], tmp_path: Path) -> None:
    with Site(tmp_path) as site:
        lecture, phone, remote = (context.new_page() for context in contexts)
        code = _begun(lecture, site)
        _paired(lecture, remote)
        _answered(lecture, phone, site, code)

        site.kill()
        expect(phone.locator(".class-bar")).to_contain_text("Not connected")
        expect(remote.locator(".class-remote > [role=status]")).to_contain_text("The server does not answer")
        site.start()
        expect(phone.locator(".class-bar")).to_contain_text("Following", timeout=AGAIN)
        lecture.wait_for_function(f"{LED}.news.here === 1 && {LED}.votes.tally?.now.answered === 2", timeout=AGAIN)
        assert lecture.evaluate(f"{LED}.room.code") == code
        lecture.wait_for_function("document.documentElement.dataset.connected === 'true'", timeout=AGAIN)
        expect(remote.locator(".class-remote > [role=status]")).to_contain_text("3 of 16", timeout=AGAIN)
        remote.get_by_role("button", name="Show the votes").click()  # it is still accepted
        counted(lecture, "1", "1", "0")
        remote.get_by_role("button", name="Show the answer").click()
        lecture.wait_for_function("oscillations.walks.walk.lesson")
        expect(phone.get_by_text("Twice the pull is twice the force")).to_be_visible()

        lecture.wait_for_function(BOTH)
        site.kill()  # the instructor's page is reloaded meanwhile, after the answer was shown
        site.start()
        lecture.reload()
        lecture.wait_for_function(f"{LED}?.news.number && {LED}.room.code === '{code}'", timeout=AGAIN)
        lecture.wait_for_function(f"{LED}.news.question.lesson && {LED}.votes.tally?.now.answered === 2")

        other = contexts[2].new_page()
        _taken_over(lecture, other)
        other.evaluate(f"{LED}.end()")
        for page in (phone, remote):
            expect(page.locator("h1")).to_contain_text("The class is over.", timeout=AGAIN)


def _begun(lecture: Page, site: Site) -> str:
    """The code of a class that asks its first question."""
    lecture.goto(f"{site.url}?walk=d31&step=d31-03")
    lecture.wait_for_function(CONNECTED)
    lecture.keyboard.press("t")
    lecture.wait_for_function(f"{LED}?.news.question?.step === 'd31-03'")
    code: str = lecture.evaluate(f"{LED}.room.code")
    return code


def _answered(lecture: Page, phone: Page, site: Site, code: str) -> None:
    """A phone answers; another one has answered before and has left."""
    phone.goto(f"{site.url}{code}")
    phone.wait_for_function(f"{READY} && oscillations.asked.card")
    gone = call(site.url, f"/class/{code}/token", "POST").json["token"]  # a phone that leaves
    call(site.url, f"/class/{code}/now", word=gone)
    vote = {"walk": "d31", "step": "d31-03", "option": 1}
    assert call(site.url, f"/class/{code}/answer", "PUT", vote, gone).status == 204
    lecture.wait_for_function(COPIED)
    phone.locator(".answers [data-option='0']").click()
    expect(phone.get_by_text("You can change it")).to_be_visible()


def _paired(lecture: Page, remote: Page) -> None:
    """A phone is accepted as the remote control."""
    lecture.keyboard.press("j")
    with lecture.expect_response(re.compile("/tickets$")) as answer:
        lecture.get_by_role("button", name="Remote control").click()
    remote.goto(answer.value.json()["address"])
    lecture.get_by_role("button", name="Yes, connect it").click()
    remote.get_by_role("button", name="Close").click()
    expect(lecture.get_by_role("dialog")).to_have_count(0)


def _taken_over(lecture: Page, other: Page) -> None:
    """Another computer leads the class, and has the walk from a file that it never opened."""
    lecture.wait_for_function(CONNECTED)
    drop(lecture, "mine.toml", MINE)
    # The server has to start a new process that reads walks, which takes long on a busy machine.
    lecture.wait_for_function(f"{LED}.news.question?.step === 'pull'", timeout=3 * AGAIN)
    other.set_viewport_size({"width": 1280, "height": 844})
    lecture.keyboard.press("j")
    with lecture.expect_response(re.compile("/word$")) as answer:
        lecture.get_by_role("button", name="Another computer").click()
    other.goto(answer.value.json()["address"])
    expect(lecture.get_by_text("led by another computer").first).to_be_visible()
    other.wait_for_function(f"{LED}?.news.question?.step === 'pull' && oscillations.walks.walk?.card", timeout=AGAIN)
    assert other.evaluate("oscillations.walks.walk.sheet.name") == "mine"
    expect(other.locator(".notice")).to_be_hidden()
