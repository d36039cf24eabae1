"""The hall: large type in every view; every step of every walk, led by a clicker and with votes.
Nothing scrolls, is cut off or is too small, and each headline and each explanation is seen.
"""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from components.walks.loading import load_walks
from components.walks.walk import Step
from tests.browser.fixtures import READY
from tests.browser.looks import LAID, LOW, SCROLLED, TAUGHT, faults, in_hall
from tests.browser.touch import middle, value
from tests.browser.waiting import MINE, clicked, drop, passed, seek, turned
from tests.grids import sample
from tests.serving.server import Server
from tools.look import faults_of

pytestmark = pytest.mark.browser
WALKS = load_walks(())
NAMES = ["tour", "d31", "d32-33", "d34", "waves"]
LEADS = ["tour", *(pytest.param(name, marks=pytest.mark.slow) for name in sample(NAMES[1:]))]
HEIGHT = 720
WORST = {
    *("d31-02", "d31-07", "d31-09", "d34-02", "d34-05", "d34-06", "d34-09", "d34-10", "d34-16"),
    *("tour-04", "waves-05"),
}
"""The steps that need the most room of their kind."""
ASKED = f"id => oscillations.walks.walk?.step?.id === id && !oscillations.walks.walk.lesson && {LAID}"
UNFOLD = """open => {
  document.querySelector(".card .follows").open = open
  document.querySelector(".paper").style.visibility = open ? "hidden" : ""
}"""
"""The equations cover the paper."""
HIDDEN = """parts => {
  const words = html => Object.assign(document.createElement("p"), {innerHTML: html}).textContent
  const {lesson} = oscillations.walks.walk, heading = document.querySelector("h1")
  const claims = heading.textContent === words(lesson.title) ? [] : [`the headline is ${heading.textContent}`]
  return claims.concat(parts.filter(name => {
    const part = document.querySelector(name)
    if (!part?.checkVisibility({visibilityProperty: true, opacityProperty: true})) return true
    const {left, top, right, bottom} = part.getBoundingClientRect()
    const under = document.elementFromPoint((left + right) / 2, top + 4)
    return top < 0 || left < 0 || right > innerWidth || bottom > innerHeight || !part.contains(under)
  }).map(name => `${name} is not seen`))
}"""
"""Faults of the answer in the headline, and of parts of the card that are not completely visible."""
NAMED = """oscillations.walks.walk.step.controls.filter(name => {
  const part = document.querySelector(`.card .borrowed :is([name="${name}"], [data-name="${name}"])`)
  return !part?.checkVisibility()
}).map(name => `${name} is not on the card`)"""
FREE = """[...document.querySelectorAll(".paper :is(.choice, [data-grab])")].filter(part => {
  const sets = part.getAttribute("data-grab")?.split(" ") ?? []
  return part.checkVisibility() && !part.inert && !oscillations.walks.walk.step.controls.some(one => sets.includes(one))
}).map(part => `sets values outside the step: ${part.outerHTML}`)"""


def unfolded(page: Page, step: Step) -> Iterator[str]:
    """Faults of a step whose formulas or controls are unfolded."""
    if step.follows:
        page.evaluate(UNFOLD, True)
        yield from in_hall(page, HEIGHT, "how it follows")
        page.evaluate(UNFOLD, False)
    opener = page.get_by_role("button", name="Try", exact=True)
    opener.click()
    yield from in_hall(page, HEIGHT, "trying")
    opener.click()


@pytest.mark.timeout(600)  # up to 21 steps
@pytest.mark.parametrize("name", LEADS)
def test_a_clicker_leads_through_a_walk(name: str, server: Server, page: Page) -> None:
    """The controls of a step are on its card, and no others can be used."""
    page.goto(f"{server.url}?walk={name}&projector")
    found: list[str] = []
    for step in WALKS[name].steps:
        page.wait_for_function(ASKED, arg=step.id)
        found += [f"{step.id}, question: {fault}" for fault in faults_of(page, HEIGHT)]
        clicked(page)
        page.wait_for_function(TAUGHT)
        shown = [*faults_of(page, HEIGHT), *(unfolded(page, step) if step.id in WORST else [])]
        page.keyboard.press("p")
        shown += page.evaluate(NAMED) + page.evaluate(FREE)
        page.keyboard.press("p")
        passed(page)
        shown += page.evaluate(HIDDEN, ["h1", ".card .why"])
        clicked(page)
        if step.derive:
            passed(page)
            shown += page.evaluate(HIDDEN, [".card .follows .lines"])
            clicked(page)
        found += [f"{step.id}, answer: {fault}" for fault in shown]
    expect(page.locator("dialog:is(.contents, .finish)")).to_be_visible()
    for key, is_over in (("PageDown", True), ("PageUp", False)) if name == "tour" else ():
        clicked(page, key)
        expect(page.locator("dialog.finish")).to_be_visible(visible=is_over)
    assert not found, "\n".join(found)


FITS = ((853, 480), (1280, 720))
SIZES = (*FITS, (1920, 1080), (1024, 768))
UNDER = """oscillations.plots.filter(({host}) => host.checkVisibility())
  .map(({figure: {model}}) => model?.below[0].major_label_text_font_size).filter(Boolean)"""
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
    if (width, height) in FITS:
        yield from page.evaluate(SCROLLED) + page.evaluate(LOW, 59)
    under = {float(size[:-2]) for size in page.evaluate(UNDER)}
    yield from (f"an axis has type of {size}" for size in under if abs(size - 13 * unit) > 1e-3)


@pytest.mark.parametrize("slug", sample([*SCENES], 20))
def test_every_view_has_the_halls_type_and_fits(slug: str, server: Server, page: Page) -> None:
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
    drop(page, "mine.toml", MINE)
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


def test_the_hall_is_a_key_and_part_of_the_link(desk: Page) -> None:
    turned(desk, "forced", {"omega": 0.5})
    desk.keyboard.press("p")
    assert "&projector" in desk.evaluate("location.search")
    expect(desk.locator(".in-force")).to_contain_text("1.00 kg")
    panel = desk.locator(".panel > .tools")
    expect(panel).to_be_hidden()
    desk.get_by_role("button", name="Controls, key C").click()
    expect(panel).to_be_visible()
    desk.keyboard.press("c")
    expect(panel).to_be_hidden()
    seek(desk, 0.0)  # a moving mass is elsewhere when the mouse arrives
    grip = desk.locator(".grip").first
    grip.click(trial=True)  # nor does it move any more with the width that the panel has left
    before, (x, y) = value(desk, "x1_0"), middle(grip)
    desk.mouse.move(x, y)
    desk.mouse.down()
    desk.mouse.move(x + 60, y, steps=4)
    expect(desk.locator(".pointer")).to_be_visible()
    desk.mouse.up()
    expect(desk.locator(".pointer")).to_be_hidden()  # it rests
    desk.wait_for_function("before => oscillations.shown.settings.x1_0.value > before", arg=before)
    desk.keyboard.press("p")
    assert "projector" not in desk.evaluate("location.search")
    expect(panel).to_be_visible()
