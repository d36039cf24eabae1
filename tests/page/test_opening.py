"""A page opens the state of its link, of which bad parts are named and the rest is kept. The navigation opens a scene
in the same state, or with the same system.
"""

import sys
from typing import Any

import pytest
from msgspec.structs import replace

from app import visited
from components.language.state import Frame, State
from components.scenes import SCENES
from components.state.link import MOST_PROBLEMS, Link, read_query, write_query
from components.state.page_state import fitted
from components.state.scene_sheet import sheet_address
from tests.page.headless_page import Page, say, set_values, unpacked
from tests.scenes.checks import as_arguments, by_link

scenes = pytest.mark.parametrize("slug", SCENES)


@scenes
def test_a_page_opens_as_its_scene_declares_by_its_address_and_by_a_click(slug: str) -> None:
    scene = visited({"scene": [slug.encode()], "projector": [b""]}, {}).now.scene
    assert {name: scene.values[name] for name in scene.opens} == scene.opens
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


COUPLED = SCENES["coupled"]
NO_NUMBER = "is not a number: type one such as 2.5 or 1e-3."
Range = tuple[float, float]


def read(text: str) -> Link:
    return read_query(as_arguments(text), SCENES)


def test_link_carries_what_is_covered_and_what_of_the_frame_is_not_fitted() -> None:
    link = read("scene=coupled&cover=plot:x2,value:tau,plot:x2&frame.x=-2,2.5&frame.t=1e-3,0&frame.window=12")
    assert link.covered == ("plot:x2", "value:tau")
    assert link.frame == Frame(ranges={"x": (-2.0, 2.5), "t": (1e-3, 0.0)}, window=12.0, given=True)
    assert link.problems == []
    scene: Any = COUPLED(hidden=["x1.slow", "x2"], k2=3, m1=1e22, energy="modes")
    assert fitted(scene.value).query == "scene=coupled&hidden=x1.slow,x2&m1=1e22&k2=3&energy=modes&view=motion"
    query = write_query(State(scene="coupled", parameters={"window": None}), COUPLED)
    assert "&window=auto&" in query and read(query).values["window"] is None


@pytest.mark.parametrize(
    ("span", "expected"),
    [
        ((-1.23456, 2.34567), (-1.235, 2.346)),
        ((2.34567, -1.23456), (2.346, -1.235)),
        ((1.0004, 1.0804), (1.0, 1.081)),
        *((span, span) for span in ((1.0004, 1.0304), (0.123456, 0.123457), (-sys.float_info.max, 0.0))),
    ],
)
def test_a_range_in_a_link_has_four_digits_if_these_widen_it_by_at_most_2_percent(span: Range, expected: Range) -> None:
    frame = Frame(ranges={"x": span}, speed=sys.float_info.max, given=True)
    found = read(write_query(State(scene="coupled", frame=frame), COUPLED)).frame
    assert found == replace(frame, ranges={"x": expected})


@pytest.mark.parametrize(
    ("part", "problem"),
    [
        ("frame.x=1", "frame.x: “1” is not a range: give two numbers, such as -1,1."),
        ("frame.y=1,1", "frame.y: The range of “y” is from 1.0 to 1.0: its ends must differ."),
        ("frame.z=a,2", f"frame.z: “a” {NO_NUMBER}"),
        ("frame.u=1e400,2", "frame.u: 1e400 is too large: the largest number that can be held is about 1.8e308."),
        ("frame.window=-3", "frame.window: The window of a frame is -3.0: it must be above 0."),
        ("frame.scale=big", f"frame.scale: “big” {NO_NUMBER}"),
        ("cover=" + ",".join(map(str, range(201))), "cover: give at most 200 names."),
        ("k1=-3", "k1: −3 N/m is not possible: a stiffness is a finite number, 0 or more."),
        ("m1=heavy", f"m1: “heavy” {NO_NUMBER}"),
        ("x1_0=nan", f"x1_0: “nan” {NO_NUMBER}"),
        ("energy=loud", "energy: “loud” is not possible: choose one of "),
        ("hidden=<b>", "hidden: “<b>” is not possible: a name has letters, digits, _.:+- only."),
        ("k9=1", "“k9” is not a parameter of this scene."),
        ("name=x", "“name” is not a parameter of this scene."),
        ("show=plot:pear", "show: “plot:pear” is not possible: choose from "),
        ("held.view=forces", "“view” is not a parameter of this scene."),
        ("held.k2=x", f"k2: “x” {NO_NUMBER}"),
        ("held=here", "held: write held=default"),
        ("m1=3&m1=4", "m1 is given 2 times: give it once."),
        ("m1=" + "9" * 5000 + "x", "m1: “999"),
    ],
)
def test_a_bad_part_is_named_and_good_ones_are_kept(part: str, problem: str) -> None:
    link = read(f"scene=coupled&k2=3&{part}&frame.v=3,4")
    assert (link.slug, link.values, link.frame) == ("coupled", {"k2": 3.0}, Frame(ranges={"v": (3.0, 4.0)}, given=True))
    (said,) = link.problems
    assert said.startswith(problem) and len(said) < 400


def test_the_scene_of_a_link() -> None:
    first = next(iter(SCENES))
    for query, problems in (
        ("x_0=3", []),
        ("scene=third&x_0=3", [f"scene: “third” is not a scene: choose one of {', '.join(SCENES)}."]),
        ("scene=coupled&scene=forced&x_0=3", ["scene is given 2 times: give it once."]),
    ):
        link = read(query)
        assert (link.slug, link.values["x_0"], link.problems) == (first, 3.0, problems)
    link = read("bokeh-session-id=1&bokeh-autoload-element=2&panel-x=3&theme=dark&projector=1")
    assert (link.values, link.problems) == ({}, []), "keys of the server and the page"


def test_not_more_problems_than_can_be_read_and_bytes_that_are_no_text_are_named() -> None:
    problems = read("&".join(f"unknown{i}=1" for i in range(100))).problems
    assert len(problems) == MOST_PROBLEMS + 1 and problems[-1] == "92 more parts of this link are refused."
    assert read_query({"x_0": [b"\xff"]}, SCENES).problems == [f"x_0: “\ufffd” {NO_NUMBER}"]
