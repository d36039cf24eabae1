"""The chain, free and driven: every family at every detuning, resonance, limits."""

import math
import sys

import mpmath as mp
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from physics.coupled import TwoMassChain
from physics.forced import driven_modes, forced_motion, particular_solution, steady_start
from tests.grids import tries
from tests.physics.chain_families import FAMILIES, chain_with, drawn, each_family
from tests.physics.chain_truth import Truth, U, rows, ulps, units, worst

LARGEST = mp.mpf(sys.float_info.max)
thorough = settings(max_examples=tries(30))
amount = st.floats(-1.0, 1.0)
starts = st.tuples(amount, amount) | st.sampled_from([(0.0, 0.0), (1.0, 1.0)])
LECTURE = TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0)


def check_amplitudes(chain, F_0, omega, true):
    """One frequency is rounded once, a curve through it is within 2 ulp; what leaves the range is refused."""
    if any(LARGEST < abs(X) < mp.inf for X in true):
        with pytest.raises(ValueError, match=r"Xp[12] at omega = .* leaves the range of doubles"):
            particular_solution(chain, F_0, omega)
        return
    for value, exactly in zip(particular_solution(chain, F_0, omega), true, strict=True):
        assert ulps(value, exactly) <= 0.51
    for value, exactly in zip(particular_solution(chain, F_0, [omega])[:, 0], true, strict=True):
        assert ulps(value, exactly) <= 2


@st.composite
def drives(draw, parameters):
    """A drive frequency at a detuning of 0 or 1e-17 to 100 from either mode, or from the antiresonance."""
    true = Truth(*parameters)
    root = draw(st.sampled_from([*true.omega, true.antiresonance]))
    detuning = draw(st.one_of(st.just(0.0), st.floats(-17.0, 2.0).map(lambda e: 10.0**e)))
    sign = draw(st.sampled_from([-1, 1])) if detuning < 1 else 1
    omega = root * (1 + sign * mp.mpf(detuning)) if root else mp.mpf(detuning)
    assume(omega < LARGEST)
    return float(omega)


@each_family
@thorough
@given(data=st.data())
def test_amplitudes_at_every_frequency(family, data):
    parameters = data.draw(drawn(family))
    omega, F_0 = data.draw(drives(parameters)), data.draw(st.floats(0.01, 100.0))
    check_amplitudes(chain_with(parameters), F_0, omega, Truth(*parameters).particular(F_0, omega))


@st.composite
def pushed(draw, true, omega):
    """F_0, x_0 and v_0: driven from rest, free from any start, or both where neither outweighs the other."""
    slow, fast = true.omega[0] or true.omega[1] or mp.mpf(1), max(true.omega[1], mp.mpf(omega)) or mp.mpf(1)
    is_driven, is_moved = draw(st.sampled_from([(True, False), (False, True), (True, True)]))
    if not is_moved:
        return 2.0, (0.0, 0.0), (0.0, 0.0)
    assume(mp.mpf("1e-100") < fast < mp.mpf("1e100") if is_driven else slow < LARGEST)
    x_0, v_0 = draw(starts), draw(starts)
    F_0 = float(min(mp.mpf("1e200"), true.m1 * fast**2)) if is_driven else 0.0
    return F_0, x_0, [float(v * (fast if is_driven else slow)) for v in v_0]


@each_family
@thorough
@given(data=st.data())
def test_a_free_motion_is_within_4_u_and_a_driven_one_within_16_u_at_every_detuning(family, data):
    parameters = data.draw(drawn(family))
    omega, true = data.draw(drives(parameters)), Truth(*parameters)
    F_0, x_0, v_0 = data.draw(pushed(true, omega))
    turns = [data.draw(st.floats(low, high)) for low, high in ((-6.0, 1.0), (0.0, 7.0), (0.0, 14.9))]
    quickest = max(true.omega[1], mp.mpf(omega) if F_0 else 0) or mp.mpf(1)
    t = [0.0, *(float(s) for s in (mp.mpf(10) ** e / quickest for e in turns) if s < LARGEST)]
    parts = [(true.free(x_0, v_0, s), true.driven(F_0, omega, s)) for s in t]
    expected = [[[a + b for a, b in zip(*pair, strict=True)] for pair in zip(*both, strict=True)] for both in parts]
    chain = chain_with(parameters)
    if max(abs(value) for values, _ in expected for value in values) > LARGEST:
        with pytest.raises(ValueError, match="leaves the range of doubles"):
            forced_motion(chain, F_0, omega, t, x_0, v_0)
        return
    motion = forced_motion(chain, F_0, omega, t, x_0, v_0)
    for n, (values, scales) in enumerate(expected):
        assert worst(motion, n, values, scales) <= (16 if F_0 else 4)


