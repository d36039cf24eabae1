"""Axes: the round numbers that are written at them."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from components.quantities.axes import Axis, log_axis
from components.quantities.formatting import parse_number


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


@pytest.mark.parametrize("size", [0.0, 5e-324, 1e-300, 1e-9, 2.5e-3, 1.0, 40.0, 1e300])
@pytest.mark.parametrize("exponent", [-3, 0, 3])
def test_a_moving_number_has_three_digits_and_no_more_decimals_than_can_be_shown(size: float, exponent: int) -> None:
    decimals = Axis(0.0, 1.0, "J", exponent, own=(0.0, size)).digits().decimals
    shown = size / 10.0**exponent
    assert decimals == (12 if shown < 1e-10 else max(0, 2 - math.floor(math.log10(shown) + 1e-12)))
