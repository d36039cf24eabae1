"""In the hand: what is grabbed follows within a frame, also when answers are late; letting go plays from the start."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.waiting import passed

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
LATE = """() => {
  const {line} = oscillations, receive = line.receive.bind(line)
  line.receive = (...packet) => setTimeout(() => receive(...packet), 500)
}"""
FLICKED = """async () => {
  const {hand, stages} = oscillations.page, {grips, all} = stages[0].grips, [grip] = grips.values()
  hand.take(grip.grab)
  for (let i = 0; i < 5; i++) {
    await new Promise(requestAnimationFrame)
    hand.move({x: grip.x + 8, y: grip.y}, all)
  }
  hand.release(all)
}"""
NEAR = 2  # pixels: the rounding of places


def middle(of: Locator) -> tuple[float, float]:
    box = of.bounding_box()
    assert box
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def stopped(page: Page) -> None:
    page.evaluate("() => { oscillations.clock.playing = false; oscillations.clock.seek(0.3) }")
    passed(page)


@pytest.mark.parametrize(
    ("query", "names", "ways"),
    [
        ({"scene": "coupled"}, "x1_0", ((20, 0), (35, 3), (-15, -2))),
        ({"scene": "oscillator"}, "x_0", ((0, 15), (2, -30), (0, -20))),
        ({"scene": "oscillator"}, "x_0 v_0", ((10, 5), (-20, 10), (-30, -15))),
        ({"scene": "energy"}, "x_0", ((0, 10), (0, 25))),
        ({"scene": "phugoid"}, "excess", ((0, 10), (4, 18))),
        ({"scene": "analogues"}, "theta_0", ((5, 2), (9, 4))),
        ({"scene": "analogues", "system": "floating"}, "floating_start", ((0, -8), (0, -14))),
    ],
)
def test_the_handle_is_where_the_hand_is_though_answers_are_late(
    query: dict[str, str], names: str, ways: tuple[tuple[int, int], ...], page: Page, open_scene: Open
) -> None:
    open_scene(page, **query)
    stopped(page)
    page.evaluate(LATE)
    grip = page.locator(f".grip[data-grab='{names}']").first
    x, y = middle(grip)
    page.mouse.move(x, y)
    page.mouse.down()
    moves_both = " " in names or names in ("excess", "theta_0")
    upright = names in ("x_0", "floating_start")
    for dx, dy in ways:
        page.mouse.move(x + dx, y + dy)
        passed(page, 1)
        at = middle(grip)
        if not upright and names != "theta_0":
            assert at[0] == pytest.approx(x + dx, abs=NEAR)
        if (moves_both or upright) and names != "theta_0":
            assert at[1] == pytest.approx(y + dy, abs=NEAR)
    assert page.evaluate("[oscillations.clock.playing, oscillations.clock.t]") == [False, 0]
    page.mouse.up()
    page.wait_for_function("oscillations.clock.playing && !oscillations.page.hand.grab")


def test_a_grabbed_mass_is_the_new_start_and_a_flick_gives_its_velocity(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled", v2_0=0.5)
    stopped(page)
    x, y = middle(page.locator(".grip[data-grab=x1_0]").first)
    here = page.evaluate("oscillations.stages[0].grips.all.x2")
    page.mouse.move(x, y)
    page.mouse.down()
    page.wait_for_function("oscillations.shown.settings.v2_0.value === 0")
    assert page.evaluate("oscillations.shown.settings.x2_0.value") == pytest.approx(here, rel=1e-3)
    page.mouse.up()
    page.wait_for_function("oscillations.clock.playing && !oscillations.page.hand.grab")
    page.evaluate(FLICKED)
    page.wait_for_function("oscillations.clock.playing && oscillations.shown.settings.v1_0.value > 0")


def test_keys_move_what_has_the_focus_and_enter_lets_it_go(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="energy")
    grip = page.get_by_role("slider", name="Mass, start")
    grip.focus()
    page.keyboard.press("ArrowDown")
    page.wait_for_function("oscillations.page.hand.grab && !oscillations.clock.playing")
    page.keyboard.press("ArrowDown")
    expect(grip).not_to_have_attribute("aria-valuenow", "0.2")
    page.keyboard.press("Enter")
    page.wait_for_function("oscillations.clock.playing && !oscillations.page.hand.grab")
    assert page.evaluate("oscillations.shown.settings.v_0.value") == 0


def test_a_value_that_cannot_be_stays_at_the_last_good_one_and_says_why(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="phugoid", show="limits", excess=-0.5)
    stopped(page)
    grip = page.get_by_role("slider", name="Speed at the start")
    x, y = middle(grip)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 3, y)
    page.mouse.move(x - 120, y)
    why = page.locator(".grips .why").filter(has_text="is not possible")
    expect(why).to_be_visible()
    assert -1 <= page.evaluate("oscillations.shown.settings.excess.value") <= -0.5
    page.mouse.up()


def test_the_hint_goes_with_the_first_grab(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="energy")
    hint = page.get_by_text("Drag what moves")
    expect(hint).to_be_visible()
    page.get_by_role("slider", name="Mass, start").focus()
    page.keyboard.press("ArrowDown")
    expect(hint).to_have_count(0)
    open_scene(page, scene="coupled")
    expect(hint).to_have_count(0)
