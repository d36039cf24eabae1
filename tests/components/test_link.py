"""Links restore all non-default values; bad parts are named and the rest is kept."""

import sys
from decimal import ROUND_CEILING, ROUND_FLOOR, Decimal
from typing import Any
from urllib.parse import parse_qs

import param
from hypothesis import given
from hypothesis import strategies as st

from components.language.blocks import Block
from components.language.state import Frame, State
from components.layout.sheet import column
from components.quantities.parameters import displacement, mass, positive, stiffness
from components.scene import Picture, Scene
from components.scene.frames import FITTED
from components.state.link import MOST_PROBLEMS, read_query, write_query
from components.state.page_state import fitted


class First(Scene):
    """The scene of a link that names none."""

    slug = "first"
    m1 = mass(2.0, symbol="m_1")
    k2 = stiffness(2.0, symbol="k_2")
    x1_0 = displacement(1.0, symbol="x_1")
    axes: Any = param.Selector(default="si", objects=["si", "lecture"])
    steps: Any = param.Selector(default=1.0, objects={"one": 1.0, "half": 0.5})
    log = param.Boolean(default=False)
    secret = param.String(default="kept")
    fixed = stiffness(1.0, symbol="k", constant=True)

    @classmethod
    def sheet(cls) -> Block:
        return column()

    def picture(self, frame: Frame = FITTED) -> Picture:
        return Picture(columns={}, axes={})


class Second(First):
    slug = "second"
    span = positive(3.0, allow_None=True, symbol="T", unit="s", label="span", says="", softbounds=(1, 9))


SCENES: dict[str, type[Scene]] = {"first": First, "second": Second}


def query(text: str) -> dict[str, list[bytes]]:
    """The arguments as the server gives them."""
    return {key: [value.encode() for value in values] for key, values in parse_qs(text, keep_blank_values=True).items()}


def test_link_carries_what_is_covered_and_what_of_the_frame_is_not_fitted() -> None:
    link = read_query(
        query(
            "scene=first&cover=plot:x2,value:tau,plot:x2&frame.x=-2,2.5&frame.t=1e-3,0&frame.window=12&frame.speed=0.5"
        ),
        SCENES,
    )
    assert link.covered == ("plot:x2", "value:tau")
    assert link.frame == Frame(ranges={"x": (-2.0, 2.5), "t": (1e-3, 0.0)}, window=12.0, speed=0.5, given=True)
    assert link.problems == []


def test_bad_parts_of_a_frame_are_named_and_good_ones_kept() -> None:
    link = read_query(
        query("frame.x=1&frame.y=1,1&frame.z=a,2&frame.u=1e400,2&frame.window=-3&frame.scale=big&frame.v=3,4"), SCENES
    )
    assert link.frame == Frame(ranges={"v": (3.0, 4.0)}, given=True)
    assert link.problems == [
        "frame.x: “1” is not a range: give two numbers, such as -1,1.",
        "frame.y: The range of “y” is from 1.0 to 1.0: its ends must differ.",
        "frame.z: “a” is not a number: type one such as 2.5 or 1e-3.",
        "frame.u: 1e400 is too large: the largest number that can be held is about 1.8e308.",
        "frame.window: The window of a frame is -3.0: it must be above 0.",
        "frame.scale: “big” is not a number: type one such as 2.5 or 1e-3.",
    ]
    assert read_query(query("cover=" + ",".join(map(str, range(201)))), SCENES).problems == [
        "cover: give at most 200 names."
    ]


def test_a_frame_at_the_end_of_the_doubles_is_carried() -> None:
    largest = sys.float_info.max
    frame = Frame(ranges={"x": (-largest, 0.0)}, speed=largest, given=True)
    state = State(scene="first", frame=frame)
    assert read_query(query(write_query(state, First)), SCENES).frame == frame


def test_link_without_a_scene_is_of_the_first() -> None:
    assert read_query(query("k2=3"), SCENES).slug == "first"


