"""The page plays without the server, restores a link, shows the numbers at the pointer, and is laid out once."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import pytest
from playwright.sync_api import Page, WebSocket, expect

from components.quantities.formatting import short
from components.scenes import SCENES
from tests.browser.fixtures import READY
from tests.browser.waiting import QUIET, passed, played, turned
from tests.grids import sample
from tests.page import scripts

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
FRAMES = 10


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


@pytest.mark.parametrize("slug", sample(list(SCENES), 20))
def test_a_frame_is_laid_out_once(slug: str, desk: Page) -> None:
    """A timer that starts with a change does not measure the page either."""
    turned(desk, slug, {})
    desk.evaluate("oscillations.clock.playing = true")
    least = {"playing": math.inf, "after a change": math.inf}
    with layouts(desk) as counts:
        for window in (None, None, 7, 8, 9):
            if window:
                desk.evaluate("text => oscillations.send({type: 'typed', name: 'window', text})", str(window))
                desk.wait_for_function(QUIET)
                played(desk, 4)
            laid_out, frames = counts()
            played(desk, 2 * FRAMES)
            now, when = counts(), "after a change" if window else "playing"
            least[when] = min(least[when], (now[0] - laid_out) / (now[1] - frames))
    assert least["playing"] <= 1.3 and least["after a change"] <= 1.5


def test_it_plays_without_the_server_and_reads_a_motion_as_it_is(page: Page, open_scene: Open) -> None:
    frames: list[WebSocket] = []
    page.on("websocket", lambda socket: socket.on("framesent", lambda _: frames.append(socket)))
    open_scene(page, scene="coupled")
    now = "oscillations.clock.t"
    played(page, 5)
    sent, first = len(frames), page.evaluate(now)
    played(page, 30)
    assert page.evaluate(now) != first and len(frames) == sent
    page.get_by_role("button", name="Pause").click()
    stopped = page.evaluate(now)
    passed(page)
    assert page.evaluate(now) == stopped
    page.get_by_role("button", name="Step forward").click()
    assert page.evaluate(now) > stopped
    page.get_by_role("button", name="Step back").click()
    assert page.evaluate(now) == pytest.approx(stopped)
    page.get_by_role("button", name="Restart").click()
    assert page.evaluate(now) == 0
    picture = SCENES["coupled"]().shown
    for share in (0.2, 0.55, 0.93):
        x, y, place = pointed(page, "x1", share)
        page.mouse.move(x, y)
        x1 = float(scripts.played(picture, place)["x1"])
        expect(page.locator(".reading:visible span").last).to_have_text(f"x1 {short(x1)} {picture.axes['x'].full_unit}")
    page.locator(".block.plot .part.slow").first.click()  # a term of the formula takes its curve away
    page.wait_for_function("oscillations.shown.state.hidden?.includes('x1_slow')")
    page.wait_for_url(re.compile("hidden=x1_slow"))


def pointed(page: Page, name: str, share: float) -> tuple[float, float, float]:
    """A point in a plot, in pixels, and its value on the horizontal axis."""
    x, y, place = page.evaluate(
        """([name, share]) => {
      const plot = oscillations.plots.find(({block}) => block.name === name), {frame} = plot
      const box = plot.host.getBoundingClientRect(), x = Math.round(box.x + frame.left + share * frame.width)
      return [x, box.y + frame.top + frame.height / 2, plot.valueAt({clientX: x, clientY: 0})]
    }""",
        [name, share],
    )
    return x, y, place


def test_numbers_at_the_pointer_and_at_a_handle_have_their_unit(desk: Page) -> None:
    for slug, given, plot, says in (
        ("oscillator", {"view": "speed"}, "v", r"^v −?\d[\d.]* m/s$"),
        ("energy", {"view": "well"}, "well", r"^V \d[\d.]* J$"),
        ("analogues", {"view": "large"}, "late", r"^longer by \d[\d.]* %$"),
        ("phugoid", {}, "period", r"^τ \d[\d.]* s$"),
    ):
        turned(desk, slug, given)
        desk.mouse.move(*pointed(desk, plot, 0.6)[:2])
        expect(desk.locator(".reading:visible span").first).to_have_text(re.compile(says))
    pill = desk.get_by_role("slider", name="Drive frequency", exact=True)
    for omega, text in ((10, "ω 10.0 rad/s"), (0.3, "ω 0.300")):  # the unit hides the axis' last number with it
        turned(desk, "forced", {"curve": "log", "omega": omega})
        expect(pill).to_have_text(text)


def test_a_link_restores_the_scene_and_names_what_it_refuses(page: Page, open_scene: Open) -> None:
    script = "<img src=x onerror=alert(1)>"
    open_scene(page, scene="coupled", k2="3.5", m1=script, energy="modes", hidden="x1_slow", window="50", fruit="pear")
    state = page.evaluate(
        "(s => ({k2: s.settings.k2.value, m1: s.settings.m1.value, hidden: s.state.hidden, end: s.view.axes.t.end}))"
        "(oscillations.shown)"
    )
    assert state == {"k2": 3.5, "m1": 2, "hidden": ["x1_slow"], "end": 50}
    notice = page.locator(".notice")
    for text in ("m1", "fruit", "<img"):
        expect(notice).to_contain_text(text)
    expect(notice).to_be_visible()
    assert notice.locator("img").count() == 0
    page.reload()
    page.wait_for_function(READY)
    assert page.evaluate("oscillations.shown.settings.k2.value") == 3.5
    with page.expect_navigation():  # before the change is answered
        page.evaluate("""() => void setTimeout(() => {
          oscillations.send({type: "set", values: {k2: 3}})
          location.reload()
        })""")
    page.wait_for_function("globalThis.oscillations?.shown?.settings.k2.value === 3")


def test_moving_numbers_are_of_the_instant_when_the_page_stops(desk: Page) -> None:
    """While it plays, they change a few times a second: each change lays out their line again."""
    turned(desk, "oscillator", {})
    told = desk.evaluate("""() => {
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
