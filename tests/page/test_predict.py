"""Predict: what is chosen, or all that the next change changes, is not sent until it is revealed."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
import pytest

from components.scenes import SCENES
from components.session import opened
from components.url import read_query
from tests.page.told import Page, change, put
from tests.scenes.checks import as_arguments, moved

scenes = pytest.mark.parametrize("slug", SCENES)


def same(one: Any, other: Any) -> bool:
    return bool(np.array_equal(one, other)) if isinstance(one, np.ndarray) else one == other


@scenes
def test_nothing_that_follows_from_the_next_change_is_sent(slug: str) -> None:
    page = Page(SCENES[slug]())
    before = change(page, covered=["next"])
    assert before["errors"] == {} and before["view"]["left_out"] == [], "until something changes"
    told = put(page, **moved(SCENES[slug]))
    covered = told["state"]["covered"]
    assert told["errors"] == {} and covered[0] == "next" and len(covered) > 1
    view, old = told["view"], before["view"]
    assert [name for name, text in view["values"].items() if old["values"].get(name) != text] == []
    for source, columns in view["columns"].items():
        for name, column in columns.items():
            assert name in old["columns"].get(source, {}) and same(column, old["columns"][source][name]), name
    link = read_query(as_arguments(told["query"]), SCENES)
    assert opened(SCENES, link).state == page.session.state
    told = change(page, covered=[])
    assert told["view"]["left_out"] == [] and told["state"]["covered"] == []


def test_a_view_is_no_change_and_what_is_revealed_one_by_one_stays_so() -> None:
    page = Page(SCENES["coupled"]())
    change(page, covered=["next"])
    told = page.say({"type": "choose", "name": "view", "value": "constants", "number": 60})
    assert told["state"]["covered"] == ["next"]
    told = put(page, k2=5.0)
    assert {"plot:x1", "plot:x2", "value:omega_minus", "stage"} <= set(told["state"]["covered"])
    left = [name for name in told["state"]["covered"] if name not in ("next", "plot:x1")]
    assert change(page, covered=left)["state"]["covered"] == left
    assert put(page, k2=6.0)["state"]["covered"] == left


def test_a_preset_is_a_change_too() -> None:
    page = Page(SCENES["oscillator"]())
    change(page, covered=["next"])
    state = msgspec.to_builtins(page.session.state)
    told = page.say({"type": "open", "state": {**state, "parameters": {"m": 4.0}, "frame": None}, "number": 61})
    assert "plot:x" in told["state"]["covered"] and "value:tau" in told["state"]["covered"]


def test_an_axis_keeps_its_range_and_loses_its_own_numbers() -> None:
    page = Page(SCENES["oscillator"]())
    before = change(page, covered=["next"])["view"]["axes"]["x"]
    told = put(page, v_0=-0.7)
    axis = told["view"]["axes"]["x"]
    assert "numbers:x" in told["state"]["covered"]
    assert (axis["start"], axis["end"]) == (before["start"], before["end"])
    assert page.scene.shown.values["C"] not in "".join(axis["labels"])
