"""The results of the scripts compared with Python: signals, texts of numbers, places of names."""

from __future__ import annotations

import json
from typing import Any

import pytest

from components.state.encoding import COARSE
from tests.page.scripts import each
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
