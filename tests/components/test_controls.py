"""The control panel of every scene and the settings of its controls."""

import pytest

from components.language.controls import Setting
from components.layout.choices import word
from components.layout.controls import settings
from components.layout.sheet import column, row, words
from components.quantities.parameters import Quantity
from components.quantities.typed import typed_number
from components.quantities.units import Unit
from components.scenes import SCENES

scenes = pytest.mark.parametrize("slug", SCENES)


@scenes
def test_a_field_has_the_value_of_its_quantity_and_says_whether_it_has_changed(slug: str) -> None:
    for values in SCENES[slug].presets.values():
        scene = SCENES[slug].at(values)
        spans = scene.shown.spans
        for name, setting in settings(scene.param.objects("existing"), scene.values, scene.units(), spans).items():
            parameter, value = SCENES[slug].param[name], scene.values.get(name)
            assert setting.changed == (value != parameter.default)
            if isinstance(parameter, Quantity):
                check_field(parameter, setting, value)
                assert setting.soft == spans.get(name)
            else:
                assert setting.value == setting.text == word(value)


def check_field(quantity: Quantity, setting: Setting, value: float | None) -> None:
    assert setting.value == value
    if value is None:
        assert setting.text == ""
        return
    typed = typed_number(setting.text, setting.unit or quantity.unit) * (setting.size or 1.0)
    assert typed == pytest.approx(value, rel=1e-3 if setting.unit else 0.0, abs=0.0)


FOOT_PER_SECOND, KNOT = Unit("ft/s", 0.3048), Unit("knots", 1852 / 3600)


def test_a_quantity_in_another_unit_has_four_digits_and_round_numbers_come_back_round() -> None:
    assert FOOT_PER_SECOND.value(150.0) == 45.72
    for value in (150, 87.5):
        assert FOOT_PER_SECOND.field(FOOT_PER_SECOND.value(value)) == f"{value:g}"
    assert (KNOT.field(45.72), FOOT_PER_SECOND.field(1 / 3), FOOT_PER_SECOND.field(0.0)) == ("88.87", "1.094", "0.00")
    for value in (1e-300, 1e300, -2.5):
        assert float(FOOT_PER_SECOND.field(value)) == pytest.approx(value / 0.3048, rel=1e-3)


def test_a_block_that_its_neighbours_leave_no_room_is_refused() -> None:
    high = words("A plot.", grow=300)
    with pytest.raises(ValueError, match="A block with grow=1 has no room beside one with grow=300: give it more"):
        column(row(words("Beside another.")), high)
    assert column(row(words("Beside another."), grow=250), words("As high as its text."), high)
