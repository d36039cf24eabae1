"""Oscillators against arbitrary precision over the whole range of doubles; without a spring, and hanging."""

import math
import sys
from fractions import Fraction

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.free_oscillation import FreeOscillation
from physics.hanging import HangingMass
from physics.oscillator import Oscillator
from tests.grids import tries
from tests.physics.chain_families import log_uniform

U = 2.0**-53
TINY = 2.0**-1074
LARGEST = sys.float_info.max
PRECISION = 2600  # bits: omega t may reach 2^2600
FAMILIES = {
    "moderate": st.floats(0.1, 10.0),
    "1e+-8": log_uniform(-27, 27),
    "1e+-150": log_uniform(-498, 498),
    "all doubles": log_uniform(-1074, 1024),
}
each_family = pytest.mark.parametrize("magnitudes", FAMILIES.values(), ids=FAMILIES)
SIGNS = st.lists(st.sampled_from([-1.0, 0.0, 1.0]), min_size=3, max_size=3)


def drawn(data, magnitudes):
    """m, k, x_0, v_0 and t; the last three may be negative or 0."""
    m, k, *sizes = (data.draw(magnitudes) for _ in range(5))
    return m, k, *(sign * size for sign, size in zip(data.draw(SIGNS), sizes, strict=True))


def within(value: float, true: mp.mpf, scale: mp.mpf, rounding_errors: float) -> bool:
    step = TINY if scale < 1e-291 else 0
    return bool(abs(mp.mpf(value) - true) <= rounding_errors * U * scale + step)


@each_family
@settings(max_examples=tries(150))
@given(data=st.data())
def test_motion_stays_within_4_u_of_its_amplitudes(magnitudes, data):
    m, k, x_0, v_0, t = drawn(data, magnitudes)
    with mp.workprec(PRECISION):
        omega = mp.sqrt(mp.mpf(k) / m)
        known = omega * abs(t) < 1e60  # beyond, 80 digits of omega_n leave only the amplitude
        C = mp.hypot(x_0, v_0 / omega)
        sine, cosine = mp.sin(omega * t), mp.cos(omega * t)
        x = x_0 * cosine + v_0 / omega * sine
        true = {"x": x, "v": v_0 * cosine - x_0 * omega * sine, "a": -(omega**2) * x}
        scale = {"x": C, "v": omega * C, "a": omega**2 * C}
        try:
            motion = Oscillator(m=m, k=k).motion(x_0, v_0, [t])
        except ValueError as refusal:
            name = {"displacement": "x", "velocity": "v", "acceleration": "a"}[str(refusal).split()[1]]
            assert (abs(true[name]) if known else scale[name]) >= LARGEST * (1 - 8 * U)
            return
        for name in true:
            aim, errors = (true[name], 4.0) if known else (mp.mpf(0), 2**53 + 4)
            assert within(getattr(motion, name)[0], aim, scale[name], errors), name


@each_family
@settings(max_examples=tries(150))
@given(data=st.data())
def test_frequency_and_constants_are_rounded_once_and_the_phase_within_2_ulp(magnitudes, data):
    m, k, x_0, v_0, _ = drawn(data, magnitudes)
    oscillator = Oscillator(m=m, k=k)
    with mp.workprec(PRECISION):
        omega = mp.sqrt(mp.mpf(k) / m)
        for value, true in ((oscillator.omega_n, omega), (oscillator.period, 2 * mp.pi / omega)):
            beyond = true >= LARGEST * (1 + mp.mpf(U) / 2)
            assert beyond if math.isinf(value) else abs(mp.mpf(value) - true) <= 0.51 * math.ulp(value)
        B = v_0 / omega
        C = mp.hypot(x_0, B)
        try:
            constants = oscillator.constants(x_0, v_0)
        except ValueError as refusal:
            assert "amplitude" in str(refusal)
            assert C > LARGEST
            return
        assert x_0 == constants.A
        assert abs(mp.mpf(constants.B) - B) <= 0.51 * math.ulp(constants.B)
        assert abs(mp.mpf(constants.C) - C) <= 0.51 * math.ulp(constants.C)
        phi = mp.atan2(x_0, B) if C else mp.mpf(0)
        error = abs(mp.mpf(constants.phi) - phi)
        assert min(error, abs(error - 2 * mp.pi)) <= 2 * math.ulp(constants.phi)  # -pi + 1e-300 may round to pi
        assert -math.pi <= constants.phi <= math.pi


def test_without_a_spring_the_mass_drifts():
    free = Oscillator(m=1.0, k=0.0)
    assert (free.omega_n, free.period) == (0.0, math.inf)
    motion = free.motion(1.0, 2.0, [0.0, 0.5, 3.0])
    np.testing.assert_array_equal([motion.x, motion.v, motion.a], [[1.0, 2.0, 7.0], [2.0] * 3, [0.0] * 3])
    c = free.constants(-1.0, 2.0)
    assert (c.A, c.B, c.C, c.phi, c.drift) == (-1.0, 0.0, 1.0, -math.pi / 2, 2.0)


@pytest.mark.parametrize(("x_0", "v_0"), [(0.2, -0.3), (0.2, 0.0), (0.0, 0.4), (-0.1, -0.5)])
def test_the_last_peak(x_0, v_0):
    free = FreeOscillation(oscillator=Oscillator(m=0.7, k=11.0), x_0=x_0, v_0=v_0)
    period = free.oscillator.period
    for end in (0.1 * period, 1.3 * period, 2.9 * period):
        last = free.last_peak(end)
        assert last * period <= end < (last + 1) * period
        assert free.x.at(np.array([last * period]))[0] == pytest.approx(free.constants.C, rel=1e-14)


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
