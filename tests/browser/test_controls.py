"""Fields, sliders, help, tabs, navigation and announcements, with a mouse, with keys and for screen readers."""

import math
import re

import pytest
from playwright.sync_api import Locator, Page, expect

from components.scenes import SCENES
from tests.browser.fixtures import Open
from tests.browser.looks import GRID, TAUGHT, faults
from tests.browser.waiting import Finger, clicked, is_shown, middle, passed, stroke, turned, typed, value
from tests.grids import sample

pytestmark = pytest.mark.browser
AT = "id => oscillations.shown.state.step === id && oscillations.walks.walk?.card"
ASKED = "oscillations.walks.walk?.card && !oscillations.walks.walk.lesson && oscillations.shown.state.covered.length"
TWICE = """() => {
  for (const type of ["keydown", "keyup", "keydown", "keyup"])
    document.body.dispatchEvent(new KeyboardEvent(type, {key: "PageDown", bubbles: true, cancelable: true}))
  globalThis.pressed = performance.now()
}"""
"""Two presses at once."""
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


def field(page: Page, name: str) -> Locator:
    return page.locator(f".panel input[name={name}]")


def slider(page: Page, name: str) -> Locator:
    return page.locator(f".panel input[name={name}-slider]")


def problem(page: Page, name: str) -> Locator:
    return page.locator(f"#problem-{name}")


def test_a_slider_has_a_name_and_sets_its_value_by_mouse_and_keys(desk: Page) -> None:
    """Keys go to the next value, by two digits where the scale is logarithmic, and by decades or tenths."""
    turned(desk, "coupled", {})
    for part in (field(desk, "x1_0"), slider(desk, "x1_0")):
        expect(part).to_have_accessible_name("x1, displacement of mass 1, m")
    expect(field(desk, "k2")).to_have_value("2.00")
    expect(slider(desk, "k2")).to_have_attribute("aria-valuetext", "2.00 N/m")
    both = desk.get_by_role("button", name="Both", exact=True)
    expect(both).to_have_attribute("aria-pressed", "true")
    slider(desk, "m1").fill("0.5")
    expect(slider(desk, "m1")).to_be_focused()
    expect(field(desk, "m1")).to_have_value("0.316")
    assert value(desk, "m1") == 0.316
    expect(both).to_have_attribute("aria-pressed", "false")
    for name, start, presses in (
        ("k2", "0", ("ArrowRight 0.0100", "ArrowLeft 0.00", "ArrowLeft 0.00")),
        ("m1", "0.123", ("ArrowRight 0.130", "ArrowLeft 0.120", "PageUp 1.20")),
        ("m1", "0.0120", ("PageDown 0.0100", "ArrowLeft 0.0100")),
        ("x1_0", "0", ("PageUp 0.400",)),
    ):
        typed(desk, name, start)
        is_shown(desk, **{name: start})
        for key, shown in map(str.split, presses):
            slider(desk, name).press(key)
            expect(field(desk, name)).to_have_value(shown)


def test_a_finger_moves_a_slider_sideways_only(phone: Page) -> None:
    turned(phone, "coupled", {})
    for across, down, moves in ((0, 60, False), (5, 2, False), (60, 4, True)):
        before = value(phone, "k2")
        x, y = middle(slider(phone, "k2"))
        stroke(Finger(phone), [(x + across * step / 5, y + down * step / 5) for step in range(6)])
        passed(phone)
        assert (value(phone, "k2") != before) is moves, (across, down)


