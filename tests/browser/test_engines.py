"""Scenes, a visitor's journey and what engines do in their own way, in Safari's engine and in Firefox."""

from collections.abc import Iterator

import pytest

from components.scenes import SCENES
from tests.browser.fixtures import CONNECTED, READY
from tests.browser.waiting import FRAMES, PASSED, QUIET, Point, stroke, value
from tests.grids import sample
from tests.serving.server import Server
from tools.browsers import firefox, webkit
from tools.browsers.driven import DrivenWindow

pytestmark = [pytest.mark.browser, pytest.mark.slow]
ENGINES = {"webkit": (webkit.WebKit, webkit.find), "firefox": (firefox.Firefox, firefox.find)}
FIND = """([selector, name]) => [...document.querySelectorAll(selector)].find(one =>
  one.checkVisibility({opacityProperty: true, visibilityProperty: true}) &&
  (!name || (one.getAttribute("aria-label") ?? one.textContent).trim() === name))"""
"""Return the first visible element of a selector, or the one with a name as a screen reader announces it."""
MIDDLE = f"""given => {{
  const found = ({FIND})(given)
  found.scrollIntoView({{block: "nearest", inline: "nearest"}})
  const {{left, top, width, height}} = found.getBoundingClientRect()
  return [left + width / 2, top + height / 2]
}}"""
WATCH = """() => {
  document.thrown = []
  addEventListener("error", event => document.thrown.push(event.message))
  addEventListener("unhandledrejection", event => document.thrown.push(String(event.reason)))
}"""
DRAWN = """oscillations.plots.filter(plot => plot.box && !plot.absent).every(plot =>
  plot.mounted && plot.figure.element.querySelector(".bk-Figure")?.shadowRoot?.querySelector(".bk-Canvas")?.shadowRoot
    ?.querySelector("canvas")?.width > 0)"""
PAINTED = """(() => {
  const canvas = document.querySelector("canvas.field")
  const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height)
  const columns = new Set()
  for (let i = 3; i < data.length; i += 4) if (data[i] > 100) columns.add(((i - 3) / 4) % canvas.width)
  return columns.size
})()"""
"""The number of masses of a chain that its picture has painted."""
MOST_LIKELY = {"m1": 1.5, "m": 1.5, "theta_0": 0.5, "limit": 2.0}
"""A value for the first of these parameters that a scene has."""
LESSON = "document.querySelector('.card .why')"
SAVED = """() => {
  URL.createObjectURL = file => ((window.saved = {size: file.size}), "#")
  HTMLAnchorElement.prototype.click = function () { window.saved.name = this.download }
}"""
"""Notes a file instead of saving it, because each browser asks in its own way where to save."""


def middle(window: DrivenWindow, selector: str, name: str = "") -> Point:
    """Return the middle of a visible element, scrolled into view, in pixels of the page."""
    window.wait_for_function(FIND, arg=[selector, name])
    x, y = window.evaluate(MIDDLE, [selector, name])
    return x, y


def press(window: DrivenWindow, selector: str, name: str = "") -> None:
    stroke(window.mouse, [middle(window, selector, name)])


