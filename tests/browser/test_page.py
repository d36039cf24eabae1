"""The page plays without the server, and restores a link; single scenes; the start page; docs/embedding.md's frame."""

import re
from collections.abc import Callable, Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread

import pytest
from playwright.sync_api import Page, WebSocket, expect

from components.quantities.formatting import short
from components.scenes import SCENES
from physics.analogues import ANALOGUES
from tests.browser import looks
from tests.browser.fixtures import READY, Open
from tests.browser.waiting import PASSED, UNFOLD, passed, played, seek, turned, unfold
from tests.page import scripts
from tests.serving.server import ROOT, Server

pytestmark = pytest.mark.browser
POINTED = """([name, share]) => {
  const plot = oscillations.plots.find(({block}) => block.name === name), {frame} = plot
  const box = plot.host.getBoundingClientRect(), x = Math.round(box.x + frame.left + share * frame.width)
  return [x, box.y + frame.top + frame.height / 2, plot.valueAt({clientX: x, clientY: 0})]
}"""
PLACES = """[...document.querySelectorAll(".thumb g")].map(part => {
  const {x, y, width, height} = part.getBoundingClientRect()
  return [x, y, width, height].map(Math.round).join()
}).join(" ")"""
TOPS = "all => all.map(one => one.getBoundingClientRect()).map(({top, height}) => top + height / 2)"
INK = """all => all.filter(one => getComputedStyle(one).backgroundColor === getComputedStyle(document.body).color)
  .map(one => one.textContent)"""
PAGE = (ROOT / "docs" / "embedding.md").read_text(encoding="utf-8")
FRAME, LISTENER, _ = re.findall(r"```html\n(.*?)```", PAGE, re.S)


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
    picture = SCENES["coupled"]().shown
    x1 = float(scripts.played(picture, stopped)["x1"])  # moving numbers change a few times a second
    told = str(page.locator("[data-value=x1]").first.text_content())
    assert float(told.replace("−", "-")) == pytest.approx(x1, abs=5.1e-3)
    page.get_by_role("button", name="Step forward").click()
    assert page.evaluate(now) > stopped
    page.get_by_role("button", name="Step back").click()
    assert page.evaluate(now) == pytest.approx(stopped)
    page.get_by_role("button", name="Restart").click()
    assert page.evaluate(now) == 0
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
    x, y, place = page.evaluate(POINTED, [name, share])
    return x, y, place


def test_numbers_at_the_pointer_and_at_a_handle_have_their_unit(desk: Page) -> None:
    for slug, given, plot, says in (
        ("oscillator", {"view": "speed"}, "v", r"^v −?\d[\d.]* m/s$"),
        ("energy", {"view": "well"}, "well", r"^V \d[\d.]* J$"),
        ("phugoid", {}, "period", r"^τ \d[\d.]* s$"),
    ):
        turned(desk, slug, given)
        passed(desk)
        desk.mouse.move(*pointed(desk, plot, 0.6)[:2])
        expect(desk.locator(".reading:visible span").first).to_have_text(re.compile(says))
    pill = desk.get_by_role("slider", name="Drive frequency", exact=True)
    for omega, text in ((10, "ω 10.0 rad/s"), (0.3, "ω 0.300")):  # the unit hides the axis' last number with it
        turned(desk, "forced", {"curve": "log", "omega": omega})
        expect(pill).to_have_text(text)


