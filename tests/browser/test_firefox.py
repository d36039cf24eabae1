"""In Debian's Firefox: every scene is drawn, moves, and answers; skipped where there is none."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from components.scenes import SCENES
from tests.browser.firefox import Firefox, find
from tests.browser.fixtures import READY, SCREENSHOTS
from tests.serving.server import Server

pytestmark = pytest.mark.browser
WATCH = """() => {
  document.thrown = []
  addEventListener("error", event => document.thrown.push(event.message))
  addEventListener("unhandledrejection", event => document.thrown.push(String(event.reason)))
}"""
FRAMES = """() => new Promise(drawn => {
  const {clock} = oscillations, last = clock.frames + 3
  const look = () => (clock.frames >= last ? drawn(true) : requestAnimationFrame(look))
  clock.dirty = true
  look()
})"""
DRAWN = """oscillations.plots.filter(plot => plot.box && !plot.absent).every(plot =>
  plot.mounted && plot.figure.element.querySelector(".bk-Figure")?.shadowRoot?.querySelector(".bk-Canvas")?.shadowRoot
    ?.querySelector("canvas")?.width > 0)"""
SET = """({name, value}) => oscillations.send({type: "set", values: {[name]: value}})"""
MOST_LIKELY = {"m1": 1.5, "m": 1.5, "theta_0": 0.5, "limit": 2.0}
"""A value for the first of these that a scene has."""


@pytest.fixture(scope="module")
def firefox(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Firefox]:
    path = find()
    if path is None:
        pytest.skip("no Firefox: apt-get install firefox-esr, or FIREFOX=its path")
    with Firefox(path, tmp_path_factory.mktemp("firefox")) as found:
        found.size(1280, 720)
        yield found


@pytest.mark.parametrize("slug", SCENES)
def test_a_scene_is_drawn_moves_and_answers(firefox: Firefox, server: Server, slug: str) -> None:
    firefox.goto(f"{server.url}?scene={slug}")
    firefox.evaluate(WATCH)
    firefox.wait_for_function(READY)
    assert firefox.evaluate("document.getElementById('missing').textContent") == ""
    firefox.wait_for_function(DRAWN)
    assert firefox.evaluate(FRAMES) is True
    name = next(name for name in MOST_LIKELY if name in SCENES[slug].linked())
    firefox.wait_for_function("oscillations.messages.wire")
    firefox.evaluate(SET, {"name": name, "value": MOST_LIKELY[name]})
    firefox.wait_for_function(f"oscillations.shown.settings.{name}.value === {MOST_LIKELY[name]}")
    firefox.screenshot(SCREENSHOTS / f"firefox-{slug}.png")
    assert firefox.evaluate("document.thrown") == []
