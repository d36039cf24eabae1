"""The control panel in Chromium, with the scene behind it and nothing else of the page."""

import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect

from components.state.page_state import with_values
from tests.browser.panel_page import Chain, Panel
from tests.browser.touch import Finger
from tests.browser.waiting import passed

pytestmark = pytest.mark.browser


@pytest.fixture
def panel(browser: Browser) -> Iterator[Panel]:
    context = browser.new_context(viewport={"width": 320, "height": 720})
    page = context.new_page()
    faults: list[str] = []
    page.on("pageerror", lambda error: faults.append(str(error)))
    yield Panel(page)
    context.close()
    assert not faults


def test_every_input_has_its_name_and_a_label_with_the_unit(panel: Panel) -> None:
    for name, label in (
        ("m1", "m1, mass, kg"),
        ("k2", "k2, stiffness, N/m"),
        ("x1_0", "x1, displacement, m"),
    ):
        expect(panel.field(name)).to_have_accessible_name(label)
        expect(panel.slider(name)).to_have_accessible_name(label)
    expect(panel.field("k2")).to_have_value("2.00")
    expect(panel.slider("k2")).to_have_attribute("aria-valuetext", "2.00 N/m")
    expect(panel.page.get_by_role("button", name="Both")).to_have_attribute("aria-pressed", "true")


def test_slider_sets_the_value_at_once(panel: Panel) -> None:
    panel.slider("m1").fill("0.5")
    expect(panel.field("m1")).to_have_value("0.316")
    assert panel.messages == [{"type": "set", "values": {"m1": 0.316}}]
    assert panel.scene.m1 == 0.316
    expect(panel.page.get_by_role("button", name="Both")).to_have_attribute("aria-pressed", "false")


def test_keys_step_sliders(panel: Panel) -> None:
    """To the next value, by two digits where the scale is logarithmic, and by decades or tenths of the range."""
    for name, typed, presses in (
        ("k2", "0", ("ArrowRight 0.0100", "ArrowLeft 0.00", "ArrowLeft 0.00")),
        ("m1", "0.123", ("ArrowRight 0.130", "ArrowLeft 0.120", "PageUp 1.20", "PageDown 0.120", "PageDown 0.0120")),
        ("m1", "0.0120", ("PageDown 0.0100", "ArrowLeft 0.0100")),
    ):
        panel.type(name, typed)
        for key, value in map(str.split, presses):
            panel.slider(name).press(key)
            expect(panel.field(name)).to_have_value(value)
    panel.type("x1_0", "0")
    panel.slider("x1_0").press("PageUp")
    low, high = Chain.param.x1_0.softbounds
    assert panel.scene.x1_0 == (high - low) / 10


def test_one_tab_stop_a_parameter_and_a_digit_leads_to_its_field(panel: Panel) -> None:
    panel.slider("m1").focus()
    panel.page.keyboard.press("Tab")
    expect(panel.slider("k2")).to_be_focused()
    panel.page.keyboard.type("7.5")
    expect(panel.field("k2")).to_be_focused()
    panel.page.keyboard.press("Enter")
    expect(panel.field("k2")).to_have_value("7.50")
    assert panel.scene.k2 == 7.5
    panel.page.keyboard.press("Tab")
    expect(panel.slider("x1_0")).to_be_focused()


@pytest.mark.parametrize(("across", "down", "moves"), [(0, 60, False), (5, 2, False), (60, 4, True)])
def test_a_finger_moves_a_slider_sideways_only(browser: Browser, across: int, down: int, moves: bool) -> None:
    context = browser.new_context(viewport={"width": 320, "height": 300}, has_touch=True)
    panel = Panel(context.new_page())
    box = panel.slider("m1").bounding_box()
    finger = Finger(panel.page)
    x, y = box["x"] + 10, box["y"] + box["height"] / 2
    finger.down(x, y)
    for step in range(1, 6):
        finger.move(x + across * step / 5, y + down * step / 5)
    finger.up()
    passed(panel.page)
    assert bool(panel.messages) == moves
    assert (panel.scene.m1 != 2.0) == moves
    context.close()