def test_a_link_restores_the_scene_and_names_what_it_refuses(page: Page, open_scene: Open) -> None:
    script = "<img src=x onerror=alert(1)>"
    open_scene(page, scene="coupled", k2="3.5", m1=script, energy="modes", hidden="x1_slow", window="50", fruit="pear")
    state = "({settings: s, state, view}) => [s.k2.value, s.m1.value, state.hidden.join(), view.axes.t.end]"
    assert page.evaluate(f"({state})(oscillations.shown)") == [3.5, 2, "x1_slow", 50]
    notice = page.locator(".notice")
    expect(notice).to_be_visible()
    for text in ("m1", "fruit", "<img"):
        expect(notice).to_contain_text(text)
    assert notice.locator("img").count() == 0
    page.reload()
    page.wait_for_function("globalThis.oscillations?.shown?.settings.k2.value === 3.5")
    with page.expect_navigation():  # before the change is answered
        change = "oscillations.send({type: 'set', values: {k2: 3}})"
        page.evaluate(f"() => void setTimeout(() => {{ {change}, location.reload() }})")
    page.wait_for_function("globalThis.oscillations?.shown?.settings.k2.value === 3")


def level(page: Page, part: str, way: str = "b.top + b.height / 2") -> float:
    """The position of the middle or an edge of an element, or of a dot (plot/tint), from the top of the window."""
    plot, _, tint = part.partition("/")
    dot = f"oscillations.plots.find(p => p.block.name === '{plot}').dots.find(d => d.curve.tint === '{tint}').dot"
    found = dot if tint else f"document.querySelector('{part}')"
    return float(page.evaluate(f"(b => {way})({found}.getBoundingClientRect())"))


def test_masses_and_bars_are_level_with_their_curves(desk: Page) -> None:
    turned(desk, "oscillator", {"view": "formulas", "x_0": 0.15, "v_0": 0.0})
    for t in (0.2, 0.685, 1.4):
        seek(desk, t)
        assert level(desk, "svg.stage rect.mass") == pytest.approx(level(desk, "x/m1"), abs=1)
        assert level(desk, "v/T") == pytest.approx(level(desk, "plane/ink"), abs=1)
        assert level(desk, "a/F") == pytest.approx(level(desk, "law/ink"), abs=1)
    turned(desk, "energy", {"view": "energy"})
    for t in (0.3, 1.09):
        seek(desk, t)
        V, T = (level(desk, f"svg.stage .{tint} > .body", "b.top") for tint in ("V", "T"))
        bottom = level(desk, "svg.stage .T > .body", "b.bottom")
        assert [V, bottom] == pytest.approx([level(desk, "energy/V")] * 2, abs=1)
        assert pytest.approx(level(desk, "energy/total"), abs=1) == T


def test_pictures_choose_a_system_a_speed_and_presets_and_another_unit_changes_labels(desk: Page) -> None:
    turned(desk, "analogues", {"view": "roles"})
    tiles = desk.get_by_role("group", name="System").get_by_role("button")
    for tile, (slug, system) in zip(tiles.all(), ANALOGUES.items(), strict=True):
        tile.click()
        expect(tile).to_have_attribute("aria-pressed", "true")
        desk.locator("summary:visible", has_text=system.name).click()
        expect(desk.locator(f"input[name={slug}_{system.parameters[0].name}]")).to_be_visible()
    desk.wait_for_url(re.compile("system=pipe"))
    turned(desk, "analogues", {"view": "motion", "system": "circuit"})
    speed, usual = desk.locator("[data-value=speed]").first, "played 200\u202f000 times slower"
    expect(speed).to_have_text(usual)
    desk.get_by_role("button", name="Slower").click()
    expect(speed).not_to_have_text(usual)
    desk.get_by_role("button", name="Auto speed").click()
    expect(speed).to_have_text(usual)
    turned(desk, "phugoid", {})
    unfold(desk)
    field = desk.locator("input[name=v_0]")
    assert field.input_value() == "150"
    desk.get_by_role("button", name="knots").click()
    expect(field).to_have_value("88.87")
    expect(desk.get_by_label("v0, speed of steady flight, knots").first).to_be_visible()
    turned(desk, "phugoid", {"view": "limits"})
    loop = desk.get_by_role("button", name="Loop, 1")
    loop.click()
    expect(loop).to_have_attribute("aria-pressed", "true")
    expect(desk.locator("[data-value=verdict]:visible").first).to_contain_text("loops")
    turned(desk, "phugoid", {"view": "period"})
    desk.get_by_role("button", name="Speed of: Glider").click()  # a flag of the plot
    expect(desk.get_by_role("button", name="Glider", exact=True)).to_have_attribute("aria-pressed", "true")
    assert desk.evaluate("oscillations.shown.settings.v_0.value") == pytest.approx(90 * 0.3048)


