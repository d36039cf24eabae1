"""Guided walks in a browser: questions of each kind, stored answers, the tour on a phone, handouts on paper."""

import math
import re

import pytest
from playwright.sync_api import Locator, Page, expect

from components.scenes import SCENES
from components.walks.loading import load_walks
from components.walks.questions.choice import ChoiceStep
from tests.browser import looks
from tests.browser.classroom import FRAME, LED, draw, joined, sent, taught
from tests.browser.fixtures import CONNECTED, READY, Open
from tests.browser.waiting import QUIET, Finger, passed, stroke, tap
from tests.serving.server import Server

pytestmark = pytest.mark.browser
CARD = "document.documentElement.dataset.ready === 'true' && document.querySelector('.card')"
PHONE = (390, 844)
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
STEPS = [step for step in load_walks(())["tour"].steps if isinstance(step, ChoiceStep)]
AT = "id => oscillations?.walks?.walk?.step?.id === id && document.querySelector('.asked')"
BOTTOMS = """names => names.map(name => [...document.querySelectorAll(name)].filter(one => one.checkVisibility()).at(-1)
  .getBoundingClientRect().bottom)"""
QUESTION = [".asked-line", "h1", ".block:is(.stage, .plot)", ".answers button", ".foot"]
ANSWER = [".judgement", "h1", ".block.plot", ".transport", ".card .why", ".tries", ".answers"]
HOW = ("wrong", "right", "skipped", "right", "wrong")
STANDS = "JSON.stringify([oscillations.shown.state, oscillations.messages.number, oscillations.walks.walk.place])"
NEWS = "JSON.stringify([oscillations.news.picture, oscillations.news.question])"
FILLED = """[...document.querySelectorAll(".handout .sheet")].map(sheet => sheet.offsetHeight / 950)"""
"""The share of each printed page's height that its steps take."""


@pytest.fixture
def walk(server: Server, new_page: Open) -> Open:
    def open_step(step: str, *size: int, **options: bool) -> Page:
        page = new_page(*size, **options)
        page.goto(f"{server.url}?walk={step.rpartition('-')[0]}&step={step}")
        page.wait_for_function(CARD)
        return page

    return open_step


def show(page: Page) -> None:
    page.get_by_role("button", name="Show the answer", exact=True).click()
    page.wait_for_function(looks.TAUGHT)


def arrived(page: Page, step: str) -> None:
    page.wait_for_function(f"oscillations.shown.state.step.endsWith('{step}') && {CARD}")
    expect(page.locator("h1.waits")).to_have_count(1)


def test_a_choice_is_asked_answered_and_explained(walk: Open) -> None:
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
    page.wait_for_function(f"{QUIET} && {looks.TAUGHT}")
    passed(page)
    expect(page.locator("h1")).to_have_text("Twice as far takes just as long")
    expect(page.locator(".answers [data-option='1']")).to_contain_text("That would be right at the same speed")
    expect(page.locator(".card .why")).to_contain_text("the same 1.00 s")
    assert page.locator(".card input[name=x_0]").input_value() == "0.200"
    assert page.locator(".panel [name=k]").is_hidden()
    page.get_by_role("button", name="Next", exact=True).click()
    arrived(page, "d31-04")
    assert page.evaluate("location.search") == "?walk=d31&step=d31-04"
    expect(page.locator("#says-x")).to_have_text(re.compile("Covered until you press Show the answer.$"))
    page.go_back()
    arrived(page, "d31-03")
    assert page.evaluate("location.search") == "?walk=d31&step=d31-03"


