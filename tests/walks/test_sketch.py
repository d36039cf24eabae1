"""Features found in drawn curves: right, nearly right, wrong and absurd ones."""

from __future__ import annotations

import math
from typing import Any

import msgspec
import numpy as np
import pytest

from components.quantities.axes import Axis
from components.walks.features import Feature, Seen
from components.walks.sketch import Ranges, Sketch, sketch, turns
from components.walks.subject import PlotAxes

FRAME = Ranges((0.0, 2.0), (-0.2, 0.2))
T = np.linspace(0, 2, 101)
SWING = -0.16 * np.sin(2 * np.pi * T)
"""Down at first, a trough at 0.25, a zero at 0.5, a peak at 0.75; period 1."""


def feature(**fields: Any) -> Feature:
    return msgspec.convert(fields, Feature)


def drawn(y: Any, x: Any = T, frame: Ranges = FRAME) -> Sketch:
    return sketch(np.column_stack((x, y)), frame)


TROUGH = feature(f="trough", at=0.25, tol=0.06, **{"is": -0.16}, tol_y=0.03)
PEAK = feature(f="peak", at=0.75, tol=0.06, **{"is": 0.16}, tol_y=0.03)
ZERO = feature(f="zero", at=0.5, tol=0.06)
DOWN = feature(f="slope", at=0.0, **{"is": "down"})
PERIOD = feature(f="period", **{"is": 1.0}, tol=0.1)


ANGULAR = -0.15 * np.interp((T - 0.02) % 1, [0, 0.25, 0.75, 1], [0, 1, -1, 0])
ANGULAR += np.random.default_rng(1).uniform(-0.004, 0.004, len(T))
"""By a trembling, rather angular hand, a little late and a little low."""
FIRST, NONE = T <= 0.6, [False] * 5


@pytest.mark.parametrize(
    ("y", "x", "expected"),
    [
        (SWING, T, [True] * 5),
        (SWING[::-1], T[::-1], [True] * 5),
        (ANGULAR, T, [True] * 5),
        (SWING[FIRST], T[FIRST], [True, False, True, True, False]),  # the rest is not made up
        (-SWING, T, [False, False, True, False, True]),  # upside down
        (np.abs(SWING), T, [False, True, False, False, False]),  # never below zero
        (0 * T, T, NONE),
        (0.19 * np.sin(2 * np.pi * 14 * T), T, [False, False, True, False, False]),  # a scribble
        ([], [], NONE),
        ([1.0], [np.nan], NONE),
    ],
)
def test_a_sketch_has_its_features_in_any_style(y: Any, x: Any, expected: list[bool]) -> None:
    assert [one.seen(drawn(y, x)).has for one in (TROUGH, PEAK, ZERO, DOWN, PERIOD)] == expected


def test_a_feature_is_found_at_its_place_and_no_gap_or_edge_is_one() -> None:
    found = TROUGH.seen(drawn(SWING))
    assert (found.x, found.y) == pytest.approx((0.25, -0.16), abs=0.02)
    assert [one.seen(drawn(SWING)).number for one in (PERIOD, ZERO)] == pytest.approx([1.0, 0.5], abs=1e-3)
    gap = (T < 0.3) | (T > 0.9)
    across = drawn(SWING[gap], T[gap])
    assert across.at(0.6) is None and across.at(0.2) is not None
    assert across.at(2.04) == pytest.approx(SWING[-1])  # a hand that stops at the edge
    edge = feature(f="peak", at=0.0, tol=0.1, **{"is": 0.16}, tol_y=0.03)
    assert not edge.seen(drawn(0.16 - 0.1 * T)).has
    t = np.linspace(0, 1, 20)
    assert turns(t, np.zeros(20)) == turns(t, t) == turns(t, np.exp(-t)) == []


def test_reach_least_and_sum_are_of_most_of_a_curve() -> None:
    part = T < 1.0
    reach = feature(f="reach", **{"from": 0.5, "to": 1.9, "is": 0.16}, tol=0.02)
    least = feature(f="least", **{"is": -0.16}, tol=0.01)
    for one in (reach, least):
        found = [one.seen(drawn(y, x)).has for y, x in ((SWING, T), (SWING / 2, T), (SWING[part], T[part]))]
        assert found == [True, False, False]
    both = feature(f="sum", **{"with": "V", "is": 0.0}, tol=0.02)
    for other, expected in ((-SWING, True), (SWING, False)):
        assert both.seen(Sketch(T, SWING, FRAME, drawn(other))).has is expected
    assert not both.seen(drawn(SWING)).has


@pytest.mark.parametrize("away", [0.35, 9.0])
def test_a_pole_leaves_the_frame_there_and_comes_back(away: float) -> None:
    """A curve that is out over a wide range, or everywhere, has no pole."""
    w, frame = np.linspace(0.01, 2.5, 250), Ranges((0.0, 2.5), (0.0, 5.0))
    pole = feature(f="pole", at=0.618, tol=0.07)
    assert pole.seen(drawn(1 / np.abs(w - 0.6183), w, frame)).has
    assert not pole.seen(drawn(np.where(np.abs(w - 0.65) < away, 5.0, 1.0), w, frame)).has


AXES = PlotAxes(Axis(0.0, 2.0, unit="ms", factor=1e-3), Axis(-0.2, 0.2, unit="cm", factor=0.01))


def test_a_feature_is_given_by_expressions_of_the_scenes_numbers() -> None:
    """In SI units, whatever the unit of the axis. A sketch that is right for one chain is wrong for another."""
    numbers = {"tau": 1.0, "X": 0.16}
    told = feature(f="trough", at="tau / 4", tol="0.06 * tau", **{"is": "-X"}, tol_y=3.0).worked_out(numbers, AXES)
    assert (told.at, told.tol, told.value, told.tol_y) == pytest.approx((250.0, 60.0, -16.0, 3.0))
    wide = Ranges((0.0, 2000.0), (-20.0, 20.0))
    assert told.seen(drawn(100 * SWING, 1000 * T, wide)).has
    assert not told.seen(drawn(100 * SWING, 500 * T, wide)).has
    period = feature(f="period", **{"is": "tau"}, tol=1.0).worked_out(numbers, AXES)
    assert period.measured(Seen(True, 1000.0), AXES, 3).startswith("1000")
    assert TROUGH.worked_out(numbers, AXES) is TROUGH
    for text, says in (("tua", "does not have, tua"), ("tau +", "is not an expression"), ("-tau", "> 0")):
        with pytest.raises(ValueError, match=says):
            feature(f="zero", at=0.5, tol=text).worked_out(numbers, AXES)


@pytest.mark.parametrize("phase", [0.3, 1.0, 2.0, math.pi - 0.1])
def test_a_curve_turns_where_its_motion_does(phase: float) -> None:
    t = np.arange(150) * 2 * math.pi / 32
    places = math.pi * np.arange(1, 12) - math.atan(0.05) - phase
    inside = places[(t[2] < places) & (places < t[-3])]
    found = [(x, y) for x, y in turns(t, np.exp(-0.05 * t) * np.cos(t + phase)) if t[2] < x < t[-3]]
    assert [x for x, _ in found] == pytest.approx(inside, abs=1e-6)
    assert [y for _, y in found] == pytest.approx(np.exp(-0.05 * inside) * np.cos(inside + phase), abs=1e-7)
