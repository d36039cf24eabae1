"""Every step of every walk in a hall, led by a clicker, by keys and by touch, and with votes: nothing scrolls, is cut
off or is too small, and each headline and each explanation is seen.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from components.walks.loading import load_walks
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.number import NumberStep, NumericStep
from components.walks.questions.point import PointStep
from components.walks.questions.sketch import SketchStep
from components.walks.subject import Subject
from components.walks.walk import Step
from tests.browser.classroom import FILLED, FRAME, LED, Open, joined, put, sent, taught
from tests.browser.halls import LAID, TAUGHT, empty, seen
from tests.browser.touch import swipe
from tests.browser.waiting import clicked, passed
from tests.grids import WHOLE, sample
from tests.live_class.caller import call
from tests.serving.server import Server
from tests.walks.answers import answers

pytestmark = pytest.mark.browser
WALKS = load_walks(())
NAMES = ["tour", "d31", "d32-33", "d34", "waves"]
SLOWER = [f"{name} {by}" for by in ("clicker", "keys", "touch") for name in NAMES if (name, by) != ("tour", "keys")]
LEADS = ["tour keys", *(pytest.param(led, marks=pytest.mark.slow) for led in sample(SLOWER, 5))]
SIZES = ((1280, 720), (1366, 768), (1920, 1080), (3840, 2160))
HEIGHT = 720
WORST = {
    *("d31-02", "d31-07", "d31-09", "d34-02", "d34-05", "d34-06", "d34-09", "d34-10", "d34-16"),
    *("tour-04", "waves-05"),
}
"""The steps that need the most room of their kind, and the one that leaves the most."""
CROWDED = {"d34-01", "d34-08", "d34-10", "d34-12", "d34-14"}
"""A step of each kind whose question or answer needs much room next to the corner of a class."""
ASKED = f"id => oscillations.walks.walk?.step?.id === id && !oscillations.walks.walk.lesson && {LAID}"
UNFOLD = """open => {
  document.querySelector(".card .follows").open = open
  document.querySelector(".paper").style.visibility = open ? "hidden" : ""
}"""
"""The equations cover the paper."""
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
GIVEN = "given => { const {question} = oscillations.asked.card; question.restore(given); question.changed() }"
NAMED = """oscillations.walks.walk.step.controls.filter(name => {
  const part = document.querySelector(`.card .borrowed :is([name="${name}"], [data-name="${name}"])`)
  return !part?.checkVisibility()
}).map(name => `${name} is not on the card`)"""
FREE = """[...document.querySelectorAll(".paper :is(.choice, [data-grab])")].filter(part => {
  const sets = part.getAttribute("data-grab")?.split(" ") ?? []
  return part.checkVisibility() && !part.inert && !oscillations.walks.walk.step.controls.some(one => sets.includes(one))
}).map(part => `sets values outside the step: ${part.outerHTML}`)"""
MISSING = """[...document.querySelectorAll(".card .why, .card .why [data-value]")].map(part => part.textContent.trim())
  .filter(text => !text || text.includes("?")).map(text => `a number is missing: ${text}`)"""
SKETCHED = """[oscillations.walks.walk.card.question.plot].map(({frame, unit, host}) => {
  const names = [...document.querySelectorAll(".votes .chip")].map(chip => chip.textContent)
  const corner = document.querySelector(".class-corner").getBoundingClientRect()
  const isClear = host.getBoundingClientRect().top + frame.top * unit >= corner.bottom
  return frame.height * unit / innerHeight >= 0.5 && names.includes("Middle 50 %") && isClear
})[0]"""
"""True if sketches have half of the screen's height, a visible middle half, and are not covered by the corner."""


def wordiest(step: Step) -> int | str:
    """The answer with the longest reply, to a question with options or numbers."""
    if isinstance(step, ChoiceStep):
        return max(range(len(step.options)), key=lambda i: len(step.options[i].reply))
    if not isinstance(step, NumericStep) or not step.misses:
        return "2"
    longest = max(range(len(step.misses)), key=lambda i: len(step.misses[i].reply))
    return f"{step.wrong(Subject('', step, SCENES))[longest]:.3g}"


def answered(page: Page, step: Step, by: str) -> None:
    """Answer with keys or with a finger."""
    if isinstance(step, ChoiceStep):
        option = page.locator(f".answers [data-option='{wordiest(step)}']")
        if by == "touch":
            return option.tap()
        place = page.locator(".answers [data-option]").evaluate_all(
            "(all, i) => all.findIndex(one => one.dataset.option === i)", str(wordiest(step))
        )
        return page.keyboard.press(f"{place + 1}")
    if isinstance(step, NumberStep):
        return page.get_by_role("textbox", name="Your answer").fill(str(wordiest(step)))
    if by == "keys" and isinstance(step, PointStep):
        return page.locator(".pill-mark").press("ArrowRight")
    if by == "keys":
        for key in ("Enter", *["Shift+ArrowRight"] * 9):
            page.get_by_role("application").press(key)
        return None
    frame = FRAME.replace(".pad", ".marker") if isinstance(step, PointStep) else FRAME
    left, top, width, height = page.evaluate(frame)
    return swipe(page, (left + width / 3, top + height / 3), (round(width / 3), round(height / 3)))


def forward(page: Page, step: Step, by: str) -> None:
    """Show the answer to a question, after an answer if keys or a finger lead."""
    if by == "clicker":
        return clicked(page)
    answered(page, step, by)
    if by == "touch":
        return page.locator(FILLED).tap()
    page.evaluate("document.activeElement.blur()")
    return page.keyboard.press("r")


def onward(page: Page, by: str) -> None:
    if by == "clicker":
        clicked(page)
    elif by == "touch":
        page.locator(FILLED).tap()
    else:
        page.locator(FILLED).press("Enter")