def test_a_digit_typed_on_a_slider_goes_to_its_field_and_a_field_takes_what_people_type(desk: Page) -> None:
    """One Tab stop for each parameter; a long number is shortened, and whole while it has the focus."""
    turned(desk, "coupled", {})
    slider(desk, "k1").focus()
    desk.keyboard.press("Tab")
    expect(slider(desk, "k2")).to_be_focused()
    for name, text, number in (("k2", "7.5", 7.5), ("k2", ".5", 0.5), ("x1_0", "-0,4", -0.4)):
        slider(desk, name).focus()
        desk.keyboard.type(text)
        expect(field(desk, name)).to_be_focused()
        expect(field(desk, name)).to_have_value(text)
        desk.keyboard.press("Enter")
        is_shown(desk, **{name: number})
    for text, number in (("1,5·10^3 N/m", 1500), ("3 kg", 1500), ("1/3", 1 / 3)):
        typed(desk, "k2", text)
        assert value(desk, "k2") == number
        if "kg" in text:
            says = "“3 kg” is in kg, and this is in N/m: type a number in N/m. Still drawn with 1500."
            expect(problem(desk, "k2")).to_have_text(says)
    k2, whole = field(desk, "k2"), "0.3333333333333333"
    for _ in range(2):
        expect(k2).to_have_value(whole)
        k2.blur()
        expect(k2).to_have_value(re.compile(r"^0\.33\d{0,7}…?$"))  # it is measured with the next frame
        assert k2.evaluate("field => field.scrollWidth <= field.clientWidth")
        expect(k2).to_have_attribute("title", whole)
        k2.focus()
    k2.blur()
    assert value(desk, "k2") == 1 / 3


def test_refused_text_stays_with_its_reason_until_it_is_corrected(desk: Page) -> None:
    turned(desk, "coupled", {})
    k2, why = field(desk, "k2"), problem(desk, "k2")
    typed(desk, "k2", "-3")
    says = "−3 N/m is not possible: a stiffness is a finite number, 0 or more. Still drawn with 2.00."
    expect(why).to_have_text(says)
    expect(k2).to_have_attribute("aria-invalid", "true")
    expect(k2).to_have_accessible_description(re.compile("not possible.*k2 "))
    typed(desk, "m1", "4")
    expect(field(desk, "m1")).to_have_value("4.00")
    expect(k2).to_have_value("-3")
    typed(desk, "k2", "3")
    expect(why).to_be_hidden()
    expect(k2).to_have_value("3.00")
    expect(k2).not_to_have_attribute("aria-invalid", "true")
    typed(desk, "k2", "much")
    expect(why).to_be_visible()
    k2.press("Escape")
    expect(why).to_be_hidden()
    expect(k2).to_have_value("3.00")
    k2.fill("7.")
    desk.evaluate("oscillations.send({type: 'set', values: {m1: 3}})")
    expect(field(desk, "m1")).to_have_value("3.00")
    expect(k2).to_have_value("7.")  # an answer does not overwrite what a hand is setting
    k2.press("Escape")
    turned(desk, "coupled", {"m1": 5e-324})
    slider(desk, "k2").fill("0.9")
    expect(why).to_contain_text("outside the range of doubles")
    expect(k2).to_have_value("72.9")
    expect(slider(desk, "k2")).to_have_attribute("aria-valuetext", "2.00 N/m")


def test_each_slider_and_field_is_described_by_its_own_help(desk: Page) -> None:
    """The help of the part that has the focus is visible, also of a handle over a plot."""
    turned(desk, "coupled", {})
    says = desk.locator("#controls-says")
    slider(desk, "k2").focus()
    expect(says).to_have_text(re.compile("^k2 couples the masses.*any value from 0 up.$"))
    typing = "Type a digit to open the field; Enter sets the number, Escape cancels."
    for part in (slider(desk, "m1"), field(desk, "m1")):
        expect(part).to_have_accessible_description(re.compile(f"^m1 is .*Type any value above 0. {typing}$"))
    field(desk, "m1").focus()
    expect(says).to_have_text(re.compile("^m1 is .*Type any value above 0.$"))
    field(desk, "m1").blur()
    expect(says).to_have_text("")
    turned(desk, "forced", {})
    handle = desk.get_by_role("slider", name="Drive frequency", exact=True)
    handle.focus()
    expect(says).to_have_text("ω is the drive frequency. Type any value from 0 up.")
    desk.get_by_role("tab", name="Motion").focus()
    expect(handle).to_have_accessible_description(re.compile("^ω is the drive frequency. Type any value from 0 up."))
    expect(says).to_have_text("")


def playing(page: Page) -> bool:
    return bool(page.evaluate("oscillations.clock.playing"))


