"""Text typed into a field: numbers, expressions and units are converted to the field's unit or refused."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from components.quantities.formatting import parse_number, tidy
from components.quantities.measures import measure
from components.quantities.parameters import Quantity
from components.quantities.typed import typed_number
from components.scenes import SCENES

UNITS = sorted({q.unit for scene in SCENES.values() for q in scene.param.objects().values() if isinstance(q, Quantity)})
OWN_UNITS = {"v₀"}
"""Units that a scene sets itself, from its parameters."""


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("2e3", "m", 2e3),
        ("3·10⁴", "m", 3e4),
        ("1,5", "m", 1.5),
        ("12 000 N", "N", 12e3),
        ("−3 m", "m", -3.0),
        ("pi", "m", math.pi),
        ("2π", "m", math.tau),
        ("2 pi/3", "m", 2.0943951023931957),
        ("1/3", "m", 1 / 3),
        ("sqrt(2)", "m", math.sqrt(2)),
        ("√2", "m", math.sqrt(2)),
        ("2 sqrt(3)/(1+1)", "m", math.sqrt(3)),
        ("2^0.5", "m", math.sqrt(2)),
        ("-2^2", "m", -4.0),
        ("1e400/1e399", "m", 10.0),
        ("007/2", "m", 3.5),
        ("2.5 N/m", "N/m", 2.5),
        ("2.5N/m", "N/m", 2.5),
        ("2.5 N/m", "kN/m", 2.5e-3),
        ("36 km/h", "m/s", 10.0),
        ("150 ft/s", "m/s", 45.72),
        ("5 mm", "m", 5e-3),
        ("5 µF", "F", 5e-6),
        ("1/2 g", "kg", 5e-4),
        ("7 g/cm³", "kg/m³", 7e3),
        ("9.81 m/s^2", "m/s²", 9.81),
        ("9.81 m s⁻²", "m/s²", 9.81),
        ("9.81 m/s/s", "m/s²", 9.81),
        ("3 N·s/m", "N s/m", 3.0),
        ("100 kg m/s²", "N", 100.0),
        ("30°", "rad", 0.5235987755982989),
        ("pi/6 rad", "°", 30.0),
        ("2 Hz", "rad/s", 4 * math.pi),
        ("3 1/s", "rad/s", 3.0),
        ("3 /s", "rad/s", 3.0),
        ("2 N m", "N m/rad", 2.0),
        ("0.5 v₀", "v₀", 0.5),
    ],
)
def test_what_is_meant(text: str, unit: str, value: float) -> None:
    assert typed_number(text, unit) == value


@pytest.mark.parametrize(
    ("text", "unit", "reason"),
    [
        ("3 kg", "N/m", "“3 kg” is in kg, and this is in N/m: type a number in N/m."),
        ("2 s", "m/s", "“2 s” is in s, and this is in m/s: type a number in m/s."),
        ("3 m", "", "“3 m” is in m, and this has no unit: type a number without a unit."),
        ("3 m", "v₀", "“3 m” is in m, and this is in v₀: type a number in v₀."),
        ("3 rad", "m", "“3 rad” is in rad, and this is in m: type a number in m."),
        ("3 foo", "m", "“foo” is not a unit known here: type a number in m."),
        ("1e", "m", "“e” is not a unit known here: type a number in m."),
        ("3 m/", "m", "“m/” is not a unit known here: type a number in m."),
        ("1/0", "m", "“1/0” divides by zero."),
        ("1/0 km", "m", "“1/0 km” divides by zero."),
        ("sqrt(-1)", "m", "“sqrt(-1)” is not a real number."),
        ("9^9^9", "m", "“9^9^9” takes more digits than a field has room for."),
        ("1e999 km", "m", "1e999 km is too large: the largest number that can be held is about 1.8e308."),
        ("10^-400", "m", "10^-400 is too small: the smallest number that can be held is about 5e-324."),
        ("1/2π", "m", "“1/2π” has two meanings: write every multiplication sign ·, and use brackets."),
        ("", "m", "Nothing is typed here: type a number such as 2.5 or 1e-3."),
    ],
)
def test_what_is_refused_says_why(text: str, unit: str, reason: str) -> None:
    with pytest.raises(ValueError) as refused:
        typed_number(text, unit)
    assert str(refused.value) == reason


@pytest.mark.parametrize(
    "text",
    [
        "abc",
        "nan",
        "inf",
        "1 2",
        "1.2.3",
        "٣",
        "()",
        "1+",
        "pi pi",
        "sqrt()",
        "sqrt(1)(2",
        "pi(2)(",
        "__import__('os')",
        "1" * 61,
    ],
)
def test_what_is_no_number_is_refused_with_an_example(text: str) -> None:
    with pytest.raises(ValueError, match=r"is not a number: type one such as 2\.5 or 1e-3"):
        typed_number(text, "m")


@given(st.floats(allow_nan=False, allow_infinity=False), st.sampled_from(UNITS))
def test_every_number_reads_back_with_its_unit_and_without(value: float, unit: str) -> None:
    text = tidy(value)
    assert typed_number(text, unit) == value
    assert typed_number(f"{text} {unit}", unit) == value


@given(st.integers(-(10**9), 10**9), st.integers(1, 10**9))
def test_a_fraction_is_rounded_once(above: int, below: int) -> None:
    assert typed_number(f"{above}/{below}", "m") == float(Fraction(above, below))
    assert typed_number(f"{above}/{below} km", "m") == float(Fraction(1000 * above, below))


@given(
    st.text(alphabet="0123456789.,+-−*/^()e πpisqrtNmkg°²⁻", max_size=70) | st.text(max_size=70), st.sampled_from(UNITS)
)
def test_whatever_is_typed_is_a_double_or_refused_in_words(text: str, unit: str) -> None:
    try:
        value = typed_number(text, unit)
    except ValueError as error:
        assert str(error).endswith(".")
    else:
        assert math.isfinite(value)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_a_plain_number_is_what_a_link_reads(value: float) -> None:
    assert typed_number(repr(value), "m") == parse_number(repr(value))


def test_every_unit_of_a_scene_is_known() -> None:
    for unit in set(UNITS) - OWN_UNITS:
        assert measure(unit).size == (measure("deg").size if unit == "°" else 1)
