"""A page opens the state of its address. The navigation opens a scene in the same state, or with the same system."""

from typing import Any

import pytest
from msgspec.structs import replace

from app import visited
from components.scenes import SCENES
from components.state.link import write_query
from components.state.page_state import fitted
from components.state.scene_sheet import sheet_address
from tests.page.headless_page import Page, say, set_values, unpacked
from tests.scenes.checks import by_link

PRESETS = {"oscillator": "Pulled", "analogues": "10°", "phugoid": "Deep, 0.6"}
"""The presets with which scenes open; other scenes open with their first."""
scenes = pytest.mark.parametrize("slug", SCENES)


@scenes
def test_a_page_opens_as_its_scene_declares_by_its_address_and_by_a_click(slug: str) -> None:
    scene = visited({"scene": [slug.encode()], "projector": [b""]}, {}).now.scene
    assert {name: scene.values[name] for name in scene.opens} == scene.opens
    assert scene.preset() == PRESETS.get(slug, next(iter(scene.presets)))
    assert slug != "oscillator" or visited({}, {}).now.scene.values == scene.values, "the first page of all"
    plain = SCENES[slug].at()
    link = write_query(fitted(plain).state, SCENES[slug])
    assert by_link(link).now.scene.values == plain.values, "without its presets"
    page = Page(SCENES["coupled" if slug == "accuracy" else "accuracy"]())
    told = say(page, "open", state={"scene": slug}, carried=True)
    assert page.scene.values == scene.values
    assert (told["scene"], told["sheet"], told["state"]["hidden"]) == (slug, sheet_address(SCENES[slug]), None)


def test_what_a_link_asks_of_a_picture_is_named_where_it_has_no_such_thing() -> None:
    session = by_link("scene=coupled&k2=3&frame.fruit=1,2&cover=plot:x2,plot:pear")
    assert session.now.state == replace(session.now.state, covered=("plot:x2",), parameters={"k2": 3.0})
    assert unpacked(session.opening())["problems"] == [
        "frame.fruit: “fruit” is not an axis of this picture.",
        "“plot:pear” cannot be covered here.",
    ]


def test_a_scene_that_was_left_is_closed_and_silent() -> None:
    page = Page(SCENES["accuracy"]())
    left, ended = page.session.running, list[bool]()
    assert left
    left.close = lambda: ended.append(True)  # type: ignore[method-assign]
    say(page, "open", state={"scene": "forced"})
    told = len(page.packets)
    left.notify()
    assert (ended, len(page.packets)) == ([True], told)


STIFF = {"m": 3.0, "k": 20.0}
CHAIN = {"m1": 1.5, "m2": 0.25, "k1": 6.0, "k2": 0.1}
ROUTES: list[tuple[str, dict[str, Any], list[tuple[str, dict[str, Any]]]]] = [
    ("coupled", {**CHAIN, "x1_0": 0.3},
     [("modes", CHAIN), ("forced", CHAIN), ("accuracy", {**CHAIN, "system": "own"})]),
    ("forced", CHAIN, [("absorber", {}), ("absorber", {"m2": 30.0}), ("modes", CHAIN)]),
    ("oscillator", {"m": 3.0}, [
        ("energy", {"m": 3.0}), ("energy", STIFF),
        ("analogues", {"system": "spring", "spring_m": 3.0, "spring_k": 20.0}), ("coupled", {}), ("oscillator", STIFF),
    ]),
    ("analogues", {"system": "circuit", "spring_m": 5.0}, [("oscillator", {})]),
    ("coupled", {"k1": 0.0, "k2": 1e-300}, [("forced", {}), ("modes", {})]),
]  # fmt: skip
"""A scene with its values, and what is in each scene to which its visitor goes. In the same scene again, it is set."""


@pytest.mark.parametrize(("slug", "values", "route"), ROUTES)
def test_a_system_goes_along_to_every_scene_that_shows_it(slug: str, values: dict[str, Any], route: Any) -> None:
    page = Page(SCENES[slug](**values))
    for scene, has in route:
        if scene == page.scene.slug:
            set_values(page, **has)
            continue
        told = say(page, "open", state={"scene": scene}, carried=True)
        opens, parameters = SCENES[scene].opens, told["state"]["parameters"]
        assert told["errors"] == {} and opens.items() <= parameters.items(), "it opens as a page of it does"
        assert {name: value for name, value in parameters.items() if name not in opens} == has
    assert by_link(page.now.query).now.state.parameters == page.now.state.parameters, "the link says all of it"
    own = say(page, "open", state={"scene": "modes", "parameters": {"k2": 9.0}})
    assert own["state"]["parameters"] == {"k2": 9.0}, "a state has its own system"