def test_answers_stay_in_the_browser_and_leaving_keeps_the_state_that_was_reached(walk: Open) -> None:
    page = walk("d31-02")
    covered = page.evaluate("oscillations.shown.state.covered")
    page.keyboard.press("w")
    page.wait_for_function("!oscillations.shown.state.step")
    assert covered and page.evaluate("oscillations.shown.state.covered") == covered, "leaving answers nothing"
    page.keyboard.press("w")
    page.wait_for_function("oscillations.walks.walk.numbers && oscillations.walks.walk.card")
    k = page.evaluate("oscillations.shown.settings.k.value")  # this visitor's spring, with 1 kg
    expect(page.locator(".card .given").first).to_contain_text(f"{2 * math.pi / math.sqrt(k):.3g}"[:4])
    query = page.evaluate("location.search")
    assert query.startswith("?walk=d31&step=d31-02&seed=")
    answer = f"{4 * math.pi / math.sqrt(k):.2f}"
    page.get_by_label("Your answer").fill(answer)
    page.keyboard.press("Enter")
    page.wait_for_function(f"{looks.TAUGHT} && oscillations.shown.settings.m.value === 4")
    page.reload()
    page.wait_for_function(CARD)
    assert page.evaluate("[location.search, oscillations.shown.settings.k.value]") == [query, k], "they stay"
    page.locator(".walks summary").click()
    page.get_by_role("button", name="Leave the walk").click()
    expect(page.locator(".card")).to_have_count(0)
    expect(page.locator("h1")).to_have_text("A swing is a turning arrow, seen from the side")
    assert page.evaluate("oscillations.shown.settings.m.value") == 4
    expect(page.locator(".panel input[name=m]")).to_be_visible()
    page.keyboard.press("w")
    page.wait_for_function(f"{CARD} && {looks.TAUGHT}")
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


def test_a_point_is_marked_and_a_sketch_is_drawn_by_keys(walk: Open) -> None:
    page = walk("d34-16")
    at = page.evaluate("""[oscillations.plots.find(({block}) => block.name === "swing")].map(plot => {
      const {left, top} = plot.host.getBoundingClientRect()
      return [left + plot.px(50), top + plot.py(0)]
    })[0]""")
    page.mouse.click(*at)
    expect(page.get_by_text(re.compile("Your mark: (50|49.9|50.1|50.0|49.[89]|50.[12]) "))).to_be_visible()
    mark, now = page.get_by_role("slider", name="Your mark"), "mark => Number(mark.ariaValueNow)"
    before = mark.evaluate(now)
    mark.press("ArrowRight")
    assert mark.evaluate(now) > before
    show(page)
    expect(page.locator(".card .reply")).to_contain_text("a drive at 50 rad/s")
    expect(page.locator(".line-mark.true")).to_have_count(1)
    page = walk("d31-15")
    for key in ("Enter", *["Shift+ArrowRight"] * 20):
        page.get_by_role("application").press(key)
    expect(page.get_by_role("status").filter(has_text="Pen at")).to_contain_text("down")
    drawn = page.evaluate("oscillations.walks.walk.card.question.given().curves.h")
    assert len(drawn) == 101 and None not in drawn
    show(page)
    expect(page.locator(".findings li")).to_have_count(4)


def test_a_sketch_is_judged_by_its_features(walk: Open) -> None:
    page = walk("d34-14")
    draw(page, lambda x: 0.5 + 2 * math.sin(9 * x), 120)
    heights = page.evaluate("oscillations.walks.walk.card.question.pad.sent.Xp1")
    assert min(heights) >= 0 and max(heights) <= 1000, "it stays in its plot"
    show(page)
    rows, judged = page.locator(".findings li"), page.locator(".findings .judged")
    for _ in range(2):
        expect(rows).to_have_count(5)
        verdicts = [row.get_attribute("aria-label") for row in judged.all()]
        assert verdicts == ["wrong", "right", "wrong", "wrong", "wrong"]
        expect(rows.nth(2)).to_contain_text("missed")
        expect(page.locator(".strokes .judged")).to_have_count(5)
        page.reload()  # a question that was drawn is not asked again
    page.get_by_role("button", name="Draw again").click()
    page.wait_for_function("oscillations.shown.state.covered.length")
    expect(page.locator(".strokes .old")).to_have_count(1)


