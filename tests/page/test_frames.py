"""The frame of a picture stays or grows while values change; Fit, presets and letting go fit it again. The compared
picture is drawn in it, and a table compares the numbers of both.
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from components.language.state import Frame
from components.quantities.axes import TIME_AXIS, Axis, nice_axis, ordered
from components.scene.frames import FITTED, grown
from components.scene.picture import draw, frame_of
from components.scenes import SCENES
from components.state.encoding import COARSE, span
from components.state.scene_sheet import column_axes
from tests.grids import sample
from tests.page.hand import grabs
from tests.page.headless_page import Page, change, say, set_values
from tests.scenes.checks import changes, quantities

scenes = pytest.mark.parametrize("slug", SCENES)
MOVING = [slug for slug in SCENES if slug != "accuracy"]
spans = st.tuples(st.floats(-1e6, 1e6), st.floats(1e-6, 1e6)).map(lambda pair: (pair[0], pair[0] + pair[1]))


def frame(page: Page) -> Frame:
    return page.now.drawn.frame


def let_go(page: Page, **more: Any) -> dict[str, Any]:
    told = say(page, "set", values={}, holding=False, **more)
    assert told["type"] == "kept" or told["errors"] == {}
    return told


@scenes
def test_a_picture_keeps_to_its_frame(slug: str) -> None:
    """In the fitted frame it is what it is without one. In a wider one the axes have the requested ranges."""
    for scene in (SCENES[slug](), *(SCENES[slug](**values) for values in SCENES[slug].presets.values())):
        fitted = draw(scene.value).frame
        for part in ("axes", "signals", "scalars", "values", "pace", "sources"):
            np.testing.assert_equal(getattr(scene.picture(fitted), part), getattr(scene.shown, part))
        assert frame_of(scene.picture(FITTED)) == fitted
        wide = {name: (start, end + 0.5 * (end - start)) for name, (start, end) in fitted.ranges.items()}
        window = fitted.window and 2 * fitted.window
        wide |= {TIME_AXIS: (0.0, window)} if window else {}
        for name, axis in scene.picture(replace(fitted, ranges=wide, window=window)).axes.items():
            assert (axis.start, axis.end) == pytest.approx(wide[name], rel=1e-12), name
            low, high = sorted((axis.place(axis.start), axis.place(axis.end)))
            assert all(low - 1e-9 <= tick <= high + 1e-9 for tick in axis.ticks)


@given(spans, spans)
def test_a_frame_grows_in_round_steps_and_never_shrinks(has: tuple[float, float], needs: tuple[float, float]) -> None:
    axes = {"x": nice_axis(*needs)}
    larger = grown(Frame(ranges={"x": has}), axes)
    low, high = larger.ranges["x"]
    assert low <= min(has[0], needs[0] + 1e-9 * abs(needs[0]))
    assert high >= max(has[1], needs[1] - 1e-9 * abs(needs[1]))
    for value, old in ((low, has[0]), (high, has[1])):
        if value != old and value:
            assert round(abs(value) / 10.0 ** math.floor(math.log10(abs(value)) + 1e-9), 9) in (1, 2, 5, 10)
    if has[0] <= needs[0] and needs[1] <= has[1]:
        assert (low, high) == has, "what is still in the frame moves nothing"
    assert grown(larger, axes) == larger


def check_grown(page: Page, before: Frame) -> None:
    """After a change: every axis has room for all of its old range, and nothing is outside."""
    after = frame(page)
    for name, ends in before.ranges.items():
        (low, high), (least, most) = ordered(after.ranges[name]), ordered(ends)
        assert low <= least and most <= high, name
    assert (after.window, after.speed) == (before.window, before.speed)
    assert (after.scale or 0) <= (before.scale or 0)
    for name, axis in page.shown.axes.items():
        (low, high), (least, most) = ordered((axis.start, axis.end)), axis.seen
        slack = 1e-9 * max(abs(low), abs(high))
        assert low - slack <= least <= most <= high + slack or name == TIME_AXIS, (name, axis)


def check_used(page: Page) -> None:
    """Every axis is used to a quarter, or is no longer than the one that would be chosen."""

    def share(axis: Axis, seen: tuple[float, float]) -> float:
        low, high, start, end = (axis.place(one) for one in (*seen, axis.start, axis.end))
        return abs(high - low) / abs(end - start)

    for name, axis in page.shown.axes.items():
        assert name == TIME_AXIS or share(axis, axis.seen) >= 0.25 or share(axis, axis.chosen) >= 0.999, (name, axis)


@pytest.mark.parametrize("slug", MOVING)
def test_a_frame_grows_with_a_value_and_is_fitted_once_when_it_is_let_go(slug: str) -> None:
    for name, quantity in sample(list(quantities(SCENES[slug]).items()), 3):
        page = Page(SCENES[slug]())
        low, high = page.shown.spans.get(name, quantity.softbounds)
        window, value = frame(page).window, getattr(page.scene, name)
        for part in (0.0, 1.0, 0.4):
            before, to = frame(page), low + part * (high - low)
            told = set_values(page, **{name: round(to) if quantity.scale == "count" else to})
            if told["errors"]:
                assert frame(page) == before
                continue
            check_grown(page, before)
            after = frame(page)
            set_values(page, **{name: getattr(page.scene, name)})
            assert frame(page) == after, "the same change again has no effect"
        set_values(page, **{name: value})
        let_go(page)
        check_used(page)
        fitted = frame(page)
        assert fitted.window == window, "curves fill the window"
        let_go(page)
        assert frame(page) == fitted, "once"
        told = change(page, frame=None)
        assert told["state"]["frame"] is None
        assert frame(page) == frame_of(SCENES[slug](**page.scene.values).shown), "Fit is the frame of a fresh page"


@pytest.mark.parametrize("slug", MOVING)
def test_the_axes_that_a_hand_moves_along_stay_and_the_others_grow(slug: str) -> None:
    """During a drag, by much and by little; at its end, by little."""
    for grab in [one for _, one in grabs(SCENES[slug]) if one.ways[0].parameter]:
        page, name = Page(SCENES[slug]()), grab.ways[0].parameter
        along = sorted({way.axis for way in grab.ways if way.axis in page.shown.axes})
        _, high = page.shown.spans.get(name, quantities(SCENES[slug])[name].softbounds)
        before = frame(page)
        for part in (1.0, 0.9, 0.03):
            say(page, "set", values={name: part * high}, holding=True, along=along)
            now = frame(page)
            assert all(now.ranges[axis] == before.ranges[axis] for axis in along), grab.label
            assert (now.scale, now.window) == (before.scale, before.window), grab.label
            for axis in set(page.shown.axes) - {*along, TIME_AXIS} if along else ():
                (low, top), (least, most) = sorted(now.ranges[axis]), page.shown.axes[axis].seen
                assert low <= least and most <= top, (grab.label, axis)
        let_go(page, along=along)
        for axis in along:
            assert abs(np.diff(frame(page).ranges[axis])) >= abs(np.diff(now.ranges[axis])), grab.label


def test_a_chosen_window_stays_and_another_way_of_showing_fits_what_it_changes_and_nothing_else() -> None:
    page = Page(SCENES["energy"]())
    own = frame(page).window
    for values, end in (({"x_0": 0.05}, own), ({"window": 5.0}, 5.0), ({"x_0": 0.06}, 5.0), ({"window": None}, own)):
        assert set_values(page, **values)["view"]["axes"]["t"]["end"] == end
    small = frame(page)
    say(page, "choose", name="datum", value="separate")
    assert frame(page).ranges["x"] == small.ranges["x"]
    assert frame(page).ranges["E"] == draw(page.scene).frame.ranges["E"]


@pytest.mark.parametrize(
    ("slug", "name", "state"),
    [
        ("modes", "x1_0", {"parameters": {"view": "hunt"}}),
        *(("oscillator", "x_0", {"covered": [cover]}) for cover in ("next", "plot:v")),
        ("oscillator", "x_0", {"step": "d31/d31-01"}),
        ("oscillator", "x_0", {"frame": {"ranges": {"x": [-9.0, 9.0]}, "given": True}}),
    ],
)
def test_a_frame_that_is_not_the_pages_own_stays(slug: str, name: str, state: Mapping[str, Any]) -> None:
    """In a plane of modes, a step of a walk, a prediction, and the frame of a link."""
    page = Page(SCENES[slug]())
    say(page, "open", state={"scene": slug, **state})
    for value in (2.0, 0.1):
        set_values(page, **{name: value})
    wide = frame(page)
    let_go(page)
    assert frame(page) == wide


def test_a_compared_picture_keeps_the_current_frame() -> None:
    """Twice as far is seen to be twice as far, and so is half; another way of showing is fitted."""
    page = Page(SCENES["oscillator"]())
    start: dict[str, Any] = {"scene": "oscillator", "parameters": {"x_0": 0.1, "v_0": 0.0}, "step": "d31/d31-03"}
    say(page, "open", state=start)
    before = frame(page)
    say(page, "open", keeps=True, state={**start, "parameters": {"x_0": 0.2, "v_0": 0.0}})
    after = frame(page)
    assert after.window == before.window
    assert (before.ranges["x"][1], after.ranges["x"][1]) == (0.125, 0.5), "in steps of 1, 2, 5"
    for other in ({**start, "parameters": {"x_0": 0.1, "v_0": 0.0, "window": 9.0}}, {"scene": "coupled"}):
        say(page, "open", keeps=True, state=other)
        assert page.now.state.frame is None


@scenes
def test_the_compared_picture_is_the_earlier_one_in_the_current_frame(slug: str) -> None:
    page = Page(SCENES[slug]())
    told = change(page, held={})
    assert told["errors"] == {} and told["state"]["held"] == {}
    assert (told["held"]["columns"], told["held"]["values"]) == ({}, {}), "nothing has changed yet"
    value = next(changes(SCENES[slug]))
    told = set_values(page, **value)
    assert told["errors"] == {} and set(told["held"]["values"]) >= set(value)
    assert page.now.drawn.beside
    wanted = SCENES[slug]().picture(frame_of(page.now.drawn.beside))
    axes = column_axes(SCENES[slug])
    for source, columns in told["held"]["columns"].items():
        for name, column in columns.items():
            axis = page.shown.axes[axes[source].get(name, TIME_AXIS)]
            low, high = span(axis.ruler)
            true = np.clip(axis.places(wanted.sources[source][name]), low, high)
            assert np.allclose(np.clip(column, low, high), true, rtol=1e-6, atol=0.51 * (high - low) / COARSE)


def test_the_ledger_says_what_became_of_each_number_and_hides_it_by_each_of_its_names() -> None:
    page = Page(SCENES["oscillator"]())
    change(page, held={})
    told = set_values(page, m=4.0)["held"]["ledger"]
    rows = [tuple(row[part] for part in ("held", "now", "unit", "ratio")) for row in told]
    assert rows[:3] == [("1.00", "4.00", "kg", "× 4"), ("6.28", "3.14", "rad/s", "× ½"), ("1.00", "2.00", "s", "× 2")]
    assert rows[4] == ("2.48", "2.77", "rad", "+0.291")
    assert [row[3] for row in rows[5:]] == ["same", "same", "same"]
    page = Page(SCENES["modes"]())
    change(page, held={})
    covers = ["value:fast_omega", "value:now_ratio_slow"]
    told = change(page, parameters={"view": "solve", "k2": 3.0}, covered=covers)
    hidden = [(row["tint"], row["unit"], row["ratio"]) for row in told["held"]["ledger"] if row["now"] == "?"]
    assert sorted(hidden) == [("fast", "rad/s", "?"), ("slow", "", "?")]
