"""A guided walk in a browser: questions, answers by mouse and keys, sketches, contents, and stored answers."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from itertools import pairwise

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from tests.browser.halls import TAUGHT
from tests.browser.waiting import QUIET, passed, played
from tests.grids import spread
from tests.serving.server import Server

pytestmark = pytest.mark.browser
CARD = "document.documentElement.dataset.ready === 'true' && document.querySelector('.card')"
BLOCKED = "Object.defineProperty(window, 'localStorage', {get() { throw new DOMException('blocked') }})"


@pytest.fixture
def walk(server: Server, new_page: Callable[..., Page]) -> Callable[..., Page]:
    def open_step(step: str, init: str = "", **options: int | bool) -> Page:
        page = new_page(fresh=bool(init), **options)
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


def test_a_choice_is_asked_answered_and_explained(walk: Callable[..., Page]) -> None:
    page = walk("d31-03")
    expect(page.locator("h1")).to_have_text("How long does one swing take?")

    assert page.evaluate("[oscillations.clock.playing, oscillations.clock.t]") == [False, 0]
    expect(page.locator(".transport")).to_have_attribute("inert", "")
    assert page.locator(".panel [name=k]").is_hidden()
    page.get_by_role("button", name="Show the answer", exact=True).click()
    expect(page.locator(".card .problem")).to_have_text("Answer first: a guess is fine.")
    page.get_by_role("button", name=re.compile("Longer: the distance is longer")).click()
    expect(page.locator(".card .problem")).to_have_text("")
    show(page)
    expect(page.locator("h1")).to_have_text("Twice as far takes just as long")
    expect(page.locator(".answers [data-option='1']")).to_contain_text("That would be right at the same speed")
    expect(page.locator(".card .why")).to_contain_text("the same 1.00 s")
    assert page.locator(".card input[name=x_0]").input_value() == "0.200"
    assert page.locator(".panel [name=k]").is_hidden()
    assert page.evaluate("location.search") == "?walk=d31&step=d31-03"
    page.get_by_role("button", name="Next", exact=True).click()
    arrived(page, "d31-04")
    assert page.evaluate("location.search") == "?walk=d31&step=d31-04"
    page.go_back()
    arrived(page, "d31-03")


def test_a_picture_that_was_on_its_way_does_not_take_the_answer_back(walk: Callable[..., Page]) -> None:
    page = walk("d31-03")
    page.locator(".answers button").first.click()
    page.evaluate("""oscillations.walks.walk.show(false)
      oscillations.messages.send({type: "set", values: {}})""")
    page.wait_for_function(f"{QUIET} && !oscillations.shown.state.covered.length")
    passed(page)
    assert page.evaluate("oscillations.walks.walk.lesson !== null")


def test_leaving_keeps_the_state_that_was_reached(walk: Callable[..., Page]) -> None:
    page = walk("d31-02")
    page.get_by_label("Your answer").fill(f"{2 * doubled(page):.2f}")
    page.get_by_label("Your answer").press("Enter")
    page.wait_for_function("oscillations.walks.walk.lesson")
    expect(page.locator(".card .reply")).to_contain_text("it goes with the root of m")
    page.wait_for_function("oscillations.shown.settings.m.value === 4")
    page.locator(".walks summary").click()
    page.get_by_role("button", name="Leave the walk").click()
    expect(page.locator(".card")).to_have_count(0)
    expect(page.locator("h1")).to_have_text("A swing is a turning arrow, seen from the side")
    assert page.evaluate("oscillations.shown.settings.m.value") == 4
    expect(page.locator(".panel input[name=m]")).to_be_visible()


@pytest.mark.parametrize("init", ["", BLOCKED], ids=["kept", "storage blocked"])
def test_answers_stay_in_the_browser(walk: Callable[..., Page], init: str) -> None:
    page = walk("d31-02", init)
    answer = f"{doubled(page):.2f}"
    page.get_by_label("Your answer").fill(answer)
    show(page)
    if not init:
        page.reload()
        page.wait_for_function(CARD)
    page.get_by_role("button", name="Contents", exact=True).first.click()
    row = page.locator(".contents li:has([aria-current])")
    expect(row).to_contain_text("Four times the mass, twice the period")
    expect(row).to_contain_text(f"your answer: {answer} s")
    with page.expect_download() as download:
        page.get_by_role("button", name="Save as text").click()
    text = download.value.path().read_text(encoding="utf-8")
    assert f"Your answer: {answer} s, right" in text and "How long does one swing take now?" in text
    page.get_by_role("button", name="Delete my answers").click()
    expect(row).not_to_contain_text("you:")
    row.locator("+ li").get_by_role("button").click()
    arrived(page, "d31-03")


def test_a_point_is_marked_by_mouse_and_keys(walk: Callable[..., Page]) -> None:
    page = walk("d34-16")
    box = page.evaluate(
        "(() => { const p = oscillations.plots.find(p => p.block.name === 'swing');"
        " const b = p.host.getBoundingClientRect(); return [b.left + p.px(50), b.top + p.py(0)] })()"
    )
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


RARE = """() => {
  const real = requestAnimationFrame
  globalThis.requestAnimationFrame = act => setTimeout(() => real(act), 150)
}"""
"""A busy machine, which draws seven times a second."""


def test_a_mark_moves_off_what_comes_with_the_answer(walk: Callable[..., Page]) -> None:
    page = walk("d31-12")
    page.evaluate(RARE)
    page.evaluate("oscillations.walks.walk.card.question.marker.setTo(24)")
    show(page)
    expect(page.locator(".line-mark.true")).to_have_count(1)
    played(page, 3)
    assert page.evaluate(CLEAR)


@pytest.mark.parametrize("step", ["d31-12", "d34-08", "d34-16"])
def test_a_point_and_its_question_share_the_first_screen_of_a_phone(walk: Callable[..., Page], step: str) -> None:
    page = walk(step, width=360, height=740)
    for width, height in ((360, 740), (390, 844)):
        page.set_viewport_size({"width": width, "height": height})
        passed(page)
        expect(page.locator(".pill-mark")).to_be_visible()
        places = page.evaluate(
            "['.nav', '.block.stage', '.pill-mark', '.card .asks', '.card .foot'].map(name => {"
            " const part = [...document.querySelectorAll(name)].find(part => part.checkVisibility());"
            " const {top, bottom} = part.getBoundingClientRect(); return [top, bottom] })"
        )
        assert all(above[1] <= below[0] + 1 for above, below in pairwise(places)), places
        assert places[-1][1] <= height


def sketch(page: Page, height: Callable[[float], float], count: int = 120) -> None:
    """Draws over the pad: heights and positions as shares of the frame."""
    frame = page.evaluate(
        "(() => { const {plot} = oscillations.walks.walk.card.question.pad;"
        " const b = plot.host.getBoundingClientRect(), f = plot.frame;"
        " return [b.left + f.left, b.top + f.top, f.width, f.height] })()"
    )
    left, top, width, tall = frame
    for i in range(count + 1):
        share = i / count
        page.mouse.move(left + share * width, top + (1 - height(share)) * tall)
        if not i:
            page.mouse.down()
    page.mouse.up()


def test_a_sketch_is_judged_by_its_features(walk: Callable[..., Page]) -> None:
    page = walk("d34-14")

    def saddle(share: float) -> float:
        """Two resonances and a minimum between them that stays above zero."""
        s = 2.5 * share
        swing = abs((1 - s * s) / (s**4 - 3 * s * s + 1 + 1e-9))
        return min(max(swing, 0.9 if 0.7 < s < 1.6 else 0.0) / 5, 1.02)

    sketch(page, saddle)
    show(page)
    rows = page.locator(".findings li")
    expect(rows).to_have_count(5)
    assert [row.get_attribute("aria-label") for row in page.locator(".findings .judged").all()] == [
        "right", "right", "wrong", "right", "right"
    ]  # fmt: skip
    expect(rows.nth(2)).to_contain_text("missed")
    expect(page.locator(".card .reply")).to_contain_text("with friction")
    expect(page.locator(".strokes .judged")).to_have_count(5)
    page.reload()  # a question that was drawn is not asked again
    expect(rows).to_have_count(5)
    expect(rows.nth(2)).to_contain_text("missed")
    page.get_by_role("button", name="Draw again").click()
    page.wait_for_function("oscillations.shown.state.covered.length")
    expect(page.locator(".strokes .old")).to_have_count(1)


def test_a_finger_draws_and_nothing_scrolls(server: Server, new_page: Callable[..., Page]) -> None:
    page = new_page(width=390, height=844, has_touch=True, is_mobile=True)
    page.goto(f"{server.url}?walk=d34&step=d34-14")
    page.wait_for_function(CARD)
    page.evaluate("oscillations.walks.walk.card.question.plot.host.scrollIntoView({block: 'center'})")
    page.get_by_role("button", name="Show the answer", exact=True).tap()
    assert page.evaluate("""(problem => {
      const {left, top, height} = problem.getBoundingClientRect()
      return document.elementFromPoint(left + 20, top + height / 2) === problem
    })(document.querySelector(".card .problem"))"""), "why it is not shown yet is out of sight"
    scrolled = page.evaluate("scrollY")
    left, top, wide, high = page.evaluate(
        "(() => { const {layer} = oscillations.walks.walk.card.question.pad;"
        " const b = layer.getBoundingClientRect(); return [b.left, b.top, b.width, b.height] })()"
    )
    finger = page.context.new_cdp_session(page)
    for i in range(21):
        point = {"x": left + wide * (0.1 + 0.04 * i), "y": top + high * (0.9 - 0.035 * i)}
        kind = "touchMove" if i else "touchStart"
        finger.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [point]})
    finger.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    drawn = page.evaluate("oscillations.walks.walk.card.question.given().curves.Xp1.filter(height => height !== null)")
    assert len(drawn) > 70 and drawn[-1] > drawn[0]
    assert page.evaluate("scrollY") == scrolled


def test_a_sketch_can_be_drawn_by_keys(walk: Callable[..., Page]) -> None:
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


def test_two_curves_are_drawn_one_after_the_other(walk: Callable[..., Page]) -> None:
    page = walk("d31-09")
    sketch(page, lambda share: 0.45 * (1 + math.cos(12 * math.pi * share)))
    page.get_by_role("button", name="Draw T").click()
    sketch(page, lambda share: 0.45 * (1 - math.cos(12 * math.pi * share)))
    show(page)
    assert page.evaluate("oscillations.walks.walk.lesson.right") is True


def test_the_core_of_a_walk_is_a_shorter_one(walk: Callable[..., Page]) -> None:
    page = walk("d34-02")
    page.get_by_role("button", name="Contents", exact=True).click()
    core = page.get_by_role("button", name="Core steps only: 6, 16 minutes")
    core.click()
    expect(core).to_have_attribute("aria-pressed", "true")
    row = page.locator(".contents li:has([aria-current])")
    expect(row).to_contain_text("2")
    page.get_by_role("dialog").get_by_role("button", name="Close").click()
    page.evaluate("oscillations.walks.walk.next()")
    arrived(page, "d34-08")
    expect(page.locator(".card-head")).to_contain_text("2 of 6")
    page.evaluate("oscillations.walks.walk.go(15)")
    arrived(page, "d34-16")
    page.evaluate("oscillations.walks.walk.next()")
    expect(page.locator(".contents .end li")).to_have_count(5)


def test_a_phone_has_a_key_for_the_sign(walk: Callable[..., Page]) -> None:
    page = walk("d34-01", width=390, height=844, has_touch=True, is_mobile=True)
    field = page.get_by_label("Your answer")
    field.fill("4")
    sign = page.get_by_role("button", name="Change the sign")
    sign.click()
    expect(field).to_have_value("−4")
    show(page)
    expect(page.get_by_role("img", name="right")).to_be_visible()


def test_a_sketch_stays_in_its_plot(walk: Callable[..., Page]) -> None:
    page = walk("d31-15")
    sketch(page, lambda x: 0.5 + 2 * math.sin(9 * x))
    heights = page.evaluate("oscillations.walks.walk.card.question.pad.sent.h")
    assert min(heights) >= 0 and max(heights) <= 1000


NAMED = """oscillations.walks.walk.step.controls.filter(name => {
  const part = document.querySelector(`.card .borrowed :is([name="${name}"], [data-name="${name}"])`)
  return !part?.checkVisibility()
})"""
"""The controls that a step names and that are not on its card."""
FREE = """[...document.querySelectorAll(".paper :is(.choice, [data-grab])")].filter(part => {
  const sets = part.getAttribute("data-grab")?.split(" ") ?? []
  return part.checkVisibility() && !part.inert && !oscillations.walks.walk.step.controls.some(one => sets.includes(one))
}).map(part => part.outerHTML)"""
"""Controls that set values outside the step."""


def looked_at(page: Page) -> Iterator[str]:
    """On a desk and on a phone, where it stays."""
    for width, height in ((1280, 720), (390, 844)):
        page.set_viewport_size({"width": width, "height": height})
        passed(page)
        if page.evaluate("document.documentElement.scrollWidth > innerWidth"):
            yield f"{width}: the page scrolls sideways"
        yield from page.evaluate(NAMED) + page.evaluate(FREE)


def go(page: Page, place: int) -> None:
    """Opens a step of the current walk."""
    page.evaluate("place => oscillations.walks.walk.go(place)", place)
    page.wait_for_function(f"place => oscillations.walks.walk.place === place && {CARD}", arg=place)
    page.wait_for_function("oscillations.walks.walk.card.page === oscillations.page")


@pytest.mark.parametrize("name", spread(["tour", "d31", "d32-33", "d34", "waves"], 5))
def test_every_step_has_its_card(walk: Callable[..., Page], name: str) -> None:
    page = walk(f"{name}-01")
    for i in range(page.evaluate("oscillations.walks.walk.sheet.steps.length")):
        go(page, i)
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), i
        page.evaluate("oscillations.walks.walk.show(true)")
        page.wait_for_function(TAUGHT)
        assert page.locator(".card .why").inner_text().strip()
        assert "?" not in page.locator(".card .why").inner_text()
        numbers = page.locator(".card .why [data-value]").all_inner_texts()
        assert all(numbers), numbers
        assert [*looked_at(page)] == [], i


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


def test_a_covered_curve_has_no_dot_where_it_begins(walk: Callable[..., Page]) -> None:
    """Its motion on the stage is at rest."""
    page = walk("d31-09")
    page.evaluate("oscillations.change(() => ({show: ['stage', 'plot:energy', 'plot:well']}))")
    expect(page.locator(".cover:visible")).to_have_count(1)
    expect(page.locator(".cover > :visible")).to_have_count(0)  # the wash alone
    bar = page.locator(".block.stage .body:visible")
    expect(bar).to_have_count(0)  # it would show which of both begins at its maximum
    plot = "oscillations.page.plots.find(plot => plot.block.name === 'energy')"
    energies = f"{plot}.dots.filter(one => 'TV'.includes(one.curve.y))"
    shown = f"{energies}.map(({{dot}}) => dot.style.display !== 'none')"
    assert page.evaluate(shown) == [False, False]
    page.evaluate("oscillations.change(() => ({covered: []}))")
    page.wait_for_function("!oscillations.shown.state.covered.length")
    page.wait_for_function(f"{shown}.every(Boolean)")
    expect(bar).not_to_have_count(0)


def test_a_walk_that_is_left_leaves_no_dialog_and_no_listener(walk: Callable[..., Page]) -> None:
    page = walk("d31-03")
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable")

    def left() -> tuple[float, int]:
        page.evaluate("oscillations.walks.walk.open()")
        expect(page.locator("dialog.contents")).to_be_visible()
        page.evaluate("oscillations.walks.leave()")
        page.wait_for_function("!oscillations.walks.walk")
        dialogs = page.locator("dialog.contents").count()
        session.send("HeapProfiler.collectGarbage")
        metrics = session.send("Performance.getMetrics")["metrics"]
        page.evaluate("oscillations.walks.comeBack()")
        page.wait_for_function(f"oscillations.walks.walk?.card && {QUIET}")
        return next(one["value"] for one in metrics if one["name"] == "JSEventListeners"), dialogs

    found = [left() for _ in range(6)]
    session.detach()
    assert [dialogs for _, dialogs in found] == [0] * len(found)
    assert found[-1][0] - found[1][0] < len(found), "no listener for each walk"


SEEN = """globalThis.frames_seen = []
const look = () => {
  const [stage, presets] = [".paper .mass", ".panel .chips button"].map(one => document.querySelector(one))
  const isThere = one => Boolean(one?.checkVisibility())
  const headline = document.querySelector("h1")?.textContent ?? ""
  const card = isThere(document.querySelector(".card"))
  frames_seen.push({headline, stage: isThere(stage), presets: isThere(presets), card})
  requestAnimationFrame(look)
}
requestAnimationFrame(look)"""
"""Notes the contents of the page at each frame."""


@pytest.mark.parametrize("step", ["d34-02", "d31-02"])
def test_a_link_to_a_step_never_shows_the_scene_alone(new_page: Callable[..., Page], server: Server, step: str) -> None:
    """The second one waits for the visitor's own numbers: its stage is visible before its card."""
    page = new_page(fresh=True)
    page.add_init_script(SEEN)
    page.goto(f"{server.url}?walk={step[:3]}&step={step}")
    page.wait_for_function("oscillations.walks.walk?.card && oscillations.connection.wire")
    seen = page.evaluate("frames_seen")
    assert any(one["card"] for one in seen)
    assert not [one for one in seen if one["presets"]]
    assert not [one for one in seen if one["stage"] and not one["card"] and step != "d31-02"]
    headlines = {scene.headline for scene in SCENES.values()}
    assert not [one for one in seen if one["headline"] in headlines]


