"""Quantities, the description of the controls, and the effect of their messages on a scene, without a browser."""

import math
from typing import Any, ClassVar

import numpy as np
import param
import pytest
from hypothesis import given
from hypothesis import strategies as st

from components.language.blocks import Block, Option
from components.language.controls import ChoiceRow, PresetButton, Setting
from components.language.state import Frame
from components.layout.controls import Group, panel, settings
from components.layout.sheet import column
from components.quantities.parameters import (
    angular_frequency,
    displacement,
    force,
    mass,
    positive,
    stiffness,
    velocity,
)
from components.scene import Picture, Scene
from components.scene.frames import FITTED
from tests.page.headless_page import apply_message, take_preset
from tests.scenes.checks import solves


class Example(Scene):
    """A scene with one extra rule: k2/m1 is at most 1e6."""

    slug = "example"
    title = headline = "Example"
    groups = ()
    m1 = mass(2.0, symbol="m_1", tint="m1")
    k2 = stiffness(1.0, symbol="k_2", says="couples the masses. Type any value from 0 up.")
    x1_0 = displacement(1.0, symbol="x_1", tint="m1")
    v1_0 = velocity(symbol="v_1", tint="m1")
    F_0 = force()
    omega = angular_frequency()
    span = positive(None, allow_None=True, symbol="T", unit="s", label="span", says="is long.", softbounds=(1, 9))
    view_of: Any = param.Selector(default="size", objects=["size", "signed"], label="Amplitude")
    log = param.Boolean(default=False)

    presets: ClassVar = {"Stiff": {"k2": 50.0}, "Heavy": {"m1": 10.0}, "Impossible": {"k2": 1e9, "m1": 1e-9}}

    @classmethod
    def sheet(cls) -> Block:
        return column()

    def picture(self, frame: Frame = FITTED) -> Picture:
        if self.k2 > 1e6 * self.m1:
            raise ValueError("the motion is too fast for a double")
        return Picture(columns={}, axes={}, spans={"omega": (0.0, self.m1)})


@pytest.fixture
def scene() -> Example:
    return Example()


def shown(scene: Scene) -> dict[str, Setting]:
    return settings(scene.param.objects("existing"), scene.values, scene.units(), scene.shown.spans)


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        ("k2", -3, "k2 = −3 N/m is not possible: a stiffness is a finite number, 0 or more."),
        ("k2", -1e-300, "k2 = −1e−300 N/m is not possible: a stiffness is a finite number, 0 or more."),
        ("k2", math.inf, "k2 = ∞ N/m is not possible: a stiffness is a finite number, 0 or more."),
        ("m1", 0.0, "m1 = 0 kg is not possible: a mass is a finite number above 0."),
        ("x1_0", math.nan, "x1_0 = nan m is not possible: a displacement is any finite number."),
        ("omega", "2", "omega = '2' is not possible: an angular frequency is a finite number, 0 or more."),
        ("m1", None, "m1 = None is not possible: a mass is a finite number above 0."),
        ("m1", True, "m1 = True is not possible: a mass is a finite number above 0."),
    ],
)
def test_impossible_value_is_refused_by_name_and_reason(name: str, value: object, reason: str) -> None:
    scene = Example()
    before = getattr(scene, name)
    with pytest.raises(ValueError) as refusal:
        setattr(scene, name, value)
    assert str(refusal.value) == reason
    assert getattr(scene, name) == before


def test_default_must_be_possible_too() -> None:
    with pytest.raises(ValueError, match=r"−1 kg is not possible"):
        mass(-1.0, symbol="m")


@pytest.mark.parametrize("value", [3, np.int64(3), np.float32(3)])
def test_any_real_number_becomes_a_double(value: Any) -> None:
    scene = Example(m1=value)
    assert type(scene.m1) is float
    assert scene.m1 == 3.0


def test_panel_is_described_by_groups_and_presets() -> None:
    known = Example.param
    groups = (Group("Chain", (known.m1, known.k2)), Group("Start", (known.x1_0, known.view_of), "or drag a mass"))
    described = panel(Example.param.objects("existing"), groups, presets=Example.presets)
    assert described.presets == (
        PresetButton("stiff", "Stiff", {"k2": 50.0, "m1": 2.0}),
        PresetButton("heavy", "Heavy", {"k2": 1.0, "m1": 10.0}),
        PresetButton("impossible", "Impossible", {"k2": 1e9, "m1": 1e-9}),
    )
    assert [(group.title, group.hint) for group in described.groups] == [("Chain", ""), ("Start", "or drag a mass")]
    assert [row.name for row in described.groups[0].rows] == ["m1", "k2"]
    options = (Option("size", "size"), Option("signed", "signed"))
    assert described.groups[1].rows[1] == ChoiceRow(name="view_of", label="Amplitude", options=options)


