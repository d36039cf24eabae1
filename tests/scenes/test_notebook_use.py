"""A scene as a library: its docstring, its columns, and the messages that a user of a notebook reads."""

from __future__ import annotations

import copy
import doctest
import pickle
import re
from typing import Any

import numpy as np
import pytest

from components.panel_face.face import PanelFace
from components.quantities.parameters import Quantity
from components.scene import Scene
from components.scene.face import SceneFace
from components.scenes import SCENES

scenes = pytest.mark.parametrize("kind", SCENES.values(), ids=SCENES.keys())


@scenes
def test_the_docstring_lists_all_parameters_with_their_units(kind: type[Scene]) -> None:
    text = kind.__doc__ or ""
    assert text == type(kind()).__doc__
    for name, one in kind.linked().items():
        (line,) = re.findall(rf"^{name} : (.+)$", text, re.M)
        assert isinstance(one, Quantity) == line.startswith("float")
        assert not isinstance(one, Quantity) or (one.unit or "a pure number") in line
    assert "None" not in re.findall(r"^    (.+?\.) ", text, re.M)


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


@scenes
def test_a_plot_has_its_columns_with_units(kind: type[Scene]) -> None:
    for view in kind.views:
        scene = kind(view=view.slug)
        for part in view.names:
            plot = part.removeprefix("plot:")
            if plot == part or plot in ("shape", "det", "guess"):
                continue
            try:
                columns = scene.frame(plot)
            except ValueError:
                continue
            assert len({len(column) for column in columns.values()}) == 1
            assert all(re.fullmatch(r"\w+ \[.+\]", name) and one.dtype == float for name, one in columns.items())


@pytest.mark.parametrize("c", [0.0, 2.0])
def test_the_response_has_one_column_for_each_quantity(c: float) -> None:
    scene = SCENES["driven"](m=2.0, c=c, k=50.0, F_0=3.0)
    columns = scene.frame("response")
    assert {"omega [rad/s]", "M [1]", "lag [rad]"} <= columns.keys()
    omega = columns["omega [rad/s]"]
    assert np.all(np.diff(omega) > 0) and omega[0] < 5.0 < omega[-1]
    away = np.abs(omega - 5.0) > 0.05
    X = 1 / np.hypot(1 - (omega / 5.0) ** 2, c * omega / 50.0)[away]
    np.testing.assert_allclose(columns["M [1]"][away], X, rtol=1e-9)


def test_a_frame_without_numbers_says_which_have_some() -> None:
    for source in ("nothing", 3):
        with pytest.raises(ValueError, match=r"“\w+” has no numbers here: choose one of time, modes, x1"):
            SCENES["coupled"]().frame(source)


def test_a_wrong_name_or_word_is_refused_with_those_that_there_are() -> None:
    scene: Any = SCENES["coupled"]()
    with pytest.raises(AttributeError, match=r"k3 is not a parameter of Coupled: it has .*m1, m2, k1, k2"):
        scene.k3 = 2.0
    with pytest.raises(ValueError, match=r"^view = 'plan' is not possible: choose one of motion, energy, plane"):
        scene.view = "plan"
    with pytest.raises(ValueError, match=r"^m1 = '2' is not possible: a mass is a finite number above 0"):
        scene.m1 = "2"
    assert scene.value.key == SCENES["coupled"]().value.key


ODD: tuple[object, ...] = (
    None, "", "2", True, [], ["x"], [1], {}, {"k": 1}, (), 3, b"2", 1j, object(),
    float("nan"), float("inf"), -float("inf"), 1e300, -1e300, 10**400,
)  # fmt: skip
"""Values of all types, most of them wrong for any parameter."""


@scenes
def test_an_odd_value_is_taken_or_refused_in_words(kind: type[Scene]) -> None:
    scene: Any = kind()
    before, taken = scene.value, 0
    for name in kind.linked():
        for odd in ODD:
            try:
                setattr(scene, name, odd)
            except ValueError as error:
                assert re.match(r"[^'].* .*\w", str(error)), (name, odd, error)
                if not isinstance(odd, (int, float)):
                    assert str(error).startswith(f"{name} = "), (name, odd, error)
                    with pytest.raises(ValueError, match=re.escape(str(error))):
                        kind(**{name: odd})
            else:
                taken += 1
                assert type(scene.values[name]) in (type(odd), float) and scene.shown, (name, odd)
                scene.show(before)
            assert scene.value.key == before.key, (name, odd)
    assert taken


@scenes
def test_numbers_outlive_copies(kind: type[Scene]) -> None:
    scene = kind(window=12.5)
    for twin in (copy.copy(scene), copy.deepcopy(scene), pickle.loads(pickle.dumps(scene))):
        assert twin.numbers == scene.numbers and twin.numbers is not scene.numbers
        twin.window = 20.0
        assert scene.window == 12.5
