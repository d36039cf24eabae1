"""Deferred expressions: allowed and forbidden uses of a case in a paper before a case exists."""

from collections.abc import Callable

import pytest

from components.layout.sheet import column, row, words
from components.paper.deferred import Attributes, book_of, deferred, number, recorded
from components.paper.plots import either
from components.quantities.declared import Declared, Family, LiveNumber, Scalar, by_name


class PointCase:
    """A case of nothing but numbers."""

    a: float

    def __init__(self, a: float) -> None:
        self.a = a


value = Attributes(PointCase)


class PointShown(PointCase):
    twice = value(lambda c: 2 * c.a)
    opposite = -twice


c = deferred(PointShown)


class Declarations(Declared[complex]):
    size = LiveNumber[complex](abs, "|z|", "m")
    side = Family((1, 2), lambda i: Scalar[complex](lambda z, a: i * z.real))


def form(name: str, *uses: tuple[object, str]) -> list[str]:
    return [book_of(PointShown).form(recorded(of), [word], name) for of, word in uses]


@pytest.mark.parametrize(
    ("wrong", "error", "says"),
    [
        # mypy asks for each of these remarks.
        (lambda: c.hlaf, AttributeError, "a PointShown has no hlaf"),  # type: ignore[attr-defined]
        (lambda: Declarations.omga, AttributeError, "omga"),  # type: ignore[attr-defined]
        (lambda: Declarations.side[3], KeyError, "3"),
        (lambda: by_name({"x": 1.0}), AttributeError, "no attribute"),  # type: ignore[type-var]
        (lambda: bool(c.a == 3.0), TypeError, "make what depends on it an attribute of the case"),
        (lambda: number(2.0), TypeError, "not an expression of a case"),
        (lambda: f"{c.twice}", ValueError, "written in two ways"),
        (lambda: form("of_one", (c.opposite, "formula"), (c.opposite, "shown")), ValueError, "used in two ways"),
        (lambda: form("of_two", (c.opposite, "formula"), (c.a, "formula")), ValueError, "used in two ways"),
        (lambda: column(row(words("Low.")), words("High.", grow=300)), ValueError, "grow=1 has no room beside one"),
    ],
)
def test_an_author_is_told_what_cannot_be_written(
    wrong: Callable[[], object], error: type[Exception], says: str
) -> None:
    """A wrong name, a decision before there is a case, a number with two formats, a form with two meanings."""
    either(c.a == 1.0, yes="one", no="others").forms()
    assert f"{c.twice:+}" == r"\val{twice}"
    assert [recorded(of).compute(PointShown(3.0), {}) for of in (c.a == 3.0, c.a != 3.0)] == [True, False]
    with pytest.raises(error, match=says):
        wrong()