@pytest.mark.slow  # methods run for seconds
def test_a_measurement_is_run_skips_a_method_and_is_cancelled(desk: Page) -> None:
    turned(desk, "accuracy", {"limit": 3, "system": "wide"})
    desk.get_by_role("button", name="Run", exact=True).click()
    stepping = re.compile("(Verlet|Newmark|RK4|DOP853|Radau|LSODA) is running")  # the others come first and are quick
    expect(desk.locator(".transport [role=status]")).to_contain_text(stepping, timeout=60_000)
    expect(desk.locator(".count")).to_contain_text("of 60 s")
    desk.get_by_role("button", name="Skip this method").click()
    desk.get_by_role("button", name="Cancel").click()
    expect(desk.locator(".count")).to_contain_text("methods measured here")
    expect(desk.get_by_role("button", name="Run again")).to_be_visible()


@pytest.fixture
def home(page: Page, server: Server) -> Page:
    page.goto(server.url)
    return page


def test_every_scene_is_there_and_opens_by_mouse_and_keys_and_one_filled_button_begins_the_tour(home: Page) -> None:
    """Light and dark are kept."""
    cards = home.locator("a.scene-card")
    expect(cards.locator(".name")).to_have_text([scene.title for scene in SCENES.values()])
    expect(cards.locator(".claim")).to_have_text([scene.headline for scene in SCENES.values()])
    card = cards.filter(has_text="Coupled")
    for opens in (lambda: card.click(), lambda: card.press("Enter")):
        card.hover()
        fetched = f'head link[rel=prefetch][href="assets/{card.get_attribute("data-sheet")}"]'
        expect(home.locator(fetched)).to_be_attached()  # before it is pressed
        opens()
        home.wait_for_function(READY)
        expect(home.get_by_role("heading", level=1)).to_have_text(SCENES["coupled"].headline)
        home.locator(".brand").click()
        expect(home.get_by_role("heading", level=1)).to_have_text("Pull a mass and see how it oscillates")
    home.locator("#theme").click()
    theme = home.evaluate("document.documentElement.dataset.theme")
    home.reload()
    assert home.evaluate("document.documentElement.dataset.theme") == theme == "dark"
    filled = home.locator("body :is(a, button)").evaluate_all(INK)
    assert filled == ["Start here five questions, ten minutes"]
    home.get_by_role("link", name="Start here").click()
    home.wait_for_function(READY)
    expect(home.locator(".card-head span")).to_contain_text("1 of 5")


def test_nothing_leaves_any_screen_all_can_be_hit_and_is_read_in_the_order_in_which_it_is_seen(home: Page) -> None:
    """Pictures move unless motion is reduced."""
    for width, height in looks.GRID:
        home.set_viewport_size({"width": width, "height": height})
        leaves = [one for one in looks.faults(home) if one.startswith(("cut", "the page"))]  # pictures have small type
        assert leaves == [], (width, height)
    home.set_viewport_size({"width": 390, "height": 844})
    assert looks.of(home, looks.TARGETS, given=24) == []
    tops = home.locator("h1, h2, a:visible, button:visible, input:visible").evaluate_all(TOPS)
    assert tops == pytest.approx(sorted(tops), abs=8)
    home.emulate_media(reduced_motion="reduce")
    home.reload()
    home.locator("a.scene-card").first.hover()
    before = home.evaluate(PLACES)
    home.evaluate(PASSED, 10)
    assert home.evaluate(PLACES) == before
    home.emulate_media(reduced_motion="no-preference")
    home.wait_for_function(f"before => {PLACES} !== before", arg=before)
    home.emulate_media(media="print")
    expect(home.locator("a.scene-card:visible")).to_have_count(len(SCENES))
    expect(home.get_by_role("link", name="Start here")).to_be_hidden()


