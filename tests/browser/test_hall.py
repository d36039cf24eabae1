"""Hall mode: large type in every scene and in the walk, full screen, and a pointer that the last row can see."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, expect

from components.scenes import SCENES
from tests.browser.boxes import faults
from tests.browser.dropping import drop
from tests.browser.fixtures import READY
from tests.browser.waiting import passed, seek, turned
from tests.grids import spread
from tests.serving.server import Server

pytestmark = pytest.mark.browser
SCENE, STEP = (28, 22), (22, 19)
"""The smallest type on 1080 lines, and an index: in a scene, and in a step of a walk, next to its card."""
SIZES = ((1920, 1080), (1280, 720), (853, 480), (1024, 768))
LINES = """oscillations.plots.filter(({host}) => host.checkVisibility())
  .flatMap(({figure: {model}}) => (model?.renderers ?? []))
  .filter(({glyph}) => glyph.type === "Line").map(({glyph}) => glyph.line_width.value ?? glyph.line_width)"""
UNDER = """oscillations.plots.filter(({host}) => host.checkVisibility())
  .map(({figure: {model}}) => model?.below[0].major_label_text_font_size).filter(Boolean)"""
THIN = """[...document.querySelectorAll(".block.plot, .block.stage")].filter(part =>
  part.checkVisibility() && part.getBoundingClientRect().width < 20).map(part => part.className)"""
"""Plots and stages without room."""
BELOW = """(paper => {
  const bar = document.querySelector(".transport").getBoundingClientRect()
  const blocks = [...paper.querySelectorAll(".words, .table")]
  const words = blocks.map(block => block.getBoundingClientRect().bottom - bar.top)
  return Math.max(paper.scrollHeight - paper.clientHeight, ...words)
})(oscillations.page.paper)"""
"""Pixels of the sheet that are out of view, or of its words under the transport."""
UNFIT = """(() => {
  const {paper} = oscillations.page, bar = paper.querySelector(".transport").getBoundingClientRect()
  const frame = paper.getBoundingClientRect(), top = paper.querySelector(".views-head").getBoundingClientRect().bottom
  const low = oscillations.plots.filter(({host, frame}) => host.checkVisibility() && frame.height < 59)
  const kinds = ".stage, .plot, .words, .table, .choice, .modes, .measured"
  const seen = [...paper.querySelectorAll(`.block:is(${kinds})`)].filter(part => part.checkVisibility())
  const parts = seen.map(({className, innerText}) => `${className} ${(innerText ?? "").slice(0, 30)}`)
  const boxes = seen.map(part => part.getBoundingClientRect())
  const isCut = box => box.top < top - 1.5 || box.bottom > (bar.height ? bar.top : frame.bottom) + 1.5 ||
    box.left < frame.left - 1.5 || box.right > frame.right + 1.5
  const meet = (one, other) => one.left + 2 < other.right && other.left + 2 < one.right &&
    one.top + 2 < other.bottom && other.top + 2 < one.bottom
  return [
    ...(seen.length ? [] : ["nothing is shown"]),
    ...low.map(({block, frame}) => `the plot ${block.name} is ${frame.height} high`),
    ...parts.filter((_, i) => isCut(boxes[i])).map(part => `cut: ${part}`),
    ...parts.flatMap((part, i) => parts.slice(0, i).filter((_, j) => meet(boxes[i], boxes[j]))
      .map(other => `${part} meets ${other}`)),
  ]
})()"""
"""The faults of a view: plots lower than 60 px (one pixel of rounding is allowed), cut parts, parts that overlap."""
UNIT = "parseFloat(getComputedStyle(document.documentElement).fontSize) / 16"


def looked_at(page: Page, width: int, height: int, least: tuple[int, int] = SCENE) -> list[str]:
    """The faults of the page on this screen, on which no scene is smaller than on a desk."""
    lines, at_desk = min(height, width * 9 / 16), 1 if least == SCENE else 0.7
    page.set_viewport_size({"width": width, "height": height})
    passed(page)
    seek(page, 0.0)
    assert page.evaluate(UNIT) == pytest.approx(max(at_desk, least[0] / 13 * lines / 1080), rel=1e-5)
    found = faults(page, *(size * lines / 1080 for size in least))
    return [f"{width} x {height}: {fault}" for fault in found]


@pytest.mark.parametrize("third", spread(range(3)))
def test_every_scene_has_the_halls_type_and_nothing_overlaps(third: int, server: Server, page: Page) -> None:
    page.goto(f"{server.url}?scene=oscillator&projector")
    found = []
    views = [("modes", {"view": view}) for view in ("guess", "solve", "roots", "sweep")]
    every = [*((slug, {}) for slug in SCENES), *views, ("coupled", {"view": "formulas"})]
    for slug, given in every[third::3]:
        page.evaluate("([scene, parameters]) => oscillations.open({scene, parameters})", [slug, given])
        page.wait_for_function(f"slug => oscillations.page.spec.slug === slug && {READY}", arg=slug)
        page.wait_for_function(
            "given => Object.entries(given).every(([name, word]) => oscillations.shown.settings[name].value === word)",
            arg=given,
        )
        for width, height in SIZES:
            found += [f"{slug} {given}, {fault}" for fault in looked_at(page, width, height)]
            under = {round(float(size[:-2]), 3) for size in page.evaluate(UNDER)}
            lines = max(min(height, width * 9 / 16), 1080 * 13 / 28)
            assert under <= {round(28 * lines / 1080, 3)}, (slug, given, width, height)
            expected = [share * lines / 1080 for share in (6, 3.5, 1.5)]
            for line in page.evaluate(LINES):
                assert any(abs(line - one) < 0.01 for one in expected), (slug, line)
            low = page.evaluate(BELOW)
            assert low <= 1, (slug, height, low)
            across = page.evaluate("oscillations.page.paper.scrollWidth - oscillations.page.paper.clientWidth")
            thin = page.evaluate(THIN)
            assert across <= 1 and not thin, (slug, given, height, across, thin)
    assert not found, "\n".join(found)


ALWAYS = {"oscillator", "coupled", "phugoid"}
"""The scenes with the fullest views."""


@pytest.mark.parametrize(
    "slug", [pytest.param(slug, marks=() if slug in ALWAYS else pytest.mark.slow) for slug in SCENES]
)
def test_every_view_fits_with_plots_that_can_be_read(slug: str, server: Server, page: Page) -> None:
    page.goto(f"{server.url}?scene={slug}&projector")
    found = []
    for view in SCENES[slug].views:
        turned(page, slug, {"view": view.slug})
        for width, height in ((853, 480), (1280, 720)):
            seen = looked_at(page, width, height)
            seen += [f"{width} x {height}: {fault}" for fault in page.evaluate(UNFIT)]
            found += [f"{view.name}, {fault}" for fault in seen]
    assert not found, "\n".join(found)


def test_the_questions_stand_in_a_window_of_their_own_that_leads_the_hall(server: Server, page: Page) -> None:
    """With the questions of the instructor's own file, which only the hall's page knows."""
    page.goto(f"{server.url}?walk=d34&step=12&projector")
    page.wait_for_function(f"{READY} && document.querySelector('.card')")
    drop(page, "mine.toml", 'title = "Mine"\n[[step]]\nid = "pull"\nfrom = "d31-03"\n')
    page.wait_for_function("oscillations.walks.walk?.step?.id === 'pull' && document.querySelector('.card')")
    page.get_by_role("button", name="Contents", exact=True).first.click()
    assert "?" not in page.locator("dialog.contents").inner_text()  # the hall cannot read the questions
    with page.context.expect_page() as opened:
        page.get_by_role("button", name="Questions in a separate window").click()
    steps = opened.value.locator("dialog.contents")
    expect(steps.locator("section").first).to_contain_text("How long does one swing take?")
    expect(steps.locator("h2").first).to_contain_text("Mine")
    steps.get_by_role("button", name="after a very long time", exact=False).click()
    page.wait_for_function("oscillations.shown.state.step === 'd34/d34-12'")
    expect(page.locator("dialog.contents")).to_be_hidden()
    expect(steps).to_be_visible()


def test_the_hall_is_a_key_and_part_of_the_link(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="forced", omega=0.5)
    page.keyboard.press("p")
    assert "&projector" in page.evaluate("location.search")
    expect(page.locator(".in-force")).to_contain_text("1.00 kg")
    panel = page.locator(".panel > .tools")
    expect(panel).to_be_hidden()
    page.get_by_role("button", name="Controls, key C").click()
    expect(panel).to_be_visible()
    page.keyboard.press("c")
    expect(panel).to_be_hidden()
    seek(page, 0.0)  # a moving mass is elsewhere when the mouse arrives
    grip = page.locator(".grip").first
    grip.click(trial=True)  # nor does it move any more with the width that the panel has left
    box = grip.bounding_box()
    assert box
    before = page.evaluate("oscillations.shown.settings.x1_0.value")
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] / 2 + 60, box["y"] + box["height"] / 2, steps=4)
    expect(page.locator(".pointer")).to_be_visible()
    passed(page, 2)
    held = page.locator(".grip.held").bounding_box()
    assert held and abs(held["x"] - box["x"] - 60) < 2  # the hand is where the mouse is
    page.mouse.up()
    expect(page.locator(".pointer")).to_be_hidden()  # it rests
    plot = page.locator(".block.plot:visible").last.bounding_box()
    assert plot
    page.mouse.move(plot["x"] + plot["width"] / 2, plot["y"] + plot["height"] / 2)
    expect(page.locator(".pointer")).to_be_visible()
    expect(page.locator(".reading:visible")).to_have_count(1)
    expect(page.locator(".pointer")).to_be_hidden()
    expect(page.locator(".reading:visible")).to_have_count(0)
    page.wait_for_function("before => oscillations.shown.settings.x1_0.value > before", arg=before)
    page.keyboard.press("p")
    assert "projector" not in page.evaluate("location.search")
    expect(panel).to_be_visible()


def test_full_screen_comes_back_with_the_next_key(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="energy")
    page.keyboard.press("f")
    page.wait_for_function("document.fullscreenElement")
    page.evaluate("oscillations.open({scene: 'forced'})")
    page.wait_for_function(f"oscillations.page.spec.slug === 'forced' && {READY}")
    assert page.evaluate("Boolean(document.fullscreenElement)")
    page.reload()
    page.wait_for_function(READY)
    if page.evaluate("Boolean(document.fullscreenElement)"):
        return  # this browser keeps it
    expect(page.get_by_text("Press a key to go back to full screen.")).to_be_visible()
    page.keyboard.press("PageDown")
    page.wait_for_function("document.fullscreenElement")
    expect(page.locator(".offer")).to_have_count(0)


def test_a_walk_is_printed_with_space_for_answers_and_apart_from_it_the_answers(
    server: Server, new_page: Callable[..., Page]
) -> None:
    page = new_page(fresh=True)
    page.add_init_script("print = () => { globalThis.printed = true }")
    page.goto(f"{server.url}?walk=tour")
    page.wait_for_function(f"{READY} && document.querySelector('.card')")
    steps = printed(page, "Print a handout of this walk")
    expect(steps.locator(".boxes li").first).to_be_visible()
    assert steps.locator(".printed-pictures svg").count() >= 5
    boxes = page.locator(".printed-pictures svg").evaluate_all("all => all.map(one => one.viewBox.baseVal.width)")
    assert min(boxes) > 100  # a view that has just come has its place before it is drawn
    assert "?" not in "".join(steps.locator("svg").all_text_contents())  # what is hidden has left no trace
    assert min(page.evaluate(POINTS)) > 6.9
    page.emulate_media(media="screen")  # where they are as wide as on paper
    filled = page.evaluate(FILLED)
    assert 2 <= len(filled) <= 5 and min(filled) >= 0.6 and max(filled) <= 1, filled
    page.locator(".handout").evaluate("one => { one.remove = () => {} }")  # it is printed twice
    page.emulate_media(media="print")
    for paper in ("A4", "Letter"):
        assert re.findall(rb"/Count (\d+)", page.pdf(format=paper)) == [str(len(filled)).encode()], paper
    page.locator(".handout").evaluate("one => one.replaceWith()")
    page.emulate_media(media="screen")
    answers = printed(page, "Print the answers of this walk")
    expect(answers).to_contain_text("the same 1.00 s")
    assert "?" not in "".join(answers.locator(".why").all_inner_texts())
    assert page.evaluate("oscillations.walks.walk.answers.of('tour-01')") is None  # nothing was answered


FILLED = """[...document.querySelectorAll(".handout .sheet")].map(sheet => sheet.offsetHeight / 950)"""
"""The share of each printed page's height that its steps take."""
POINTS = """[...document.querySelectorAll(".handout svg text")].filter(one => one.textContent.trim()).map(one =>
  parseFloat(getComputedStyle(one).fontSize) * one.ownerSVGElement.getScreenCTM().a * 0.75)"""
"""The type of the labels on paper."""


def printed(page: Page, name: str) -> Locator:
    """The pages that a button prints, one article a step."""
    page.evaluate("globalThis.printed = false")
    page.locator(".walks summary").click()
    page.get_by_role("button", name=name).click()
    page.wait_for_function("globalThis.printed && oscillations.walks.walk.place === 0")
    page.emulate_media(media="print")
    pages = page.locator(".handout > section")
    expect(pages.locator("article")).to_have_count(5)
    return pages
