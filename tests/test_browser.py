"""The page in a real Chromium: draws, plays without the server, answers a slider, restores a link, refuses kindly."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, WebSocket, expect

from components.scenes import SCENES

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
slugs = pytest.mark.parametrize("slug", list(SCENES))

BLANK = """() => [...document.querySelectorAll('.plot-area')].filter(area => area.offsetParent).map(area => {
  const canvas = area.querySelector('.figure > *')?.shadowRoot ? null : area.querySelector('canvas')
  return area.clientWidth > 20 && area.clientHeight > 20
})"""
OVERFLOW = """() => {
  const page = document.documentElement
  const wide = page.scrollWidth > innerWidth, high = page.scrollHeight > innerHeight
  const panel = document.querySelector('.panel')
  return {wide, high, panel: panel.scrollHeight - panel.clientHeight}
}"""


@slugs
def test_scene_draws_and_fits(slug: str, page: Page, open_scene: Open, screenshot: Callable[[Page, str], Path]) -> None:
    open_scene(page, scene=slug)
    expect(page.get_by_role("heading", level=1)).to_have_text(SCENES[slug].headline)
    assert all(page.evaluate(BLANK))
    fit = page.evaluate(OVERFLOW)
    assert not fit["wide"] and not fit["high"], fit
    assert fit["panel"] <= 0, fit
    screenshot(page, slug)


@slugs
def test_scene_fits_a_phone_and_a_hall(
    slug: str, new_page: Callable[..., Page], open_scene: Open, screenshot: Callable[[Page, str], Path]
) -> None:
    phone = open_scene(new_page(390, 844, has_touch=True), scene=slug)
    assert not phone.evaluate(OVERFLOW)["wide"]
    screenshot(phone, f"{slug}-phone")
    hall = open_scene(new_page(1920, 1080, color_scheme="dark"), scene=slug)
    fit = hall.evaluate(OVERFLOW)
    assert not fit["wide"] and not fit["high"], fit
    screenshot(hall, f"{slug}-hall-dark")


def test_plays_without_the_server(page: Page, open_scene: Open) -> None:
    frames: list[WebSocket] = []
    page.on("websocket", lambda socket: socket.on("framesent", lambda _: frames.append(socket)))
    open_scene(page, scene="coupled")
    page.wait_for_timeout(300)
    sent, first, drawn = len(frames), page.evaluate("oscillations.clock.t"), page.evaluate("oscillations.clock.frames")
    page.wait_for_timeout(1000)
    assert page.evaluate("oscillations.clock.t") != first
    assert page.evaluate("oscillations.clock.frames") - drawn > 10
    assert len(frames) == sent
    page.get_by_role("button", name="Pause").click()
    stopped = page.evaluate("oscillations.clock.t")
    page.wait_for_timeout(200)
    assert page.evaluate("oscillations.clock.t") == stopped
    page.get_by_role("button", name="Step forward").click()
    assert page.evaluate("oscillations.clock.t") > stopped
    page.get_by_role("button", name="Step back").click()
    assert page.evaluate("oscillations.clock.t") == pytest.approx(stopped)
    page.get_by_role("button", name="Restart").click()
    assert page.evaluate("oscillations.clock.t") == 0


def test_stage_shows_what_the_plot_shows(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    page.evaluate("oscillations.clock.playing = false, oscillations.clock.seek(2.5)")
    page.wait_for_timeout(100)
    columns = page.evaluate("(c => ({t: [...c.t], x1: [...c.x1]}))(oscillations.state.columns.time)")
    at = min(range(len(columns["t"])), key=lambda i: abs(columns["t"][i] - 2.5))
    text = page.locator("svg.stage [data-value=x1]").first.text_content() or ""
    assert float(text.replace("−", "-")) == pytest.approx(columns["x1"][at], abs=0.06)


def test_a_slider_changes_the_curve_with_one_message(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    before = page.evaluate("[...oscillations.state.columns.time.x1]")
    with page.expect_event("console", lambda m: m.text == "painted"):
        page.evaluate("document.addEventListener('oscillations:painted', () => console.log('painted'), {once: true})")
        slider = page.locator('input[name="k2-slider"]')
        slider.focus()
        slider.press("ArrowRight")
    assert page.evaluate("[...oscillations.state.columns.time.x1]") != before
    page.wait_for_url(re.compile("k2="))


def test_typed_values_and_refusals(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="forced")
    field = page.locator('input[name="k2"]')
    field.fill("-3")
    field.press("Enter")
    alert = page.get_by_role("alert").filter(has_text="−3 N/m is not possible")
    expect(alert).to_be_visible()
    assert page.evaluate("oscillations.state.params.k2.value") == 1
    field.fill("1e6")
    field.press("Enter")
    expect(alert).to_be_hidden()
    page.wait_for_function("oscillations.state.params.k2.value === 1e6")


def test_a_link_restores_the_scene_and_names_what_it_refuses(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled", k2="3.5", m1="-2", energy="modes", hidden="x1_slow", window="50", fruit="pear")
    state = page.evaluate(
        "(s => ({k2: s.params.k2.value, m1: s.params.m1.value, hidden: s.hidden, end: s.axes.t.end}))"
        "(oscillations.state)"
    )
    assert state == {"k2": 3.5, "m1": 2, "hidden": ["x1_slow"], "end": 50}
    notice = page.locator(".notice")
    expect(notice).to_be_visible()
    expect(notice).to_contain_text("m1")
    expect(notice).to_contain_text("fruit")
    page.reload()
    page.wait_for_function("document.documentElement.dataset.ready === 'true'")
    assert page.evaluate("oscillations.state.params.k2.value") == 3.5


def test_a_script_in_a_link_stays_text(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled", m1="<img src=x onerror=alert(1)>")
    assert page.locator(".notice img").count() == 0
    expect(page.locator(".notice")).to_be_visible()


def test_the_handle_on_the_response_curve(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="forced")
    pill = page.get_by_role("slider", name="Drive frequency")
    pill.focus()
    pill.press("ArrowRight")
    page.wait_for_function("oscillations.state.params.omega.value > 0.8")
    box = pill.bounding_box()
    assert box
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + 5)
    page.mouse.down()
    page.mouse.move(box["x"] + 120, box["y"] + 5, steps=4)
    page.mouse.up()
    page.wait_for_function("oscillations.state.params.omega.value > 1")
    page.get_by_role("button", name="Drive at the slow natural frequency").click()
    page.wait_for_function("Math.abs(oscillations.state.params.omega.value - 0.6180339887498949) < 1e-15")
    assert page.evaluate("oscillations.state.columns.time.x1_p === undefined")


def test_a_handle_over_the_last_number_says_the_unit(page: Page, open_scene: Open) -> None:
    pill = page.get_by_role("slider", name="Drive frequency")
    open_scene(page, scene="forced", curve="log", omega=10)
    expect(pill).to_have_text("ω 10.0 rad/s")
    open_scene(page, scene="forced", curve="log", omega=0.3)
    expect(pill).to_have_text("ω 0.300")


def test_a_term_of_the_formula_takes_its_curve_away(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    page.locator(".block.plot .part.slow").first.click()
    page.wait_for_function("oscillations.state.hidden.includes('x1_slow')")
    page.wait_for_url(re.compile("hidden=x1_slow"))


def test_dark_and_light(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    paper = "getComputedStyle(document.body).backgroundColor"
    light = page.evaluate(paper)
    page.get_by_role("button", name="Light or dark").click()
    assert page.evaluate(paper) != light


def test_numbers_can_be_taken_along(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    with page.expect_download() as download:
        page.get_by_role("button", name="CSV").click()
    lines = Path(download.value.path()).read_text().splitlines()
    assert lines[1].startswith("time.t,")
    assert len(lines) > 200


def test_reduced_motion_opens_paused(new_page: Callable[..., Page], open_scene: Open) -> None:
    page = open_scene(new_page(reduced_motion="reduce"), scene="coupled")
    expect(page.get_by_role("button", name="Play", exact=True)).to_be_visible()
    assert json.dumps(page.evaluate("oscillations.clock.playing")) == "false"
