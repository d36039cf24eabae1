"""Links: bad parts are named and the rest is kept; numbers have the digits that they need."""

import sys
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from components.language.state import Frame, State
from components.scenes import SCENES
from components.state.link import MOST_PROBLEMS, Link, read_query, write_query
from components.state.page_state import fitted
from tests.scenes.checks import as_arguments

COUPLED = SCENES["coupled"]
NO_NUMBER = "is not a number: type one such as 2.5 or 1e-3."


def read(text: str) -> Link:
    return read_query(as_arguments(text), SCENES)


def test_link_carries_what_is_covered_and_what_of_the_frame_is_not_fitted() -> None:
    link = read("scene=coupled&cover=plot:x2,value:tau,plot:x2&frame.x=-2,2.5&frame.t=1e-3,0&frame.window=12")
    assert link.covered == ("plot:x2", "value:tau")
    assert link.frame == Frame(ranges={"x": (-2.0, 2.5), "t": (1e-3, 0.0)}, window=12.0, given=True)
    assert link.problems == []
    scene: Any = COUPLED(hidden=["x1.slow", "x2"], k2=3, m1=1e22, energy="modes")
    assert fitted(scene.value).query == "scene=coupled&hidden=x1.slow,x2&m1=1e22&k2=3&energy=modes&view=motion"
    edge = Frame(ranges={"x": (-sys.float_info.max, 0.0)}, speed=sys.float_info.max, given=True)
    assert carried(edge) == edge
    query = write_query(State(scene="coupled", parameters={"window": None}), COUPLED)
    assert "&window=auto&" in query and read(query).values["window"] is None


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


near = st.floats(-6, 3).flatmap(lambda power: st.sampled_from((10**power, -(10**power))))
spans = st.tuples(size := st.floats(-1e300, 1e300), size) | st.builds(
    lambda end, by: (end, end + by * abs(end)), st.floats(-1e100, 1e100), near
)


def carried(frame: Frame) -> Frame:
    """A frame that a link has carried."""
    found = read(write_query(State(scene="coupled", frame=frame), COUPLED)).frame
    assert found is not None
    return found


@given(spans.filter(lambda span: span[0] != span[1]))
def test_a_range_in_a_link_has_four_digits_if_these_widen_it_by_at_most_2_percent(span: tuple[float, float]) -> None:
    found = carried(Frame(ranges={"x": span}, given=True)).ranges["x"]
    (low, high), (least, most) = sorted(span), sorted(found)
    assert least <= low < high <= most and (found == (least, most)) == (span == (low, high))
    assert most - least <= 1.02 * (high - low) * (1 + 1e-9)
    if not all(float(f"{end:.4g}") == end for end in found):
        assert (least, most) == (low, high) and high - low < 0.1 * max(abs(low), abs(high))
