"""Looking for the modes: determinant, readings, forces, the quadratic, sweeps and limits, the mixture of a start."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from physics.coupled import TwoMassChain, free_modes
from physics.modes import determinant_curve, mixture, row_curves, trial
from physics.sweeps import PARAMETERS, limit, sweep
from tests.grids import tries

U = 2.0**-53
GOOD = TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0)
NO_WALL = TwoMassChain(m1=2.0, m2=1.0, k1=0.0, k2=2.0)
LOOSE = TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=0.0)

usual = st.floats(-3, 3).map(lambda power: 10.0**power)
usual_chains = st.builds(TwoMassChain, m1=usual, m2=usual, k1=usual, k2=usual)
thorough = settings(max_examples=tries(60))


@thorough
@given(usual_chains, st.sampled_from([1.0, 1e300]))
def test_determinant_curve_keeps_its_digits_beside_a_root(chain: TwoMassChain, scale: float) -> None:
    """Also beyond the range of doubles."""
    chain = replace(chain, k1=scale * chain.k1, k2=scale * chain.k2)
    slow, fast = (float(w) for w in chain.modes().omega)
    omega = np.array([0.0, 0.5 * slow, slow * (1 + 1e-12), np.sqrt(slow * fast), fast * (1 - 1e-9), 1.2 * fast])
    curve, exponent = determinant_curve(chain, omega)
    assert (exponent == 0) == (scale == 1.0)
    exactly = [float(trial(chain, w).determinant.scaleb(-exponent)) for w in omega]
    np.testing.assert_allclose(curve, exactly, rtol=32 * U)


@thorough
@given(usual_chains, st.sampled_from(PARAMETERS))
def test_sweep_is_the_modes_of_each_chain(chain: TwoMassChain, name: str) -> None:
    """The frequencies with one mass held are between the modes, so the modes never meet: an avoided crossing."""
    values = np.geomspace(1e-3, 1e3, 41)
    run = sweep(chain, name, values)
    assert np.all(run.omega[0] <= run.held.min(axis=0) * (1 + 1e-15))
    assert np.all(run.omega[1] >= run.held.max(axis=0) * (1 - 1e-15))
    assert np.all(run.omega[0] < run.omega[1])
    for i in range(0, 41, 8):
        modes = replace(chain, **{name: float(values[i])}).modes()
        np.testing.assert_allclose(run.omega[:, i], modes.omega, rtol=8 * U)
        np.testing.assert_allclose(run.ratio[:, i], modes.ratio, rtol=1e-12)


@pytest.mark.parametrize("name", PARAMETERS)
@pytest.mark.parametrize("chain", [GOOD, NO_WALL, LOOSE], ids=["good", "no wall", "loose"])
@pytest.mark.parametrize("end", [0, 1])
def test_limits(name: str, chain: TwoMassChain, end: int) -> None:
    """A million times beyond the others the modes are their limits to about a millionth, each kind of limit its own."""
    value = np.array([1e-8, 1e8][end : end + 1])
    run, tends = sweep(chain, name, value), limit(chain, name, end, value)
    np.testing.assert_allclose(tends.omega, run.omega, rtol=1e-6)
    np.testing.assert_allclose(tends.ratio, run.ratio, rtol=1e-6)


@pytest.mark.parametrize(
    ("chain", "omega", "rows"),
    [
        (LOOSE, 1.0, (math.inf, 0.0)),
        (LOOSE, 0.0, (math.inf, None)),
        (replace(LOOSE, m1=1.0), 2.0, (None, 0.0)),
        (replace(LOOSE, k2=4.0), 2.0, (0.0, math.inf)),
    ],
)
def test_a_row_without_coupling_asks_for_rest_or_for_nothing(chain, omega, rows) -> None:
    found = trial(chain, omega)
    assert tuple(None if row is None else float(row) for row in found.rows) == rows
    assert chain.k2 or found.apart is None


@thorough
@given(usual_chains)
def test_row_curves_are_what_the_rows_say(chain: TwoMassChain) -> None:
    modes = chain.modes()
    end = 1.2 * float(modes.omega[1])
    largest = 6.0 * float(np.max(np.abs(modes.ratio)))
    first, second = row_curves(chain, end, largest)
    for branches, row in ((first, 0), (second, 1)):
        for omega, ratio in zip(branches.omega, branches.ratio, strict=True):
            assert np.all(np.diff(omega) >= 0)
            assert omega[0] >= 0 and omega[-1] <= end * (1 + 1e-15)
            for w, r in zip(omega[::20], ratio[::20], strict=True):
                found = trial(chain, float(w)).rows[row]
                assert found is None or float(found) == pytest.approx(r, rel=1e-6 * max(1, abs(r)), abs=1e-6 * largest)
    first, second = row_curves(LOOSE, 3.0, 10.0)
    np.testing.assert_allclose(first.omega[0], [np.sqrt(2.0)] * 2)
    np.testing.assert_array_equal(second.ratio[0], [0.0, 0.0])


@thorough
@given(usual_chains, st.floats(-2, 2), st.floats(-2, 2))
def test_shares_are_those_of_the_amplitudes(chain: TwoMassChain, x1: float, x2: float) -> None:
    assume(max(abs(x1), abs(x2)) > 1e-3)
    amplitude = free_modes(chain, (x1, x2), (0.0, 0.0)).amplitude
    sizes = np.hypot(*amplitude.T)
    *parts, width = mixture(chain, (x1, x2))
    np.testing.assert_allclose(parts, sizes / sizes.sum(), rtol=1e-13, atol=1e-300)
    assert width == pytest.approx(abs(np.linalg.det(amplitude)) / sizes.max() ** 2, rel=1e-9, abs=1e-15)
    assert mixture(chain, (0, 0)) == mixture(NO_WALL, (1, 1)) == (0.0, 0.0, 0.0)
