"""One visitor's journey in Chromium, in Safari's engine and in Firefox."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import expect

from components.scenes import SCENES
from tests.browser.classroom import Open, taught
from tests.browser.engines import Window
from tests.browser.fixtures import READY
from tests.browser.hands import CONNECTED, click, drag, middle, opened, press, stroke
from tests.browser.waiting import PASSED, QUIET
from tests.serving.server import Server, free_port, serving

pytestmark = [pytest.mark.browser, pytest.mark.slow]
HEADLINE = "document.querySelector('h1').textContent"
ADDRESS = "decodeURIComponent(location.search)"
CARD = f"{CONNECTED} && oscillations.walks.walk?.card && {QUIET}"
LESSON = "document.querySelector('.card .why')"
SAVED = """() => {
  URL.createObjectURL = file => ((window.saved = {size: file.size}), "#")
  HTMLAnchorElement.prototype.click = function () { window.saved.name = this.download }
}"""
"""Notes a file instead of saving it, because each browser asks in its own way where to save."""


def value(window: Window, name: str) -> float:
    """The value of a parameter, once all messages are answered."""
    window.wait_for_function(QUIET)
    found: float = window.evaluate(f"oscillations.shown.settings.{name}.value")
    return found


def test_a_visitor_finds_a_scene_changes_it_and_takes_its_numbers_along(engine: Window, server: Server) -> None:
    engine.goto(server.url)
    press(engine, middle(engine, "a.scene-card[href='?scene=coupled']"))
    engine.wait_for_function(f"location.search && {CONNECTED}")
    assert engine.evaluate(HEADLINE) == SCENES["coupled"].headline
    click(engine, "button", "Pause")
    click(engine, "button", "Restart")
    engine.evaluate(PASSED, 3)  # until the mass is drawn where it starts
    drag(engine, "[data-grab=x1_0]", 40)
    engine.wait_for_function("oscillations.shown.settings.x1_0.value > 1")
    before = value(engine, "k2")
    x, y = middle(engine, "input[name=k2-slider]")
    press(engine, (x + 30, y))
    by_track = value(engine, "k2")
    assert by_track != before
    engine.keyboard.press("ArrowRight")
    assert value(engine, "k2") > by_track
    press(engine, middle(engine, "input[name=k2]"))
    engine.evaluate("document.activeElement.select()")
    engine.keyboard.type("3.5")
    engine.keyboard.press("Enter")
    engine.wait_for_function(f"{ADDRESS}.includes('k2=3.5')")
    engine.reload()
    engine.wait_for_function(CONNECTED)
    assert value(engine, "k2") == 3.5
    label, given = next((label, given) for label, given in SCENES["coupled"].presets.items() if "k2" in given)
    click(engine, "button", label)
    engine.wait_for_function(f"oscillations.shown.settings.k2.value === {given['k2']}")
    click(engine, "button", "Undo")
    engine.wait_for_function("oscillations.shown.settings.k2.value === 3.5")
    first, second, *_ = SCENES["coupled"].views
    chosen = "document.querySelector('[role=tab][aria-selected=true]').textContent"
    click(engine, "tab", second.name)
    engine.wait_for_function(f"{chosen} === {second.name!r} && {ADDRESS}.includes('view=')")
    engine.keyboard.press(",")
    engine.wait_for_function(f"{chosen} === {first.name!r}")
    engine.evaluate(SAVED)
    click(engine, "button", "Save and share")
    click(engine, "button", "CSV")
    engine.wait_for_function("window.saved?.name === 'coupled.zip' && window.saved.size > 10_000")


def marked(window: Window) -> None:
    left, top, width, height = window.evaluate("""(({plot: {host, frame}}) => {
      const {left, top} = host.getBoundingClientRect()
      return [left + frame.left, top + frame.top, frame.width, frame.height]
    })(oscillations.walks.walk.card.question.marker)""")
    press(window, (left + width / 2, top + 0.3 * height))


def sketched(window: Window) -> None:
    x, y = middle(window, ".drawing")
    stroke(window, [(x + 12 * i, y - 40 + 8 * (i % 10)) for i in range(-15, 15)])


def numbered(window: Window) -> None:
    press(window, middle(window, ".card input[name=answer]"))
    window.keyboard.type("2.5")


ANSWERS: dict[str, Callable[[Window], None]] = {
    "d34-01": numbered,
    "d34-02": lambda window: press(window, middle(window, ".answers [data-option='0']")),
    "d34-08": marked,
    "d34-10": sketched,
}
"""How to give a number, a choice, a point and a sketch."""


@pytest.mark.parametrize("step", ANSWERS)
def test_a_step_of_a_walk_is_answered_and_explained(engine: Window, server: Server, step: str) -> None:
    engine.goto(f"{server.url}?walk=d34&step={step}")
    engine.wait_for_function(CARD)
    ANSWERS[step](engine)
    click(engine, "button", "Show the answer")
    engine.wait_for_function(LESSON)
    assert engine.evaluate("oscillations.walks.walk.lesson.right") is not None
    engine.keyboard.press("PageDown")
    engine.wait_for_function(f"!{LESSON} || document.querySelector('.follows').open")


def test_a_follower_joins_a_class_and_votes(engine: Window, server: Server, window: Open) -> None:
    lecture, code = taught(window, "walk=d34&step=d34-12")
    engine.goto(f"{server.url}?class={code}")
    press(engine, middle(engine, ".answers [data-option='1']"))
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered")
    engine.goto("about:blank")


def test_a_restarted_server_finds_what_was_set_meanwhile(engine: Window, tmp_path: Path) -> None:
    port = free_port()
    with serving(tmp_path / "first", port=port) as server:
        opened(engine, f"{server.url}?scene=coupled&k2=3")
    engine.wait_for_function("document.documentElement.dataset.connected === 'false'")
    press(engine, middle(engine, "input[name=k2-slider]"))
    engine.keyboard.press("End")
    engine.wait_for_function("document.querySelector('.control.waits')")
    with serving(tmp_path / "second", port=port):
        engine.wait_for_function(f"{READY} && {CONNECTED} && {QUIET}")
        assert value(engine, "k2") > 3
        engine.goto("about:blank")