def test_keys_of_a_scene(desk: Page) -> None:
    """None acts while something is typed. The key that ends a blank screen does nothing else."""
    now = "oscillations.clock.t"
    turned(desk, "coupled", {})
    before = playing(desk)
    desk.keyboard.press("Space")
    assert playing(desk) is not before
    desk.keyboard.press("]")
    later = desk.evaluate(now)
    assert later > 0 and not playing(desk)
    desk.keyboard.press("[")
    assert desk.evaluate(now) < later
    desk.keyboard.press("]")
    desk.keyboard.press("Home")
    assert desk.evaluate(now) == 0
    desk.keyboard.press("2")
    desk.wait_for_function("oscillations.shown.preset === oscillations.page.spec.panel.presets[1].name")
    before = playing(desk)
    for key, count in (("b", 1), ("Space", 0), (".", 1), (".", 0)):  # a clicker sends the same one again
        desk.keyboard.press(key)
        expect(desk.locator(".blank")).to_have_count(count)
    assert playing(desk) is before
    state = desk.evaluate("[oscillations.clock.playing, oscillations.shown.preset]")
    field(desk, "k2").fill("")
    field(desk, "k2").press_sequentially("2 fwb?.")
    expect(field(desk, "k2")).to_have_value("2 fwb?.")
    assert desk.locator(".blank, dialog.keys, .walks[open]").count() == 0
    assert desk.evaluate("[oscillations.clock.playing, oscillations.shown.preset]") == state


def test_the_list_names_each_key_and_single_letters_can_be_switched_off(desk: Page) -> None:
    turned(desk, "coupled", {})
    desk.keyboard.press("?")
    keys = desk.get_by_role("dialog", name="Keys")
    expect(keys.get_by_role("button", name="Close", exact=True)).to_be_focused()
    before = playing(desk)
    keys.get_by_role("button", name="Play or pause").click()
    assert playing(desk) is not before
    keys.get_by_label("Single-letter shortcuts on").uncheck()
    keys.get_by_role("button", name="Close", exact=True).click()
    desk.keyboard.press("b")
    desk.keyboard.press("?")
    keys.get_by_label("Single-letter shortcuts on").check()
    desk.keyboard.press("Escape")
    expect(keys).to_have_count(0)
    for count in (1, 0):  # the first “b” did nothing
        desk.keyboard.press("b")
        expect(desk.locator(".blank")).to_have_count(count)


def test_a_clicker_leads_through_a_walk_and_takes_an_answer_back(page: Page, open_scene: Open) -> None:
    """Two presses at once are one. It closes the topmost dialog first."""
    open_scene(page, walk="d34", step="d34-02")
    page.wait_for_function(AT, arg="d34/d34-02")
    page.keyboard.press("Space")
    assert not playing(page), "nothing plays before the answer"
    page.keyboard.press("2")
    expect(page.locator(".answers button").nth(1)).to_have_attribute("aria-pressed", "true")
    keys, walks = page.get_by_role("button", name="Keys"), page.locator(".walks summary")
    for shut, opener in (("dialog.keys", keys), (".walks[open]", walks)):
        opener.click()
        expect(page.locator(shut)).to_be_visible()
        clicked(page)
        expect(page.locator(shut)).to_have_count(0)
        assert not page.evaluate(TAUGHT)
    page.wait_for_function("performance.now() > pressed + 420")
    page.evaluate(TWICE)
    page.wait_for_function(TAUGHT)
    clicked(page, "PageUp")
    page.wait_for_function(ASKED)
    clicked(page)
    page.wait_for_function(TAUGHT)
    formulas = page.locator(".card .follows .lines")
    expect(formulas).to_be_hidden()
    for key, visible in (("PageDown", True), ("PageUp", False), ("PageDown", True)):
        clicked(page, key)
        expect(formulas).to_be_visible(visible=visible)
    clicked(page)
    page.wait_for_function(AT, arg="d34/d34-03")
    clicked(page, "PageUp")
    page.wait_for_function(AT, arg="d34/d34-02")
    page.keyboard.press("Escape")
    expect(page.locator(".card")).to_be_visible()  # Esc never leaves a walk