def test_a_phone_has_a_key_for_the_sign_and_a_finger_marks_and_draws(walk: Open) -> None:
    page = walk("d34-01", *PHONE, has_touch=True, is_mobile=True)
    assert looks.of(page, looks.ORDER, looks.FIELDS) == []
    field = page.get_by_label("Your answer")
    field.fill("4")
    page.get_by_role("button", name="Change the sign").click()
    expect(field).to_have_value("−4")
    show(page)
    expect(page.get_by_role("img", name="right")).to_be_visible()
    assert looks.of(page, looks.ORDER) == []
    page = walk("d31-12", *PHONE, has_touch=True, is_mobile=True)
    left, top, wide, high = page.evaluate(FRAME)
    stroke(Finger(page), [(left + share * wide, top + share * high) for share in (0.3, 0.5, 0.7)])
    expect(page.get_by_text("Your mark: ")).to_be_visible()
    page = walk("d34-14", *PHONE, has_touch=True, is_mobile=True)
    page.evaluate("oscillations.walks.walk.card.question.plot.host.scrollIntoView({block: 'center'})")
    page.get_by_role("button", name="Show the answer", exact=True).tap()
    assert page.evaluate("""(problem => {
      const {left, top, height} = problem.getBoundingClientRect()
      return document.elementFromPoint(left + 20, top + height / 2) === problem
    })(document.querySelector(".card .problem"))"""), "why it is not shown yet is out of sight"
    scrolled = page.evaluate("scrollY")
    left, top, wide, high = page.evaluate(FRAME)
    stroke(Finger(page), [(left + wide * (0.1 + 0.04 * i), top + high * (0.9 - 0.035 * i)) for i in range(21)])
    drawn = page.evaluate("oscillations.walks.walk.card.question.given().curves.Xp1.filter(height => height !== null)")
    assert len(drawn) > 70 and drawn[-1] > drawn[0]
    assert page.evaluate("scrollY") == scrolled


def test_a_step_is_seen_from_its_start_and_a_phone_held_sideways_has_room_to_draw(walk: Open) -> None:
    """After scrolling to the end, the verdict and then the next question are in sight."""
    page = walk("d34-03", 320, 568, has_touch=True)
    page.locator("[data-option='0']").tap()
    page.evaluate("scrollTo(0, 9999)")
    show(page)
    expect(page.locator(".judgement")).to_be_in_viewport()
    page.evaluate("scrollTo(0, 9999)")
    page.get_by_role("button", name="Next", exact=True).tap()
    arrived(page, "d34-04")
    expect(page.locator(".asks")).to_be_in_viewport()
    page = walk("d34-01", 844, 390, has_touch=True)
    page.get_by_label("Your answer").fill("2")
    show(page)
    expect(page.get_by_role("button", name="Change the sign")).to_be_hidden()
    assert [fault for fault in looks.faults(page) if "act filled" not in fault] == []
    page = walk("d34-10", 844, 390, has_touch=True)
    _, top, wide, high = page.evaluate(FRAME)
    assert wide > 390 and high > 75 and top + high < 390
    page.evaluate("oscillations.walks.walk.show(true)")
    page.wait_for_function(looks.TAUGHT)
    covered = page.evaluate("""(lines => {
      document.querySelector(".follows").open = true
      const {left, top, right, bottom} = lines.getBoundingClientRect()
      return [...Array(99).keys()].filter(i => !lines.contains(document.elementFromPoint(
        left + (right - left) * ((7 * i + 7) / 100 % 1), top + (bottom - top) * (i + 1) / 100))).length
    })(document.querySelector(".follows .lines"))""")
    assert covered == 0, "the picture lies over the formulas"
    page = walk("d34-19", 1280, 720)
    page.locator("[data-option='0']").click()
    show(page)
    assert looks.faults(page) == []


