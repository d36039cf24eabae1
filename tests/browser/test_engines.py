"""Every scene is drawn, moves and answers in Safari's engine and in Firefox; other tests draw it in Chromium."""

from __future__ import annotations

import pytest

from components.scenes import SCENES
from tests.browser.engines import Window
from tests.browser.fixtures import READY
from tests.browser.hands import CONNECTED, middle, opened, stroke
from tests.browser.waiting import FRAMES, PASSED, QUIET
from tests.serving.server import Server

pytestmark = [pytest.mark.browser, pytest.mark.slow]
WATCH = """() => {
  document.thrown = []
  addEventListener("error", event => document.thrown.push(event.message))
  addEventListener("unhandledrejection", event => document.thrown.push(String(event.reason)))
}"""
DRAWN = """oscillations.plots.filter(plot => plot.box && !plot.absent).every(plot =>
  plot.mounted && plot.figure.element.querySelector(".bk-Figure")?.shadowRoot?.querySelector(".bk-Canvas")?.shadowRoot
    ?.querySelector("canvas")?.width > 0)"""
SET = """({name, value}) => oscillations.send({type: "set", values: {[name]: value}})"""
MOST_LIKELY = {"m1": 1.5, "m": 1.5, "theta_0": 0.5, "limit": 2.0}
"""A value for the first of these parameters that a scene has."""


@pytest.mark.parametrize("engine", ("webkit", "firefox"), indirect=True)
@pytest.mark.parametrize("slug", SCENES)
def test_a_scene_is_drawn_moves_and_answers(engine: Window, server: Server, slug: str) -> None:
    engine.goto(f"{server.url}?scene={slug}")
    engine.evaluate(WATCH)
    engine.wait_for_function(READY)
    assert engine.evaluate("document.getElementById('missing').textContent") == ""
    engine.wait_for_function(DRAWN)
    engine.evaluate(FRAMES, 3)
    name = next(name for name in MOST_LIKELY if name in SCENES[slug].linked())
    engine.wait_for_function("oscillations.messages.wire")
    engine.evaluate(SET, {"name": name, "value": MOST_LIKELY[name]})
    engine.wait_for_function(f"oscillations.shown.settings.{name}.value === {MOST_LIKELY[name]}")
    assert engine.evaluate("document.thrown") == []


PAINTED = """(() => {
  const canvas = document.querySelector("canvas.field")
  const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height)
  const columns = new Set()
  for (let i = 3; i < data.length; i += 4) if (data[i] > 100) columns.add(((i - 3) / 4) % canvas.width)
  return columns.size
})()"""


@pytest.mark.parametrize("engine", ("webkit", "firefox"), indirect=True)
def test_a_pulse_crosses_the_whole_picture_of_a_chain(engine: Window, server: Server) -> None:
    opened(engine, f"{server.url}?scene=chain")
    engine.wait_for_function(f"document.querySelector('canvas.field') && {PAINTED} === 50")


STACKED = "Number(getComputedStyle(document.querySelector('.page')).getPropertyValue('--stacked'))"
BAR = "(innerWidth - document.documentElement.clientWidth)"


def test_the_scrollbar_of_a_narrow_window_does_not_keep_the_stacked_layout(engine: Window, server: Server) -> None:
    """A stacked page scrolls, a wide one does not. The bar takes up to 21 px of the width that decides the layout."""
    engine.set_viewport_size({"width": 1000, "height": 720})
    engine.goto(f"{server.url}?scene=analogues")
    engine.wait_for_function(READY)
    assert engine.evaluate(f"[{STACKED}, {BAR} > 0]") == [1, True]
    engine.set_viewport_size({"width": 1280, "height": 720})
    engine.wait_for_function(f"innerWidth === 1280 && !{STACKED} && !{BAR}")


NONE_COALESCED = "() => { PointerEvent.prototype.getCoalescedEvents = () => [] }"
DRAWN_TO = "document.querySelector('.strokes path.yours')?.getAttribute('d').split('L').length > 20"


def test_a_curve_is_drawn_where_an_event_names_no_other(engine: Window, server: Server) -> None:
    opened(engine, f"{server.url}?walk=d34&step=d34-10")
    engine.evaluate(NONE_COALESCED)
    x, y = middle(engine, ".drawing")
    stroke(engine, [(x + 10 * i, y + i) for i in range(12)])
    engine.wait_for_function(DRAWN_TO)


HOLD_BACK = """() => {
  const {wire} = oscillations.messages
  const send = wire.send
  wire.send = message => (message.type === "open" ? (window.go = () => send(message)) : send(message))
  oscillations.walks.walk.show(true)
}"""
EXPLAINED = "document.querySelector('.card .why')"
READ = f"getComputedStyle({EXPLAINED}).visibility === 'visible' && {EXPLAINED}.textContent"


def test_an_explanation_is_read_with_its_numbers(engine: Window, server: Server) -> None:
    """They arrive with the picture after the answer, which is held back here."""
    opened(engine, f"{server.url}?walk=d34&step=d34-10")
    engine.wait_for_function(f"oscillations.walks.walk?.card && {QUIET}")
    engine.evaluate(HOLD_BACK)
    engine.wait_for_function(f"{EXPLAINED} && Boolean(window.go)")
    assert not engine.evaluate(READ)
    engine.evaluate("() => window.go()")
    engine.wait_for_function(READ)
    assert "again every 31.3 s. Half-way" in engine.evaluate(READ)


HIDE = """hidden => {
  Object.defineProperty(document, "hidden", {configurable: true, get: () => hidden})
  document.dispatchEvent(new Event("visibilitychange"))
}"""
KILL = "() => { oscillations.messages.wire.send = () => {} }"


def test_a_connection_that_died_while_the_page_was_hidden_is_replaced(engine: Window, server: Server) -> None:
    """The visitor sends nothing meanwhile."""
    opened(engine, f"{server.url}?scene=coupled")
    engine.wait_for_function(QUIET)
    engine.evaluate(KILL)
    engine.evaluate(HIDE, True)
    engine.evaluate(HIDE, False)
    engine.wait_for_function(f"oscillations.messages.lostConnections === 1 && {CONNECTED}")


TOP = "document.querySelector('input[name=k2-slider]').getBoundingClientRect().top"
GROWS = "() => { document.querySelector('h1').style.paddingBottom = '90px' }"


def test_what_appears_above_does_not_move_what_is_in_sight(engine: Window, server: Server) -> None:
    engine.set_viewport_size({"width": 390, "height": 844})
    opened(engine, f"{server.url}?scene=coupled")
    engine.evaluate("scrollTo(0, 300)")
    engine.wait_for_function("scrollY === 300")
    engine.evaluate(PASSED, 3)
    stood = engine.evaluate(TOP)
    engine.evaluate(GROWS)
    engine.wait_for_function("scrollY > 380")
    assert abs(engine.evaluate(TOP) - stood) <= 1
    engine.set_viewport_size({"width": 1280, "height": 720})