def test_the_tab_key_goes_round_is_seen_everywhere_and_changes_nothing(new_page: Open, open_scene: Open) -> None:
    """It begins with links to the picture and to the controls. Each stop of the paper has its own name."""
    page = open_scene(new_page(reduced_motion="reduce"), folded=True, scene="energy")
    assert not playing(page)
    expect(page.get_by_role("button", name="Play", exact=True)).to_be_visible()
    state, stops, unseen = page.evaluate("JSON.stringify(oscillations.shown.state)"), list[str](), list[str]()
    for _ in range(150):
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
    assert desk.locator(f"#{desk.get_by_role('tab').first.get_attribute('aria-controls')}[role=tabpanel]").count() == 1
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
    for key in ("Enter", "Tab", "Enter"):
        desk.keyboard.press(key)
    expect(desk.locator("h1")).to_have_text(SCENES["oscillator"].headline)
    expect(links).to_have_text([scene.title for scene in SCENES.values() if scene.lecture == "D31"])


def test_on_a_narrow_screen_all_scenes_are_in_one_list_and_turning_keeps_the_focus(desk: Page) -> None:
    """On no screen the navigation runs into anything."""
    turned(desk, "coupled", {})
    for width, height in sample(GRID, 4):
        desk.set_viewport_size({"width": width, "height": height})
        assert [fault for fault in faults(desk) if "nav: " in fault] == [], (width, height)
    links, theme = desk.locator(".nav .scenes a:visible"), desk.locator("#theme")
    for width, height, to in ((820, 900, "energy"), (390, 844, "phugoid"), (320, 640, "energy")):
        theme.focus()
        desk.set_viewport_size({"width": width, "height": height})
        passed(desk)
        expect(theme).to_be_focused()
        desk.locator(".scene-menu summary").click()
        expect(links).to_have_text([scene.title for scene in SCENES.values()])
        expect(desk.locator(".nav .scene-group > button:visible")).to_have_count(0)
        # The open list may cover the page.
        assert [one for one in faults(desk) if all("nav: " in part for part in one.split(" | "))] == [], width
        desk.locator(f".nav .scenes a[data-scene={to}]").click()
        expect(desk.locator("h1")).to_have_text(SCENES[to].headline)
        expect(links).to_have_count(0)


def test_a_plot_is_described_by_its_motion_and_a_change_announced_in_one_sentence(desk: Page) -> None:
    """A turning point is where the motion turns, not at the nearest drawn point. The figure has the description."""
    turned(desk, "oscillator", {})
    scene = SCENES["oscillator"]()
    omega_n = math.sqrt(scene.k / scene.m)
    lowest = (math.pi + math.atan2(scene.v_0 / omega_n, scene.x_0)) / omega_n
    depth = math.hypot(scene.x_0, scene.v_0 / omega_n)
    expect(desk.locator("#says-x")).to_contain_text(f"lowest −{depth:.3g} m at {lowest:.3g} s, highest")
    told = re.compile(r"^Displacement against time\. Horizontal axis 0 s to 2 s")
    figure = desk.get_by_role("img", name="Displacement against time")
    expect(figure).to_have_accessible_description(told)
    turned(desk, "coupled", {})
    expect(desk.locator("#says-x1")).not_to_be_empty()
    heard = desk.locator(".page > [role=status]")
    expect(heard).to_have_text("")
    before, now = SCENES["coupled"]().shown.values, SCENES["coupled"](k2=3.0).shown.values
    desk.evaluate("oscillations.send({type: 'set', values: {k2: 3}})")
    parts = (("Slow mode", "omega_minus", "rad/s"), ("fast mode", "omega_plus", "rad/s"), ("energy", "E_total", "J"))
    said = "; ".join(f"{name} {now[key]} {unit}, was {before[key]} {unit}" for name, key, unit in parts)
    expect(heard).to_have_text(f"{said}.")
    desk.evaluate("oscillations.send({type: 'set', values: {v1_0: 1}})")
    expect(heard).to_have_text(re.compile(r"^Energy [\d.]+ J, was [\d.]+ J; unchanged: slow mode, fast mode\.$"))
    state = "{...oscillations.shown.state, covered: ['value:omega_minus', 'plot:x2']}"
    desk.evaluate(f"oscillations.send({{type: 'open', state: {state}}})")
    desk.evaluate("oscillations.send({type: 'set', values: {k1: 9}})")
    expect(heard).to_have_text(re.compile("^Fast mode .*"))
    assert "slow" not in (heard.text_content() or "").lower(), "a hidden number is announced"
    expect(desk.locator("#says-x2")).to_have_text(re.compile(r"Covered until you press Reveal\.$"))
