"""Amplitudes of exponentials, from means of neighbouring rows."""

from __future__ import annotations

import cmath

import numpy as np
import pytest

from physics.means import before_means


@pytest.mark.parametrize("size", [1, 2, 10])
@pytest.mark.parametrize("exponent", [complex(-0.1, 6.3), complex(0.02, 40.0), 0j])
def test_an_amplitude_comes_back_from_means(size: int, exponent: complex) -> None:
    step, amplitude = 0.01, 0.3 - 0.2j
    t = step * np.arange(40 * size)
    means = (amplitude * np.exp(exponent * t)).reshape(-1, size).mean(axis=1)
    middle = t.reshape(-1, size).mean(axis=1)
    seen = means[7] / cmath.exp(exponent * middle[7])
    assert before_means(complex(seen), exponent, step, size) == pytest.approx(amplitude, rel=1e-12)
