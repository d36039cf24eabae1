"""Response and lags over many drive frequencies, against 50 digits and against one frequency at a time."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.bode_curves import bode_curves
from physics.damped_chain import DampedChain
from tests.grids import tries
from tests.physics.chain_cases import log_uniform

U = 2.0**-53
NAMES = ("m1", "m2", "k1", "k2", "c1", "c2")


@settings(max_examples=tries(150))
@given(*[log_uniform(-40, 40)] * 7, st.sets(st.sampled_from(NAMES[2:])), st.floats(-3, 3))
def test_curves_are_those_of_single_frequencies(
    m1: float, m2: float, k1: float, k2: float, c1: float, c2: float, F_0: float, none: set[str], octaves: float
) -> None:
    """Also where a product would leave the doubles, and next to a natural frequency."""
    chain = DampedChain(**(dict(zip(NAMES, (m1, m2, k1, k2, c1, c2), strict=True)) | dict.fromkeys(none, 0.0)))
    natural = chain.chain.modes().omega
    omega = np.unique([*natural, *(natural * (1 + 1e-9)), *(natural * 2.0**octaves), 1.0])
    omega = omega[omega > 0]
    found, true, lags = bode_curves(chain, omega, F_0), chain.response(omega, F_0), chain.lags(omega)
    finite = np.isfinite(true).all(axis=0)
    np.testing.assert_array_equal(np.isfinite(found.X).all(axis=0), finite)
    assert np.all(np.abs(found.X - true)[:, finite] <= 9 * U * np.abs(true[:, finite]))
    still = (true == 0.0).any(axis=0)  # no swing, no lag
    assert np.all(np.abs(found.lags - lags)[:, finite & ~still] <= 16 * U)


def test_at_a_pole_a_mass_without_a_link_stays_at_rest() -> None:
    for k2 in (0.0, 2.0):
        chain = DampedChain(m1=2.0, m2=1.0, k1=4.0 if k2 else 8.0, k2=k2)
        X = bode_curves(chain, [2.0], 3.0).X
        np.testing.assert_array_equal(X, chain.response([2.0], 3.0))
        assert np.isinf(X[0]) and (X[1] == 0.0) == (k2 == 0.0)
