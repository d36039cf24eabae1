"""A walk of one's own: from a file that is chosen or dropped, and from questions that are asked on the page."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest
from playwright.sync_api import FilePayload, Locator, Page, expect

from components.scenes import SCENES
from components.walks.checking import problems
from components.walks.loading import load_walk
from components.walks.types import PointStep
from tests.browser.dropping import drop
from tests.browser.fixtures import READY

pytestmark = pytest.mark.browser
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


def chosen(page: Page, name: str, content: bytes) -> None:
    """The file, chosen from the menu."""
    page.locator(".walks summary").click()
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name="A walk from a file").click()
    chooser.value.set_files(FilePayload(name=name, mimeType="text/plain", buffer=content))


def test_a_file_is_run_or_refused_in_a_sentence(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="energy")
    notice = page.locator(".notice span")
    for name, content, said in (
        ("big.toml", b"#" * 48_001, "big.toml: the file has 48001 bytes; 48000 are the most."),
        ("latin.toml", b'title = "\xe9"', "latin.toml: this is no UTF-8 text."),
        ("My notes.toml", b"hello", "My notes.toml: my-notes: this is not TOML"),
        ("cover.toml", MINE.encode() + b'cover = ["plot:z"]', "step 1 (one), cover: “plot:z” is nothing that"),
    ):
        chosen(page, name, content)
        expect(notice).to_contain_text(said)
    drop(page, "My walk.toml", f"{MINE}#".ljust(48_000, "x"))  # as large as may be
    page.wait_for_function(f"oscillations.walks.walk?.sheet.name === 'my-walk' && {READY}")
    expect(page.locator(".card .asks")).to_contain_text("How long does one swing take?")
    assert "walk=my-walk&step=one" in page.evaluate("location.search")
    page.reload()  # a clicker's start key
    page.wait_for_function(f"oscillations.walks.walk?.card && {READY}")
    expect(page.locator(".notice")).to_be_hidden()
    page.keyboard.press("1")
    page.keyboard.press("PageDown")
    expect(page.locator("h1")).to_have_text("Twice as far takes just as long")


def asked(page: Page, question: str, kind: str, **fields: str) -> None:
    """A step, asked of what is shown."""
    dialog = page.get_by_role("dialog", name="Ask")
    dialog.locator("[name=question]").fill(question)
    dialog.locator("[name=kind]").select_option(kind)
    for name, value in {**fields, "title": "A claim", "explain": 'What it "means".'}.items():
        field = dialog.locator(f"[name={name}]")
        if name in ("curve", "axis"):
            field.select_option(value)
        else:
            field.fill(value)
    dialog.get_by_role("button", name="Add this step").click()


def ask_each_kind(page: Page) -> Locator:
    """A step of each kind; the dialog in which they were asked."""
    page.locator(".walks summary").click()
    page.get_by_role("button", name="Ask about what is shown").click()
    dialog = page.get_by_role("dialog", name="Ask")
    dialog.get_by_label("Displacement of mass 2 against time").check()
    choice = {"text-1": "Both", "text-2": "Neither"}
    asked(page, "Which one swings?", "choice", **choice)
    expect(dialog.locator(".problem")).to_contain_text("a wrong answer has a sentence of its own")
    asked(page, "Which one swings?", "choice", **choice, **{"reply-2": "It is right at rest."})
    expect(dialog.locator("li")).to_have_count(1)
    asked(page, "How long does a beat take?", "number", **{"is": "2,5", "unit": "s", "tol": "0.1"})
    expect(dialog.locator("li")).to_have_count(2)
    asked(page, "Sketch mass 1.", "sketch", curve="x1.x1")
    expect(dialog.locator("li")).to_have_count(3)
    asked(page, "Mark where mass 2 begins.", "point", **{"axis": "x2.y", "is": "−0.5", "tol": "0.1"})
    expect(dialog.locator("li")).to_have_count(4)
    return dialog


def test_what_is_asked_is_a_walk_that_passes_its_checks_and_runs(
    page: Page, open_scene: Callable[..., Page], tmp_path: Path
) -> None:
    open_scene(page, scene="coupled", k2=3)
    drawn = page.evaluate(DRAWN)
    dialog = ask_each_kind(page)
    with page.expect_download() as download:
        dialog.get_by_role("button", name="Download the walk").click()
    file = tmp_path / download.value.suggested_filename
    download.value.save_as(file)
    walk = load_walk(file, {})
    assert not list(problems(walk, SCENES))
    assert [step.cover for step in walk.steps] == [("plot:x2",), (), ("plot:x1",), ()]
    assert walk.steps[0].state == "?scene=coupled&k2=3"
    assert isinstance(walk.steps[3], PointStep) and walk.steps[3].answer.unit == "m"
    dialog.get_by_role("button", name="Close").click()
    drop(page, file.name, file.read_text(encoding="utf-8"))
    for place, answer in enumerate((choose, number, partial(sketch, drawn), point)):
        page.wait_for_function(f"place => oscillations.walks.walk?.place === place && {READY}", arg=place)
        page.wait_for_function("oscillations.walks.walk.card?.page === oscillations.page")
        expect(page.locator(".card .asks")).to_have_text(walk.steps[place].question)
        answer(page)
        page.keyboard.press("PageDown")
        page.wait_for_function("oscillations.walks.walk.lesson && !oscillations.shown.state.covered.length")
        assert page.evaluate("oscillations.walks.walk.lesson.right") is True
        page.keyboard.press("PageDown")


def choose(page: Page) -> None:
    page.keyboard.press("1")


def number(page: Page) -> None:
    page.get_by_label("Your answer").fill("2.45")


def sketch(drawn: list[list[float]], page: Page) -> None:
    for i, place in enumerate(page.evaluate(PLACES, drawn)):
        page.mouse.move(*place)
        if not i:
            page.mouse.down()
    page.mouse.up()


def point(page: Page) -> None:
    mark = page.get_by_role("slider", name="Your mark")
    while float(mark.get_attribute("aria-valuenow") or "nan") > -0.45:
        mark.press("ArrowDown")
