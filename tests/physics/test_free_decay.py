"""One damped motion from its start: zeros, turns, settling and the energy lost, against the reference cases."""

import json
import math
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest

from physics.damped import DampedOscillator
from physics.free_decay import FreeDecay
from tests.physics.chain_truth import U, ulps

CASES = json.loads((Path(__file__).parents[1] / "reference" / "beyond_cases.json").read_text())["damped"]
each_case = pytest.mark.parametrize("case", CASES, ids=[case["note"] for case in CASES])


def oscillator(case):
    return DampedOscillator(m=case["m"], c=case["c"], k=case["k"])


def decay(case):
    return FreeDecay(oscillator=oscillator(case), x_0=case["x_0"], v_0=case["v_0"])


def near(value, text, most):
    """Return True if a value is within `most` ulps of the case's number, or both are missing."""
    if text is None:
        return value is None or not math.isfinite(value)
    return ulps(value, mp.mpf(text)) <= most


@each_case
def test_rates_zeros_and_turns(case):
    one, motion = oscillator(case), decay(case)
    assert one.regime == ("critical" if case["critical_within_an_ulp"] else case["regime"])
    for value, text in zip(one.rates, case["rates"], strict=True):
        assert near(value, text, 1)
    assert near(one.omega_d, case["omega_d"], 1)
    assert near(one.log_decrement, case["log_decrement"], 4)
    if case["x_0"]:  # the cases do not look for a second zero after the one at the start
        assert near(motion.first_zero, case["first_zero"], 8)
    assert near(motion.first_turn, case["first_turn"], 8)
    for share, true in case["settled"].items():
        found = motion.settled(float(share))
        assert (found is None) == (true is None)
        assert found is None or found == pytest.approx(float(true), rel=1e-8)


@each_case
def test_the_energy_lost_is_within_64_u_of_itself(case):
    lost = decay(case).lost(case["t"])
    assert np.all(np.diff(lost) >= 0)
    for t, value, text in zip(case["t"], lost, case["lost"], strict=True):
        true = mp.mpf(text) if case["c"] and t else 0
        assert abs(mp.mpf(float(value)) - true) <= 64 * U * abs(true) + mp.mpf("1e-300")


@pytest.mark.parametrize("zeta", [1e-12, 1e-3, 0.1, 0.49, 0.51, 0.999, 1.0, 1.5, 1.99, 2.01, 30.0])
def test_the_energy_lost_is_what_the_motion_lacks(zeta):
    one, t = DampedOscillator(m=2.0, c=4 * zeta, k=2.0), np.linspace(0.0, 30.0, 200)
    motion = one.motion(0.7, -1.1, t)
    energy = motion.v**2 + motion.x**2
    lost = FreeDecay(oscillator=one, x_0=0.7, v_0=-1.1).lost(t)
    assert np.max(np.abs(energy + lost - energy[0])) <= 30 * U * energy[0]


def test_top_speed_is_where_the_acceleration_is_zero():
    motion = FreeDecay(oscillator=DampedOscillator(m=1.0, c=0.4, k=4.0), x_0=1.0, v_0=0.0)
    t = motion.first_top_speed
    found = motion.oscillator.motion(1.0, 0.0, [t])
    assert abs(found.a[0]) < 1e-14 and found.x[0] == pytest.approx(-0.1 * found.v[0])


def test_at_rest_nothing_happens():
    motion = FreeDecay(oscillator=DampedOscillator(m=1.0, c=0.4, k=4.0), x_0=0.0, v_0=0.0)
    assert (motion.first_zero, motion.first_turn, motion.settled(0.02)) == (None, None, None)
    assert not motion.lost([0.0, 1.0]).any()


def test_what_is_lost_beyond_the_doubles_is_refused():
    motion = FreeDecay(oscillator=DampedOscillator(m=1.0, c=1.0, k=1.0), x_0=1e200, v_0=0.0)
    with pytest.raises(ValueError, match="the energy lost leaves the range"):
        motion.lost([1.0])


@each_case
def test_motion_is_within_four_u_of_the_amplitude(case):
    if case["m"] < 1e-100:
        pytest.skip("sizes of 1e-250 count as nothing")
    motion = oscillator(case).motion(case["x_0"], case["v_0"], case["t"])
    for row, name, sizes in zip((motion.x, motion.v, motion.a), ("x", "v", "acc"), case["size"], strict=True):
        for value, text, size in zip(row, case[name], sizes, strict=True):
            assert abs(mp.mpf(value) - mp.mpf(text)) <= 4 * U * 1.001 * size + mp.mpf("1e-250")
