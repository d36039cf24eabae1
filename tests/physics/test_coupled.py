"""Modes and free motion of the chain: reference cases, families of chains, limits, independent solvers."""

import math
import sys

import mpmath as mp
import numpy as np
import pytest
import scipy.linalg
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.coupled import TwoMassChain, free_modes, free_motion
from physics.energy import chain_energy
from physics.precision.exact import sin_cos
from tests.grids import tries
from tests.physics.chain_cases import chain_of, chain_with, each_case, each_family
from tests.physics.chain_families import drawn
from tests.physics.chain_truth import WORKING_BITS, Truth, U, ulps, units, worst

LARGEST = mp.mpf(sys.float_info.max)
thorough = settings(max_examples=tries(40))


@pytest.fixture(autouse=True)
def many_digits():
    with mp.workprec(WORKING_BITS):
        yield


@each_case
def test_reference_modes(case):
    modes = chain_of(case).modes()
    for value, key in (
        (modes.omega[0], "w_minus"),
        (modes.omega[1], "w_plus"),
        (modes.ratio[0], "r_minus"),
        (modes.ratio[1], "r_plus"),
        (modes.beat, "beat_w_plus_minus_w_minus"),
    ):
        true = mp.mpf(case[key])
        assert ulps(value, true) <= 0.51 or (abs(true) > LARGEST and math.isinf(value))


@each_case
def test_reference_free_motion(case):
    free = case["free"]
    motion = free_motion(chain_of(case), free["x0"], free["v0"], free["t"])
    for i in (0, 1):
        scale = mp.mpf(free["amplitude_scale"][i])
        for value, true in zip(motion.x[i], free[f"x{i + 1}"], strict=True):
            assert units(value, mp.mpf(true), scale) <= 4


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


def test_the_numbers_of_the_lecture():
    chain = TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0)
    modes = chain.modes()
    assert modes.omega.tolist() == [1.0, 2.0] and modes.ratio.tolist() == [2.0, -1.0]
    assert (modes.beat, modes.gamma, modes.delta) == (1.0, -0.5, 1.5)
    assert modes.omega_lo.tolist() == [0.0, 0.0]
    free = free_modes(chain, (1.0, 0.0), (0.0, 0.0))
    assert free.energy.tolist() == [1 / 3, 8 / 3]
    assert free.amplitude.tolist() == [[1 / 3, 2 / 3], [2 / 3, -2 / 3]]
    assert free.phase.tolist() == [math.pi / 2, math.pi / 2]


def test_the_figure_of_the_lecture_has_the_golden_ratio():
    omega = TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=1.0).modes().omega
    assert omega.tolist() == [0.6180339887498949, 1.618033988749895]


def test_beats_with_complete_exchange():
    chain = TwoMassChain(m1=1.0, m2=0.04, k1=0.96, k2=0.04)
    modes = chain.modes()
    assert modes.omega**2 == pytest.approx([0.8, 1.2], rel=1e-15)
    t = np.linspace(0.0, 4 * np.pi / modes.beat, 2001)
    x = free_motion(chain, (1.0, 0.0), (0.0, 0.0), t).x
    assert np.max(np.abs(x[1])) == pytest.approx(5.0, rel=1e-2)
    half_a_beat = np.abs(t - np.pi / modes.beat) < 0.1
    assert np.max(np.abs(x[0][half_a_beat])) < 0.03


def test_without_a_wall_the_pair_drifts():
    chain = TwoMassChain(m1=2.0, m2=1.0, k1=0.0, k2=3.0)
    modes = chain.modes()
    assert modes.omega[0] == 0.0 and modes.ratio.tolist() == [1.0, -2.0]
    assert modes.omega[1] == math.sqrt(4.5)
    free = free_modes(chain, (1.0, 0.0), (0.0, 3.0))
    assert free.amplitude[0].tolist() == [0.0, 0.0] and free.phase[0] == 0.0
    assert free.drift_a.tolist() == [2 / 3, 2 / 3] and free.drift_b.tolist() == [1.0, 1.0]
    assert free.energy[0] == 1.5
    t = np.array([0.0, 1e3, 1e9])
    motion = free_motion(chain, (1.0, 0.0), (0.0, 3.0), t)
    assert (2 * motion.x[0] + motion.x[1]) / 3 == pytest.approx(2 / 3 + t, rel=1e-15)


def test_without_coupling_mass_2_is_free():
    chain = TwoMassChain(m1=2.0, m2=1.0, k1=8.0, k2=0.0)
    modes = chain.modes()
    assert modes.omega.tolist() == [0.0, 2.0] and modes.ratio.tolist() == [math.inf, 0.0]
    motion = free_motion(chain, (1.0, 2.0), (0.0, 0.25), [0.0, 4.0])
    assert motion.x[1].tolist() == [2.0, 3.0] and motion.v[1].tolist() == [0.25, 0.25]
    assert motion.x[0] == pytest.approx(np.cos([0.0, 8.0]), rel=1e-15)


