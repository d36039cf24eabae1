"""Declarations of the numbers of a picture: they give its values, and mypy, run on this file, finds wrong names."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from components.language.expressions import PAGE_NUMBERS
from components.layout.controls import Group
from components.quantities.axes import Axis
from components.quantities.declared import (
    Declared,
    Family,
    LiveNumber,
    Scalar,
    by_name,
)
from components.scene.about import rows

number = LiveNumber[complex]
STATIC = Path(__file__).parents[2] / "static"


class Drawn(Declared[complex]):
    """A case with a number and one scalar for each of two sides."""

    size = number(abs, "|z|", "m", "m1")
    x = Scalar[complex](lambda z, a: z.real)
    side = Family((1, 2), lambda i: Scalar[complex](lambda z, a: i * z.real))


AXES = {"x": Axis(0.0, 5e-3, "m")}


def test_the_live_numbers_of_the_page_are_its_own() -> None:
    told = {name for file in STATIC.rglob("*.js") for name in re.findall(r'live\.tell\("(\w+)"', file.read_text())}
    assert told == PAGE_NUMBERS
    with pytest.raises(ValueError, match="Fast: the page has a live number “speed” of its own"):

        class Fast(Declared[complex]):
            speed = number(abs)


def test_a_misspelt_name_is_an_error_of_types() -> None:
    with pytest.raises(AttributeError):
        Drawn.omga  # type: ignore[attr-defined]  # noqa: B018
    wrong = number(lambda z: z.rael)  # type: ignore[attr-defined]
    first, _ = number.both(lambda z: (z.rael, z.imag))  # type: ignore[attr-defined]
    for one in (wrong, first):
        with pytest.raises(AttributeError):
            one.text(1j, AXES)
    with pytest.raises(TypeError):
        number(symbol="x")  # type: ignore[call-arg]  # a number without a value
    with pytest.raises(AttributeError):
        Drawn.axis  # type: ignore[attr-defined]  # noqa: B018
    with pytest.raises(KeyError):
        Drawn.side[3]


def test_strings_are_no_names() -> None:
    """mypy, which asks for each of these remarks, finds them; where a name is read they are refused."""
    with pytest.raises(AttributeError):
        by_name({"x": 1.0})  # type: ignore[type-var]
    with pytest.raises(AttributeError):
        rows({"x": "$x$"}, {"t": np.zeros(1)}, {})  # type: ignore[type-var]
    with pytest.raises(AttributeError):
        _ = Group("Start", ("x_0",)).names  # type: ignore[arg-type]
