"""Hands on the picture: by mouse, by finger and by keys. Whatever is dragged is where the hand is."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, expect

from components.scenes import SCENES
from tests.browser.touch import FREE, IN_PLOT, OUTLINE, SCROLLING, Finger, Mouse, middle, stopped, swipe, value
from tests.browser.views import seen
from tests.browser.waiting import QUIET, passed, turned
from tests.grids import WHOLE, sample
from tests.page.hand import grabs

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
NEAR = 1  # pixels
LATE = """() => {
  const {messages} = oscillations, receive = messages.receive.bind(messages)
  messages.receive = (...packet) => setTimeout(() => receive(...packet), 500)
}"""
FLICKED = """async name => {
  const {hand, stages} = oscillations.page, {grips, all} = stages[0].grips
  const grip = [...grips.values()].find(({grip, grab}) => !grip.hidden && grab.label.startsWith(name))
  let now = performance.now()
  performance.now = () => now // sixty frames a second on any machine
  hand.take(grip.grab)
  for (let i = 0; i < 5; i++) {
    await new Promise(requestAnimationFrame)
    now += 16
    hand.grab.move({x: grip.x + 8, y: grip.y}, all)
  }
  hand.grab.release(all, true)
  delete performance.now
}"""
WAYS = ((9, 4), (-6, -7))
"""Positions to which a grip is dragged, in pixels from where it was."""
GRIPS = """() => oscillations.stages.flatMap(stage => [...(stage.grips?.grips.values() ?? [])])
  .filter(({grip}) => !grip.hidden && grip.checkVisibility())
  .map(({grip, grab}) => (grip.dataset.of = `${grab.label}: ${grab.ways.map(way => way.parameter)}`))"""
PLACE = """grip => {
  for (const {grips} of oscillations.stages) {
    const found = [...(grips?.grips.values() ?? [])].find(one => one.grip === grip)
    if (!found) continue
    const {ways, begins} = found.grab
    const value = number => typeof number === "number" ? number
      : number.terms.reduce((sum, [size, names]) => names.reduce((part, name) => part * grips.all[name], size) + sum, 0)
    const {left, top, width, height} = grip.getBoundingClientRect()
    const own = grips.element.getBoundingClientRect()
    const turn = ways.find(way => way.kind === "turn")
    return {x: left + width / 2, y: top + height / 2, begins, bound: ways.some(way => way.kind === "locus"),
      along: ways.map(way => way.across ?? (way.kind === "trade" ? "y" : "")).join(""),
      about: turn && [own.left + value(turn.x), own.top + value(turn.y), turn.tall]}
  }
}"""
STATE = """() => {
  const {shown, clock, host} = oscillations.page
  const values = Object.entries(shown.settings).map(([name, {value}]) => [name, value])
  return JSON.stringify([values, clock.t, host.messages.last])
}"""
"""All values, the instant, and the number of the last message."""


def off(at: dict[str, Any], x: float, y: float) -> float:
    """The distance of the dragged shape from the pointer at (x, y), along its ways; if it turns about a point, the
    distance from the line between them.
    """
    if at["about"]:
        cx, cy, tall = at["about"]
        one, other = (at["x"] - cx, (at["y"] - cy) / tall), (x - cx, (y - cy) / tall)
        return abs(one[0] * other[1] - one[1] * other[0]) / math.hypot(*other)
    return max(abs(at[axis] - {"x": x, "y": y}[axis]) for axis in at["along"])


SCREENS = {"desk": (1280, 720), "landscape": (568, 320), "wide": (500, 800), "phone": (390, 844), "small": (320, 640)}
OTHERS = [screen for screen in SCREENS if screen != "phone"]
TURNS = [*zip(SCENES, itertools.cycle(["phone", *OTHERS]), strict=False)]
"""Every scene on one of the screens."""


@pytest.mark.parametrize("turn", [*itertools.product(SCENES, SCREENS)] if WHOLE else sample(TURNS, 5), ids="-".join)
def test_a_scene_in_the_hand(turn: tuple[str, str], new_page: Callable[..., Page], open_scene: Open) -> None:
    """Each grip follows within two frames, by mouse on a desk with late answers, by finger on phones. A finger shows no
    ring. A finger that scrolls sets nothing.
    """
    (slug, screen), desk = turn, turn[1] == "desk"
    options = {} if desk else {"has_touch": True, "is_mobile": True}
    page = open_scene(new_page(*SCREENS[screen], fresh=True, **options), scene=slug)
    if desk:
        page.evaluate(LATE)
    hand, taken, tried = Mouse(page) if desk else Finger(page), 0, set[str]()
    for view in (scene.off_default() for scene in seen(SCENES[slug])):
        turned(page, slug, view)
        stopped(page)
        for name in page.evaluate(GRIPS):
            if name not in tried:
                tried.add(name)
                taken += 1
                is_taken(page, hand, page.locator(f'.grip[data-of="{name}"]').first)
        for name in set[str]() if desk else set(page.evaluate(SCROLLING)) - tried:
            tried.add(name)
            scrolls(page, hand, name)
    assert taken or not [*grabs(SCENES[slug])]


def is_taken(page: Page, hand: Mouse | Finger, grip: Locator) -> None:
    """A grip follows the pointer along its ways. A grip that begins a motion stops time, and plays it when it is
    released.
    """
    page.wait_for_function(QUIET)  # an answer may move lines
    grip.evaluate("grip => grip.scrollIntoView({block: 'center'})")
    stopped(page)
    name, was = grip.get_attribute("data-of"), grip.evaluate(PLACE)
    hand.down(was["x"], was["y"])
    for dx, dy in WAYS:
        hand.move(was["x"] + dx, was["y"] + dy)
        passed(page, 2)
        assert off(grip.evaluate(PLACE), was["x"] + dx, was["y"] + dy) < NEAR or was["bound"], name
    assert not was["begins"] or page.evaluate("[oscillations.clock.playing, oscillations.clock.t]") == [False, 0]
    hand.up()
    page.wait_for_function(
        f"(oscillations.clock.playing || {str(not was['begins']).lower()}) && !oscillations.page.hand.grab"
    )
    if isinstance(hand, Finger):
        assert page.evaluate(f"[document.activeElement !== document.body, {OUTLINE}]") == [True, "none"], name


def scrolls(page: Page, finger: Mouse | Finger, name: str) -> None:
    """A finger that moves up over a plot scrolls the page and sets nothing."""
    page.wait_for_function(FREE)
    stopped(page)
    x, y = page.evaluate(IN_PLOT, name)
    before, was = page.evaluate(STATE), page.evaluate("scrollY")
    finger.down(x, y)
    for far in range(10, 90, 10):
        finger.move(x + 2, y - far)
    finger.up()
    page.wait_for_function("was => scrollY !== was", arg=was)
    assert page.evaluate(STATE) == before, name


def follows(page: Page, finger: Finger, grip: Locator, x: float, y: float) -> tuple[float, float]:
    """The distance from the finger to the grip, after the server's answer."""
    finger.move(x, y)
    passed(page)  # a message is sent with a frame
    page.wait_for_function(QUIET)
    passed(page)
    now = grip.evaluate(PLACE)
    return now["x"] - x, now["y"] - y


