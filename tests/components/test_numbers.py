"""Numbers as a person reads and types them."""

import json
import math
from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from components.quantities.formatting import (
    at_tick,
    excerpt,
    parse_number,
    power_unit,
    short,
    shortest,
    signed,
    three,
    tidy,
    with_error,
)
from tests.serving.server import ROOT

TEXTS = json.loads((ROOT / "tests" / "reference" / "number_texts.json").read_text(encoding="utf-8"))
"""Texts that both languages write: tests/page/test_scripts.py reads them too."""
finite = st.floats(allow_nan=False, allow_infinity=False)


@given(finite)
def test_three_digits_are_within_half_a_unit_of_the_third(value: float) -> None:
    shown = three(value).replace("−", "-").replace("·10", "e").translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))
    assert abs(Decimal(shown) - Decimal(value)) <= abs(Decimal(value)) * Decimal("0.005")


@pytest.mark.parametrize("case", TEXTS, ids=lambda case: repr(case["value"]))
def test_both_languages_write_the_same(case: dict[str, object]) -> None:
    written = {function.__name__: function(case["value"]) for function in (three, signed, short, tidy)}
    assert {"value": case["value"], **written} == case


@given(finite)
def test_field_and_shortest_text_read_back_exactly(value: float) -> None:
    for text in (tidy(value), shortest(value)):
        assert text.isascii()
        assert float(text) == value
        assert parse_number(text) == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1e-3", 1e-3),
        ("1,5", 1.5),
        ("−3", -3.0),
        ("1.5·10^-3", 1.5e-3),
        ("1.5 × 10^−3", 1.5e-3),
        ("1.23·10⁻⁷", 1.23e-7),
        ("10⁻³", 1e-3),
        ("-10^3", -1e3),
        ("  2.5 ", 2.5),
        ("12 000", 12000.0),
        ("１．５", 1.5),
        (".5", 0.5),
        ("+5.", 5.0),
        ("0e-999", 0.0),
    ],
)
def test_number_as_people_type_it(text: str, value: float) -> None:
    assert parse_number(text) == value


@given(finite)
def test_what_is_shown_can_be_typed_again(value: float) -> None:
    if 1e-307 < abs(value) < 1e307:
        assert parse_number(three(value)) == pytest.approx(value, rel=5e-3)


@pytest.mark.parametrize(
    "text", ["abc", "nan", "inf", "1e", "1 2", "0x10", "1_0", "1.5·105", "٣", "1.2.3", "1" * 61, "3 N/m"]
)
def test_text_that_is_no_number_is_refused_with_an_example(text: str) -> None:
    with pytest.raises(ValueError, match=r"is not a number: type one such as 2\.5 or 1e-3"):
        parse_number(text)


@pytest.mark.parametrize("text", ["", "  "])
def test_an_empty_field_is_not_quoted(text: str) -> None:
    with pytest.raises(ValueError, match=r"^Nothing is typed here: type a number such as 2\.5 or 1e-3\.$"):
        parse_number(text)


@pytest.mark.parametrize(("text", "reason"), [("1e999", "too large"), ("-1e999", "too large"), ("1e-999", "too small")])
def test_number_that_no_double_holds_is_refused(text: str, reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        parse_number(text)


@given(finite)
def test_scaled_axis_reaches_to_a_readable_number(value: float) -> None:
    exponent, _ = power_unit(value)
    scaled = abs(value) / 10.0**exponent
    assert exponent % 3 == 0
    assert value == 0 or 0.999e-3 <= scaled < 1e4 or abs(value) < 1e-306


def test_foreign_text_is_shortened_and_made_visible() -> None:
    assert excerpt("a\nb\u202ec") == "a\ufffdb\ufffdc"
    assert excerpt("x" * 41) == "x" * 39 + "…"
    assert excerpt("x" * 40) == "x" * 40


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (-2.5, "−2.5"), (1252.5, "1252.5"), (0.00125, "0.00125"), (4e6, "4·10⁶"), (-1e305, "−1·10³⁰⁵")],
)
def test_a_tick_has_the_digits_that_it_takes(value: float, text: str) -> None:
    assert at_tick(value) == text


@pytest.mark.parametrize(
    ("value", "error", "texts"),
    [
        (6.30171, 0.00083, ("6.3017", "0.0008")),
        (0.017673, 0.00012, ("0.01767", "0.00012")),
        (-0.1049, 0.0031, ("−0.105", "0.003")),
        (13.899, 1.4, ("13.9", "1.4")),
        (0.0, 0.02, ("0.00", "0.02")),
        (13450.0, 21.0, ("1.345·10⁴", "0.002·10⁴")),
        (2.3456e-7, 3e-9, ("2.35·10⁻⁷", "0.03·10⁻⁷")),
        (2.5, 0.0, ("2.50", "")),
        (2.5, math.inf, ("2.50", "")),
    ],
)
def test_a_number_ends_at_the_place_of_its_error(value: float, error: float, texts: tuple[str, str]) -> None:
    assert with_error(value, error) == texts
