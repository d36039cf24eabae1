"""Dragging: the dragged shape follows within two frames, even if answers are late; letting go plays from the start."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, expect

from components.scenes import SCENES
from components.scenes.coupled import BY_MODES
from tests.browser.touch import Finger, Mouse, swipe
from tests.browser.views import seen
from tests.browser.waiting import QUIET, passed, turned
from tests.grids import WHOLE, spread
from tests.page.hand import grabs

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
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
RESTED = "performance.now() > oscillations.page.hand.grab.trail.at(-1).when + 200"  # letting go is no flick any more
NEAR = 1  # pixels


def middle(of: Locator) -> tuple[float, float]:
    box = of.bounding_box()
    assert box
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def stopped(page: Page) -> None:
    page.evaluate("() => { oscillations.clock.playing = false; oscillations.clock.seek(0.3) }")
    passed(page)


ACROSS = ((15, 0), (-12, 2))
SCREENS = {"desk": (1280, 720), "landscape": (568, 320), "wide": (500, 800), "phone": (390, 844), "small": (320, 640)}
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


def new_grips(page: Page, slug: str) -> Iterator[Locator]:
    """Every grip of a scene in order, each once, in the first of its views that has it; nothing plays."""
    known: set[str] = set()
    for view in (scene.off_default() for scene in seen(SCENES[slug])):
        turned(page, slug, view)
        stopped(page)
        for name in page.evaluate(GRIPS):
            if name not in known:
                known.add(name)
                yield page.locator(f'.grip[data-of="{name}"]').first


HELD_IN = [slug for slug in SCENES if slug != "accuracy"]
OTHERS = [screen for screen in SCREENS if screen != "phone"]
TURNS = list(zip(HELD_IN, itertools.cycle(["phone", *OTHERS]), strict=False))
"""Every scene on one of the screens."""


@pytest.mark.parametrize("turn", [*itertools.product(HELD_IN, SCREENS)] if WHOLE else spread(TURNS, 2), ids="-".join)
def test_what_a_hand_has_taken_is_where_the_hand_is(
    turn: tuple[str, str], new_page: Callable[..., Page], open_scene: Open
) -> None:
    """By mouse on a desk, with late answers; by finger on phones."""
    (slug, screen), desk = turn, turn[1] == "desk"
    page = open_scene(
        new_page(*SCREENS[screen], fresh=True, **({} if desk else {"has_touch": True, "is_mobile": True})), scene=slug
    )
    if desk:
        page.evaluate(LATE)
    hand = Mouse(page) if desk else Finger(page)
    held = [taken(page, hand, grip) for grip in new_grips(page, slug)]
    assert held or not [*grabs(SCENES[slug])]


def taken(page: Page, hand: Mouse | Finger, grip: Locator) -> None:
    """A grip follows the pointer along its ways. A grip that begins a motion stops time, and plays it when it is
    released.
    """
    page.wait_for_function(QUIET)  # an answer may move lines
    grip.evaluate("grip => grip.scrollIntoView({block: 'center'})")
    stopped(page)
    was = grip.evaluate(PLACE)
    hand.down(was["x"], was["y"])
    for dx, dy in WAYS:
        hand.move(was["x"] + dx, was["y"] + dy)
        passed(page, 2)
        far = off(grip.evaluate(PLACE), was["x"] + dx, was["y"] + dy)
        assert far < NEAR or was["bound"], grip.get_attribute("data-of")
    assert not was["begins"] or page.evaluate("[oscillations.clock.playing, oscillations.clock.t]") == [False, 0]
    hand.up()
    page.wait_for_function(
        f"(oscillations.clock.playing || {str(not was['begins']).lower()}) && !oscillations.page.hand.grab"
    )


OUTLINE = "getComputedStyle(document.activeElement).outlineStyle"


def check_ring(page: Page, part: Locator) -> None:
    """A finger on a part shows no ring around it, a key then does."""
    part.scroll_into_view_if_needed()
    finger, (x, y) = Finger(page), middle(part)
    finger.down(x, y)
    finger.move(x + 5, y - 5)
    assert page.evaluate(OUTLINE) == "none"
    finger.up()
    page.wait_for_function(f"!oscillations.page.hand.grab && {QUIET}")
    assert page.evaluate(OUTLINE) == "none", part
    assert page.evaluate("document.activeElement !== document.body"), part
    page.keyboard.press("ArrowRight")
    assert page.evaluate(OUTLINE) == "solid", part


@pytest.mark.parametrize("slug", spread([*SCENES]))
def test_a_finger_shows_no_focus_ring_and_a_key_does(
    slug: str, new_page: Callable[..., Page], open_scene: Open
) -> None:
    page = open_scene(new_page(390, 844, has_touch=True), scene=slug)
    stopped(page)
    parts = page.locator(":is(.grip, .pill[data-grab]):visible")
    for i in range(min(parts.count(), 3)):
        check_ring(page, parts.nth(i))


@pytest.mark.parametrize(("step", "part"), [("d31-04", ".drawing"), ("d31-12", ".pill-mark")])
def test_a_finger_that_answers_shows_no_focus_ring(
    step: str, part: str, new_page: Callable[..., Page], open_scene: Open
) -> None:
    page = open_scene(new_page(390, 844, has_touch=True), walk="d31", step=step, folded=True)
    check_ring(page, page.locator(part).first)


def held_by_finger(page: Page, grip: Locator) -> tuple[Finger, dict[str, Any]]:
    """A finger on a grip of a stage, and its position."""
    page.evaluate("() => { oscillations.clock.playing = false; oscillations.clock.seek(0) }")
    grip.evaluate("grip => grip.scrollIntoView({block: 'center'})")
    passed(page)
    finger, was = Finger(page), grip.evaluate(PLACE)
    finger.down(was["x"], was["y"])
    page.wait_for_function(QUIET)
    return finger, was


def follows(page: Page, finger: Finger, grip: Locator, x: float, y: float) -> tuple[float, float]:
    """The distance from the finger to the grip, after the server's answer."""
    finger.move(x, y)
    passed(page)  # a message is sent with a frame
    page.wait_for_function(QUIET)
    passed(page)
    now = grip.evaluate(PLACE)
    return now["x"] - x, now["y"] - y


