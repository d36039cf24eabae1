"""Page Down alone leads through every step of every walk, and shows each headline and each explanation."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import Page, expect

from components.walks.loading import load_walks
from components.walks.walk import Step
from tests.browser.classroom import LED, Open, joined, taught
from tests.browser.halls import LAID, TAUGHT
from tests.browser.waiting import clicked, passed
from tests.grids import spread
from tests.live_class.caller import call
from tests.serving.server import Server
from tests.walks.voters import answers

pytestmark = pytest.mark.browser
WALKS = load_walks(())
NAMES = spread(["tour", "d31", "d32-33", "d34", "waves"], 5)
SIZE = {"width": 1280, "height": 720}
VOTERS = 57
PHONES = ((390, 844), (360, 640), (844, 390))
ASKED = f"id => oscillations.walks.walk?.step?.id === id && !oscillations.walks.walk.lesson && {LAID}"
HIDDEN = """parts => {
  const words = html => Object.assign(document.createElement("p"), {innerHTML: html}).textContent
  const {lesson} = oscillations.walks.walk, heading = document.querySelector("h1")
  const claims = heading.textContent === words(lesson.title) ? [] : [`the headline is ${heading.textContent}`]
  return claims.concat(parts.filter(name => {
    const part = document.querySelector(name)
    if (!part?.checkVisibility({visibilityProperty: true, opacityProperty: true})) return true
    const {left, top, right, bottom} = part.getBoundingClientRect()
    const under = document.elementFromPoint((left + right) / 2, top + 4)
    return top < 0 || left < 0 || right > innerWidth || bottom > innerHeight || !part.contains(under)
  }).map(name => `${name} is not seen`))
}"""
"""Faults of the answer in the headline, and of parts of the card that are not completely visible."""
CLAIM = ["h1", ".card .why"]
PUT = "id => oscillations.asked.question?.step === id && oscillations.asked.card"
GIVEN = "given => { const {question} = oscillations.asked.card; question.restore(given); question.changed() }"


def asked(page: Page, step: Step) -> None:
    page.wait_for_function(ASKED, arg=step.id)


def explained(page: Page, step: Step) -> list[str]:
    """Faults of headline, explanation, and with `derive` of the formulas; the next press continues."""
    passed(page)
    found = [f"{step.id}: {fault}" for fault in page.evaluate(HIDDEN, CLAIM)]
    if step.derive:
        clicked(page)
        passed(page)
        found += [f"{step.id}: {fault}" for fault in page.evaluate(HIDDEN, [".card .follows .lines"])]
    return found


@pytest.mark.parametrize("name", NAMES)
def test_alone(name: str, server: Server, page: Page) -> None:
    page.set_viewport_size(SIZE)
    page.goto(f"{server.url}?walk={name}&projector")
    found: list[str] = []
    for step in WALKS[name].steps:
        asked(page, step)
        clicked(page)
        page.wait_for_function(TAUGHT)
        found += explained(page, step)
        clicked(page)
    expect(page.locator("dialog:is(.contents, .finish)")).to_be_visible()
    assert not found, "\n".join(found)


@pytest.mark.timeout(600)  # sixteen steps, on four pages
@pytest.mark.parametrize("name", NAMES)
def test_with_votes(name: str, server: Server, window: Open) -> None:
    lecture, code = taught(window, f"walk={name}&projector")
    lecture.set_viewport_size(SIZE)
    phones = [joined(window, code, *size) for size in PHONES]
    tokens = [call(server.url, f"/class/{code}/token", "POST").json["token"] for _ in range(VOTERS)]
    found: list[str] = []

    for step in WALKS[name].steps:
        asked(lecture, step)
        voted(server, code, name, step, tokens, phones)
        expect(lecture.locator(".votes [role=status]")).to_contain_text(f"{VOTERS + len(PHONES) - 1} ")
        clicked(lecture)
        lecture.wait_for_function(f"{LED}.votes.layer")
        assert not lecture.evaluate("oscillations.walks.walk.lesson")
        clicked(lecture)
        lecture.wait_for_function(TAUGHT)
        for phone in phones:
            expect(phone.locator(".card .why")).to_be_attached()
        clicked(lecture)
        lecture.wait_for_function(f"!{LED}.votes.layer")
        found += explained(lecture, step)
        clicked(lecture)
    expect(lecture.locator("dialog:is(.contents, .finish)")).to_be_visible()
    assert not found, "\n".join(found)


def voted(server: Server, code: str, name: str, step: Step, tokens: list[str], phones: list[Page]) -> None:
    """All answer except the last phone."""
    given: list[dict[str, Any]] = answers(step, len(tokens))
    for phone in phones:
        phone.wait_for_function(PUT, arg=step.id)  # then the class takes answers
    for token, answer in zip(tokens, given, strict=True):
        call(server.url, f"/class/{code}/now", word=token)  # a phone that polls is there
        put = call(server.url, f"/class/{code}/answer", "PUT", {"walk": name, "step": step.id, **answer}, token)
        assert put.status == 204, f"{step.id}: {put.text}"
    for phone, answer in zip(phones[:-1], given, strict=False):
        phone.evaluate(GIVEN, answer)
        expect(phone.get_by_text("You can change it")).to_be_visible()