def test_a_code_that_no_class_has_is_said_and_stays(quiet: Open, server: Server) -> None:
    page = quiet(390, 844, has_touch=True, is_mobile=True)  # the browser logs the refusal
    page.goto(server.url)
    assert looks.of(page, looks.FIELDS) == []
    field = page.get_by_label("In a live class?")
    field.fill("ZZZZ")
    page.keyboard.press("Enter")
    expect(page.locator("#no-class")).to_have_text("No class has this code now. A code has four letters and digits.")
    expect(field).to_be_focused()
    expect(field).to_have_value("ZZZZ")


@pytest.fixture
def shown(quiet: Open, framed: Server, tmp_path: Path) -> Iterator[Callable[[str], Page]]:
    """Shows a page of another origin."""

    def visit(html: str) -> Page:
        html = f"<!DOCTYPE html><title>A course</title>{html}".replace("https://lecture.example/", framed.url)
        (tmp_path / "course.html").write_text(html, encoding="utf-8")
        page = quiet(height=900, reduced_motion="reduce")
        page.goto(f"http://127.0.0.1:{served.server_port}/course.html")
        return page

    with ThreadingHTTPServer(("127.0.0.1", 0), partial(SimpleHTTPRequestHandler, directory=tmp_path)) as served:
        Thread(target=served.serve_forever, daemon=True).start()
        yield visit
        served.shutdown()


@pytest.mark.slow  # it starts a server
def test_a_frame_reports_its_height_takes_no_focus_and_copies_its_link(shown: Callable[[str], Page]) -> None:
    """If a page may not copy, it shows the link instead."""
    low = FRAME.replace('height="760"', 'height="500"')
    page = shown(f"<label>Name <input></label>{low}{LISTENER}")
    name, frame = page.get_by_label("Name"), page.frames[1]
    name.focus()
    frame.wait_for_function(READY)
    expect(frame.locator("h1")).to_have_text("Every free motion is a slow mode plus a fast mode")
    assert frame.evaluate("oscillations.shown.state.parameters.k2") == 3
    page.wait_for_function("document.querySelector('iframe').height !== '500'")
    frame.wait_for_function("document.documentElement.scrollHeight <= innerHeight + 1")
    expect(name).to_be_focused()
    frame.get_by_text("Save and share").click()
    frame.get_by_role("button", name="Copy link").click()
    expect(frame.get_by_role("button", name="Copied")).to_be_visible()
    name.press("ControlOrMeta+v")
    expect(name).to_have_value(re.compile(r"\?scene=coupled&k2=3(&|$)"))
    out = frame.get_by_role("link", name="Open in a tab")
    out.focus()
    expect(out).to_have_attribute("href", re.compile(r"^\?scene=coupled&k2=3(&|$)"))
    expect(out).to_have_attribute("target", "_blank")
    name.focus()
    frame.evaluate("oscillations.open({scene: 'modes'})")
    expect(frame.locator("h1")).to_have_text(SCENES["modes"].headline)
    expect(name).to_be_focused()
    page.evaluate("document.querySelector('iframe').width = 420")
    frame.wait_for_function("innerWidth === 420 && document.documentElement.scrollHeight <= innerHeight + 1")
    frame.evaluate("document.execCommand = () => false")
    frame.evaluate(UNFOLD)
    frame.get_by_role("button", name="Copy link").click()
    field = frame.get_by_role("textbox", name="Link", exact=True)
    expect(field).to_have_value(re.compile(r"\?scene=modes"))
    expect(field).to_be_focused()
    assert field.evaluate("one => one.selectionEnd - one.selectionStart === one.value.length")
