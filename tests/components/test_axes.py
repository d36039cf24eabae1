"""Axes: the round numbers that are written at them."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from components.quantities.axes import log_axis
from components.quantities.numbers import parse_number


@given(st.floats(-300, 300), st.floats(0.05, 20), st.integers(3, 6))
def test_a_log_axis_has_two_numbers_at_least_each_where_it_says(power: float, span: float, count: int) -> None:
    axis = log_axis(10.0**power, 10.0 ** min(power + span, 307), "s", count)
    labels = [label.removesuffix(" s") for label in axis.ruler.labels]
    assert len(set(labels)) == len(axis.ticks) >= 2
    for label, tick in zip(labels, axis.ticks, strict=True):
        assert math.log10(parse_number(label)) == pytest.approx(tick, abs=0.003)


def test_powers_of_ten_go_before_other_round_numbers() -> None:
    assert log_axis(0.2, 30.0, "s").ruler.labels == ("1", "10¹ s")
    assert log_axis(2.0, 80.0, "s").ruler.labels == ("2", "5", "10", "20", "50 s")
    assert log_axis(3.0, 4.5).ruler.labels == ("3.2", "3.6", "4", "4.4")