@pytest.mark.parametrize("name", ["moderate", "1e+-8", "tuned weak coupling", "k2 to 0", "k1 = 0"])
@thorough
@given(data=st.data(), early=st.floats(-6.0, 0.0), ratio=st.floats(-3.0, 3.0))
def test_mass_2_starts_like_the_fifth_power_of_time(name, data, early, ratio):
    """Relative to its own value, far below the envelope: the modes all but cancel in it."""
    parameters = data.draw(drawn(FAMILIES[name]))
    true = Truth(*parameters)
    omega = float(true.omega[1] * mp.mpf(10) ** ratio)
    t = float(mp.mpf(10) ** early / max(mp.mpf(omega), true.omega[1]))
    values, _ = true.driven(1.0, omega, t)
    assume(all(not value or mp.mpf("1e-290") < abs(value) < LARGEST for value in values))
    motion = forced_motion(chain_with(parameters), 1.0, omega, [t])
    for row, value in zip(rows(motion), values, strict=True):
        assert units(row[0], value, abs(value)) <= 8


@pytest.mark.parametrize("omega", [1.0, 2.0])
@pytest.mark.parametrize("F_0", [3.0, -3.0])
def test_resonance_has_no_steady_amplitude(omega, F_0):
    assert particular_solution(LECTURE, F_0, omega).tolist() == [math.inf, math.inf]
    assert particular_solution(LECTURE, F_0, [0.5, omega])[:, 1].tolist() == [math.inf, math.inf]
    modes = driven_modes(LECTURE, F_0, omega)
    assert not modes.split_is_meaningful and np.min(np.abs(modes.detuning)) == 0.0
    for refused in (modes.complementary, modes.particular_motion, modes.apart):
        with pytest.raises(ValueError, match=f"the drive at omega = {omega:.6g} rad/s is at a natural frequency"):
            refused([1.0])
    with pytest.raises(ValueError, match="natural frequency"):
        steady_start(LECTURE, F_0, omega)


@pytest.mark.parametrize("omega", [0.0, 0.9999, 1.4, 7.0])
@pytest.mark.parametrize("end", [0.01, 40.0])
def test_total_is_complementary_plus_particular(omega, end):
    """From the onset on, with a beat that has not begun, and without a force; formed together or alone."""
    t = np.linspace(0.0, end, 200)
    modes = driven_modes(LECTURE, 2.0, omega, (0.5, -1.0), (0.25, 0.0))
    assert modes.split_is_meaningful == (omega != 0.9999)
    motion, x_p, x_c = modes.apart(t)
    alone = modes.motion(t)
    size = np.max(np.abs(modes.particular)) + 1.0
    assert np.max(np.abs(x_p + x_c - alone.x)) <= 32 * U * size
    pairs = [(motion.x, alone.x), (motion.v, alone.v), (motion.e, alone.e)]
    pairs += [(x_p, modes.particular_motion(t)), (x_c, modes.complementary(t))]
    for together, apart in pairs:
        assert np.max(np.abs(together - apart)) <= U * np.max(np.abs(apart))
    steady = driven_modes(LECTURE, 2.0, omega, *steady_start(LECTURE, 2.0, omega)).motion(t)
    assert np.max(np.abs(steady.x - np.outer(modes.particular, np.sin(omega * t)))) <= 1e-13 * size
