"""Motions as values: exact sums and products, also near the ends of the doubles; means and bands of fast ones."""

from __future__ import annotations

import math

import numpy as np
import pytest

from physics.damped import DampedOscillator
from physics.free_decay import FreeDecay
from physics.motion import Elementary, Harmonic, MotionPolynomial, constant, harmonic_motion, superposed
from physics.precision.exact import Array
from physics.sampling import Sinusoid


def decay(m: float = 1.0, c: float = 0.4, k: float = 4.0, x_0: float = 1.0, v_0: float = 0.0) -> FreeDecay:
    return FreeDecay(oscillator=DampedOscillator(m=m, c=c, k=k), x_0=x_0, v_0=v_0)


@pytest.fixture
def t() -> Array:
    return np.linspace(0.0, 10.0, 101)


def test_sums_products_and_quotients_are_those_of_the_values(t: Array) -> None:
    free = decay()
    x, v = free.x.at(t), free.v.at(t)
    pairs = [
        (free.x + free.v, x + v),
        (2.0 - free.x, 2.0 - x),
        (free.x - 1, x - 1),
        (3.0 * free.x / 4.0, 0.75 * x),
        (-free.v, -v),
        (free.x * free.v, x * v),
        (0.5 * free.x**2 + free.v**2, 0.5 * x**2 + v**2),
        (constant(2.0), np.full_like(t, 2.0)),
    ]
    for motion, values in pairs:
        assert np.array_equal(motion.at(t), values)


@pytest.mark.parametrize(("k", "x_0"), [(1e-300, 1e200), (1e300, 1e-200)])
def test_no_factor_alone_takes_a_product_out_of_range(t: Array, k: float, x_0: float) -> None:
    """The square of the displacement leaves the range of doubles, the energy does not."""
    free = decay(m=k, c=0.0, k=k, x_0=x_0)
    assert (0.5 * k * free.x**2).at(t)[0] == pytest.approx(0.5 * k * x_0 * x_0, rel=1e-12)


def test_a_product_out_of_range_is_infinite(t: Array) -> None:
    assert np.isinf((1e200 * decay(x_0=1e200).x).at(t)[0])


def test_the_mean_of_a_fast_motion_is_that_over_a_cycle() -> None:
    free = decay(m=2.0, c=1e-3, k=50.0, v_0=1.0)
    whole = np.linspace(0.0, 2 * math.pi / free.oscillator.omega_d, 4001)
    for motion in (free.x, 25.0 * free.x**2, free.v**2, 3.0 - free.v**2, 2.0 * (free.x**2 + free.v**2)):
        averaged = np.trapezoid(motion.at(whole), whole) / whole[-1]
        size = np.max(np.abs(motion.at(whole)))
        assert motion.mean.at(whole)[2000] == pytest.approx(averaged, abs=2e-3 * size)


def test_a_fast_motion_stays_within_its_band(t: Array) -> None:
    free = decay(v_0=-2.0)
    assert free.v.band(0.0) is None and (free.x * free.v).band(0.0) is None
    for motion in (free.x, 3.0 - 2.0 * free.x, 4.0 * free.x**2 + 1.0, free.x**2 - 0.5 * free.x):
        low, high = motion.band(0.0) or pytest.fail("it has no band")
        margin = 1e-12 * np.max(np.abs(high.at(t)))
        assert np.all(low.at(t) - margin <= motion.at(t)) and np.all(motion.at(t) <= high.at(t) + margin)


def test_the_slow_part_of_a_band_is_a_line(t: Array) -> None:
    """If x is slow enough for a line and its square is not, the band of their sum follows x."""
    free = decay(v_0=-2.0)
    low, high = (free.x**2 + free.x).band(1.5 * free.oscillator.omega_d) or pytest.fail("it has no band")
    assert np.array_equal(low.at(t), free.x.at(t))
    assert np.all(high.at(t) >= (free.x**2 + free.x).at(t))


def test_a_product_takes_the_place_of_its_name() -> None:
    """A motion that stays whole is one factor; others are multiplied out."""
    free = decay()
    V = 2.0 * free.x**2
    ((factor, motions),) = (3.0 * V).flat()
    assert (factor, motions) == (6, (free.x, free.x))
    ((factor, motions),) = (3.0 * V).flat(whole=lambda motion: motion is V)
    assert (factor, motions) == (3, (V,))
    assert isinstance(V, MotionPolynomial) and V.omega == 2 * free.oscillator.omega_d


def wave(omega: float) -> Elementary:
    return harmonic_motion("x", Harmonic((Sinusoid(1.0, omega, 0.3),)), lambda t: np.sin(omega * t + 0.3))


@pytest.mark.parametrize("omegas", [(1.0, 1000.0), (1000.0, 1001.0), (800.0, 1000.0)])
def test_a_superposition_knows_its_band_and_its_averages(t: Array, omegas: tuple[float, float]) -> None:
    """A slow part moves the band, close frequencies beat, others add up."""
    whole, fine = superposed("x", *map(wave, omegas)), np.linspace(0.0, 10.0, 200_001)
    values, averaged = whole.at(fine), whole * whole
    low, high = (np.interp(fine, t, edge.at(t)) for edge in whole.band(10.0))
    assert np.all(low <= values + 0.02) and np.all(values <= high + 0.02)
    assert values.max() == pytest.approx(high.max(), abs=0.02)
    assert np.trapezoid(averaged.mean.at(t), t) == pytest.approx(np.trapezoid(values**2, fine), rel=0.02)
    assert whole.size() == 2.0 and whole.omega == max(omegas)
