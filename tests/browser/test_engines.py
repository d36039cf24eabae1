"""Every scene in Safari's engine and in Firefox; in all engines, what each of them does in its own way."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from components.layout.text import mathml
from components.scenes import SCENES
from tests.browser.engines import Window
from tests.browser.fixtures import READY
from tests.browser.hands import CONNECTED, middle, opened, stroke
from tests.browser.waiting import FRAMES, PASSED, QUIET
from tests.grids import sample
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
@pytest.mark.parametrize("slug", sample([*SCENES], 3))
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


SIZE = 80  # px of the text
SHOW = f"""formula => {{
  document.body.innerHTML = `<div style="padding: 100px; font-size: {SIZE}px">${{formula}}</div>`
  return document.fonts.ready.then(() => new Promise(drawn => requestAnimationFrame(() => setTimeout(drawn, 100))))
}}"""


class Ink:
    """The dark pixels of one formula, in the lecture's style, independent of the boxes that an engine reports."""

    def __init__(self, window: Window, latex: str, path: Path) -> None:
        window.evaluate(SHOW, mathml(latex))
        window.screenshot(path=path)
        self._dark = np.asarray(Image.open(path).convert("L")) < 128

    def gaps(self, axis: int) -> list[int]:
        """The gaps between parts, in px: above each other (axis 1) or next to each other (axis 0)."""
        return [start - end for (_, end), (start, _) in pairwise(self.parts(axis))]

    def parts(self, axis: int) -> list[tuple[int, int]]:
        """The first and last pixel of each part."""
        edges = np.flatnonzero(np.diff(self._dark.any(axis=axis).astype(int))) + 1
        return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def test_formulas_look_the_same(engine: Window, server: Server, tmp_path: Path) -> None:
    """The dots of a derivative are close above its letter; a frequency and its sign are one symbol; words are as large
    as the text around them, and letters larger, because those of the font of formulas are small.
    """
    engine.goto(f"{server.url}?scene=energy")
    engine.wait_for_function(READY)
    for latex in (r"\dot{x}", r"\ddot{x}", r"\dot{\theta}", r"\ddot{x}_1"):
        [gap] = Ink(engine, latex, tmp_path / "formula.png").gaps(axis=1)
        assert 0.05 * SIZE < gap < 0.25 * SIZE, latex
    for sign in "-+":
        inside, after, _ = Ink(engine, rf"\omega_{sign} = 1", tmp_path / "formula.png").gaps(axis=0)
        assert inside < 0.15 * SIZE < 0.4 * SIZE < after < 0.55 * SIZE, sign
    Ink(engine, r"\text{slow} = x", tmp_path / "formula.png")
    sizes = "['mtext', 'mi'].map(name => parseFloat(getComputedStyle(document.querySelector(name)).fontSize))"
    assert engine.evaluate(sizes) == pytest.approx([1.05 * SIZE, 1.13 * SIZE], abs=0.005 * SIZE)


SELECTED = """[...document.querySelectorAll(".block.stage, .plot-area, .drawing, .marking, [data-grab], .pill")]
  .filter(one => one.checkVisibility())
  .map(one => [one.getAttribute("class").split(" ")[0], getComputedStyle(one).webkitUserSelect])"""


@pytest.mark.parametrize("link", ["scene=coupled", "walk=d34&step=d34-10", "walk=d34&step=d34-08"])
def test_a_long_press_on_what_can_be_dragged_selects_no_text(engine: Window, server: Server, link: str) -> None:
    engine.goto(f"{server.url}?{link}")
    engine.wait_for_function(f"{READY} && (!{'walk' in link:d} || document.querySelector('.card'))")
    kinds, found = zip(*engine.evaluate(SELECTED), strict=True)
    assert {"plot-area", {"coupled": "grip", "d34-10": "drawing", "d34-08": "marking"}[link.split("=")[-1]]} <= {*kinds}
    assert {*found} == {"none"}