@pytest.mark.parametrize("step", ["d34-19", "d34-20", "d34-21"])
def test_on_a_phone_an_answer_without_a_stage_on_top_begins_with_its_picture(
    step: str, walk: Callable[..., Page]
) -> None:
    page = walk(step, width=390, height=844)
    page.evaluate("oscillations.walks.walk.show(true)")
    page.wait_for_function(TAUGHT)
    page.wait_for_function(
        """() => [".block.plot", ".block.stage", ".transport", ".card"]
          .map(kind => [...document.querySelectorAll(kind)].find(one => one.checkVisibility()))
          .map(one => one.getBoundingClientRect().top)
          .every((top, i, all) => !i || top > all[i - 1])"""
    )


def test_names_over_a_plot_are_above_the_own_curve(walk: Callable[..., Page]) -> None:
    page = walk("d34-14", width=390, height=844)
    pad = page.locator(".drawing")
    pad.scroll_into_view_if_needed()
    box = pad.bounding_box()
    assert box
    page.mouse.move(box["x"] + 15, box["y"] + 20)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] - 15, box["y"] + 20, steps=20)
    page.mouse.up()
    page.evaluate("oscillations.walks.walk.show(true)")
    page.wait_for_function(TAUGHT)
    page.add_style_tag(content="* { pointer-events: auto !important }")
    uppermost = """() => {
      const flag = [...document.querySelectorAll(".plot-area .flag")].find(flag => flag.checkVisibility())
      flag.scrollIntoView({block: "center"})
      const {left, top, width, height} = flag.getBoundingClientRect()
      const found = document.elementsFromPoint(left + width / 2, top + height - 3)
      return found.findIndex(one => flag.contains(one)) < found.findIndex(one => one.closest(".drawing"))
    }"""
    assert page.evaluate(uppermost)
