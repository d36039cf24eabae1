"""Oscillator against arbitrary precision over the whole range of doubles, and against book values."""

import math
import sys

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.oscillator import Oscillator
from tests.grids import tries
from tests.physics.chain_cases import log_uniform

U = 2.0**-53
TINY = 2.0**-1074
LARGEST = sys.float_info.max
PRECISION = 2600  # bits: omega t may reach 2^2600


def signed(magnitudes: st.SearchStrategy[float]) -> st.SearchStrategy[float]:
    return st.builds(lambda x, sign: sign * x, magnitudes, st.sampled_from([-1.0, 0.0, 1.0]))


FAMILIES = {
    "moderate": st.floats(0.1, 10.0),
    "1e+-8": log_uniform(-27, 27),
    "1e+-150": log_uniform(-498, 498),
    "all doubles": log_uniform(-1074, 1024),
}
families = pytest.mark.parametrize("magnitudes", FAMILIES.values(), ids=FAMILIES)


def ulp(x: float) -> float:
    return math.ulp(x) if math.isfinite(x) else math.ulp(LARGEST)


def within(value: float, true: mp.mpf, scale: mp.mpf, rounding_errors: float) -> bool:
    step = TINY if scale < 1e-291 else 0
    return bool(abs(mp.mpf(value) - true) <= rounding_errors * U * scale + step)


@families
def test_motion_stays_within_4_u_of_its_amplitudes(magnitudes):
    @settings(max_examples=tries(150))
    @given(m=magnitudes, k=magnitudes, x_0=signed(magnitudes), v_0=signed(magnitudes), t=signed(magnitudes))
    def check(m, k, x_0, v_0, t):
        with mp.workprec(PRECISION):
            omega = mp.sqrt(mp.mpf(k) / m)
            C = mp.hypot(x_0, v_0 / omega)
            sine, cosine = mp.sin(omega * t), mp.cos(omega * t)
            x = x_0 * cosine + v_0 / omega * sine
            true = {"x": x, "v": v_0 * cosine - x_0 * omega * sine, "a": -(omega**2) * x}
            scale = {"x": C, "v": omega * C, "a": omega**2 * C}
            try:
                motion = Oscillator(m=m, k=k).motion(x_0, v_0, [t])
            except ValueError as refusal:
                name = {"displacement": "x", "velocity": "v", "acceleration": "a"}[str(refusal).split()[1]]
                known = omega * abs(t) < 1e60
                assert (abs(true[name]) if known else scale[name]) >= LARGEST * (1 - 8 * U)
                return
            known = omega * abs(t) < 1e60  # beyond, 80 digits of omega_n leave only the amplitude
            for name in true:
                aim, errors = (true[name], 4.0) if known else (mp.mpf(0), 2**53 + 4)
                assert within(getattr(motion, name)[0], aim, scale[name], errors), name

    check()


@families
def test_frequency_and_constants_are_rounded_once_and_the_phase_within_2_ulp(magnitudes):
    @settings(max_examples=tries(150))
    @given(m=magnitudes, k=magnitudes, x_0=signed(magnitudes), v_0=signed(magnitudes))
    def check(m, k, x_0, v_0):
        oscillator = Oscillator(m=m, k=k)
        with mp.workprec(PRECISION):
            omega = mp.sqrt(mp.mpf(k) / m)
            for value, true in ((oscillator.omega_n, omega), (oscillator.period, 2 * mp.pi / omega)):
                beyond = true >= LARGEST * (1 + mp.mpf(U) / 2)
                assert beyond if math.isinf(value) else abs(mp.mpf(value) - true) <= 0.51 * ulp(value)
            B = v_0 / omega
            C = mp.hypot(x_0, B)
            try:
                constants = oscillator.constants(x_0, v_0)
            except ValueError as refusal:
                assert "amplitude" in str(refusal)
                assert C > LARGEST
                return
            assert x_0 == constants.A
            assert abs(mp.mpf(constants.B) - B) <= 0.51 * ulp(constants.B)
            assert abs(mp.mpf(constants.C) - C) <= 0.51 * ulp(constants.C)
            phi = mp.atan2(x_0, B) if C else mp.mpf(0)
            error = abs(mp.mpf(constants.phi) - phi)
            assert min(error, abs(error - 2 * mp.pi)) <= 2 * ulp(constants.phi)  # -pi + 1e-300 may round to pi
            assert -math.pi <= constants.phi <= math.pi

    check()


def test_without_a_spring_the_mass_drifts():
    free = Oscillator(m=1.0, k=0.0)
    assert (free.omega_n, free.period) == (0.0, math.inf)
    motion = free.motion(1.0, 2.0, [0.0, 0.5, 3.0])
    np.testing.assert_array_equal(motion.x, [1.0, 2.0, 7.0])
    np.testing.assert_array_equal(motion.v, [2.0, 2.0, 2.0])
    np.testing.assert_array_equal(motion.a, [0.0, 0.0, 0.0])
    c = free.constants(-1.0, 2.0)
    assert (c.A, c.B, c.C, c.phi, c.drift) == (-1.0, 0.0, 1.0, -math.pi / 2, 2.0)


def test_terms_that_overflow_may_have_a_sum_that_does_not():
    """At a zero of x both terms of a are 7e309 and cancel."""
    x_0, v_0, t = 1e300, 1e305, 0.75e-5 * math.pi
    motion = Oscillator(m=1.0, k=1e10).motion(x_0, v_0, [t])
    with mp.workdps(40):
        omega = mp.mpf(10) ** 5
        true = -(omega**2) * x_0 * mp.cos(omega * t) - omega * v_0 * mp.sin(omega * t)
        assert abs(mp.mpf(motion.a[0]) - true) <= 4 * U * omega**2 * mp.hypot(x_0, v_0 / omega)


@pytest.mark.parametrize(
    ("m", "k", "start", "t"), [(1e-300, 1e300, (1e-200, 0.0), 0.0), (2.0**-54, 1.5 * 2.0**1023, (-0.5, -8e146), -0.5)]
)
def test_what_leaves_the_range_of_doubles_is_named(m, k, start, t):
    with pytest.raises(ValueError, match="acceleration leaves the range of doubles"):
        Oscillator(m=m, k=k).motion(*start, [t])
