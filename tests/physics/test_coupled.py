"""Modes of the chain and their parts in its free motion, over families of chains; test_forced has the motion itself."""

import math
import sys

import mpmath as mp
import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.coupled import free_modes, free_motion
from physics.precision.exact import sin_cos
from tests.grids import tries
from tests.physics.chain_families import chain_with, drawn, each_family
from tests.physics.chain_truth import Truth, U, ulps

LARGEST = mp.mpf(sys.float_info.max)
thorough = settings(max_examples=tries(40))


@each_family
@thorough
@given(data=st.data())
def test_modes_are_rounded_once(family, data):
    parameters = data.draw(drawn(family))
    modes, true = chain_with(parameters).modes(), Truth(*parameters)
    found = [*modes.omega, *modes.ratio, modes.beat]
    for value, exactly in zip(found, [*true.omega, *true.ratio, true.beat], strict=True):
        assert ulps(value, exactly) <= 0.51 or (abs(exactly) > LARGEST and math.isinf(value))
    for hi, lo, exactly in zip(modes.omega, modes.omega_lo, true.omega, strict=True):
        if mp.mpf("1e-290") < exactly < LARGEST:
            assert abs(mp.mpf(hi) + mp.mpf(lo) - exactly) <= exactly * mp.mpf(2) ** -105


@each_family
@thorough
@given(data=st.data(), x1_0=st.floats(-1.0, 1.0), v2_0=st.floats(-1.0, 1.0))
def test_amplitudes_and_phases_give_the_motion(family, data, x1_0, v2_0):
    parameters = data.draw(drawn(family))
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
