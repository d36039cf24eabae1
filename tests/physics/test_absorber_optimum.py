"""The band that an absorber helps in, and Den Hartog's optimum."""

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.absorber import (
    alone,
    damped_amplitude,
    den_hartog,
    fixed_points,
    helped_band,
)
from physics.coupled import TwoMassChain
from physics.forced import particular_solution
from tests.grids import tries
from tests.physics.chain_truth import close, exactly

MACHINE = {"m1": 100.0, "k1": 250e3}
TUNED = TwoMassChain(**MACHINE, m2=16.0, k2=36864.0)
F_0 = 500.0
any_double = st.builds(math.ldexp, st.floats(0.5, 1.0, exclude_max=True), st.integers(-1073, 1024))


@pytest.mark.parametrize("c", [0.0, 3.0, 100.0, 313.7, 600.0, 2000.0, 1e6])
@pytest.mark.parametrize(("m2", "k2"), [(16.0, 36864.0), (16.0, 60000.0), (1.0, 100.0), (200.0, 1e5)])
def test_helped_band_is_where_the_machine_swings_less(m2, k2, c):
    chain = TwoMassChain(**MACHINE, m2=m2, k2=k2)
    band = helped_band(chain, c)
    omega = np.geomspace(1.0, 1e4, 4001)
    less = damped_amplitude(chain, c, F_0, omega)[0] < np.abs(particular_solution(alone(chain), F_0, omega)[0])
    if band is None:
        assert not less.any()
        return
    edges = [e for e in band if math.isfinite(e)]
    clear = np.all([np.abs(omega / e - 1) > 1e-6 for e in edges], axis=0)
    assert np.array_equal(less[clear], ((omega > band[0]) & (omega < band[1]))[clear])
    assert less.any()


@settings(max_examples=tries(60))
@given(*[any_double] * 4)
def test_helped_band_over_the_range_of_doubles(m1, m2, k1, k2):
    low, high = helped_band(TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2))
    with exactly():
        a, b, c, d = map(mp.mpf, (m1, m2, k1, k2))
        half, product = a * d + b * c + b * d / 2, a * b * c * d
        root = mp.sqrt(half**2 - 4 * product)
        assert close(low, mp.sqrt(2 * c * d / (half + root)), 0.51)
        assert close(high, mp.sqrt((half + root) / (2 * a * b)), 0.51)


def test_no_absorber_helps_nowhere():
    assert helped_band(alone(TUNED)) is None
    assert helped_band(alone(TUNED), 10.0) == (pytest.approx(math.sqrt(2 * 250e3 / 216)), math.inf)


@pytest.mark.parametrize("c", [0.0, 1.0, 100.0, 313.7, 1e4, 1e9])
def test_fixed_points_do_not_feel_the_damping(c):
    free, held = (
        damped_amplitude(TUNED, c, F_0, fixed_points(TUNED)),
        damped_amplitude(TUNED, 50.0, F_0, fixed_points(TUNED)),
    )
    assert free[0] == pytest.approx(held[0], rel=1e-12)


@pytest.mark.parametrize("mu", [0.01, 0.05, 0.16, 0.25, 1.0])
def test_optimum_is_den_hartogs(mu):
    m2 = 100.0 * mu
    best = den_hartog(100.0, 250e3, m2)
    assert math.sqrt(best.k2 / m2) == pytest.approx(50.0 / (1 + mu), rel=1e-14)
    assert best.c / (2 * m2 * 50.0) == pytest.approx(math.sqrt(3 * mu / (8 * (1 + mu) ** 3)), rel=1e-14)
    assert best.height == pytest.approx(math.sqrt(1 + 2 / mu), rel=1e-14)
    chain = TwoMassChain(**MACHINE, m2=m2, k2=best.k2)
    at_points = damped_amplitude(chain, best.c, F_0, fixed_points(chain))[0]
    assert at_points == pytest.approx(best.height * F_0 / 250e3, rel=1e-12)