def test_state_holds_values_and_the_texts_of_the_fields() -> None:
    scene = Example(k2=0.04)
    state = shown(scene)
    assert state["k2"] == Setting(value=0.04, text="0.0400", changed=True)
    assert state["window"] == Setting(value=None, text="")
    assert state["view_of"].value == "size"
    assert state["log"].value == "false"
    assert "name" not in state


def test_the_state_has_sliders_with_moved_ranges() -> None:
    state = shown(Example(m1=8.0))
    assert state["omega"].soft == (0.0, 8.0)
    assert state["k2"].soft is None


@pytest.mark.parametrize(
    ("message", "errors"),
    [
        (
            {"type": "typed", "name": "m1", "text": "−3"},
            {"m1": "−3 kg is not possible: a mass is a finite number above 0. Still drawn with 2.00."},
        ),
        (
            {"type": "typed", "name": "k2", "text": "two"},
            {"k2": "“two” is not a number: type one such as 2.5 or 1e-3. Still drawn with 1.00."},
        ),
        (
            {"type": "typed", "name": "k2", "text": "1e7"},
            {"k2": "The motion is too fast for a double. Still drawn with 1.00."},
        ),
        ({"type": "typed", "name": "k9", "text": "1"}, {"k9": "“k9” is not a parameter of this scene."}),
        (
            {"type": "typed", "name": "name", "text": "1"},
            {"name": "“name” is not a parameter of this scene."},
        ),
        (
            {"type": "set", "values": {"k2": 3.0, "m1": -1.0}},
            {"m1": "−1 kg is not possible: a mass is a finite number above 0. Still drawn with 2.00."},
        ),
        (
            {"type": "set", "values": {"presets": 1.0}},
            {"presets": "“presets” is not a parameter of this scene."},
        ),
        (
            {"type": "choose", "name": "view_of", "value": "loud"},
            {"view_of": "“loud” is not possible: choose one of size, signed."},
        ),
        ({"type": "choose", "name": "k2", "value": "1"}, {"k2": "“k2” is not a parameter of this scene."}),
    ],
)
def test_refused_message_says_why_and_changes_nothing(message: dict[str, Any], errors: dict[str, str]) -> None:
    scene = Example()
    before, solved = shown(scene), solves(scene)
    assert apply_message(scene, message) == errors
    assert shown(scene) == before
    assert solved == []


@given(
    st.dictionaries(
        st.sampled_from(["type", "values", "name", "text", "value"]),
        st.recursive(
            st.none() | st.booleans() | st.floats() | st.sampled_from(["set", "typed", "choose", "k2", "hidden"]),
            lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from(["k2", "m1", "x"]), inner),
        ),
    )
)
def test_no_message_breaks_the_server(message: dict[str, Any]) -> None:
    scene = Example()
    solved = solves(scene)
    errors = apply_message(scene, message)
    assert not solved or not errors
    assert all(isinstance(text, str) for text in errors.values())


def test_emptied_window_is_the_scene_s_own() -> None:
    scene = Example(window=5.0)
    assert apply_message(scene, {"type": "typed", "name": "window", "text": " "}) == {}
    assert scene.window is None


def test_preset_that_physics_refuses_changes_nothing() -> None:
    scene = Example(m1=5.0)
    assert take_preset(scene, "Impossible") == {"state": "The motion is too fast for a double. Still drawn as before."}
    assert (scene.k2, scene.m1) == (1.0, 5.0)


def test_choices_are_made_by_word_or_value() -> None:
    scene = Example()
    assert apply_message(scene, {"type": "choose", "name": "view_of", "value": "signed"}) == {}
    assert apply_message(scene, {"type": "choose", "name": "log", "value": "true"}) == {}
    assert apply_message(scene, {"type": "choose", "name": "hidden", "value": ["x1.slow", "x2.fast"]}) == {}
    assert (scene.view_of, scene.log, scene.hidden) == ("signed", True, ["x1.slow", "x2.fast"])
