"""The texts of a walk's file: where a line of formulas may end."""

from __future__ import annotations

import pytest

from components.layout.text import mathml
from components.walks.loading import load_walks, steps_of
from components.walks.texts import line, pieces

EQUATIONS = [equation for step in steps_of(load_walks(()).values()).values() for equation in step.equations]


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"F = -k x, \quad k > 0", [r"F = -k x, \quad ", "k > 0"]),
        (r"T = V,\; V = 2", [r"T = V,\; ", "V = 2"]),
        (r"a = b \;\Rightarrow\; c = d = e", [r"a = b \;", r"\Rightarrow\; c = d ", "= e"]),
        (r"x = 0 \text{ at } t = 0", ["x = 0 ", r"\text{ at } t = 0"]),
        (r"p = x_1 \text{'s slow part}", [r"p = x_1 \text{'s slow part}"]),
        (r"(a = b = c) = \frac{a = b}{c}", [r"(a = b = c) = \frac{a = b}{c}"]),
        (r"\left\{a = b = c\right. \quad d", [r"\left\{a = b = c\right. \quad d"]),
        (
            r"\begin{matrix} a = b = c & d \end{matrix} = e = f",
            [r"\begin{matrix} a = b = c & d \end{matrix} = e ", "= f"],
        ),
        (r"a = b = c \over d", [r"a = b = c \over d"]),
        ("", [""]),
    ],
)
def test_a_line_ends_between_its_pieces(latex: str, expected: list[str]) -> None:
    assert pieces(latex) == expected


@pytest.mark.parametrize("latex", EQUATIONS)
def test_the_pieces_are_formulas_that_make_the_whole(latex: str) -> None:
    assert "".join(pieces(latex)) == latex
    for piece in pieces(latex):
        mathml(piece)
    assert line(latex).count("<math") == len(pieces(latex))
