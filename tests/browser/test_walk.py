"""A guided walk in a browser: questions, answers by mouse, finger and keys, contents, and stored answers."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from itertools import pairwise

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from tests.browser.classroom import FRAME, draw
from tests.browser.halls import TAUGHT
from tests.browser.touch import Finger
from tests.browser.waiting import QUIET, passed
from tests.grids import sample
from tests.serving.server import Server

pytestmark = pytest.mark.browser
CARD = "document.documentElement.dataset.ready === 'true' && document.querySelector('.card')"
PHONE = (390, 844)
TOPS = """names => names.map(name => [...document.querySelectorAll(name)].find(one => one.checkVisibility())
  .getBoundingClientRect()).map(({top, bottom}) => [top, bottom])"""

Walk = Callable[..., Page]


@pytest.fixture
def walk(server: Server, new_page: Callable[..., Page]) -> Walk:
    def open_step(step: str, *size: int, init: str = "", **options: bool) -> Page:
        page = new_page(*size, fresh=bool(init), **options)
        if init:
            page.add_init_script(init)
        page.goto(f"{server.url}?walk={step.rpartition('-')[0]}&step={step}")
        page.wait_for_function(CARD)
        return page

    return open_step


def show(page: Page) -> None:
    page.get_by_role("button", name="Show the answer", exact=True).click()
    page.wait_for_function(TAUGHT)


def arrived(page: Page, step: str) -> None:
    page.wait_for_function(f"oscillations.shown.state.step.endsWith('{step}') && {CARD}")
    expect(page.locator("h1.waits")).to_have_count(1)


def doubled(page: Page) -> float:
    """Twice the period of this visitor's spring with 1 kg."""
    page.wait_for_function("oscillations.walks.walk.numbers && oscillations.walks.walk.card")
    return 4 * math.pi / math.sqrt(page.evaluate("oscillations.shown.settings.k.value"))


def test_a_choice_is_asked_answered_and_explained(walk: Walk) -> None:
    page = walk("d31-03")
    expect(page.locator("h1")).to_have_text("How long does one swing take?")
    assert page.evaluate("[oscillations.clock.playing, oscillations.clock.t]") == [False, 0]
    expect(page.locator(".transport")).to_have_attribute("inert", "")
    page.get_by_role("button", name="Show the answer", exact=True).click()
    expect(page.locator(".card .problem")).to_have_text("Answer first: a guess is fine.")
    page.get_by_role("button", name=re.compile("Longer: the distance is longer")).click()
    expect(page.locator(".card .problem")).to_have_text("")
    page.evaluate("""oscillations.walks.walk.show(false)
      oscillations.messages.send({type: "set", values: {}})""")  # a picture on its way does not take the answer back
    page.wait_for_function(f"{QUIET} && {TAUGHT}")
    passed(page)
    expect(page.locator("h1")).to_have_text("Twice as far takes just as long")
    expect(page.locator(".answers [data-option='1']")).to_contain_text("That would be right at the same speed")
    expect(page.locator(".card .why")).to_contain_text("the same 1.00 s")
    assert page.locator(".card input[name=x_0]").input_value() == "0.200"
    assert page.locator(".panel [name=k]").is_hidden()
    page.get_by_role("button", name="Next", exact=True).click()
    arrived(page, "d31-04")
    assert page.evaluate("location.search") == "?walk=d31&step=d31-04"
    page.go_back()
    arrived(page, "d31-03")
    assert page.evaluate("location.search") == "?walk=d31&step=d31-03"


