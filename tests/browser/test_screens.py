"""Every scene on every screen: nothing overlaps, is cut off, or is too small to read."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import pytest
from playwright.sync_api import Page

from components.scenes import SCENES
from components.state.page_state import fitted
from tests.browser.boxes import faults
from tests.browser.fixtures import READY
from tests.browser.targets import small_targets
from tests.browser.views import GRID, LINKS, SAMPLE
from tests.browser.waiting import passed, seek, turned
from tests.grids import WHOLE, spread
from tests.serving.server import Server

pytestmark = pytest.mark.browser
STAYING = """() => {
  scrollTo(0, 500)
  const staying = [...document.querySelectorAll(".paper *, .nav")].filter(one =>
    getComputedStyle(one).position === "sticky" && one.checkVisibility() && one.getBoundingClientRect().height)
  const heights = staying.map(one => one.getBoundingClientRect().height)
  scrollTo(0, 0)
  return heights.reduce((sum, height) => sum + height, 0) / innerHeight
}"""


SCROLLED = """(paper => paper.scrollHeight - paper.clientHeight -
  (paper.parentElement.querySelector(".notice")?.offsetHeight ?? 0))(document.querySelector(".paper"))"""
"""Pixels of the paper that are out of view; closing a notice gives its room back."""
PRESETS = [fitted(scene.at(values)).query for scene in SCENES.values() for values in scene.presets.values() if values]
BRAKED = fitted(SCENES["forced"](c1=0.4, c2=0.2, view="formulas").value).query
"""The longest equations."""
REFUSED = f"{fitted(SCENES['absorber'](damping='added', c=40.0).value).query}&unknown=1"
"""The longest words next to a stage, under a notice."""
BODE = fitted(SCENES["forced"](view="bode").value).query
"""The only view with numbers at vertical axes that have no room beside each other."""
CASES = [(link, GRID if WHOLE else SAMPLE) for link in dict.fromkeys((*LINKS, BRAKED, REFUSED, BODE))] + [
    (link, (*SAMPLE, (390, 844), (3840, 2160))) for link in PRESETS if WHOLE and link not in LINKS
]
"""Links, and the sizes at which each is tested."""
DESK = (1250, 590)
NAMES_ON = """kinds => {
  const seen = one => one.checkVisibility() && one.getBoundingClientRect().width > 0
  const boxes = kind => [...document.querySelectorAll(`.block.stage:not(.still) svg.stage ${kind}`)].filter(seen)
  const meet = (one, other) => one.left < other.right + 3 && other.left < one.right + 3 &&
    one.top < other.bottom && other.top < one.bottom
  return boxes("text").flatMap(text => kinds.flatMap(boxes)
    .filter(part => part !== text && meet(text.getBoundingClientRect(), part.getBoundingClientRect()))
    .map(part => `${text.textContent} on ${part.getAttribute("class")}`))
}"""
"""Names on a stage that overlap parts of these kinds, or are less than 3 px next to them."""
CROSSED = """(({shapes, collisions}) => {
  const {parts: [shift]} = shapes.find(({group}) => group.textContent.includes("½"))
  const {left, right, top, bottom} = collisions.box(shift)
  const crossed = collisions.lines.filter(one =>
    one.left < right && one.right > left && one.top < bottom && one.bottom > top)
  return [collisions.lines.length > 99, crossed]
})(oscillations.page.stages.find(({under}) => under?.block.name === "well"))"""
"""True if the lines of the well are drawn, and the part of them under the name of a shift."""
LIFT = """(({host, frame}) => {
  const name = [...document.querySelectorAll(".stage text")].find(({textContent}) => textContent === "L")
  return name.getBoundingClientRect().left - host.getBoundingClientRect().left - frame.left
})(oscillations.plots.find(({block}) => block.name === "path"))"""
SQUEEZED = """[...document.querySelectorAll(".seg button")]
  .filter(one => one.checkVisibility() && one.scrollWidth > one.clientWidth + 1)
  .map(one => `cut in its button: ${one.textContent}`)"""
MISPLACED = """oscillations.plots.filter(({host}) => host.checkVisibility()).flatMap(plot => {
  const bare = text => text.replaceAll(" ", "")
  return [...plot.labels.scale.children].filter(number => !plot.y.ticks.some((tick, i) =>
    bare(plot.y.labels[i]) === bare(number.textContent) && Math.abs(number.getAttribute("y") - plot.py(tick)) < 5
  )).map(number => `not at its tick: ${number.textContent} of ${plot.block.name}`)
})"""
"""Numbers at vertical axes with other positions."""
SIDEWAYS = (844, 390)
PLAY_ENDS = "document.querySelector('.transport .play').getBoundingClientRect().bottom - innerHeight"


@pytest.mark.parametrize(("link", "sizes"), CASES, ids=[link for link, _ in CASES])
def test_nothing_overlaps_is_cut_or_too_small(
    link: str, sizes: Iterable[tuple[int, int]], page: Page, server: Server
) -> None:
    page.goto(f"{server.url}?{link}")
    page.wait_for_function(READY)
    found = [fault for width, height in sizes for fault in seen(page, width, height)]
    # Everything that is drawn follows the size of text in the browser.
    page.evaluate("document.documentElement.style.fontSize = '200%'")
    for width, height in ((1280, 720), (640, 900)) if WHOLE else ((1280, 720),):
        found += [f"text of 200 %, {fault}" for fault in seen(page, width, height)]
    assert not found, "\n".join(found)


def seen(page: Page, width: int, height: int) -> list[str]:
    """The faults in a window of this size."""
    page.set_viewport_size({"width": width, "height": height})
    passed(page)
    seek(page, 0.0)
    found = [*faults(page), *page.evaluate(SQUEEZED), *page.evaluate(MISPLACED)]
    if (covered := page.evaluate(STAYING)) > 0.45:
        found.append(f"what stays in sight covers {covered:.1%}")
    # On a desk the whole sheet is visible, with its handles.
    if width >= DESK[0] and height >= DESK[1] and (scrolled := page.evaluate(SCROLLED)) > 1:
        found.append(f"{scrolled} px of the sheet are out of sight")
    if (width, height) == SIDEWAYS and (cut := page.evaluate(PLAY_ENDS)) > 0:
        found.append(f"{cut} px of Play are out of sight")
    return [f"{width} x {height}: {fault}" for fault in found]


@pytest.mark.parametrize("slug", spread([*SCENES]))
def test_a_finger_hits_what_it_aims_at(
    slug: str, new_page: Callable[..., Page], open_scene: Callable[..., Page]
) -> None:
    finger = open_scene(new_page(390, 844, has_touch=True, is_mobile=True), scene=slug)
    assert small_targets(finger, 44) == []
    finger.set_viewport_size({"width": 1280, "height": 720})
    passed(finger)
    assert small_targets(finger, 44) == []
    assert small_targets(open_scene(new_page(1280, 590), scene=slug), 24) == []


def test_in_a_low_window_the_bar_goes_under_the_stage(
    new_page: Callable[..., Page], open_scene: Callable[..., Page]
) -> None:
    """Where the stage stays visible: on a phone held sideways it is next to the plots."""
    page = open_scene(new_page(1280, 720), scene="analogues")
    page.evaluate("document.documentElement.style.fontSize = '200%'")
    passed(page)
    page.evaluate("scrollBy(0, document.querySelector('.transport').getBoundingClientRect().top - 60)")
    passed(page)
    assert page.evaluate("""() => {
      const {x, y, width, height} = document.querySelector(".transport .play").getBoundingClientRect()
      const [over] = document.elementsFromPoint(x + width / 2, y + height / 2)
      return Boolean(over.closest(".block.stage")) && scrollY > 0
    }""")


def test_on_a_phone_no_number_of_a_table_is_out_of_sight(
    new_page: Callable[..., Page], open_scene: Callable[..., Page]
) -> None:
    page = open_scene(new_page(390, 844), scene="analogues", system="pipe")  # its formulas are the longest
    for width in (390, 320):
        page.set_viewport_size({"width": width, "height": 640})
        passed(page)
        assert page.evaluate("(table => table.scrollWidth - table.clientWidth)(document.querySelector('.roles'))") == 0
    assert page.locator(".roles").get_by_role("rowheader").count() == 7  # it is still a table


def test_on_a_low_phone_names_lie_on_no_bar(new_page: Callable[..., Page], open_scene: Callable[..., Page]) -> None:
    """With words under the stage, which is low then."""
    page = open_scene(new_page(320, 568), scene="modes", view="hunt")
    assert page.locator(".transport .note").text_content()
    seek(page, 0.0)
    name, bar = page.evaluate("""(shapes => [
      shapes.find(one => one.matches("text") && one.textContent.startsWith("fast")),
      shapes.find(one => one.matches("line.thick")),
    ].map(one => one.getBoundingClientRect().top))(
      [...document.querySelectorAll("svg.stage *")].filter(one => one.getBoundingClientRect().width))""")
    assert name > bar + 2, "a line of 5 px"


@pytest.mark.parametrize(("width", "text"), [(320, "100%"), (390, "100%"), (390, "200%")])
def test_on_a_phone_names_lie_on_no_other_part(
    width: int, text: str, new_page: Callable[..., Page], open_scene: Callable[..., Page]
) -> None:
    jupiter = {"g": 24.8}  # it has the longest name
    page = open_scene(new_page(width, 568), scene="energy", view="motion", **jupiter)
    page.evaluate("size => { document.documentElement.style.fontSize = size }", text)
    passed(page)
    seek(page, 0.0)
    assert page.evaluate(NAMES_ON, [".spring"] if text == "200%" else ["line", ".spring"]) == []
    turned(page, "energy", {**jupiter, "view": "energy"})
    seek(page, 0.0)
    assert page.locator("svg.stage path.outline").is_visible()
    assert page.evaluate(NAMES_ON, ["text", ".spring", ".wall", "path.outline"]) == []  # the bar of the energy
    if (width, text) == (390, "100%"):
        turned(page, "energy", {"datum": "separate", "view": "well"})
        seek(page, 0.0)
        assert page.evaluate(CROSSED) == [True, []]  # the shift in its well
    turned(page, "driven", {})
    seek(page, 0.0)
    assert page.evaluate(NAMES_ON, ["text"]) == []
    assert [fault for fault in faults(page) if "cut" in fault] == []
    turned(page, "phugoid", {"excess": 0.1, "view": "lift"})
    seek(page, 0.0)
    assert page.evaluate(LIFT) > 0  # it is not cut off at the frame of the path
