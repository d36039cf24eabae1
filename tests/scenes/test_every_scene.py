"""The contract of every scene: one solve a change, presets, links, refusals, and pictures that stay finite."""

from __future__ import annotations

import numpy as np
import pytest

from components.quantities.axes import TIME_AXIS
from components.scene import Scene
from components.scenes import SCENES
from components.state.encoding import COARSE, span
from components.state.scene_sheet import column_axes
from tests.page.headless_page import Page, apply_message, take_preset
from tests.scenes.checks import check_picture, choices, quantities, solves

MOST_BYTES = {"phugoid": 5000}
"""Of a change, where 3000 are not enough."""
scenes = pytest.mark.parametrize("scene_class", SCENES.values(), ids=SCENES.keys())


@scenes
def test_one_solve_a_change(scene_class: type[Scene]) -> None:
    scene = scene_class()
    name, quantity = next(iter(quantities(scene_class).items()))
    counted = solves(scene)
    setattr(scene, name, quantity.softbounds[1])
    assert len(counted) == 1
    for choice in choices(scene_class):
        counted.clear()
        is_another = bool(scene.differing(choice))
        scene.set(choice)
        assert len(counted) == is_another, choice


@scenes
def test_every_preset_is_one_solve_and_is_recognised(scene_class: type[Scene]) -> None:
    scene = scene_class()
    for label in scene.presets:
        values = {name: scene.preset_value(label, name) for name in scene.preset_names()}
        is_there = all(getattr(scene, name) == value for name, value in values.items())
        counted = solves(scene)
        assert take_preset(scene, label) == {}
        assert len(counted) == (0 if is_there else 1), label
        assert scene.preset() == label
        check_picture(scene)


@scenes
def test_a_refused_batch_changes_nothing(scene_class: type[Scene]) -> None:
    scene = scene_class()
    names = list(quantities(scene_class))
    before = scene.param.values(), scene.shown
    with pytest.raises(ValueError, match=r"not possible|finite"):
        scene.param.update({names[0]: quantities(scene_class)[names[0]].softbounds[1], names[-1]: float("nan")})
    assert (scene.param.values(), scene.shown) == before
    counted = solves(scene)
    scene.set({names[0]: quantities(scene_class)[names[0]].softbounds[0]})
    assert len(counted) == 1


@scenes
def test_the_result_is_described_only_for_a_single_change(
    scene_class: type[Scene], monkeypatch: pytest.MonkeyPatch
) -> None:
    scene = scene_class()
    first, *_, last = quantities(scene_class)
    low = quantities(scene_class)[first].softbounds[0]
    before = scene.shown
    for refused in ({first: low, last: float("nan")}, {first: low, "nothing": 1.0}):
        with pytest.raises(ValueError, match=r"not possible|nothing: not a parameter"):
            scene.set(refused)
    assert scene.shown is before
    told: list[frozenset[str]] = []
    following = scene.following
    monkeypatch.setattr(
        scene_class,
        "following",
        lambda _, changed, *rest, **more: told.append(changed) or following(changed, *rest, **more),
    )
    scene.set({last: scene.values[last], first: low})
    assert told == [{first}]


def test_sources_hold_what_another_view_draws_and_nothing_of_the_one_before() -> None:
    scene = SCENES["accuracy"]()
    assert scene.sources.keys() == scene.shown.sources.keys()
    for view in ("growth", "stability", "time"):
        scene.set({"view": view})
        data = {name: dict(source.data) for name, source in scene.sources.items() if source.data}
        assert data.keys() == {name for name, columns in scene.shown.sources.items() if columns}


@scenes
def test_a_refused_value_is_reported_at_its_control(scene_class: type[Scene]) -> None:
    scene = scene_class()
    before, values = scene.shown, dict(scene.param.values())
    for name, quantity in quantities(scene_class).items():
        beyond = [text for text in ("-1", "0") if quantity.refusal(float(text))]
        for text in ("", "many", "nan", "1e999", *beyond):
            errors = apply_message(scene, {"type": "typed", "name": name, "text": text})
            assert list(errors) == [name]
            assert errors[name].endswith(".")
    assert scene.shown is before and dict(scene.param.values()) == values


@scenes
def test_what_is_sent_is_the_picture(scene_class: type[Scene]) -> None:
    parts = [part for view in scene_class.views for part in view.names if part.startswith("plot:")]
    drawn = next(view.slug for view in scene_class.views if parts[0] in view.names)
    page = Page(scene_class(view=drawn))
    name, quantity = next(iter(quantities(scene_class).items()))
    told = page.send({"type": "set", "values": {name: quantity.softbounds[1]}, "number": 1})
    assert (told["type"], told["answer"], told["errors"]) == ("shown", 1, {})
    assert told["state"]["parameters"][name] == quantity.softbounds[1]
    picture, sent = page.shown, 0
    for source, columns in told["view"]["columns"].items():
        for column, places in columns.items():
            axis = picture.axes[column_axes(scene_class)[source].get(column, TIME_AXIS)]
            low, high = span(axis.ruler)
            true = np.clip(axis.places(picture.sources[source][column]), low, high)
            assert np.allclose(np.clip(places, low, high), true, rtol=1e-6, atol=0.51 * (high - low) / COARSE)
            sent += 1
    assert sent == sum(len(columns) for columns in told["view"]["columns"].values()) > 0


@scenes
def test_a_change_is_small(scene_class: type[Scene]) -> None:
    page = Page(scene_class())
    for number, (name, quantity) in enumerate(quantities(scene_class).items(), start=1):
        low, high = quantity.softbounds
        value = 1.1 * (quantity.default or 0.1 * high)
        page.send({"type": "set", "values": {name: min(max(value, low), high)}, "number": 2 * number})
        page.send({"type": "set", "values": {name: quantity.default}, "number": 2 * number + 1})
    around = 340  # bytes of the frames that Bokeh sends with it
    assert max(len(packet["data"]) for packet in page.packets) + around <= MOST_BYTES.get(scene_class.slug, 3000)