def test_answers_stay_in_the_browser_and_leaving_keeps_the_state_that_was_reached(walk: Walk) -> None:
    page = walk("d31-02")
    answer = f"{doubled(page):.2f}"
    page.get_by_label("Your answer").fill(answer)
    page.get_by_label("Your answer").press("Enter")
    page.wait_for_function(f"{TAUGHT} && oscillations.shown.settings.m.value === 4")
    page.reload()
    page.wait_for_function(CARD)
    page.locator(".walks summary").click()
    page.get_by_role("button", name="Leave the walk").click()
    expect(page.locator(".card")).to_have_count(0)
    expect(page.locator("h1")).to_have_text("A swing is a turning arrow, seen from the side")
    assert page.evaluate("oscillations.shown.settings.m.value") == 4
    expect(page.locator(".panel input[name=m]")).to_be_visible()
    page.keyboard.press("w")
    page.wait_for_function(f"{CARD} && {TAUGHT}")
    page.get_by_role("button", name="Contents", exact=True).first.click()
    row = page.locator(".contents li:has([aria-current])")
    expect(row).to_contain_text("Four times the mass, twice the period")
    expect(row).to_contain_text(f"your answer: {answer} s")
    with page.expect_download() as download:
        page.get_by_role("button", name="Save as text").click()
    text = download.value.path().read_text(encoding="utf-8")
    assert f"Your answer: {answer} s, right" in text and "How long does one swing take now?" in text
    page.get_by_role("button", name="Delete my answers").click()
    expect(row).not_to_contain_text("your answer")
    row.locator("+ li").get_by_role("button").click()
    arrived(page, "d31-03")


def test_a_point_is_marked_by_mouse_and_keys(walk: Walk) -> None:
    page = walk("d34-16")
    box = page.evaluate("""[oscillations.plots.find(({block}) => block.name === "swing")].map(plot => {
      const {left, top} = plot.host.getBoundingClientRect()
      return [left + plot.px(50), top + plot.py(0)]
    })[0]""")
    page.mouse.click(*box)
    expect(page.get_by_text(re.compile("Your mark: (50|49.9|50.1|50.0|49.[89]|50.[12]) "))).to_be_visible()
    mark = page.get_by_role("slider", name="Your mark")
    before = float(mark.get_attribute("aria-valuenow") or "nan")
    mark.press("ArrowRight")
    assert float(mark.get_attribute("aria-valuenow") or "nan") > before
    show(page)
    expect(page.locator(".card .reply")).to_contain_text("a drive at 50 rad/s")
    expect(page.locator(".line-mark.true")).to_have_count(1)


CLEAR = """() => {
  const mark = document.querySelector(".pill-mark"), own = mark.getBoundingClientRect()
  const others = [...mark.closest(".plot-area").querySelectorAll(".pill, .flag, text")]
    .map(part => part.getBoundingClientRect()).filter(({width}) => width)
  return others.length > 0 && !others.some(({left, right, top, bottom}) =>
    left < own.right - 1 && own.left < right - 1 && top < own.bottom - 1 && own.top < bottom - 1)
}"""
"""True if the visitor's mark covers no text of the plot."""


def test_a_mark_moves_off_what_comes_with_the_answer(walk: Walk) -> None:
    page = walk("d31-12")
    page.evaluate("oscillations.walks.walk.card.question.marker.setTo(24)")
    show(page)
    expect(page.locator(".line-mark.true")).to_have_count(1)
    page.wait_for_function(CLEAR)


@pytest.mark.parametrize("step", sample(["d31-12", "d34-08", "d34-16"], 3))
def test_a_point_and_its_question_share_the_first_screen_of_a_phone(walk: Walk, step: str) -> None:
    page = walk(step, 360, 740)
    for width, height in ((360, 740), PHONE):
        page.set_viewport_size({"width": width, "height": height})
        passed(page)
        places = page.evaluate(TOPS, [".nav", ".block.stage", ".pill-mark", ".card .asks", ".card .foot"])
        assert all(above[1] <= below[0] + 1 for above, below in pairwise(places)), places
        assert places[-1][1] <= height


def test_on_a_phone_an_answer_without_a_stage_on_top_begins_with_its_picture(walk: Walk) -> None:
    page = walk("d34-19", *PHONE)
    for step in ("d34-19", "d34-20", "d34-21"):
        arrived(page, step)
        page.evaluate("oscillations.walks.walk.show(true)")
        page.wait_for_function(TAUGHT)
        are_ordered = f"names => ({TOPS})(names).every(([top], i, all) => !i || top > all[i - 1][0])"
        page.wait_for_function(are_ordered, arg=[".block.plot", ".block.stage", ".transport", ".card"])
        page.evaluate("oscillations.walks.walk.next()")