def test_without_springs_both_masses_are_free():
    chain = TwoMassChain(m1=2.0, m2=1.0, k1=0.0, k2=0.0)
    modes = chain.modes()
    assert modes.omega.tolist() == [0.0, 0.0] and modes.ratio.tolist() == [math.inf, 0.0] and modes.beat == 0.0
    free = free_modes(chain, (1.0, -1.0), (0.5, 0.25))
    assert free.drift_a.tolist() == [1.0, -1.0] and free.drift_b.tolist() == [0.5, 0.25]
    assert free_motion(chain, (1.0, -1.0), (0.5, 0.25), [4.0]).x.tolist() == [[3.0], [0.0]]


def test_rest_stays_at_rest():
    motion = free_motion(TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0), (0, 0), (0, 0), [0.0, 1.0, 1e9])
    assert not np.any(motion.x) and not np.any(motion.v) and not np.any(motion.e)


def test_a_start_in_one_mode_leaves_the_other_at_rest():
    free = free_modes(TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0), (1.0, -1.0), (0.0, 0.0))
    assert free.amplitude[0].tolist() == [0.0, 0.0] and free.energy[0] == 0.0


@given(st.tuples(*[st.floats(0.1, 10.0)] * 4))
@thorough
def test_against_eigenvalues(parameters):
    m1, m2, k1, k2 = parameters
    squares, vectors = scipy.linalg.eigh([[k1 + k2, -k2], [-k2, k2]], np.diag([m1, m2]))
    modes = chain_with(parameters).modes()
    assert np.sqrt(squares) == pytest.approx(modes.omega, rel=1e-11)
    assert vectors[1] / vectors[0] == pytest.approx(modes.ratio, rel=1e-10)


def test_against_the_matrix_exponential():
    chain, t = TwoMassChain(m1=2.0, m2=1.0, k1=3.0, k2=0.7), np.array([0.0, 0.3, 2.0, 11.0])
    K = np.array([[chain.k1 + chain.k2, -chain.k2], [-chain.k2, chain.k2]]) / [[chain.m1], [chain.m2]]
    rate = np.block([[np.zeros((2, 2)), np.eye(2)], [-K, np.zeros((2, 2))]])
    motion = free_motion(chain, (1.0, -0.3), (0.2, 0.5), t)
    for n, time in enumerate(t):
        state = scipy.linalg.expm(rate * time) @ [1.0, -0.3, 0.2, 0.5]
        assert [*motion.x[:, n], *motion.v[:, n]] == pytest.approx(state, abs=1e-12)


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


@pytest.mark.parametrize("name", ["m1", "m2", "k1", "k2"])
@pytest.mark.parametrize("value", [-1.0, -math.inf, math.inf, math.nan])
def test_refused_parameters(name, value):
    with pytest.raises(ValueError, match=f"{name} = {value}.*finite number"):
        TwoMassChain(**({"m1": 1.0, "m2": 1.0, "k1": 1.0, "k2": 1.0} | {name: value}))


def test_a_mass_of_zero_is_refused():
    for masses in ({"m1": 0.0, "m2": 1.0}, {"m1": 1.0, "m2": 0.0}):
        with pytest.raises(ValueError, match=r"m[12] = 0.0.*above 0"):
            TwoMassChain(**masses, k1=1.0, k2=1.0)


@pytest.mark.parametrize(
    ("x_0", "v_0", "t", "message"),
    [
        ((1.0,), (0.0, 0.0), [0.0], "x_0"),
        ((1.0, 0.0), (0.0, 0.0, 0.0), [0.0], "v_0"),
        ((math.nan, 0.0), (0.0, 0.0), [0.0], "x_0"),
        ((1.0, 0.0), (0.0, math.inf), [0.0], "v_0"),
        ((1.0, 0.0), (0.0, 0.0), [0.0, math.nan], "t"),
        ((1.0, 0.0), (0.0, 0.0), [math.inf], "t"),
        ((1.0, 0.0), (0.0, 0.0), [[0.0, 1.0]], "t"),
    ],
)
def test_refused_starts_and_times(x_0, v_0, t, message):
    with pytest.raises(ValueError, match=message):
        free_motion(TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=1.0), x_0, v_0, t)


def test_a_result_out_of_range_is_named():
    chain = TwoMassChain(m1=1e-300, m2=1.0, k1=1e300, k2=1.0)
    with pytest.raises(ValueError, match="v1 leaves the range of doubles"):
        free_motion(chain, (1e20, 0.0), (0.0, 0.0), [1e-300])
    with pytest.raises(ValueError, match="energy of a mode"):
        free_modes(chain, (1e20, 0.0), (0.0, 0.0)).energy  # noqa: B018
