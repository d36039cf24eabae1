"""Traces: from signals the browser draws the motion of the physics, with enough points for its fastest part."""

import numpy as np
import pytest

from components.language.signals import Sampled
from components.quantities.axes import TIME_AXIS, Axis
from components.quantities.instant import instant
from components.scene import Picture, Scene
from components.scenes import SCENES
from components.state.scene_sheet import column_axes, plots
from tests.page.headless_page import picture_wire
from tests.scenes.checks import choices, in_any_state

pytestmark = pytest.mark.timeout(600)
TABLES = {"driven", "absorber"}
"""Scenes whose motions are tables in some states."""
NEAR = {"absorber": 1e-7}
"""Of the frame."""
CORNERS = {"x_sliced": 5e-3}
"""The velocity of a sum of slices has a corner at each slice, which sampling cuts off."""
TOLD, CLOSED = 1e-6, 1e-9
"""Error of a motion sent as a table of one period, and of one sent as a formula."""


def axis_of(scene: type[Scene], picture: Picture, source: str, name: str) -> Axis:
    """Return the axis of a curve. For a chain's masses, which are drawn by colour, it is the axis of the signal."""
    return picture.axes[column_axes(scene)[source][name] if source in column_axes(scene) else "y"]


@pytest.mark.parametrize("slug", SCENES)
def test_what_is_drawn_is_the_motion_of_the_physics_with_enough_points(slug: str) -> None:
    kind, checked = SCENES[slug], 0

    def compare(scene: Scene, _: object) -> None:
        nonlocal checked
        checked += check_drawn(scene)
        check_points(scene)

    def drawn(scene: Scene) -> object:
        return [trace.columns for trace in scene.shown.traces.values()]

    ways = (way for way in choices(kind) if not any(kind.linked()[name] in kind.physical for name in way))
    in_any_state(kind, drawn, compare, 0 if slug in TABLES else 48, rare=ways)
    assert checked or not any(plot.time for plot in plots(kind))


def check_drawn(scene: Scene) -> int:
    """Compare each curve that the browser draws with the physics, and return how many there are."""
    shown, wire = scene.shown, picture_wire(scene)["columns"]
    by_table = any(isinstance(one, Sampled) for one in shown.signals.values())
    near = TOLD if by_table else NEAR.get(scene.slug, CLOSED)
    curves = {(source, name): one.columns[name] for source, one in shown.traces.items() for name in one.names}
    for (source, name), exact in curves.items():
        axis = axis_of(type(scene), shown, source, name)
        off = np.abs(wire[source][name] - axis.places(exact)).max() / abs(axis.place(axis.end) - axis.place(axis.start))
        assert off < CORNERS.get(name, near), (dict(scene.values), source, name, off)
        trace, third = shown.traces[source], len(exact) // 3
        now = instant(shown.signals, shown.scalars, shown.axes[TIME_AXIS].place(trace.t[third]))
        signal, size = trace.signals.get(name, name), abs(axis.place(axis.end) - axis.place(axis.start))
        if signal in now:  # not a mass of a chain
            assert now[signal] == pytest.approx(axis.places(exact)[third], abs=1e-6 * size), "in Python too"
    for source, one in shown.traces.items():
        np.testing.assert_allclose(wire[source]["t"], shown.axes[TIME_AXIS].places(one.t), rtol=1e-14, atol=0)
    return len(curves)


def check_points(scene: Scene) -> None:
    """With eight times as many instants a curve reaches as far, apart from what twelve points per cycle miss.

    A motion that ends before the second point is too short to be seen.
    """
    for source, one in scene.shown.traces.items():
        dense = one.exact(np.linspace(0.0, one.end, 8 * (one.count - 1) + 1))
        for name in one.names:
            axis, drawn = axis_of(type(scene), scene.shown, source, name), one.columns[name]
            later = np.append(dense[name][0], dense[name][8:])
            reached = later.max() - drawn.max(), drawn.min() - later.min()
            roundings = 1e-12 * abs(axis.end - axis.start)
            assert 0 <= max(reached) <= 0.035 * np.ptp(dense[name]) + roundings, (dict(scene.values), source, name)