EXCESS = "oscillations.shown.settings.excess.value"


def test_a_finger_sets_the_height_of_the_aircraft_as_finely_as_it_can(
    new_page: Callable[..., Page], open_scene: Open
) -> None:
    """Downwards it follows the finger. Upwards its range to standstill is short: the finger has 60 pixels for that."""
    page = open_scene(new_page(390, 844, has_touch=True), scene="phugoid", excess=0.1)
    grip = page.locator(".grip[data-grab=excess]:visible").first
    finger, was = held_by_finger(page, grip)
    x, y, opens = was["x"], was["y"], page.evaluate(EXCESS)
    for down in (8, 16, 60, 100):
        assert follows(page, finger, grip, x, y + down) == pytest.approx((0, 0), abs=NEAR)
    found = []
    for up in range(8, 60, 8):
        follows(page, finger, grip, x, y - up)
        found.append(page.evaluate(EXCESS))
    assert found == sorted(found, reverse=True) and len(set(found)) == len(found), "each step counts"
    assert found[0] > opens - 0.2 and found[-1] > -1
    follows(page, finger, grip, x, y - 70)
    assert page.evaluate(EXCESS) == pytest.approx(-1)
    finger.up()
    page.wait_for_function("!oscillations.page.hand.grab")


def test_a_height_over_a_plot_follows_the_finger_beyond_it(new_page: Callable[..., Page], open_scene: Open) -> None:
    """The axes grow when the finger lets go."""
    page = open_scene(new_page(390, 844, has_touch=True), scene="driven")
    grip = page.locator(".grip[aria-label^=Height]:visible").first
    finger, was = held_by_finger(page, grip)
    for up in (10, 40, 80, 140):
        assert follows(page, finger, grip, was["x"], was["y"] - up) == pytest.approx((0, 0), abs=NEAR)
    end = page.evaluate("oscillations.shown.view.axes.M.end")
    finger.up()
    page.wait_for_function(f"oscillations.shown.view.axes.M.end > {end}")


