"""Response, lags, peaks and half-power points of the damped chain and of the driven mass, against 50 digits."""

from __future__ import annotations

import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from physics.bode import Resonances, chain_resonances, quarter_lags
from physics.bode_curves import bode_curves
from physics.damped_chain import DampedChain
from tests.grids import tries
from tests.physics.chain_families import log_uniform
from tests.physics.references import each, reference

U = 2.0**-53
NAMES = ("m1", "m2", "k1", "k2", "c1", "c2")


def chain_of(case: dict[str, Any]) -> DampedChain:
    return DampedChain(**{name: case[name] for name in NAMES})


@each(reference("bode"))
def test_peaks_dips_half_power_and_works_are_those_of_the_reference(case: dict[str, Any]) -> None:
    found = chain_resonances(chain_of(case))
    for one, name in zip(found, ("X1", "X2", "stroke"), strict=True):
        true = case["over_F_0"][name]
        check(one, [*true["peaks"], *true["dips"]])
        assert one.poles == pytest.approx([float(w) for w in true["infinite"]], rel=U, abs=0)
    wanted = [float(w) for w in case["quarter_lag_1"]]
    assert quarter_lags(chain_of(case)) == pytest.approx(wanted, rel=U, abs=0)
    for omega, true in zip(case["omega"], case["at"], strict=True):
        if true:
            works = chain_of(case).works(omega, case["F_0"])
            assert works == pytest.approx([float(one) for one in true["work"][1:]], rel=4 * U, abs=0)


def check(found: Resonances, wanted: list[dict[str, Any]]) -> None:
    every = [*found.peaks, *found.dips]
    assert len(every) == len(wanted)
    for one, true in zip(every, wanted, strict=True):
        sides = [None if side is None else float(side) for side in true.get("half_power", (None, None))]
        assert [side is None for side in one.half_power] == [side is None for side in sides]
        pairs = [(one.omega, float(true["omega"])), (one.height, float(true["height"]))]
        pairs += [(a, b) for a, b in zip(one.half_power, sides, strict=True) if a and b]
        assert all(a == pytest.approx(b, rel=U, abs=0) for a, b in pairs)


@settings(max_examples=tries(400))
@given(*[log_uniform(-150, 150)] * 7, st.sets(st.sampled_from(NAMES[2:])))
def test_lags_over_many_decades_are_those_of_the_forces(
    m1: float, m2: float, k1: float, k2: float, c1: float, c2: float, omega: float, none: set[str]
) -> None:
    """Lag 1 from 60 digits; lag 2 is behind it by an angle from 0 to pi."""
    chain = DampedChain(**(dict(zip(NAMES, (m1, m2, k1, k2, c1, c2), strict=True)) | dict.fromkeys(none, 0.0)))
    assume(chain.c1 or chain.c2)
    lags = chain.lags(omega).tolist()
    with mp.workdps(800):
        m1, m2, k1, k2, c1, c2, w = (mp.mpf(one) for one in (*(getattr(chain, name) for name in NAMES), omega))
        link, N = mp.mpc(k2, c2 * w), mp.mpc(k2 - m2 * w**2, c2 * w)
        D = mp.mpc(k1 - m1 * w**2, c1 * w) * N - m2 * w**2 * link
        assume(N)
        first = mp.arg(D / N)
        assert abs(lags[0] - first) <= 2 * U and 0 <= lags[0] <= math.pi
        if link:
            assert abs(lags[1] - lags[0] - mp.arg(N / link)) <= 8 * U and lags[0] <= lags[1] <= 2 * math.pi


@pytest.mark.parametrize(
    ("numbers", "omega", "lags"),
    [
        ({"k1": 4.0, "k2": 2.0}, [0.0, 1.0, 1.2, 2.0, 9.0], [(0, 0), (0, 0), (1, 1), (0, 1), (1, 2)]),
        ({"k1": 0.0, "k2": 2.0, "c1": 1.0}, [0.0], [(0.5, 0.5)]),
        ({"k1": 0.0, "k2": 2.0, "c2": 1.0}, [0.0], [(1, 1)]),
        ({"k1": 0.0, "k2": 0.0}, [0.0], [(1, 1)]),
        ({"k1": 4.0, "k2": 0.0, "c1": 1.0}, [0.0], [(0, 0)]),
    ],
)
def test_lags_in_limits(numbers: dict[str, float], omega: list[float], lags: list[tuple[float, float]]) -> None:
    """In half turns; at a natural frequency without dashpots the lag of the frequencies just below."""
    found = DampedChain(m1=2, m2=1, **numbers).lags(omega).T / math.pi
    assert found.tolist() == [list(pair) for pair in lags]


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
