"""A class sketches: an exact curve from a phone is judged right there and in the hall, and is drawn on the true one."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from components.walks.loading import load_walks
from components.walks.questions.sketch import SketchStep
from tests.browser.classroom import Open, explained, joined, put, sent, taught
from tests.browser.hands import stroke
from tests.grids import sample
from tests.walks.answers import strokes

pytestmark = pytest.mark.browser
PLACES = """points => { const {plot} = oscillations.asked.card.question.pad
  const b = plot.host.getBoundingClientRect(), f = plot.frame
  return points.filter(([x]) => x >= plot.x.start && x <= plot.x.end).map(([x, y]) => [
    b.left + plot.px(x), b.top + Math.min(Math.max(plot.py(y), f.top - 10), f.top + f.height + 10)]) }"""
ABOVE = """() => document.querySelector(".drawing").getBoundingClientRect().bottom
  <= document.querySelector(".class-bar").getBoundingClientRect().top"""
NUMBERED = "card.question.plot.figure.numbered"
INKED = """points => { const {plot, canvas} = oscillations.classes.led.votes.layer
  const ink = canvas.getContext("2d"), scale = devicePixelRatio * plot.unit, f = plot.frame
  const places = points.map(([x, y]) => [plot.px(x), plot.py(y)])
  const seen = places.filter(([x, y]) => x > f.left + 4 && x < f.left + f.width - 4
    && y > f.top + 4 && y < f.top + f.height - 4)
  const inked = seen.filter(([x, y]) => ink.getImageData(scale * x - 5, scale * y - 5, 11, 11).data.some(Boolean))
  return seen.length && inked.length > 0.95 * seen.length }"""
SKETCHED = sorted(
    [(walk, step) for walk in load_walks(()).values() for step in walk.steps if isinstance(step, SketchStep)],
    key=lambda one: -len(strokes(one[1])),
)
"""Walks and steps; first one with two curves."""


@pytest.mark.parametrize("step", sample([step.id for _, step in SKETCHED], 20))
def test_the_exact_curve_from_a_phone_is_right(step: str, window: Open) -> None:
    walk, asked = next(one for one in SKETCHED if one[1].id == step)
    lecture, code = taught(window, f"walk={walk.name}&step={step}")
    phone = joined(window, code)
    put(step, lecture, phone)
    curves = strokes(asked)
    for name, points in curves.items():
        if len(curves) > 1:
            phone.get_by_role("button", name=f"Draw {name}", exact=True).click()
        phone.locator(".drawing").scroll_into_view_if_needed()
        stroke(phone, phone.evaluate(PLACES, points))
    sent(phone)
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered")
    explained(lecture, phone)
    lecture.wait_for_function(f"oscillations.classes.led.votes.tally?.step === '{step}'")
    tally = lecture.evaluate("oscillations.classes.led.votes.tally.now.sketches")
    assert [one["has"] for one in tally] == [[True] * len(asked.must)]
    expect(phone.locator(".findings li")).to_have_count(len(asked.must))
    expect(phone.locator(".findings")).to_contain_text("yours")
    assert "missed" not in phone.locator(".findings").inner_text()
    lecture.wait_for_function("!oscillations.shown.state.covered.length")
    lecture.wait_for_function(INKED, arg=[point for points in curves.values() for point in points])


def test_the_pad_is_above_the_bar_of_the_class(window: Open) -> None:
    """A drawing does not cover the bar. A plot that the step lists has the numbers of the time."""
    lecture, code = taught(window, "walk=d34&step=d34-10&projector")
    phone = joined(window, code, 844, 390)
    put("d34-10", lecture, phone)
    phone.wait_for_function(ABOVE)
    assert phone.evaluate(f"oscillations.asked.{NUMBERED}") and lecture.evaluate(f"oscillations.walks.walk.{NUMBERED}")