def by_finger(page: Page, grip: Locator) -> tuple[Finger, float, float]:
    """A finger on a grip of a stage, and its position."""
    stopped(page, 0)
    x, y = middle(grip)
    finger = Finger(page)
    finger.down(x, y)
    page.wait_for_function(QUIET)
    return finger, x, y


def test_axes_grow_when_the_finger_lets_go_and_those_of_a_plane_stay(phone: Page) -> None:
    turned(phone, "driven", {})
    grip = phone.locator(".grip[aria-label^=Height]:visible").first
    finger, x, y = by_finger(phone, grip)
    for up in (10, 40, 80, 140):
        assert follows(phone, finger, grip, x, y - up) == pytest.approx((0, 0), abs=NEAR), "beyond the plot"
    end = phone.evaluate("oscillations.shown.view.axes.M.end")
    finger.up()
    phone.wait_for_function(f"oscillations.shown.view.axes.M.end > {end}")
    for part in (".grip[data-grab='x1_0 x2_0']", ".pill[data-grab=x2_0]"):
        turned(phone, "modes", {"view": "hunt", "x1_0": 0.2, "x2_0": 1.5})
        before = phone.evaluate("JSON.stringify(oscillations.shown.view.axes.x)")
        finger, x, y = by_finger(phone, phone.locator(f"{part}:visible").first)
        for down, below in ((60, 1), (100, 0.3)):
            finger.move(x, y + down)
            phone.wait_for_function(f"oscillations.shown.settings.x2_0.value < {below} && {QUIET}")
        finger.up()
        phone.wait_for_function(FREE)
        passed(phone)
        assert phone.evaluate("JSON.stringify(oscillations.shown.view.axes.x)") == before, part


