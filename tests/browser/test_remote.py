"""The remote control of a class: the question, the votes, and buttons that have an effect now."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

from tests.browser.classroom import Open, joined, remote_of, taught
from tests.live_class.caller import call
from tests.serving.server import Server

pytestmark = pytest.mark.browser
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
