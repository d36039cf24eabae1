"""The control panel: fields, sliders, refusals, help; keys of a scene and of a clicker."""

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.looks import TAUGHT
from tests.browser.touch import Finger, middle, stroke, value
from tests.browser.waiting import clicked, is_shown, passed, turned, typed

pytestmark = pytest.mark.browser
Open = Callable[..., Page]


def field(page: Page, name: str) -> Locator:
    return page.locator(f".panel input[name={name}]")


def slider(page: Page, name: str) -> Locator:
    return page.locator(f".panel input[name={name}-slider]")


def problem(page: Page, name: str) -> Locator:
    return page.locator(f"#problem-{name}")


def test_a_slider_has_a_name_and_sets_its_value_by_mouse_and_keys(desk: Page) -> None:
    """Keys go to the next value, by two digits where the scale is logarithmic, and by decades or tenths."""
    turned(desk, "coupled", {})
    for name, label in (
        ("m1", "m1, mass, kg"),
        ("k2", "k2, stiffness, N/m"),
        ("x1_0", "x1, displacement of mass 1, m"),
    ):
        expect(field(desk, name)).to_have_accessible_name(label)
        expect(slider(desk, name)).to_have_accessible_name(label)
    expect(field(desk, "k2")).to_have_value("2.00")
    expect(slider(desk, "k2")).to_have_attribute("aria-valuetext", "2.00 N/m")
    both = desk.get_by_role("button", name="Both", exact=True)
    expect(both).to_have_attribute("aria-pressed", "true")
    slider(desk, "m1").focus()
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
            expect(problem(desk, "k2")).to_have_text(
                "“3 kg” is in kg, and this is in N/m: type a number in N/m. Still drawn with 1500."
            )
    expect(field(desk, "k2")).to_have_value("0.3333333333333333")
    field(desk, "k2").blur()
    expect(field(desk, "k2")).not_to_have_value("0.3333333333333333")  # it is measured with the next frame
    assert re.fullmatch(r"0\.33\d{0,7}…?", field(desk, "k2").input_value())
    assert field(desk, "k2").evaluate("field => field.scrollWidth <= field.clientWidth")
    expect(field(desk, "k2")).to_have_attribute("title", "0.3333333333333333")
    field(desk, "k2").focus()
    expect(field(desk, "k2")).to_have_value("0.3333333333333333")
    field(desk, "k2").blur()
    assert value(desk, "k2") == 1 / 3


def test_refused_text_stays_with_its_reason_until_it_is_corrected(desk: Page) -> None:
    turned(desk, "coupled", {})
    typed(desk, "k2", "-3")
    expect(problem(desk, "k2")).to_have_text(
        "−3 N/m is not possible: a stiffness is a finite number, 0 or more. Still drawn with 2.00."
    )
    expect(field(desk, "k2")).to_have_value("-3")
    expect(field(desk, "k2")).to_have_attribute("aria-invalid", "true")
    expect(field(desk, "k2")).to_have_accessible_description(re.compile("not possible.*k2 "))
    typed(desk, "m1", "4")
    expect(field(desk, "m1")).to_have_value("4.00")
    expect(field(desk, "k2")).to_have_value("-3")
    typed(desk, "k2", "3")
    expect(problem(desk, "k2")).to_be_hidden()
    expect(field(desk, "k2")).to_have_value("3.00")
    expect(field(desk, "k2")).not_to_have_attribute("aria-invalid", "true")
    typed(desk, "k2", "much")
    expect(problem(desk, "k2")).to_be_visible()
    field(desk, "k2").press("Escape")
    expect(problem(desk, "k2")).to_be_hidden()
    expect(field(desk, "k2")).to_have_value("3.00")
    field(desk, "k2").fill("7.")
    desk.evaluate("oscillations.send({type: 'set', values: {m1: 3}})")
    expect(field(desk, "m1")).to_have_value("3.00")
    expect(field(desk, "k2")).to_have_value("7.")  # an answer does not overwrite what a hand is setting
    field(desk, "k2").press("Escape")
    turned(desk, "coupled", {"m1": 5e-324})
    slider(desk, "k2").fill("0.9")
    expect(problem(desk, "k2")).to_contain_text("outside the range of doubles")
    expect(field(desk, "k2")).to_have_value("72.9")
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


AT = "id => oscillations.shown.state.step === id && oscillations.walks.walk?.card"
ASKED = "oscillations.walks.walk?.card && !oscillations.walks.walk.lesson && oscillations.shown.state.covered.length"
TWICE = """() => {
  for (const type of ["keydown", "keyup", "keydown", "keyup"])
    document.body.dispatchEvent(new KeyboardEvent(type, {key: "PageDown", bubbles: true, cancelable: true}))
  globalThis.pressed = performance.now()
}"""
"""Two presses at once."""