def test_a_field_takes_what_people_type(panel: Panel) -> None:
    """Also outside the slider; another kind of unit is refused."""
    panel.type("k2", "1,5·10^3 N/m")
    expect(panel.field("k2")).to_have_value("1500")
    expect(panel.slider("k2")).to_have_value("1")
    assert panel.scene.k2 == 1500.0
    panel.type("k2", "3 kg")
    expect(panel.problem("k2")).to_have_text(
        "“3 kg” is in kg, and this is in N/m: type a number in N/m. Still drawn with 1500."
    )
    assert panel.scene.k2 == 1500.0


def test_a_long_number_is_shortened_to_its_field_and_whole_while_it_has_the_focus(panel: Panel) -> None:
    field = panel.field("k2")
    panel.type("k2", "1/3")
    expect(field).to_have_value("0.3333333333333333")
    field.blur()
    expect(field).not_to_have_value("0.3333333333333333")  # it is measured with the next frame
    shown = field.input_value()
    assert shown.startswith("0.33") and len(shown) < 12
    assert field.evaluate("field => field.scrollWidth <= field.clientWidth")
    expect(field).to_have_attribute("title", "0.3333333333333333")
    field.focus()
    expect(field).to_have_value("0.3333333333333333")
    field.blur()
    assert panel.scene.k2 == 1 / 3
    assert [message["type"] for message in panel.messages] == ["typed"]


def test_arrow_keys_step_the_last_digit_of_a_field_that_has_a_true_minus(panel: Panel) -> None:
    panel.field("k2").press("ArrowUp")
    expect(panel.field("k2")).to_have_value("2.01")
    panel.type("x1_0", "-1.5e-7")
    expect(panel.field("x1_0")).to_have_value("−1.5e−7")
    panel.field("x1_0").press("ArrowUp")
    expect(panel.field("x1_0")).to_have_value("−1.4e−7")
    assert panel.scene.x1_0 == -1.4e-7
    stepped = "[['9.99', 1], ['0.00', -1], ['-3e5', 1], ['x', 1]].map(([text, way]) => stepped(text, way))"
    assert panel.page.evaluate(stepped) == ["10.00", "-0.01", "-2e5", None]


def test_refused_text_stays_with_its_reason_until_it_is_corrected(panel: Panel) -> None:
    panel.type("k2", "-3")
    expect(panel.problem("k2")).to_have_text(
        "−3 N/m is not possible: a stiffness is a finite number, 0 or more. Still drawn with 2.00."
    )
    expect(panel.field("k2")).to_have_value("-3")
    expect(panel.field("k2")).to_have_attribute("aria-invalid", "true")
    expect(panel.field("k2")).to_have_accessible_description(re.compile("not possible"))
    assert panel.page.evaluate("sliderValue('near0', document.getElementsByName('k2-slider')[0].value, [0, 100])") == 2
    panel.type("m1", "4")
    expect(panel.field("m1")).to_have_value("4.00")
    expect(panel.field("k2")).to_have_value("-3")
    panel.type("k2", "3")
    expect(panel.problem("k2")).to_be_hidden()
    expect(panel.field("k2")).to_have_value("3.00")
    assert panel.field("k2").get_attribute("aria-invalid") is None
    panel.type("k2", "much")
    expect(panel.problem("k2")).to_be_visible()
    panel.field("k2").press("Escape")
    expect(panel.problem("k2")).to_be_hidden()
    expect(panel.field("k2")).to_have_value("3.00")