@pytest.mark.parametrize("part", [".grip[data-grab='x1_0 x2_0']", ".pill[data-grab=x2_0]"])
def test_the_axes_of_a_plane_stay_when_a_finger_lets_go(
    part: str, new_page: Callable[..., Page], open_scene: Open
) -> None:
    page = open_scene(new_page(390, 844, has_touch=True), scene="modes", view="hunt", x1_0=0.2, x2_0=1.5)
    axis = "(({start, end}) => [start, end])(oscillations.shown.view.axes.x)"
    before = page.evaluate(axis)
    handle = page.locator(f"{part}:visible").first
    handle.evaluate("handle => handle.scrollIntoView({block: 'center'})")
    x, y = middle(handle)
    finger = Finger(page)
    finger.down(x, y)
    finger.move(x, y + 60)
    page.wait_for_function(f"oscillations.shown.settings.x2_0.value < 1 && {QUIET}")
    finger.move(x, y + 100)
    page.wait_for_function(f"oscillations.shown.settings.x2_0.value < 0.3 && {QUIET}")
    finger.up()
    page.wait_for_function(f"!oscillations.page.hand.grab && !oscillations.page.compare.undoGroup && {QUIET}")
    passed(page)
    assert page.evaluate(axis) == before


def off(at: dict[str, Any], x: float, y: float) -> float:
    """The distance of the dragged shape from the pointer at (x, y), along its ways; if it turns about a point, the
    distance from the line between them.
    """
    if at["about"]:
        cx, cy, tall = at["about"]
        one, other = (at["x"] - cx, (at["y"] - cy) / tall), (x - cx, (y - cy) / tall)
        return abs(one[0] * other[1] - one[1] * other[0]) / math.hypot(*other)
    return max(abs(at[axis] - {"x": x, "y": y}[axis]) for axis in at["along"])


def drag(page: Page, grip: Locator, along: str, ways: tuple[tuple[int, int], ...]) -> None:
    """Take a grip and drag it along `along`, which it must follow within two frames; the pointer stays pressed."""
    x, y = middle(grip)
    page.mouse.move(x, y)
    page.mouse.down()
    for dx, dy in ways:
        page.mouse.move(x + dx, y + dy)
        passed(page, 2)
        at = middle(grip)
        assert "x" not in along or at[0] == pytest.approx(x + dx, abs=NEAR)
        assert "y" not in along or at[1] == pytest.approx(y + dy, abs=NEAR)


HELD = """({page, clock, messages, busy}) => [Boolean(page.hand.grab), page.compare.pressed, busy.isPressed,
  clock.playing, messages.asked || messages.outbox.length > 0]"""


@pytest.mark.parametrize(
    ("where", "parameter"),
    [
        (".grip[aria-label^='Mass 1']", "x1_0"),
        ("input[name=omega-slider]", "omega"),
        (".pill[data-grab=omega]", "omega"),
    ],
)
def test_a_value_set_by_a_finger_is_kept_when_the_browser_cancels_the_touch(
    where: str, parameter: str, new_page: Callable[..., Page], open_scene: Open
) -> None:
    page = open_scene(new_page(390, 844, fresh=True, has_touch=True, is_mobile=True), scene="forced")
    took = page.locator(where).first
    took.evaluate("one => one.scrollIntoView({block: 'center'})")
    if "grip" in where:
        stopped(page)  # a moving mass is elsewhere when the finger arrives
    before = page.evaluate("name => oscillations.shown.settings[name].value", parameter)
    swipe(page, middle(took), (30, 1), end="touchCancel")
    page.wait_for_function(f"JSON.stringify(({HELD})(oscillations)) === '[false,false,false,true,false]'")
    after = page.evaluate("name => oscillations.shown.settings[name].value", parameter)
    assert after != before, "what was set last stands"
    assert page.evaluate("oscillations.shown.settings.v1_0.value") == 0, "and is no flick"


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
    page.evaluate(FLICKED, "Mass 1")
    page.wait_for_function("oscillations.clock.playing && oscillations.shown.settings.v1_0.value > 0")


def test_a_mode_s_row_sets_that_mode_and_the_other_keeps_every_digit(page: Page, open_scene: Open) -> None:
    modes = {"given_by": "modes", "X_slow": 0.5, "X_fast": 0.30000000000000004, "phi_fast": 1.1}
    open_scene(page, scene="coupled", **modes)
    stopped(page)
    row = page.get_by_role("slider", name="Slow mode, start, by mass 2")
    expect(row).to_have_attribute("data-grab", "X_slow phi_slow")
    drag(page, row, "x", ACROSS)
    page.wait_for_function(RESTED)
    page.mouse.up()
    page.wait_for_function("oscillations.clock.playing && !oscillations.page.hand.grab")
    slow, phase, fast, turned = (page.evaluate(f"oscillations.shown.settings.{name}.value") for name in BY_MODES)
    assert slow != 0.5 and fast == modes["X_fast"] and turned == pytest.approx(1.1 + 2 * 0.3, rel=1e-12)
    assert phase == pytest.approx(math.pi / 2)
    page.evaluate(FLICKED, "Slow mode, start, by mass 1")
    page.wait_for_function(f"oscillations.clock.playing && oscillations.shown.settings.phi_slow.value !== {phase}")
    assert page.evaluate("oscillations.shown.settings.X_fast.value") == fast
    page.get_by_role("button", name="Starting values").click()
    expect(row).to_have_attribute("data-grab", "x1_0 x2_0")


