"""A visitor's own walk: from a file that is chosen or dropped, and from questions that are written on the page."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import FilePayload, Locator, Page, expect

from components.scenes import SCENES
from components.walks.checking import problems
from components.walks.loading import load_walk
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.point import PointStep
from components.walks.questions.sketch import SketchStep
from components.walks.walk import Walk
from tests.browser.classroom import tap
from tests.browser.engines import stroke
from tests.browser.fixtures import READY
from tests.browser.waiting import clicked, drop

pytestmark = pytest.mark.browser
COVERED = {"plot:x2", "value:omega_minus", "form:beat"}
MINE = 'title = "Mine"\n[[step]]\nid = "one"\nfrom = "d31-03"\n'
DRAWN = """(() => {
  const {x, y} = oscillations.plots.find(({block}) => block.name === "x1")
  const {t, x1} = oscillations.shown.view.columns.time
  return Array.from(t, (at, i) => [(at - x.start) / (x.end - x.start), (x1[i] - y.start) / (y.end - y.start)])
})()"""
"""The curve of mass 1, in shares of its frame."""
PLACES = """drawn => {
  const {plot: {host, frame}} = oscillations.walks.walk.card.question.pad
  const {left, top} = host.getBoundingClientRect()
  const places = drawn.map(([x, y]) => [left + frame.left + x * frame.width, top + frame.top + (1 - y) * frame.height])
  return places.filter((_, i) => i % Math.ceil(places.length / 120) === 0)
}"""
REFUSED = {
    "big.toml": (b"#" * 48_001, "big.toml: the file has 48001 bytes; at most 48000 are allowed."),
    "cover.toml": (MINE.encode() + b'cover = ["plot:z"]', "step 1 (one), cover: “plot:z” is not possible: choose from"),
}


def chosen(page: Page, name: str, content: bytes) -> None:
    """The file, chosen from the menu."""
    page.locator(".walks summary").click()
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name="Open my own walk").click()
    chooser.value.set_files(FilePayload(name=name, mimeType="text/plain", buffer=content))


def test_a_file_is_run_or_refused_in_a_sentence(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="energy")
    for name, (content, said) in REFUSED.items():
        chosen(page, name, content)
        expect(page.locator(".notice span")).to_contain_text(said, timeout=30_000)  # a worker may be starting
    chosen(page, "here.toml", MINE.replace("d31-03", "d31-07").encode())  # a step of the visible scene
    page.wait_for_function(f"oscillations.walks.walk?.sheet.name === 'here' && {READY}")
    expect(page.locator(".notice")).to_be_hidden()
    drop(page, "My walk.toml", f"{MINE}#".ljust(48_000, "x"))  # the largest size
    page.wait_for_function(f"oscillations.walks.walk?.sheet.name === 'my-walk' && {READY}")
    expect(page.locator("h1")).to_have_text("How long does one swing take?")
    assert "walk=my-walk&step=one" in page.evaluate("location.search")
    page.reload()  # a clicker's start key
    page.wait_for_function(f"oscillations.walks.walk?.card && {READY}")
    expect(page.locator(".notice")).to_be_hidden()
    tap(page, 0)
    clicked(page)
    expect(page.locator("h1")).to_have_text("Twice as far takes just as long")
    page.get_by_role("button", name="Answer again").click()
    page.wait_for_function("oscillations.shown.state.covered.length && !oscillations.walks.walk.lesson")
    page.reload()
    page.wait_for_function(f"oscillations.walks.walk?.card && {READY}")
    assert page.evaluate("oscillations.walks.walk.lesson === null && !oscillations.walks.walk.card.question.given()")


def asked(page: Page, question: str, kind: str, **fields: str) -> None:
    """A step about the visible picture."""
    dialog = page.get_by_role("dialog", name="Write a question")
    dialog.locator("[name=question]").fill(question)
    dialog.locator("[name=kind]").select_option(kind)
    for name, value in {**fields, "title": "A claim", "explain": 'What it "means".'}.items():
        field = dialog.locator(f"[name={name}]")
        if name in ("curve", "axis"):
            field.select_option(value)
        else:
            field.fill(value)
    dialog.get_by_role("button", name="Add this question").click()


def ask_each_kind(page: Page) -> Locator:
    """A step of each kind, and the dialog in which it was written."""
    page.locator(".walks summary").click()
    page.get_by_role("button", name="Write a question on this picture").click()
    dialog = page.get_by_role("dialog", name="Write a question")
    for part in ("Displacement of mass 2 against time", "Number: slow mode", "Text: No beat"):
        dialog.get_by_label(part).check()
    choice = {"text-1": "Both", "text-2": "Neither", "notes": "Show the real springs first."}
    asked(page, "Which one swings?", "choice", **choice)
    expect(dialog.locator(".problem")).to_contain_text("a wrong answer needs a reply", timeout=30_000)
    dialog.get_by_label("The answers keep this order").check()
    dialog.locator("[name=reply-2]").fill("It is right at rest.")
    dialog.get_by_role("button", name="Add this question").click()
    expect(dialog.locator("li")).to_have_count(1)
    asked(page, "How long is {beat:null}?", "number", **{"is": "2500 ms", "unit": "s", "tol": "0,1"})
    expect(dialog.locator("li")).to_have_count(2)
    asked(page, "Sketch mass 1.", "sketch", curve="x1.x1", **{"is-0": "x1_O"})
    expect(dialog.locator(".problem")).to_contain_text("has a name that the scene does not have, x1_O; it has")
    asked(page, "Sketch mass 1.", "sketch", curve="x1.x1", **{"is-0": "x1_0"})
    expect(dialog.locator("li")).to_have_count(3)
    asked(page, "Mark where mass 2 begins.", "point", axis="x2.y", of="x2_0 - 0.5", tol="0.1")
    expect(dialog.locator("li")).to_have_count(4)
    return dialog


def test_what_is_asked_is_a_walk_that_passes_its_checks_and_runs(
    page: Page, open_scene: Callable[..., Page], tmp_path: Path
) -> None:
    shown = {"hidden": "x1_slow", "frame.window": 40, "held.k2": 20}
    open_scene(page, scene="coupled", k2=3, cover="value:omega_plus", **shown)
    drawn = page.evaluate(DRAWN)
    dialog = ask_each_kind(page)
    with page.expect_download() as download:
        dialog.get_by_role("button", name="Save the walk as a file").click()
    file = tmp_path / download.value.suggested_filename
    download.value.save_as(file)
    walk = load_walk(file, {})
    assert not list(problems(walk, SCENES))
    covers = [COVERED, set(), {"plot:x1"}, set()]
    assert [{*step.cover} for step in walk.steps] == [{"value:omega_plus"} | more for more in covers]
    assert walk.steps[0].state == "?scene=coupled&hidden=x1_slow&k2=3&view=motion&frame.window=40&held.k2=20"
    assert isinstance(walk.steps[2], SketchStep)
    assert isinstance(walk.steps[3], PointStep) and walk.steps[3].answer.unit == "m"
    assert walk.steps[3].answer.quantities == ("x2_0 - 0.5",) and not walk.steps[3].answer.numbers
    assert isinstance(walk.steps[0], ChoiceStep) and walk.steps[0].fixed
    assert [step.notes for step in walk.steps] == ["Show the real springs first.", "", "", ""]
    dialog.get_by_role("button", name="Close").click()
    drop(page, file.name, file.read_text(encoding="utf-8"))
    answered(page, walk, drawn)


def answered(page: Page, walk: Walk, drawn: list[list[float]]) -> None:
    """Every step is asked in the picture on which it was written, and the right answer is right."""
    answers: tuple[Callable[[Page], None], ...] = (
        lambda page: tap(page, 0),
        lambda page: page.get_by_label("Your answer").fill("2.45"),
        lambda page: stroke(page, page.evaluate(PLACES, drawn)),
        point,
    )
    for place, answer in enumerate(answers):
        page.wait_for_function(f"place => oscillations.walks.walk?.place === place && {READY}", arg=place)
        page.wait_for_function("oscillations.walks.walk.card?.page === oscillations.page")
        expect(page.locator("h1")).to_have_text(walk.steps[place].question)
        hidden, held, window = page.evaluate(
            "[({hidden, held, frame: {window}}) => [hidden, held, window]][0](oscillations.shown.state)"
        )
        assert (hidden, held, window) == (["x1_slow"], {"k2": 20}, 40)
        answer(page)
        clicked(page)
        page.wait_for_function("oscillations.walks.walk.lesson && !oscillations.shown.state.covered.length")
        assert page.evaluate("oscillations.walks.walk.lesson.right") is True
        clicked(page)


def point(page: Page) -> None:
    mark = page.get_by_role("slider", name="Your mark")
    while float(mark.get_attribute("aria-valuenow") or "nan") > -0.45:
        mark.press("ArrowDown")


def test_a_hall_does_not_see_a_question_written(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="coupled", k2=3, projector="")
    page.locator(".walks summary").click()
    with page.expect_popup() as window:
        page.get_by_role("button", name="Write a question").click()
    desk = window.value
    expect(desk.get_by_role("dialog", name="Write a question")).to_be_visible()
    assert "k2=3" in desk.url and "projector" not in desk.url and "#ask" not in desk.url
    expect(page.get_by_role("dialog", name="Write a question")).to_have_count(0)
    desk.close()
