"""The page in Chromium: draws, plays without the server, restores a link, shows the numbers at the pointer."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import pytest
from playwright.sync_api import Page, WebSocket, expect

from components.quantities.formatting import short
from components.scenes import SCENES
from tests.browser.waiting import QUIET, passed, played, turned
from tests.grids import spread
from tests.page import scripts

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
slugs = pytest.mark.parametrize("slug", list(SCENES))

INKED = """() => oscillations.plots.filter(plot => plot.host.offsetParent && !plot.absent).map(plot => {
  const below = one => [one, ...(one.shadowRoot ? within(one.shadowRoot) : [])]
  const within = root => [...root.querySelectorAll('*')].flatMap(below)
  const canvases = within(plot.host).filter(one => one.tagName === 'CANVAS' && one.width)
  const pixels = canvases.map(one => one.getContext('2d').getImageData(0, 0, one.width, one.height).data)
  const probe = document.createElement('canvas').getContext('2d')
  const has = tint => {
    probe.fillStyle = getComputedStyle(document.documentElement).getPropertyValue('--' + tint).trim()
    probe.fillRect(0, 0, 1, 1)
    const ink = probe.getImageData(0, 0, 1, 1).data
    return pixels.some(data => {
      for (let i = 0; i < data.length; i += 4)
        if (data[i + 3] > 99 && [0, 1, 2].every(part => Math.abs(data[i + part] - ink[part]) < 40)) return true
      return false
    })
  }
  const {curves, regions} = plot.block
  return {name: plot.block.name, inked: [...curves, ...regions].some(part => has(part.tint))}
})"""
OVERFLOW = """() => {
  const page = document.documentElement
  const wide = page.scrollWidth > innerWidth, high = page.scrollHeight > innerHeight
  const panel = document.querySelector('.panel')
  return {wide, high, panel: panel.scrollHeight - panel.clientHeight}
}"""


FRAMES = 10
SIZES = ((1280, 720), (1920, 1080), (390, 844))
"""A desk, and in the other theme a hall and a phone."""


@slugs
def test_scene_draws_and_fits_desk_hall_and_phone(slug: str, turning: Page) -> None:
    turned(turning, slug, {})
    expect(turning.get_by_role("heading", level=1)).to_have_text(SCENES[slug].headline)
    drawn = "plots.length || document.querySelector('.block.table').checkVisibility()"
    turning.wait_for_function(f"(plots => ({drawn}) && plots.every(plot => plot.inked))(({INKED})())")
    theme = turning.get_by_role("button", name="Light or dark")
    for width, height in SIZES:
        turning.set_viewport_size({"width": width, "height": height})
        passed(turning)
        fit = turning.evaluate(OVERFLOW)
        assert not fit["wide"], (width, fit)
        if width > 700:
            assert not fit["high"], (width, fit)
            assert fit["panel"] <= 0, (width, fit)
        if width == 1280:
            theme.click()
    turning.set_viewport_size({"width": 1280, "height": 720})
    theme.click()


@contextmanager
def layouts(page: Page) -> Iterator[Callable[[], tuple[float, float]]]:
    """A function that returns the number of layouts of the page, and the number of frames drawn."""
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable")

    def counts() -> tuple[float, float]:
        metrics = session.send("Performance.getMetrics")["metrics"]
        laid_out = next(one["value"] for one in metrics if one["name"] == "LayoutCount")
        return laid_out, page.evaluate("oscillations.clock.frames")

    yield counts
    session.detach()


@pytest.mark.parametrize("slug", spread(list(SCENES), 3))
def test_a_frame_is_laid_out_once(slug: str, turning: Page) -> None:
    turned(turning, slug, {})
    turning.evaluate("oscillations.clock.playing = true")
    least = math.inf
    with layouts(turning) as counts:
        for _ in range(3):
            laid_out, frames = counts()
            played(turning, FRAMES)
            now = counts()
            least = min(least, (now[0] - laid_out) / (now[1] - frames))
    assert least <= 1.3


@pytest.mark.parametrize("slug", spread(list(SCENES), 3))
def test_nothing_but_frames_lays_out_the_page_after_a_change(slug: str, turning: Page) -> None:
    """A timer that starts with a change does not measure the page either."""
    turned(turning, slug, {})
    turning.evaluate("oscillations.clock.playing = true")
    least = math.inf
    with layouts(turning) as counts:
        for window in (7, 8, 9):
            turning.evaluate("text => oscillations.send({type: 'typed', name: 'window', text})", str(window))
            turning.wait_for_function(QUIET)
            played(turning, 4)
            laid_out, frames = counts()
            played(turning, 2 * FRAMES)
            now = counts()
            least = min(least, (now[0] - laid_out) / (now[1] - frames))
    assert least <= 1.5


def test_plays_without_the_server(page: Page, open_scene: Open) -> None:
    frames: list[WebSocket] = []
    page.on("websocket", lambda socket: socket.on("framesent", lambda _: frames.append(socket)))
    open_scene(page, scene="coupled")
    played(page, 5)
    sent, first = len(frames), page.evaluate("oscillations.clock.t")
    played(page, 30)
    assert page.evaluate("oscillations.clock.t") != first
    assert len(frames) == sent
    page.get_by_role("button", name="Pause").click()
    stopped = page.evaluate("oscillations.clock.t")
    passed(page)
    assert page.evaluate("oscillations.clock.t") == stopped
    page.get_by_role("button", name="Step forward").click()
    assert page.evaluate("oscillations.clock.t") > stopped
    page.get_by_role("button", name="Step back").click()
    assert page.evaluate("oscillations.clock.t") == pytest.approx(stopped)
    page.get_by_role("button", name="Restart").click()
    assert page.evaluate("oscillations.clock.t") == 0


def test_a_link_restores_the_scene_and_names_what_it_refuses(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled", k2="3.5", m1="-2", energy="modes", hidden="x1_slow", window="50", fruit="pear")
    state = page.evaluate(
        "(s => ({k2: s.settings.k2.value, m1: s.settings.m1.value, hidden: s.state.hidden, end: s.view.axes.t.end}))"
        "(oscillations.shown)"
    )
    assert state == {"k2": 3.5, "m1": 2, "hidden": ["x1_slow"], "end": 50}
    notice = page.locator(".notice")
    expect(notice).to_be_visible()
    expect(notice).to_contain_text("m1")
    expect(notice).to_contain_text("fruit")
    page.reload()
    page.wait_for_function("document.documentElement.dataset.ready === 'true'")
    assert page.evaluate("oscillations.shown.settings.k2.value") == 3.5
    with page.expect_navigation():  # before the change is answered
        page.evaluate("""() => void setTimeout(() => {
          oscillations.send({type: "set", values: {k2: 3}})
          location.reload()
        })""")
    page.wait_for_function("globalThis.oscillations?.shown?.settings.k2.value === 3")


def test_a_script_in_a_link_stays_text(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled", m1="<img src=x onerror=alert(1)>")
    assert page.locator(".notice img").count() == 0
    expect(page.locator(".notice")).to_be_visible()


def test_a_handle_over_the_last_number_says_the_unit(page: Page, open_scene: Open) -> None:
    pill = page.get_by_role("slider", name="Drive frequency", exact=True)
    open_scene(page, scene="forced", curve="log", omega=10)
    expect(pill).to_have_text("ω 10.0 rad/s")
    open_scene(page, scene="forced", curve="log", omega=0.3)
    expect(pill).to_have_text("ω 0.300")


def test_a_term_of_the_formula_takes_its_curve_away(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    page.locator(".block.plot .part.slow").first.click()
    page.wait_for_function("oscillations.shown.state.hidden?.includes('x1_slow')")
    page.wait_for_url(re.compile("hidden=x1_slow"))


def test_reduced_motion_opens_paused(new_page: Callable[..., Page], open_scene: Open) -> None:
    page = open_scene(new_page(reduced_motion="reduce"), scene="coupled")
    expect(page.get_by_role("button", name="Play", exact=True)).to_be_visible()
    assert page.evaluate("oscillations.clock.playing") is False


def test_moving_numbers_are_of_the_instant_when_the_page_stops(turning: Page) -> None:
    """While it plays, they change a few times a second: each change lays out their line again."""
    turned(turning, "oscillator", {})
    told = turning.evaluate("""() => {
      const {page} = oscillations, {clock} = page, told = [], now = performance.now()
      const text = () => document.querySelector('.stage [data-value="x"], [data-value="x"]').textContent
      performance.now = () => now
      try {
        clock.playing = true
        page.redraw()
        for (const t of [0, 0.3 * clock.end]) { page.draw(t); told.push(text()) }
        clock.playing = false
        page.draw(0.3 * clock.end)
        told.push(text())
      } finally { delete performance.now }
      return told
    }""")
    assert told[0] == told[1] != told[2]


def test_small_pictures_that_scroll_out_of_sight_rest(turning: Page) -> None:
    turned(turning, "analogues", {})
    turning.set_viewport_size({"width": 390, "height": 844})
    turning.wait_for_function("oscillations.stages.some(stage => stage.eyes && !stage.isSeen)")
    before = turning.evaluate("""() => {
      const {page} = oscillations, away = page.stages.filter(stage => stage.eyes && !stage.isSeen)
      const drawn = () => away.map(stage => stage.svg.innerHTML).join()
      page.clock.playing = false
      page.draw(0.1 * page.clock.end)
      const before = drawn()
      page.draw(0.3 * page.clock.end)
      away.at(-1).host.scrollIntoView({inline: "center"})
      globalThis.resting = away.at(-1)
      globalThis.rested = resting.svg.innerHTML
      return before === drawn()
    }""")
    assert before
    turning.evaluate("oscillations.clock.seek(0.37 * oscillations.clock.end)")
    turning.wait_for_function("resting.svg.innerHTML !== rested")


POINT = """([name, share]) => {
  const plot = oscillations.plots.find(({block}) => block.name === name), {frame} = plot
  const box = plot.host.getBoundingClientRect(), x = Math.round(box.x + frame.left + share * frame.width)
  return {x, y: box.y + frame.top + frame.height / 2, place: plot.valueAt({clientX: x, clientY: 0})}
}"""


@pytest.mark.parametrize("share", [0.2, 0.55, 0.93])
def test_a_motion_is_read_as_it_is(page: Page, open_scene: Open, share: float) -> None:
    open_scene(page, scene="coupled")
    point = page.evaluate(POINT, ["x1", share])
    page.mouse.move(point["x"], point["y"])
    picture = SCENES["coupled"]().shown
    x1 = float(scripts.played(picture, point["place"])["x1"])
    expect(page.locator(".reading:visible span").last).to_have_text(f"x1 {short(x1)} {picture.axes['x'].full_unit}")
