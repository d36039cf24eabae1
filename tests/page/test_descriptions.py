"""Descriptions of curves for screen readers, compared with densely sampled points of the same lines."""

from __future__ import annotations

import re
from typing import Any

import msgspec
import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from components.quantities.axes import Axis
from tests.grids import tries
from tests.page.scripts import call

X, Y = Axis(0.0, 10.0, "s"), Axis(-2.0, 2.0, "m")
ROOM = 1e-3
Points = list[tuple[float, float]]


def course(pieces: list[Points], lines: int = 1) -> str:
    trace = {"name": "x", "lines": lines, "motion": None}
    trace["pieces"] = [{"xs": [x for x, _ in one], "ys": [y for _, y in one]} for one in pieces]
    return str(call("static/scene/describe.course", trace, *(msgspec.to_builtins(axis) for axis in (X, Y))))


def heights(rising: st.SearchStrategy[float]) -> st.SearchStrategy[list[float]]:
    return st.lists(rising, min_size=1, max_size=6)


@st.composite
def curves(draw: Any) -> list[Points]:
    """Consecutive pieces, each with heights inside and outside the frame, or one height."""
    pieces: list[Points] = []
    start = draw(st.floats(-3.0, 3.0))
    for _ in range(draw(st.integers(1, 4))):
        flat = draw(st.booleans())
        ys = draw(heights(st.sampled_from((-5.0, -1.0, 0.0, 0.5, 1.5, 3.0, 40.0)) | st.floats(-4.0, 4.0)))
        ys = [ys[0]] * len(ys) if flat else ys
        pieces.append([(start + i, y) for i, y in enumerate(ys)])
        start += len(ys) + draw(st.floats(0.1, 2.0))
    return pieces


def dense(points: Points) -> tuple[np.ndarray, np.ndarray]:
    """Points of a line, 400 for each segment."""
    if len(points) == 1:
        ((x, y),) = points
        return np.array([x]), np.array([y])
    xs, ys = map(np.array, zip(*points, strict=True))
    t = np.linspace(0, len(points) - 1, 400 * (len(points) - 1) + 1)
    return np.interp(t, np.arange(len(points)), xs), np.interp(t, np.arange(len(points)), ys)


def is_seen(x: np.ndarray, y: np.ndarray, more: float = ROOM) -> np.ndarray:
    wide, high = more * (X.end - X.start), more * (Y.end - Y.start)
    return (x >= X.start - wide) & (x <= X.end + wide) & (y >= Y.start - high) & (y <= Y.end + high)


def runs(seen: np.ndarray) -> int:
    return int(np.count_nonzero(np.diff(np.concatenate(([False], seen))) & seen))


@settings(max_examples=tries(600), deadline=None)
@given(curves())
def test_a_curve_is_described_by_its_pieces(pieces: list[Points]) -> None:
    told = course(pieces)
    lines = [dense(one) for one in pieces if len(one) == 1 or (one[-1][0] > X.start and one[0][0] < X.end)]
    close = any(np.any(is_seen(*one, 5e-3) & ~is_seen(*one, 0.0)) for one in lines)
    count = sum(runs(is_seen(*one)) for one in lines)
    if count == 0:
        assert told == "x: outside the frame throughout." or close
        return
    assert told != "x: outside the frame throughout."
    if not close:
        counted = re.match(r"x, (\d+) pieces: ", told)
        assert (int(counted[1]) if counted else 1) == count, told
    seen = np.concatenate([y[is_seen(x, y)] for x, y in lines])
    if "throughout" in told:
        inside = np.concatenate([y for x, y in lines if np.any((x >= X.start) & (x <= X.end))])
        assert np.ptp(inside) < 5e-3 * (Y.end - Y.start)
    if count == 1 and not close:
        steps = np.diff(seen)
        assert not told.startswith("x: rises") or np.all(steps >= -1e-9), told
        assert not told.startswith("x: falls") or np.all(steps <= 1e-9), told


def test_lines_through_the_frame_gaps_and_poles_are_described() -> None:
    assert course([[(4.0, -50.0), (4.0, 50.0)]]) == "x: upright at 4 s, from outside the frame to outside the frame."
    assert course([[(-90.0, -20.0), (110.0, 20.0)]]) == "x: rises from −2 m to 0 m."
    assert "lines: lowest" in course([[(0.0, 1.0), (1.0, 1.0)], [(0.0, 0.0), (1.0, 0.5)]], lines=2)
    told = course([[(0.0, 1.0), (4.0, 1.0)], [(6.0, 1.0), (9.0, 1.0)]])
    assert told == "x, 2 pieces: from 0 s to 4 s it stays at 1 m; from 6 s to 9 s it stays at 1 m."
    assert course([[(2.0, 1.0)], [(4.0, 0.5)]]) == "x, 2 pieces: 1 m at 2 s; 0.5 m at 4 s."
    bent = [(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)]
    assert course([bent]) == "x: from 0 m to 0 m, lowest 0 m at 0 s, highest 1 m at 1 s."
    first, second = course([[(0.0, 0.1), (4.9, 9.0)], [(5.1, -9.0), (10.0, -0.1)]]).split("; ")
    assert " it rises from " in first and first.endswith(" to outside the frame")
    assert " it rises from outside the frame to " in second
