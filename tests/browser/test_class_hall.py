"""Steps of a walk in a hall with a class: next to its corner, with many votes, nothing is covered or cut off."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.browser.classroom import LED, Open, taught
from tests.browser.halls import LAID, TAUGHT, seen
from tests.browser.waiting import clicked
from tests.live_class.caller import call
from tests.serving.server import Server

pytestmark = pytest.mark.browser
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
def test_a_step_is_seen_whole_beside_the_corner_of_a_class(server: Server, window: Open) -> None:
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