def test_refused_slider_goes_back_to_the_last_good_value(panel: Panel) -> None:
    panel.session_page.session.now = with_values(panel.session_page.now, {"m1": 1e-5})
    panel.slider("k2").fill("0.9")
    expect(panel.problem("k2")).to_contain_text("The motion is too fast for a double.")
    expect(panel.field("k2")).to_have_value("72.9")
    expect(panel.slider("k2")).to_have_attribute("aria-valuetext", "2.00 N/m")


def test_preset_moves_everything_and_ends_a_refusal(panel: Panel) -> None:
    panel.type("m1", "0")
    expect(panel.problem("m1")).to_be_visible()
    panel.page.evaluate("release()")
    panel.page.get_by_role("button", name="Stiff", exact=True).click()
    expect(panel.page.get_by_role("button", name="Stiff", exact=True)).to_have_attribute("aria-pressed", "true")
    expect(panel.field("k2")).to_have_value("50.0")
    expect(panel.field("m1")).to_have_value("2.00")
    expect(panel.problem("m1")).to_be_hidden()


def test_state_does_not_overwrite_what_is_being_typed(panel: Panel) -> None:
    panel.field("k2").fill("7.")
    panel.page.evaluate("tell({type: 'set', values: {m1: 3}}).then(show)")
    expect(panel.field("m1")).to_have_value("3.00")
    expect(panel.field("k2")).to_have_value("7.")


def test_answer_to_an_older_message_does_not_move_the_slider_back(panel: Panel) -> None:
    panel.page.evaluate("tell({type: 'set', values: {}}).then(state => { globalThis.old = state })")
    panel.page.wait_for_function("globalThis.old")
    place = panel.page.evaluate(
        """() => {
          const slider = document.getElementsByName("m1-slider")[0]
          slider.value = 0.5
          slider.dispatchEvent(new Event("input"))
          show(old)
          return slider.value
        }"""
    )
    assert place == "0.5"


def test_each_slider_and_field_is_described_by_its_own_help(panel: Panel) -> None:
    """The help of the part that has the focus is visible."""
    says = panel.page.locator("#controls-says")
    expect(says).to_have_text("")
    panel.slider("k2").focus()
    expect(says).to_have_text("k2 couples the masses. Type any value from 0 up.")
    typing = "Type a digit to open the field; Enter sets the number, Escape cancels."
    for part in (panel.slider("m1"), panel.field("m1")):
        expect(part).to_have_accessible_description(f"m1 is a mass. Type any value above 0. {typing}")
    panel.field("m1").focus()
    expect(says).to_have_text("m1 is a mass. Type any value above 0.")
    panel.field("m1").blur()
    expect(says).to_have_text("")
    panel.type("m1", "-1")
    expect(panel.field("m1")).to_have_accessible_description(re.compile(r"above 0.*m1 is a mass"))


@pytest.mark.parametrize(
    ("scale", "soft", "unit"),
    [
        ("linear", [-2, 2], 0.01),
        ("linear", [0, 4.045], 0.01),
        ("near0", [0, 100], 0.01),
        ("log", [0.01, 10], None),
    ],
)
def test_slider_runs_evenly_over_its_range(panel: Panel, scale: str, soft: list[float], unit: float | None) -> None:
    values: list[float] = panel.page.evaluate(
        "([scale, soft]) => Array.from({length: 1001}, (_, i) => sliderValue(scale, i/1000, soft))",
        [scale, soft],
    )
    assert values == sorted(values)
    assert values[0] == soft[0]
    assert values[-1] == pytest.approx(soft[1], rel=2e-3)
    assert all(float(f"{value:.3g}") == value for value in values)
    assert unit is None or all(abs(value / unit - round(value / unit)) < 1e-9 for value in values)
    places = panel.page.evaluate(
        "([scale, soft, values]) => values.map(v => sliderPlace(scale, v, soft))", [scale, soft, values]
    )
    assert all(0 <= place <= 1 for place in places)
    assert max(abs(place - i / 1000) for i, place in enumerate(places) if i > 100) < 0.002
