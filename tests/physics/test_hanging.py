"""The hanging mass: datum, exchange, and energies without cancellation."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.hanging import HangingMass
from tests.grids import tries

U = 2.0**-53
MASS = HangingMass(m=2.0, k=50.0, g=9.81)
positive = st.builds(math.ldexp, st.floats(0.5, 1.0), st.integers(-60, 60))
signed = st.builds(lambda x, sign: sign * x, positive, st.sampled_from([-1.0, 1.0]))


def test_book_values():
    assert MASS.delta_st == pytest.approx(2 * 9.81 / 50, rel=U)
    assert MASS.omega_n == 5.0
    assert MASS.datum_shift == pytest.approx(50 * MASS.delta_st**2 / 2, rel=4 * U)


def test_gravity_moves_the_equilibrium_and_not_the_frequency():
    moon = HangingMass(m=2.0, k=50.0, g=1.62)
    assert moon.omega_n == MASS.omega_n
    assert moon.delta_st < MASS.delta_st
    t = np.linspace(0, 3, 20)
    np.testing.assert_array_equal(moon.motion(0.1, 0.0, t).x, MASS.motion(0.1, 0.0, t).x)
    weightless = HangingMass(m=2.0, k=50.0, g=0.0)
    assert (weightless.delta_st, weightless.datum_shift) == (0.0, 0.0)


@settings(max_examples=tries(300))
@given(m=positive, k=positive, g=positive, x=signed, v=signed)
def test_energies_against_rational_arithmetic(m, k, g, x, v):
    M, K, W, X, V = (Fraction(value) for value in (m, k, Fraction(m) * Fraction(g), x, v))
    true = {
        "T": M * V**2 / 2,
        "V": K * X**2 / 2,
        "spring": K * (X + W / K) ** 2 / 2,
        "gravity": -W * X,
    }
    mass = HangingMass(m=m, k=k, g=g)
    energies = mass.energies([x], [v])
    for name, value in true.items():
        error = abs(Fraction(float(getattr(energies, name)[0])) - value)
        assert error <= 4 * Fraction(U) * abs(value), name
    separate = mass.energies([x], [v], "separate")
    assert separate.V[0] == pytest.approx(float(true["spring"] + true["gravity"]), rel=4 * U)


@settings(max_examples=tries(100))
@given(m=positive, k=positive, g=positive)
def test_the_spring_is_relaxed_at_its_natural_length(m, k, g):
    """At x = -delta_st what is left is the rounding of x itself."""
    mass = HangingMass(m=m, k=k, g=g)
    spring = mass.energies([-mass.delta_st], [0.0]).spring[0]
    rest = Fraction(m) * Fraction(g) / Fraction(k) - Fraction(mass.delta_st)
    assert spring == pytest.approx(float(Fraction(k) * rest**2 / 2), rel=1e-14)


@pytest.mark.parametrize("periods", [1.0, 1e6])
def test_total_energy_is_constant_within_8_u(periods):
    tau = 2 * math.pi / MASS.omega_n
    t = np.random.default_rng(3).uniform(periods - 1, periods, 2000) * tau
    motion = MASS.motion(0.13, -0.4, t)
    total = MASS.energies(motion.x, motion.v).total
    assert np.max(np.abs(total / MASS.total_energy(0.13, -0.4) - 1)) <= 8 * U


def test_the_two_datums_differ_by_a_constant_and_only_one_has_equal_maxima():
    t = np.linspace(0, 2 * math.pi / MASS.omega_n, 401)
    motion = MASS.motion(0.1, 0.0, t)
    equilibrium, separate = (MASS.energies(motion.x, motion.v, datum) for datum in ("equilibrium", "separate"))
    np.testing.assert_allclose(separate.V - equilibrium.V, MASS.datum_shift, rtol=1e-14)
    assert np.max(equilibrium.V) == pytest.approx(np.max(equilibrium.T), rel=1e-14)
    assert np.max(separate.V) - np.max(separate.T) == pytest.approx(MASS.datum_shift, rel=1e-13)


def test_exchange_runs_at_twice_the_frequency():
    t = np.linspace(0, 2, 50)
    motion = MASS.motion(0.1, 0.0, t)
    energies = MASS.energies(motion.x, motion.v)
    swing = MASS.total_energy(0.1, 0.0) / 2
    np.testing.assert_allclose(energies.V, swing * (1 + np.cos(2 * MASS.omega_n * t)), atol=1e-15)


def test_the_well_meets_the_energy_at_the_turning_points():
    C = MASS.oscillator.constants(0.1, 0.3).C
    np.testing.assert_allclose(MASS.well([-C, C]), MASS.total_energy(0.1, 0.3), rtol=4 * U)
    np.testing.assert_allclose(MASS.well([0.0], "separate"), MASS.datum_shift)


@pytest.mark.parametrize(("name", "value"), [("m", 0.0), ("k", 0.0), ("k", math.inf), ("g", -9.81), ("g", math.nan)])
def test_bad_parameters_are_refused(name, value):
    with pytest.raises(ValueError, match=f"{name} = {value!r}"):
        HangingMass(**{"m": 1.0, "k": 1.0, "g": 9.81, name: value})


def test_what_leaves_the_range_of_doubles_is_named():
    with pytest.raises(ValueError, match="static deflection"):
        _ = HangingMass(m=1e300, k=1e-300, g=9.81).delta_st
    with pytest.raises(ValueError, match="T leaves the range"):
        _ = MASS.energies([0.0], [1e200]).T
    with pytest.raises(ValueError, match="of the spring leaves the range"):
        _ = MASS.energies([1e200], [0.0]).spring
    with pytest.raises(ValueError, match="the weight m g = "):
        _ = HangingMass(m=1e200, k=1.0, g=1e200).energies([0.0], [0.0]).gravity
