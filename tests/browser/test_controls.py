"""The control panel: fields, sliders, refusals, help, and what a message that is late may not change."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.touch import Finger
from tests.browser.waiting import QUIET, is_shown, passed, turned, typed

pytestmark = pytest.mark.browser


def field(page: Page, name: str) -> Locator:
    return page.locator(f".panel input[name={name}]")


def slider(page: Page, name: str) -> Locator:
    return page.locator(f".panel input[name={name}-slider]")


def problem(page: Page, name: str) -> Locator:
    return page.locator(f"#problem-{name}")


def value(page: Page, name: str) -> float:
    page.wait_for_function(QUIET)
    return float(page.evaluate(f"oscillations.shown.settings.{name}.value"))


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
        ("m1", "0.123", ("ArrowRight 0.130", "ArrowLeft 0.120", "PageUp 1.20", "PageDown 0.120", "PageDown 0.0120")),
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
        slider(phone, "k2").evaluate("one => one.scrollIntoView({block: 'center'})")
        box = slider(phone, "k2").bounding_box()
        assert box
        finger, x, y = Finger(phone), box["x"] + 0.3 * box["width"], box["y"] + box["height"] / 2
        finger.down(x, y)
        for step in range(1, 6):
            finger.move(x + across * step / 5, y + down * step / 5)
        finger.up()
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
    typed(desk, "x1_0", "-1.5e-7")
    expect(field(desk, "x1_0")).to_have_value("−1.5e−7")
    field(desk, "x1_0").press("ArrowUp")
    expect(field(desk, "x1_0")).to_have_value("−1.4e−7")
    assert value(desk, "x1_0") == -1.4e-7


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
    typed(desk, "m1", "0")
    expect(problem(desk, "m1")).to_be_visible()
    desk.get_by_role("button", name="All equal").click()
    expect(field(desk, "m1")).to_have_value("1.00")
    expect(problem(desk, "m1")).to_be_hidden()
    turned(desk, "coupled", {"m1": 5e-324})
    slider(desk, "k2").fill("0.9")
    expect(problem(desk, "k2")).to_contain_text("outside the range of doubles")
    expect(field(desk, "k2")).to_have_value("72.9")
    expect(slider(desk, "k2")).to_have_attribute("aria-valuetext", "2.00 N/m")


def test_answers_do_not_overwrite_what_a_hand_is_setting(desk: Page) -> None:
    turned(desk, "coupled", {})
    field(desk, "k2").fill("7.")
    desk.evaluate("oscillations.send({type: 'set', values: {m1: 3}})")
    expect(field(desk, "m1")).to_have_value("3.00")
    expect(field(desk, "k2")).to_have_value("7.")
    field(desk, "k2").press("Escape")
    place = """() => {
      const {messages} = oscillations, {handle} = messages, slider = document.getElementsByName("m1-slider")[0]
      messages.handle = (message, asked) => {
        messages.handle = handle
        slider.value = 0.5
        slider.dispatchEvent(new Event("input"))
        handle(message, asked)
        globalThis.place = slider.value
      }
      oscillations.send({type: "set", values: {k1: 3}})
    }"""
    desk.evaluate(place)
    desk.wait_for_function("globalThis.place === '0.5'")  # the answer to the older message came after the slider moved


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
