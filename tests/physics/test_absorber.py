"""Damped amplitudes against arbitrary precision, the undamped limit, Den Hartog's book values."""

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.absorber import (
    damped_amplitude,
    damped_solution,
    den_hartog,
    highest_peak,
    swing_and_stroke,
)
from physics.coupled import TwoMassChain
from physics.forced import particular_solution
from physics.reference.single import steady
from tests.grids import tries
from tests.physics.chain_cases import log_uniform
from tests.physics.chain_truth import LARGEST, close, exactly

MACHINE = {"m1": 100.0, "k1": 250e3}
F_0 = 500.0
TUNED = TwoMassChain(**MACHINE, m2=16.0, k2=36864.0)


FAMILIES = {
    "moderate": st.floats(0.1, 10.0),
    "1e+-8": log_uniform(-27, 27),
    "all doubles": log_uniform(-1074, 1024),
}
families = pytest.mark.parametrize("numbers", FAMILIES.values(), ids=FAMILIES)


def truth(chain: TwoMassChain, c: float, F: float, omega: float) -> tuple[mp.mpc, mp.mpc]:
    """The steady amplitudes from Newton's laws as two linear equations."""
    return steady(mp, chain, c, F, omega)


@families
def test_damped_amplitudes_are_rounded_once(numbers):
    @settings(max_examples=tries(80))
    @given(*[numbers] * 7)
    def check(m1, m2, k1, k2, c, F, omega):
        chain = TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2)
        with exactly():
            true = truth(chain, c, F, omega)
            try:
                size, parts = (
                    damped_amplitude(chain, c, F, [omega])[:, 0],
                    damped_solution(chain, c, F, omega),
                )
            except ValueError as refusal:
                assert "leaves the range of doubles" in str(refusal)
                assert max(abs(x) for x in true) > LARGEST
                return
            for i in (0, 1):
                assert close(size[i], abs(true[i]), 0.51)
                assert close(parts[i].real, true[i].real, 0.51)
                assert close(parts[i].imag, true[i].imag, 0.51)

    check()


@families
def test_the_stroke_is_the_distance_between_the_masses(numbers):
    @settings(max_examples=tries(80))
    @given(*[numbers] * 7, st.booleans())
    def check(m1, m2, k1, k2, c, F, omega, damped):
        chain = TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2)
        with exactly():
            one, two = truth(chain, c if damped else 0.0, F, omega)
            try:
                swing, stroke = swing_and_stroke(chain, c if damped else 0.0, F, omega)
            except ValueError as refusal:
                assert "leaves the range of doubles" in str(refusal)
                assert max(abs(one), abs(two), abs(two - one)) > LARGEST / 2
                return
            assert close(swing, abs(one), 0.51)
            assert close(stroke, abs(two - one), 4)

    check()


@pytest.mark.parametrize(("mu", "percent"), [(0.01, 0.0162), (0.16, 0.27), (1.0, 1.3)])
def test_den_hartogs_fixed_points_are_nearly_the_peaks(mu, percent):
    best = den_hartog(1.0, 1.0, mu)
    tuning, damping = math.sqrt(best.k2 / mu), best.c / (2 * mu)
    peak = highest_peak(mu, tuning, damping)
    assert 100 * (peak / best.height - 1) == pytest.approx(percent, rel=0.05)
    omega = np.linspace(0.3, 2.0, 20_001)
    chain = TwoMassChain(m1=1.0, m2=mu, k1=1.0, k2=best.k2)
    seen = damped_amplitude(chain, best.c, 1.0, omega)[0].max()
    assert seen <= peak * (1 + 1e-9) and seen == pytest.approx(peak, rel=1e-6)


def test_peaks_of_other_dampings():
    """Without damping there is no limit. With a nearly rigid link, the peak is that of one heavier mass."""
    assert highest_peak(0.16, 1.0, 0.0) == math.inf
    assert highest_peak(0.16, 1.0, 1e4) > 1e3
    for tuning, damping in ((0.8, 0.05), (1.1, 0.3), (0.86, 0.168)):
        chain = TwoMassChain(m1=1.0, m2=0.16, k1=1.0, k2=0.16 * tuning**2)
        seen = damped_amplitude(chain, 2 * 0.16 * damping, 1.0, np.linspace(0.3, 2.0, 20_001))[0].max()
        assert highest_peak(0.16, tuning, damping) == pytest.approx(seen, rel=1e-5)


def test_damped_amplitudes_next_to_a_resonance():
    """Next to a double at which nothing but the damping holds the motion."""
    chain = TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0)
    near = [math.nextafter(1.0, 2.0), 1.0, math.nextafter(2.0, 1.0), 2.0]
    for c in (1e-3, 1e-12, 1e-300):
        with exactly():
            for omega, column in zip(near, damped_amplitude(chain, c, 1.0, near).T, strict=True):
                for value, true in zip(column, truth(chain, c, 1.0, omega), strict=True):
                    assert close(value, abs(true), 0.51)


@pytest.mark.parametrize("c", [5e-324, 1e-300])
def test_no_seam_between_damped_and_undamped(c):
    omega = np.array([0.0, 30.0, 40.0, 48.5, 59.0, 70.0])
    undamped = [np.abs(particular_solution(TUNED, F_0, w)) for w in omega]
    assert np.array_equal(damped_amplitude(TUNED, c, F_0, omega), np.transpose(undamped))


@pytest.mark.parametrize("k1", [0.0, 250e3])
def test_damper_without_a_spring(k1):
    """N and kappa share a factor omega, which must not become 0/0 at rest."""
    chain = TwoMassChain(m1=100.0, m2=16.0, k1=k1, k2=0.0)
    still, moving = damped_amplitude(chain, 50.0, F_0, [0.0, 40.0]).T
    assert np.array_equal(still, np.full(2, F_0 / k1 if k1 else math.inf))
    with exactly():
        assert all(close(x, abs(true), 0.51) for x, true in zip(moving, truth(chain, 50.0, F_0, 40.0), strict=True))
