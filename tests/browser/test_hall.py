"""The hall: every view, and every step led by a clicker, keys or touch, and with votes, is visible and large."""

from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from components.walks.loading import load_walks
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.number import NumberStep, NumericStep
from components.walks.questions.point import PointStep
from components.walks.questions.sketch import SketchStep
from components.walks.subject import Subject
from components.walks.walk import Step
from tests.browser.classroom import FILLED, FRAME, LED, joined, put, sent, taught
from tests.browser.fixtures import READY, Open
from tests.browser.looks import LAID, LOW, SCROLLED, TAUGHT, faults, in_hall
from tests.browser.waiting import MINE, Finger, clicked, drop, middle, passed, seek, stroke, turned, value
from tests.grids import WHOLE, sample
from tests.live_class.caller import call
from tests.serving.server import Server
from tests.walks.test_walking import answers
from tools.look import faults_of

pytestmark = pytest.mark.browser
WALKS = load_walks(())
NAMES = ["tour", "d31", "d32-33", "d34", "waves"]
SLOWER = [f"{name} {by}" for by in ("clicker", "keys", "touch") for name in NAMES if (name, by) != ("tour", "keys")]
LEADS = ["tour keys", *(pytest.param(led, marks=pytest.mark.slow) for led in sample(SLOWER, 5))]
HEIGHT = 720
WORST = {
    *("d31-02", "d31-07", "d31-09", "d34-02", "d34-05", "d34-06", "d34-09", "d34-10", "d34-16"),
    *("tour-04", "waves-05"),
}
"""The steps that need the most room of their kind."""
CROWDED = {"d34-01", "d34-08", "d34-10", "d34-12", "d34-14"}
"""A step of each kind whose question or answer needs much room next to the corner of a class."""
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
GIVEN = "given => { const {question} = oscillations.asked.card; question.restore(given); question.changed() }"
NAMED = """oscillations.walks.walk.step.controls.filter(name => {
  const part = document.querySelector(`.card .borrowed :is([name="${name}"], [data-name="${name}"])`)
  return !part?.checkVisibility()
}).map(name => `${name} is not on the card`)"""
FREE = """[...document.querySelectorAll(".paper :is(.choice, [data-grab])")].filter(part => {
  const sets = part.getAttribute("data-grab")?.split(" ") ?? []
  return part.checkVisibility() && !part.inert && !oscillations.walks.walk.step.controls.some(one => sets.includes(one))
}).map(part => `sets values outside the step: ${part.outerHTML}`)"""
MISSING = """[...document.querySelectorAll(".card .why, .card .why [data-value]")].map(part => part.textContent.trim())
  .filter(text => !text || text.includes("?")).map(text => `a number is missing: ${text}`)"""
SKETCHED = """[oscillations.walks.walk.card.question.plot].map(({frame, unit, host}) => {
  const names = [...document.querySelectorAll(".votes .chip")].map(chip => chip.textContent)
  const corner = document.querySelector(".class-corner").getBoundingClientRect()
  const isClear = host.getBoundingClientRect().top + frame.top * unit >= corner.bottom
  return frame.height * unit / innerHeight >= 0.5 && names.includes("Middle 50 %") && isClear
})[0]"""
"""True if sketches have half of the screen's height, a visible middle half, and are not covered by the corner."""
VOTERS = 57
PHONES = ((390, 844), (844, 390))
FITS = ((853, 480), (1280, 720))
SIZES = (*FITS, (1920, 1080), (1024, 768))
UNDER = """oscillations.plots.filter(({host}) => host.checkVisibility())
  .map(({figure: {model}}) => model?.below[0].major_label_text_font_size).filter(Boolean)"""
UNIT = "parseFloat(getComputedStyle(document.documentElement).fontSize) / 16"


def wordiest(step: Step) -> int | str:
    """The answer with the longest reply, to a question with options or numbers."""
    if isinstance(step, ChoiceStep):
        return max(range(len(step.options)), key=lambda i: len(step.options[i].reply))
    if not isinstance(step, NumericStep) or not step.misses:
        return "2"
    longest = max(range(len(step.misses)), key=lambda i: len(step.misses[i].reply))
    return f"{step.wrong(Subject('', step, SCENES))[longest]:.3g}"


def answered(page: Page, step: Step, by: str) -> None:
    """Answer with keys or a finger."""
    if isinstance(step, ChoiceStep) and by == "touch":
        page.locator(f".answers [data-option='{wordiest(step)}']").tap()
    elif isinstance(step, ChoiceStep):
        names = page.locator(".answers [data-option]").evaluate_all("all => all.map(one => one.dataset.option)")
        page.keyboard.press(f"{names.index(str(wordiest(step))) + 1}")
    elif isinstance(step, NumberStep):
        page.get_by_role("textbox", name="Your answer").fill(str(wordiest(step)))
    elif by == "touch":
        frame = FRAME.replace(".pad", ".marker") if isinstance(step, PointStep) else FRAME
        left, top, width, height = page.evaluate(frame)
        stroke(Finger(page), [(left + share * width, top + share * height) for share in (0.3, 0.5, 0.7)])
    elif isinstance(step, PointStep):
        page.locator(".pill-mark").press("ArrowRight")
    else:
        for key in ("Enter", *["Shift+ArrowRight"] * 9):
            page.get_by_role("application").press(key)


def onward(page: Page, by: str) -> None:
    if by == "clicker":
        clicked(page)
    elif by == "touch":
        page.locator(FILLED).tap()
    else:
        page.locator(FILLED).press("Enter")