def test_a_link_to_a_step_never_shows_the_scene_alone(server: Server, new_page: Open) -> None:
    page = new_page()
    page.add_init_script(SEEN)
    page.goto(f"{server.url}?walk=d34&step=d34-02")
    page.wait_for_function("globalThis.oscillations?.walks?.walk?.card && oscillations.connection.wire")
    seen = page.evaluate("frames_seen")
    headlines = {scene.headline for scene in SCENES.values()}
    assert any(one["card"] for one in seen)
    assert not [one for one in seen if one["presets"] or one["headline"] in headlines]
    assert not [one for one in seen if one["stage"] and not one["card"]]


def test_the_core_of_a_walk_is_a_shorter_one(walk: Open) -> None:
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


def test_the_first_visit_offers_the_tour_and_names_the_lectures(page: Page, open_scene: Open) -> None:
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


def test_a_covered_curve_has_no_dot_and_no_bar_where_it_begins(walk: Open) -> None:
    """They would show which of both begins at its maximum."""
    page = walk("d31-09")
    page.evaluate("oscillations.change(() => ({show: ['stage', 'plot:energy', 'plot:well']}))")
    expect(page.locator(".cover:visible")).to_have_count(1)
    bar = page.locator(".block.stage .body:visible")
    expect(bar).to_have_count(0)
    shown = """oscillations.page.plots.find(plot => plot.block.name === "energy")
      .dots.filter(({curve}) => "TV".includes(curve.y)).map(({dot}) => dot.style.display !== "none")"""
    assert page.evaluate(shown) == [False, False]
    page.evaluate("oscillations.change(() => ({covered: []}))")
    page.wait_for_function(f"!oscillations.shown.state.covered.length && {shown}.every(Boolean)")
    expect(bar).not_to_have_count(0)


def asked(tour: Page, place: int) -> None:
    """All of a question is on the first screen of a phone, in the order in which it is read."""
    for width, height in ((320, 568), PHONE):
        tour.set_viewport_size({"width": width, "height": height})
        passed(tour)
        tour.wait_for_function(AT, arg=STEPS[place].id)
        expect(tour.locator(".answers button")).to_have_count(3)
        places = tour.evaluate(BOTTOMS, QUESTION)
        assert places == sorted(places) and places[-1] <= height, (STEPS[place].id, places)
        expect(tour.locator(".foot .ruler .here")).to_be_in_viewport(ratio=1)
    assert looks.of(tour, looks.ORDER) == []
    expect(tour.locator(".foot")).to_contain_text(f"{place + 1} of {len(STEPS)}")


def answered(tour: Page, step: ChoiceStep, how: str) -> None:
    """The answer says if it is right, then comes the picture."""
    i = next(i for i, option in enumerate(step.options) if option.right == (how == "right"))
    tour.locator(f".answers [data-option='{i}']").tap()
    tour.locator(".foot .filled", has_text="Show the answer").click()
    expect(tour.get_by_role("heading", level=1)).to_have_text(step.title)
    expect(tour.get_by_role("status").filter(has_text=f"Your answer is {how}.")).to_be_in_viewport(ratio=1)
    expect(tour.locator(f".answers [data-option='{i}'] .line")).to_have_text(step.options[i].reply.replace("*", ""))
    expect(tour.get_by_role("button", name="Skip")).to_have_count(0)
    places = tour.evaluate(BOTTOMS, ANSWER)
    assert places == sorted(places), (step.id, places)
    tour.locator(".foot .filled").click()


