"""What can be taken in hand: its names are those of the scene, and a hand that holds on keeps the frame."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from components.description import blocks
from components.page.blocks import PlotBlock, StageBlock
from components.page.shapes import AnyShape, Grab
from components.scene import Scene, frame_of
from components.scenes import SCENES
from physics.analogues import ANALOGUES
from tests.page.told import Page


def grabs(scene: type[Scene]) -> Iterator[tuple[AnyShape, Grab]]:
    for block in blocks(scene.sheet()):
        for shape in block.shapes if isinstance(block, (StageBlock, PlotBlock)) else ():
            if shape.grab:
                yield shape, shape.grab


def shown_with(slug: str, shape: AnyShape, grab: Grab) -> Scene:
    """The scene in a form in which the shape is drawn."""
    ways: list[dict[str, Any]] = [{}, {"show": "limits"}, {"task": "hunt"}]
    ways += [{"system": name} for name in shape.show]
    known = SCENES[slug].linked()
    for values in ways:
        if not values.keys() <= known.keys() or ("system" in values and values["system"] not in ANALOGUES):
            continue
        scene = SCENES[slug](**values)
        if all(way.axis in scene.shown.axes for way in grab.ways if way.axis):
            return scene
    raise AssertionError(f"{slug} never draws {grab.label}")


@pytest.mark.parametrize("slug", SCENES)
def test_what_a_hand_sets_and_moves_is_there(slug: str) -> None:
    for shape, grab in grabs(SCENES[slug]):
        scene = shown_with(slug, shape, grab)
        picture, known = scene.shown, scene.linked()
        for way in grab.ways:
            assert not way.parameter or way.parameter in known, way
            assert not way.rate or way.rate in known, way
            assert way.moves in picture.signals or way.moves in picture.scalars, way
            assert not way.axis or way.axis in picture.axes, way
        for begin in grab.start:
            assert begin.parameter in known, begin
            assert not begin.of or begin.of in picture.signals, begin


def test_most_scenes_can_be_taken_in_hand() -> None:
    held = {slug: {way.parameter for _, grab in grabs(SCENES[slug]) for way in grab.ways} for slug in SCENES}
    assert {"x_0", "v_0"} <= held["oscillator"]
    assert "x_0" in held["energy"]
    assert {"x1_0", "x2_0"} <= held["coupled"] & held["forced"] & held["modes"]
    assert "excess" in held["phugoid"]
    assert {"theta_0", "floating_start", "string_start", "spring_start"} <= held["analogues"]


def test_a_frame_stands_while_a_hand_holds_on_and_grows_when_it_lets_go() -> None:
    page = Page(SCENES["oscillator"]())
    before = frame_of(page.scene.shown)
    page.say({"type": "set", "values": {"x_0": 0.5}, "holding": True, "number": 1})
    assert frame_of(page.scene.shown) == before
    page.say({"type": "set", "values": {}, "holding": False, "number": 2})
    grown = frame_of(page.scene.shown)
    assert grown.ranges["x"][1] >= 0.5 > before.ranges["x"][1]
    assert (grown.window, grown.speed) == (before.window, before.speed)
