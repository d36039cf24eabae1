"""The frame after a change: axes, window, scale and speed stay, or grow if they must; Fit fits them again."""

from __future__ import annotations

from typing import Any

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.language.state import Frame
from components.layout.choices import stated
from components.quantities.axes import TIME_AXIS, ordered
from components.scene import Picture, Scene
from components.scene.picture import draw, frame_of
from components.scenes import SCENES
from tests.grids import WHOLE
from tests.page.headless_page import Page
from tests.scenes.checks import check_picture, quantities

scenes = pytest.mark.parametrize("slug", SCENES)
MOVING = [slug for slug in SCENES if slug != "accuracy"]
WHOLLY_SEEN = {"oscillator": "x v a", "energy": "x T V", "coupled": "x1 x2", "analogues": "q", "phugoid": "h v"}
"""Columns over time that no frame cuts, by scene."""
steps = st.lists(st.tuples(st.integers(0, 50), st.floats(0.0, 1.0)), min_size=1, max_size=6)


def page_of(slug: str) -> Page:
    return Page(SCENES[slug]())


def set_value(page: Page, values: dict[str, Any]) -> dict[str, Any]:
    return page.send({"type": "set", "values": values, "number": len(page.packets) + 1})


def fit(page: Page) -> dict[str, Any]:
    state = {**msgspec.to_builtins(page.now.state), "frame": None}
    return page.send({"type": "open", "state": state, "number": len(page.packets) + 1})


def holds(wide: Frame, narrow: Frame) -> bool:
    """Whether the one has room for all of the other."""
    pairs = [(ordered(wide.ranges[name]), ordered(span)) for name, span in narrow.ranges.items()]
    return all(one[0] <= other[0] and other[1] <= one[1] for one, other in pairs)


def standing(scene: Scene) -> Frame:
    return frame_of(scene.shown)


def check_nothing_outside(slug: str, shown: Picture) -> None:
    for name, axis in shown.axes.items():
        (low, high), (least, most) = ordered((axis.start, axis.end)), axis.seen
        slack = 1e-9 * max(abs(low), abs(high))
        assert low - slack <= least <= most <= high + slack or name == TIME_AXIS, (name, axis)
    for name in WHOLLY_SEEN.get(slug, "").split():
        column = shown.sources["time"].get(name)
        if column is not None:
            # The energies of the hanging mass share an axis, and so do the displacements of the chain.
            axis = shown.axes.get(name, shown.axes.get({"x1": "x", "x2": "x"}.get(name, "E")))
            low, high = ordered((axis.start, axis.end)) if axis else (0.0, 0.0)
            assert low <= column.min() <= column.max() <= high, name


@pytest.mark.parametrize("slug", MOVING)
@given(steps=steps)
@settings(max_examples=40 if WHOLE else 8)
def test_walks_of_values_never_shrink_a_frame_nor_leave_it(slug: str, steps: list[tuple[int, float]]) -> None:
    page, ranges = page_of(slug), quantities(SCENES[slug])
    names = list(ranges)
    for which, share in steps:
        name = names[which % len(names)]
        low, high = page.shown.spans.get(name, ranges[name].softbounds)
        value = low + share * (high - low)
        before = page.now.drawn.frame
        told = set_value(page, {name: round(value) if ranges[name].scale == "count" else value})
        after = page.now.drawn.frame
        if told["errors"]:
            assert after == before
            continue
        assert holds(after, before), (name, value)
        assert (after.window, after.speed) == (before.window, before.speed)
        assert (after.scale or 0) <= (before.scale or 0)
        check_nothing_outside(slug, page.shown)
        # The same change again has no effect, so the frame does not flip back and forth.
        set_value(page, {name: msgspec.to_builtins(getattr(page.scene, name))})
        assert page.now.drawn.frame == after
    check_picture(page.now)
    told = fit(page)
    assert told["errors"] or told["state"]["frame"] is None  # a window that fits may be beyond all doubles
    values = {name: getattr(page.scene, name) for name in page.scene.linked()}
    assert page.now.drawn.frame == standing(SCENES[slug](**values)), "Fit is the frame of a fresh page"


@scenes
def test_a_preset_fits(slug: str) -> None:
    page = page_of(slug)
    for label, values in SCENES[slug].presets.items():
        set_value(page, {"window": 3.0})
        state = {"scene": slug, "parameters": {name: stated(value) for name, value in values.items()}}
        told = page.send({"type": "open", "state": state, "number": len(page.packets) + 1})
        assert told["errors"] == {}
        fresh = Page(SCENES[slug](**values)).opening()
        assert told["state"]["frame"] is None
        assert told["view"]["axes"] == fresh["view"]["axes"], label
        assert told["view"]["pace"] == fresh["view"]["pace"]


def test_another_window_is_chosen_by_its_field() -> None:
    page = page_of("coupled")
    set_value(page, {"k2": 3.0})
    told = set_value(page, {"window": 5.0})
    assert told["view"]["axes"]["t"]["end"] == 5.0
    told = set_value(page, {"k2": 2.0})
    assert told["view"]["axes"]["t"]["end"] == 5.0
    assert set_value(page, {"window": None})["view"]["axes"]["t"]["end"] == draw(page_of("coupled").scene).frame.window


def test_another_way_of_showing_fits_what_it_changes_and_nothing_else() -> None:
    page = page_of("energy")
    set_value(page, {"x_0": 0.05})
    small = page.now.drawn.frame
    page.send({"type": "choose", "name": "datum", "value": "separate", "number": 50})
    after = page.now.drawn.frame
    assert after.ranges["x"] == small.ranges["x"]
    assert after.ranges["E"] == draw(page.scene).frame.ranges["E"]
    page = page_of("analogues")
    page.send({"type": "choose", "name": "system", "value": "spring", "number": 50})
    assert page.now.state.frame is None, "another system is another scene"


def test_where_nothing_can_be_drawn_in_the_frame_it_is_fitted() -> None:
    """A window of many years is no place for a quick motion of many digits."""
    page = page_of("coupled")
    set_value(page, {"x1_0": 1.7e308})
    check_picture(page.now)
    told = set_value(page, {"x1_0": 1e-3})
    assert told["errors"] == {}
    check_picture(page.now)
