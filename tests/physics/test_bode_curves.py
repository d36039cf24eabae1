"""Response and lags over many drive frequencies, against 50 digits and against one frequency at a time."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.bode_curves import bode_curves
from physics.damped_chain import DampedChain
from tests.grids import tries
from tests.physics.chain_cases import log_uniform

U = 2.0**-53
CASES = json.loads((Path(__file__).parents[1] / "reference" / "bode_cases.json").read_text())["cases"]
NAMES = ("m1", "m2", "k1", "k2", "c1", "c2")


@pytest.mark.parametrize("case", CASES, ids=lambda case: str(case["id"]))
def test_curves_are_within_eight_units_of_the_reference(case: dict[str, Any]) -> None:
    chain = DampedChain(**{name: case[name] for name in NAMES})
    found = bode_curves(chain, case["omega"], case["F_0"])
    with mp.workdps(30):
        for i, true in enumerate(case["at"]):
            if true is None:
                assert np.isinf(found.X[0, i])
                continue
            for j, name in enumerate(("X1", "X2")):
                wanted = mp.mpc(*true[name])
                assert abs(mp.mpc(complex(found.X[j, i])) - wanted) <= 8 * U * abs(wanted)
                if true["lag"][j] is not None:
                    assert abs(mp.mpf(float(found.lags[j, i])) - mp.mpf(true["lag"][j])) <= 8 * U


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
