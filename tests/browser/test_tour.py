"""The tour on a phone: each question on one screen, walked with wrong answers, right ones and none."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, expect

from components.walks.loading import load_walks
from components.walks.questions.choice import ChoiceStep
from tests.browser.fixtures import READY
from tests.browser.waiting import passed
from tests.grids import sample
from tests.serving.server import Server

pytestmark = pytest.mark.browser
STEPS = [step for step in load_walks(())["tour"].steps if isinstance(step, ChoiceStep)]
AT = "id => oscillations?.walks?.walk?.step?.id === id && document.querySelector('.asked')"
BOTTOMS = """names => names.map(name => [...document.querySelectorAll(name)].filter(one => one.checkVisibility()).at(-1)
  .getBoundingClientRect().bottom)"""
FITS = """() => {
  const [foot, answer] = [".foot", ".answers button:last-child"].map(one => document.querySelector(one))
  return answer.getBoundingClientRect().bottom <= foot.getBoundingClientRect().top
}"""
"""The last answer is above the buttons, which stay visible at the bottom of the screen."""
READ = """() => [...document.querySelectorAll(".asked-line, h1, .block:is(.stage, .plot), .answers, .foot")]
  .filter(one => one.checkVisibility()).map(one => one.getBoundingClientRect().top)"""
"""The parts in the order in which a screen reader reads them: how far down each is."""
QUESTION = [".asked-line", "h1", ".block:is(.stage, .plot)", ".answers button"]
ANSWER = [".judgement", "h1", ".block.plot", ".transport", ".card .why", ".tries", ".answers"]
IS_ABOVE_FOOT = """one => one.getBoundingClientRect().bottom <=
  document.querySelector(".foot").getBoundingClientRect().top"""
LOWEST = """() => Math.min(
  ...oscillations.plots.filter(({host}) => host.checkVisibility()).map(({frame}) => frame.height)
)"""
ON_SCREEN = """() => document.querySelector(".foot .filled").getBoundingClientRect().bottom <= innerHeight"""
"""The button that continues, without scrolling."""
LARGE, SMALL = (390, 844), (320, 568)


@pytest.fixture
def tour(new_page: Callable[..., Page], server: Server) -> Page:
    page = new_page(*LARGE, fresh=True, has_touch=True)
    page.goto(f"{server.url}?walk=tour")
    page.wait_for_function(READY)
    return page


def resized(tour: Page, size: tuple[int, int]) -> None:
    tour.set_viewport_size({"width": size[0], "height": size[1]})
    passed(tour)


def asked(tour: Page, place: int) -> None:
    """All of a question is on the first screen of a phone."""
    for size in (SMALL, LARGE):
        resized(tour, size)
        tour.wait_for_function(AT, arg=STEPS[place].id)
        expect(tour.locator(".answers button")).to_have_count(3)
        tour.wait_for_function(FITS)
        for places in (tour.evaluate(BOTTOMS, QUESTION), tour.evaluate(READ)):
            assert places == sorted(places), (STEPS[place].id, places)
        expect(tour.locator(".foot .ruler .here")).to_be_in_viewport(ratio=1)
        expect(tour.locator(".foot")).to_contain_text(f"{place + 1} of {len(STEPS)}")
    if place == 2:  # before the answer the axis has no other name
        expect(tour.locator(".plot-area .pill:visible")).to_contain_text("frequency ratio")


def answered(tour: Page, step: ChoiceStep, how: str) -> None:
    """The answer says if it is right, then comes the picture, readable also on a small phone."""
    i = next(i for i, option in enumerate(step.options) if option.right == (how == "right"))
    tour.locator(f".answers [data-option='{i}']").tap()
    forward = tour.locator(".foot .filled")
    expect(forward).to_have_text("Show the answer")
    forward.click()
    expect(tour.get_by_role("heading", level=1)).to_have_text(step.title)
    verdict = tour.get_by_role("status").filter(has_text=f"Your answer is {how}.")
    expect(verdict).to_be_in_viewport(ratio=1)
    expect(verdict.locator("svg")).to_be_visible()
    reply = tour.locator(f".answers [data-option='{i}'] .line")
    expect(reply).to_have_text(step.options[i].reply.replace("*", ""))
    expect(tour.get_by_role("button", name="Skip")).to_have_count(0)
    places = tour.evaluate(BOTTOMS, ANSWER)
    assert places == sorted(places), (step.id, places)
    plots = tour.locator(".block.plot:not(.path):visible .plot-area")
    assert plots.count() > 1 or plots.evaluate("area => area.clientHeight") > 844 / 8
    # The slider that a task names is above the buttons; the task of the third step names a dot.
    slider = tour.locator(".tries .control").nth(1 if step.id == "tour-02" else 0)
    assert step.id == "tour-03" or slider.evaluate(IS_ABOVE_FOOT), step.id
    resized(tour, SMALL)
    tour.wait_for_function(ON_SCREEN)
    assert tour.evaluate(LOWEST) >= 28, step.id
    forward.click()


def judged(end: Locator, how: str) -> None:
    """The last page counts the answers and names each step with its result."""
    counts = {"right": "5 of your 5 answers were right.", "wrong": "0 of your 5 answers were right.", "nothing": "Five"}
    expect(end.locator("p")).to_contain_text(counts[how])
    results = end.locator(".results li")
    expect(results).to_have_count(len(STEPS))
    for row, step in zip(results.all(), STEPS, strict=True):
        said = step.question if how == "nothing" else step.title
        expect(row).to_contain_text(re.search(r"[^.]+$", said)[0].strip())
        expect(row).to_contain_text("skipped" if how == "nothing" else how)


@pytest.mark.parametrize("how", sample(["wrong", "right", "nothing"], 3))
def test_a_student_walks_the_tour(tour: Page, how: str) -> None:
    for place, step in enumerate(STEPS):
        asked(tour, place)
        forward = tour.locator(".foot .filled")
        expect(forward).to_have_text("Choose an answer")
        if how != "nothing":
            answered(tour, step, how)
            continue
        forward.click()
        expect(tour.get_by_role("alert").filter(has_text="Answer first: a guess is fine.")).to_be_visible()
        tour.get_by_role("button", name="Skip").click()
    end = tour.get_by_role("dialog", name="Done")
    judged(end, how)
    expect(end.locator("a.scene-card svg")).to_have_count(3)
    expect(end.get_by_role("link", name="All scenes")).to_be_visible()
    end.get_by_role("button", name="Close").click()
    expect(end).to_be_hidden()
    tour.get_by_role("button", name="Skip" if how == "nothing" else "Finish").click()
    end.get_by_role("link", name="Calm a machine").click()
    tour.wait_for_function(f"{READY} && oscillations.page.spec.slug === 'absorber'")
