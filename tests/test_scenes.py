"""What every scene keeps to: one solve a change, presets, links, refusals, and pictures that stay finite."""

from __future__ import annotations

import itertools
import json
from typing import Any

import numpy as np
import pytest

from components.controls import apply_message
from components.scene import Scene
from components.scenes import SCENES
from components.url import read_query, write_query
from components.view import SceneView
from tests.scene_checks import check_picture, corners, quantities, typed

scenes = pytest.mark.parametrize("scene_class", SCENES.values(), ids=SCENES.keys())


def as_arguments(query: str) -> dict[str, list[bytes]]:
    from urllib.parse import parse_qs

    return {name: [v.encode() for v in values] for name, values in parse_qs(query, keep_blank_values=True).items()}


def solves(scene: Scene) -> list[Any]:
    counted: list[Any] = []
    scene.on_picture(counted.append)
    return counted


def test_scenes_stand_in_the_lectures_order() -> None:
    order = ["oscillator", "energy", "analogues", "phugoid", "coupled", "modes", "forced", "absorber", "accuracy"]
    assert list(SCENES) == [slug for slug in order if slug in SCENES]


@scenes
def test_first_picture(scene_class: type[Scene]) -> None:
    check_picture(scene_class())


@scenes
def test_one_solve_a_change(scene_class: type[Scene]) -> None:
    scene = scene_class()
    name, quantity = next(iter(quantities(scene_class).items()))
    counted = solves(scene)
    setattr(scene, name, quantity.softbounds[1])
    assert len(counted) == 1


@scenes
def test_every_preset_is_one_solve_and_is_recognised(scene_class: type[Scene]) -> None:
    scene = scene_class()
    for label in scene.presets:
        scene.set({name: scene.preset_value(label, name) for name in scene.preset_names()})
        counted = solves(scene)
        other = next(iter(quantities(scene_class)))
        scene.set({other: getattr(scene, other)})
        assert scene.preset() == label
        check_picture(scene)
        assert len(counted) <= 1


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
    assert len(counted) <= 1


@scenes
def test_a_bad_value_is_told_at_its_control(scene_class: type[Scene]) -> None:
    scene = scene_class()
    name = next(iter(quantities(scene_class)))
    before = scene.shown
    for text in ("", "many", "nan", "1e999"):
        errors = apply_message(scene, {"type": "typed", "name": name, "text": text})
        assert list(errors) == [name]
        assert errors[name].endswith(".")
    assert scene.shown is before


@scenes
def test_link_round_trip(scene_class: type[Scene]) -> None:
    scene = scene_class()
    assert write_query(scene) == f"scene={scene.slug}"
    changed = {name: q.softbounds[1] for name, q in list(quantities(scene_class).items())[:2]}
    scene.set({**changed, "window": 12.5})
    link = read_query(as_arguments(write_query(scene)), SCENES)
    assert (link.slug, link.problems) == (scene.slug, [])
    again = scene_class()
    again.set(link.values)
    assert again.param.values() | {"name": ""} == scene.param.values() | {"name": ""}


@scenes
def test_what_is_sent_is_the_picture(scene_class: type[Scene]) -> None:
    view = SceneView(scene_class())
    sent: list[dict[str, Any]] = []
    view._send_msg = sent.append  # type: ignore[method-assign]
    name, quantity = next(iter(quantities(scene_class).items()))
    view._handle_msg({"type": "set", "values": {name: quantity.softbounds[1]}, "number": 1})
    assert len(sent) == 1
    facts, numbers = json.loads(sent[0]["facts"]), sent[0]["numbers"]
    assert facts["answer"] == 1
    assert view.value[name] == quantity.softbounds[1]
    message = view.message()
    assert facts["query"] == message["query"]
    ends = itertools.accumulate(length for columns in facts["columns"].values() for length in columns.values())
    columns = [column for data in message["columns"].values() for column in data.values()]
    assert numbers.dtype == np.float32
    assert len(numbers) == sum(map(len, columns))
    for end, column in zip(ends, columns, strict=True):
        assert np.array_equal(numbers[end - len(column) : end], column)


@scenes
def test_csv_holds_every_column(scene_class: type[Scene]) -> None:
    view = SceneView(scene_class())
    sent: list[dict[str, Any]] = []
    view._send_msg = sent.append  # type: ignore[method-assign]
    view._handle_msg({"type": "csv"})
    header = sent[0]["text"].splitlines()[1].split(",")
    assert set(header) == {f"{s}.{c}" for s, data in view.scene.sources.items() for c in data.data}


@scenes
def test_corners_of_all_sliders(scene_class: type[Scene]) -> None:
    scene = scene_class()
    drawn = 0
    for values in corners(scene_class):
        try:
            scene.set(values)
        except ValueError as reason:
            assert str(reason)
            continue
        drawn += 1
        check_picture(scene)
    assert drawn


@scenes
def test_values_far_beyond_the_sliders(scene_class: type[Scene]) -> None:
    drawn = refused = 0
    for values in typed(scene_class):
        scene = scene_class()
        before = scene.shown
        try:
            scene.set(values)
        except ValueError as reason:
            assert str(reason), values
            assert scene.shown is before
            refused += 1
            continue
        drawn += 1
        check_picture(scene)
    assert drawn > refused
