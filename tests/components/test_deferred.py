"""Deferred expressions: what a paper says of a case before there is one, and what it must not say."""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

import pytest

from components.language.expressions import named
from components.layout.stage import circle
from components.paper.deferred import Attributes, book_of, deferred, fields, number, recorded
from components.paper.plot_axes import axis
from components.paper.plots import Plot, either, shown_by
from components.quantities.axes import Axis


class Place(NamedTuple):
    x: float
    y: float


class PointCase:
    """A case of nothing but numbers."""

    a: float

    def __init__(self, a: float) -> None:
        self.a = a
        self.asked: list[str] = []

    @cached_property
    def places(self) -> list[Place]:
        return [Place(self.a, 2 * self.a)] if self.a else []


value = Attributes(PointCase)


def _asked(case: PointCase) -> float:
    case.asked.append("twice")
    return 2 * case.a


class PointShown(PointCase):
    twice = value(_asked)
    half = value.optional(lambda c: c.a / 2 if c.a else None)
    both, neither = value.pair(lambda c: (c.a, -c.a) if c.a > 1 else None, called=("first", "second"))
    total = twice + half
    opposite = -twice
    beyond = (twice - 1.0).where(lambda c: c.a > 10)


c = deferred(PointShown)


def test_an_attribute_is_computed_once_and_only_if_it_is_read() -> None:
    case = PointShown(3.0)
    assert case.asked == []
    assert (case.twice, case.twice, case.total, case.opposite) == (6.0, 6.0, 7.5, -6.0)
    assert case.asked == ["twice"]


def test_a_missing_part_makes_the_whole_missing() -> None:
    case = PointShown(0.0)
    assert (case.half, case.total, case.both, case.neither, case.beyond) == (None,) * 5
    assert (PointShown(2.0).both, PointShown(2.0).neither, PointShown(20.0).beyond) == (2.0, -2.0, 39.0)


def test_an_expression_is_computed_for_each_case() -> None:
    for of, expected in ((c.a, 3.0), (c.places[0].y, 6.0), (c.a == 3.0, True), (c.a != 3.0, False), (c.half, 1.5)):
        assert recorded(of).compute(PointShown(3.0), {}) == expected
    assert recorded(c.places[0].y).compute(PointShown(0.0), {}) is None
    assert recorded(c.places[1].y).compute(PointShown(3.0), {}) is None


def test_names_are_those_of_the_class_and_of_the_path() -> None:
    assert [recorded(one).name for one in (c.a, c.places[0].y, c.both, c.a == 3)] == ["a", "places0_y", "first", "a_3"]
    assert fields(PointShown) == ("a",)


def test_a_misspelt_name_is_an_error() -> None:
    with pytest.raises(AttributeError, match="a PointShown has no hlaf"):
        c.hlaf  # type: ignore[attr-defined]  # noqa: B018


def test_nothing_is_decided_before_there_is_a_case() -> None:
    with pytest.raises(TypeError, match="make what depends on it an attribute of the case"):
        bool(c.a == 3.0)
    with pytest.raises(TypeError, match="not an expression of a case"):
        number(2.0)


def test_it_counts_like_a_number() -> None:
    a = named("a")
    for expression, expected in (
        (2 * c.a, 2 * a),
        (c.a * 2, a * 2),
        (1 + c.a, a + 1),
        (c.a - 1, a - 1),
        (1 - c.a, 1 - a),
        (c.a / 4, a / 4),
        (-c.a, -a),
        (named("W") * c.a, a * named("W")),
        (named("W") + c.a, a + named("W")),
    ):
        assert expression == expected


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


def test_a_place_in_a_plot_is_an_attribute() -> None:
    plot = Plot("somewhere", axis("m", lambda c: (0.0, c.a)), axis("m", lambda c: (0.0, c.a)))
    assert (plot.across.name, plot.up.name) == ("somewhere_x", "somewhere")
    assert plot.x(c.beyond) == named("somewhere.x0") + named("somewhere.x1") * named("beyond")
    assert plot.x(0) == named("somewhere.x0") + named("somewhere.x1") * 0.0
    with pytest.raises(TypeError, match=r"0\.5 has no place before there is an axis"):
        plot.y(0.5)


def test_a_value_of_the_frame_knows_the_axes() -> None:
    plot = Plot("kept", axis("m", lambda c: (0.0, c.a)), axis("m", lambda c: (0.0, c.a)))
    inside = plot.in_frame(c, "inside", lambda case, x, y: x.start <= case.a <= x.end)
    (shape,) = shown_by(inside, circle(1.0, 2.0, 3.0))
    assert shape.show == ("inside",)
    axes = {"kept_x": Axis(0.0, 2.0), "kept": Axis(0.0, 1.0)}
    assert [recorded(inside).compute(PointShown(a), axes) for a in (1.0, 3.0)] == [True, False]
