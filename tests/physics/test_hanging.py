"""The hanging mass: datum, exchange, and energies without cancellation."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.free_oscillation import FreeOscillation
from physics.hanging import HangingMass
from tests.grids import tries

U = 2.0**-53
MASS = HangingMass(m=2.0, k=50.0, g=9.81)
positive = st.builds(math.ldexp, st.floats(0.5, 1.0), st.integers(-60, 60))
signed = st.builds(lambda x, sign: sign * x, positive, st.sampled_from([-1.0, 1.0]))


@settings(max_examples=tries(300))
@given(m=positive, k=positive, g=positive, x=signed)
def test_energies_against_rational_arithmetic(m, k, g, x):
    K, W, X = (Fraction(value) for value in (k, Fraction(m) * Fraction(g), x))
    mass = HangingMass(m=m, k=k, g=g)
    true = {mass.well: K * X**2 / 2, mass.spring: K * (X + W / K) ** 2 / 2, mass.gravity: -W * X}
    for energy, value in true.items():
        assert abs(Fraction(float(energy([x])[0])) - value) <= 4 * Fraction(U) * abs(value), energy
    assert mass.well([x], "separate")[0] == pytest.approx(float(true[mass.spring] + true[mass.gravity]), rel=4 * U)
    relaxed = Fraction(m) * Fraction(g) / Fraction(k) - Fraction(mass.delta_st)  # what is left is the rounding of x
    assert mass.spring([-mass.delta_st])[0] == pytest.approx(float(K * relaxed**2 / 2), rel=1e-14)


def test_the_spring_along_a_motion_is_that_of_each_place():
    t = np.linspace(0, 4, 300)
    x = FreeOscillation(oscillator=MASS.oscillator, x_0=-MASS.delta_st, v_0=0.0).x
    along = MASS.spring_along(x)
    np.testing.assert_array_equal(along.at(t), MASS.spring(x.at(t)))
    low, high = along.band(0.0)
    assert np.all(low.at(t) <= along.at(t)) and np.all(along.at(t) <= high.at(t) * (1 + U))
    np.testing.assert_allclose(high.at(t), MASS.spring([MASS.delta_st])[0], rtol=1e-14)


@pytest.mark.parametrize("periods", [1.0, 1e6])
def test_total_energy_is_constant_within_8_u(periods):
    tau = 2 * math.pi / MASS.omega_n
    t = np.random.default_rng(3).uniform(periods - 1, periods, 2000) * tau
    free = FreeOscillation(oscillator=MASS.oscillator, x_0=0.13, v_0=-0.4)
    total = (0.5 * MASS.m * free.v**2).at(t) + MASS.well(free.x.at(t))
    assert np.max(np.abs(total / free.E - 1)) <= 8 * U
