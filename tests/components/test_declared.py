"""A live number is declared once: its text and readout follow, and mypy, which reads this file, finds a wrong name."""

from __future__ import annotations

from decimal import Decimal

import pytest

from components.layout.text import mathml, rich, runs
from components.quantities.axes import Axis
from components.quantities.declared import AxisUnit, Declared, LiveNumber, Text, by_name
from components.quantities.numbers import plus
from components.quantities.readouts import Readout
from components.scenes.damped.numbers import Numbers as N

number = LiveNumber[complex]


class Shared(Declared[complex]):
    size = number(abs, "|z|", "m", "m1")
    unit = AxisUnit("x")


class Own(Shared):
    real = number(lambda z: z.real, form=plus)
    imaginary = number(lambda z: z.imag or None, "y", axis=Shared.unit)
    length = number(abs, unit="m", whole=True)
    height = number(lambda z: z.imag, axis=Shared.unit, whole=True)
    sign = number(lambda z: "none" if not z.real else z.real / abs(z), "s")
    first, second = number.both(lambda z: (Decimal(z.real), z.imag), plus, unit="m", whole=True)


AXES = {"x": Axis(0.0, 5e-3, "m")}


def test_texts_follow_in_the_order_of_declaration() -> None:
    texts = Own.texts(3e-3 + 4e-3j, AXES)
    assert list(texts) == ["size", "unit", "real", "imaginary", "length", "height", "sign", "first", "second"]
    assert texts["real"] == "+ 0.00300" and texts["unit"] == AXES["x"].full_unit
    assert texts["imaginary"] == AXES["x"].number(4e-3)
    assert (texts["first"], texts["second"]) == ("+ 0.00300 m", "+ 0.00400 m")
    assert (texts["length"], texts["height"]) == ("0.00500 m", f"{texts['imaginary']} {texts['unit']}")


def test_a_text_is_made_of_the_case_or_elsewhere() -> None:
    class Texts(Declared[complex]):
        here = Text[complex](lambda z, axes: f"{z.real} {axes['x'].unit}")
        one, two = Text[complex].some(2)

    assert Texts.texts(2j, AXES) | by_name({Texts.two: "elsewhere"}) == {"here": "0.0 m", "two": "elsewhere"}


def test_an_axis_has_its_own_way_to_write_what_is_counted_on_it() -> None:
    whole = AxisUnit("x", write=lambda axis, value: f"{axis.place(value):.0f}")
    assert number(abs, axis=whole).text(3e-3 + 4e-3j, AXES) == f"{AXES['x'].place(5e-3):.0f}"


def test_what_has_a_symbol_and_a_value_is_compared() -> None:
    assert Own.readouts(3 + 4j) == (
        Readout("size", "|z|", 5.0, "m", "m1"), Readout("imaginary", "y", 4.0, ""), Readout("sign", "s", 0.6, ""),
    )  # fmt: skip
    assert [one.name for one in Own.readouts(2j)] == ["size", "imaginary"]
    assert Own.texts(2 + 0j, AXES)["imaginary"] == "" and Own.texts(2j, AXES)["sign"] == "none"


def test_a_name_stands_alike_in_words_formulas_and_drawings() -> None:
    assert rich(f"{Own.size} m") == rich("{size} m")
    assert mathml(f"r = {Own.size}") == mathml(r"r = \val{size}")
    assert runs(f"*r* {Own.size}") == runs("*r* {size}")


def test_it_is_read_aloud_with_its_unit() -> None:
    assert (Own.size.aloud, Own.sign.aloud, Own.imaginary.aloud) == ("{size} m", "{sign}", "{imaginary} {unit}")
    assert Own.length.aloud == "{length}"


def test_a_misspelt_name_is_an_error_of_types() -> None:
    with pytest.raises(AttributeError):
        N.omga  # type: ignore[attr-defined]  # noqa: B018
    wrong = number(lambda z: z.rael)  # type: ignore[attr-defined]
    first, _ = number.both(lambda z: (z.rael, z.imag))  # type: ignore[attr-defined]
    for one in (wrong, first):
        with pytest.raises(AttributeError):
            one.text(1j, AXES)
    with pytest.raises(TypeError):
        number(symbol="x")  # type: ignore[call-arg]  # a number without a value