def test_keys_move_what_has_the_focus_and_enter_lets_it_go(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="energy")
    grip = page.get_by_role("slider", name="Mass, start")
    grip.focus()
    page.keyboard.press("ArrowDown")
    page.wait_for_function("oscillations.page.hand.grab && !oscillations.clock.playing")
    page.keyboard.press("ArrowDown")
    expect(grip).not_to_have_attribute("aria-valuenow", "0.2")
    page.keyboard.press("Home")
    low, high = (float(grip.get_attribute(f"aria-value{end}") or "") for end in ("min", "max"))
    expect(grip).to_have_attribute("aria-valuenow", f"{low:g}")
    page.keyboard.press("PageUp")
    expect(grip).not_to_have_attribute("aria-valuenow", f"{low:g}")
    page.keyboard.press("End")
    expect(grip).to_have_attribute("aria-valuenow", f"{high:g}")
    expect(grip).to_have_attribute("aria-valuetext", f"x0, displacement: {high:.3f} m")
    page.keyboard.press("Enter")
    page.wait_for_function("oscillations.clock.playing && !oscillations.page.hand.grab")
    assert page.evaluate("oscillations.shown.settings.v_0.value") == 0


def test_a_value_that_cannot_be_stays_at_the_last_good_one_and_says_why(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="phugoid", view="limits", excess=-0.5)
    stopped(page)
    grip = page.get_by_role("slider", name="Speed at the start", exact=True)
    x, y = middle(grip)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 3, y)
    page.mouse.move(x - 120, y)
    why = page.locator(".grips .why").filter(has_text="is not possible")
    expect(why).to_be_visible()
    assert -1 <= page.evaluate("oscillations.shown.settings.excess.value") <= -0.5
    page.mouse.up()


def test_a_step_lets_the_hand_set_what_it_names_alone(page: Page, open_scene: Open) -> None:
    for step, free in (("d31-02", False), ("d31-03", True)):
        open_scene(page, walk="d31", step=step)
        mass = page.locator(".grip[data-grab=x_0]")
        expect(page.locator("[inert] .grip[data-grab=x_0]")).to_be_attached()
        page.keyboard.press("PageDown")
        page.wait_for_function("oscillations.walks.walk.lesson")
        assert mass.evaluate("grip => !grip.closest('[inert]')") is free


@pytest.mark.parametrize("desk", [True, False], ids=["mouse", "finger"])
def test_the_dot_of_nyquist_goes_round_its_loop(desk: bool, new_page: Callable[..., Page], open_scene: Open) -> None:
    """By pointer, which it follows along the curve, and by keys."""
    page = new_page(1280, 720) if desk else new_page(390, 844, has_touch=True)
    open_scene(page, scene="forced", view="nyquist", c1=0.2, c2=0.2, omega=0.5)
    grip, omega = page.get_by_role("slider", name="on the loops of mass 1"), "oscillations.shown.settings.omega.value"
    grip.evaluate("grip => grip.scrollIntoView({block: 'center'})")
    stopped(page)
    was, hand = grip.evaluate(PLACE), Mouse(page) if desk else Finger(page)
    hand.down(was["x"], was["y"])
    for far in (20, 40, 60):
        hand.move(was["x"], was["y"] + far)
        passed(page, 2)
    page.wait_for_function(f"{omega} > 0.52 && {QUIET}")
    hand.up()
    page.wait_for_function(f"!oscillations.page.hand.grab && {QUIET}")
    now = page.evaluate(omega)
    assert now < 0.75, "the first loop"
    for key, sign in (("ArrowRight", 1), ("ArrowLeft", -1)):
        grip.press(key)
        page.wait_for_function(f"{sign} * ({omega} - {now}) > 0 && {QUIET}")
        now = page.evaluate(omega)
    page.keyboard.press("Enter")
    page.wait_for_function("!oscillations.page.hand.grab")
