"""Energies of the chain: conserved when free, equal to the work done when driven, shared by the modes."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from physics.coupled import TwoMassChain, free_modes, free_motion
from physics.energy import chain_energy, half_square
from physics.forced import driven_modes, forced_motion
from physics.free_motions import FreeMotions
from tests.grids import tries
from tests.physics.chain_families import chain_with, drawn, each_family
from tests.physics.chain_truth import U

thorough = settings(max_examples=tries(40))
amounts = st.tuples(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))
LECTURE = TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0)
STIFF = TwoMassChain(m1=2.0, m2=1.0, k1=1.0, k2=1e12)


def within_range(chain):
    """Energies of displacements near 1 are doubles well inside the range."""
    values = [chain.m1, chain.m2, chain.k1, chain.k2, *chain.modes().omega]
    return all(not value or 1e-120 < value < 1e120 for value in values)


def long_times(chain, quickest, early, late, n=300):
    """From a fraction of a radian to a million slow periods, while phases are accurate."""
    slow = chain.modes().omega[0] or quickest
    end = min(1e6 * 2 * math.pi / slow, 1e15 / quickest) * late
    return np.concatenate([[0.0], np.geomspace(early / quickest, max(end, 1.0 / quickest), n)])


@each_family
@thorough
@given(data=st.data(), late=st.floats(1e-6, 1.0))
def test_work_is_the_gain_of_energy_within_8_u(family, data, late):
    """Without a drive the energy is that of both modes."""
    chain = chain_with(data.draw(drawn(family)))
    x_0, v_0 = data.draw(st.just((0.0, 0.0)) | amounts), data.draw(amounts)
    assume(within_range(chain))
    slow, fast = chain.modes().omega
    detuning = data.draw(st.just(0.0) | st.floats(-17.0, 2.0).map(lambda e: 10.0**e))
    omega = data.draw(st.sampled_from([float(slow), float(fast)])) * (1.0 + detuning) or 1.0
    t = long_times(chain, max(omega, fast), 1e-3, late)
    F_0 = chain.m1 * omega**2
    total = chain_energy(chain, forced_motion(chain, F_0, omega, t, x_0)).total
    work = driven_modes(chain, F_0, omega, x_0).work(t)
    assert np.all(np.abs(work - (total - total[0])) <= 8 * U * np.maximum.accumulate(total) + 1e-300)
    v_0 = tuple(v * (slow or fast or 1.0) for v in v_0)
    free = chain_energy(chain, free_motion(chain, x_0, v_0, t * omega / (fast or 1.0))).total
    energy = math.fsum(free_modes(chain, x_0, v_0).energy)
    assert np.all(np.abs(free - energy) <= 8 * U * energy)


@pytest.mark.parametrize(
    ("factor", "value", "energy"),
    [
        (1e300, 2e-200, 2e-100),
        (1e-300, 2e200, 2e100),
        (2.0, 3.0, 9.0),
        (5e-324, 2.0**537, 0.5),
        (1e-200, 1e-200, 0.0),
        (0.0, 1e300, 0.0),
        (1.0, 0.0, 0.0),
    ],
)
def test_half_squares_at_the_edges(factor, value, energy):
    assert half_square("V", factor, np.array([value, -value])) == pytest.approx([energy, energy], rel=4 * U, abs=0.0)


@pytest.mark.parametrize(("chain", "start"), [(STIFF, (1.0, 1.0)), (STIFF, (1.0, 1.000001)), (LECTURE, (1.0, -0.5))])
def test_on_a_coarse_grid_a_mode_too_fast_to_draw_counts_by_its_mean_energy(chain, start):
    """The slow mode counts by its values; their sum is the whole energy."""
    t, free = np.linspace(0.0, 30.0, 300), free_modes(chain, start, (0.0, 0.0))
    both = FreeMotions(free).both
    T, V = (
        [0.5 * size * one**2 for size, one in pairs]
        for pairs in (((chain.m1, both.v1), (chain.m2, both.v2)), ((chain.k1, both.e1), (chain.k2, both.e2)))
    )
    assert sum(one.mean.at(t) for one in (*T, *V)) == pytest.approx(math.fsum(free.energy), rel=1e-6)
    if chain is STIFF:
        stretched = free.amplitude[0, 0] * float(STIFF.exact_modes[0].stretch)
        slow = STIFF.k2 * (np.cos(STIFF.modes().omega[0] * t) * stretched) ** 2 / 2
        assert V[1].mean.at(t) == pytest.approx(slow + free.energy[1] / 2, rel=1e-9)
        return
    energy = chain_energy(chain, free.motion(t))
    for one, true in zip((*T, *V), (*energy.T, *energy.V), strict=True):
        assert np.array_equal(one.at(t), true)
        assert one.mean.at(t) == pytest.approx(true, abs=1e-14)
