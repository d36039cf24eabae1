"""The control panel in a Chromium, with the scene behind it and nothing else of the page."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, ClassVar

import pytest
from playwright.sync_api import Browser, Page, Route, expect

from components.controls import Group, apply_message, controls_spec, params_state
from components.parameters import displacement, mass, stiffness
from components.scene import Picture, Scene
from components.sheet import Block, column

pytestmark = pytest.mark.browser

STATIC = Path(__file__).parent.parent / "static"
HTML = """<!DOCTYPE html><html lang="en"><title>Controls</title>
<link rel="stylesheet" href="style.css">
<aside class="panel"></aside>
<script type="module">
  import {buildControls} from "./controls.js"
  import {sliderPlace, sliderValue, stepped} from "./slider.js"
  Object.assign(globalThis, {sliderPlace, sliderValue, stepped})
  const controls = buildControls(document.querySelector("aside"), await describe(), send)
  const show = state => controls.update(state)
  async function send(message) { show(await tell(message)) }
  globalThis.show = show
  show(await tell({type: "set", values: {}}))
  document.documentElement.dataset.ready = "true"
</script></html>"""


class Chain(Scene):
    """A scene with one rule of its own: k2/m1 is at most 1e6."""

    slug = "chain"
    m1 = mass(2.0, symbol="m_1", tint="m1")
    k2 = stiffness(2.0, symbol="k_2", says="couples the masses. Type any value from 0 up.")
    x1_0 = displacement(1.0, symbol="x_1", tint="m1")
    presets: ClassVar = {"Both": {"m1": 2.0}, "Stiff": {"k2": 50.0}, "Too stiff": {"k2": 1e9}}
    groups = (Group("Chain", ("m1", "k2")), Group("Start", ("x1_0",), "or drag a mass"))

    @classmethod
    def sheet(cls) -> Block:
        return column()

    def picture(self) -> Picture:
        if self.k2 > 1e6 * self.m1:
            raise ValueError("the motion is too fast for a double")
        return Picture(columns={}, axes={})


class Panel:
    """The controls of one scene on a page of their own; `messages` are those that the page has sent."""

    def __init__(self, page: Page) -> None:
        self.page, self.scene = page, Chain()
        self.messages: list[dict[str, Any]] = []
        page.expose_function("describe", lambda: controls_spec(Chain, Chain.groups, Chain.presets))
        page.expose_function("tell", self.tell)
        page.route("**/*", self.serve)
        page.goto("http://controls.test/")
        page.wait_for_selector("html[data-ready=true]")
        self.messages.clear()

    def serve(self, route: Route) -> None:
        name = route.request.url.rsplit("/", 1)[-1]
        if name:
            route.fulfill(path=STATIC / name)
        else:
            route.fulfill(body=HTML, content_type="text/html")

    def tell(self, message: dict[str, Any]) -> dict[str, Any]:
        self.messages.append(message)
        errors = apply_message(self.scene, message)
        return {"params": params_state(self.scene), "errors": errors, "preset": self.scene.preset()}

    def field(self, name: str) -> Any:
        return self.page.locator(f'input[name="{name}"]')

    def slider(self, name: str) -> Any:
        return self.page.locator(f'input[name="{name}-slider"]')

    def problem(self, name: str) -> Any:
        return self.page.locator(f"#problem-{name}")

    def type(self, name: str, text: str) -> None:
        self.field(name).fill(text)
        self.field(name).press("Enter")


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


def test_slider_sets_the_scene_at_once(panel: Panel) -> None:
    panel.slider("m1").fill("0.5")
    expect(panel.field("m1")).to_have_value("0.316")
    assert panel.messages == [{"type": "set", "values": {"m1": 0.316}}]
    assert panel.scene.m1 == 0.316
    expect(panel.page.get_by_role("button", name="Both")).to_have_attribute("aria-pressed", "false")


def test_arrow_keys_step_a_slider_to_the_next_value_and_back(panel: Panel) -> None:
    panel.type("k2", "0")
    panel.slider("k2").press("ArrowRight")
    expect(panel.field("k2")).to_have_value("0.0100")
    panel.slider("k2").press("ArrowLeft")
    expect(panel.field("k2")).to_have_value("0.00")
    panel.slider("k2").press("ArrowLeft")
    assert panel.scene.k2 == 0


def test_typed_value_may_lie_outside_the_slider(panel: Panel) -> None:
    panel.type("k2", "1,5·10^3")
    expect(panel.field("k2")).to_have_value("1500")
    expect(panel.slider("k2")).to_have_value("1")
    assert panel.scene.k2 == 1500.0


def test_arrow_keys_step_the_last_digit_of_a_field(panel: Panel) -> None:
    panel.field("k2").press("ArrowUp")
    expect(panel.field("k2")).to_have_value("2.01")
    panel.type("k2", "1e-3")
    expect(panel.field("k2")).to_have_value("0.00100")
    assert panel.page.evaluate("[stepped('9.99', 1), stepped('0.00', -1), stepped('-3e5', 1), stepped('x', 1)]") == [
        "10.00",
        "-0.01",
        "-2e5",
        None,
    ]


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


def test_escape_takes_back_what_was_typed(panel: Panel) -> None:
    panel.type("k2", "much")
    expect(panel.problem("k2")).to_be_visible()
    panel.field("k2").press("Escape")
    expect(panel.problem("k2")).to_be_hidden()
    expect(panel.field("k2")).to_have_value("2.00")


def test_refused_slider_goes_back_to_the_last_good_value(panel: Panel) -> None:
    panel.scene.set({"m1": 1e-5})
    panel.slider("k2").fill("0.9")
    expect(panel.problem("k2")).to_contain_text("The motion is too fast for a double.")
    expect(panel.field("k2")).to_have_value("72.9")
    expect(panel.slider("k2")).to_have_attribute("aria-valuetext", "2.00 N/m")


def test_preset_moves_everything_and_ends_a_refusal(panel: Panel) -> None:
    panel.type("m1", "0")
    expect(panel.problem("m1")).to_be_visible()
    panel.page.get_by_role("button", name="Stiff", exact=True).click()
    expect(panel.page.get_by_role("button", name="Stiff", exact=True)).to_have_attribute("aria-pressed", "true")
    expect(panel.field("k2")).to_have_value("50.0")
    expect(panel.field("m1")).to_have_value("2.00")
    expect(panel.problem("m1")).to_be_hidden()


def test_preset_that_is_refused_says_why(panel: Panel) -> None:
    panel.page.get_by_role("button", name="Too stiff").click()
    expect(panel.problem("preset")).to_have_text("The motion is too fast for a double. Still drawn as before.")


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


def test_help_is_of_what_has_the_focus(panel: Panel) -> None:
    expect(panel.page.locator("#controls-says")).to_have_text("m1 is a mass. Type any value above 0.")
    panel.slider("k2").focus()
    expect(panel.page.locator("#controls-says")).to_have_text("k2 couples the masses. Type any value from 0 up.")


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
