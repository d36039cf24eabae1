"""The page by keys and for screen readers: the Tab key, tabs, the navigation, forced colours, what is announced."""

import math
import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from tests.browser import looks
from tests.browser.fixtures import READY
from tests.browser.looks import GRID, faults
from tests.browser.waiting import passed, turned
from tests.serving.server import Server

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
MOST_STOPS = 150
STOP = """() => {
  const one = document.activeElement
  const name = (one.getAttribute("aria-label") || one.labels?.[0]?.textContent || one.textContent).trim()
  for (let at = one; at && at !== document.body; at = at.parentElement) {
    const {outlineStyle, outlineWidth} = getComputedStyle(at)
    if (outlineStyle !== "none" && parseFloat(outlineWidth) >= 2) return [name, true]
  }
  return [name, one === document.body || one.matches("input[type=range]")]
}"""
"""The name of the part with the focus, and whether its focus is visible."""


def test_the_tab_key_goes_round_is_seen_everywhere_and_changes_nothing(
    new_page: Callable[..., Page], open_scene: Open
) -> None:
    """It begins with links to the picture and to the controls. Each stop of the paper has its own name."""
    page = open_scene(new_page(reduced_motion="reduce"), folded=True, scene="energy")
    assert page.evaluate("oscillations.clock.playing") is False
    expect(page.get_by_role("button", name="Play", exact=True)).to_be_visible()
    state, stops, unseen = page.evaluate("JSON.stringify(oscillations.shown.state)"), list[str](), list[str]()
    for _ in range(MOST_STOPS):
        page.keyboard.press("Tab")
        name, seen = page.evaluate(STOP)
        unseen += [] if seen else [name]
        if stops and name == stops[0]:
            break
        stops.append(name)
    else:
        pytest.fail("the Tab key does not come back")
    assert unseen == []
    assert page.evaluate("JSON.stringify(oscillations.shown.state)") == state
    assert stops[:2] == ["Skip to the picture", "Skip to the controls"]
    assert not {*page.evaluate("oscillations.plots.map(p => p.block.title)")} & {*stops}, "keys do nothing there"
    paper = stops[stops.index("Light or dark") + 1 : stops.index("Restart")]
    assert len({*paper}) == len(paper) and "Kinetic energy: T" in paper
    assert any(name.startswith("Time,") for name in paper)
    page.keyboard.press("Tab")
    link = page.get_by_role("link", name="Skip to the controls")
    expect(link).to_be_focused()
    expect(link).to_be_in_viewport()
    page.keyboard.press("Enter")
    expect(page.get_by_role("complementary", name="Controls")).to_be_focused()


def test_tabs_are_chosen_by_keys_and_the_focus_goes_along(desk: Page) -> None:
    names = [view.name for view in SCENES["damped"].views]
    turned(desk, "damped", {"view": SCENES["damped"].views[0].slug})
    desk.locator("h1").focus()
    for key, name in ((";", names[1]), (",", names[0])):
        desk.keyboard.press(key)
        expect(desk.get_by_role("tab", selected=True)).to_have_text(name)
    desk.get_by_role("tab").first.focus()
    for key, name in (("ArrowLeft", names[-1]), ("Home", names[0]), ("End", names[-1]), ("ArrowRight", names[0])):
        desk.keyboard.press(key)
        expect(desk.get_by_role("tab", name=name, exact=True)).to_be_focused()
    controlled = desk.get_by_role("tab").first.get_attribute("aria-controls")
    assert desk.locator(f"#{controlled}[role=tabpanel]").count() == 1
    desk.get_by_role("button", name="Undo").click()
    expect(desk.get_by_role("tab", selected=True)).to_have_text(names[-1])


