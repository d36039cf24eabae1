"""Deferred expressions: allowed and forbidden uses of a case in a paper before a case exists."""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

import pytest

from components.paper.deferred import Attributes, book_of, deferred, number, recorded
from components.paper.plots import either
from components.quantities.declared import Declared, Family, LiveNumber, Scalar, by_name


class Place(NamedTuple):
    x: float
    y: float


class PointCase:
    """A case of nothing but numbers."""

    a: float

    def __init__(self, a: float) -> None:
        self.a = a

    @cached_property
    def places(self) -> list[Place]:
        return [Place(self.a, 2 * self.a)] if self.a else []


value = Attributes(PointCase)


class PointShown(PointCase):
    twice = value(lambda c: 2 * c.a)
    half = value.optional(lambda c: c.a / 2 if c.a else None)
    opposite = -twice


c = deferred(PointShown)


def test_an_expression_is_computed_for_each_case() -> None:
    for of, expected in ((c.a, 3.0), (c.places[0].y, 6.0), (c.a == 3.0, True), (c.a != 3.0, False), (c.half, 1.5)):
        assert recorded(of).compute(PointShown(3.0), {}) == expected
    assert recorded(c.places[0].y).compute(PointShown(0.0), {}) is None
    assert recorded(c.places[1].y).compute(PointShown(3.0), {}) is None


class Declarations(Declared[complex]):
    size = LiveNumber[complex](abs, "|z|", "m")
    side = Family((1, 2), lambda i: Scalar[complex](lambda z, a: i * z.real))


def test_a_misspelt_name_is_an_error_also_of_types() -> None:
    """mypy, which asks for each of these remarks, finds them."""
    with pytest.raises(AttributeError, match="a PointShown has no hlaf"):
        c.hlaf  # type: ignore[attr-defined]  # noqa: B018
    with pytest.raises(AttributeError):
        Declarations.omga  # type: ignore[attr-defined]  # noqa: B018
    with pytest.raises(KeyError):
        Declarations.side[3]
    with pytest.raises(AttributeError):
        by_name({"x": 1.0})  # type: ignore[type-var]


def test_nothing_is_decided_before_there_is_a_case() -> None:
    with pytest.raises(TypeError, match="make what depends on it an attribute of the case"):
        bool(c.a == 3.0)
    with pytest.raises(TypeError, match="not an expression of a case"):
        number(2.0)


def test_a_number_is_written_in_one_way() -> None:
    assert f"{c.twice:+}" == r"\val{twice}"
    with pytest.raises(ValueError, match="written in two ways"):
        f"{c.twice}"


def test_a_form_has_one_meaning() -> None:
    either(c.a == 1.0, yes="one", no="others").forms()
    book, record = book_of(PointShown), recorded(c.opposite)
    book.form(record, ["formula"])
    with pytest.raises(ValueError, match="used in two ways"):
        book.form(record, ["shown"])
    with pytest.raises(ValueError, match="used in two ways"):
        book.form(recorded(c.a), ["formula"], "opposite")
