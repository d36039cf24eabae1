"""The scripts: their types are those of components/language, as in docs/protocol.md; numbers as Python writes them; and
descriptions of curves for screen readers."""

import json
from pathlib import Path
from typing import Any

import msgspec
import pytest

from components.quantities import formatting
from components.quantities.axes import Axis
from components.state.encoding import COARSE
from tests.page.scripts import call, each
from tests.serving.server import ROOT
from tools.protocol import FILES

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
        *((2.0, "2"), (12345.6, "12\u202f300"), (0.5, "0.5"), (999400.0, "999\u202f000"), (1.23e7, "1.23·10⁷"))
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
    given, texts = [case[:-1] for case in WRITTEN[function]], [case[-1] for case in WRITTEN[function]]
    assert each(f"static/{function}", given) == texts
    if (name := function.rpartition(".")[2]) in KINDS:
        assert [getattr(formatting, name)(*one) for one in given] == texts, "as in Python"


AXES = [Axis(0.5, 4.0, exponent=-4), Axis(0.5, 4.0, power=2, exponent=-4), Axis(0.5, 4.0, log=True, factor=0.3048)]


@pytest.mark.parametrize("axis", AXES, ids=str)
def test_a_place_on_an_axis_stands_for_a_quantity_as_in_python_and_back(axis: Axis) -> None:
    for value in (0.25, 1.0, 3.7):
        place = call("static/core/ruler.toPlace", axis.ruler, value)
        assert place == pytest.approx(axis.place(value), rel=1e-14)
        assert call("static/core/ruler.toSI", axis.ruler, place) == pytest.approx(value, rel=1e-14)


X, Y = Axis(0.0, 10.0, "s"), Axis(-2.0, 2.0, "m")
Points = list[tuple[float, float]]


def course(pieces: list[Points], lines: int = 1) -> str:
    trace = {"name": "x", "lines": lines, "motion": None}
    trace["pieces"] = [{"xs": [x for x, _ in one], "ys": [y for _, y in one]} for one in pieces]
    return str(call("static/scene/describe.course", trace, *(msgspec.to_builtins(axis) for axis in (X, Y))))


def test_lines_through_the_frame_gaps_and_poles_are_described() -> None:
    assert course([[(4.0, -50.0), (4.0, 50.0)]]) == "x: upright at 4 s, from outside the frame to outside the frame."
    assert course([[(-90.0, -20.0), (110.0, 20.0)]]) == "x: rises from −2 m to 0 m."
    assert "lines: lowest" in course([[(0.0, 1.0), (1.0, 1.0)], [(0.0, 0.0), (1.0, 0.5)]], lines=2)
    told = course([[(0.0, 1.0), (4.0, 1.0)], [(6.0, 1.0), (9.0, 1.0)]])
    assert told == "x, 2 pieces: from 0 s to 4 s it stays at 1 m; from 6 s to 9 s it stays at 1 m."
    assert course([[(2.0, 1.0)], [(4.0, 0.5)]]) == "x, 2 pieces: 1 m at 2 s; 0.5 m at 4 s."
    assert course([[(0.0, 1.0), (10.0, 1.0)]]) == "x: 1 m throughout."
    assert course([[(0.0, 9.0), (10.0, 9.0)]]) == "x: outside the frame throughout."
    assert course([[(0.0, 9.0), (5.0, 1.0), (10.0, 9.0)]]).startswith("x: from outside the frame to outside the frame,")
    bent = [(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)]
    assert course([bent]) == "x: from 0 m to 0 m, lowest 0 m at 0 s, highest 1 m at 1 s."
    first, second = course([[(0.0, 0.1), (4.9, 9.0)], [(5.1, -9.0), (10.0, -0.1)]]).split("; ")
    assert " it rises from " in first and first.endswith(" to outside the frame")
    assert " it rises from outside the frame to " in second


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_what_is_written_is_current(path: Path) -> None:
    assert path.read_text(encoding="utf-8") == FILES[path](), "make protocol writes it anew"
