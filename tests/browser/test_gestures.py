"""Hands on the picture: by mouse, by finger and by keys. Whatever is dragged is where the hand is."""

import itertools

import pytest
from playwright.sync_api import Locator, Mouse, Page, expect

from components.scenes import SCENES
from tests.browser.fixtures import Open
from tests.browser.looks import seen
from tests.browser.waiting import QUIET, Finger, middle, passed, seek, stroke, turned, value
from tests.grids import WHOLE, sample
from tests.page.hand import grabs

pytestmark = pytest.mark.browser
FREE = f"!oscillations.page.hand.grab && !oscillations.page.compare.undoGroup && {QUIET}"
"""No hand holds anything, and the server has answered."""
OUTLINE = "getComputedStyle(document.activeElement).outlineStyle"
SCROLLING = """() => oscillations.page.plots
  .filter(({host, absent, block: {handles, time, pick}}) => !absent && host.checkVisibility() &&
    host.style.touchAction !== "none" && (handles.length || time || pick))
  .map(({block}) => block.name)"""
"""Plots that act on a press, and that a finger scrolls."""
IN_PLOT = """name => {
  const plot = oscillations.page.plots.find(({block}) => block.name === name)
  plot.host.scrollIntoView({block: "center"})
  const {left, top} = plot.host.getBoundingClientRect()
  const {frame} = plot
  return [left + frame.left + 0.7 * frame.width, top + frame.top + 0.6 * frame.height]
}"""
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
GRIPS = """() => oscillations.stages.flatMap(stage => [...(stage.grips?.grips.values() ?? [])])
  .filter(({grip}) => !grip.hidden && grip.checkVisibility())
  .map(({grip, grab}) => (grip.dataset.of = `${grab.label}: ${grab.ways.map(way => way.parameter)}`))"""
PLACE = """grip => {
  const all = oscillations.stages.flatMap(({grips}) => [...(grips?.grips.values() ?? [])])
  const {ways, begins} = all.find(one => one.grip === grip).grab
  const {left, top, width, height} = grip.getBoundingClientRect()
  const isBound = ways.some(({kind}) => ["locus", "turn"].includes(kind))
  const along = isBound ? "" : ways.map(way => way.across ?? (way.kind === "trade" ? "y" : "")).join("")
  return {x: left + width / 2, y: top + height / 2, begins, along}
}"""
"""The place of a grip, and the axes along which it follows; tests/scenes/test_drawn.py moves grips along curves."""
STATE = """() => {
  const {shown, clock, host} = oscillations.page
  const values = Object.entries(shown.settings).map(([name, {value}]) => [name, value])
  return JSON.stringify([values, clock.t, host.messages.last])
}"""
"""All values, the instant, and the number of the last message."""
SCREENS = {"desk": (1280, 720), "landscape": (568, 320), "wide": (500, 800), "phone": (390, 844), "small": (320, 640)}
TURNS = [*zip(SCENES, itertools.cycle(["phone", *(name for name in SCREENS if name != "phone")]), strict=False)]
"""Every scene on one of the screens."""
PLUCKED = {"starts": "pluck", "N": 8, "m": 0.5, "k": 2, "a": 0.5, "p": 3}
DRAGS: list[tuple[str, dict[str, object], str, tuple[int, int], str]] = [
    ("forced", {}, "Drive frequency", (40, 0), "omega.value > 0.9"),
    ("absorber", {}, "Frequency to which the absorber is tuned", (40, 0), "k2.value > 40000"),
    ("modes", {"view": "guess"}, "Trial shape X2/X1", (0, -40), "ratio.value > 0"),
    ("modes", {"view": "hunt"}, "Start of mass 2", (0, -40), "x2_0.value > 0.8"),
    ("modes", {"view": "sweep"}, "k₂, swept", (-40, 0), "k2.value < 0.5"),
    ("accuracy", {"view": "time"}, "Accepted error", (0, -40), "wanted.value > 1e-5"),
]


def stopped(page: Page, t: float = 0.3) -> None:
    seek(page, t)
    passed(page)


