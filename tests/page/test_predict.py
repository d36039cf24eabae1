"""Predict: chosen parts, or everything that the next change affects, are sent only when they are revealed."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Any

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace

from components.quantities.axes import round_ticks
from components.quantities.formatting import three
from components.scene import Scene
from components.scenes import SCENES
from components.session.opening import opened
from components.state.csv_export import tables
from components.state.link import read_query
from components.state.wire import as_json
from tests.page.headless_page import Page, change, set_values
from tests.scenes.checks import as_arguments, moved, quantities

NUMBER = re.compile(r"[0-9][0-9.]*")
"""Digits of a number in a text."""
scenes = pytest.mark.parametrize("slug", SCENES)


def same(one: Any, other: Any) -> bool:
    return bool(np.array_equal(one, other)) if isinstance(one, np.ndarray) else one == other


@scenes
def test_nothing_that_follows_from_the_next_change_is_sent(slug: str) -> None:
    page = Page(SCENES[slug]())
    before = change(page, covered=["next"])
    assert before["errors"] == {} and before["view"]["left_out"] == [], "until something changes"
    told = set_values(page, **moved(SCENES[slug]))
    covered = told["state"]["covered"]
    assert told["errors"] == {} and covered[0] == "next" and len(covered) > 1
    view, old = told["view"], before["view"]
    assert [name for name, text in view["values"].items() if old["values"].get(name) != text] == []
    for source, columns in view["columns"].items():
        for name, column in columns.items():
            assert name in old["columns"].get(source, {}) and same(column, old["columns"][source][name]), name
    link = read_query(as_arguments(told["query"]), SCENES)
    assert opened(SCENES, link).now.state == page.now.state
    told = change(page, covered=[])
    assert told["view"]["left_out"] == [] and told["state"]["covered"] == []


@scenes
def test_no_number_that_follows_from_a_change_is_in_any_message(slug: str) -> None:
    for values in changes(SCENES[slug]):
        page = Page(SCENES[slug]())
        seen = numbers([change(page, covered=["next"], held={}), csv_of(page), round_numbers(page)])
        told = set_values(page, **values)
        assert told["errors"] == {} and told["state"]["before"] == {}, values
        given = numbers([set_by_hand(told), told["state"]["parameters"], told["query"], _ratio(SCENES[slug], values)])
        outcome = numbers(told_of_scene(page)) - seen - given
        assert outcome, f"nothing follows from {values}"
        assert outcome & numbers([told, csv_of(page)]) == set(), values


def _ratio(scene: type[Scene], values: dict[str, float]) -> str:
    """Return the ratio of the set value to its default, as the comparison writes it."""
    ((name, value),) = values.items()
    default = scene.param[name].default
    return three(value / default) if default else ""


def changes(scene: type[Scene]) -> Iterator[dict[str, float]]:
    """Yield every quantity of the panel, each alone at another value."""
    first = scene()
    for group in first.groups:
        for name in group.names:
            quantity = scene.param[name]
            if name in quantities(scene) and group.is_shown(first.shown.forms):
                value = 0.37 * quantity.softbounds[0] + 0.63 * quantity.softbounds[1]
                yield {name: round(value) if quantity.scale == "count" else value}


def round_numbers(page: Page) -> list[Any]:
    """Return the numbers of each axis that do not depend on curves; they replace those of the total."""
    axes = (replace(axis, ticks=round_ticks(axis), labels=()) for axis in page.shown.axes.values())
    return [json.loads(as_json(axis.ruler)) for axis in axes]


@pytest.mark.parametrize("x_0", [0.05, 0.002])
def test_a_total_that_is_small_in_its_frame_is_not_given_away(x_0: float) -> None:
    """The axis of the energies ends at their total. When hidden, it has round numbers of the frame, which stays."""
    page = Page(SCENES["damped"](view="energy"))
    change(page, covered=["next"])
    told = set_values(page, x_0=x_0)
    first = Page(SCENES["damped"](view="energy"))
    change(first, covered=["next"])
    other = set_values(first, x_0=0.07)
    assert "numbers:E" in told["state"]["covered"] and page.shown.axes["E"].seen != first.shown.axes["E"].seen
    assert told["view"]["axes"]["E"] == other["view"]["axes"]["E"]


def set_by_hand(told: dict[str, Any]) -> list[Any]:
    """Return the values of the controls as they are sent, and rounded to three digits as in the comparison."""
    ones = [one for one in told["settings"].values() if isinstance(one["value"], float)]
    return [(one["value"], one["text"], three(one["value"] / one["size"])) for one in ones]


def csv_of(page: Page) -> list[list[Any]]:
    return [[table.name, table.head, table.rows] for table in tables(type(page.scene), page.now.to_send[0])]


def told_of_scene(page: Page) -> list[Any]:
    """Return the complete current picture as it would be sent."""
    picture = page.shown
    columns = {name: column.tolist() for given in picture.sources.values() for name, column in given.items()}
    axes = {name: axis.ruler for name, axis in picture.axes.items()}
    parts = (picture.signals, picture.scalars, picture.values, picture.notes, picture.pace, picture.spans, axes)
    return [columns, *(json.loads(as_json(part)) for part in parts)]


def numbers(told: Any) -> set[float | str]:
    """Return all sent numbers, and those in texts by their digits; without one-digit numbers, which round axes have."""
    if isinstance(told, dict):
        return numbers(list(told.values()))
    if isinstance(told, np.ndarray):
        return set(told.tolist())
    if isinstance(told, (list, tuple)):
        return set().union(*map(numbers, told))
    if isinstance(told, str):
        return {digits for digits in NUMBER.findall(told) if len(digits.strip("0.")) > 1}
    return {told, abs(told)} if isinstance(told, float) and len(f"{told:g}".strip("-0.")) > 1 else set()


def test_a_view_is_no_change_and_what_is_revealed_one_by_one_stays_so() -> None:
    page = Page(SCENES["coupled"]())
    change(page, covered=["next"])
    told = page.send({"type": "choose", "name": "view", "value": "formulas", "number": 60})
    assert told["state"]["covered"] == ["next"]
    told = set_values(page, k2=5.0)
    assert {"plot:x1", "plot:x2", "value:omega_minus", "stage"} <= set(told["state"]["covered"])
    left = [name for name in told["state"]["covered"] if name not in ("next", "plot:x1")]
    assert change(page, covered=left)["state"]["covered"] == left
    assert set_values(page, k2=6.0)["state"]["covered"] == left


def test_a_preset_is_a_change_too() -> None:
    page = Page(SCENES["oscillator"]())
    change(page, covered=["next"])
    state = msgspec.to_builtins(page.now.state)
    told = page.send({"type": "open", "state": {**state, "parameters": {"m": 4.0}, "frame": None}, "number": 61})
    assert "plot:x" in told["state"]["covered"] and "value:tau" in told["state"]["covered"]


def test_an_axis_keeps_its_range_and_loses_its_own_numbers() -> None:
    page = Page(SCENES["oscillator"]())
    before = change(page, covered=["next"])["view"]["axes"]["x"]
    told = set_values(page, v_0=-0.7)
    axis = told["view"]["axes"]["x"]
    assert "numbers:x" in told["state"]["covered"]
    assert (axis["start"], axis["end"]) == (before["start"], before["end"])
    assert page.shown.values["C"] not in "".join(axis["labels"])


@scenes
def test_a_new_session_sends_the_same_and_a_reveal_keeps_the_positions(slug: str) -> None:
    page, other = Page(SCENES[slug]()), Page(SCENES[slug]())
    axes = change(page, covered=["next"])["view"]["axes"]
    told = set_values(page, **moved(SCENES[slug]))
    again = change(other, **msgspec.to_builtins(page.now.state))
    assert (again["errors"], again["state"], again["view"]["left_out"]) == ({}, told["state"], told["view"]["left_out"])
    assert (again["view"]["scalars"], again["view"]["values"]) == (told["view"]["scalars"], told["view"]["values"])
    shown = change(page, covered=[])
    assert (shown["state"]["before"], shown["view"]["left_out"]) == (None, [])
    for name, axis in shown["view"]["axes"].items():
        stood = axes[name]
        low, high = sorted((stood["start"], stood["end"]))
        assert min(axis["start"], axis["end"]) <= low and max(axis["start"], axis["end"]) >= high, name


def test_another_view_of_what_is_covered_is_that_from_before() -> None:
    page = Page(SCENES["coupled"]())
    change(page, covered=["next"])
    set_values(page, k2=5.0)
    told = page.send({"type": "choose", "name": "view", "value": "formulas", "number": 60})
    assert told["state"]["parameters"]["view"] == "formulas" and told["state"]["before"] == {}
    assert told["view"]["scalars"] == Page(SCENES["coupled"](view="formulas")).opening()["view"]["scalars"]
