"""The frame is an immutable value: fit, grow and picture are pure functions, and a session keeps a given frame."""

from __future__ import annotations

import math
from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from components.language.state import Frame
from components.quantities.axes import nice_axis
from components.scene import Picture, Scene
from components.scene.frames import FITTED, checked, grown
from components.scene.picture import draw, frame_of
from components.scenes import SCENES
from tests.page.headless_page import Page
from tests.page.scripts import played

scenes = pytest.mark.parametrize("slug", SCENES)
SINES = ("oscillator", "energy", "coupled")
"""Scenes whose curves over time are exactly the motion that the clock plays."""
spans = st.tuples(st.floats(-1e6, 1e6), st.floats(1e-6, 1e6)).map(lambda pair: (pair[0], pair[0] + pair[1]))


def each(slug: str) -> list[Scene]:
    """The scene and its presets."""
    scene = SCENES[slug]
    return [scene(), *(scene(**values) for values in scene.presets.values())]


def same(one: Picture, other: Picture) -> None:
    assert one.axes == other.axes
    assert (one.signals, one.scalars, one.values, one.pace) == (other.signals, other.scalars, other.values, other.pace)
    assert one.sources.keys() == other.sources.keys()
    for source, columns in one.sources.items():
        for name, column in columns.items():
            np.testing.assert_array_equal(column, other.sources[source][name])


@scenes
def test_in_the_fitted_frame_a_picture_is_what_it_is_without_one(slug: str) -> None:
    for scene in each(slug):
        same(scene.picture(draw(scene.value).frame), scene.shown)
        assert frame_of(scene.picture(FITTED)) == draw(scene.value).frame


def wider(frame: Frame) -> Frame:
    """Every range half as wide again to the right, and twice the window."""
    ranges = {name: (start, end + 0.5 * (end - start)) for name, (start, end) in frame.ranges.items()}
    window = frame.window and 2 * frame.window
    if window:
        ranges["t"] = (0.0, window)
    return msgspec.structs.replace(frame, ranges=ranges, window=window)


@scenes
def test_a_picture_keeps_to_its_frame(slug: str) -> None:
    """The axes have the requested ranges, and the played motion stays on the curves."""
    for scene in each(slug):
        frame = wider(draw(scene.value).frame)
        picture = scene.picture(frame)
        for name, axis in picture.axes.items():
            assert (axis.start, axis.end) == pytest.approx(frame.ranges[name], rel=1e-12), name
            low, high = sorted((axis.place(axis.start), axis.place(axis.end)))
            assert all(low - 1e-9 <= tick <= high + 1e-9 for tick in axis.ticks)
        if slug not in SINES:
            continue
        assert picture.sources.get("time", {"t": [frame.window]})["t"][-1] == pytest.approx(frame.window)
        for name, column in picture.sources.get("time", {}).items():
            if name in picture.signals and name in picture.axes:
                at = picture.axes["t"].places(picture.sources["time"]["t"])
                places, size = picture.axes[name].places(column), picture.axes[name]
                reach = abs(size.place(size.end)) + abs(size.place(size.start))
                np.testing.assert_allclose(played(picture, at)[name], places, atol=1e-9 * reach)


@given(spans, spans)
def test_a_frame_grows_in_round_steps_and_never_shrinks(has: tuple[float, float], needs: tuple[float, float]) -> None:
    axes = {"x": nice_axis(*needs)}
    frame = grown(Frame(ranges={"x": has}), axes)
    low, high = frame.ranges["x"]
    assert low <= min(has[0], needs[0] + 1e-9 * abs(needs[0]))
    assert high >= max(has[1], needs[1] - 1e-9 * abs(needs[1]))
    for value, old in ((low, has[0]), (high, has[1])):
        if value != old and value:
            assert round(abs(value) / 10.0 ** math.floor(math.log10(abs(value)) + 1e-9), 9) in (1, 2, 5, 10)
    if has[0] <= needs[0] and needs[1] <= has[1]:
        assert (low, high) == has, "what is still in the frame moves nothing"
    assert grown(frame, axes) == frame


def test_what_fits_its_frame_is_drawn_once_though_its_own_window_is_longer() -> None:
    scene = SCENES["coupled"]()
    fitted = draw(scene.value).frame
    assert fitted.window
    pictures = []

    class Counted:
        key = object()

        def picture(self, frame: Frame) -> Picture:
            pictures.append(scene.picture(frame))
            return pictures[-1]

    frame = replace(wider(fitted), window=fitted.window / 2)
    assert draw(Counted(), None, "grown", frame).frame.window == fitted.window / 2
    assert len(pictures) == 1


def test_an_axis_in_a_unit_of_1e_306_may_have_the_range_of_a_page() -> None:
    page = Page(SCENES["phugoid"]())
    before = page.now.drawn.frame
    told = page.send({"type": "set", "values": {"excess": 5e-324}, "number": 1})
    assert told["errors"] == {} and page.now.drawn.frame.ranges["h"] == before.ranges["h"]


def opened(page: Page, **state: Any) -> dict[str, Any]:
    return page.send({"type": "open", "state": {"scene": "coupled", **state}, "number": len(page.packets) + 1})


@pytest.mark.parametrize(
    ("frame", "says"),
    [
        ({"ranges": {"x": [1.0, 1.0]}}, "its ends must differ"),
        ({"window": 0.0}, "window of a frame"),
        ({"speed": -1.0}, "speed of a frame"),
        ({"scale": 0.0}, "scale of a frame"),
    ],
)
def test_a_frame_that_nothing_can_be_drawn_in_is_refused(frame: dict[str, Any], says: str) -> None:
    page = Page(SCENES["coupled"](k2=3.0))
    before = page.opening()
    told = opened(page, frame=frame)
    assert says in told["errors"]["state"]
    assert (told["state"], told["query"]) == (before["state"], before["query"])
    with pytest.raises(ValueError, match=says):
        checked(msgspec.convert(frame, Frame))
