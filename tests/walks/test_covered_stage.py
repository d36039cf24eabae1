"""While the stage is hidden, its bodies stay at their initial positions and no revealing motion is sent."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from components.language.blocks import StageBlock
from components.language.shapes import Begin
from components.language.signals import Derived
from components.layout.sheet import blocks
from components.quantities.instant import instant
from components.quantities.motion import derived
from components.scenes import SCENES
from components.state.covers import PLOT, STAGE, without
from components.state.page_state import PageState
from components.state.scene_sheet import plots
from components.walks.links import page_state_at
from components.walks.loading import load_walks
from components.walks.walk import Step
from tests.page.scripts import played

STEPS = [step for walk in load_walks(()).values() for step in walk.steps if STAGE in step.cover]
every_step = pytest.mark.parametrize("step", STEPS, ids=lambda step: step.id)
RESTING = {"d31-04": "x v", "d31-06": "v", "d34-10": "x2", "tour-04": "x2"}
"""The motions that rest where a hand began them, of steps whose covers hide them."""


def begun(scene: PageState) -> Iterator[tuple[str, float]]:
    """The bodies of the stage and their initial positions from the parameters, in the unit of their axis."""
    for block in blocks(scene.kind.sheet()):
        for shape in block.shapes if isinstance(block, StageBlock) else ():
            for begin in shape.grab.start if shape.grab else ():
                if isinstance(begin, Begin) and begin.of in scene.shown.signals:
                    axis = scene.shown.axes.get(begin.axis)
                    if axis:
                        yield begin.of, axis.place(float(scene.scene.values[begin.parameter])) * begin.size


@every_step
def test_bodies_are_at_their_initial_positions(step: Step) -> None:
    scene = page_state_at(step.state, SCENES)
    left, _ = without(scene.kind, scene.shown, step.cover)
    resting = {name: place for name, place in begun(scene) if left.signals[name] != scene.shown.signals[name]}
    assert resting.keys() >= set(RESTING.get(step.id, "").split())
    for name, place in resting.items():
        for t in (0.0, 0.3):
            assert played(left, t)[name] == pytest.approx(place, rel=1e-12, abs=1e-12), name


def test_a_mode_is_at_rest_where_its_shape_is_asked_for() -> None:
    """Its motion begins at its amplitude, which would reveal the shape."""
    step = next(step for step in STEPS if step.id == "d34-07")
    scene = page_state_at(step.state, SCENES)
    left, _ = without(scene.kind, scene.shown, step.cover)
    bodies = {f"x{i}_{mode}" for i in (1, 2) for mode in ("slow", "fast")}
    assert {scene.shown.signals[name] for name in bodies}.isdisjoint({derived(0.0)})
    assert {name: left.signals[name] for name in bodies} == dict.fromkeys(bodies, derived(0.0))


@every_step
def test_of_what_is_covered_nothing_but_the_start_of_a_body_is_sent(step: Step) -> None:
    """Not the parts of a motion either, whose start is an amplitude."""
    scene = page_state_at(step.state, SCENES)
    left, _ = without(scene.kind, scene.shown, step.cover)
    bodies = {name for name, _ in begun(scene)}
    for plot in plots(scene.kind):
        drawn = {curve.signal for curve in plot.curves if PLOT + plot.name in step.cover} & left.signals.keys()
        for name in drawn - bodies:
            signal = left.signals[name]
            assert isinstance(signal, Derived), name
            assert signal == derived(0.0) or any(term.names for term in signal.value.terms), name


@pytest.mark.parametrize("slug", SCENES)
def test_starts_are_what_is_played_first(slug: str) -> None:
    picture = SCENES[slug]().shown
    first = played(picture, 0.0)
    now = instant(picture.signals, picture.scalars)
    for name in now.keys() & first.keys():
        assert np.isclose(now[name], first[name], rtol=1e-12, atol=1e-12), name