def test_forced_colours_distinguish_pressed_buttons_and_the_current_page(desk: Page) -> None:
    shown = "one => (s => [s.backgroundColor, s.borderBottomColor, s.outlineStyle].join())(getComputedStyle(one))"
    turned(desk, "coupled", {})
    for scheme in ("light", "dark"):
        desk.emulate_media(forced_colors="active", color_scheme=scheme)
        for pressed, other in (
            (".chip[aria-pressed=true]", ".chip[aria-pressed=false]"),
            (".group .seg [aria-pressed=true]", ".group .seg [aria-pressed=false]"),
            (".nav nav [aria-current=page]", ".nav nav a:not([aria-current])"),
        ):
            one, another = (desk.locator(selector).first.evaluate(shown) for selector in (pressed, other))
            assert one != another, (scheme, pressed)
        adjusted = "one => getComputedStyle(one).forcedColorAdjust"
        assert desk.locator("input[type=range]").first.evaluate(adjusted) == "none", "its track has its colours"
    desk.emulate_media(forced_colors="none", color_scheme="light")


def test_a_step_of_a_walk_is_read_in_order_and_its_fields_do_not_zoom(
    new_page: Callable[..., Page], server: Server
) -> None:
    """Before and after its answer. Nor do those of the start page and of an own question."""
    phone = new_page(390, 844, has_touch=True, is_mobile=True)
    for step in ("tour/tour-03", "d34/d34-05", "d34/d34-16"):
        walk, name = step.split("/")
        phone.goto(f"{server.url}?walk={walk}&step={name}")
        phone.wait_for_function(f"{READY} && document.querySelector('.asked .card')")
        found = looks.of(phone, looks.ORDER, looks.FIELDS)
        phone.evaluate("oscillations.walks.walk.show(true)")
        phone.wait_for_function("oscillations.walks.walk.lesson && !document.querySelector('.asked')")
        found += looks.of(phone, looks.ORDER)
        assert not found, (step, found)
    for address, part in (("?scene=coupled#ask", ".asking select"), ("", "#code")):
        phone.goto(server.url + address)
        phone.wait_for_function(f"document.querySelector('{part}')")
        assert looks.of(phone, looks.FIELDS) == [], address


def of_navigation(page: Page) -> list[str]:
    """Parts of the navigation that are cut or overlap each other; an open list may cover the page."""
    return [fault for fault in faults(page) if all("nav: " in part for part in fault.split(" | "))]


def test_a_folded_lecture_opens_by_mouse_and_keys(desk: Page) -> None:
    turned(desk, "coupled", {})
    links, first = desk.locator(".nav .scenes a:visible"), desk.locator(".nav .scene-group > button:visible").first
    expect(links).to_have_text([scene.title for scene in SCENES.values() if scene.lecture == "D34"])
    first.click()
    expect(first).to_have_attribute("aria-expanded", "true")
    desk.locator(".panel").click(position={"x": 4, "y": 4})
    expect(first).to_have_attribute("aria-expanded", "false")
    first.focus()
    for key, title in (("ArrowDown", "Oscillator"), ("ArrowDown", "Energy"), ("ArrowUp", "Oscillator")):
        desk.keyboard.press(key)
        expect(desk.get_by_role("link", name=title)).to_be_focused()
    desk.keyboard.press("Escape")
    expect(first).to_be_focused()
    expect(first).to_have_attribute("aria-expanded", "false")
    for key in ("Enter", "Tab", "Enter"):
        desk.keyboard.press(key)
    expect(desk.locator("h1")).to_have_text(SCENES["oscillator"].headline)
    expect(links).to_have_text([scene.title for scene in SCENES.values() if scene.lecture == "D31"])


