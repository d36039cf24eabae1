"""Every step of the walks in a hall, before and after its answer: nothing scrolls, is cut off or is too small."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import Page

from components.scenes import SCENES
from components.walks.loading import load_walks
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.number import NumericStep
from components.walks.subject import Subject
from components.walks.walk import Step
from tests.browser.fixtures import READY
from tests.browser.halls import LAID, TAUGHT, empty, seen
from tests.grids import WHOLE, spread
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
