"""Every step of the walks in a hall, also with votes: nothing scrolls, is cut off or is too small."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from components.walks.loading import load_walks
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.number import NumericStep
from components.walks.subject import Subject
from components.walks.walk import Step
from tests.browser.classroom import LED, Open, taught
from tests.browser.fixtures import READY
from tests.browser.halls import LAID, TAUGHT, empty, seen
from tests.browser.waiting import clicked
from tests.grids import WHOLE, spread
from tests.live_class.caller import call
from tests.serving.server import Server

pytestmark = pytest.mark.browser
WALKS = load_walks(())
SIZES = ((1280, 720), (1366, 768), (1920, 1080), (3840, 2160))
WORST = (
    "d31-02",
    "d31-07",
    "d31-09",
    "d34-02",
    "d34-05",
    "d34-06",
    "d34-09",
    "d34-10",
    "d34-16",
    "tour-04",
    "waves-05",
)
"""The steps that need the most room of their kind, and the one that leaves the most."""
ASKED = f"place => oscillations.walks.walk?.place === place && !oscillations.walks.walk.lesson && {READY}"
UNFOLD = """open => {
  document.querySelector(".card .follows").open = open
  document.querySelector(".paper").style.visibility = open ? "hidden" : ""
}"""
"""The equations cover the paper."""
ANSWER = """given => {
  const {question} = oscillations.walks.walk.card, {marker, pad, field} = question
  if ("option" in given) question.restore(given)
  if (field) field.value = Number(given.value.toPrecision(3))
  if (marker) {
    const {start, end, exponent} = marker.ruler
    marker.value = Math.min(Math.max(given.value / 10 ** exponent, start), end)
  }
  const level = share => pad.plot.y.start + share * (pad.plot.y.end - pad.plot.y.start)
  for (const [i, heights] of [...(pad?.heights.values() ?? [])].entries()) heights.fill(level(0.3 + 0.4 * i))
}"""
"""The answer as a student would give it; how it is entered is tested elsewhere."""


def wordiest(step: Step) -> dict[str, Any]:
    """The answer with the longest reply."""
    if isinstance(step, ChoiceStep):
        return {"option": max(range(len(step.options)), key=lambda i: len(step.options[i].reply))}
    if isinstance(step, NumericStep) and step.misses:
        longest = max(range(len(step.misses)), key=lambda i: len(step.misses[i].reply))
        return {"value": step.wrong(Subject("", step, SCENES))[longest]}
    return {}


@pytest.mark.parametrize(("width", "height"), SIZES if WHOLE else SIZES[:1])
@pytest.mark.parametrize("name", spread(["d34", "d31", "d32-33", "waves", "tour"], 5))
def test_a_step_is_seen_whole(name: str, width: int, height: int, server: Server, page: Page) -> None:
    page.set_viewport_size({"width": width, "height": height})
    page.goto(f"{server.url}?walk={name}&projector")
    found: list[str] = []
    for place, step in enumerate(WALKS[name].steps):
        if not WHOLE and step.id not in WORST:
            continue
        page.wait_for_function(f"{READY} && oscillations.walks.walk")
        page.evaluate("place => oscillations.walks.walk.go(place)", place)
        page.wait_for_function(f"place => ({ASKED})(place) && {LAID}", arg=place)
        found += seen(page, height, f"{step.id}, before")
        share = 0.0 if any(part.startswith("words:") for part in step.show) else empty(page)  # formulas are short
        found += [f"{step.id}: {share:.0%} of the paper are empty"] if share > 1 / 3 else []
        page.evaluate(ANSWER, wordiest(step))
        page.evaluate("oscillations.walks.walk.show(true)")
        page.wait_for_function(TAUGHT)
        found += seen(page, height, f"{step.id}, after")
        if step.follows:
            page.evaluate(UNFOLD, True)
            found += seen(page, height, f"{step.id}, how it follows, after")
            page.evaluate(UNFOLD, False)
        page.get_by_role("button", name="Try", exact=True).click()
        found += seen(page, height, f"{step.id}, trying, after")
    assert not found, "\n".join(found)


MANY = 12
HEIGHT = 720
STEPS: dict[str, Callable[[int], dict[str, Any]]] = {
    "d34-12": lambda i: {"option": i % 3},
    "d34-14": lambda i: {"curves": {"Xp1": [round(500 + 400 * math.sin(i + j / 9)) for j in range(101)]}},
    "d34-10": lambda i: {"curves": {"x2": [round(500 + 400 * math.sin(i + j / 9)) for j in range(101)]}},
    "d34-08": lambda i: {"value": 0.8 + 0.1 * i},
    "d34-01": lambda i: {"text": f"{i % 4}"},
}
"""A step of each kind whose question or answer needs much room, and the answer of follower number n."""
SKETCHED = """[oscillations.walks.walk.card.question.plot].map(({frame, unit, host}) => {
  const names = [...document.querySelectorAll(".votes .chip")].map(chip => chip.textContent)
  const corner = document.querySelector(".class-corner").getBoundingClientRect()
  const isClear = host.getBoundingClientRect().top + frame.top * unit >= corner.bottom
  return [frame.height * unit / innerHeight, names.includes("Middle 50 %"), isClear]
})[0]"""
"""The share of the screen's height that sketches have, and whether their middle half is visible."""
GO = "id => oscillations.walks.walk.go(oscillations.walks.walk.sheet.steps.findIndex(step => step.id === id))"
PUT = f"id => {LED}.news.question?.step === id && !oscillations.walks.walk.lesson && {LAID}"


@pytest.mark.slow
def test_a_step_is_fully_visible_next_to_the_corner_of_a_class(server: Server, window: Open) -> None:
    lecture, code = taught(window, "walk=d34&projector")
    lecture.set_viewport_size({"width": 1280, "height": HEIGHT})
    tokens = [call(server.url, f"/class/{code}/token", "POST").json["token"] for _ in range(MANY)]
    found: list[str] = []
    for step, answer in STEPS.items():
        lecture.evaluate(GO, step)
        lecture.wait_for_function(PUT, arg=step)
        found += seen(lecture, HEIGHT, f"{step}, before")
        for i, token in enumerate(tokens):
            vote = {"walk": "d34", "step": step, **answer(i)}
            call(server.url, f"/class/{code}/now", word=token)  # a phone that polls is there
            assert call(server.url, f"/class/{code}/answer", "PUT", vote, token).status == 204
        shown(lecture)
        found += seen(lecture, HEIGHT, f"{step} with votes, before")
        found += narrow(lecture, step, answer(0))
        clicked(lecture)
        lecture.wait_for_function(TAUGHT)
        found += seen(lecture, HEIGHT, f"{step} with votes, after")
        found += narrow(lecture, step, answer(0))
        clicked(lecture)
        expect(lecture.locator(".card .why")).to_be_visible()
        found += seen(lecture, HEIGHT, f"{step} explained, after")
    assert not found, "\n".join(found)


def narrow(lecture: Page, step: str, answer: dict[str, Any]) -> list[str]:
    """The faults of a class's sketches: lower than half of the height, no middle half, or covered by the corner."""
    told = lecture.evaluate(SKETCHED) if "curves" in answer else [1, True, True]
    return [] if told[0] >= 0.5 and all(told[1:]) else [f"{step}: sketches have {told}"]


def shown(lecture: Page) -> None:
    clicked(lecture)
    expect(lecture.locator(".votes [role=status]")).to_contain_text(f"{MANY} have answered")
    expect(lecture.get_by_role("button", name="Vote again")).to_be_visible()
