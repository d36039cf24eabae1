"""Handles at the axes of plots, and the instant: dragged by mouse and finger; numbers of an axis next to a handle."""

from __future__ import annotations

import itertools

import pytest
from playwright.sync_api import Page

from tests.browser.touch import FREE, IN_PLOT, OUTLINE, SCROLLING, Finger, middle, stopped, top
from tests.browser.waiting import passed, turned
from tests.grids import sample

pytestmark = pytest.mark.browser


DRAGS: list[tuple[str, dict[str, object], str, tuple[int, int], str]] = [
    ("forced", {}, "Drive frequency", (40, 0), "omega.value > 0.9"),
    ("absorber", {}, "Frequency to which the absorber is tuned", (40, 0), "k2.value > 40000"),
    ("modes", {"view": "guess"}, "Trial shape X2/X1", (0, -40), "ratio.value > 0"),
    ("modes", {"view": "hunt"}, "Start of mass 2", (0, -40), "x2_0.value > 0.8"),
    ("modes", {"view": "sweep"}, "k₂, swept", (-40, 0), "k2.value < 0.5"),
    ("accuracy", {"view": "time"}, "Accepted error", (0, -40), "wanted.value > 1e-5"),
]


@pytest.mark.parametrize("drag", sample(DRAGS, 4), ids=lambda drag: drag[2])
def test_a_finger_drags_a_handle_from_where_it_has_taken_it(
    drag: tuple[str, dict[str, object], str, tuple[int, int], str], phone: Page
) -> None:
    """The plot stays, even in a browser without scroll anchoring."""
    slug, given, name, way, moves = drag
    turned(phone, slug, given)
    handle = phone.get_by_role("slider", name=name, exact=True)
    phone.evaluate("document.documentElement.style.overflowAnchor = document.body.style.overflowAnchor = 'none'")
    x, y = middle(handle)
    plot = phone.locator(".block.plot").filter(has=handle)
    before, finger = top(plot), Finger(phone)
    finger.down(x + 9, y - 9)
    finger.move(x + 9 + way[0], y - 9 + way[1])
    phone.wait_for_function(f"oscillations.shown.settings.{moves}")
    stands = "([block, top]) => Math.abs(block.getBoundingClientRect().top - top) <= 1"
    phone.wait_for_function(stands, arg=[plot.element_handle(), before])
    box = handle.bounding_box()
    assert box
    gone = (box["x"] + box["width"] / 2 - x, box["y"] + box["height"] / 2 - y)
    assert gone[way[1] != 0] == pytest.approx(sum(way), abs=3), "no leap to where the finger is"
    finger.up()
    phone.wait_for_function(FREE)
    assert phone.evaluate(OUTLINE) == "none"
    phone.keyboard.press("ArrowRight")
    assert phone.evaluate(OUTLINE) == "solid", "keys show the focus"


def test_lines_that_come_above_move_nothing_under_a_hand(desk: Page) -> None:
    desk.set_viewport_size({"width": 390, "height": 700})
    turned(desk, "forced", {})
    desk.evaluate("document.documentElement.style.overflowAnchor = document.body.style.overflowAnchor = 'none'")
    pad = "size => { document.querySelector('h1').style.paddingBottom = size }"
    for part in (".grip[aria-label^='Mass 1']", ".pill[data-grab=omega]", "[name=omega-slider]"):
        stopped(desk)
        held = desk.locator(part).first
        desk.mouse.move(*middle(held))
        desk.mouse.down()
        passed(desk)
        before = top(held)
        desk.evaluate(pad, "50px")
        passed(desk)
        assert top(held) == pytest.approx(before, abs=1), part
        desk.evaluate(pad, "70px")
        desk.evaluate("() => { document.body.style.height = `${document.body.offsetHeight - 20}px` }")
        passed(desk)
        assert top(held) == pytest.approx(before, abs=1), f"{part}: the page is as tall as before"
        desk.mouse.up()
        desk.evaluate("document.body.style.height = ''")
        desk.evaluate(pad, "")
        passed(desk)
        assert "grip" in part or top(held) < before - 20, "nothing is held any more"
        desk.wait_for_function(FREE)
    desk.set_viewport_size({"width": 1280, "height": 720})


def test_the_instant_is_led_by_mouse_and_finger_and_plays_on(desk: Page, phone: Page) -> None:
    """On the time's handle, over a plot, downwards where time runs down, and by a tap."""
    now, plays = "oscillations.clock.t", "oscillations.clock.playing"
    for slug, part, way in (
        ("coupled", ".pill[aria-label^=Time]", (200, 0)),
        ("coupled", ".plot-area", (200, 0)),
        ("chain", ".pill[aria-label^=Time]", (0, 60)),
    ):
        turned(desk, slug, {})
        desk.evaluate("oscillations.clock.playing = true; oscillations.clock.seek(1)")
        x, y = middle(desk.locator(f"{part}:visible").first)
        desk.mouse.move(x, y)
        desk.mouse.down()
        first = desk.evaluate(now)
        desk.mouse.move(x + way[0], y + way[1], steps=3)
        held = desk.evaluate(now)
        assert held > first + 1 and not desk.evaluate(plays), (slug, part)
        desk.mouse.up()
        desk.wait_for_function(f"{plays} && {now} > {held}")
    turned(phone, "coupled", {})
    phone.evaluate("oscillations.clock.playing = true; oscillations.clock.seek(0)")
    finger = Finger(phone)
    finger.down(*phone.evaluate(IN_PLOT, phone.evaluate(SCROLLING)[0]))
    finger.up()
    phone.wait_for_function(f"{now} > 0.68 * oscillations.shown.view.axes.t.end && {plays}")


def test_a_number_of_the_axis_is_read_whole_next_to_a_handle_or_not_at_all(desk: Page) -> None:
    read = """() => [...oscillations.plots.find(plot => plot.block.handles.length && plot.host.checkVisibility())
      .figure.model.below[0].major_label_overrides.values()].filter(Boolean).join()"""
    for omega, numbers in ((0.5, "0,1,2 rad/s"), (0.97, "0,2 rad/s"), (1.03, "0,2 rad/s"), (0.5, "0,1,2 rad/s")):
        turned(desk, "forced", {"omega": omega})
        passed(desk)
        assert desk.evaluate(read) == numbers, omega


def test_a_handle_at_a_vertical_axis_cuts_no_number(desk: Page) -> None:
    """Over all its values, also in the hall, where type is large and the plot low. Numbers do not touch."""
    bare = """plot => [plot.querySelector(".pill"), ...plot.querySelectorAll(".scale text")].map(part => {
      const {top, height} = part.getBoundingClientRect(), room = part.matches("text") ? height / 6 : 0
      return [top + room, top + height - room]
    }).sort(([one], [other]) => one - other)"""
    counts = set()
    for key in ("", "p"):
        turned(desk, "modes", {"view": "guess"})
        desk.locator("h1").focus()
        desk.keyboard.press(key or "Shift")
        for ratio in range(-3, 4):
            turned(desk, "modes", {"view": "guess", "ratio": ratio})
            passed(desk)
            plot = desk.locator(".block.plot:visible").filter(has=desk.locator(".pill")).first
            parts = plot.evaluate(bare)
            counts.add(len(parts))
            assert all(other[0] > one[1] - 1 for one, other in itertools.pairwise(parts)), (key, ratio, parts)
    assert len(counts) > 1, "it takes the place of numbers"
    desk.keyboard.press("p")