def explained(page: Page, step: Step, by: str) -> Iterator[str]:
    """Faults of headline, explanation, and with `derive` of the formulas; the next press continues."""
    passed(page)
    yield from page.evaluate(HIDDEN, ["h1", ".card .why"])
    yield from page.evaluate(MISSING)
    if step.derive:
        onward(page, by)
        passed(page)
        yield from page.evaluate(HIDDEN, [".card .follows .lines"])


def with_room(page: Page, step: Step, by: str) -> Iterator[str]:
    """Faults of a step in all that it shows."""
    height = page.viewport_size["height"] if page.viewport_size else HEIGHT
    yield from seen(page, height, "before")
    share = 0.0 if any(part.startswith("words:") for part in step.show) else empty(page)  # formulas are short
    if share > 1 / 3:
        yield f"{share:.0%} of the paper are empty"
    forward(page, step, by)
    page.wait_for_function(TAUGHT)
    yield from seen(page, height, "after")
    if step.follows:
        page.evaluate(UNFOLD, True)
        yield from seen(page, height, "how it follows, after")
        page.evaluate(UNFOLD, False)
    opener = page.get_by_role("button", name="Try", exact=True)
    opener.click()
    yield from seen(page, height, "trying, after")
    opener.click()


def on_a_desk_and_a_phone(page: Page) -> Iterator[str]:
    """The controls of a step are on its card, and no others can be used."""
    size = page.viewport_size
    page.keyboard.press("p")
    for width, height in ((1280, 720), (390, 844)):
        page.set_viewport_size({"width": width, "height": height})
        passed(page)
        if page.evaluate("document.documentElement.scrollWidth > innerWidth"):
            yield f"{width}: the page scrolls sideways"
        yield from page.evaluate(NAMED) + page.evaluate(FREE)
    assert size
    page.set_viewport_size(size)
    page.keyboard.press("p")


@pytest.mark.timeout(600)  # up to 21 steps
@pytest.mark.parametrize("size", SIZES if WHOLE else SIZES[:1], ids=str)
@pytest.mark.parametrize("led", LEADS)
def test_alone(led: str, size: tuple[int, int], server: Server, new_page: Callable[..., Page]) -> None:
    name, by = led.split()
    page = new_page(*size, has_touch=by == "touch")
    page.goto(f"{server.url}?walk={name}&projector")
    found: list[str] = []
    for step in WALKS[name].steps:
        page.wait_for_function(ASKED, arg=step.id)
        if by == "keys" and (WHOLE or step.id in WORST):
            found += [f"{step.id}: {fault}" for fault in with_room(page, step, by)]
        else:
            forward(page, step, by)
            page.wait_for_function(TAUGHT)
        found += [f"{step.id}: {fault}" for fault in explained(page, step, by)]
        if by == "clicker":
            found += [f"{step.id}: {fault}" for fault in on_a_desk_and_a_phone(page)]
        onward(page, by)
    expect(page.locator("dialog:is(.contents, .finish)")).to_be_visible()
    assert not found, "\n".join(found)


VOTERS = 57
PHONES = ((390, 844), (360, 640), (844, 390))


@pytest.mark.timeout(600)  # up to 21 steps, on four pages
@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES if WHOLE else ["d34"])
def test_with_votes(name: str, server: Server, window: Open) -> None:
    lecture, code = taught(window, f"walk={name}&projector", 1280, HEIGHT)
    phones = [joined(window, code, *size) for size in PHONES]
    tokens = [call(server.url, f"/class/{code}/token", "POST").json["token"] for _ in range(VOTERS)]
    found: list[str] = []

    def look(step: Step, when: str) -> None:
        if WHOLE or step.id in CROWDED:
            found.extend(seen(lecture, HEIGHT, f"{step.id}, {when}"))
            if isinstance(step, SketchStep) and "votes" in when:
                assert lecture.evaluate(SKETCHED), step.id

    for step in WALKS[name].steps:
        lecture.wait_for_function(ASKED, arg=step.id)
        look(step, "before")
        put(step.id, lecture, *phones)  # then the class takes answers
        voted(server, code, name, step, tokens, phones)
        expect(lecture.locator(".votes [role=status]")).to_contain_text(f"{VOTERS + len(PHONES) - 1} ")
        clicked(lecture)
        lecture.wait_for_function(f"{LED}.votes.layer")
        assert not lecture.evaluate("oscillations.walks.walk.lesson")
        look(step, "with votes, before")
        clicked(lecture)
        lecture.wait_for_function(TAUGHT)
        look(step, "with votes, after")
        for phone in phones:
            expect(phone.locator(".card .why")).to_be_attached()
        clicked(lecture)
        lecture.wait_for_function(f"!{LED}.votes.layer")
        look(step, "explained, after")
        found += [f"{step.id}: {fault}" for fault in explained(lecture, step, "clicker")]
        clicked(lecture)
    expect(lecture.locator("dialog:is(.contents, .finish)")).to_be_visible()
    assert not found, "\n".join(found)


def voted(server: Server, code: str, name: str, step: Step, tokens: list[str], phones: list[Page]) -> None:
    """All answer except the last phone."""
    given: list[dict[str, Any]] = answers(step, len(tokens))
    for token, answer in zip(tokens, given, strict=True):
        call(server.url, f"/class/{code}/now", word=token)  # a phone that polls is there
        made = call(server.url, f"/class/{code}/answer", "PUT", {"walk": name, "step": step.id, **answer}, token)
        assert made.status == 204, f"{step.id}: {made.text}"
    for phone, answer in zip(phones[:-1], given, strict=False):
        phone.evaluate(GIVEN, answer)
        sent(phone)
