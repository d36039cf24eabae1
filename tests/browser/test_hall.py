"""Hall mode: large type in every scene and in the walk, full screen, and a pointer that the last row can see."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from tests.browser.boxes import faults
from tests.browser.dropping import drop
from tests.browser.fixtures import READY
from tests.browser.waiting import passed, seek, turned
from tests.grids import sample
from tests.serving.server import Server

pytestmark = pytest.mark.browser
FITS = ((853, 480), (1280, 720))
SIZES = (*FITS, (1920, 1080), (1024, 768))
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


def looked_at(page: Page, width: int, height: int) -> Iterator[str]:
    """The faults of the page on this screen, on which no scene is smaller than on a desk."""
    lines = min(height, width * 9 / 16)
    page.set_viewport_size({"width": width, "height": height})
    passed(page)
    seek(page, 0.0)
    unit = max(1, 28 / 13 * lines / 1080)
    assert page.evaluate(UNIT) == pytest.approx(unit, rel=1e-5)
    yield from faults(page, 28 * lines / 1080, 22 * lines / 1080)
    yield from page.evaluate(UNFIT) if (width, height) in FITS else []
    under = {float(size[:-2]) for size in page.evaluate(UNDER)}
    yield from (f"an axis has type of {size}" for size in under if abs(size - 13 * unit) > 1e-3)
    widths = [share * unit * 13 / 28 for share in (6, 3.5, 1.5)]
    lines_drawn = page.evaluate(LINES)
    yield from (f"a line is {line} wide" for line in lines_drawn if min(abs(line - one) for one in widths) > 0.01)
    low = page.evaluate(BELOW)
    across = page.evaluate("oscillations.page.paper.scrollWidth - oscillations.page.paper.clientWidth")
    if max(low, across) > 1:
        yield f"{low} px are below, {across} to the side"
    yield from (f"no room for {part}" for part in page.evaluate(THIN))


@pytest.mark.parametrize("slug", sample([*SCENES], 20))
def test_every_view_has_the_halls_type_and_fits_with_plots_that_can_be_read(
    slug: str, server: Server, page: Page
) -> None:
    page.goto(f"{server.url}?scene={slug}&projector")
    found = []
    for view in SCENES[slug].views:
        turned(page, slug, {"view": view.slug})
        for width, height in SIZES if view is SCENES[slug].views[0] else FITS:
            found += [f"{view.name}, {width} x {height}: {fault}" for fault in looked_at(page, width, height)]
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
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    before = page.evaluate("oscillations.shown.settings.x1_0.value")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y, steps=4)
    pointer = page.locator(".pointer")
    expect(pointer).to_be_visible()
    passed(page, 2)
    held = page.locator(".grip.held").bounding_box()
    assert held and abs(held["x"] - box["x"] - 60) < 2  # the hand is where the mouse is
    page.mouse.up()
    expect(pointer).to_be_hidden()  # it rests
    page.locator(".block.plot:visible").last.hover()
    reading = page.locator(".reading:visible")
    for count in (1, 0):
        expect(reading).to_have_count(count)
        expect(pointer).to_be_visible(visible=bool(count))
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