@pytest.fixture(scope="session", params=ENGINES)
def engine(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[DrivenWindow]:
    """A window of 1280 x 720 in each engine; engines that the machine lacks are skipped."""
    kind, find = ENGINES[request.param]
    path = find()
    if path is None:
        pytest.skip(f"{kind.__name__} is not installed: make browsers installs it")
    window = kind(path, tmp_path_factory.mktemp(request.param))
    try:
        window.set_viewport_size({"width": 1280, "height": 720})
        yield window
    finally:
        window.close()


@pytest.mark.parametrize("slug", sample([*SCENES], 5))
def test_a_scene_is_drawn_moves_and_answers(engine: DrivenWindow, server: Server, slug: str) -> None:
    engine.goto(f"{server.url}?scene={slug}")
    engine.evaluate(WATCH)
    engine.wait_for_function(READY)
    assert engine.evaluate("document.getElementById('missing').textContent") == ""
    engine.wait_for_function(DRAWN)
    if slug == "chain":  # a pulse crosses the whole picture
        engine.wait_for_function(f"document.querySelector('canvas.field') && {PAINTED} === 50")
    engine.evaluate(FRAMES, 3)
    name = next(name for name in MOST_LIKELY if name in SCENES[slug].linked())
    engine.wait_for_function("oscillations.messages.wire")
    engine.evaluate("values => oscillations.send({type: 'set', values})", {name: MOST_LIKELY[name]})
    engine.wait_for_function(f"oscillations.shown.settings.{name}.value === {MOST_LIKELY[name]}")
    assert engine.evaluate("document.thrown") == []


def test_what_appears_above_does_not_move_what_is_in_sight(engine: DrivenWindow, server: Server) -> None:
    top = "document.querySelector('input[name=k2-slider]').getBoundingClientRect().top"
    engine.set_viewport_size({"width": 390, "height": 844})
    engine.goto(f"{server.url}?scene=coupled")
    engine.wait_for_function(CONNECTED)
    engine.evaluate("scrollTo(0, 300)")
    engine.wait_for_function("scrollY === 300")
    engine.evaluate(PASSED, 3)
    stood = engine.evaluate(top)
    engine.evaluate("() => { document.querySelector('h1').style.paddingBottom = '90px' }")
    engine.wait_for_function("scrollY > 380")
    assert abs(engine.evaluate(top) - stood) <= 1
    engine.set_viewport_size({"width": 1280, "height": 720})


def test_a_visitor_finds_a_scene_changes_it_and_takes_its_numbers_along(engine: DrivenWindow, server: Server) -> None:
    engine.goto(server.url)
    press(engine, "a.scene-card[href='?scene=coupled']")
    engine.wait_for_function(f"location.search && {CONNECTED}")
    assert engine.evaluate("document.querySelector('h1').textContent") == SCENES["coupled"].headline
    press(engine, "button", "Pause")
    press(engine, "button", "Restart")
    engine.evaluate(PASSED, 3)  # until the mass is drawn where it starts
    x, y = middle(engine, "[data-grab=x1_0]")
    stroke(engine.mouse, [(x + 5 * i, y) for i in range(9)])
    engine.wait_for_function("oscillations.shown.settings.x1_0.value > 1")
    before = value(engine, "k2")
    x, y = middle(engine, "input[name=k2-slider]")
    stroke(engine.mouse, [(x + 30, y)])
    by_track = value(engine, "k2")
    assert by_track != before
    engine.keyboard.press("ArrowRight")
    assert value(engine, "k2") > by_track
    press(engine, "input[name=k2]")
    engine.evaluate("document.activeElement.select()")
    engine.keyboard.type("3.5")
    engine.keyboard.press("Enter")
    engine.wait_for_function("location.search.includes('k2=3.5')")
    engine.reload()
    engine.wait_for_function(CONNECTED)
    assert value(engine, "k2") == 3.5
    engine.evaluate(SAVED)
    press(engine, "summary", "Save and share")
    press(engine, "button", "CSV")
    engine.wait_for_function("window.saved?.name === 'coupled.zip' && window.saved.size > 10_000")


def test_a_sketch_of_a_walk_is_answered_and_explained(engine: DrivenWindow, server: Server) -> None:
    engine.goto(f"{server.url}?walk=d34&step=d34-10")
    engine.wait_for_function(f"{CONNECTED} && oscillations.walks.walk?.card && {QUIET}")
    x, y = middle(engine, ".drawing")
    stroke(engine.mouse, [(x + 12 * i, y - 40 + 8 * (i % 10)) for i in range(-15, 15)])
    press(engine, "button", "Show the answer")
    engine.wait_for_function(LESSON)
    assert engine.evaluate("oscillations.walks.walk.lesson.right") is not None
    engine.keyboard.press("PageDown")
    engine.wait_for_function(f"!{LESSON} || document.querySelector('.follows').open")
