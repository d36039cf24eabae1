"""Quantities shown and typed in another unit than their own."""

from __future__ import annotations

import pytest

from components.language.controls import Setting, SliderRow
from components.layout.controls import control, settings
from components.quantities.typed import typed_number
from components.quantities.units import Unit
from components.scenes.phugoid import Phugoid
from components.state.scene_sheet import scene_sheet
from tests.page.headless_page import apply_message

FOOT_PER_SECOND, KNOT = Unit("ft/s", 0.3048), Unit("knots", 1852 / 3600)


def test_a_round_number_comes_back_round() -> None:
    assert FOOT_PER_SECOND.value(150.0) == 45.72
    assert FOOT_PER_SECOND.field(45.72) == "150"
    assert FOOT_PER_SECOND.field(FOOT_PER_SECOND.value(87.5)) == "87.5"


def test_other_numbers_are_shown_with_four_digits() -> None:
    assert KNOT.field(45.72) == "88.87"
    assert Unit("ft/s", 0.3048).field(1 / 3) == "1.094"
    assert FOOT_PER_SECOND.field(0.0) == "0.00"


@pytest.mark.parametrize("value", [1e-300, 1e300, -2.5])
def test_any_size_is_shown(value: float) -> None:
    assert float(FOOT_PER_SECOND.field(value)) == pytest.approx(value / 0.3048, rel=1e-3)


def shown(scene: Phugoid) -> Setting:
    return settings(scene.param.objects("existing"), scene.values, scene.units(), scene.shown.spans)["v_0"]


def test_state_says_the_unit_and_its_size() -> None:
    scene = Phugoid()
    assert shown(scene) == Setting(value=45.72, text="150", unit="ft/s", size=0.3048)
    scene.unit = "m/s"
    assert shown(scene) == Setting(value=45.72, text="45.72")


def test_typed_numbers_are_in_the_unit_shown() -> None:
    scene = Phugoid()
    assert apply_message(scene, {"type": "typed", "name": "v_0", "text": "200"}) == {}
    assert scene.v_0 == pytest.approx(60.96, rel=1e-15)
    assert apply_message(scene, {"type": "typed", "name": "excess", "text": "50"}) == {}
    assert scene.excess == pytest.approx(0.25, rel=1e-14)
    scene.unit = "knots"
    assert apply_message(scene, {"type": "typed", "name": "v_0", "text": "100"}) == {}
    assert scene.v_0 == pytest.approx(100 * 1852 / 3600, rel=1e-15)


def test_refusals_use_the_shown_unit() -> None:
    scene = Phugoid()
    errors = apply_message(scene, {"type": "typed", "name": "excess", "text": "-200"})
    assert errors["excess"].startswith("−200 ft/s is not possible: an excess of speed is from −v₀")
    assert errors["excess"].endswith("Still drawn with 90.0.")
    assert scene.excess == 0.6
    errors = apply_message(scene, {"type": "set", "values": {"v_0": -3.048}})
    assert errors["v_0"].startswith("−10.0 ft/s is not possible")
    assert "not possible" in apply_message(scene, {"type": "set", "values": {"v_0": float("nan")}})["v_0"]
    for odd in (True, 10**400, "fast"):
        assert list(apply_message(scene, {"type": "set", "values": {"v_0": odd}})) == ["message"]


def test_marks_and_outlines_reach_the_page() -> None:
    slider = control(Phugoid.param.excess)
    assert isinstance(slider, SliderRow)
    assert [mark.text for mark in slider.marks] == ["0", "0.1 %", "1 %", "cusp", "loops"]
    assert [mark.value for mark in slider.marks] == sorted(mark.value for mark in slider.marks)
    presets = scene_sheet(Phugoid).panel.presets
    assert [preset.label for preset in presets] == list(Phugoid.presets)
    assert all(preset.outline.startswith("M") for preset in presets)


@pytest.mark.parametrize(
    ("text", "value"), [("２．５", 2.5), ("－3", -3), ("１／３", 1 / 3), ("1。5", 1.5), ("２ｍ", 2)]
)
def test_full_width_characters_are_read_as_plain_ones(text: str, value: float) -> None:
    assert typed_number(text, "m") == value