def saddle(share: float) -> float:
    """Two resonances and a minimum between them that stays above zero."""
    s = 2.5 * share
    swing = abs((1 - s * s) / (s**4 - 3 * s * s + 1 + 1e-9))
    return min(max(swing, 0.9 if 0.7 < s < 1.6 else 0.0) / 5, 1.02)


def test_a_sketch_is_judged_by_its_features(walk: Walk) -> None:
    page = walk("d34-14")
    draw(page, lambda x: 0.5 + 2 * math.sin(9 * x), 120)
    heights = page.evaluate("oscillations.walks.walk.card.question.pad.sent.Xp1")
    assert min(heights) >= 0 and max(heights) <= 1000, "it stays in its plot"
    draw(page, saddle, 120)
    show(page)
    rows, judged = page.locator(".findings li"), page.locator(".findings .judged")
    verdicts = ["right", "right", "wrong", "right", "right"]
    for _ in range(2):
        expect(rows).to_have_count(5)
        assert [row.get_attribute("aria-label") for row in judged.all()] == verdicts
        expect(rows.nth(2)).to_contain_text("missed")
        expect(page.locator(".card .reply")).to_contain_text("with friction")
        expect(page.locator(".strokes .judged")).to_have_count(5)
        page.reload()  # a question that was drawn is not asked again
    page.get_by_role("button", name="Draw again").click()
    page.wait_for_function("oscillations.shown.state.covered.length")
    expect(page.locator(".strokes .old")).to_have_count(1)


UNDER_NAME = """() => {
  const flag = [...document.querySelectorAll(".plot-area .flag")].find(flag => flag.checkVisibility())
  flag.scrollIntoView({block: "center"})
  const {left, top, width, height} = flag.getBoundingClientRect()
  const found = document.elementsFromPoint(left + width / 2, top + height - 3)
  return found.findIndex(one => flag.contains(one)) < found.findIndex(one => one.closest(".drawing"))
}"""


def test_a_finger_draws_and_nothing_scrolls(walk: Walk) -> None:
    page = walk("d34-14", *PHONE, has_touch=True, is_mobile=True)
    page.evaluate("oscillations.walks.walk.card.question.plot.host.scrollIntoView({block: 'center'})")
    page.get_by_role("button", name="Show the answer", exact=True).tap()
    assert page.evaluate("""(problem => {
      const {left, top, height} = problem.getBoundingClientRect()
      return document.elementFromPoint(left + 20, top + height / 2) === problem
    })(document.querySelector(".card .problem"))"""), "why it is not shown yet is out of sight"
    scrolled = page.evaluate("scrollY")
    left, top, wide, high = page.evaluate(FRAME)
    finger = Finger(page)
    finger.down(left + 0.1 * wide, top + 0.9 * high)
    for i in range(1, 21):
        finger.move(left + wide * (0.1 + 0.04 * i), top + high * (0.9 - 0.035 * i))
    finger.up()
    drawn = page.evaluate("oscillations.walks.walk.card.question.given().curves.Xp1.filter(height => height !== null)")
    assert len(drawn) > 70 and drawn[-1] > drawn[0]
    assert page.evaluate("scrollY") == scrolled
    page.evaluate("oscillations.walks.walk.show(true)")
    page.wait_for_function(TAUGHT)
    page.add_style_tag(content="* { pointer-events: auto !important }")
    assert page.evaluate(UNDER_NAME), "names over a plot are above the own curve"


def test_a_sketch_can_be_drawn_by_keys(walk: Walk) -> None:
    page = walk("d31-15")
    pad = page.get_by_role("application")
    pad.press("Enter")
    for key in ["Shift+ArrowRight"] * 20:
        pad.press(key)
    expect(page.get_by_role("status").filter(has_text="Pen at")).to_contain_text("down")
    drawn = page.evaluate("oscillations.walks.walk.card.question.given().curves.h")
    assert len(drawn) == 101 and None not in drawn
    show(page)
    expect(page.locator(".findings li")).to_have_count(4)


