"""Modes and free motion of the chain: reference cases, families of chains, limits, independent solvers."""

import math
import sys

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.coupled import TwoMassChain, free_modes, free_motion
from physics.energy import chain_energy
from physics.precision.exact import sin_cos
from tests.grids import tries
from tests.physics.chain_cases import chain_with, each_family
from tests.physics.chain_families import drawn
from tests.physics.chain_truth import WORKING_BITS, Truth, U, ulps, worst

LARGEST = mp.mpf(sys.float_info.max)
thorough = settings(max_examples=tries(40))


@pytest.fixture(autouse=True)
def many_digits():
    with mp.workprec(WORKING_BITS):
        yield


@each_family
def test_modes_are_rounded_once(family):
    @thorough
    @given(drawn(family))
    def check(parameters):
        modes, true = chain_with(parameters).modes(), Truth(*parameters)
        found = [*modes.omega, *modes.ratio, modes.beat]
        for value, exactly in zip(found, [*true.omega, *true.ratio, true.beat], strict=True):
            assert ulps(value, exactly) <= 0.51 or (abs(exactly) > LARGEST and math.isinf(value))
        for hi, lo, exactly in zip(modes.omega, modes.omega_lo, true.omega, strict=True):
            if mp.mpf("1e-290") < exactly < LARGEST:
                assert abs(mp.mpf(hi) + mp.mpf(lo) - exactly) <= exactly * mp.mpf(2) ** -105

    check()


@st.composite
def starts_and_times(draw):
    """x_0 in m, v_0 in m times the slow frequency, times in slow periods and in fast ones (as exponents)."""
    amount = st.floats(-1.0, 1.0)
    x_0 = draw(st.one_of(st.just((0.0, 0.0)), st.just((1.0, 1.0)), st.tuples(amount, amount)))
    return x_0, draw(st.tuples(amount, amount)), draw(st.floats(-6.0, 12.0)), draw(st.floats(-6.0, 14.0))


@each_family
def test_free_motion_is_within_4_u(family):
    @thorough
    @given(drawn(family), starts_and_times())
    def check(parameters, start):
        true = Truth(*parameters)
        x_0, v_0, slow_periods, fast_periods = start
        slow, fast = true.omega[0] or true.omega[1] or mp.mpf(1), true.omega[1] or mp.mpf(1)
        times = [mp.mpf(10) ** slow_periods / slow, mp.mpf(10) ** fast_periods / fast]
        t = [0.0, *(float(s) for s in times if s < LARGEST and fast * s < 1e15)]
        if max(abs(mp.mpf(v)) for v in v_0) * slow > LARGEST:
            return
        v_0 = tuple(float(v * slow) for v in v_0)
        expected = [true.free(x_0, v_0, s) for s in t]
        if max(abs(value) for values, _ in expected for value in values) > LARGEST:
            with pytest.raises(ValueError, match="leaves the range of doubles"):
                free_motion(chain_with(parameters), x_0, v_0, t)
            return
        motion = free_motion(chain_with(parameters), x_0, v_0, t)
        for n, (values, scales) in enumerate(expected):
            assert worst(motion, n, values, scales) <= 4

    check()


@each_family
def test_amplitudes_and_phases_give_the_motion(family):
    @thorough
    @given(drawn(family), st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))
    def check(parameters, x1_0, v2_0):
        chain = chain_with(parameters)
        fast = chain.modes().omega[1] or 1.0
        if not 1e-100 < fast < 1e100 or not abs(chain.modes().ratio[1]) < 1e100:
            return
        x_0, v_0, t = (x1_0, 0.5), (0.0, v2_0 * fast), np.array([0.0, 0.1, 1.7]) / fast
        modes, motion = free_modes(chain, x_0, v_0), free_motion(chain, x_0, v_0, t)
        phases = zip(modes.omega, modes.omega_lo, modes.phase, strict=True)
        sines = [sin_cos(hi, lo, t, phase)[0] for hi, lo, phase in phases]
        x = modes.amplitude.T @ sines + np.array([modes.drift_a + modes.drift_b * s for s in t]).T
        scale = np.sum(np.abs(modes.amplitude), axis=0) + np.abs(modes.drift_a)
        scale = scale[:, np.newaxis] + np.abs(np.outer(modes.drift_b, t))
        assert np.all(np.abs(x - motion.x) <= 16 * U * scale)
        slow, fast = modes.parts(t)
        assert np.all(np.abs((slow + fast).x - motion.x) <= 4 * U * scale)
        assert np.all(np.abs((slow + fast).v - motion.v) <= 4 * U * (np.abs(slow.v) + np.abs(fast.v)).max())
        assert np.all(modes.amplitude[:, 0] >= 0) and np.all((-np.pi < modes.phase) & (modes.phase <= np.pi))

    check()


def test_phases_beyond_reach_stay_on_the_orbit():
    chain = TwoMassChain(m1=1e-300, m2=1e-300, k1=1e-300, k2=1e300)
    motion = free_motion(chain, (1e-9, -1e-9), (0.0, 0.0), np.linspace(0.0, 1e300, 7))
    assert np.max(np.abs(motion.x)) <= 1e-9 * (1 + 1e-15)
    total = chain_energy(chain, motion).total
    assert total == pytest.approx(total[0], rel=1e-14)


def test_times_of_any_kind():
    chain = TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0)
    assert free_motion(chain, (1, 0), (0, 0), []).x.shape == (2, 0)
    forward, backward = (free_motion(chain, (1, 0), (0, 0), [s]).x for s in (1.3, -1.3))
    assert np.array_equal(forward, backward)


def test_a_result_out_of_range_is_named():
    chain = TwoMassChain(m1=1e-300, m2=1.0, k1=1e300, k2=1.0)
    with pytest.raises(ValueError, match="v1 leaves the range of doubles"):
        free_motion(chain, (1e20, 0.0), (0.0, 0.0), [1e-300])
    with pytest.raises(ValueError, match="energy of a mode"):
        free_modes(chain, (1e20, 0.0), (0.0, 0.0)).energy  # noqa: B018
