"""A server is killed and started again while a class goes on: it has the class again, from the instructor's page."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect

from tests.browser.classroom import CONNECTED, LED, counted
from tests.browser.fixtures import READY
from tests.live_class.caller import call
from tests.reconnect.site import Site

pytestmark = pytest.mark.browser

BOTH = f"Object.keys({LED}.kept.answers.get('d31/d31-03/1')).length === 2"
COPIED = f"{LED}.kept.answers.size && !{LED}.kept.stale.size"


@pytest.fixture
def contexts(browser: Browser) -> Iterator[list[BrowserContext]]:
    """The instructor's browser and a phone's, which note as errors what a lost server refuses."""
    made = [browser.new_context(viewport={"width": width, "height": 844}, bypass_csp=True) for width in (1280, 390)]
    yield made
    for context in made:
        context.close()


def test_a_killed_server_has_the_class_again(contexts: list[BrowserContext], tmp_path: Path) -> None:
    with Site(tmp_path) as site:
        lecture, phone = (context.new_page() for context in contexts)
        code = _begun(lecture, site)
        phone.goto(f"{site.url}{code}")
        phone.wait_for_function(f"{READY} && oscillations.asked.card")
        gone = call(site.url, f"/class/{code}/token", "POST").json["token"]  # a phone that leaves
        call(site.url, f"/class/{code}/now", word=gone)
        vote = {"walk": "d31", "step": "d31-03", "option": 1}
        assert call(site.url, f"/class/{code}/answer", "PUT", vote, gone).status == 204
        lecture.wait_for_function(COPIED)
        phone.locator(".answers [data-option='0']").click()
        expect(phone.get_by_text("Sent. You can change it")).to_be_visible()

        site.kill()
        expect(phone.locator(".class-bar")).to_contain_text("Not connected")
        site.start()
        expect(phone.locator(".class-bar")).to_contain_text("Following", timeout=30_000)
        lecture.wait_for_function(f"{LED}.news.here === 1 && {LED}.votes.tally?.now.answered === 2", timeout=30_000)
        assert lecture.evaluate(f"{LED}.room.code") == code
        lecture.wait_for_function("document.documentElement.dataset.connected === 'true'", timeout=30_000)
        lecture.keyboard.press("PageDown")
        counted(lecture, "1", "1", "0")
        lecture.wait_for_timeout(500)
        lecture.keyboard.press("PageDown")
        lecture.wait_for_function("oscillations.walks.walk.lesson")
        expect(phone.get_by_text("Twice the pull is twice the force")).to_be_visible()

        lecture.wait_for_function(BOTH)
        site.kill()  # the instructor's page is loaded anew meanwhile, and the answer had been shown
        site.start()
        lecture.reload()
        lecture.wait_for_function(f"{LED}?.news.number && {LED}.room.code === '{code}'", timeout=30_000)
        lecture.wait_for_function(f"{LED}.news.question.lesson && {LED}.votes.tally?.now.answered === 2")


def _begun(lecture: Page, site: Site) -> str:
    """The code of a class that asks its first question."""
    lecture.goto(f"{site.url}?walk=d31&step=d31-03")
    lecture.wait_for_function(CONNECTED)
    lecture.keyboard.press("t")
    lecture.wait_for_function(f"{LED}?.news.question?.step === 'd31-03'")
    code: str = lecture.evaluate(f"{LED}.room.code")
    return code
