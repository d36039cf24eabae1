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
    root_mean_square,
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


def test_fast_beats_keep_their_shape():
    """The band touches what a fine grid finds as the extremes of each short stretch of time."""
    components = [Sinusoid(1.0, 1000.0, 0.0), Sinusoid(0.6, 1002.0, 1.0)]
    found = curve_or_band(components, T)
    fine = np.linspace(0.0, 10.0, 600 * 400 + 1)
    x = sum(a * np.sin(w * fine + phase) for a, w, phase in components)
    middles = x[200:-201].reshape(599, 400)
    assert np.all(found.hi <= 1.6 + 1e-12) and np.min(found.hi) < 0.45
    assert np.max(middles, axis=1) == pytest.approx(found.hi[1:-1], abs=0.03)
    assert np.min(middles, axis=1) == pytest.approx(found.lo[1:-1], abs=0.03)


def test_mean_squares_average_the_fast_part_only():
    carrier = 2 * math.pi * 4 * 60  # four cycles from one sample to the next
    slow, fast = Sinusoid(2.0, 1.0, 0.0), [Sinusoid(1.0, carrier, 0.0), Sinusoid(0.6, carrier + 2.0, 1.0)]
    found = root_mean_square([slow, *fast], T) ** 2
    fine = np.linspace(0.0, 10.0, 600 * 400 + 1)
    x = 2 * np.sin(fine) + sum(a * np.sin(w * fine + phase) for a, w, phase in fast)
    means = np.mean((x**2)[200:-201].reshape(599, 400), axis=1)
    assert means == pytest.approx(found[1:-1], abs=0.02)
    assert np.mean(means) == pytest.approx(np.mean(found[1:-1]), rel=1e-3)
    assert root_mean_square([slow], T, 0.5 * T) == pytest.approx(np.abs(2 * np.sin(T) + 0.5 * T), abs=1e-14)
    huge = root_mean_square([Sinusoid(1e200, 1e9, 0.0)], T)
    assert huge == pytest.approx(np.full_like(T, 1e200 / math.sqrt(2.0)))
    assert not np.any(root_mean_square([], T))