def test_on_a_narrow_screen_all_scenes_are_in_one_list_and_turning_keeps_the_focus(desk: Page) -> None:
    """On no screen the navigation runs into anything."""
    off_line = """() => {
      const range = document.createRange()
      range.selectNodeContents(document.querySelector(".scene-menu summary"))
      const [text, line] = [range, document.querySelector(".nav")].map(one => one.getBoundingClientRect())
      return Math.abs(text.top + text.bottom - line.top - line.bottom) / 2
    }"""
    turned(desk, "coupled", {})
    found = []
    for width, height in GRID:
        desk.set_viewport_size({"width": width, "height": height})
        found += [f"{width} x {height}: {fault}" for fault in of_navigation(desk)]
    assert not found, "\n".join(found)
    links, theme = desk.locator(".nav .scenes a:visible"), desk.locator("#theme")
    for width, height, to in ((820, 900, "energy"), (390, 844, "phugoid"), (320, 640, "energy")):
        theme.focus()
        desk.set_viewport_size({"width": width, "height": height})
        passed(desk)
        expect(theme).to_be_focused()
        assert desk.evaluate(off_line) < 1, "the scene is in the middle of its line"
        desk.locator(".scene-menu summary").click()
        expect(links).to_have_text([scene.title for scene in SCENES.values()])
        expect(desk.locator(".nav .scene-group > button:visible")).to_have_count(0)
        assert of_navigation(desk) == [], width
        desk.locator(f".nav .scenes a[data-scene={to}]").click()
        expect(desk.locator("h1")).to_have_text(SCENES[to].headline)
        expect(links).to_have_count(0)
    desk.set_viewport_size({"width": 1280, "height": 720})


HEARD = ".page > [role=status]"


def described(page: Page, name: str) -> str:
    """Return the description of a plot, once it has one."""
    page.wait_for_function('name => document.getElementById(`says-${name}`)?.textContent !== ""', arg=name)
    return str(page.evaluate("name => document.getElementById(`says-${name}`).textContent", name))


def test_a_change_is_announced_in_one_sentence_of_the_scenes_values(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    described(page, "x1")
    heard = page.locator(HEARD)
    expect(heard).to_have_text("")
    before, now = SCENES["coupled"]().shown.values, SCENES["coupled"](k2=3.0).shown.values
    page.evaluate("oscillations.send({type: 'set', values: {k2: 3}})")
    parts = ("Slow mode omega_minus rad/s", "fast mode omega_plus rad/s", "energy E_total J")
    told = [
        f"{name} {now[key]} {unit}, was {before[key]} {unit}"
        for name, key, unit in (part.rsplit(maxsplit=2) for part in parts)
    ]
    expect(heard).to_have_text("; ".join(told) + ".")
    page.evaluate("oscillations.send({type: 'set', values: {v1_0: 1}})")
    expect(heard).to_have_text(re.compile(r"^Energy [\d.]+ J, was [\d.]+ J; unchanged: slow mode, fast mode\.$"))
    state = "{...oscillations.shown.state, covered: ['value:omega_minus', 'plot:x2']}"
    page.evaluate(f"oscillations.send({{type: 'open', state: {state}}})")
    page.evaluate("oscillations.send({type: 'set', values: {k1: 9}})")
    expect(heard).to_have_text(re.compile("^Fast mode .*"))
    assert "slow" not in (heard.text_content() or "").lower(), "a hidden number is announced"
    assert described(page, "x2").endswith("Covered until you press Reveal.")
    open_scene(page, walk="d31", step="d31-04")
    assert described(page, "x").endswith("Covered until you press Show the answer.")


def test_a_turning_point_is_described_where_the_motion_turns(page: Page, open_scene: Open) -> None:
    """Not at the nearest drawn point. The figure has the description as its own."""
    open_scene(page, scene="oscillator")
    scene = SCENES["oscillator"]()
    omega_n = math.sqrt(scene.k / scene.m)
    lowest = (math.pi + math.atan2(scene.v_0 / omega_n, scene.x_0)) / omega_n
    depth = math.hypot(scene.x_0, scene.v_0 / omega_n)
    assert f"lowest −{depth:.3g} m at {lowest:.3g} s, highest" in described(page, "x")
    figure = page.get_by_role("img", name="Displacement against time")
    told = re.compile(r"^Displacement against time\. Horizontal axis 0 s to 2 s")
    expect(figure).to_have_accessible_description(told)