def playing(page: Page) -> bool:
    return bool(page.evaluate("oscillations.clock.playing"))


def test_keys_of_a_scene(page: Page, open_scene: Open) -> None:
    """None acts while something is typed. The key that ends a blank screen does nothing else."""
    now = "oscillations.clock.t"
    open_scene(page, scene="coupled")
    before = playing(page)
    page.keyboard.press("Space")
    assert playing(page) is not before
    page.keyboard.press("]")
    later = page.evaluate(now)
    assert later > 0 and not playing(page)
    page.keyboard.press("[")
    assert page.evaluate(now) < later
    page.keyboard.press("]")
    page.keyboard.press("Home")
    assert page.evaluate(now) == 0
    page.keyboard.press("2")
    page.wait_for_function("oscillations.shown.preset === oscillations.page.spec.panel.presets[1].name")
    page.keyboard.press("b")
    expect(page.locator(".blank")).to_be_visible()
    before = playing(page)
    page.keyboard.press("Space")
    expect(page.locator(".blank")).to_have_count(0)
    assert playing(page) is before
    for count in (1, 0):  # a clicker sends the same one again
        page.keyboard.press(".")
        expect(page.locator(".blank")).to_have_count(count)
    state = page.evaluate("[oscillations.clock.playing, oscillations.shown.preset]")
    field = page.locator(".panel input[name=k2]").last
    field.fill("")
    field.press_sequentially("2 fwb?.")
    assert field.input_value() == "2 fwb?."
    assert page.locator(".blank, dialog.keys, .walks[open]").count() == 0
    assert page.evaluate("[oscillations.clock.playing, oscillations.shown.preset]") == state


def test_the_list_names_each_key_and_single_letters_can_be_switched_off(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    page.keyboard.press("?")
    keys = page.get_by_role("dialog", name="Keys")
    expect(keys.get_by_role("button", name="Close", exact=True)).to_be_focused()
    before = playing(page)
    keys.get_by_role("button", name="Play or pause").click()
    assert playing(page) is not before
    keys.get_by_label("Single-letter shortcuts on").uncheck()
    keys.get_by_role("button", name="Close", exact=True).click()
    page.keyboard.press("b")
    assert page.locator(".blank").count() == 0
    page.keyboard.press("?")
    expect(keys).to_be_visible()
    keys.get_by_label("Single-letter shortcuts on").check()
    page.keyboard.press("Escape")
    expect(keys).to_have_count(0)
    page.keyboard.press("b")
    expect(page.locator(".blank")).to_be_visible()


def closes_the_topmost_dialog(page: Page) -> None:
    for shut, show in (("dialog.keys", "?"), (".walks[open]", None)):
        if show:
            page.keyboard.press(show)
        else:
            page.locator(".walks summary").click()
        expect(page.locator(shut)).to_be_visible()
        clicked(page)
        expect(page.locator(shut)).to_have_count(0)
        assert not page.evaluate(TAUGHT)


def stops_at_the_last_slide(page: Page) -> None:
    """Then it goes back."""
    last = "oscillations.walks.walk.sheet.steps.length - 1"
    page.wait_for_function("oscillations.walks.walk?.card")
    page.evaluate(f"oscillations.walks.walk.go({last})")
    page.wait_for_function(f"oscillations.walks.walk.place === {last}")
    clicked(page)
    page.wait_for_function(TAUGHT)
    for _ in range(3):
        clicked(page)
        expect(page.locator("dialog.finish")).to_be_visible()
    clicked(page, "PageUp")
    expect(page.locator("dialog.finish")).to_be_hidden()


def test_a_clicker_leads_through_a_walk_and_takes_an_answer_back(page: Page, open_scene: Open) -> None:
    """Two presses at once are one. It closes the topmost dialog first, and stops at the last slide."""
    open_scene(page, walk="d34", step="d34-02")
    page.wait_for_function(AT, arg="d34/d34-02")
    page.keyboard.press("Space")
    assert not playing(page), "nothing plays before the answer"
    page.keyboard.press("2")
    expect(page.locator(".answers button").nth(1)).to_have_attribute("aria-pressed", "true")
    closes_the_topmost_dialog(page)
    page.wait_for_function("performance.now() > pressed + 420")
    page.evaluate(TWICE)
    page.wait_for_function(TAUGHT)
    clicked(page, "PageUp")
    page.wait_for_function(ASKED)
    page.wait_for_function(AT, arg="d34/d34-02")
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
    open_scene(page, walk="tour", step="1")
    stops_at_the_last_slide(page)
