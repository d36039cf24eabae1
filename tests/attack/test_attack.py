"""A short form of `make attack`: a page stays consistent after any link or message."""

from __future__ import annotations

import sys

import pytest
from hypothesis import given, settings

from components.scene import Scene
from components.scenes import SCENES
from tools.attack.extremes import ExtremeValues, Message, messages, queries, values
from tools.attack.visit import follow, visit

scenes = pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES.keys())


@scenes
@pytest.mark.timeout(600)
def test_pages_at_extremes(scene: type[Scene]) -> None:
    @settings(max_examples=15)
    @given(values(scene), messages(scene))
    def page(link: ExtremeValues, sent: list[Message]) -> None:
        visit(scene.slug, link, sent)

    page()


@scenes
def test_malformed_links(scene: type[Scene]) -> None:
    settings(max_examples=15)(given(queries(scene))(follow))()


@scenes
@pytest.mark.parametrize("window", [5e-324, 1e-300, 1.7e308])
def test_extreme_windows(scene: type[Scene], window: float) -> None:
    visit(scene.slug, {}, [{"type": "set", "values": {"window": window}}])


def test_ticks_far_off_their_unit_can_be_read() -> None:
    """A kept frame grows to 5e16 m for the smallest mass on the softest spring. It was once labelled −4e+16."""
    parameters = {"k": 5e-324, "x_0": 0.0, "m": sys.float_info.min}
    state = {"scene": "energy", "parameters": parameters, "frame": {}}
    visit("oscillator", {}, [{"type": "open", "state": state}, {"type": "set", "values": {"m": 5e-324}}])
