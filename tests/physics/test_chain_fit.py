"""The chain of a fit with two frequencies: its shapes, and its masses and stiffnesses over the first mass."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from physics.chain_fit import ChainFit, chain_of_fit
from physics.coupled import TwoMassChain
from physics.fit import fit_damped
from physics.transient import DampedModes

pytestmark = pytest.mark.timeout(600)  # hundreds of fits, on a machine that may be busy
SEEDS = 200
CHAIN = TwoMassChain(m1=2.0, m2=1.0, k1=16.0, k2=9.0)
T = np.arange(160) * 0.08


@cache
def motion(c: float) -> np.ndarray:
    """x1 and x2 at the times T, with a dashpot c parallel to the second spring."""
    return np.asarray(DampedModes(chain=CHAIN, c=c, F_0=0.0, omega=0.0, x_0=(1.0, 0.2)).motion(T).x)


def found(seed: int, noise: tuple[float, float] = (0.02, 0.06), c: float = 0.0, swapped: bool = False) -> ChainFit:
    """The chain of a simulated record."""
    x = motion(c)
    rows = x + 0.1 + np.array(noise)[:, None] * np.random.default_rng(seed).standard_normal(x.shape)
    return chain_of_fit(fit_damped(T, rows[::-1] if swapped else rows, modes=2))


def test_one_standard_error_holds_the_chain_as_often_as_it_says() -> None:
    modes = CHAIN.modes()
    true = np.array([*modes.omega, *modes.ratio, 8.0, 4.5, 0.5])
    inside, agree = np.zeros(7), 0
    for seed in range(SEEDS):
        chain = found(seed)
        assert chain.parts is not None
        numbers = np.array([*chain.omega, *chain.ratio, *chain.parts])
        inside += np.abs(numbers - true) < [*chain.se_omega, *chain.se_ratio, *chain.se_parts]
        agree += abs(chain.difference) < 1
    assert np.all((inside >= 0.6 * SEEDS) & (inside <= 0.76 * SEEDS)), inside / SEEDS
    assert 0.6 * SEEDS <= agree <= 0.76 * SEEDS


def test_without_noise_the_chain_is_exact() -> None:
    chain = found(0, (1e-9, 1e-9))
    assert chain.parts == pytest.approx([8.0, 4.5, 0.5], rel=1e-7)
    assert chain.ratio == pytest.approx(CHAIN.modes().ratio, rel=1e-7)


def test_columns_in_the_wrong_order_are_no_chain() -> None:
    assert found(1, swapped=True).parts is None


def test_a_dashpot_turns_the_shapes_and_hardly_changes_the_chain() -> None:
    assert found(2, (1e-4, 1e-4), c=0.1).parts == pytest.approx([8.0, 4.5, 0.5], rel=1e-2)