def forward(page: Page, step: Step, by: str) -> None:
    """Show the answer to a question, after an answer if keys or fingers lead."""
    if by != "clicker":
        answered(page, step, by)
    if by != "keys":
        return onward(page, by)
    page.evaluate("document.activeElement.blur()")
    return page.keyboard.press("r")


def explained(page: Page, step: Step, by: str) -> Iterator[str]:
    """Faults of headline, explanation, and with `derive` of the formulas; the next press continues."""
    passed(page)
    yield from page.evaluate(HIDDEN, ["h1", ".card .why"])
    yield from page.evaluate(MISSING)
    if step.derive:
        onward(page, by)
        passed(page)
        yield from page.evaluate(HIDDEN, [".card .follows .lines"])


def with_room(page: Page, step: Step, by: str) -> Iterator[str]:
    """Faults of a step in all that it shows."""
    yield from (f"question: {fault}" for fault in faults_of(page, HEIGHT))
    forward(page, step, by)
    page.wait_for_function(TAUGHT)
    yield from (f"answer: {fault}" for fault in faults_of(page, HEIGHT))
    if step.id not in WORST:
        return
    if step.follows:
        page.evaluate(UNFOLD, True)
        yield from in_hall(page, HEIGHT, "how it follows")
        page.evaluate(UNFOLD, False)
    opener = page.get_by_role("button", name="Try", exact=True)
    opener.click()
    yield from in_hall(page, HEIGHT, "trying")
    opener.click()


def on_a_desk_and_a_phone(page: Page) -> Iterator[str]:
    """The controls of a step are on its card, and no others can be used."""
    size = page.viewport_size
    page.keyboard.press("p")
    for width, height in ((1280, 720), (390, 844)):
        page.set_viewport_size({"width": width, "height": height})
        passed(page)
        if page.evaluate("document.documentElement.scrollWidth > innerWidth"):
            yield f"{width}: the page scrolls sideways"
        yield from page.evaluate(NAMED) + page.evaluate(FREE)
    assert size
    page.set_viewport_size(size)
    page.keyboard.press("p")


@pytest.mark.timeout(600)  # up to 21 steps
@pytest.mark.parametrize("led", LEADS)
def test_alone(led: str, server: Server, new_page: Open) -> None:
    name, by = led.split()
    page = new_page(1280, HEIGHT, has_touch=by == "touch")
    page.goto(f"{server.url}?walk={name}&projector")
    found: list[str] = []
    for step in WALKS[name].steps:
        page.wait_for_function(ASKED, arg=step.id)
        if by == "keys":
            found += [f"{step.id}: {fault}" for fault in with_room(page, step, by)]
        else:
            forward(page, step, by)
            page.wait_for_function(TAUGHT)
        found += [f"{step.id}: {fault}" for fault in explained(page, step, by)]
        if by == "clicker":
            found += [f"{step.id}: {fault}" for fault in on_a_desk_and_a_phone(page)]
        onward(page, by)
    expect(page.locator("dialog:is(.contents, .finish)")).to_be_visible()
    for key, is_over in (("PageDown", True), ("PageUp", False)) if led == "tour clicker" else ():
        clicked(page, key)
        expect(page.locator("dialog.finish")).to_be_visible(visible=is_over)
    assert not found, "\n".join(found)


@pytest.mark.timeout(600)  # up to 21 steps, on three pages
@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES if WHOLE else ["d34"])
def test_with_votes(name: str, server: Server, window: Open) -> None:
    lecture, code = taught(window, f"walk={name}&projector", 1280, HEIGHT)
    phones = [joined(window, code, *size) for size in PHONES]
    tokens = [call(server.url, f"/class/{code}/token", "POST").json["token"] for _ in range(VOTERS)]
    found: list[str] = []
    for place, step in enumerate(WALKS[name].steps):
        if not WHOLE and step.id not in CROWDED:
            continue
        lecture.evaluate("place => oscillations.walks.walk.go(place)", place)
        lecture.wait_for_function(ASKED, arg=step.id)
        found += in_hall(lecture, HEIGHT, f"{step.id}, before")
        put(step.id, lecture, *phones)  # then the class takes answers
        voted(server, code, name, step, tokens, phones)
        expect(lecture.locator(".votes [role=status]")).to_contain_text(f"{VOTERS + 1} ")
        clicked(lecture)
        lecture.wait_for_function(f"{LED}.votes.layer")
        found += in_hall(lecture, HEIGHT, f"{step.id}, with votes, before")
        assert not isinstance(step, SketchStep) or lecture.evaluate(SKETCHED), step.id
        clicked(lecture)
        lecture.wait_for_function(TAUGHT)
        found += in_hall(lecture, HEIGHT, f"{step.id}, with votes, after")
        for phone in phones:
            expect(phone.locator(".card .why")).to_be_attached()
        clicked(lecture)
        lecture.wait_for_function(f"!{LED}.votes.layer")
        found += in_hall(lecture, HEIGHT, f"{step.id}, explained, after")
        found += [f"{step.id}: {fault}" for fault in explained(lecture, step, "clicker")]
    assert not found, "\n".join(found)


def voted(server: Server, code: str, name: str, step: Step, tokens: list[str], phones: list[Page]) -> None:
    """All answer except the last phone."""
    given: list[dict[str, Any]] = answers(step, len(tokens))
    for token, answer in zip(tokens, given, strict=True):
        call(server.url, f"/class/{code}/now", word=token)  # a phone that polls is there
        made = call(server.url, f"/class/{code}/answer", "PUT", {"walk": name, "step": step.id, **answer}, token)
        assert made.status == 204, f"{step.id}: {made.text}"
    for phone, answer in zip(phones[:-1], given, strict=False):
        phone.evaluate(GIVEN, answer)
        sent(phone)


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
