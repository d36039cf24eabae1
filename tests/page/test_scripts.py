"""The results of the scripts compared with Python: signals, texts of numbers, places of names."""

from __future__ import annotations

import json
import math
from itertools import product
from typing import Any

import pytest

from components.quantities.axes import Axis
from components.state.encoding import COARSE
from tests.page.scripts import call, each
from tests.serving.server import ROOT

TEXTS = json.loads((ROOT / "tests" / "reference" / "number_texts.json").read_text(encoding="utf-8"))


STEP = 30 / COARSE  # 0.00046
KINDS = ("three", "signed", "short", "tidy")
WRITTEN: dict[str, list[tuple[Any, ...]]] = {
    **{f"core/numbers.{kind}": [(case["value"], case[kind]) for case in TEXTS] for kind in KINDS},
    "core/numbers.fixed": [
        *((1.25, 1, False, "1.3"), (-1.25, 1, False, "−1.3"), (-0.001, 2, False, "0.00"), (-0.001, 2, True, "+0.00")),
        *((0.5, 2, True, "+0.50"), (-12.0, 0, True, "−12")),
    ],
    "core/numbers.grouped": [
        *((2.0, "2"), (12345.6, "12\u202f300"), (0.5, "0.5"), (999400.0, "999\u202f000"), (1.23e7, "1.23·10⁷")),
    ],
    "scene/reading.honest": [
        *((12.3456, STEP, "12.3"), (-0.123456, STEP, "−0.123"), (0.0123456, STEP, "0.012"), (-0.00234, STEP, "−0.002")),
        *((0.0003, STEP, "0"), (0.0, STEP, "0"), (2.3456, 0.03, "2.3"), (2.3456, 0.0, "2.35")),
        *((0.000123456, 0.0, "1.23·10⁻⁴"),),
    ],
}
"""Functions that write numbers: as Python does, with fixed places, how many times, and without unknown digits."""


@pytest.mark.parametrize("function", WRITTEN)
def test_a_number_is_written(function: str) -> None:
    cases = WRITTEN[function]
    assert each(f"static/{function}", (case[:-1] for case in cases)) == [case[-1] for case in cases]


AXES = [
    Axis(0.5, 4.0, log=log, power=power, exponent=exponent, factor=factor)
    for log, power, exponent, factor in product((False, True), (1, 2), (0, -4), (1.0, math.pi / 180))
    if not (log and (power > 1 or exponent))
]


@pytest.mark.parametrize("axis", AXES, ids=str)
def test_a_place_on_an_axis_stands_for_a_quantity_as_in_python_and_back(axis: Axis) -> None:
    for value in (0.25, 1.0, 3.7):
        place = call("static/core/ruler.toPlace", axis.ruler, value)
        assert place == pytest.approx(axis.place(value), rel=1e-14)
        assert call("static/core/ruler.toSI", axis.ruler, place) == pytest.approx(value, rel=1e-14)
