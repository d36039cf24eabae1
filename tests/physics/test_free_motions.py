"""The free motions of the chain as values: in each mode, in both, averaged where they are too fast, played."""

from __future__ import annotations

import math

import numpy as np
import pytest

from physics.coupled import FreeModes, TwoMassChain, free_modes
from physics.energy import chain_energy
from physics.free_motions import FreeMotions
from physics.motion import Elementary, ExactMotion, Harmonic
from physics.precision.exact import Array
from physics.sampling import Sinusoid

LECTURE = TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0)
STIFF = TwoMassChain(m1=2.0, m2=1.0, k1=1.0, k2=1e12)


def begun(chain: TwoMassChain, x_0: tuple[float, float] = (1.0, -0.5)) -> FreeModes:
    return free_modes(chain, x_0, (0.25, 0.5))


def energies(free: FreeModes) -> dict[str, ExactMotion]:
    chain, both = free.chain, FreeMotions(free).both
    return {
        "T1": 0.5 * chain.m1 * both.v1**2,
        "T2": 0.5 * chain.m2 * both.v2**2,
        "V1": 0.5 * chain.k1 * both.e1**2,
        "V2": 0.5 * chain.k2 * both.e2**2,
    }


def mean(motion: ExactMotion, t: Array) -> Array:
    return motion.mean.at(t)


def test_elongations_have_their_own_digits() -> None:
    """The difference x2 - x1 of rounded displacements would have no digit for a stiff spring."""
    fast = FreeMotions(free_modes(STIFF, (1.0, 1.000001), (0.0, 0.0))).slow.e2
    assert isinstance(fast, Elementary) and isinstance(fast.played, Harmonic)
    (wave,) = fast.played.sinusoids
    assert isinstance(wave, Sinusoid) and 0 < abs(wave.amplitude) < 1e-11


@pytest.mark.parametrize("start", [(1.0, 1.0), (1.0, 1.000001)])
def test_mean_energies_of_a_spring_too_stiff_to_draw(start: tuple[float, float]) -> None:
    """On a coarse grid the fast mode counts by its mean, the slow one by its values; their sum is the whole energy."""
    t, free = np.linspace(0.0, 30.0, 300), free_modes(STIFF, start, (0.0, 0.0))
    of = energies(free)
    assert sum(mean(one, t) for one in of.values()) == pytest.approx(math.fsum(free.energy), rel=1e-6)
    stretched = free.amplitude[0, 0] * float(STIFF.exact_modes[0].stretch)
    slow = STIFF.k2 * (np.cos(STIFF.modes().omega[0] * t) * stretched) ** 2 / 2
    assert mean(of["V2"], t) == pytest.approx(slow + free.energy[1] / 2, rel=1e-9)


def test_mean_energies_of_what_can_be_drawn_are_the_energies() -> None:
    t, free = np.linspace(0.0, 6.0, 300), begun(LECTURE)
    energy, of = chain_energy(LECTURE, free.motion(t)), energies(free)
    for name, true in zip(("T1", "T2", "V1", "V2"), (*energy.T, *energy.V), strict=True):
        assert np.array_equal(of[name].at(t), true)
        assert mean(of[name], t) == pytest.approx(true, abs=1e-14)
