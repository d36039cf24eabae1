"""The page by keys: where the Tab key leads, tabs, the navigation; forced colours; a phone that is turned."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from tests.browser import looks
from tests.browser.boxes import faults
from tests.browser.fixtures import READY
from tests.browser.views import GRID
from tests.browser.waiting import passed, turned, unfold
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


def test_turning_a_phone_keeps_the_focus(phone: Page) -> None:
    turned(phone, "forced", {"view": "response"})
    slider = phone.locator("input[name=omega-slider]")
    for width, height in ((844, 390), (1280, 720), (390, 844)):
        slider.focus()
        phone.set_viewport_size({"width": width, "height": height})
        passed(phone)
        expect(slider).to_be_focused()


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
    phone.goto(f"{server.url}?scene=coupled")
    phone.wait_for_function(READY)
    unfold(phone)
    phone.evaluate("document.getElementById('ask').click()")
    phone.wait_for_function("document.querySelector('.asking select')")
    assert looks.of(phone, looks.FIELDS) == []
    phone.goto(server.url)
    phone.wait_for_function("document.querySelector('#code')")
    assert looks.of(phone, looks.FIELDS) == []


def of_navigation(page: Page) -> list[str]:
    """Parts of the navigation that are cut or overlap each other; an open list may cover the page."""
    return [fault for fault in faults(page) if all("nav: " in part for part in fault.split(" | "))]


def test_the_navigation_runs_into_nothing_and_has_room_for_thirteen_scenes(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    found = []
    for size in GRID:
        page.set_viewport_size({"width": size[0], "height": size[1]})
        found += [f"{size}: {fault}" for fault in of_navigation(page)]
    page.evaluate(
        """count => {
      const last = [...document.querySelectorAll(".nav .scene-group")].at(-1), own = last.cloneNode(true)
      const links = [...Array(count)].map(() => last.querySelector("a").cloneNode(true))
      own.querySelector(".lecture").textContent = own.querySelector("button").textContent = "Beyond the slides"
      own.querySelector(".scenes").replaceChildren(...links)
      if (count) last.after(own)
    }""",
        13 - len(SCENES),
    )
    for width in (1000, 1024, 1160, 1280, 1519, 1520, 1920):
        page.set_viewport_size({"width": width, "height": 800})
        found += [f"{width} px, thirteen scenes: {fault}" for fault in of_navigation(page)]
    assert not found, "\n".join(found)


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


def test_on_a_narrow_screen_all_scenes_are_in_one_list(desk: Page) -> None:
    off_line = """() => {
      const range = document.createRange()
      range.selectNodeContents(document.querySelector(".scene-menu summary"))
      const [text, line] = [range, document.querySelector(".nav")].map(one => one.getBoundingClientRect())
      return Math.abs(text.top + text.bottom - line.top - line.bottom) / 2
    }"""
    turned(desk, "coupled", {})
    links = desk.locator(".nav .scenes a:visible")
    for width, height, to in ((820, 900, "energy"), (390, 844, "phugoid"), (320, 640, "energy")):
        desk.set_viewport_size({"width": width, "height": height})
        assert desk.evaluate(off_line) < 1, "the scene is in the middle of its line"
        desk.locator(".scene-menu summary").click()
        expect(links).to_have_text([scene.title for scene in SCENES.values()])
        expect(desk.locator(".nav .scene-group > button:visible")).to_have_count(0)
        assert of_navigation(desk) == [], width
        desk.locator(f".nav .scenes a[data-scene={to}]").click()
        expect(desk.locator("h1")).to_have_text(SCENES[to].headline)
        expect(links).to_have_count(0)
    desk.set_viewport_size({"width": 1280, "height": 720})