@pytest.mark.parametrize("turn", [*itertools.product(SCENES, SCREENS)] if WHOLE else sample(TURNS, 4), ids="-".join)
def test_a_scene_in_the_hand(turn: tuple[str, str], new_page: Open, open_scene: Open) -> None:
    """Grips follow within two frames, on a desk with late answers. A finger shows no ring, or scrolls."""
    (slug, screen), desk = turn, turn[1] == "desk"
    page = open_scene(new_page(*SCREENS[screen], has_touch=not desk, is_mobile=not desk), scene=slug)
    if desk:
        page.evaluate(LATE)
    hand, taken, tried = page.mouse if desk else Finger(page), 0, set[str]()
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
    """A grip follows the pointer along its ways. If it begins a motion, time stops until it is released."""
    page.wait_for_function(QUIET)  # an answer may move lines
    grip.evaluate("grip => grip.scrollIntoView({block: 'center'})")
    stopped(page)
    name, was = grip.get_attribute("data-of"), grip.evaluate(PLACE)
    hand.move(was["x"], was["y"])
    hand.down()
    for dx, dy in ((9, 4), (-6, -7)):  # pixels
        hand.move(was["x"] + dx, was["y"] + dy)
        passed(page, 2)
        at, hand_at = grip.evaluate(PLACE), {"x": was["x"] + dx, "y": was["y"] + dy}
        assert all(abs(at[axis] - hand_at[axis]) < 1 for axis in at["along"]), name  # pixel
    assert not was["begins"] or page.evaluate("[oscillations.clock.playing, oscillations.clock.t]") == [False, 0]
    hand.up()
    plays = "oscillations.clock.playing" if was["begins"] else "true"
    page.wait_for_function(f"{plays} && !oscillations.page.hand.grab")
    if isinstance(hand, Finger):
        assert page.evaluate(f"[document.activeElement !== document.body, {OUTLINE}]") == [True, "none"], name


def scrolls(page: Page, finger: Mouse | Finger, name: str) -> None:
    """A finger that moves up over a plot scrolls the page and sets nothing."""
    page.wait_for_function(FREE)
    stopped(page)
    x, y = page.evaluate(IN_PLOT, name)
    before, was = page.evaluate(STATE), page.evaluate("scrollY")
    stroke(finger, [(x + 2, y - far) for far in range(0, 90, 10)])
    page.wait_for_function("was => scrollY !== was", arg=was)
    assert page.evaluate(STATE) == before, name


def test_a_value_set_by_a_finger_is_kept_when_the_browser_cancels_the_touch(phone: Page) -> None:
    omega = [("input[name=omega-slider]", "omega"), (".pill[data-grab=omega]", "omega")]
    for where, name in ((".grip[aria-label^='Mass 1']", "x1_0"), *omega):
        turned(phone, "forced", {})
        stopped(phone)  # a moving mass is elsewhere when the finger arrives
        phone.evaluate("is => { oscillations.clock.playing = is }", name == "omega")
        before = value(phone, name)
        x, y = middle(phone.locator(where).first)
        stroke(Finger(phone), [(x, y), (x + 15, y), (x + 30, y + 1)], kind="touchCancel")
        released = "(({page, busy, clock}) => !page.compare.pressed && !busy.isPressed && clock.playing)(oscillations)"
        phone.wait_for_function(f"{FREE} && {released}")
        assert value(phone, name) != before, f"{where}: what was set last stands"
        assert value(phone, "v1_0") == 0, "and is no flick"


def drag(page: Page, grip: Locator, *ways: tuple[float, float]) -> None:
    """Take a part by mouse and move it; the pointer stays pressed."""
    x, y = middle(grip)
    page.mouse.move(x, y)
    page.mouse.down()
    for dx, dy in ways:
        page.mouse.move(x + dx, y + dy, steps=4)


def test_lines_that_come_above_move_nothing_under_a_hand(desk: Page) -> None:
    desk.set_viewport_size({"width": 390, "height": 700})
    turned(desk, "forced", {})
    desk.evaluate("document.documentElement.style.overflowAnchor = document.body.style.overflowAnchor = 'none'")
    stopped(desk)
    held = desk.locator(".pill[data-grab=omega]").first
    drag(desk, held)
    passed(desk)
    place = "part => part.getBoundingClientRect().top"
    before = held.evaluate(place)
    desk.evaluate("document.querySelector('h1').style.paddingBottom = '50px'")
    passed(desk)
    assert held.evaluate(place) == pytest.approx(before, abs=1)
    desk.mouse.up()
    desk.wait_for_function(FREE)
    desk.evaluate("document.querySelector('h1').style.paddingBottom = ''")


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