def test_a_finger_sets_the_height_of_the_aircraft_as_finely_as_it_can(phone: Page) -> None:
    """Downwards it follows the finger. Upwards its range to standstill is short: the finger has 60 pixels for that."""
    turned(phone, "phugoid", {"excess": 0.1})
    grip = phone.locator(".grip[data-grab=excess]:visible").first
    finger, x, y = by_finger(phone, grip)
    opens, found = value(phone, "excess"), list[float]()
    for down in (16, 100):
        assert follows(phone, finger, grip, x, y + down) == pytest.approx((0, 0), abs=NEAR)
    for up in range(8, 60, 10):
        follows(phone, finger, grip, x, y - up)
        found.append(value(phone, "excess"))
    assert found == sorted(found, reverse=True) and len({*found}) == len(found), "each step counts"
    assert found[0] > opens - 0.2 and found[-1] > -1
    follows(phone, finger, grip, x, y - 70)
    assert value(phone, "excess") == pytest.approx(-1)
    finger.up()
    phone.wait_for_function(FREE)


def test_the_dot_of_nyquist_goes_round_its_loop(desk: Page) -> None:
    """The pointer moves it along the curve; keys move it, too."""
    turned(desk, "forced", {"view": "nyquist", "c1": 0.2, "c2": 0.2, "omega": 0.5})
    grip, omega = desk.get_by_role("slider", name="on the loops of mass 1"), "oscillations.shown.settings.omega.value"
    stopped(desk)
    drag(desk, grip, (0, 20), (0, 40), (0, 60))
    desk.wait_for_function(f"{omega} > 0.52 && {QUIET}")
    desk.mouse.up()
    desk.wait_for_function(FREE)
    now = value(desk, "omega")
    assert now < 0.75, "the first loop"
    for key, sign in (("ArrowRight", 1), ("ArrowLeft", -1)):
        grip.press(key)
        desk.wait_for_function(f"{sign} * ({omega} - {now}) > 0 && {QUIET}")
        now = value(desk, "omega")
    desk.keyboard.press("Enter")
    desk.wait_for_function(FREE)


def test_a_mode_s_row_sets_that_mode_and_the_other_keeps_every_digit(desk: Page) -> None:
    turned(desk, "coupled", {"given_by": "modes", "X_slow": 0.5, "X_fast": 0.30000000000000004, "phi_fast": 1.1})
    stopped(desk)
    row = desk.get_by_role("slider", name="Slow mode, start, by mass 2")
    expect(row).to_have_attribute("data-grab", "X_slow phi_slow")
    drag(desk, row, (15, 0), (-12, 2))
    desk.wait_for_function("performance.now() > oscillations.page.hand.grab.trail.at(-1).when + 200")  # no flick
    desk.mouse.up()
    desk.wait_for_function(f"oscillations.clock.playing && {FREE}")
    assert value(desk, "X_slow") != 0.5 and value(desk, "X_fast") == 0.30000000000000004
    assert value(desk, "phi_fast") == pytest.approx(1.1 + 2 * 0.3, rel=1e-12)
    assert value(desk, "phi_slow") == pytest.approx(math.pi / 2)
    desk.evaluate(FLICKED, "Slow mode, start, by mass 1")
    desk.wait_for_function(f"oscillations.clock.playing && {FREE}")
    assert value(desk, "phi_slow") != pytest.approx(math.pi / 2) and value(desk, "X_fast") == 0.30000000000000004


