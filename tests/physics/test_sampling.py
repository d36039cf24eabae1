"""Time windows, and curves or bands of what a grid can and cannot resolve."""

import math

import numpy as np
import pytest

from physics.sampling import (
    SAMPLES_PER_CYCLE,
    Sinusoid,
    curve_or_band,
    drawable,
    periods,
    time_window,
)

T = np.linspace(0.0, 10.0, 601)


WINDOWS = [(1.0, 2.0, 4), (1.0, 1.5, 4), (1.0, 1.25, 8), (1.0, 1.02, 100), (1.0, 1.0, 100), (1e-200, 2e-200, 4)]


@pytest.mark.parametrize(("slow", "fast", "in_slow_periods"), WINDOWS)
def test_the_window_is_4_slow_or_2_beat_periods(slow, fast, in_slow_periods):
    assert time_window(slow, fast) == pytest.approx(in_slow_periods * 2 * math.pi / slow, rel=1e-12)
    assert time_window(0.0, fast) == periods(fast, 4.0) == pytest.approx(8 * math.pi / fast)
    assert time_window(0.0, 0.0) == 10.0


def test_drawable_means_twelve_samples_a_cycle():
    step = T[1] - T[0]
    assert drawable(2 * math.pi / (SAMPLES_PER_CYCLE * step) * 0.999, T)
    assert not drawable(2 * math.pi / (SAMPLES_PER_CYCLE * step) * 1.001, T)
    assert drawable(0.0, T) and not drawable(1e300, T) and drawable(1e300, T[:1])


def test_slow_components_are_a_curve():
    components = [Sinusoid(1.0, 2.0, 0.3), Sinusoid(-0.5, 3.0, 0.0)]
    base = 0.1 * T
    found = curve_or_band(components, T, base)
    assert np.array_equal(base, 0.1 * T), "an input is not changed"
    assert found.curve is not None
    assert found.curve == pytest.approx(0.1 * T + np.sin(2 * T + 0.3) - 0.5 * np.sin(3 * T), abs=1e-14)
    assert np.array_equal(found.lo, found.curve) and np.array_equal(found.hi, found.curve)
    assert np.array_equal(curve_or_band([], T).lo, np.zeros_like(T))


@pytest.mark.parametrize(
    ("components", "slow", "width"),
    [
        ([Sinusoid(1.0, 1.0, 0.0), Sinusoid(0.5, 1e6, 0.2)], np.sin(T), 0.5),
        ([Sinusoid(1.0, 1e5, 0.0), Sinusoid(-0.5, 1e9, 0.0)], np.zeros_like(T), 1.5),
    ],
)
def test_fast_components_are_a_band_about_the_slow_ones(components, slow, width):
    found = curve_or_band(components, T)
    assert found.curve is None
    assert found.lo == pytest.approx(slow - width, abs=1e-14) and found.hi == pytest.approx(slow + width, abs=1e-14)
