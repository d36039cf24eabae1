"""A free oscillation as motions: their values, their sizes, what the browser plays, peaks and energy."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

from physics.free_oscillation import FreeOscillation
from physics.oscillator import Oscillator

T = np.linspace(0.0, 3.0, 301)


def released(m: float = 0.7, k: float = 11.0, x_0: float = 0.2, v_0: float = -0.3) -> FreeOscillation:
    return FreeOscillation(oscillator=Oscillator(m=m, k=k), x_0=x_0, v_0=v_0)


def test_the_energy_is_constant_over_the_motion() -> None:
    free = released(m=3.0, k=7.0)
    total = 1.5 * free.v**2 + 3.5 * free.x**2
    np.testing.assert_allclose(total.at(T), free.E, rtol=1e-15 * 8)
    with mp.workdps(30):
        assert float(1.5 * mp.mpf(-0.3) ** 2 + 3.5 * mp.mpf(0.2) ** 2) == free.E


@pytest.mark.parametrize(("x_0", "v_0"), [(0.2, -0.3), (0.2, 0.0), (0.0, 0.4), (-0.1, -0.5)])
def test_the_last_peak(x_0: float, v_0: float) -> None:
    free = released(x_0=x_0, v_0=v_0)
    period = free.oscillator.period
    for end in (0.1 * period, 1.3 * period, 2.9 * period):
        last = free.last_peak(end)
        assert last * period <= end < (last + 1) * period
        assert free.x.at(np.array([last * period]))[0] == pytest.approx(free.constants.C, rel=1e-14)


def test_what_leaves_the_doubles_is_refused() -> None:
    with pytest.raises(ValueError, match=r"the largest acceleration = .* leaves the range of doubles"):
        _ = released(m=1e-300, k=1e10).amplitude(2)
    assert math.isfinite(released(m=1e-100, k=1e100).amplitude(2))
