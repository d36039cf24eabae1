"""The tour on a phone: each question on one screen, walked with wrong answers, right ones and none."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, expect

from components.walks.loading import load_walks
from components.walks.questions.choice import ChoiceStep
from tests.browser.fixtures import READY
from tests.serving.server import Server

pytestmark = pytest.mark.browser
STEPS = [step for step in load_walks(())["tour"].steps if isinstance(step, ChoiceStep)]
AT = "id => oscillations?.walks?.walk?.step?.id === id && document.querySelector('.asked')"
FITS = """() => {
  const [foot, answer] = [".foot", ".answers button:last-child"].map(one => document.querySelector(one))
  return answer.getBoundingClientRect().bottom <= foot.getBoundingClientRect().top
}"""
"""The last answer is above the buttons, which stay visible at the bottom of the screen."""

READ = """() => [...document.querySelectorAll(".asked-line, h1, .block:is(.stage, .plot), .answers, .foot")]
  .filter(one => one.checkVisibility()).map(one => one.getBoundingClientRect().top)"""
"""The parts in the order in which a screen reader reads them: how far down each is."""


@pytest.fixture
def tour(new_page: Callable[..., Page], server: Server) -> Page:
    page = new_page(390, 844, fresh=True, has_touch=True)
    page.goto(f"{server.url}?walk=tour")
    page.wait_for_function(READY)
    return page


def bottom(page: Page, selector: str) -> float:
    return float(page.locator(selector).last.evaluate("one => one.getBoundingClientRect().bottom"))


IS_ABOVE_FOOT = """one => one.getBoundingClientRect().bottom <=
  document.querySelector(".foot").getBoundingClientRect().top"""


@pytest.mark.parametrize("size", [(390, 844), (320, 568)], ids=str)
def test_all_of_a_question_is_on_the_first_screen(tour: Page, size: tuple[int, int]) -> None:
    tour.set_viewport_size({"width": size[0], "height": size[1]})
    for step in STEPS:
        tour.wait_for_function(AT, arg=step.id)
        expect(tour.locator(".answers button")).to_have_count(3)
        tour.wait_for_function(FITS)
        parts = (".asked-line", "h1", ".block:is(.stage, .plot):visible", ".answers button")
        places = [bottom(tour, part) for part in parts]
        assert places == sorted(places), (step.id, places)
        read = tour.evaluate(READ)
        assert read == sorted(read), (step.id, read)
        expect(tour.locator(".foot .ruler .here")).to_be_in_viewport(ratio=1)
        expect(tour.locator(".foot")).to_contain_text(f"{STEPS.index(step) + 1} of {len(STEPS)}")
        tour.get_by_role("button", name="Skip").click()


def test_a_handle_names_the_quantity_that_a_question_is_about(tour: Page) -> None:
    """Before the answer the axis has no other name."""
    tour.wait_for_function(AT, arg=STEPS[0].id)
    for step in STEPS[1:3]:
        tour.get_by_role("button", name="Skip").click()
        tour.wait_for_function(AT, arg=step.id)
    expect(tour.locator(".plot-area .pill:visible")).to_contain_text("frequency ratio")


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


def is_readable(page: Page) -> bool:
    """Return True if a plot that is the only one, except for a path, has an eighth of the screen's height."""
    plots = page.locator(".block.plot:not(.path):visible .plot-area")
    return plots.count() > 1 or plots.evaluate("area => area.clientHeight") > 844 / 8


@pytest.mark.parametrize("how", ["right", "wrong", "nothing"])
def test_a_student_walks_the_tour(tour: Page, how: str) -> None:
    for step in STEPS:
        tour.wait_for_function(AT, arg=step.id)
        forward = tour.locator(".foot .filled")
        expect(forward).to_have_text("Choose an answer")
        if how == "nothing":
            forward.click()
            expect(tour.get_by_role("alert").filter(has_text="Answer first: a guess is fine.")).to_be_visible()
            tour.get_by_role("button", name="Skip").click()
            continue
        i = next(i for i, option in enumerate(step.options) if option.right == (how == "right"))
        tour.locator(f".answers [data-option='{i}']").tap()
        expect(forward).to_have_text("Show the answer")
        forward.click()
        expect(tour.get_by_role("heading", level=1)).to_have_text(step.title)
        verdict = tour.get_by_role("status").filter(has_text=f"Your answer is {how}.")
        expect(verdict).to_be_in_viewport(ratio=1)
        expect(verdict.locator("svg")).to_be_visible()
        assert bottom(tour, ".judgement") < bottom(tour, "h1")
        reply = tour.locator(f".answers [data-option='{i}'] .line")
        expect(reply).to_have_text(step.options[i].reply.replace("*", ""))
        expect(tour.get_by_role("button", name="Skip")).to_have_count(0)
        parts = (".block.plot:visible", ".transport", ".card .why", ".tries", ".answers")
        order = [bottom(tour, part) for part in parts]
        assert order == sorted(order) and is_readable(tour), (step.id, order)
        # The slider that a task names is above the buttons; the task of the third step names a dot.
        slider = tour.locator(".tries .control").nth(1 if step.id == "tour-02" else 0)
        assert step.id == "tour-03" or slider.evaluate(IS_ABOVE_FOOT), step.id
        forward.click()
    end = tour.get_by_role("dialog", name="Done")
    expect(end).to_be_visible()
    judged(end, how)
    expect(end.locator("a.scene-card svg")).to_have_count(3)
    expect(end.get_by_role("link", name="All scenes")).to_be_visible()
    end.get_by_role("button", name="Close").click()
    expect(end).to_be_hidden()
    tour.get_by_role("button", name="Skip" if how == "nothing" else "Finish").click()
    end.get_by_role("link", name="Calm a machine").click()
    tour.wait_for_function(f"{READY} && oscillations.page.spec.slug === 'absorber'")


LOWEST = """() => Math.min(
  ...oscillations.plots.filter(({host}) => host.checkVisibility()).map(({frame}) => frame.height)
)"""
ON_SCREEN = """() => document.querySelector(".foot .filled").getBoundingClientRect().bottom <= innerHeight"""
"""The button that continues, without scrolling."""


def test_an_answer_on_a_small_phone_has_its_curve_and_the_way_on(tour: Page) -> None:
    tour.set_viewport_size({"width": 320, "height": 568})
    for step in STEPS:
        tour.wait_for_function(AT, arg=step.id)
        tour.locator(".answers button").first.tap()
        tour.locator(".foot .filled").click()
        expect(tour.get_by_role("heading", level=1)).to_have_text(step.title)
        tour.wait_for_function(ON_SCREEN)
        assert tour.evaluate(LOWEST) >= 28, step.id
        tour.locator(".foot .filled").click()
