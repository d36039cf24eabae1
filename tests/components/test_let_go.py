"""The end of a drag: axes that are hardly used are fitted once; others stay."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from components.language.shapes import Grab
from components.language.state import Frame, State
from components.quantities.axes import TIME_AXIS, Axis, nice_axis, widest
from components.scene import Picture
from components.scene.frames import FITTED, loosened, unfitted
from components.scene.picture import frame_of
from components.scenes import SCENES
from components.state.link import read_query
from tests.page.hand import grabs
from tests.page.headless_page import Page
from tests.scenes.checks import as_arguments, quantities

MOVING = [slug for slug in SCENES if slug != "accuracy"]


def say(page: Page, **message: Any) -> dict[str, Any]:
    return page.send({**message, "number": len(page.packets) + 1})


def sweep(page: Page, name: str, *values: float) -> None:
    for value in values:
        say(page, type="set", values={name: value})


def let_go(page: Page) -> State:
    """Lets go and returns the state that the page then has, as the browser knows it."""
    told = say(page, type="set", values={}, holding=False)
    assert told["type"] == "kept" or told["errors"] == {}
    return page.now.state


def essence(told: dict[str, Any]) -> str:
    """A message without its number, for comparison."""
    return json.dumps({**told, "answer": None}, default=lambda column: column.tolist())


def share(axis: Axis, seen: tuple[float, float]) -> float:
    """The share of an axis that is used."""
    low, high = (axis.place(end) for end in seen)
    start, end = axis.place(axis.start), axis.place(axis.end)
    return abs(high - low) / abs(end - start)


def check_used(shown: Picture, held: Picture | None = None) -> None:
    """Every axis is used to a quarter, or is no longer than the one that would be chosen."""
    for name, axis in shown.axes.items():
        used = share(axis, widest(axis.seen, *([held.axes[name].seen] if held and name in held.axes else [])))
        assert name == TIME_AXIS or used >= 0.25 or share(axis, axis.chosen) >= 0.999, (name, axis)


@pytest.mark.parametrize("slug", MOVING)
def test_after_a_sweep_of_any_slider_nothing_is_lost_in_its_axes(slug: str) -> None:
    for name, quantity in quantities(SCENES[slug]).items():
        page = Page(SCENES[slug]())
        value = getattr(page.scene, name)
        window = frame_of(page.shown).window
        sweep(page, name, *page.shown.spans.get(name, quantity.softbounds), value)
        let_go(page)
        check_used(page.shown)
        assert frame_of(page.shown).window == window, "curves fill the window"
        frame = frame_of(page.shown)
        let_go(page)
        assert frame_of(page.shown) == frame, "once"


@pytest.mark.parametrize("slug", MOVING)
def test_letting_go_sends_a_picture_only_where_it_is_another(slug: str) -> None:
    """After any change, also during a drag, an answer that would repeat the last one is short."""
    for name, quantity in quantities(SCENES[slug]).items():
        page = Page(SCENES[slug]())
        low, high = page.shown.spans.get(name, quantity.softbounds)
        for holding in (None, True):
            for value in (low + 0.4 * (high - low), low + 0.6 * (high - low), low + 0.6001 * (high - low)):
                last = say(page, type="set", values={name: value}, holding=holding)
                told = say(page, type="set", values={}, holding=False)
                again = page.send({"type": "set", "values": {}, "holding": False, "number": told["answer"]})
                assert again["type"] == "shown", "a repeated message is answered in full: its answer may be lost"
                same = essence(again) == essence(last)
                assert told["type"] == ("kept" if same else "shown"), (name, value, holding)
                assert same or essence(told) == essence(again)


def test_letting_go_after_a_refusal_takes_the_refusal_back() -> None:
    page = Page(SCENES["coupled"]())
    assert say(page, type="set", values={"m1": 0.0})["errors"]
    assert let_go(page) == page.now.state
    assert page.last_message["type"] == "shown" and page.last_message["errors"] == {}


GRABS = [(slug, grab) for slug in MOVING for _, grab in grabs(SCENES[slug]) if grab.ways[0].parameter]


@pytest.mark.parametrize(("slug", "grab"), GRABS, ids=lambda one: one if isinstance(one, str) else one.label)
def test_the_axes_that_a_hand_moves_along_stay_and_the_others_grow(slug: str, grab: Grab) -> None:
    """During a drag, by much and by little; at its end, by little."""
    page = Page(SCENES[slug]())
    along = sorted({way.axis for way in grab.ways if way.axis in page.shown.axes})
    name = grab.ways[0].parameter
    _, high = page.shown.spans.get(name, quantities(SCENES[slug])[name].softbounds)
    frame = frame_of(page.shown)
    for share in (1.0, 0.9, 0.03):
        say(page, type="set", values={name: share * high}, holding=True, along=along)
        now = frame_of(page.shown)
        assert all(now.ranges[axis] == frame.ranges[axis] for axis in along)
        assert (now.scale, now.window) == (frame.scale, frame.window)
        for axis in set(page.shown.axes) - {*along, TIME_AXIS} if along else ():
            (low, top), (least, most) = sorted(now.ranges[axis]), page.shown.axes[axis].seen
            assert low <= least and most <= top, axis
    say(page, type="set", values={}, holding=False, along=along)
    last = frame_of(page.shown)
    assert all(span(last, axis) >= span(now, axis) for axis in along)


def span(frame: Frame, axis: str) -> float:
    low, high = frame.ranges[axis]
    return abs(high - low)


def test_the_plane_of_modes_stays_whatever_lets_go() -> None:
    page = Page(SCENES["modes"](view="hunt"))
    for value in (2.0, 0.2):
        say(page, type="set", values={"x1_0": value, "x2_0": value})
    wide = frame_of(page.shown)
    let_go(page)
    assert frame_of(page.shown) == wide


def test_curves_held_count() -> None:
    page = Page(SCENES["oscillator"]())
    sweep(page, "x_0", 2.0)
    state = msgspec.to_builtins(page.now.state)
    say(page, type="open", state={**state, "held": state["parameters"]})
    sweep(page, "x_0", 0.1)
    let_go(page)
    assert frame_of(page.shown).ranges["x"][1] >= 2.0
    check_used(page.shown, page.now.drawn.beside)


@pytest.mark.parametrize("kept", [{"step": "d31/d31-01"}, {"covered": ["next"]}, {"covered": ["plot:v"]}])
def test_a_step_of_a_walk_and_what_waits_to_be_predicted_keep_their_frame(kept: Mapping[str, Any]) -> None:
    page = Page(SCENES["oscillator"]())
    say(page, type="open", state={"scene": "oscillator", **kept})
    sweep(page, "x_0", 5.0, 0.1)
    wide = frame_of(page.shown)
    let_go(page)
    assert frame_of(page.shown) == wide


def test_a_frame_of_a_link_is_kept_and_undo_restores_one() -> None:
    page = Page(SCENES["oscillator"]())
    link = read_query(as_arguments("scene=oscillator&frame.x=-9,9"), SCENES)
    state = {"scene": "oscillator", "frame": msgspec.to_builtins(link.frame)}
    say(page, type="open", state=state)
    sweep(page, "k", 1.0, page.scene.k)
    wide = frame_of(page.shown).ranges["x"]
    frame = let_go(page).frame
    assert frame_of(page.shown).ranges["x"] == wide, "the visitor's own"
    assert frame and frame.given
    say(page, type="open", state={"scene": "oscillator", "parameters": {"v_0": 0.0}})
    sweep(page, "x_0", 0.3)
    before = msgspec.to_builtins(let_go(page))
    sweep(page, "x_0", 0.01)
    assert frame_of(page.shown).ranges["x"][1] > 0.2
    let_go(page)
    say(page, type="open", state=before)  # as undo does
    assert frame_of(page.shown).ranges["x"][1] >= 0.3
    sweep(page, "x_0", 0.01)
    let_go(page)
    assert frame_of(page.shown).ranges["x"][1] < 0.2, "what undo brought back is no frame of the visitor's own"


def test_a_compared_picture_keeps_the_current_frame() -> None:
    """Twice as far is seen to be twice as far, and so is half; another way of showing is fitted."""
    page = Page(SCENES["oscillator"]())
    start = {"scene": "oscillator", "parameters": {"x_0": 0.1, "v_0": 0.0}, "step": "d31/d31-03"}
    say(page, type="open", state=start)
    standing = frame_of(page.shown)
    say(page, type="open", keeps=True, state={**start, "parameters": {"x_0": 0.2, "v_0": 0.0}})
    grown = frame_of(page.shown)
    assert grown.window == standing.window
    assert (standing.ranges["x"][1], grown.ranges["x"][1]) == (0.125, 0.5), "in steps of 1, 2, 5"
    say(page, type="open", keeps=True, state={**start, "parameters": {"x_0": 0.1, "v_0": 0.0, "window": 9.0}})
    assert page.now.state.frame is None
    say(page, type="open", keeps=True, state={"scene": "coupled"})
    assert page.now.state.frame is None


@given(st.floats(1e-6, 1e6), st.floats(0.01, 100.0))
def test_loosening_is_pure_and_the_second_time_does_nothing(size: float, wide: float) -> None:
    axis = nice_axis(-size, size)
    frame, fitted = Frame(ranges={"x": (-wide * size, wide * size)}), Frame(ranges={"x": axis.chosen})
    drawn = [{"x": replace(axis, start=-wide * size, end=wide * size, own=axis.chosen)}]
    loose = loosened(frame, fitted, drawn)
    assert loose == (fitted if wide > 4 else frame)
    assert loosened(loose, fitted, drawn) == loose
    assert loosened(replace(frame, given=True), fitted, drawn) == replace(frame, given=True)
    assert loosened(frame, fitted, [*drawn, {"x": nice_axis(-wide * size, 0.0)}]) == frame


def test_what_a_screen_does_not_tell_apart_is_no_frame_of_its_own() -> None:
    fitted = Frame(ranges={"x": (-1.0, 2.0), "w": (1e-4, 1e3)}, window=10.0)
    assert unfitted(Frame(ranges={"x": (-1.0001, 2.0)}, window=10.001), fitted) is None
    other = Frame(ranges={"w": (2e-4, 1e3)}, window=10.1, given=True)
    assert unfitted(other, fitted) == other
    assert unfitted(FITTED, fitted) is None