def test_a_student_walks_the_tour(walk: Open) -> None:
    """The last page counts the answers and names each step with its result."""
    tour = walk("tour-01", *PHONE, has_touch=True)
    for place, (step, how) in enumerate(zip(STEPS, HOW, strict=True)):
        asked(tour, place)
        forward = tour.locator(".foot .filled", has_text="Choose an answer")
        expect(forward).to_be_visible()
        if how != "skipped":
            answered(tour, step, how)
            continue
        forward.click()
        expect(tour.get_by_role("alert").filter(has_text="Answer first: a guess is fine.")).to_be_visible()
        tour.get_by_role("button", name="Skip").click()
    end = tour.get_by_role("dialog", name="Done")
    expect(end.locator("p")).to_contain_text("2 of your 4 answers were right.")
    for row, step, how in zip(end.locator(".results li").all(), STEPS, HOW, strict=True):
        said = step.question if how == "skipped" else step.title
        expect(row).to_contain_text(re.search(r"[^.]+$", said)[0].strip())
        expect(row).to_contain_text(how)
    expect(end.locator("a.scene-card svg")).to_have_count(3)
    expect(end.get_by_role("link", name="All scenes")).to_be_visible()
    end.get_by_role("button", name="Close").click()
    expect(end).to_be_hidden()
    tour.get_by_role("button", name="Finish").click()
    end.get_by_role("link", name="Calm a machine").click()
    tour.wait_for_function(f"{READY} && oscillations.page.spec.slug === 'absorber'")


def printed(page: Page, steps: int, name: str = "Print a handout of this walk") -> Locator:
    """The pages that a button prints, one article a step."""
    page.evaluate("() => { globalThis.print = () => {} }")
    page.locator(".walks summary").click()
    page.get_by_role("button", name=name).click()
    pages = page.locator(".handout")
    expect(pages.locator("article")).to_have_count(steps, timeout=60_000)
    page.evaluate("document.querySelector('.handout').remove = () => {}")  # it is printed several times
    return pages


@pytest.mark.slow  # it prints four times
def test_a_walk_is_printed_with_space_for_answers(server: Server, page: Page) -> None:
    page.goto(f"{server.url}?walk=tour")
    page.wait_for_function(f"{CONNECTED} && oscillations.walks.walk?.card")
    pages = printed(page, 5)
    expect(pages.locator(".boxes li").first).to_be_attached()
    boxes = page.locator(".printed-pictures svg").evaluate_all("all => all.map(one => one.viewBox.baseVal.width)")
    assert len(boxes) >= 5 and min(boxes) > 100  # a view that has just come has its place before it is drawn
    assert "?" not in "".join(pages.locator("svg").all_text_contents())  # what is hidden has left no trace
    filled = page.evaluate(FILLED)
    assert 2 <= len(filled) <= 5 and min(filled) >= 0.6 and max(filled) <= 1, filled
    page.emulate_media(media="print")
    for paper in ("A4", "Letter"):  # the tree of pages has several nodes, each with its number; the root has all
        assert max(map(int, re.findall(rb"/Count (\d+)", page.pdf(format=paper)))) == len(filled)
    page.locator(".handout").evaluate("one => one.replaceWith()")
    page.emulate_media(media="screen")
    answers = printed(page, 5, "Print the answers of this walk")
    expect(answers).to_contain_text("the same 1.00 s")
    assert "?" not in "".join(answers.locator(".why").all_text_contents())
    assert page.evaluate("oscillations.walks.walk.answers.of('tour-01')") is None  # nothing was answered


@pytest.mark.slow  # two windows of a class
def test_a_handout_that_is_printed_during_a_class_moves_nothing(window: Open) -> None:
    lecture, code = taught(window, "walk=tour&projector")
    phone = joined(window, code)
    tap(phone, 0)
    sent(phone)
    lecture.wait_for_function(f"{QUIET} && {LED}.votes.tally?.now.answered === 1")
    before, news = lecture.evaluate(STANDS), phone.evaluate(NEWS)
    orders: list[str] = []
    lecture.on("request", lambda request: orders.append(request.url) if request.url.endswith("/lead") else None)
    printed(lecture, 5)
    expect(lecture.locator("iframe, .offer")).to_have_count(0)
    assert lecture.evaluate(STANDS) == before and not orders
    assert phone.evaluate(NEWS) == news and lecture.evaluate(f"{LED}.news.here") == 1
