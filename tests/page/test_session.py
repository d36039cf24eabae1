"""The message Open(state) puts a session into any state (presets, links, other scenes), completely or not at all."""

from __future__ import annotations

from typing import Any

import msgspec
import pytest

from components.language.state import State
from components.scene import Scene
from components.scenes import SCENES
from components.session.opening import opened
from components.state.link import read_query
from components.state.page_state import fitted
from components.state.scene_sheet import sheet_address
from tests.page.headless_page import Page, unpacked
from tests.scenes.checks import as_arguments, choices, quantities

scenes = pytest.mark.parametrize("slug", SCENES)


def opening(state: State | dict[str, Any], number: int = 1) -> dict[str, Any]:
    plain = msgspec.to_builtins(state) if isinstance(state, State) else state
    return {"type": "open", "state": plain, "number": number}


def changed(scene: type[Scene]) -> Scene:
    """The scene with one change of each kind: a quantity, a choice, a window, a hidden curve."""
    values: dict[str, Any] = {name: q.softbounds[1] for name, q in list(quantities(scene).items())[:2]}
    chosen = [*choices(scene)]
    values |= [one for one in chosen if one.keys() == chosen[0].keys()][-1] if chosen else {}
    return scene.at({**values, "window": 12.5, "hidden": ["x1"]})


@scenes
def test_a_state_brings_a_scene_back_from_anywhere(slug: str) -> None:
    wanted = changed(SCENES[slug])
    for start in ("coupled", slug):
        page = Page(SCENES[start]())
        told = page.send(opening(fitted(wanted).state, number=5))
        assert (told["answer"], told["errors"], told["scene"]) == (5, {}, slug)
        assert msgspec.convert(told["state"], State) == fitted(wanted).state
        assert page.now.state == fitted(wanted).state
        assert told["sheet"] == sheet_address(SCENES[slug])


@scenes
def test_what_a_state_does_not_name_is_at_its_default(slug: str) -> None:
    page = Page(changed(SCENES[slug]))
    page.send(opening(State(scene=slug)))
    assert page.now.state == State(scene=slug)
    assert page.scene.values == SCENES[slug].at().values


@pytest.mark.parametrize(
    ("state", "reason"),
    [
        ({"scene": "nowhere"}, "“nowhere” is not a scene."),
        ({"scene": "forced", "parameters": {"k9": 1.0}}, "“k9” is not a parameter of this scene."),
        ({"scene": "forced", "parameters": {"m1": -1.0}}, "−1 kg is not possible: a mass is a finite number above 0."),
        ({"scene": "forced", "parameters": {"m1": "heavy"}}, "'heavy' is not possible"),
        ({"scene": "forced", "parameters": {"curve": "loud"}}, "curve: “loud” is not possible: choose one of"),
        ({"scene": "forced", "parameters": {"omega": 1e300}}, "Still drawn as before."),
        ({"scene": "forced", "hidden": ["<b>"]}, "“<b>” is not possible"),
        ({"scene": "coupled", "parameters": {"hidden": ["x1"]}}, "“hidden” is not a parameter"),
    ],
)
def test_a_state_that_is_refused_changes_nothing(state: dict[str, Any], reason: str) -> None:
    page = Page(SCENES["coupled"](k2=3.0))
    before, scene = page.opening(), page.scene
    told = page.send(opening(state))
    assert reason in told["errors"]["state"]
    assert told["errors"]["state"].endswith("Still drawn as before.")
    assert page.scene is scene
    assert {**told, "errors": {}, "answer": None} | {"view": None} == before | {"view": None}


def test_what_a_link_asks_of_a_picture_is_named_where_it_has_no_such_thing() -> None:
    link = read_query(as_arguments("scene=coupled&k2=3&frame.fruit=1,2&cover=plot:x2,plot:pear"), SCENES)
    session = opened(SCENES, link)
    assert session.now.state.covered == ("plot:x2",)
    assert session.now.state.parameters == {"k2": 3.0}
    assert unpacked(session.opening())["problems"] == [
        "frame.fruit: “fruit” is not an axis of this picture.",
        "“plot:pear” cannot be covered here.",
    ]


def test_what_is_covered_in_one_view_may_stay_so_in_another() -> None:
    """The number belongs to another view than that of the state, as in a new session after a reconnection."""
    page = Page(SCENES["modes"]())
    page.send(opening({"scene": "modes", "parameters": {"view": "solve"}, "covered": ["value:Delta"]}))
    told = page.send({"type": "choose", "name": "view", "value": "hunt", "number": 2})
    again = Page(SCENES["modes"]()).send(opening(told["state"]))
    assert (again["errors"], again["state"]) == ({}, told["state"])


@pytest.mark.parametrize("state", [None, 3, {}, {"scene": 3}, {"scene": "coupled", "parameters": {"k2": {"a": 1}}}])
def test_what_is_no_state_is_no_message(state: Any) -> None:
    page = Page(SCENES["coupled"]())
    assert list(page.send(opening(state))["errors"]) == ["message"]


def test_a_scene_that_was_left_is_closed_and_silent() -> None:
    page = Page(SCENES["accuracy"]())
    left = page.session.running
    assert left
    ended: list[bool] = []
    left.close = lambda: ended.append(True)  # type: ignore[method-assign]
    page.send(opening(State(scene="forced")))
    told = len(page.packets)
    left.notify()
    assert (ended, len(page.packets)) == ([True], told)