def test_a_value_set_by_a_finger_is_kept_when_the_browser_cancels_the_touch(phone: Page) -> None:
    held = """({page, clock, messages, busy}) => [Boolean(page.hand.grab), page.compare.pressed, busy.isPressed,
      clock.playing, messages.asked || messages.outbox.length > 0].join()"""
    for where, name in (
        (".grip[aria-label^='Mass 1']", "x1_0"),
        ("input[name=omega-slider]", "omega"),
        (".pill[data-grab=omega]", "omega"),
    ):
        turned(phone, "forced", {})
        if "grip" in where:
            stopped(phone)  # a moving mass is elsewhere when the finger arrives
        else:
            phone.evaluate("oscillations.clock.playing = true")
        before = value(phone, name)
        swipe(phone, middle(phone.locator(where).first), (30, 1), end="touchCancel")
        phone.wait_for_function(f"({held})(oscillations) === 'false,false,false,true,false'")
        assert value(phone, name) != before, f"{where}: what was set last stands"
        assert value(phone, "v1_0") == 0, "and is no flick"


def drag(page: Page, grip: Locator, *ways: tuple[float, float]) -> None:
    """Take a part by mouse and move it; the pointer stays pressed."""
    x, y = middle(grip)
    page.mouse.move(x, y)
    page.mouse.down()
    for dx, dy in ways:
        page.mouse.move(x + dx, y + dy, steps=4)


def test_a_grabbed_mass_is_the_new_start_and_a_flick_gives_its_velocity(desk: Page) -> None:
    turned(desk, "coupled", {"v2_0": 0.5})
    stopped(desk)
    here = desk.evaluate("oscillations.stages[0].grips.all.x2")
    drag(desk, desk.locator(".grip[data-grab=x1_0]").first)
    desk.wait_for_function("oscillations.shown.settings.v2_0.value === 0")
    assert value(desk, "x2_0") == pytest.approx(here, rel=1e-3)
    desk.mouse.up()
    desk.wait_for_function("oscillations.clock.playing && !oscillations.page.hand.grab")
    desk.evaluate(FLICKED, "Mass 1")
    desk.wait_for_function("oscillations.clock.playing && oscillations.shown.settings.v1_0.value > 0")


def test_keys_move_what_has_the_focus_and_enter_lets_it_go(desk: Page) -> None:
    turned(desk, "energy", {})
    grip = desk.get_by_role("slider", name="Mass, start")
    grip.focus()
    desk.keyboard.press("ArrowDown")
    desk.wait_for_function("oscillations.page.hand.grab && !oscillations.clock.playing")
    desk.keyboard.press("ArrowDown")
    expect(grip).not_to_have_attribute("aria-valuenow", "0.2")
    low, high = (float(grip.get_attribute(f"aria-value{end}") or "") for end in ("min", "max"))
    for key, end in (("Home", low), ("End", high)):
        desk.keyboard.press(key)
        expect(grip).to_have_attribute("aria-valuenow", f"{end:g}")
    expect(grip).to_have_attribute("aria-valuetext", f"x0, displacement: {high:.3f} m")
    desk.keyboard.press("PageDown")
    expect(grip).not_to_have_attribute("aria-valuenow", f"{high:g}")
    desk.keyboard.press("Enter")
    desk.wait_for_function("oscillations.clock.playing && !oscillations.page.hand.grab")
    assert value(desk, "v_0") == 0


