"""The contract of every scene: any state can be drawn or is refused in words; one solve a change, presets, small
messages; and its use as a library.
"""

import copy
import doctest
import pickle
import re
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from components.panel_face.face import PanelFace
from components.quantities.instant import instant
from components.quantities.refusals import SORRY
from components.scene import Picture, Scene
from components.scene.face import SceneFace
from components.scenes import SCENES
from components.session.links import page_state_of
from components.state.link import Link, read_query
from components.state.page_state import PageState
from tests.grids import tries
from tests.page.headless_page import Page, set_values
from tests.page.scripts import played
from tests.scenes.checks import as_arguments, changes, check_picture, choices
from tests.states import links

ALL_DOUBLES = 60.0
"""Decades beyond the sliders: from nothing to far more than a square can hold."""
MOST_BYTES = {"phugoid": 5000}
"""Of a change, where 3000 are not enough."""
FRAMES = 340
"""Bytes of the frames that Bokeh sends with a change."""
pytestmark = pytest.mark.timeout(600)
scenes = pytest.mark.parametrize("scene_class", SCENES.values(), ids=SCENES.keys())


@scenes
def test_a_picture_of_any_state_is_finite_or_refused_in_words(scene_class: type[Scene]) -> None:
    """The browser evaluates its signals as Python does, and its address brings the state back."""

    @settings(max_examples=tries(80))
    @given(links(scene_class) | links(scene_class, ALL_DOUBLES), st.sampled_from([0.0, 1e-3, 0.31, 0.77, 1.0]))
    def holds(link: Link, share: float) -> None:
        now, refused = page_state_of(scene_class, link)
        check_picture(now)
        for sentence in refused:
            assert sentence.endswith((".", "…")) and SORRY not in sentence, sentence
        check_address(now)
        check_signals(now.shown, share)

    holds()


def check_address(now: PageState) -> None:
    read = read_query(as_arguments(now.query), SCENES)
    again, refused = page_state_of(now.kind, read)
    assert (read.problems, refused, again.query) == ([], [], now.query)
    assert replace(again.state, frame=None) == replace(now.state, frame=None)


def check_signals(shown: Picture, share: float) -> None:
    t = share * shown.axes["t"].place(shown.axes["t"].end) if "t" in shown.axes else share
    wanted = instant(shown.signals, shown.scalars, t)
    for name, value in played(shown, t).items():
        assert float(value) == pytest.approx(wanted[name], rel=1e-9, abs=1e-9), name


@scenes
def test_each_change_is_one_solve(scene_class: type[Scene]) -> None:
    scene, counted = scene_class(), list[Picture]()
    scene.on_picture(counted.append)
    presets = map(scene_class.preset_all, scene_class.presets)
    for values in (next(changes(scene_class)), *choices(scene_class), *presets):
        counted.clear()
        is_another = bool(scene.differing(values))
        scene.set(values)
        assert len(counted) == is_another, values
        check_picture(scene)


@scenes
def test_a_change_is_small(scene_class: type[Scene]) -> None:
    page = Page(scene_class())
    for values in changes(scene_class):
        set_values(page, **values)
        set_values(page, **{name: scene_class.param[name].default for name in values})
    assert max(len(packet["data"]) for packet in page.packets) + FRAMES <= MOST_BYTES.get(scene_class.slug, 3000)


@pytest.mark.parametrize(
    "documented",
    [Scene, Scene.frame, Scene.numbers, SceneFace, PanelFace, *SCENES.values()],
    ids=lambda one: getattr(one, "__name__", "numbers"),
)
def test_the_examples_of_docstrings_run(documented: Any) -> None:
    name = getattr(documented, "__name__", "numbers")
    examples = doctest.DocTestParser().get_doctest(documented.__doc__ or "", {}, name, None, 0)
    assert doctest.DocTestRunner().run(examples).failed == 0
    assert examples.examples


def test_a_wrong_name_or_word_is_refused_with_those_that_there_are() -> None:
    scene: Any = SCENES["coupled"]()
    with pytest.raises(AttributeError, match=r"k3 is not a parameter of Coupled: it has .*m1, m2, k1, k2"):
        scene.k3 = 2.0
    with pytest.raises(ValueError, match=r"^view = 'plan' is not possible: choose one of motion, energy, plane"):
        scene.view = "plan"


ODD: tuple[object, ...] = (None, "", "2", True, ["x"], [1], {"k": 1}, 3, 1j, float("nan"), -float("inf"), 10**400)
"""Values of all types, most of them wrong for any parameter."""


@scenes
def test_an_odd_value_is_taken_or_refused_in_words(scene_class: type[Scene]) -> None:
    scene: Any = scene_class()
    before, taken = scene.value, 0
    for name in scene_class.linked():
        for odd in ODD:
            try:
                setattr(scene, name, odd)
            except ValueError as error:
                assert re.match(r"[^'].* .*\w", str(error)), (name, odd, error)
                if not isinstance(odd, (int, float)):
                    assert str(error).startswith(f"{name} = "), (name, odd, error)
                    with pytest.raises(ValueError, match=re.escape(str(error))):
                        scene_class(**{name: odd})
            else:
                taken += 1
                assert type(scene.values[name]) in (type(odd), float) and scene.shown, (name, odd)
                scene.show(before)
            assert scene.value.key == before.key, (name, odd)
    assert taken


@scenes
def test_numbers_outlive_copies(scene_class: type[Scene]) -> None:
    scene = scene_class(window=12.5)
    for twin in (copy.copy(scene), copy.deepcopy(scene), pickle.loads(pickle.dumps(scene))):
        assert twin.numbers == scene.numbers and twin.numbers is not scene.numbers
        twin.window = 20.0
        assert scene.window == 12.5