def test_the_core_of_a_walk_is_a_shorter_one(walk: Walk) -> None:
    page = walk("d34-02")
    page.get_by_role("button", name="Contents", exact=True).click()
    core = page.get_by_role("button", name="Core steps only: 6, 16 minutes")
    core.click()
    expect(core).to_have_attribute("aria-pressed", "true")
    expect(page.locator(".contents li:has([aria-current])")).to_contain_text("2")
    page.get_by_role("dialog").get_by_role("button", name="Close").click()
    page.evaluate("oscillations.walks.walk.next()")
    arrived(page, "d34-08")
    expect(page.locator(".card-head")).to_contain_text("2 of 6")
    page.evaluate("oscillations.walks.walk.go(15)")
    arrived(page, "d34-16")
    page.evaluate("oscillations.walks.walk.next()")
    expect(page.locator(".contents .end li")).to_have_count(5)


def test_a_phone_has_a_key_for_the_sign(walk: Walk) -> None:
    page = walk("d34-01", *PHONE, has_touch=True, is_mobile=True)
    field = page.get_by_label("Your answer")
    field.fill("4")
    page.get_by_role("button", name="Change the sign").click()
    expect(field).to_have_value("−4")
    show(page)
    expect(page.get_by_role("img", name="right")).to_be_visible()


def test_the_first_visit_offers_the_tour_and_names_the_lectures(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="coupled")
    offer = page.locator("a.new-here")
    expect(offer).to_be_visible()
    page.locator(".walks summary").click()
    expect(page.locator(".walks p")).to_contain_text("D31 to D34 are lectures of the MIT course 16.07, Dynamics")
    page.keyboard.press("p")
    expect(offer).to_be_hidden()
    page.keyboard.press("p")
    offer.click()
    page.wait_for_function("oscillations.walks.walk?.step?.id === 'tour-01'")
    expect(offer).to_be_hidden()
    open_scene(page, scene="coupled")
    expect(offer).to_be_hidden()


def test_a_covered_curve_has_no_dot_where_it_begins(walk: Walk) -> None:
    """Its motion on the stage is at rest."""
    page = walk("d31-09")
    page.evaluate("oscillations.change(() => ({show: ['stage', 'plot:energy', 'plot:well']}))")
    expect(page.locator(".cover:visible")).to_have_count(1)
    expect(page.locator(".cover > :visible")).to_have_count(0)  # the wash alone
    bar = page.locator(".block.stage .body:visible")
    expect(bar).to_have_count(0)  # it would show which of both begins at its maximum
    shown = """oscillations.page.plots.find(plot => plot.block.name === "energy")
      .dots.filter(({curve}) => "TV".includes(curve.y)).map(({dot}) => dot.style.display !== "none")"""
    assert page.evaluate(shown) == [False, False]
    page.evaluate("oscillations.change(() => ({covered: []}))")
    page.wait_for_function(f"!oscillations.shown.state.covered.length && {shown}.every(Boolean)")
    expect(bar).not_to_have_count(0)


SEEN = """globalThis.frames_seen = []
const look = () => {
  const isThere = name => Boolean(document.querySelector(name)?.checkVisibility())
  const headline = document.querySelector("h1")?.textContent ?? ""
  const [stage, presets, card] = [".paper .mass", ".panel .chips button", ".card"].map(isThere)
  frames_seen.push({headline, stage, presets, card})
  requestAnimationFrame(look)
}
requestAnimationFrame(look)"""
"""Notes the contents of the page at each frame."""


@pytest.mark.parametrize("step", sample(["d31-02", "d34-02"], 3))
def test_a_link_to_a_step_never_shows_the_scene_alone(walk: Walk, step: str) -> None:
    """The first one waits for the visitor's own numbers: its stage is visible before its card."""
    page = walk(step, init=SEEN)
    page.wait_for_function("oscillations.walks.walk?.card && oscillations.connection.wire")
    seen = page.evaluate("frames_seen")
    headlines = {scene.headline for scene in SCENES.values()}
    assert any(one["card"] for one in seen)
    assert not [one for one in seen if one["presets"] or one["headline"] in headlines]
    assert not [one for one in seen if one["stage"] and not one["card"] and step != "d31-02"]