def test_bad_parts_are_named_and_good_ones_kept() -> None:
    link = read_query(
        query("scene=first&k2=-3&m1=heavy&x1_0=nan&axes=loud&hidden=<b>&k9=1&secret=x&fixed=2&log=true"),
        SCENES,
    )
    assert link.values == {"log": True}
    assert link.problems == [
        "k2: −3 N/m is not possible: a stiffness is a finite number, 0 or more.",
        "m1: “heavy” is not a number: type one such as 2.5 or 1e-3.",
        "x1_0: “nan” is not a number: type one such as 2.5 or 1e-3.",
        "axes: “loud” is not possible: choose one of si, lecture.",
        "hidden: “<b>” is not possible: a name has letters, digits, _.:+- only.",
        "“k9” is not a parameter of this scene.",
        "“secret” is not a parameter of this scene.",
        "“fixed” is not a parameter of this scene.",
    ]


def test_unknown_scene_is_named_and_the_first_shown() -> None:
    link = read_query(query("scene=third&k2=3"), SCENES)
    assert (link.slug, link.values) == ("first", {"k2": 3.0})
    assert link.problems == ["scene: “third” is not a scene: choose one of first, second."]


def test_key_given_twice_is_refused() -> None:
    link = read_query(query("k2=3&k2=4&scene=first&scene=second"), SCENES)
    assert (link.slug, link.values) == ("first", {})
    assert link.problems == ["scene is given 2 times: give it once.", "k2 is given 2 times: give it once."]


def test_keys_of_the_server_and_the_page_are_none_of_the_scene_s() -> None:
    link = read_query(query("bokeh-session-id=1&bokeh-autoload-element=2&panel-x=3&theme=dark&projector=1"), SCENES)
    assert (link.values, link.problems) == ({}, [])


def test_foreign_text_is_echoed_short() -> None:
    link = read_query(query("k2=" + "9" * 5000 + "x"), SCENES)
    assert len(link.problems[0]) < 120


def test_not_more_problems_than_can_be_read() -> None:
    link = read_query(query("&".join(f"unknown{i}=1" for i in range(100))), SCENES)
    assert len(link.problems) == MOST_PROBLEMS + 1
    assert link.problems[-1] == "92 more parts of this link are refused."


@given(
    st.dictionaries(
        st.sampled_from(["scene", "m1", "hidden", "axes", "log", "cover", "frame.x", "frame.window", "?"]),
        st.lists(st.binary(), max_size=3),
    )
)
def test_no_query_breaks_the_server(args: dict[str, list[bytes]]) -> None:
    link = read_query(args, SCENES)
    assert link.slug in SCENES
    SCENES[link.slug](**link.values)


def test_default_scene_has_the_shortest_link() -> None:
    assert fitted(First().value).query == "scene=first"


def test_link_is_short_and_in_a_stable_order() -> None:
    scene = First(hidden=["x1.slow", "x2"], k2=3, m1=1e22, axes="lecture", steps=0.5)
    assert fitted(scene.value).query == "scene=first&hidden=x1.slow,x2&m1=1e22&k2=3&axes=lecture&steps=0.5"


near = st.floats(-6, 3).flatmap(lambda power: st.sampled_from((10**power, -(10**power))))
spans = st.tuples(size := st.floats(-1e300, 1e300), size) | st.builds(
    lambda end, by: (end, end + by * abs(end)), st.floats(-1e100, 1e100), near
)


@given(spans.filter(lambda span: span[0] != span[1]))
def test_a_range_in_a_link_has_four_digits_if_these_widen_it_by_at_most_2_percent(span: tuple[float, float]) -> None:
    state = State(scene="first", frame=Frame(ranges={"x": span}, given=True))
    frame = read_query(query(write_query(state, First)), SCENES).frame
    assert frame is not None
    (low, high), (least, most) = sorted(span), sorted(frame.ranges["x"])
    assert least <= low < high <= most and (frame.ranges["x"] == (least, most)) == (span == (low, high))
    wide = four_digits(low, ROUND_FLOOR), four_digits(high, ROUND_CEILING)
    widened = (wide[1] - wide[0]) / (high - low)
    if abs(widened - 1.02) > 1e-9:
        assert (least, most) == (wide if widened < 1.02 else (low, high))


def four_digits(value: float, rounding: str) -> float:
    exact = Decimal(repr(value))
    return float(exact.quantize(Decimal((0, (1,), exact.adjusted() - 3)), rounding)) if value else value