def test_a_value_that_cannot_be_stays_at_the_last_good_one_and_says_why(desk: Page) -> None:
    turned(desk, "phugoid", {"view": "limits", "excess": -0.5})
    stopped(desk)
    drag(desk, desk.get_by_role("slider", name="Speed at the start", exact=True), (-3, 0), (-120, 0))
    expect(desk.locator(".grips .why").filter(has_text="is not possible")).to_be_visible()
    assert -1 <= value(desk, "excess") <= -0.5
    desk.mouse.up()


PLUCKED = {"starts": "pluck", "N": 8, "m": 0.5, "k": 2, "a": 0.5, "p": 3}


def test_a_chain_is_plucked_pushed_and_set_to_a_mode(desk: Page) -> None:
    """The mass at the pointer is taken; the pulse is led to where it starts; a mode is a button."""
    turned(desk, "chain", PLUCKED)
    stopped(desk, 0)
    x, y = desk.evaluate(
        """p => {
      const {svg, named} = oscillations.page.stages[0]
      const {left, top, width, height} = svg.getBoundingClientRect()
      const {end} = oscillations.page.shown.view.axes.y
      return [left + 56 + ((width - 90) * p) / 9, top + height / 2 - (0.36 * height * named[`x${p}`]) / end]
    }""",
        6,
    )
    desk.mouse.move(x, y)
    desk.mouse.down()
    desk.mouse.move(x, y - 20, steps=4)
    desk.wait_for_function("oscillations.shown.settings.p.value === 6")
    desk.mouse.up()
    desk.wait_for_function(FREE)
    assert value(desk, "starts") == "pluck" and value(desk, "h") > 0

    turned(desk, "chain", {})
    stopped(desk)
    ring = desk.get_by_role("slider", name="Pulse, start")
    metre = desk.evaluate("(oscillations.page.stages[0].svg.getBoundingClientRect().width - 90) / 4.5")
    drag(desk, ring, (metre, 0))
    settings = "oscillations.shown.settings"
    desk.wait_for_function(f"Math.abs({settings}.centre.value - 1.8) < 0.02 && oscillations.clock.t === 0")
    desk.mouse.up()
    desk.wait_for_function(FREE)
    assert value(desk, "h") == pytest.approx(0.4, abs=0.02)
    ring.press("ArrowDown")
    desk.wait_for_function(f"{settings}.h.value < 0.38 && {settings}.starts.value === 'pulse'")
    desk.keyboard.press("Enter")

    turned(desk, "chain", {"view": "modes", **PLUCKED})
    assert desk.locator(".mode-row button").count() == 8
    desk.get_by_role("button", name="Mode 4").click()
    desk.wait_for_function("document.querySelector('.mode-row [aria-pressed=true]')?.textContent === '4'")
    assert (value(desk, "starts"), value(desk, "j")) == ("mode", 4)


@pytest.mark.parametrize("view", ["spectrum", "modes"])
def test_a_tap_starts_a_mode_and_a_move_sideways_drags_it(view: str, phone: Page) -> None:
    turned(phone, "chain", {"view": view, **PLUCKED})
    finger, settings = Finger(phone), "oscillations.shown.settings"
    (name,) = phone.evaluate(SCROLLING)
    x, y = phone.evaluate(IN_PLOT, name)
    finger.down(x, y)
    assert value(phone, "starts") == "pluck", "a press alone may be the begin of a scroll"
    finger.up()
    phone.wait_for_function(f"{settings}.starts.value === 'mode' && {settings}.j.value === 6")
    finger.down(x, y)
    for far in range(0, 100, 10):
        finger.move(x - far, y)
    phone.wait_for_function(f"{settings}.j.value < 5")
    finger.up()
    phone.wait_for_function(FREE)
    assert value(phone, "starts") == "mode"