def test_a_handle_that_cannot_go_further_says_why(desk: Page) -> None:
    turned(desk, "phugoid", {"view": "limits", "excess": -0.5})
    stopped(desk)
    drag(desk, desk.get_by_role("slider", name="Speed at the start", exact=True), (-3, 0), (-120, 0))
    expect(desk.locator(".grips .why").filter(has_text="is not possible")).to_be_visible()
    assert -1 <= value(desk, "excess") <= -0.5
    desk.mouse.up()


def test_a_tap_starts_a_mode_and_a_move_sideways_drags_it(phone: Page) -> None:
    turned(phone, "chain", {"view": "spectrum", **PLUCKED})
    finger, settings = Finger(phone), "oscillations.shown.settings"
    (name,) = phone.evaluate(SCROLLING)
    x, y = phone.evaluate(IN_PLOT, name)
    finger.move(x, y)
    finger.down()
    assert phone.evaluate(f"{settings}.starts.value") == "pluck", "a press alone may be the begin of a scroll"
    finger.up()
    phone.wait_for_function(f"{settings}.starts.value === 'mode' && {settings}.j.value === 6")
    finger.down()
    for far in range(0, 100, 10):
        finger.move(x - far, y)
    phone.wait_for_function(f"{settings}.j.value < 5")
    finger.up()
    phone.wait_for_function(FREE)
    assert value(phone, "starts") == "mode"
    turned(phone, "chain", {"view": "modes", **PLUCKED})
    phone.get_by_role("button", name="Mode 4").tap()
    phone.wait_for_function(f"{settings}.starts.value === 'mode' && {settings}.j.value === 4")


@pytest.mark.parametrize(("slug", "given", "name", "way", "moves"), sample(DRAGS, 4), ids=str)
def test_a_finger_drags_a_handle_from_where_it_has_taken_it(
    slug: str, given: dict[str, object], name: str, way: tuple[int, int], moves: str, phone: Page
) -> None:
    turned(phone, slug, given)
    handle, finger = phone.get_by_role("slider", name=name, exact=True), Finger(phone)
    x, y = middle(handle)
    finger.move(x + 9, y - 9)
    finger.down()
    finger.move(x + 9 + way[0], y - 9 + way[1])
    phone.wait_for_function(f"oscillations.shown.settings.{moves}")
    passed(phone)
    box = handle.bounding_box()
    assert box
    gone = (box["x"] + box["width"] / 2 - x, box["y"] + box["height"] / 2 - y)
    assert gone[way[1] != 0] == pytest.approx(sum(way), abs=3), "no leap to where the finger is"
    finger.up()
    phone.wait_for_function(FREE)
    assert phone.evaluate(OUTLINE) == "none"
    phone.keyboard.press("ArrowRight")
    assert phone.evaluate(OUTLINE) == "solid", "keys show the focus"


def test_the_instant_is_led_by_mouse_and_plays_on(desk: Page) -> None:
    """On the time's handle, over a plot, and downwards where time runs down."""
    now, plays, pill = "oscillations.clock.t", "oscillations.clock.playing", ".pill[aria-label^=Time]"
    for slug, part, way in (("coupled", pill, (200, 0)), ("coupled", ".plot-area", (200, 0)), ("chain", pill, (0, 60))):
        turned(desk, slug, {})
        stopped(desk, 1)  # a handle of a playing time is elsewhere when the mouse arrives
        x, y = middle(desk.locator(f"{part}:visible").first)
        desk.mouse.move(x, y)
        desk.evaluate("oscillations.clock.playing = true")
        desk.mouse.down()
        first = desk.evaluate(now)
        desk.mouse.move(x + way[0], y + way[1], steps=3)
        held = desk.evaluate(now)
        assert held > first + 1 and not desk.evaluate(plays), (slug, part)
        desk.mouse.up()
        desk.wait_for_function(f"{plays} && {now} > {held}")
